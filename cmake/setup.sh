# What drivers/run and tests/run share: packages, configuration, build, the environment of a run.
# Sourced by bash with `set -euo pipefail`; expects voussoir_root to be the folder of the repository.

voussoir_preset=${VOUSSOIR_PRESET:-release}
voussoir_build=$voussoir_root/build/$voussoir_preset

say() { [ -n "${voussoir_quiet:-}" ] || printf '%s\n' "$*"; }

# stop CODE LINE...: says why and leaves with the exit codes of voussoir (2 input, 4 a resource is missing).
stop() {
  local code=$1
  shift
  printf '%s\n' "$@" >&2
  exit "$code"
}

# missing_packages [long]: names those of the list that dpkg does not have, in one call because each call costs 10 ms.
missing_packages() {
  local wanted
  mapfile -t wanted < <(sed -n -e "s/^${1:-none}: //" -e '/^[^# ]\+$/p' "$voussoir_root/cmake/packages.txt")
  comm -23 <(printf '%s\n' "${wanted[@]}" | sort) \
    <(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null |
      sed -n 's/ installed$//p' | sort -u)
}

# install_packages [long]
install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "Not a Debian system: libraries are taken as they are; cmake/packages.txt names them."
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0

  local command=(apt-get install -y --no-install-recommends "${missing[@]}")
  local by_hand="Install by hand:"$'\n'"  sudo ${command[*]}"
  local rights=()
  if [ "$(id -u)" -ne 0 ]; then
    rights=(sudo -n)
    sudo -n true 2>/dev/null || stop 4 "Packages are missing and this user may not install them: ${missing[*]}" "$by_hand"
  fi
  printf 'Installing Debian packages: %s\n' "${missing[*]}"
  local log
  log=$(mktemp)
  if ! { "${rights[@]}" apt-get update && "${rights[@]}" env DEBIAN_FRONTEND=noninteractive "${command[@]}"; } \
    </dev/null >"$log" 2>&1; then
    tail -n 5 "$log" >&2
    rm -f "$log"
    stop 4 "Packages could not be installed (is the network there?): ${missing[*]}" "$by_hand"
  fi
  rm -f "$log"
}

# nproc alone would answer OMP_NUM_THREADS when that is set.
usable_cores() { env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc; }

# What takes most to compile takes 0.9 GB, so there is at most one job per GB of free memory.
build_jobs() {
  local jobs free
  jobs=$(usable_cores)
  free=$(awk '/MemAvailable/ {print int($2 / 1048576)}' /proc/meminfo)
  [ "$free" -ge 1 ] || free=1
  [ "$jobs" -le "$free" ] || jobs=$free
  echo "${VOUSSOIR_JOBS:-$jobs}"
}

# A build folder that was moved or copied remembers the wrong place; it is configured afresh.
configured_here() {
  [ -e "$voussoir_build/build.ninja" ] &&
    grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$voussoir_root" "$voussoir_build/CMakeCache.txt"
}

can_build_here() { [ -w "$voussoir_build" ] && { [ ! -e "$voussoir_build/.lock" ] || [ -w "$voussoir_build/.lock" ]; }; }

# configure_and_build [TARGET...]: one at a time, by a lock, when several runs start together. A build that this user may not
# write to (another user's, an image) is run as it is.
configure_and_build() {
  local log=$voussoir_build/configure.log status=0
  if [ -x "$voussoir_build/drivers/voussoir" ] && ! can_build_here; then
    say "Not built anew, since $voussoir_build cannot be written to: the program is the one that is there."
    return 0
  fi
  mkdir -p "$voussoir_build"
  exec 9>"$voussoir_build/.lock"
  flock 9
  if ! configured_here; then
    say "Configuring ($voussoir_preset) ..."
    (cd "$voussoir_root" && cmake --preset "$voussoir_preset" --fresh) >"$log" 2>&1 9>&- || {
      cat "$log" >&2
      flock -u 9
      return 1
    }
  fi
  ninja -C "$voussoir_build" -j "$(build_jobs)" "$@" </dev/null 2>&1 9>&- |
    { grep --line-buffered -v -e '^ninja: Entering' -e '^ninja: no work to do' -e 'Re-checking globbed' || true; } |
    if [ -n "${voussoir_quiet:-}" ]; then grep -v -e '^\[' || true; else cat; fi || status=$?
  flock -u 9
  return "$status"
}

# Hyper-threads share the memory bandwidth a solver lives on, so ranks follow physical cores.
physical_cores() {
  local cores allowed
  cores=$(lscpu -p=core,socket 2>/dev/null | grep -v '^#' | sort -u | wc -l)
  allowed=$(usable_cores)
  { [ "$cores" -ge 1 ] && [ "$cores" -le "$allowed" ]; } || cores=$allowed
  echo "$cores"
}

run_environment() {
  export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 # one thread per rank, or ranks fight over the cores
  # Containers forbid reading another process' memory, and Open MPI complains on every start.
  export OMPI_MCA_btl_vader_single_copy_mechanism=none
  # Debug build: programs look for leaks themselves, before MPI ends and takes its plug-ins away.
  export ASAN_OPTIONS=${ASAN_OPTIONS:-leak_check_at_exit=0}
  export LSAN_OPTIONS=${LSAN_OPTIONS:-suppressions=$voussoir_root/cmake/leaks.txt:print_suppressions=0}
  if [ "$(id -u)" -eq 0 ]; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  fi
}

"""Memory that runs out, at several places: a message and exit code 4, on one rank and on two, and no hang.

    out_of_memory.py PROGRAM MPIEXEC

The limit is one of addresses, in steps above what the program needs to say its version. A wall of 64 courses needs some
600 MB more; up to 300 MB the room for factorisations, taken before anything is computed, is missing already.
Where MPI itself cannot begin, or OpenMP cannot begin a thread, the process is theirs to end.
"""

import pathlib
import re
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
STEPS_MB = (200, 320, 400, 420, 440, 460, 500)


def limited(command, megabytes):
    size = megabytes << 20
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=100,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size)))


def addresses_at_start(program):
    """Smallest limit [MB], to 20 MB, under which the program still begins."""
    for megabytes in range(200, 4000, 20):
        done = limited([program, "--version"], megabytes)
        if done.returncode == 0 and re.match("voussoir", done.stdout):
            return megabytes
    raise SystemExit("the program does not begin below 4 GB")


def main():
    program, mpiexec = sys.argv[1:]
    scene = [f"--xml={ROOT / 'xml' / 'wall.xml'}", "--overwrite", "--quiet", "--set", "mesh/wall/courses=64",
             "--set", "mesh/wall/blocks per course=64", "--set", "selection/mode=all"]
    start = addresses_at_start(program)
    failed, refused = 0, 0
    for ranks in (1, 2):
        launch = [mpiexec, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        for more in STEPS_MB:
            done = limited([*launch, program, *scene, f"--out=out-of-memory/np{ranks}-{more}"], start + more)
            refused += done.returncode == 4
            well = done.returncode == 0 or (done.returncode == 4 and "not enough memory" in done.stderr)
            well |= any(word in done.stderr for word in ("MPI_Init", "MPI_INIT", "libgomp: Thread creation failed"))
            failed += not well
            print(f"{ranks} ranks, {start} + {more} MB: exit code {done.returncode}")
            if not well:
                print(done.stderr[:1500])
    print(f"{refused} runs out of memory, {failed} wrong")
    sys.exit(1 if failed or refused < 2 else 0)


if __name__ == "__main__":
    main()

"""Where the program is, how it is started, and what its exit codes mean.

The package computes nothing itself: every number comes from the program `voussoir`, which is looked for in this order:
the environment variable VOUSSOIR_PROGRAM, the build of the repository that this package lies in, the search path.
"""

import ctypes
import hashlib
import os
import pathlib
import shutil
import signal
import subprocess

DONE, WRONG_INPUT, NO_CONVERGENCE, NO_RESOURCE, STOPPED = 0, 2, 3, 4, 5

# One thread a rank, or ranks fight over the cores; the rest is what runs of several ranks need where users are root,
# where one process may not read the memory of another, and where runs side by side would be bound to the same core.
ENVIRONMENT = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
               "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
               "OMPI_MCA_hwloc_base_binding_policy": "none"}
REPORT = "drivers/report/make_report.py"
SET_PARENT_DEATH_SIGNAL = 1  # of prctl(2)


def counted(number, one, many=None):
    """A number of things in words: 1 run, 2 runs; 1 vertex, 2 vertices."""
    return f"{number} {one if number == 1 else many or one + 's'}"


class VoussoirError(Exception):
    """What the program, or this package in its words, could not do; `code` is the exit code of the program."""

    code = None


class InputError(VoussoirError):
    """A scene, or what is asked of it, is wrong: key, value, why and what to do."""

    code = WRONG_INPUT


class ResourceError(VoussoirError):
    """A file, a disk, memory or the program itself is missing."""

    code = NO_RESOURCE


def repository():
    """The folder of the repository, or None for a package that was installed elsewhere."""
    folders = [pathlib.Path(__file__).resolve().parents[2]]
    if os.environ.get("VOUSSOIR_PROGRAM"):
        folders += pathlib.Path(os.environ["VOUSSOIR_PROGRAM"]).resolve().parents
    else:
        found = shutil.which("voussoir")
        folders += pathlib.Path(found).resolve().parents if found else []
    return next((folder for folder in folders if (folder / REPORT).exists()), None)


def find_program():
    """The path of the program; ResourceError where there is none."""
    named = os.environ.get("VOUSSOIR_PROGRAM")
    if named:
        if not os.access(named, os.X_OK) or os.path.isdir(named):
            raise ResourceError(f"VOUSSOIR_PROGRAM = {named}\n  is no program that can be run.\n"
                                "  Give the path of voussoir, such as build/release/drivers/voussoir.")
        return pathlib.Path(named).resolve()
    preset = os.environ.get("VOUSSOIR_PRESET", "release")
    built = pathlib.Path(__file__).resolve().parents[2] / "build" / preset / "drivers" / "voussoir"
    found = str(built) if os.access(built, os.X_OK) else shutil.which("voussoir")
    if not found:
        raise ResourceError(f"voussoir: the program is not at {built} nor on the search path\n"
                            "  so that there is nothing to compute with.\n"
                            "  Build it by drivers/run, or name it in the environment variable VOUSSOIR_PROGRAM.")
    return pathlib.Path(found).resolve()


def environment():
    return {**os.environ, **ENVIRONMENT}


def usable_cores():
    return len(os.sched_getaffinity(0))


def physical_cores():
    """Hyper-threads share the memory bandwidth that a solver lives on, so runs follow physical cores."""
    try:
        listed = subprocess.run(["lscpu", "-p=core,socket"], capture_output=True, text=True, check=True).stdout
        cores = len({line for line in listed.splitlines() if line and not line.startswith("#")})
    except (OSError, subprocess.CalledProcessError):
        cores = usable_cores()
    return max(1, min(cores, usable_cores()))


def launch(ranks):
    """What stands before the program so that it runs on some ranks; one needs no mpirun."""
    if ranks == 1:
        return []
    mpirun = shutil.which("mpirun")
    if not mpirun:
        raise ResourceError("mpirun is not on the search path\n  so that more than one rank cannot be had.\n"
                            "  Install openmpi-bin, or compute on one rank.")
    return [mpirun, "--quiet", "--oversubscribe", "--bind-to", "none", "-np", str(ranks)]


def ends_with_parent():
    """In the child, before the program begins: when this process is killed the program saves its state and ends."""
    ctypes.CDLL(None).prctl(SET_PARENT_DEATH_SIGNAL, signal.SIGUSR1)


def start(arguments, ranks, output, errors=subprocess.STDOUT):
    """Starts the program in a session of its own, so that Ctrl-C reaches this process alone, which then asks it to stop."""
    command = [*launch(ranks), str(find_program()), *arguments]
    several = {"OMPI_MCA_mpi_yield_when_idle": "1"} if ranks > physical_cores() else {}
    return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=errors, text=True,
                            start_new_session=True, preexec_fn=ends_with_parent, env={**environment(), **several})


def ask_to_stop(process):
    """The program saves its state and ends with exit code 5; mpirun passes this signal on."""
    try:
        process.send_signal(signal.SIGUSR1)
    except ProcessLookupError:
        pass


def kill(process):
    """With all that it has started."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()


def answer(*arguments):
    """What the program prints, for options that compute nothing; its words as an error where it refuses."""
    done = subprocess.run([str(find_program()), *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          check=False, env=environment())
    if done.returncode == WRONG_INPUT:
        raise InputError(done.stderr.strip())
    if done.returncode != DONE:
        raise ResourceError(done.stderr.strip() or f"{find_program()} ended with code {done.returncode}")
    return done.stdout


def find_scene(scene):
    """The path of a scene: from here, then from the folder of the repository, as drivers/run looks for it."""
    path = pathlib.Path(scene)
    home = repository()
    if not path.exists() and home and (home / path).exists():
        path = home / path
    if not path.is_file() or not os.access(path, os.R_OK):
        looked = f"looked in {os.getcwd()}" + (f" and {home}" if home else "")
        raise InputError(f"scene = {scene}\n  is not a file that can be read ({looked}).\n"
                         "  Give the path of a scene, such as xml/arch.xml.")
    return path.resolve()


def make_report(folder):
    """Draws the report of a run; its path, or None where it could not be made (report.log in the folder says why)."""
    home, folder = repository(), pathlib.Path(folder)
    if not home:
        return None
    log = folder / "report.log"
    with open(log, "w", encoding="utf-8") as said:
        done = subprocess.run(["/usr/bin/python3", "-B", str(home / REPORT), str(folder)], stdin=subprocess.DEVNULL,
                              stdout=said, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        return None
    log.unlink(missing_ok=True)
    return folder / "report.html"


def digest(path):
    """Of the content of a file."""
    found = hashlib.sha256()
    with open(path, "rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            found.update(block)
    return found.hexdigest()[:16]


def write_atomically(path, text):
    """A reader, and a process that is killed, find the old file or the new one."""
    path = pathlib.Path(path)
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    with open(beside, "w", encoding="utf-8", newline="") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.replace(beside, path)

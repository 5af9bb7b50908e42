"""Kills a run at random moments; whatever the moment, the run goes on to the same end.

    kill.py PROGRAM MPIEXEC KILLS

Each round begins a run, kills it (SIGKILL, all processes at once), kills what goes on from there as well, and lets the
third part finish: two kills per round, on 1 rank and 2 in turn. Every table of every step must equal that of a run
without kills to the last bit. The seed is printed; SEED=... repeats a failure.
"""

import os
import pathlib
import random
import signal
import subprocess
import sys
import time

from runs import Program, differences, empty


def children(pid):
    """A process and all it has started; mpiexec gives its ranks groups of their own."""
    parents = {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            name, rest = stat.read_text().rsplit(")", 1)
            if rest.split()[0] != "Z":
                parents[int(name.split()[0])] = int(rest.split()[1])
        except OSError:
            pass  # ended meanwhile
    found = [pid]
    for parent in found:
        found += [child for child, of in parents.items() if of == parent]
    return found


def kill(process, seconds):
    """True when the process was still running after so many seconds; then neither it nor its ranks are any more."""
    try:
        process.wait(timeout=seconds)
        return False
    except subprocess.TimeoutExpired:
        pass
    doomed = children(process.pid)
    for pid in doomed:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    process.wait()
    while any(pathlib.Path(f"/proc/{pid}/cmdline").exists() and pathlib.Path(f"/proc/{pid}/cmdline").read_bytes()
              for pid in doomed):
        time.sleep(0.01)
    return True


def main():
    program = Program(sys.argv[1], sys.argv[2])
    kills = int(sys.argv[3])
    seed = int(os.environ.get("SEED", time.time_ns() % 1_000_000))
    print(f"SEED={seed}")
    dice = random.Random(seed)
    references, seconds = {}, {}
    for ranks in (1, 2):
        references[ranks] = empty(f"kill/reference-np{ranks}")
        begin = time.monotonic()
        done = program.run(references[ranks], ranks=ranks)
        seconds[ranks] = time.monotonic() - begin
        assert done.returncode == 0, done.stdout + done.stderr

    failed = killed = begun_again = 0
    while killed < kills:
        ranks = 1 + killed // 2 % 2
        out = empty("kill/run")
        options = []
        for _ in range(2):
            # Some kills fall into the start of the run, some on its last steps.
            at = dice.uniform(0.02, 0.9) * seconds[ranks]
            killed += kill(program.start(out, *options, ranks=ranks), at)
            if (out / "result.json").exists():
                break  # it was quicker than the kill
            begun_again += not (out / "checkpoint.h5").exists()
            options = ["--restart"] if (out / "checkpoint.h5").exists() else ["--overwrite"]
        else:
            done = program.run(out, *options, ranks=ranks)
            problems = [done.stdout + done.stderr] if done.returncode else differences(out, references[ranks])
            print(f"{'FAILED' if problems else 'passed'}: {ranks} ranks, last kill after {at:.2f} s"
                  f" of {seconds[ranks]:.2f} s, {options[0]}: {problems}")
            failed += bool(problems)
    print(f"{killed} kills, {begun_again} before the first checkpoint, {failed} failed")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())

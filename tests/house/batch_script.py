"""The batch script hands an interrupted run back to the queue and restarts it, with Slurm's commands played by others.

    batch_script.py PROGRAM
"""

import os
import pathlib
import subprocess
import sys

import house

# Runs the program and tells it to stop once it computes.
SRUN = """#!/bin/bash
shift 2
echo "$@" >> calls
"$@" & pid=$!
until [ -f out/history.csv ]; do sleep 0.02; done
kill -USR1 $pid
wait $pid
"""
SCONTROL = """#!/bin/bash
echo "scontrol $@" >> calls
"""


def main(program):
    folder = pathlib.Path("batch_script").resolve()
    subprocess.run(["rm", "-rf", folder], check=True)
    folder.mkdir()
    for name, text in (("srun", SRUN), ("scontrol", SCONTROL)):
        (folder / name).write_text(text, encoding="utf-8")
        (folder / name).chmod(0o755)
    environment = dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}", PROGRAM=program, OUT="out", SLURM_JOB_ID="17",
                       SCENE=str(house.ROOT / "xml/clare-college-bridge.xml"))
    script = house.ROOT / "drivers/slurm/voussoir.sbatch"
    problems = []
    first = subprocess.run(["bash", script], cwd=folder, env=environment, capture_output=True, text=True, check=False)
    calls = (folder / "calls").read_text(encoding="utf-8").splitlines()
    if first.returncode != 0 or calls[-1] != "scontrol requeue 17":
        problems.append(f"An interrupted run is not handed back: code {first.returncode}, {calls}\n{first.stderr}")
    if not (folder / "out/checkpoint.h5").exists():
        problems.append("It left no checkpoint.")
    # Enough to see that it goes on: the restart of a run is tested elsewhere.
    (folder / "srun").write_text('#!/bin/bash\nshift 2\necho "$@" >> calls\nexit 3\n', encoding="utf-8")
    second = subprocess.run(["bash", script], cwd=folder, env=environment, capture_output=True, text=True, check=False)
    last = (folder / "calls").read_text(encoding="utf-8").splitlines()[-1]
    if "--restart" not in last or second.returncode != 3:
        problems.append(f"The next job does not go on, or hides the exit code: {last}, code {second.returncode}")
    house.finish("The batch script goes on where time was over", problems)


if __name__ == "__main__":
    main(sys.argv[1])

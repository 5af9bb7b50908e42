"""What --dry-run says of the number of steps and solves, and of seconds.

    prediction.py PROGRAM
    prediction.py PROGRAM --measure [SCENE ...]   prints a table of the seconds told and taken (drivers/studies/prediction.csv)
"""

import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Scene with its options -> lines that must and words that must not be in the prediction.
SAID = {
    "wall": (["2 load steps of about 40 linear solves each", "expected: 80 linear solves,"], "time steps"),
    "impact-bars": (["400 time steps of about 3 linear solves each", "expected: 1200 linear solves,"], "load steps"),
    "rocking-column": (["1 load step of", "1000 time steps", "expected: 3040 linear solves,"], "as many as"),
    "triplet": (["(within a factor of ten: how joints crack cannot be told)"], "factor of three"),
    "wall --set=joints/dry/cohesion=1e5 --set=selection/mode=bonded": (["(within a factor of three)"], "factor of ten"),
    "wall-shaken": (["as many as it finds it needs", "linear solves without those", "how many there are cannot be told"],
                    "factor of three"),
}


MOST = 600  # [s] of processor, after which a scene is stopped


def seconds_of(command, folder):
    """Of the processor, and how it ended: 0 or 3 for a run that came to its end, else that it was stopped."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "OMPI_MCA_mpi_yield_when_idle": "0"}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([*command, f"--out={folder}", "--quiet"], check=False, env=environment,
                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                         preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (MOST, MOST)))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, run.returncode


def measure(program, chosen):
    """Seconds told and taken of every scene, or of those that are named: of the processor, on one core."""
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    print("scene,predicted_s,said,taken_s,taken_over_predicted,ended", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for scene in sorted((ROOT / "xml").glob("*.xml")):
            if scene.stem == "reference" or chosen and scene.stem not in chosen:
                continue
            told = subprocess.run([program, f"--xml={scene}", "--dry-run"], capture_output=True, text=True, check=True).stdout
            seconds = re.search(r"([\d.e+-]+) s on 1 rank ", told)
            answers = ("factor of three", "factor of five", "factor of ten", "cannot be told")
            said = next((words for words in answers if words in told), "open")
            taken, code = seconds_of([program, f"--xml={scene}"], f"{folder}/{scene.stem}")
            ended = {0: "yes", 3: "no equilibrium found"}.get(code, f"no: code {code}")
            predicted = float(seconds[1]) if seconds else None
            ratio = f"{taken / predicted:.2f}" if seconds else ""
            print(f"{scene.stem},{seconds[1] if seconds else ''},{said},{taken:.1f},{ratio},{ended}", flush=True)


def main():
    program = sys.argv[1]
    if sys.argv[2:3] == ["--measure"]:
        return measure(program, sys.argv[3:])
    failed = False
    for scene, (lines, never) in SAID.items():
        name, *given = scene.split()
        command = [program, f"--xml={ROOT / 'xml' / name}.xml", "--dry-run", *given]
        text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        text = text[text.index("candidate contact points"):]
        for line in lines:
            if line not in text:
                print(f"{scene}: misses {line!r} in\n{text}")
                failed = True
        if never in text:
            print(f"{scene}: {never!r} is in\n{text}")
            failed = True
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

"""What --dry-run says of the number of steps and solves, and of seconds.

    prediction.py PROGRAM
    prediction.py PROGRAM --measure    prints a table of the seconds told and taken
"""

import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Scene -> lines that must and words that must not be in the prediction.
SAID = {
    "wall": (["2 load steps of about 40 linear solves each", "expected: 80 linear solves,"], "time steps"),
    "impact-bars": (["400 time steps of about 3 linear solves each", "expected: 1200 linear solves,"], "load steps"),
    "rocking-column": (["1 load steps", "1000 time steps", "expected: 3040 linear solves,"], "as many as"),
    "wall-shaken": (["as many as it finds it needs", "linear solves without those", "how many there are cannot be told"],
                    "factor of three"),
}


MOST = 120  # [s] of processor, after which a scene is left out of the table


def measure(program):
    """Of every scene whose seconds are told, those of the processor: on an idle machine, of the clock too."""
    print("scene,predicted_s,taken_s,taken_over_predicted")
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    with tempfile.TemporaryDirectory() as folder:
        for scene in sorted((ROOT / "xml").glob("*.xml")):
            told = subprocess.run([program, f"--xml={scene}", "--dry-run"], capture_output=True, text=True, check=False)
            seconds = re.search(r"([\d.e+-]+) s on 1 rank ", told.stdout)
            if told.returncode != 0 or not seconds:
                continue
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            run = subprocess.run([program, f"--xml={scene}", f"--out={folder}/{scene.stem}", "--quiet"], check=False, env=environment,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (MOST, MOST)))
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            taken = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            if run.returncode in (0, 3):
                predicted = float(seconds[1])
                print(f"{scene.stem},{predicted:g},{taken:.2f},{taken / predicted:.2f}", flush=True)


def main():
    program = sys.argv[1]
    if sys.argv[2:] == ["--measure"]:
        return measure(program)
    failed = False
    for scene, (lines, never) in SAID.items():
        command = [program, f"--xml={ROOT / 'xml' / scene}.xml", "--dry-run"]
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

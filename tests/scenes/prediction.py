"""What --dry-run says of the number of steps and solves.

    prediction.py PROGRAM
"""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Scene -> lines that must and words that must not be in the prediction.
SAID = {
    "wall": (["2 load steps of about 40 linear solves each", "expected: 80 linear solves,"], "time steps"),
    "impact-bars": (["400 time steps of about 7 linear solves each", "expected: 2800 linear solves,"], "load steps"),
    "rocking-column": (["1 load steps", "1000 time steps", "expected: 7040 linear solves,"], "as many as"),
    "wall-shaken": (["as many as it finds it needs", "linear solves without those"], "0 time steps"),
}


def main():
    program = sys.argv[1]
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

"""The thinnest semicircular arch of 27 voussoirs that stands under its own weight.

usage: minimum_thickness.py MINIMUM_THICKNESS_PROGRAM

Source    a rigid-block linear programme with exact joint cones and associated friction; it agrees with M. Gilbert,
          C. Casapulla, H. M. Ahmed, Computers and Structures 84 (2006) 873-887. For many voussoirs without sliding:
          t / R = 0.1074, G. Cocchetti, E. Rizzi, Frontiers of Struct. Civ. Eng. 14 (2020).
Set-up    drivers/minimum_thickness.cpp: limit analysis to 1e-5, then elastic stones just below and just above.
Expected  t / R = 0.10678 / 0.12539 / 0.15059 at a friction coefficient of 1 / 0.375 / 0.35, within 1e-4; none at 0.308,
          since below 0.30899 no thickness stands (27 stones; tests/unit/statics has the closed form).
Came out  limit analysis 0.10678 / 0.12541 / 0.15060, elastic stones stand at 0.10682 / 0.12545 / 0.15065 and collapse
          1e-4 below. The sides of a stone are chords, 6 cells along it, which ask for 0.01 % more thickness. That
          friction does not associate makes no difference here.
"""

import subprocess
import sys

TABLE = {1.0: 0.10678, 0.375: 0.12539, 0.35: 0.15059}
WITHIN = 1e-4  # of the radius


def search(program, friction):
    """The lines of the program."""
    done = subprocess.run([program, f"--friction={friction}"], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        sys.exit(f"friction {friction}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout.strip().splitlines()


def main():
    failed = 0
    for friction, expected in TABLE.items():
        lines = search(sys.argv[1], friction)
        answers = {}
        for line in lines:
            what, sign, number = line.partition("minimum t/R = ")
            if sign:
                answers[what or "elastic stones: "] = float(number)
        good = len(answers) == 2 and all(abs(found - expected) < WITHIN for found in answers.values())
        good = good and any("collapses" in line for line in lines[-3:])
        print(f"{'passed' if good else 'FAILED'}: friction {friction}: {answers}, expected {expected}")
        failed += not good
    answer = search(sys.argv[1], 0.308)[-1]
    good = answer.startswith("no equilibrium at any thickness") and answer.endswith("by the static theorem")
    print(f"{'passed' if good else 'FAILED'}: friction 0.308: {answer}")
    failed += not good
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())

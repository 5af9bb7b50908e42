"""The thinnest semicircular arch of 27 voussoirs that stands under its own weight.

usage: minimum_thickness.py MINIMUM_THICKNESS_PROGRAM

Source    a rigid-block linear programme with exact joint cones and associated friction; it agrees with M. Gilbert,
          C. Casapulla, H. M. Ahmed, Computers and Structures 84 (2006) 873-887. For many voussoirs without sliding:
          t / R = 0.1074, G. Cocchetti, E. Rizzi, Frontiers of Struct. Civ. Eng. 14 (2020).
Set-up    drivers/minimum_thickness.cpp, bisection to 1e-4.
Expected  t / R = 0.10678 / 0.12539 / 0.15059 at a friction coefficient of 1 / 0.375 / 0.35, within 1 %; none at 0.3,
          since below 0.3092 no thickness stands.
Came out  0.10683 / 0.12536 / 0.15055, and bisection to 1e-5 gives 0.10675 / 0.12535 / 0.15054: 0.03 % below the table.
          At a friction coefficient of 0.310 an arch of t / R = 0.195 stands, at 0.308 none does. That friction does not
          associate makes no difference here. The sides of a stone are chords: 2 cells along it instead of 6 ask for
          0.1 % more thickness. 1 % leaves room for that and for the bisection.
"""

import subprocess
import sys

TABLE = {1.0: 0.10678, 0.375: 0.12539, 0.35: 0.15059}
WITHIN = 0.01


def search(program, friction):
    """The last line of the program: its answer."""
    done = subprocess.run([program, f"--friction={friction}"], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        sys.exit(f"friction {friction}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout.strip().splitlines()[-1]


def main():
    failed = 0
    for friction, expected in TABLE.items():
        answer = search(sys.argv[1], friction)
        found = float(answer.split("=")[1]) if answer.startswith("minimum") else float("nan")
        good = abs(found / expected - 1) < WITHIN
        print(f"{'passed' if good else 'FAILED'}: friction {friction}: t/R = {found}, expected {expected}")
        failed += not good
    answer = search(sys.argv[1], 0.3)
    good = answer.startswith("no equilibrium at any thickness")
    print(f"{'passed' if good else 'FAILED'}: friction 0.3: {answer}")
    failed += not good
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())

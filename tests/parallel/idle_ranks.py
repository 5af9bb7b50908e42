"""More ranks than blocks, in time: the motion is that of one rank.

    idle_ranks.py PROGRAM MPIEXEC SCENE

Two bars collide; on three ranks one has no block. The first 14 of 400 time steps, in which the gap of 10 micrometre closes.
"""

import csv
import pathlib
import subprocess
import sys

# The forces of a time step are solved to 1e-11 of the largest; velocities of some steps add up to a little more.
TOLERANCE = 1e-8
CONTACT = "steps/stages/impact/duration=3.5e-5"


def run(command, folder, *options):
    subprocess.run(command + [f"--out={folder}", "--quiet", *options], check=True)


def columns(folder):
    """Observed motion, as the user sees it in history.csv."""
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {key: [float(row[key]) for row in rows] for key in rows[0] if key[:3] in ("ux_", "vx_", "kin")}


def main():
    program, mpiexec, scene = sys.argv[1:]
    folders = {ranks: pathlib.Path("idle-ranks") / f"np{ranks}" for ranks in (1, 3)}
    for ranks, folder in folders.items():
        run([mpiexec, "--oversubscribe", "-np", str(ranks), program, f"--xml={scene}"], folder, "--overwrite", "--set", CONTACT)
    one, three = (columns(folder) for folder in folders.values())
    failed = len(next(iter(one.values()))) != 14 or set(one) != set(three)
    for key in one:
        largest = max(map(abs, one[key]))
        wrong = max(abs(a - b) for a, b in zip(one[key], three[key])) / largest
        print(f"{key}: {wrong:.1e}")
        failed |= not wrong <= TOLERANCE  # not a number fails too
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

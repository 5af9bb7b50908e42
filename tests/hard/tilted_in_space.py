"""Random structures of stones in space whose ground tilts until they fall: what finite rotations find against rigid stones.

On ground that has turned by an angle t stones bear their weight as on level ground they bear a push of tan t times their
weight: all forces are those, turned and shortened, and friction knows no scale. So the structures of
certificates_in_space.py fall at the arc tangent of the push that they bear, and not beyond that of the limit of that test's
own linear programme.

Asked of every structure:
- no equilibrium is found beyond that limit;
- a stack, an arch, a flat arch and a table lean as far as they can be pushed, to within the accuracy of two searches. (In
  bond it hangs on which way friction was led what stones bear.)

    tilted_in_space.py PROGRAM MPIEXEC [SEED...] [--to SEEDS]
"""

import argparse
import math
import pathlib
import sys
import tempfile
import time

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE / "ground"), str(HERE.parent / "support")]
import program  # noqa: E402  (folders of their own)
import solids  # noqa: E402
from certificates_in_space import ACCURACY, Pushed  # noqa: E402
from stones import xml  # noqa: E402

WITHIN = 1e-3  # of an angle: stones are not rigid
DECIDED = ("stack", "arch", "flat_arch", "table")  # one way of friction leads there
LARGEST = 1.4  # [rad] tried


def scene(pushed):
    """The ground turns about a horizontal axis so that the structure leans where it would be pushed."""
    c, s = math.cos(pushed.turned), math.sin(pushed.turned)
    x, y = float(pushed.push[0]), float(pushed.push[1])
    tilt = {"type": "settlement", "support": "ground", "rotation": 1.0, "axis x": -(s * x + c * y), "axis y": c * x - s * y,
            "axis z": 0.0}
    tree = pushed.scene()
    tree["mesh"]["stones"]["element"] = "linear"
    return {**tree, "model": {"rotations": "finite"}, "loads": {"weight": tree["loads"]["weight"], "tilt": tilt},
            "load factor": {"pattern": {"tilt": 1.0}, "first factor": 0.05, "largest factor": LARGEST, "accuracy": ACCURACY}}


def judged(pushed, folder):
    """What is wrong, and what came out."""
    own = pushed.bracket()
    if own is None:
        return "", "falls under its weight"
    least, most = (math.atan(factor) for factor in own)
    drawn = solids.drawn(pushed.stones, pushed.random, turned=pushed.turned, unit=pushed.unit, up=pushed.up)
    (folder / "stones.obj").write_text(drawn, encoding="utf-8")
    highest = {}
    for name, tree in (("tilted", scene(pushed)), ("pushed", pushed.scene())):
        (folder / f"{name}.xml").write_text(xml(name, tree) + "\n", encoding="utf-8")
        run = program.run(folder / f"{name}.xml", folder / name, ranks=pushed.ranks, seconds=900)
        if "collapse" not in run.result:
            return f"no search: {run.words[-900:]}", ""
        found = run.result["collapse"]
        highest[name] = max([found["lower"]] + [a["factor"] for a in found["attempts"] if a["outcome"] == "equilibrium"])
        if pushed.kind not in DECIDED:
            break
    leans, level = highest["tilted"], math.atan(highest.get("pushed", 0.0))
    told = (f"leans by {leans:.4f} rad, {f'pushed as by {level:.4f}, ' if level else ''}rigid stones by {least:.4f} to "
            f"{most:.4f}")
    if most < LARGEST and leans > most * (1 + WITHIN):
        return "an equilibrium beyond the limit", told
    if leans < (1 - 2 * ACCURACY) * min(level, LARGEST):
        return "falls too early", told
    return "", told


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("mpiexec")
    parser.add_argument("seeds", type=int, nargs="*")
    parser.add_argument("--to", type=int, default=0, help="all seeds below this one too")
    asked = parser.parse_args()
    program.PROGRAM, program.MPIEXEC = asked.program, asked.mpiexec
    wrong = 0
    for seed in [*asked.seeds, *range(asked.to)]:
        pushed, start = Pushed(seed), time.monotonic()
        pushed.push = numpy.array([*pushed.push[:2], 0.0]) / math.hypot(*pushed.push[:2])
        with tempfile.TemporaryDirectory() as folder:
            problem, told = judged(pushed, pathlib.Path(folder))
        print(f"{seed}: {pushed}: {told}{': WRONG, ' + problem if problem else ''} ({time.monotonic() - start:.0f} s)", flush=True)
        wrong += bool(problem)
    print(f"{wrong} are wrong.")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()

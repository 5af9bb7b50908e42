"""Two stones in bond on the corner of two walls of ground, with friction of 2, pushed by up to 0.6 g.

Where friction is large the interior path turns back (src/nonlinear/folds.md) while stones are still far from balance:
steps shrink to nothing and the imbalance stays. Friction that follows the pressure by less leads these stones to rest.
Where it follows in full all the same (internals > interior path > folds = false) some take 600 linear solves, and one comes
to no equilibrium in 12 000.

    corners.py PROGRAM MPIEXEC
"""

import itertools
import pathlib
import random
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "ground"), str(HERE.parent / "support")]
import program  # noqa: E402  (folders of their own)
import solids  # noqa: E402
from stones import xml  # noqa: E402

GRAVITY = 9.81
HEIGHT = 0.3
# Each step takes 10 to 30 solves where active sets arrive, 60 where the path folds twice.
MOST_SOLVES = 300


def corner(thickness, lengths):
    """The corner belongs to the first wall in the lower course, to the second in the upper one."""
    stones = {}
    for course, side in itertools.product(range(2), range(2)):
        begin, end = thickness if course != side else 0.0, lengths[side]
        for k, (a, b) in enumerate([(begin, end)] if course else [(begin, 0.6 * end), (0.6 * end, end)]):
            low, high = [0.0, 0.0, course * HEIGHT], [thickness, thickness, (course + 1) * HEIGHT]
            low[side], high[side] = a, b
            stones[f"course {course} wall {side} stone {k}"] = solids.box(low, high)
    return stones


def scene(push, mode):
    stages = {"own weight": {"loads": {"weight": 1.0}}}
    stages.update({f"push of {s}": {"loads": {"push": s}} for s in (0.2, 0.4, 0.5, 0.6)})
    return {"mesh": {"type": "stones", "stones": {"file": "stones.obj", "element size": 0.3}},
            "materials": {"stone": {"Young modulus": 1e10, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"dry": {"friction coefficient": 2.0}}, "supports": {"ground": {"on": "base"}},
            "loads": {"weight": {"type": "self weight", "gravity": GRAVITY},
                      "push": {"type": "acceleration", "ax": GRAVITY * push[0], "ay": GRAVITY * push[1], "az": 0.0}},
            "steps": {"stages": stages}, "selection": {"mode": mode}, "output": {"report": False}}


def main():
    program.PROGRAM, program.MPIEXEC = sys.argv[1:]
    wrong = 0
    cases = itertools.product((0.25, 0.35), ((0.8, 0.8), (1.0, 0.8), (1.2, 0.7)), ((0.0, -1.0), (0.0, 1.0), (-1.0, 0.0)),
                              ("all", "adaptive"))
    with tempfile.TemporaryDirectory() as name:
        for number, (thickness, lengths, push, mode) in enumerate(cases):
            folder = pathlib.Path(name) / str(number)
            folder.mkdir()
            drawn = solids.drawn(corner(thickness, lengths), random.Random(0), turned=0.0, unit=1.0, up="z")
            (folder / "stones.obj").write_text(drawn, encoding="utf-8")
            (folder / "scene.xml").write_text(xml("corner", scene(push, mode)) + "\n", encoding="utf-8")
            run = program.run(folder / "scene.xml", folder / "out")
            solves = run.result.get("linear_solves", 0) if run.result else 0
            bad = run.outcome != "equilibrium" or solves > MOST_SOLVES
            print(f"{thickness} m, {lengths}, push {push}, {mode}: {run.outcome}, {solves} solves{': WRONG' if bad else ''}",
                  flush=True)
            wrong += bad
    print(f"{wrong} are wrong.")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()

"""Stones in space are the same however they are drawn: turned, mirrored, moved, in other units, in another order.

usage: any_drawing_in_space.py PROGRAM MPIEXEC

Set-up    A corner of two walls of boxes in bond on a slab, under its own weight and pushed out of the corner by half of what
          rigid stones bear; a lintel on two piers, all hexahedra. The drawing is turned about the vertical axis, mirrored,
          written in millimetres a kilometre from the origin, with another axis upwards, its stones in another order.
Expected  Largest displacement, energies and reactions as in the first drawing; an error tolerance of zero
          resolves what resolving all points does; 2 and 4 ranks too.
Tolerance 1e-6 of the largest: what the solver leaves with 1e-10. A kilometre from the origin 1e-4: places are known to
          1e-13 of it, and cells of 0.1 m to 1e-9, which stones of rigid joints feel.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (folders of their own)
import solids  # noqa: E402
from stones import xml  # noqa: E402

DENSITY, GRAVITY = 2000.0, 9.81
SAME = 1e-6


def corner():
    """Walls along x and y, stones of 0.4 x 0.2 x 0.2 m, that share the corner in turn."""
    stones = {"slab": solids.box((-0.2, -0.2, -0.2), (1.4, 1.4, 0))}
    for c in range(4):
        z = 0.2 * c
        first = (0.0, 0.2) if c % 2 == 0 else (0.2, 0.0)  # where the stones of either wall start
        for k in range(3):
            a, b = (first[0] + 0.4 * k, min(first[0] + 0.4 * k + 0.4, 1.2))
            if b - a > 0.1:
                stones[f"x {c} {k}"] = solids.box((a, 0, z), (b, 0.2, z + 0.2))
            a, b = (first[1] + 0.4 * k, min(first[1] + 0.4 * k + 0.4, 1.2))
            if b - a > 0.1:
                stones[f"y {c} {k}"] = solids.box((0, a, z), (0.2, b, z + 0.2))
    return stones


LINTEL = {"west": solids.box((0, 0, 0), (0.4, 0.5, 1.2)), "east": solids.box((1.6, 0, 0), (2, 0.5, 1.2)),
          "lintel": solids.box((-0.1, 0, 1.2), (2.1, 0.5, 1.5)), "block": solids.box((0.8, 0.1, 1.5), (1.1, 0.4, 1.8))}


class Drawing:
    """How stones are written: a turn about the vertical axis, a mirror of x, a move [m], a unit [m], what points up."""

    def __init__(self, turn=0.0, mirror=False, move=(0.0, 0.0, 0.0), unit=1.0, up="z", backwards=False):
        self.turn, self.mirror, self.move, self.unit, self.up = math.radians(turn), mirror, move, unit, up
        self.backwards = backwards

    def along(self, v):
        """A direction of the stones in the scene."""
        x, y, z = (-v[0] if self.mirror else v[0]), v[1], v[2]
        c, s = math.cos(self.turn), math.sin(self.turn)
        return (c * x - s * y, s * x + c * y, z)

    def place(self, p):
        x, y, z = (a + m for a, m in zip(self.along(p), self.move))
        at = {"z": (x, y, z), "x": (z, x, y), "y": (y, z, x)}[self.up]
        return tuple(v / self.unit for v in at)

    def text(self, stones):
        names = list(stones)[::-1] if self.backwards else list(stones)
        return solids.obj({n: ([self.place(p) for p in stones[n][0]],
                               [f[::-1] if self.mirror else f for f in stones[n][1]]) for n in names})


class AnyDrawing(program.SceneTest):
    def run_drawn(self, stones, towards, share, size, drawing, *, out, ranks=1, **selection):
        (self.folder / f"{out}.obj").write_text(drawing.text(stones), encoding="utf-8")
        x, y, _ = drawing.along((math.cos(math.radians(towards)), math.sin(math.radians(towards)), 0.0))
        tree = {"mesh": {"type": "stones", "stones": {"file": f"{out}.obj", "unit": drawing.unit, "up": drawing.up,
                                                      "element size": size}},
                "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": DENSITY}},
                "joints": {"dry": {"friction coefficient": 0.6}}, "supports": {"ground": {"on": "base"}},
                "loads": {"weight": {"type": "self weight", "gravity": GRAVITY},
                          "push": {"type": "acceleration", "ax": share * GRAVITY * x, "ay": share * GRAVITY * y}},
                "steps": {"stages": {"own weight": {"loads": {"weight": 1.0}}, "push": {"loads": {"push": 1.0}}}},
                "observations": {"ground": {"place": "support", "support": "ground"}}, "newton": {"tolerance": 1e-10}, "selection": selection, "output": {"report": False}}
        run = self.run_scene(xml("drawn", tree) + "\n", out=out, ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", f"{out}: {run.said}")
        return run, drawing

    def assert_same(self, first, other, what, within=SAME):
        """Of two runs and how they were drawn, step by step."""
        (run, drawing), (again, redrawn) = first, other
        self.assertEqual(len(run.history), len(again.history), what)
        for a, b in zip(run.history, again.history):
            for key in ("largest_displacement_m", "elastic_J", "external_work_J"):
                self.assertLess(abs(a[key] - b[key]), within * abs(a[key]), f"{what}: {key}")
            force = self.reaction(a), self.reaction(b)
            mine, theirs = (d.along((1.0, 0.0, 0.0)) for d in (drawing, redrawn))
            for f, g in ((sum(p * q for p, q in zip(force[0], mine)), sum(p * q for p, q in zip(force[1], theirs))),
                         (force[0][2], force[1][2])):
                self.assertLess(abs(f - g), within * abs(force[0][2]), f"{what}: reactions")

    @staticmethod
    def reaction(row):
        return tuple(row[f"f{c}_N of ground"] for c in "xyz")

    def vary(self, stones, towards, share, size):
        first = self.run_drawn(stones, towards, share, size, Drawing(), out="first", mode="all")
        for name, drawing in (("turned", Drawing(turn=37)), ("upside", Drawing(turn=90, up="x")), ("mirrored", Drawing(mirror=True)),
                              ("backwards", Drawing(backwards=True, up="y")), ("in mm", Drawing(unit=1e-3, move=(3, -2, 5)))):
            self.assert_same(first, self.run_drawn(stones, towards, share, size, drawing, out=name, mode="all"), name)
        far = Drawing(turn=21, move=(800, 600, 10))
        self.assert_same(first, self.run_drawn(stones, towards, share, size, far, out="far", mode="all"), "far", 1e-4)
        for ranks in (2, 4):
            self.assert_same(first, self.run_drawn(stones, towards, share, size, Drawing(turn=12), out=f"on {ranks}", ranks=ranks,
                                                   mode="all"), f"on {ranks} ranks")
        chosen = {"mode": "adaptive", "error tolerance": 0.0}
        self.assert_same(first, self.run_drawn(stones, towards, share, size, Drawing(), out="chosen", **chosen), "chosen")

    def test_a_corner_of_walls(self):
        self.vary(corner(), 225.0, 0.05, 0.1)

    def test_a_lintel(self):
        self.vary(LINTEL, 20.0, 0.08, 0.15)


if __name__ == "__main__":
    program.main()

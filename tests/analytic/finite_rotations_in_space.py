"""Stones in space that turn far: how far supports may move or turn before what stands on them falls.

usage: finite_rotations_in_space.py PROGRAM MPIEXEC

Set-up    The arch of xml/spreading-arch.xml as a vault of one stone a course, between two blocks of ground. A column of
          two stones, 0.25 m square and 0.75 m high, on a third that turns about a horizontal axis in any direction to
          its sides, friction 1.5; drawn turned about the vertical too.
Expected  Rigid stones. The vault falls where the arch does (finite_rotations.py). The column falls over an edge where its
          middle is above that, tan t = 0.25 / 0.75 / cos a, with a from the normal of the nearest face to where it leans,
          and over a corner at a = 45 degrees.
Tolerance The brackets hold the expected value, give or take 0.2 %: stones of 100 GPa and 10 GPa are not rigid.
"""

import math
import pathlib
import random
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "support")]
import program  # noqa: E402  (folders of their own)
import solids  # noqa: E402
from finite_rotations import RigidHalf, WITHIN, largest_spread  # noqa: E402
from stones import xml  # noqa: E402

GRAVITY = 9.81
WIDTH, HEIGHT = 0.25, 0.375  # [m] of a stone
WEIGHT = {"type": "self weight", "gravity": GRAVITY}


def vault(length):
    """32 voussoirs, of which ground takes the place of the first and the last."""
    mesh = {"radius": 5.0, "thickness": 1.0, "embrace": 168.75, "length": length, "voussoirs": 30, "stones along": 1,
            "bond": "stack", "cells radial": 4, "cells along": 1, "ground height": 0.5}
    return {"mesh": {"type": "barrel vault", "barrel vault": mesh}, "model": {"rotations": "finite"},
            "materials": {"stone": {"Young modulus": 100e9, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"dry": {"friction coefficient": 0.6}},
            "supports": {side: {"on": f"ground {side}"} for side in ("left", "right")},
            "loads": {"weight": WEIGHT, "spreading": {"type": "settlement", "support": "right", "ux": 1.0}},
            "steps": {"stages": {"own weight": {"loads": {"weight": 1.0}}}},
            "load factor": {"first factor": 0.4, "pattern": {"spreading": 1.0}},
            "selection": {"mode": "all"}, "output": {"report": False}}


def column(leans, drawn):
    """A column whose lowest stone turns so that it leans by an angle from the normal of a face; the pattern is 1 rad."""
    way = leans + drawn
    turning = {"type": "settlement", "support": "ground", "rotation": 1.0, "axis x": -math.sin(way), "axis y": math.cos(way),
               "axis z": 0.0}
    return {"mesh": {"type": "stones", "stones": {"file": "stones.obj", "element size": WIDTH, "element": "linear"}},
            "model": {"rotations": "finite"},
            "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"dry": {"friction coefficient": 1.5}}, "supports": {"ground": {"on": "base"}},
            "loads": {"weight": WEIGHT, "turning": turning},
            "steps": {"stages": {"own weight": {"loads": {"weight": 1.0}}}},
            "load factor": {"first factor": 0.1, "largest factor": 0.7, "pattern": {"turning": 1.0}},
            "selection": {"mode": "all"}, "output": {"report": False}}


class FiniteRotationsInSpace(program.SceneTest):
    def check_bracket(self, run, expected):
        self.assertEqual(run.code, 0, run.said)
        found = run.result["collapse"]
        print(f"{found['lower']:.5f} to {found['upper']:.5f}, rigid stones {expected:.5f}")
        self.assertEqual(run.outcome, "collapse")
        self.assertTrue(found["sharp"])
        self.assertLess(found["lower"], expected * (1 + WITHIN))
        self.assertGreater(found["upper"], expected * (1 - WITHIN))

    def leaning(self, leans, drawn, *options, ranks=1, out="out"):
        stones = {f"stone {k}": solids.box((0, 0, k * HEIGHT), (WIDTH, WIDTH, (k + 1) * HEIGHT)) for k in range(3)}
        drawing = solids.drawn(stones, random.Random(1), turned=drawn, unit=1.0, up="z")
        (self.folder / "stones.obj").write_text(drawing, encoding="utf-8")
        return self.run_scene(xml("column", column(leans, drawn)) + "\n", *options, ranks=ranks, out=out)

    def test_a_vault_on_spreading_springings(self):
        run = self.run_scene(xml("vault", vault(0.5)) + "\n", ranks=2)
        self.check_bracket(run, largest_spread())
        thrust, _ = RigidHalf(5).equilibrium(run.result["collapse"]["lower"])
        self.assertAlmostEqual(run.result["statics"]["reactions"]["left"]["x_N"] / (0.5 * thrust), 1, delta=WITHIN)

    def test_a_column_leans_any_way(self):
        for degrees, drawn, ranks in ((0, 0.0, 1), (0, 0.4, 2), (25, 0.4, 1), (45, 2.0, 1), (115, -1.0, 1)):
            beside = math.radians(min(degrees % 90, 90 - degrees % 90))
            expected = math.atan(WIDTH / (2 * HEIGHT) / math.cos(beside))
            with self.subTest(degrees=degrees):
                self.check_bracket(self.leaning(math.radians(degrees), drawn, ranks=ranks, out=f"{degrees} {ranks}"), expected)

    def test_a_run_goes_on_on_other_ranks(self):
        shares = (0.1, 0.2, 0.3)

        def stages(count):
            turning = {f"by {share} rad": {"loads": {"weight": 1.0, "turning": share}} for share in shares[:count]}
            return {"steps": {"stages": {"own weight": {"loads": {"weight": 1.0}}, **turning}}}
        tree = column(0.6, 0.4)
        tree.pop("load factor")
        tree["observations"] = {"top": {"place": "mean", "blocks": "stone 2"}, "foot": {"place": "support", "support": "ground"}}
        self.leaning(0.6, 0.4, "--validate")  # draws the stones
        whole = self.run_scene(xml("whole", {**tree, **stages(3)}) + "\n", out="whole")
        self.run_scene(xml("parts", {**tree, **stages(1)}) + "\n", out="parts")
        parts = self.run_scene(xml("parts", {**tree, **stages(3)}) + "\n", "--restart", out="parts", ranks=2)
        for run in (whole, parts):
            self.assertEqual(run.outcome, "equilibrium", run.said)
        self.assertEqual(len(whole.history), len(parts.history))
        # Reactions work along an arc, and take what the column loses in height: its weight presses no differently.
        fall = 3 * WIDTH**2 * HEIGHT * 2000 * GRAVITY * 1.5 * HEIGHT * (1 - math.cos(shares[-1]))
        self.assertLess(abs(whole.history[-1]["external_work_J"]), 2e-4 * fall)
        for column_of, size in (("ux_m of top", 0.3), ("uz_m of top", 0.3), ("fz_N of foot", 1e3), ("external_work_J", 100.0)):
            for a, b in zip(whole.history, parts.history):
                self.assertLess(abs(a[column_of] - b[column_of]), 1e-6 * size, (column_of, a, b))

    def test_small_rotations_are_told_apart(self):
        run = self.leaning(0.3, 0.0, "--set", "model/rotations=small")
        self.assertEqual((run.code, run.outcome), (3, "out_of_range"), run.said)
        self.assertIn("model > rotations = finite follows the stones", run.words)

    def test_elements_whose_edges_bend_are_refused(self):
        run = self.leaning(0.3, 0.0, "--validate", "--set", "mesh/stones/element=quadratic")
        self.assertEqual(run.code, 2, run.said)
        self.assertIn('scene > model > rotations = "finite" does not go with element = "quadratic"', run.words)


if __name__ == "__main__":
    program.main()

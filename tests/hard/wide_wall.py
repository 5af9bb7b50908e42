"""A wide wall in space with every point selected closes under its own weight.

usage: wide_wall.py PROGRAM MPIEXEC

Set-up    A wall of 48 courses of 64 stones in running bond on rigid ground, 3160 blocks, on 1 and 2 ranks. In its highest
          courses stones slide on two that part, and nothing but a neighbour or a point that turns round stops them.
Expected  Equilibrium, the ground bears the weight; no more linear solves of the whole than other walls take.
Tolerance Reactions 1e-8 of the weight, the tolerance of the solver.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (folders of their own)
from stones import xml  # noqa: E402

DENSITY, GRAVITY, COURSES, STONES = 2000.0, 9.81, 48, 64
LENGTH, HEIGHT, THICKNESS, GROUND = 0.4, 0.2, 0.2, 0.2
MOST_SOLVES = 15


class WideWall(program.SceneTest):
    def test_it_closes_and_stands_on_the_ground(self):
        wall = {"courses": COURSES, "blocks per course": STONES, "block length": LENGTH, "block height": HEIGHT,
                "thickness": THICKNESS, "bond": "running", "cells along": 2, "cells up": 1, "cells across": 1,
                "ground height": GROUND}
        scene = xml("wide wall", {
            "mesh": {"type": "wall in space", "wall in space": wall},
            "materials": {"stone": {"Young modulus": 20e9, "Poisson ratio": 0.2, "density": DENSITY}},
            "joints": {"dry": {"friction coefficient": 0.6}},
            "supports": {"ground": {"on": "ground"}},
            "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}},
            "selection": {"mode": "all"},
            "steps": {"largest halvings": 0, "stages": {"own weight": {"loads": {"weight": 1.0}}}},
            "observations": {"ground": {"place": "support", "support": "ground"}}}) + "\n"
        weight = STONES * LENGTH * THICKNESS * (COURSES * HEIGHT + GROUND) * DENSITY * GRAVITY
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                run = self.run_scene(scene, out=str(ranks), ranks=ranks)
                self.assertEqual(run.outcome, "equilibrium", run.said)
                self.assertLessEqual(run.result["linear_solves"], MOST_SOLVES)
                self.assertLess(abs(run.history[-1]["fz_N of ground"] - weight), 1e-8 * weight)


if __name__ == "__main__":
    program.main()

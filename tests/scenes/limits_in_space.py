"""The static theorem in space: limit analysis, searches for a load factor, and load steps that nothing can balance.

usage: limits_in_space.py PROGRAM MPIEXEC

Set-up    A dry wall, pushed across; a prism of 1 x 0.6 x 2 m, pushed at angles from x.
Expected  The wall falls at its thickness over its height, turning about the edge of its foot. The prism with friction 0.6
          tips at 0.5, 0.5774 and 0.4243 g at 0, 30 and 45 degrees; with friction 0.2 it slides at 0.2 g.
Tolerance What tips 1e-6; what slides a thousandth, to which pyramids around cones are made finer.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import h5py  # noqa: E402  (folders of their own)
import numpy as np  # noqa: E402
import program  # noqa: E402
from stones import xml  # noqa: E402

DENSITY, GRAVITY = 2000.0, 9.81
WALL = {"courses": 10, "blocks per course": 2, "block length": 0.4, "block height": 0.2, "thickness": 0.2,
        "cells along": 2, "cells up": 1, "cells across": 1, "ground height": 0.2}
PRISM = {"courses": 1, "blocks per course": 1, "block length": 1.0, "block height": 2.0, "thickness": 0.6, "bond": "stack",
         "ground height": 0.5}


def scene(mesh, loads, stages=None, friction=0.6, **sections):
    tree = {"mesh": {"type": "wall in space", "wall in space": mesh},
            "materials": {"stone": {"Young modulus": 20e9, "Poisson ratio": 0.2, "density": DENSITY}},
            "joints": {"dry": {"friction coefficient": friction}}, "supports": {"ground": {"on": "ground"}},
            "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, **loads},
            "steps": {"stages": {"own weight": {"loads": {"weight": 1.0}}, **(stages or {})}},
            **{name.replace("_", " "): section for name, section in sections.items()}}
    return xml("limits", tree) + "\n"


def push(degrees):
    """By g in a direction from x to y."""
    return {"push": {"type": "acceleration", "ax": GRAVITY * math.cos(math.radians(degrees)),
                     "ay": GRAVITY * math.sin(math.radians(degrees))}}


RAISED = {"load_factor": {"pattern": {"push": 1.0}, "accuracy": 0.005}}


class LimitsInSpace(program.SceneTest):
    def test_a_search_ends_between_an_equilibrium_and_the_certificate(self):
        run = self.run_scene(scene(WALL, push(-90), **RAISED))
        self.assertEqual(run.outcome, "collapse", run.said)
        found = run.result["collapse"]
        self.assertLess(abs(found["certified_upper"] - 0.1), 1e-6)
        self.assertLessEqual(found["lower"], 0.1 * (1 + 1e-6))
        self.assertGreaterEqual(found["upper"], 0.1 * (1 - 1e-6))
        self.assertLess(found["upper"] - found["lower"], 0.006 * 0.1)
        self.assertIn("Above load factor 0.1 no equilibrium exists, by the static theorem", run.words)
        self.assertIn("most, towards -y and turning about an axis along x through y = 0 m, z = 0 m", run.words)

    def test_a_step_that_nothing_balances_falls_with_its_mechanism(self):
        run = self.run_scene(scene(WALL, push(90), {"push": {"loads": {"weight": 1.0, "push": 0.12}}}))
        self.assertEqual(run.outcome, "collapse", run.said)
        self.assertIn("by the static theorem (rigid limit analysis)", run.words)
        self.assertIn("83.3333 % of the way here from the loads before can be borne", run.words)
        self.assertIn("most, towards +y and turning about an axis along x through y = 0.2 m, z = 0 m", run.words)
        self.assertGreaterEqual(run.result["mechanism"]["largest_mover_block"], 0)

    def test_limit_analysis_alone_on_any_ranks(self):
        first = None
        for ranks in (1, 2, 4):
            run = self.run_scene(scene(WALL, push(-90), **RAISED), "--limit-analysis", out=f"on {ranks}", ranks=ranks)
            self.assertEqual(run.code, 0, run.said)
            found, rigid = run.result["collapse"], run.result["rigid"]
            self.assertLess(abs(found["certified_upper"] - 0.1), 1e-6)
            self.assertLess(abs(rigid["forces_found_up_to"] - 0.1), 1e-4)
            self.assertEqual(run.result["linear_solves"], 0)
            self.assertIsNone(found["estimate_without_dilatancy"])
            ground = rigid["reactions"]["ground"]
            weight = 0.8 * 0.2 * (2.0 + 0.2) * DENSITY * GRAVITY
            for end in ("least", "most"):
                for axis, force in (("x", 0.0), ("y", 0.0), ("z", weight)):
                    self.assertLess(abs(ground[f"{end}_{axis}_N"] - force), 1e-6 * weight)
            self.assertIn("upwards", run.words)
            first = first or run.result
            for key in ("certified_upper", "upper"):
                self.assertLess(abs(found[key] - first["collapse"][key]), 1e-9)
            self.assertLess(abs(rigid["free_share_of_joints"] - first["rigid"]["free_share_of_joints"]), 1e-9)

    def test_forces_that_are_drawn_balance_every_stone(self):
        run = self.run_scene(scene(WALL, push(-90), {"push": {"loads": {"push": 0.05}}}), "--limit-analysis")
        self.assertEqual(run.outcome, "equilibrium", run.said)
        with h5py.File(run.folder / "fields.h5") as file:
            joints, step = file["joints"], file["steps/0001"]
            normal = joints["normal"][()]
            force = step["joint_normal_force_N"][()]
            self.assertGreaterEqual(force.min(), -1e-6)
            on = np.zeros((int(joints["block_j"][()].max()) + 1, 3))
            along = force[:, None] * normal
            np.add.at(on, joints["block_j"][()].astype(int), along)
            np.add.at(on, joints["block_i"][()].astype(int), -along)
            stone = 0.4 * 0.2 * 0.2 * DENSITY * GRAVITY
            beds = on[np.abs(on[:, 2]) > 1e-6 * stone, 2] / stone  # beds are level, so that they bear weight by normal forces
        free = beds[beds > 0]
        self.assertTrue(np.all(np.isclose(free, 1.0, atol=1e-5) | np.isclose(free, 0.5, atol=1e-5)), beds)

    def test_a_prism_tips_and_slides(self):
        for degrees, friction, limit, finer in ((0, 0.6, 0.5, 1e-6), (30, 0.6, 0.5 / math.cos(math.radians(30)), 1e-6),
                                                (45, 0.6, 0.3 / math.sin(math.radians(45)), 1e-6), (17, 0.2, 0.2, 1.5e-3)):
            run = self.run_scene(scene(PRISM, push(degrees), friction=friction, **RAISED), "--limit-analysis",
                                 out=f"{degrees} {friction}")
            self.assertEqual(run.code, 0, run.said)
            found = run.result["collapse"]["certified_upper"]
            self.assertGreaterEqual(found, limit * (1 - 1e-6))
            self.assertLessEqual(found, limit * (1 + finer))
            below = run.result["rigid"]["forces_found_up_to"]
            self.assertLessEqual(below, limit * (1 + 1e-6))
            self.assertGreaterEqual(below, limit * (1 - finer))

    def test_loads_that_nothing_balances_are_refused(self):
        run = self.run_scene(scene(PRISM, push(45), {"push": {"loads": {"push": 0.43}}}), "--limit-analysis")
        self.assertEqual(run.outcome, "collapse", run.said)
        self.assertIn("no forces that joints admit balance the loads", run.words)
        self.assertIn("1 of 2 blocks moves", run.words)


if __name__ == "__main__":
    program.main()

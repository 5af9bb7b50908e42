"""The static theorem in space: limit analysis, searches for a load factor, and load steps that nothing can balance.

usage: limits_in_space.py PROGRAM MPIEXEC

Set-up    A dry wall, pushed across; a prism of 1 x 0.6 x 2 m, pushed at angles from x; a stone on a ridge that falls by a
          tenth to both sides, pushed across it; a cross vault on four springers and a wall on a slab, files of others
          whose folder VOUSSOIR_STONES names.
Expected  The wall falls at its thickness over its height, turning about the edge of its foot. The prism with friction 0.6
          tips at 0.5, 0.5774 and 0.4243 g at 0, 30 and 45 degrees; with friction 0.2 it slides at 0.2 g. The stone on the
          ridge bears between 0.2923 and 0.2934 g, by pyramids of 32 lines within and of 32 faces around the cones of its
          six corners, four of which lie in two places; one normal for both sides of the ridge would give 0.196. So the
          vault with friction 0.5 bears between 0.1815 and 0.1850 g along x, by another programme (HiGHS) and another
          search for joints; within 12 lines, which turn with the axes of the joints, 0.1690 to 0.1712, within 16 0.1740
          to 0.1790. The wall falls at 0.2857 g = t / h across and at 0.4041 g in 45 degrees.
Tolerance What tips 1e-6; what slides a thousandth, to which pyramids around cones are made finer.
"""

import math
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import h5py  # noqa: E402  (folders of their own)
import numpy as np  # noqa: E402
import program  # noqa: E402
import solids  # noqa: E402
from stones import xml  # noqa: E402

DENSITY, GRAVITY = 2000.0, 9.81
OTHERS = os.environ.get("VOUSSOIR_STONES")
WALL = {"courses": 10, "blocks per course": 2, "block length": 0.4, "block height": 0.2, "thickness": 0.2,
        "cells along": 2, "cells up": 1, "cells across": 1, "ground height": 0.2}
PRISM = {"courses": 1, "blocks per course": 1, "block length": 1.0, "block height": 2.0, "thickness": 0.6, "bond": "stack",
         "ground height": 0.5}


def scene(mesh, loads, stages=None, friction=0.6, kind="wall in space", supports=None, **sections):
    tree = {"mesh": {"type": kind, kind: mesh},
            "materials": {"stone": {"Young modulus": 20e9, "Poisson ratio": 0.2, "density": DENSITY}},
            "joints": {"dry": {"friction coefficient": friction}}, "supports": {"ground": supports or {"on": "ground"}},
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

    def test_a_fall_where_a_joint_was_not_found_says_that_it_was_not(self):
        beam = {"left": solids.box((0, 0, 0), (0.4, 0.5, 1)), "right": solids.box((1.6, 0, 0), (2, 0.5, 0.98)),
                "beam": solids.box((0, 0, 1), (2, 0.5, 1.3))}
        apart = scene({"file": "stones.obj"}, {}, kind="stones", supports={"on": "base"})
        (self.folder / "stones.obj").write_text(solids.obj(beam), encoding="utf-8")
        for options in ((), ("--limit-analysis",)):
            run = self.run_scene(apart, *options, out="".join(options) or "run")
            self.assertEqual(run.outcome, "collapse", run.said)
            self.assertIn("open_joints", run.warnings)
            last = run.words[run.words.index("Limit analysis:" if options else "Collapse:"):]
            self.assertIn("WARNING: ", last)
        joined = self.run_scene(apart, "--limit-analysis", "--set=mesh/stones/joint tolerance=0.03", out="joined")
        self.assertEqual(joined.outcome, "equilibrium", joined.said)

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

    def test_forces_that_are_drawn_are_those_of_one_rank(self):
        # Of many forces that balance, a programme gives those that the order of its rows leads to.
        text = (pathlib.Path(__file__).resolve().parents[2] / "xml" / "wall-with-returns.xml").read_text(encoding="utf-8")
        forces = []
        for ranks in (1, 2):
            run = self.run_scene(text, "--limit-analysis", out=f"drawn {ranks}", ranks=ranks)
            with h5py.File(run.folder / "fields.h5") as file:
                forces.append(file["steps/0001/joint_force_N"][()])
        self.assertLess(np.abs(forces[1] - forces[0]).max(), 1e-9 * np.abs(forces[0]).max())

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

    def test_heat_has_no_resultant_and_can_be_raised_without_end(self):
        heat = {"heat": {"type": "temperature", "change": 10.0}}
        tilted = {"weight": {"type": "self weight", "gravity": GRAVITY}, "push": push(20)["push"], **heat}
        for name, loads, stages in (("level", heat, None), ("tilted", tilted, {"push": {"loads": {"push": 0.2}}})):
            for ranks in (1, 2):
                run = self.run_scene(scene(PRISM, loads, stages, load_factor={"pattern": {"heat": 1.0}}), "--limit-analysis",
                                     out=f"{name} {ranks}", ranks=ranks)
                self.assertEqual((run.code, run.outcome), (0, "equilibrium"), run.said)
                self.assertIn("so they do at any factor of the pattern, since joints balance it alone", run.words)

    def test_loads_that_nothing_balances_are_refused(self):
        run = self.run_scene(scene(PRISM, push(45), {"push": {"loads": {"push": 0.43}}}), "--limit-analysis")
        self.assertEqual(run.outcome, "collapse", run.said)
        self.assertIn("no forces that joints admit balance the loads", run.words)
        self.assertIn("1 of 2 blocks moves", run.words)


def of_file(file, supports, degrees, friction=0.6, **mesh):
    return scene({"file": file, "joint tolerance": 1e-3, **mesh}, push(degrees), friction=friction, kind="stones",
                 supports=supports, **RAISED)


class StonesFromFiles(program.SceneTest):
    def between(self, run, least, most):
        self.assertEqual(run.outcome, "collapse", run.said)
        found, borne = run.result["collapse"]["certified_upper"], run.result["rigid"]["forces_found_up_to"]
        self.assertLessEqual(found, most)
        self.assertGreaterEqual(borne, least)
        self.assertLessEqual(borne, found * (1 + 1e-9))
        self.assertGreaterEqual(borne, found * (1 - 5e-3))

    def test_a_stone_on_a_ridge_climbs_one_side_of_it(self):
        ridge = [(1, -0.1), (0, 0), (-1, -0.1)]
        stones = {"below": solids.prism([(-1, -1), (1, -1), *ridge], 0.0, 1.0),
                  "above": solids.prism([*ridge[::-1], (1, 0.5), (-1, 0.5)], 0.0, 1.0)}
        (self.folder / "ridge.obj").write_text(solids.obj(stones), encoding="utf-8")
        held = {"on": "faces", "blocks": "below"}
        for size in (0.5, 1.0):
            text = of_file("ridge.obj", held, 0, friction=0.2, **{"element size": size})
            self.between(self.run_scene(text, "--limit-analysis", out=f"of {size}"), 0.2923, 0.2934)

    @program.unittest.skipUnless(OTHERS, "VOUSSOIR_STONES names no folder with files of others")
    def test_a_cross_vault_of_others(self):
        text = of_file(f"{OTHERS}/compas_dem_crossvault.obj", {"on": "base", "blocks": "one neighbour"}, 0, friction=0.5,
                       unit=0.025, **{"element size": 0.4})
        run = self.run_scene(text, "--limit-analysis")
        self.between(run, 0.1815, 0.1850)
        self.assertIn("488 joints of 452 pairs of stones, 142.018 m2", run.words)

    @program.unittest.skipUnless(OTHERS, "VOUSSOIR_STONES names no folder with files of others")
    def test_a_wall_of_others_on_a_slab(self):
        drawn = pathlib.Path(OTHERS, "compas_dem_wall.obj").read_text(encoding="utf-8")
        points, faces = solids.box((-0.5, -0.75, -0.5), (5.6, 0.75, 0))
        first = 1 + sum(line.startswith("v ") for line in drawn.splitlines())
        slab = ["o slab", *("v " + " ".join(map(repr, map(float, x))) for x in points),
                *("f " + " ".join(str(first + k) for k in face) for face in faces)]
        (self.folder / "wall.obj").write_text(drawn + "\n" + "\n".join(slab) + "\n", encoding="utf-8")
        for degrees, limit in ((90, 0.5 / 1.75), (45, 0.5 / 1.75 / math.sin(math.radians(45)))):
            text = of_file("wall.obj", {"on": "faces", "blocks": "slab"}, degrees, **{"element size": 0.25})
            run = self.run_scene(text, "--limit-analysis", out=f"at {degrees}")
            self.assertIn("65 joints of 65 pairs of stones, 17.125 m2", run.words)
            self.assertLess(abs(run.result["collapse"]["certified_upper"] - limit), 1e-6)
            self.assertLess(abs(run.result["rigid"]["forces_found_up_to"] - limit), 1e-4)


if __name__ == "__main__":
    program.main()

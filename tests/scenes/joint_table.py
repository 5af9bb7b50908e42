"""joints.csv and the reactions of result.json: what joints carry is in equilibrium, and margins are those of statics.

    joint_table.py PROGRAM MPIEXEC
"""

import csv
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "restart"))
from runs import empty, run_scene  # noqa: E402  (a folder of its own)

XML = pathlib.Path(__file__).resolve().parents[2] / "xml"
PROGRAM = MPIEXEC = None
GRAVITY, DENSITY = 9.81, 2000


def run(name, scene, *settings, ranks=1):
    """Runs a scene; its joints by pair of blocks, and the section statics of its result.json."""
    out = empty(f"joint_table/{name}")
    result = run_scene(PROGRAM, MPIEXEC, out, XML / f"{scene}.xml", *settings, ranks=ranks)
    with open(out / "joints.csv", newline="", encoding="utf-8") as file:
        joints = {(int(row.pop("block_i")), int(row.pop("block_j"))): {k: float(v) if v else math.nan for k, v in row.items()}
                  for row in csv.DictReader(file)}
    return joints, result["statics"]


class JointTable(unittest.TestCase):
    def near(self, a, b, within):
        self.assertLessEqual(abs(a - b), within, f"{a} is not {b}")

    def test_a_block_on_an_incline_has_the_margins_of_its_slope(self):
        # Half of the friction is used up at half of the slope; the weight passes the bed at h/2 tan a below the middle.
        joints, statics = run("incline", "incline", "mesh/gmsh/geometry/slope=0.3")
        self.assertEqual(len(joints), 1)
        joint = next(iter(joints.values()))
        # Forces are exact to the tolerance of the solver, 1e-8 of the largest.
        self.near(joint["friction_margin"], 0.5, 1e-6)
        self.near(abs(joint["eccentricity_m"]), 0.25 * 0.3, 1e-6)
        self.near(joint["length_m"], 1.0, 1e-12)
        self.near(joint["edge_margin"], 0.5 - 0.075, 1e-6)
        weight = 1.0 * 0.5 * DENSITY * GRAVITY
        self.near(math.hypot(joint["force_x_N"], joint["force_y_N"]), weight, 1e-6 * weight)
        self.near(joint["force_x_N"], 0, 1e-6 * weight)
        self.assertEqual((statics["hinges"], statics["sliding_joints"]), (0, 0))

    def test_every_stone_of_a_wall_is_in_equilibrium_and_so_is_the_wall_on_any_ranks(self):
        courses = 4
        size = [f"mesh/wall/courses={courses}", f"mesh/wall/blocks per course={courses}"]
        joints, statics = run("wall", "wall", *size)
        stone, push = 0.5 * 0.25 * DENSITY * GRAVITY, 0.15
        blocks = 1 + max(j for _, j in joints)
        sums = [[0.0, 0.0] for _ in range(blocks)]
        for (i, j), joint in joints.items():
            for block, way in ((i, -1), (j, 1)):
                sums[block][0] += way * joint["force_x_N"]
                sums[block][1] += way * joint["force_y_N"]
        # Weights of the stones, from the lowest free course up: half stones begin and end the odd courses.
        free = range(courses, blocks)  # the supports hold the first course, which has no half stones
        weights = {}
        block = 0
        for course in range(courses):
            count = courses + course % 2
            for k in range(count):
                weights[block] = stone / 2 if course % 2 and k in (0, count - 1) else stone
                block += 1
        self.assertEqual(block, blocks)
        for b in free:
            self.near(sums[b][1], weights[b], 1e-5 * stone)
            self.near(sums[b][0], -push * weights[b], 1e-5 * stone)
        total = sum(weights.values())
        ground = statics["reactions"]["ground"]
        self.near(ground["y_N"], total, 1e-6 * total)
        self.near(ground["x_N"], -push * total, 1e-6 * total)
        # Weight at half the height and length, pushed by 0.15 of it: the reaction passes the base by so much to the right.
        self.near(ground["through_x_m"] + push * ground["through_y_m"], 1.0 + 0.5 * push, 1e-5)
        for ranks in (2, 4):
            others, summary = run(f"wall{ranks}", "wall", *size, ranks=ranks)
            self.assertEqual(others.keys(), joints.keys())
            for pair, joint in joints.items():
                for key in ("force_x_N", "force_y_N"):
                    self.near(others[pair][key], joint[key], 1e-5 * total)
                # Friction between stones of the held course is not unique: a joint may be just at its cone or just below.
                if others[pair]["slides"] != joint["slides"]:
                    self.assertLess(max(others[pair]["friction_margin"], joint["friction_margin"]), 0.01)
            self.assertEqual(summary["hinges"], statics["hinges"])

    def test_three_hinges_of_an_arch_and_its_thrust(self):
        joints, statics = run("arch", "three-hinge-arch")
        self.assertEqual(statics["hinges"], 3)
        self.assertEqual(sum(joint["hinge"] for joint in joints.values()), 3)
        left, right = statics["reactions"]["left"], statics["reactions"]["right"]
        self.near(left["x_N"], -right["x_N"], 1e-5 * left["x_N"])
        # All joints of an arch without other loads than weight carry the same thrust.
        for joint in joints.values():
            self.near(abs(joint["force_x_N"]), left["x_N"], 1e-5 * left["x_N"])
        # By symmetry the crown bears no vertical force; the springings bear half the weight each.
        self.near(left["y_N"], right["y_N"], 1e-5 * left["y_N"])

    def test_joints_tell_how_much_of_their_strength_is_lost(self):
        joints, _ = run("triplet", "triplet")
        # The middle brick has slid by 3 mm in both, less some 60 micrometres by which bricks and mortar give way.
        slid = [joint for joint in joints.values() if joint["damage"] > 0.5]
        self.assertEqual(len(slid), 2)
        cohesion, energy = 0.35e6, 125.0  # [Pa, J/m2]
        for joint in slid:
            left = 1 - joint["damage"]
            self.assertGreater(left, math.exp(-cohesion * 3e-3 / energy))
            self.assertLess(left, math.exp(-cohesion * 2.94e-3 / energy))
        dry, _ = run("dry", "incline", "mesh/gmsh/geometry/slope=0.3")
        self.assertEqual([joint["damage"] for joint in dry.values()], [0])

    def test_places_of_what_slides_and_turns_lie_in_its_joint(self):
        # Joints of a continuum pull as well: their resultants may cross their planes anywhere.
        outside = 0
        for mode, push, kind in (("bonded", 9.0, "first_sliding"), ("adaptive", 1.4715, "first_sliding"), ("all", 1.4715, "widest_hinges")):
            joints, statics = run(f"places {mode} {push}", "wall", f"selection/mode={mode}", f"loads/sideways/ax={push}")
            self.assertTrue(statics[kind])
            for place in statics["first_sliding"] + statics["widest_hinges"]:
                joint = joints[tuple(place["blocks"])]
                self.near(math.dist((place["x_m"], place["y_m"]), (joint["x_m"], joint["y_m"])), 0, joint["length_m"] / 2 + 1e-9)
                through = math.dist((joint["through_x_m"], joint["through_y_m"]), (joint["x_m"], joint["y_m"]))
                outside += through > 1.001 * joint["length_m"] / 2
        self.assertGreater(outside, 0)

    def test_runs_that_end_in_time_have_no_table(self):
        with self.assertRaises(FileNotFoundError):
            run("time", "sliding-block")


if __name__ == "__main__":
    PROGRAM, MPIEXEC = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])

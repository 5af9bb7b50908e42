"""joints.csv in space: what joints carry is in equilibrium, its place and margins are those of statics.

usage: joint_table_in_space.py PROGRAM MPIEXEC

Set-up    A prism, an L and a trapezoid, each a stone on ground, under their weight and an acceleration that is known; a dry
          wall in space that is pushed.
Expected  The resultant crosses the bed where its moment over its normal force says; its margins are those of the convex hull
          of the bed and of Coulomb. The weight of the L passes beside it, through its notch, and it stands. A wall: forces on
          every stone balance its weight and push, on any ranks. Reports tell the joints of the least margins.
Tolerance 1e-6: forces are exact to 1e-8 of the largest.
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import solids  # noqa: E402
from stones import xml  # noqa: E402

GRAVITY, DENSITY = 9.81, 2000.0
REPORT = pathlib.Path(__file__).resolve().parents[2] / "drivers" / "report" / "make_report.py"
OWN = {"loads": {"weight": 1.0}}


def scene(mesh, supports, push, mu, **sections):
    """A structure under its weight, then pushed by shares of it along x and y."""
    return xml("joints", {
        "mesh": mesh, "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": DENSITY}},
        "joints": {"dry": {"friction coefficient": mu}}, "supports": supports,
        "loads": {"weight": {"type": "self weight", "gravity": GRAVITY},
                  "push": {"type": "acceleration", "ax": push[0] * GRAVITY, "ay": push[1] * GRAVITY}},
        "steps": {"stages": {"own weight": OWN, "push": {"loads": {"weight": 1.0, "push": 1.0}}}},
        **{name.replace("_", " "): section for name, section in sections.items()}}) + "\n"


def upright(outline, height):
    """An outline in x and y, counter-clockwise from above, from z = 0 up."""
    points, faces = solids.prism([(x, -y) for x, y in reversed(outline)], 0.0, height)
    return [(x, -z, y) for x, y, z in points], faces


def middle(outline):
    """Centroid and area."""
    crossed = [(a[0] * b[1] - b[0] * a[1], a, b) for a, b in zip(outline, outline[1:] + outline[:1])]
    area = sum(c for c, _, _ in crossed) / 2
    return [sum(c * (a[k] + b[k]) for c, a, b in crossed) / (6 * area) for k in (0, 1)], area


def margin(hull, place):
    """The least distance of a place from a side over the width across that; hull counter-clockwise."""
    least = math.inf
    for a, b in zip(hull, hull[1:] + hull[:1]):
        length = math.dist(a, b)
        away = lambda x, a=a, b=b, length=length: ((b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0])) / length
        least = min(least, away(place) / max(map(away, hull)))
    return least


class JointTableInSpace(program.SceneTest):
    def near(self, a, b, within, said=""):
        self.assertLessEqual(abs(a - b), within, f"{a} is not {b} {said}")

    def joints(self, run):
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return {(int(row["block_i"]), int(row["block_j"])): row for row in run.table("joints.csv")}

    def stand(self, outline, hull, height, push, mu=0.6, size=0.2, **more):
        """A stone on ground, pushed: its one joint, against statics."""
        low, high = (min(x[k] for x in outline) for k in (0, 1)), (max(x[k] for x in outline) for k in (0, 1))
        stones = {"ground": solids.box((*low, -0.2), (*high, 0)), "stone": upright(outline, height)}
        (self.folder / "stones.obj").write_text(solids.obj(stones), encoding="utf-8")
        run = self.run_scene(scene({"type": "stones", "stones": {"file": "stones.obj", "element size": size}},
                                   {"ground": {"on": "faces", "blocks": "ground"}}, push, mu), **more)
        joints = self.joints(run)
        self.assertEqual(len(joints), 1)
        joint = next(iter(joints.values()))
        centre, area = middle(outline)
        weight = area * height * DENSITY * GRAVITY
        self.near(joint["area_m2"], area, 1e-9)
        self.near(joint["normal_force_N"], weight, 1e-6 * weight)
        self.near(joint["shear_N"], math.hypot(*push) * weight, 1e-6 * weight)
        self.near(joint["twist_Nm"], 0, 1e-6 * weight)
        place = [c + p * height / 2 for c, p in zip(centre, push)]  # moment over normal force
        for name, value in zip(("through_x_m", "through_y_m", "through_z_m"), (*place, 0.0)):
            self.near(joint[name], value, 1e-6, run.said)
        self.near(joint["eccentricity_m"], math.hypot(*push) * height / 2, 1e-6)
        self.near(joint["edge_margin"], margin(hull, place), 1e-6)
        self.assertLessEqual(joint["friction_margin"], 1 - math.hypot(*push) / mu + 1e-6)
        self.near(run.result["statics"]["least_edge_margin"], joint["edge_margin"], 1e-12)
        return joint

    def test_a_prism_that_is_pushed(self):
        box = [(0.0, 0.0), (1.0, 0.0), (1.0, 0.6), (0.0, 0.6)]
        for number, push in enumerate(((0.0, 0.0), (0.2, 0.0), (0.0, -0.1), (0.15, 0.1))):
            joint = self.stand(box, box, 2.0, push, out=f"push {number}")
            if 0.0 in push:  # along an axis of symmetry: nothing twists
                self.near(joint["friction_margin"], 1 - math.hypot(*push) / 0.6, 2e-6)
        two = self.stand(box, box, 2.0, (0.15, 0.1), out="two ranks", ranks=2)
        for column, value in joint.items():
            self.near(two[column], value, 1e-6 * max(1.0, abs(value)))

    def test_an_l_stands_on_its_hull(self):
        outline = [(0.0, 0.0), (1.2, 0.0), (1.2, 0.4), (0.4, 0.4), (0.4, 1.2), (0.0, 1.2)]
        hull = outline[:3] + outline[4:]
        self.assertTrue(min(middle(outline)[0]) > 0.4)  # the weight passes beside the stone
        self.stand(outline, hull, 0.5, (0.0, 0.0), mu=2.0)
        pushed = self.stand(outline, hull, 0.5, (0.8, 0.8), mu=2.0, out="pushed")
        self.near(pushed["edge_x_m"] + pushed["edge_y_m"], 1.6, 1e-6)  # next to the line across the notch

    def test_a_trapezoid(self):
        outline = [(0.0, 0.0), (1.6, 0.0), (1.2, 0.8), (0.4, 0.8)]
        self.stand(outline, outline, 0.8, (0.3, 0.1))
        self.stand(outline, outline, 0.8, (-0.2, -0.3), out="back")

    def test_every_stone_of_a_wall_is_in_equilibrium_on_any_ranks(self):
        wall = {"courses": 4, "blocks per course": 3, "block length": 0.4, "block height": 0.2, "thickness": 0.2,
                "cells along": 2, "cells up": 1, "cells across": 2}
        push = (0.1, 0.02)
        text = scene({"type": "wall in space", "wall in space": wall}, {"ground": {"on": "base"}}, push, 0.6)
        self.in_their_joints(wall)
        tables = {}
        for ranks in (1, 2):
            run = self.run_scene(text, out=f"ranks {ranks}", ranks=ranks)
            tables[ranks] = self.joints(run)
        stone = 0.4 * 0.2 * 0.2 * DENSITY * GRAVITY
        blocks = 1 + max(j for _, j in tables[1])
        sums = [[0.0] * 3 for _ in range(blocks)]
        for (i, j), joint in tables[1].items():
            for block, way in ((i, -1), (j, 1)):
                for c in range(3):
                    sums[block][c] += way * joint[f"force_{'xyz'[c]}_N"]
        for b in range(3, blocks):  # the first course is held
            share = sums[b][2] / stone
            self.assertTrue(min(abs(share - 1), abs(share - 0.5)) < 1e-5, sums[b])
            for c in (0, 1):
                self.near(sums[b][c], -push[c] * sums[b][2], 1e-5 * stone)
        for pair, joint in tables[2].items():
            for column in ("force_x_N", "force_y_N", "force_z_N"):
                self.near(joint[column], tables[1][pair][column], 1e-5 * stone * blocks)
        self.report(run.folder)

    def in_their_joints(self, wall):
        """Joints of a continuum pull as well: their resultants may cross their planes anywhere, what slides may not."""
        text = scene({"type": "wall in space", "wall in space": wall}, {"ground": {"on": "base"}}, (0.9, 0.1), 0.6,
                     selection={"mode": "bonded"})
        run = self.run_scene(text, out="bonded")
        joints, sides, outside = self.joints(run), (0.4, 0.2, 0.2), 0
        self.assertTrue(run.result["statics"]["first_sliding"])
        for place in run.result["statics"]["first_sliding"]:
            joint = joints[tuple(place["blocks"])]
            for c, side in zip("xyz", sides):
                self.near(place[c + "_m"], joint[c + "_m"], side / 2 + 1e-9)
                outside += abs(joint[f"through_{c}_m"] - joint[c + "_m"]) > 1.001 * side / 2
        self.assertGreater(outside, 0)

    def report(self, folder):
        done = subprocess.run([sys.executable, REPORT, folder], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (folder / "report.html").read_text(encoding="utf-8")
        for words in ("Joints nearest to opening at an edge", "Least margins"):
            self.assertIn(words, page)

    def test_runs_that_end_in_time_have_no_table(self):
        (self.folder / "stones.obj").write_text(
            solids.obj({"ground": solids.box((0, 0, -0.2), (1, 1, 0)), "stone": solids.box((0, 0, 0), (1, 1, 0.5))}), encoding="utf-8")
        time = {"duration": 0.01, "time step": 0.005, "loads": {"weight": 1.0}}
        run = self.run_scene(scene({"type": "stones", "stones": {"file": "stones.obj", "element size": 0.5}},
                                   {"ground": {"on": "faces", "blocks": "ground"}}, (0, 0), 0.6,
                                   steps={"stages": {"own weight": OWN, "waiting": time}}))
        self.assertEqual(run.code, 0, run.said)
        self.assertFalse((run.folder / "joints.csv").exists())


if __name__ == "__main__":
    program.main()

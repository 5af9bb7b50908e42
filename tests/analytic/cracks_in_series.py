"""Of cracks that could open side by side one runs on, and the others stay closed.

usage: cracks_in_series.py PROGRAM MPIEXEC

Set-up    A bar of stones glued end to end, of length L and section A, held at one end and pulled at the other by a way U. Joints
          bear T, and their strength falls linearly with the energy G: by h = (T A)^2 / (2 G A) per opening. The bar is a
          spring of k = E A / L. And a beam on two equal glued supports that
          hangs from a thin rod, and three equal columns between feet and a plate that cannot turn.
Expected  All joints may soften at once, in equilibrium, but the bar does not stay so: any two of them gain by opening the one and
          closing the other. With one crack, where k > h,

              F = k U up to T A,      then F = k (U - g) = T A - h g,     g = (k U - T A) / (k - h)

          whatever the number of joints, increments and ranks, and that it is one of several alike is told. Where k < h the bar breaks as soon as it is pulled to T A,
          at once: nothing is left of the force, or the run says that it did not find where the bar goes. Pulled by many times
          the way that parts a joint, 2 G / T, in one step or two, it parts in one joint and has taken G A. Likewise columns.
          The beam bends and peels both of its joints at their inner edges, in equilibria that are stable; then it turns off one
          support, whose joint parts, while the other keeps nine tenths. Columns whose joints the plate opens by one way for
          all do not compete: of each the joint above or below opens, and the other does not beyond the stress at its edges.
          Of damage that comes to 6 % in joints that open, edges take 0.2 % in the others.
Tolerance 1e-6 of the force: a hundred times that of the solver, whose residual is 1e-8 of the largest force.
"""

import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import stones  # noqa: E402

YOUNG, STRENGTH, DEPTH, CELL = 10e9, 1e5, 0.1, 0.1  # [Pa, Pa, m, m]


def glued(energy):
    return {"dry": {"friction coefficient": 0.6, "cohesion": 10 * STRENGTH, "tension strength": STRENGTH,
                    "fracture energy": energy, "shear fracture energy": 100 * energy}}


class Bar(program.SceneTest):
    def pulled(self, joints, length, energy, way, increments, ranks=1, cell=CELL):
        """The last row of history.csv, and the run."""
        piece = length / (joints + 1)
        bar = {f"s{i}": stones.rectangle(i * piece, 0, (i + 1) * piece, DEPTH) for i in range(joints + 1)}
        drawing = stones.geo(bar, cell, {"left": ("s0", 3), "right": (f"s{joints}", 1)})
        scene = stones.scene("stones.geo", ["left", "right"],
                             {"pull": {"type": "settlement", "support": "right", "ux": way}},
                             {"pulled": {"increments": increments, "loads": {"pull": 1.0}}}, joints=glued(energy),
                             materials={"stone": {"Young modulus": YOUNG, "Poisson ratio": 0.0}},
                             observations={"end": {"place": "support", "support": "right"}})
        run = self.run_scene(scene, drawing=drawing, out=f"{joints}_{increments}_{ranks}", ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run.history[-1], run

    def test_one_crack_runs_whatever_the_increments_and_ranks(self):
        length, energy, way = 3.0, 10.0, 5e-5  # [m, J/m2, m]
        k, h = YOUNG / length, STRENGTH**2 / (2 * energy)  # [Pa/m]
        opening = (k * way - STRENGTH) / (k - h)
        self.assertGreater(k, h)
        for increments, ranks in (1, 1), (4, 1), (40, 1), (4, 2):
            with self.subTest(increments=increments, ranks=ranks):
                end, run = self.pulled(2, length, energy, way, increments, ranks)
                force = (STRENGTH - h * opening) * DEPTH
                self.assertLess(abs(end["fx_N of end"] - force), 1e-6 * force, run.said)
                self.assertEqual(end["open_points"], 2, run.said)  # those of one joint
                self.assertNotIn("unstable", run.warnings)
                self.assertIn("one_of_alike", run.warnings)

    def test_so_does_one_of_many(self):
        length, energy, way = 3.0, 10.0, 4e-5
        k, h = YOUNG / length, STRENGTH**2 / (2 * energy)
        force = (STRENGTH - h * (k * way - STRENGTH) / (k - h)) * DEPTH
        for joints, increments, cell in (5, 1, CELL), (5, 3, CELL), (5, 8, CELL), (9, 2, CELL), (3, 2, CELL / 3):
            with self.subTest(joints=joints, increments=increments, cell=cell):
                end, run = self.pulled(joints, length, energy, way, increments, cell=cell)
                self.assertLess(abs(end["fx_N of end"] - force), 1e-6 * force, run.said)
                self.assertEqual(end["open_points"], 1 + round(DEPTH / cell), run.said)
                self.assertNotIn("unstable", run.warnings)

    def test_torn_apart_in_any_number_of_steps_it_parts_in_one_joint(self):
        length, energy = 3.0, 10.0
        parts = 2 * energy / STRENGTH  # [m] opening at which nothing is left
        for joints, ways, increments, ranks in (2, 2.1, 1, 1), (2, 2.1, 2, 1), (5, 40.0, 1, 1), (9, 11.0, 2, 1), (5, 7.0, 1, 2):
            with self.subTest(joints=joints, ways=ways, increments=increments, ranks=ranks):
                end, run = self.pulled(joints, length, energy, ways * parts, increments, ranks)
                self.assertLess(abs(end["fx_N of end"]), 1e-6 * STRENGTH * DEPTH, run.said)
                self.assertEqual(end["open_points"], 2, run.said)
                taken = run.result["energy"]["fracture_J"]
                self.assertLess(abs(taken - energy * DEPTH), 1e-6 * energy * DEPTH, run.said)

    def test_a_bar_too_long_for_its_joints_breaks_at_once(self):
        length, energy = 30.0, 10.0
        k, h = YOUNG / length, STRENGTH**2 / (2 * energy)
        self.assertLess(k, h)
        for increments in 1, 4:
            with self.subTest(increments=increments):
                end, run = self.pulled(2, length, energy, 1.2 * STRENGTH / k, increments)
                broken = abs(end["fx_N of end"]) < 1e-6 * STRENGTH * DEPTH and end["open_points"] == 2
                self.assertTrue(broken or "unstable" in run.warnings, run.said)


class SideBySide(program.SceneTest):
    def lifted(self, outlines, feet, hook, way, increments=4):
        edges = {foot: (foot, 0) for foot in feet}
        scene = stones.scene("stones.geo", [*feet, "hook"],
                             {"lift": {"type": "settlement", "support": "hook", "uy": way}},
                             {"lifted": {"increments": increments, "loads": {"lift": 1.0}}}, joints=glued(10.0))
        run = self.run_scene(scene, drawing=stones.geo(outlines, 0.1, {**edges, "hook": hook}))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        self.assertNotIn("unstable", run.warnings, run.said)
        return sorted(joint["damage"] for joint in run.table("joints.csv"))

    def test_a_beam_that_hangs_turns_off_one_of_its_equal_supports(self):
        beam = [(0, 0.2), (0.2, 0.2), (1.8, 0.2), (2, 0.2), (2, 0.6), (1.05, 0.6), (1.05, 1.6), (0.95, 1.6), (0.95, 0.6),
                (0, 0.6)]
        damage = self.lifted({"left": stones.rectangle(0, 0, 0.2, 0.2), "right": stones.rectangle(1.8, 0, 2, 0.2),
                              "beam": stones.polygon(beam)}, ["left", "right"], ("beam", 6), 1.2e-4)
        self.assertEqual(damage[1], 1.0)
        self.assertLess(damage[0], 0.1)

    def columns(self, way, increments=4):
        """Damage of the joints of three columns below a plate, in order."""
        columns = {f"c{i}": stones.rectangle(0.4 * i, 0.2, 0.4 * i + 0.2, 1.2) for i in range(3)}
        feet = {f"f{i}": stones.rectangle(0.4 * i, 0, 0.4 * i + 0.2, 0.2) for i in range(3)}
        corners = sum(([(0.4 * i, 1.2), (0.4 * i + 0.2, 1.2)] for i in range(3)), [])
        plate = stones.polygon([*corners, (1.0, 1.4), (0, 1.4)])
        return self.lifted({**feet, **columns, "plate": plate}, list(feet), ("plate", 6), way, increments)

    def test_a_plate_that_cannot_turn_lifts_three_columns_alike(self):
        damage = self.columns(2.5e-5)
        self.assertGreater(damage[3], 0.05)
        self.assertLess(damage[2], 0.005)

    def test_torn_off_each_column_parts_in_one_joint(self):
        for increments in 1, 2:
            damage = self.columns(5e-3, increments)
            self.assertEqual(damage[3:], [1.0] * 3)
            self.assertLess(damage[2], 0.01)


if __name__ == "__main__":
    program.main()

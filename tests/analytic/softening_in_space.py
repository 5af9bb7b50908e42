"""Joints in space that lose their strength: what they take, in any direction, and that of cracks side by side one runs on.

usage: softening_in_space.py PROGRAM MPIEXEC

Set-up    A column of stones between a foot and a head that are held, joined by mortar of 0.05 MPa, 0.1 MPa, 10 and 50 J/m2.
          The head is lifted, pressed and moved across in directions that are no axis, in few load steps and in many, on 1,
          2 and 4 ranks; or lifted where the column has several joints. The prism, its stones and its joints are those of
          fracture_energy and cracks_in_series, which hold the plane to the same.
Expected  A joint takes its energy times its area in opening, and in shear, whatever the direction and whether the way turns;
          friction takes its force times the way beside it. Of n joints one opens, and with the stiffness of the column
          k = E A / L and the slope h = T^2 A / (2 G) of the strength the force at a lift U is T A - h (k U - T A) / (k - h).
Tolerance 1e-8 of the energy where all strength is lost; 1e-6 of the force, a hundred times what the solver leaves.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
from stones import xml  # noqa: E402

OPENING, SHEAR, FRICTION, MODULUS, TENSION = 10.0, 50.0, 0.6, 10e9, 5e4  # [J/m2, J/m2, -, Pa, Pa]
LENGTH, THICKNESS = 1.0, 0.6  # [m]
AREA = LENGTH * THICKNESS
MORTAR = {"friction coefficient": FRICTION, "cohesion": 1e5, "tension strength": TENSION, "fracture energy": OPENING,
          "shear fracture energy": SHEAR}
AXES = "xyz"


def column(moves, courses=2, height=1.0, cells=2, mortar=None, increments=1):
    """Stages that bring the head to places (x, y, z) [m] from where it was built."""
    mesh = {"courses": courses, "blocks per course": 1, "block length": LENGTH, "block height": height, "thickness": THICKNESS,
            "bond": "stack", "cells along": cells, "cells up": 1, "cells across": cells}
    stages = {f"move {k}": {"increments": increments, "loads": dict(zip(AXES, move))} for k, move in enumerate(moves, 1)}
    return xml("column", {
        "mesh": {"type": "wall in space", "wall in space": mesh},
        "materials": {"stone": {"Young modulus": MODULUS, "Poisson ratio": 0.0, "density": 2000.0}},
        "joints": {"mortar": {**MORTAR, **(mortar or {})}}, "supports": {"foot": {"on": "base"}, "head": {"on": "top"}},
        "loads": {axis: {"type": "settlement", "support": "head", f"u{axis}": 1.0} for axis in AXES},
        "newton": {"tolerance": 1e-11}, "observations": {"head": {"place": "support", "support": "head"}},
        "steps": {"stages": stages}}) + "\n"


def across(degrees, way, up=-4e-5):
    return (way * math.cos(math.radians(degrees)), way * math.sin(math.radians(degrees)), up)


class SofteningInSpace(program.SceneTest):
    def energy(self, *moves, ranks=1, **told):
        run = self.run_scene(column(moves, **told), ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return {key.removesuffix("_J"): value for key, value in run.result["energy"].items()}

    def near(self, value, wanted, relative):
        self.assertLess(abs(value - wanted), relative * abs(wanted))

    def test_opening_takes_the_energy_of_the_joint_whatever_the_steps(self):
        up = [(0, 0, z) for z in (6e-5, 2e-4, 1e-3)]
        for moves in ([up[-1]], up, [*up[:2], (0, 0, -1e-5), *up[1:]]):
            for shape in ("linear", "exponential"):
                taken = self.energy(*moves, *([(0, 0, 1e-2)] if shape == "exponential" else []), mortar={"softening": shape})
                self.near(taken["fracture"], OPENING * AREA, 1e-8)

    def test_shear_takes_its_energy_beside_friction_in_any_direction(self):
        pressed = across(0, 0)
        for degrees in (0, 30, 90, 200):
            taken = self.energy(pressed, across(degrees, 5e-3))
            self.near(taken["fracture"], SHEAR * AREA, 1e-8)
            self.assertLess(abs(taken["imbalance"]), 1e-8 * SHEAR)
            self.near(taken["friction"], FRICTION * 0.2e6 * AREA * 5e-3, 0.1)  # stones give way by some of it

    def test_so_does_a_way_that_turns(self):
        taken = self.energy(across(0, 0), across(20, 5e-4), across(65, 1e-3), across(110, 3e-3), across(200, 6e-3))
        self.near(taken["fracture"], SHEAR * AREA, 1e-8)

    def test_a_joint_that_opens_and_slips_takes_an_energy_between(self):
        taken = self.energy(across(30, 4e-4, 2e-4), across(30, 2e-3, 1e-3))
        self.assertGreater(taken["fracture"], OPENING * AREA)
        self.assertLess(taken["fracture"], SHEAR * AREA)

    def test_ranks_agree(self):
        moves = (0, 0, 1e-4), across(30, 3e-4, 1.2e-4), across(75, 2e-3)
        one, *others = (self.energy(*moves, ranks=n) for n in (1, 2, 4))
        for other in others:
            for key in ("fracture", "friction", "elastic"):
                self.assertLess(abs(other[key] - one[key]), 1e-8 * SHEAR * AREA)

    def test_one_crack_of_many_runs_on(self):
        stiffness, slope = MODULUS / 3.0, TENSION**2 / (2 * OPENING)  # [Pa/m]
        lift = 2.2e-5
        force = (TENSION - slope * (stiffness * lift - TENSION) / (stiffness - slope)) * AREA
        self.assertGreater(stiffness * lift, TENSION)
        for courses, increments, ranks in (3, 1, 1), (3, 7, 1), (3, 2, 2), (6, 3, 1):
            with self.subTest(courses=courses, increments=increments, ranks=ranks):
                run = self.run_scene(column([(0, 0, lift)], courses, 3.0 / courses, increments=increments), ranks=ranks)
                self.assertEqual(run.outcome, "equilibrium", run.said)
                self.near(run.history[-1]["fz_N of head"], force, 1e-6)
                self.assertEqual(run.history[-1]["open_points"], 9, run.said)  # those of one joint
                self.assertNotIn("unstable", run.warnings)


if __name__ == "__main__":
    program.main()

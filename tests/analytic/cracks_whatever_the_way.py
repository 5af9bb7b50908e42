"""Joints that soften do not depend on steps, units, sides, selection or ranks.

usage: cracks_whatever_the_way.py PROGRAM MPIEXEC

Set-up    A stack of four stones with rigid joints, and the wall W(4) with joints that are springs until they crack, between plates.
          Strengths are 0.1 MPa and 0.2 MPa, 0.7 of that in the middle bed, and take 10 and 50 J/m2. The upper plate goes
          down by 0.03 mm, then sideways by 0.6 mm. And the triplet of xml/triplet.xml, until half of its cohesion is lost.
          Where three or more stones meet, forces of rigid joints are not unique, so neither is what cracks first: the stack
          has no such place, and springs share forces in one way only.
Expected  Steps: the joints of the triplet slip one way only, so their state depends on where they are: 1, 4 and 16 steps end
          alike. Units: with powers of two every number is the same but for its exponent; in mm, N and MPa all is the same to
          round-off. Sides: pushed to the left the stack is the mirror image. Selection: a threshold of zero is as good as
          all points. Ranks: 1, 2 and 4 alike. Law: after each step no point has lost more than the largest of its recorded
          openings, and its way from slip to slip, take: what a solver tries on its way to a state is no part of a history.
Tolerance 1e-6 of the largest displacement, a hundred times the tolerance of the solver (1e-8 of the largest force); 1e-5 in
          damage, which grows from 0 to 1 over ways as large as these displacements, or a third of them.
"""

import sys
import unittest

import numpy as np

from cracked_joints import XML, Programs, run, scenes
from drawing import grid

PRESS, PUSH = 30e-6, 6e-4  # [m] of the upper plate
WEAK = 0.7  # strength of the middle bed by that of the others
LIME = {"friction coefficient": 0.6, "cohesion": 2e5, "tension strength": 1e5, "fracture energy": 10.0,
        "shear fracture energy": 50.0}  # [-, Pa, Pa, J/m2, J/m2]
SPRINGS = {"normal stiffness": 1e11, "tangential stiffness": 0.4e11}  # [Pa/m]


def pushed(kind, name, *settings, ranks=1, length=1.0, force=1.0, side=1):
    """Result and Steps of the stack or the wall, in units of which so many make a metre and a newton."""
    stress, energy = force / length**2, force / length

    def lime(strength):
        units = {"friction coefficient": 1.0, "cohesion": strength * stress, "tension strength": strength * stress,
                 "fracture energy": energy, "shear fracture energy": energy}
        springs = {key: value * stress / length for key, value in SPRINGS.items()} if kind == "wall" else {}
        return {**{key: LIME[key] * unit for key, unit in units.items()}, **springs}

    wall = scenes.wall(4, block_length=0.5 * length, block_height=0.25 * length)
    mesh, below, course = (wall, "base", "course") if kind == "wall" else (grid(1, 4, 1.0, 0.25, 0.125, scale=length),
                                                                          "ground", "row")
    scene = scenes.scene(
        mesh, supports={"base": {"on": below}, "plate": {"on": "top"}}, model={"thickness": 1.0 * length},
        stone={"Young modulus": 10e9 * stress, "density": 2000 * force / length**4},
        loads={"press": {"type": "settlement", "support": "plate", "uy": -PRESS * length},
               "push": {"type": "settlement", "support": "plate", "ux": side * PUSH * length}},
        stages={"pressed": {"loads": {"weight": 0.0, "press": 1.0}}, "pushed": {"increments": 6, "loads": {"push": 1.0}}})
    scene["joints"] = {"lime": lime(1.0), "weak": {"between": f"{course} 1", "and": f"{course} 2", **lime(WEAK)}}
    scene["steps"].pop("expect collapse")
    result, steps = run(f"cracks_whatever_the_way/{kind} {name}", scene, *settings, ranks=ranks)
    lost = steps.damage[-1]
    print(f"{kind} {name}: {result['linear_solves']} solves, {(lost > 0).sum()} of {lost.size} points damaged")
    return result, steps


class CracksWhateverTheWay(unittest.TestCase):
    def equal(self, some, others):
        scale = np.abs(others.displacement[-1]).max()
        apart = np.abs(some.displacement - others.displacement).max() / scale
        print(f"  difference {apart:.1e}, of damage {np.abs(some.damage - others.damage).max():.1e}")
        self.assertLess(apart, 1e-6)
        np.testing.assert_allclose(some.damage, others.damage, atol=1e-5)

    def test_stack_and_wall_crack(self):
        for kind in ("stack", "wall"):
            _, steps = pushed(kind, "as it is")
            self.assertGreater(steps.damage[-1].max(), 0.5)
            self.assertGreater((steps.damage[-1] > 0.01).sum(), 8)
            self.assertGreater((steps.damage[-1] == 0).sum(), 3)

    def test_no_point_loses_more_than_its_states_take(self):
        for steps in (1, 6, 24):
            for kind in ("stack", "wall"):
                _, found = pushed(kind, f"law {steps}", f"steps/stages/pushed/increments={steps}")
                weak = np.where((np.abs(found.position[:, 1] - 0.5) < 1e-6) & (np.abs(found.normal[:, 1]) > 0.5), WEAK, 1)
                beyond = found.lost_beyond_states({**LIME, **(SPRINGS if kind == "wall" else {})}, weak)
                print(f"{kind}, {steps} steps: beyond the states {beyond:.1e}")
                self.assertLess(beyond, 1e-6)

    def test_steps(self):
        ends = [run(f"cracks_whatever_the_way/triplet {steps}", XML / "triplet.xml", "loads/push/uy=-3e-4",
                    "steps/stages/to the peak/loads/push=0", "steps/stages/to the peak/increments=1",
                    f"steps/stages/through/increments={steps}")[1] for steps in (1, 4, 16)]
        for end in ends:
            end.displacement, end.damage = end.displacement[-1:], end.damage[-1:]
        self.assertGreater(ends[0].damage.min(), 0.4)
        self.assertLess(ends[0].damage.max(), 0.6)
        for other in ends[1:]:
            self.equal(other, ends[0])
            np.testing.assert_allclose(other.shear[-1], ends[0].shear[-1], rtol=1e-6)

    def test_units_that_are_powers_of_two_change_not_a_bit(self):
        for kind in ("stack", "wall"):
            (result, si), (scaled, other) = (pushed(kind, f"{length:g} {force:g}", length=length, force=force)
                                             for length, force in ((1.0, 1.0), (1024.0, 64.0)))
            for key in ("linear_solves", "krylov_iterations"):
                self.assertEqual(scaled[key], result[key])
            np.testing.assert_array_equal(other.displacement, 1024 * si.displacement)
            np.testing.assert_array_equal(other.damage, si.damage)

    def test_millimetres_and_megapascals(self):
        for kind in ("stack", "wall"):
            (_, si), (_, other) = (pushed(kind, f"{length:g}", length=length) for length in (1.0, 1000.0))
            other.displacement /= 1000
            self.equal(other, si)

    def test_sides(self):
        _, right = pushed("stack", "right")
        _, left = pushed("stack", "left", side=-1)
        mirrored = np.lexsort((-right.position[:, 0].round(6), right.position[:, 1].round(6)))
        order = np.lexsort((left.position[:, 0].round(6), left.position[:, 1].round(6)))
        for one, other, sign in ((left.gap, right.gap, 1), (left.slip, right.slip, -1)):
            np.testing.assert_allclose(one[:, order], sign * other[:, mirrored], atol=1e-6 * PUSH)
        np.testing.assert_allclose(left.damage[:, order], right.damage[:, mirrored], atol=1e-5)

    def test_selection_to_a_threshold_of_zero(self):
        self.equal(pushed("stack", "threshold", "selection/error tolerance=0")[1],
                   pushed("stack", "all", "selection/mode=all")[1])

    def test_ranks(self):
        for kind in ("stack", "wall"):
            (_, one), *others = (pushed(kind, f"on {ranks} ranks", ranks=ranks) for ranks in (1, 2, 4))
            for _, other in others:
                self.equal(other, one)


if __name__ == "__main__":
    Programs.take(sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

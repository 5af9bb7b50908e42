"""Whole joints that crack and soften, beside closed forms.

usage: cohesive_sections.py PROGRAM MPIEXEC

Triplet   Two joints are sheared under a lateral pressure s that stays. Bricks without give slip by u everywhere alike, the
          way the middle one is pushed, so shear is

              tau = c exp(-c u / G_II) + mu s:        c + mu s at first, mu s in the end,

          whatever part of s each point bears, since friction is linear in it. The bricks of xml/triplet.xml give way, and
          the joints crack from their ends.
Column    Two stones and a bed of depth h = 1 m in mortar k_n. The upper one bears a pressure and is turned by an angle a
          about a level; its height is free. Where stones give nothing sections stay plane: the bed, from x = 0 to h, is parted
          by d = b + a x, and with d_e = T / k_n, d_f = 2 G_I / T its tension is

              t = k_n d                          d <= d_e, pressure included
              t = T (d_f - d) / (d_f - d_e)      up to d_f, 0 beyond            (linear softening in series with mortar)
              t = t_m d / d_m                    back from the largest d_m, 0 < d < d_m

          b follows from the force of the bed, that of the pressure, and the moment from b.
Limits    More and more energy: strength stays, so shear is c + mu s at any slip and t = min(k_n d, T). Less and less: what
          joints without energies do.
Tolerance Stones of 1e15 Pa (column: 1e16 Pa) shorten by 1e-6 of what the joints give: 2e-6, and 1e-5 where that is multiplied
          by the slope of softening. A bed of n cells is the rule of trapezes: kinks of t leave an error of order 1 / n^2.
"""

import sys
import unittest

import numpy as np

from cracked_joints import XML, Programs, run, scenes
from drawing import Drawing

COHESION, FRICTION, SHEAR_ENERGY = 0.35e6, 0.75, 125.0  # [Pa, -, J/m2] of xml/triplet.xml
STIFF = ["materials/brick/Young modulus=1e15", "joints/mortar/normal stiffness=inf", "joints/mortar/tangential stiffness=inf",
         "steps/stages/to the peak/increments=3", "steps/stages/through/increments=6"]


def triplet(name, pressure, *settings):
    """Ways that the middle brick is pushed [m] and mean shear of the joints [Pa] step by step, and the reactions."""
    result, steps = run(f"cohesive_sections/{name}", XML / "triplet.xml", f"loads/lateral/pressure={pressure}", *settings)
    pushed = -steps.displacement[1:, :, 1].min(axis=1)
    mean = np.abs(steps.shear[1:]) @ steps.area / steps.area.sum()
    reactions = result["statics"]["reactions"]
    print(f"{name}: peak {mean.max():.0f} Pa, end {mean[-1]:.0f} Pa, {result['linear_solves']} solves")
    return pushed, mean, reactions["press"]["y_N"] / steps.area.sum(), reactions["wall"]["x_N"] / steps.area.sum() * 2


class Triplet(unittest.TestCase):
    def test_bricks_without_give_show_the_law_of_the_joint(self):
        for pressure in (0.1e6, 0.5e6, 1e6):
            for reach in (1e-6, 3e-3):  # 0.3 % of cohesion lost, and all but 2e-4
                pushed, shear, press, wall = triplet(f"stiff {pressure:g} {reach:g}", pressure, *STIFF,
                                                     f"loads/push/uy={-reach}")
                self.assertLess(abs(pushed[-1] / reach - 1), 1e-9)
                expected = COHESION * np.exp(-COHESION * pushed / SHEAR_ENERGY) + FRICTION * pressure
                np.testing.assert_allclose(shear, expected, rtol=2e-6)
                np.testing.assert_allclose([-press, wall], [shear[-1], pressure], rtol=1e-7)
                if reach < 1e-5:  # after 2e-8 m: cohesion lost by 5e-5
                    self.assertLess(abs(shear[0] / (COHESION + FRICTION * pressure) - 1), 5e-5)

    def test_bricks_that_give_way_crack_from_the_ends_and_end_in_friction(self):
        for pressure in (0.1e6, 0.5e6, 1e6):
            _, shear, *_ = triplet(f"as is {pressure:g}", pressure)
            strength = COHESION + FRICTION * pressure
            # Where a joint reaches its strength first it has lost some before the rest follows.
            self.assertLess(shear.max(), strength)
            self.assertGreater(shear.max(), 0.95 * strength)
            # exp(-c u / G_II) = 2.2e-4 is left of c, with u = 3 mm less what mortar and bricks take of the way: shear by
            # k_t, 21 micrometres under 1 MPa, and half the stress of the middle brick by its modulus, 38 micrometres.
            left = COHESION * np.exp(-COHESION * np.array([3e-3, 3e-3 - 60e-6]) / SHEAR_ENERGY)
            self.assertLess(left[0], shear[-1] - FRICTION * pressure)
            self.assertLess(shear[-1] - FRICTION * pressure, left[1])

    def test_the_work_is_that_of_the_press_and_of_the_pressure_beside(self):
        _, steps = run("cohesive_sections/work", XML / "triplet.xml", "loads/lateral/pressure=0.5e6")
        x, y = steps.coordinates.T
        face = np.where(x > x.max() - 1e-9)[0]
        face = face[np.argsort(y[face])]
        # Of the mean way of every edge; the pressure grows from nothing in the first step.
        ways = np.array([np.trapezoid(u, y[face]) if hasattr(np, "trapezoid") else np.trapz(u, y[face])
                         for u in steps.displacement[:, face, 0]])
        beside = -0.5e6 * 0.1 * (ways[0] / 2 + ways[-1] - ways[0])
        expected = steps.work_of_support("press") + beside
        print(f"press and pressure do {expected:.6g} J, of which the pressure {beside:.3g} J")
        self.assertLess(abs(steps.work_of_means() / expected - 1), 1e-8)
        self.assertLess(abs(float(steps.history[-1]["external_work_J"]) / expected - 1), 1e-2)

    def test_strength_stays_where_energy_has_no_end(self):
        _, shear, *_ = triplet("perfect", 0.5e6, *STIFF, "joints/mortar/shear fracture energy=1e12",
                               "joints/mortar/fracture energy=1e12")
        np.testing.assert_allclose(shear, COHESION + FRICTION * 0.5e6, rtol=2e-6)

    def test_no_energy_is_little_energy(self):
        ends = [triplet(f"energy {energy:g}", 0.5e6, f"joints/mortar/shear fracture energy={energy}",
                        f"joints/mortar/fracture energy={energy}")[1] for energy in (0, 1e-6)]
        # Statuses of a joint that has lost its strength are the same, so solutions are, to the tolerance of the solver.
        np.testing.assert_allclose(ends[0], ends[1], rtol=1e-6)
        self.assertLess(abs(ends[0][-1] - FRICTION * 0.5e6), 1e-6 * FRICTION * 0.5e6)


TENSION, OPENING_ENERGY, MORTAR, PRESSURE = 5e4, 10.0, 1e9, 2e4  # [Pa, J/m2, Pa/m, Pa]
ELASTIC, PARTED = TENSION / MORTAR, 2 * OPENING_ENERGY / TENSION  # [m] d_e, d_f
ANGLES = [4e-5, 1e-4, 2e-4, 4e-4, 7e-4, 1.2e-3]  # [rad] the strength is reached at 1.4e-4


def traction(parted, largest=0.0, perfect=False):
    """t [Pa] of what is parted by d [m] and has been by largest."""
    def grown(d):
        soft = TENSION if perfect else TENSION * np.clip((PARTED - d) / (PARTED - ELASTIC), 0, 1)
        return np.where(d <= ELASTIC, MORTAR * d, soft)

    # Below the largest d it has been it comes back along a straight line to nothing; below nothing it presses.
    back = (parted > 0) & (parted < largest)
    return np.where(back, grown(np.maximum(largest, 1e-30)) * parted / np.maximum(largest, 1e-30), grown(parted))


def height(force):
    """b for which a rising force of it is that of the pressure."""
    low, high = -1e-2, 1e-2
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if force(middle) < -PRESSURE else (low, middle)
    return middle


def points(angles, cells, perfect=False):
    """Moment about the middle of the bed [N m/m] for angles one after the other, of the points of so many cells."""
    x = np.linspace(0, 1, cells + 1)
    share = np.full(cells + 1, 1 / cells)
    share[[0, -1]] /= 2
    largest = np.zeros(cells + 1)
    moments = []
    for angle in angles:
        b = height(lambda b: share @ traction(b + angle * x, largest, perfect))
        moments.append(share * (x - 0.5) @ traction(b + angle * x, largest, perfect))
        largest = np.maximum(largest, b + angle * x)
    return np.array(moments)


def continuous(angle):
    """The moment of the section itself at an angle that grows: straight pieces of t, which two points of Gauss integrate."""
    def integrals(b):
        kinks = [(d - b) / angle for d in (ELASTIC, PARTED)]
        ends = np.unique(np.clip([0, *kinks, 1], 0, 1))
        force = moment = 0.0
        for start, end in zip(ends, ends[1:]):
            x = (start + end) / 2 + np.array([-1, 1]) * (end - start) / 2 / np.sqrt(3)
            t = traction(b + angle * x) * (end - start) / 2
            force, moment = force + t.sum(), moment + t @ (x - 0.5)
        return force, moment

    return integrals(height(lambda b: integrals(b)[0]))[1]


def column(name, angles, cells, **law):
    """Moments about the middle of the bed [N m/m] after stages that turn the upper stone to these angles [rad]."""
    drawing = Drawing(1 / cells)
    drawing.box(0, -0.25, 1, 0.25, bottom="ground")
    drawing.box(0, 0, 1, 0.25, top="top", right="side")
    turn = {"type": "settlement", "support": "side", "rotation": 1.0, "about x": 0.0, "about y": 0.0}
    scene = scenes.scene(
        drawing, supports={"ground": {"on": "ground"}, "side": {"on": "side", "components": "x"}},
        loads={"top": {"type": "traction", "on": "top", "pressure": PRESSURE}, "turn": turn},
        stages={f"turned {k}": {"loads": {"weight": 0.0, "top": 1.0, "turn": angle}} for k, angle in enumerate(angles)},
        stone={"Young modulus": 1e16, "Poisson ratio": 0.0}, newton={"tolerance": 1e-10})
    scene["joints"] = {"mortar": {
        "friction coefficient": 0.6, "cohesion": 2 * TENSION, "tension strength": TENSION, "normal stiffness": MORTAR,
        "tangential stiffness": 0.4 * MORTAR, "fracture energy": OPENING_ENERGY, "shear fracture energy": 5 * OPENING_ENERGY,
        **law}}
    scene["steps"].pop("expect collapse")
    result, steps = run(f"cohesive_sections/{name}", scene)
    force = -steps.pressure @ steps.area
    moments = -steps.pressure @ (steps.area * (steps.position[:, 0] - 0.5))
    print(name, moments, f"{result['linear_solves']} solves")
    np.testing.assert_allclose(force, -PRESSURE, rtol=1e-7)
    return moments


class Column(unittest.TestCase):
    def test_a_bed_of_points_bends_cracks_and_comes_back_as_they_do(self):
        angles = ANGLES + [8e-4, 4e-4, 9e-4, 1.6e-3, 1e-4]
        expected = points(angles, 16)
        np.testing.assert_allclose(column("points", angles, 16), expected, atol=1e-5 * expected.max())

    def test_more_points_come_to_the_section(self):
        expected = np.array([continuous(angle) for angle in ANGLES])
        self.assertGreater(expected.max(), 1.2 * expected[-1])  # beyond its peak it softens
        for cells in (8, 16, 32, 64):
            error = np.abs(column(f"cells {cells}", ANGLES, cells) - expected).max() / expected.max()
            print(f"{cells} cells: {error:.2e}, {error * cells**2:.2f} / n^2")
            self.assertLess(error, 3 / cells**2)

    def test_strength_stays_where_energy_has_no_end(self):
        law = {"fracture energy": 1e9, "shear fracture energy": 1e9}
        expected = points(ANGLES, 16, perfect=True)
        np.testing.assert_allclose(column("perfect", ANGLES, 16, **law), expected, atol=1e-5 * expected.max())


if __name__ == "__main__":
    Programs.take(sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

"""One stone in space on another: twist, slip along two directions, slopes, spin and rocking, against closed forms.

usage: prism_in_space.py PROGRAM MPIEXEC [names of tests]

Set-up    Prisms of one or two stones on rigid ground, of material without Poisson's effect, so that they press evenly.
Expected  A square joint of side a that turns under an even pressure resists by mu N a (sqrt 2 + asinh 1) / 6 = 0.3826 mu N a.
          A block that is held sideways by 0.6 of its friction slips at 0.8 of it across, along the resultant. On a slope
          it stands below the angle of friction, in whatever direction that falls, and above it slides with what is left.
          A block that spins on its base is stopped by the same moment. A prism that is set rocking about an edge or about
          a corner is slowed by the constant moment of its weight, as small rotations have it, and keeps its energy.
Tolerance 4 % where friction is summed up at the nodes of four cells a side, which take 3.9 % too much: the sum over nodes
          itself to 0.5 %. Of motions 1 %: what elastic stones tremble beside them. The way of a stone that slides off, at
          the corner that moves most, 0.03, two degrees: nothing resists a slow spin beside it, and it is the last solve's.
"""

import math
import pathlib
import sys

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
from stones import xml  # noqa: E402

DENSITY, GRAVITY = 2000.0, 9.81
OWN = {"loads": {"weight": 1.0}}
SQUARE = (math.sqrt(2) + math.asinh(1)) / 6  # mean distance from the middle of a square, of its side


def scene(prism, loads=None, stages=None, friction=0.5, supports=None, modulus=10e9, **sections):
    tree = {"mesh": {"type": "prism", "prism": prism},
            "materials": {"stone": {"Young modulus": modulus, "Poisson ratio": 0.0, "density": DENSITY}},
            "joints": {"dry": {"friction coefficient": friction}}, "supports": supports or {"ground": {"on": "ground"}},
            "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, **(loads or {})}, "selection": {"mode": "all"},
            "steps": {"stages": stages or {"own weight": OWN}}, **{name.replace("_", " "): s for name, s in sections.items()}}
    return xml("prism", tree) + "\n"


def prism(length, width, height, cells=(2, 2, 2), stones=1, ground=0.2):
    return {"length": length, "width": width, "height": height, "stones": stones, "cells along": cells[0], "cells across": cells[1],
            "cells up": cells[2], "ground height": ground}


def sum_over_nodes(cells):
    """Mean distance from the middle of a square of side one, by areas of nodes."""
    weight = np.ones(cells + 1)
    weight[[0, -1]] = 0.5
    place = np.linspace(-0.5, 0.5, cells + 1)
    return (np.hypot(place[:, None], place[None, :]) * weight[:, None] * weight[None, :]).sum() / cells**2


class PrismInSpace(program.SceneTest):
    def test_a_joint_that_is_twisted(self):
        side, pressure, friction = 0.8, 2e5, 0.1
        supports = {"foot": {"on": "base"}, "head": {"on": "top", "components": "xy"}}
        loads = {"press": {"type": "traction", "on": "top", "pressure": pressure},
                 "turn": {"type": "settlement", "support": "head", "rotation": 1e-4}}
        stages = {"pressed": {"loads": {"press": 1.0}}, "turned": {"loads": {"press": 1.0, "turn": 1.0}}}
        run = self.run_scene(scene(prism(side, side, 1.0, (4, 4, 2), 2, 0.0), loads, stages, friction, supports))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        with h5py.File(run.folder / "fields.h5") as fields:
            step = fields["steps"][sorted(fields["steps"])[-1]]
            x, f = fields["joints/position"][:], step["joint_force_N"][:]
            self.assertEqual(set(step["joint_status"][:].reshape(-1)[np.hypot(*(x[:, :2] - side / 2).T) > 1e-9]), {2})
        x = x - side / 2
        moment = abs((x[:, 0] * f[:, 1] - x[:, 1] * f[:, 0]).sum()) / (friction * pressure * side**3)
        self.assertLess(abs(moment / sum_over_nodes(4) - 1), 0.005)
        self.assertLess(abs(moment / SQUARE - 1), 0.04)

    def test_slip_along_the_resultant_of_two_pushes(self):
        friction = 0.5
        loads = {"held": {"type": "acceleration", "ax": 0.6 * friction * GRAVITY}, "raised": {"type": "acceleration", "ay": friction * GRAVITY}}
        for share, outcome in ((0.799, "equilibrium"), (0.801, "collapse")):
            stages = {"own weight": OWN, "held": {"loads": {"weight": 1.0, "held": 1.0}},
                      "raised": {"loads": {"weight": 1.0, "held": 1.0, "raised": share}}}
            run = self.run_scene(scene(prism(1.0, 1.0, 0.4), loads, stages, friction), out=outcome)
            self.assertEqual(run.outcome, outcome, run.said)
        with h5py.File(run.folder / "fields.h5") as fields:
            motion = fields["steps"][sorted(fields["steps"])[-1]]["displacement"][:]
        way = motion[np.linalg.norm(motion, axis=1).argmax()]
        self.assertLess(np.abs(way / np.linalg.norm(way) - [0.6, 0.8, 0.0]).max(), 0.03)

    def test_a_slope_that_falls_along_no_axis(self):
        # Gravity is turned and not the drawing: its part along the slope grows evenly from nothing.
        friction, degrees, duration = 0.3, 30.0, 0.2
        down, along = GRAVITY * math.cos(math.radians(degrees)), GRAVITY * math.sin(math.radians(degrees))
        held = friction * down / along * duration
        speed = along * (duration**2 - held**2) / (2 * duration) - friction * down * (duration - held)
        for bearing in (17.0, 60.0):
            fall = np.array([math.cos(math.radians(bearing)), math.sin(math.radians(bearing))])
            loads = {"weight": {"type": "self weight", "gravity": down}, "pull": {"type": "acceleration", "ax": float(along * fall[0]), "ay": float(along * fall[1])}}
            stages = {"own weight": OWN, "pulled": {"duration": duration, "time step": 0.002, "loads": {"weight": 1.0, "pull": 1.0}}}
            run = self.run_scene(scene(prism(1.0, 1.0, 0.2, (2, 2, 1)), loads, stages, friction,
                                       observations={"stone": {"place": "mean", "blocks": "course 0"}}), out=str(bearing))
            self.assertEqual(run.outcome, "equilibrium", run.said)
            found = np.array([run.history[-1][f"v{c}_m_per_s of stone"] for c in "xy"])
            self.assertLess(np.linalg.norm(found - speed * fall), 0.01 * speed)

    def test_a_block_that_spins(self):
        side, friction, rate, duration = 1.0, 0.4, 1.0, 0.06
        stages = {"own weight": OWN, "spin": {"duration": duration, "time step": 0.001, "loads": {"weight": 1.0}}}
        corner = {"blocks": "course 0", "x": side, "y": side, "z": 0.2, "tolerance": 1e-6}
        run = self.run_scene(scene(prism(side, side, 0.2, (4, 4, 1)), {}, stages, friction, observations={"corner": corner},
                                   initial_velocities={"spin": {"blocks": "course 0", "rotation": rate}}))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        # Moment over inertia m a^2 / 6: of 0.3826 mu m g a.
        lost = 6 * sum_over_nodes(4) * friction * GRAVITY / side * duration
        left = run.history[-1]["vy_m_per_s of corner"] / (side / 2)
        self.assertLess(abs(left - (rate - lost)), 0.01 * lost)
        self.assertLess(abs(run.history[-1]["imbalance_in_time_J"]), 1e-8 * run.history[1]["kinetic_J"])

    def rock(self, bearing, corner, out):
        """A prism turns about a horizontal axis through a corner of its base, with its weight against it."""
        a, b, h, rate, duration = 0.6, 0.4, 1.6, 0.05, 0.02
        across = np.array([math.cos(math.radians(bearing)), math.sin(math.radians(bearing)), 0.0])
        axis = np.cross([0, 0, 1.0], across)  # what lies opposite rises
        foot, middle = np.array([*corner, 0]) * [a, b, 0.0], np.array([a, b, h]) / 2
        stages = {"own weight": OWN, "rocking": {"duration": duration, "time step": 0.0005, "loads": {"weight": 1.0}}}
        turn = {"blocks": "course 0", "rotation": rate, **{f"axis {c}": float(v) for c, v in zip("xyz", axis)},
                **{f"about {c}": float(v) for c, v in zip("xyz", foot)}}
        run = self.run_scene(scene(prism(a, b, h, (2, 2, 3)), {}, stages, 2.0, modulus=50e9, initial_velocities={"start": turn},
                                   observations={"stone": {"place": "mean", "blocks": "course 0"}}), out=out)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run, rate * axis, foot, middle, (a, b, h), duration

    def test_rocking_about_an_edge(self):
        run, rate, foot, middle, (a, _, h), duration = self.rock(0.0, (1, 0), "edge")
        arm = middle - foot
        slowed = GRAVITY * a / 2 / ((a**2 + h**2) / 3)  # m g a / 2 over m (a^2 + h^2) / 3
        angle = np.linalg.norm(rate) * duration - slowed * duration**2 / 2
        self.compare(run, angle * np.cross(rate / np.linalg.norm(rate), arm))

    def test_rocking_about_a_corner(self):
        run, rate, foot, middle, size, duration = self.rock(math.degrees(math.atan2(0.4, 0.6)), (1, 1), "corner")
        arm = middle - foot
        # Inertia about the corner, per mass: of a box about its middle, and of its middle about the corner.
        inertia = np.diag([sum(s**2 for s in size) - s**2 for s in size]) / 12 + np.dot(arm, arm) * np.eye(3) - np.outer(arm, arm)
        slowed = np.linalg.solve(inertia, np.cross(arm, [0, 0, -GRAVITY]))
        self.compare(run, np.cross(rate * duration + slowed * duration**2 / 2, arm))

    def compare(self, run, expected):
        found = np.array([run.history[-1][f"u{c}_m of stone"] - run.history[0][f"u{c}_m of stone"] for c in "xyz"])
        self.assertLess(np.linalg.norm(found - expected), 0.01 * np.linalg.norm(expected), f"{found} for {expected}")
        self.assertLess(abs(run.history[-1]["imbalance_in_time_J"]), 1e-8 * run.history[1]["kinetic_J"])


if __name__ == "__main__":
    program.main()

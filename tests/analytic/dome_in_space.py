"""A dome that is pushed sideways, by this program and by another linear programme of the same stones.

usage: dome_in_space.py PROGRAM MPIEXEC

Set-up    Half a sphere of mean radius R and thickness 0.08 R, of 16 lunes and 8 courses of equal angle between the
          springing and 5 degrees from the crown; joints above each other, friction 0.6, on a rigid bed. A stone is the
          hexahedron of its eight corners, which lie on spheres of radius R - t / 2 and R + t / 2: its weight and its middle
          are those of the hexahedron, its joints the plane quadrangles between four corners. Its weight is raised sideways,
          towards a meridian on which joints lie. The other programme is scipy's (HiGHS, an interior point method), with
          pyramids that nothing makes finer.
Expected  Pyramids of 12 lines within the cones bear 0.3647 to 0.3658, of 16 0.3669 to 0.3670; those of 16 faces around them
          0.3721 to 0.3722. Round cones bear 0.3694 to 0.3697, between pyramids of 32 lines and of 32 faces. Within 16 lines
          a dome that is pushed towards the middle of a lune bears 0.3662, one with the middle of a stone at the mean of its
          corners 0.3636, with the weights of stones between spheres 0.3560, with R at the intrados 0.3542.
Tolerance What is told by the other programme 2e-4, by which lines may be turned; where this program looks for forces and
          proofs a thousandth, to which it makes pyramids finer.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import numpy as np  # noqa: E402  (folders of their own)
import program  # noqa: E402
import scipy.sparse  # noqa: E402
from scipy.optimize import linprog  # noqa: E402
from stones import xml  # noqa: E402

LUNES, COURSES, OCULUS, THICKNESS, FRICTION = 16, 8, 5.0, 0.08, 0.6
RADIUS, DENSITY, GRAVITY = 5.0, 2000.0, 9.81
FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


class Dome:
    """Stones and joints by their corners; a joint has numbers of two stones, that of the bed is none."""

    def __init__(self, inside=1 - THICKNESS / 2, turned=0.0):
        self.inside, self.outside, self.turned = inside, inside + THICKNESS, turned
        self.stones, self.joints = [], []
        number = {}
        for k in range(COURSES):
            for j in range(LUNES):
                number[k, j] = len(self.stones)
                self.stones.append(np.array([self.at(side, k + up, j + round_) for up, round_, side in (
                    (0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0), (1, 0, 0), (1, 0, 1), (1, 1, 1), (1, 1, 0))]))
        for k in range(COURSES):
            for j in range(LUNES):
                x = self.stones[number[k, j]]
                self.joints.append((number.get((k - 1, j)), number[k, j], x[:4]))
                self.joints.append((number[k, (j - 1) % LUNES], number[k, j], x[[0, 1, 5, 4]]))

    def angles(self, course, lune):
        """From the crown, and about the axis."""
        from_crown = math.pi / 2 - (math.pi / 2 - math.radians(OCULUS)) * course / COURSES
        return from_crown, 2 * math.pi * (lune + self.turned) / LUNES

    def at(self, side, course, lune):
        p, a = self.angles(course, lune)
        r = self.outside if side else self.inside
        return np.array([r * math.sin(p) * math.cos(a), r * math.sin(p) * math.sin(a), r * math.cos(p)])

    def volumes_and_middles(self):
        return [of_hexahedron(x) for x in self.stones]

    def of_spheres(self):
        """Volume and middle of what lies between spheres, cones and meridian planes."""
        found = []
        for k in range(COURSES):
            for j in range(LUNES):
                (q, a), (p, b) = self.angles(k, j), self.angles(k + 1, j + 1)
                third, fourth = ((self.outside**n - self.inside**n) / n for n in (3, 4))
                volume = third * (math.cos(p) - math.cos(q)) * (b - a)
                square = (q - p) / 2 - (math.sin(2 * q) - math.sin(2 * p)) / 4
                height = (math.sin(q) ** 2 - math.sin(p) ** 2) / 2 * (b - a)
                found.append((volume, fourth / volume * np.array([square * (math.sin(b) - math.sin(a)),
                                                                 square * (math.cos(a) - math.cos(b)), height])))
        return found


def of_hexahedron(x):
    inside, volume, first = x.mean(axis=0), 0.0, np.zeros(3)
    for face in FACES:
        for b, c in ((1, 2), (2, 3)):
            p, q, r = (x[face[n]] - inside for n in (0, b, c))
            part = np.dot(p, np.cross(q, r)) / 6
            volume += part
            first += part / 4 * (p + q + r)
    return volume, inside + first / volume


def limit(dome, lines, around=False, half_turned=False, weights=None):
    """The largest factor that pyramids of so many lines bear."""
    weights = weights or dome.volumes_and_middles()
    unit = max(volume for volume, _ in weights)
    radius = FRICTION / math.cos(math.pi / lines) if around else FRICTION
    angles = 2 * math.pi * (np.arange(lines) + half_turned / 2) / lines
    rows, columns, values, count = [], [], [], 0
    for below, above, corners in dome.joints:
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal *= np.sign(np.dot(normal, weights[above][1] - corners.mean(axis=0))) / np.linalg.norm(normal)
        up = np.array([0.0, 0.0, 1.0]) if abs(normal[2]) < 0.9 else np.array([1.0, 0.0, 0.0])
        first = up - np.dot(up, normal) * normal
        first /= np.linalg.norm(first)
        second = np.cross(normal, first)
        forces = normal + radius * (np.outer(np.cos(angles), first) + np.outer(np.sin(angles), second))
        for place in corners:
            for stone, sign in ((above, 1), (below, -1)):
                if stone is None:
                    continue
                wrenches = sign * np.hstack([forces, np.cross(place - weights[stone][1], forces)])
                rows.append(np.tile(6 * stone + np.arange(6), lines))
                columns.append(np.repeat(count + np.arange(lines), 6))
                values.append(wrenches.ravel())
            count += lines
    size = 6 * len(weights)
    down, sideways = np.zeros(size), np.zeros(size)
    down[2::6] = sideways[::6] = [volume / unit for volume, _ in weights]
    joints = scipy.sparse.csc_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), (size, count))
    balance = scipy.sparse.hstack([joints, scipy.sparse.csc_matrix(sideways[:, None])]).tocsc()
    found = linprog(np.append(np.zeros(count), -1.0), A_eq=balance, b_eq=down, bounds=(0, None), method="highs-ipm")
    assert found.status == 0, found.message
    return -found.fun


class ADomePushedSideways(program.SceneTest):
    def between(self, found, least, most):
        self.assertGreaterEqual(found, least - 2e-4)
        self.assertLessEqual(found, most + 2e-4)

    def test_this_program_agrees_with_pyramids_of_many_lines(self):
        mesh = {"radius": RADIUS, "thickness": THICKNESS * RADIUS, "oculus": OCULUS, "springing": 90.0, "courses": COURSES,
                "lunes": LUNES, "bond": "stack", "faces": "plane", "cells radial": 1, "cells round": 1, "cells up": 1,
                "ground height": 0.3}
        tree = {"mesh": {"type": "dome", "dome": mesh},
                "materials": {"stone": {"Young modulus": 20e9, "Poisson ratio": 0.2, "density": DENSITY}},
                "joints": {"dry": {"friction coefficient": FRICTION}}, "supports": {"ground": {"on": "ground"}},
                "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, "push": {"type": "acceleration", "ax": GRAVITY}},
                "steps": {"stages": {"own weight": {"loads": {"weight": 1.0}}}},
                "load factor": {"pattern": {"push": 1.0}, "accuracy": 0.01}}
        run = self.run_scene(xml("dome", tree) + "\n", "--limit-analysis")
        self.assertEqual(run.code, 0, run.said)
        proven, borne = run.result["collapse"]["certified_upper"], run.result["rigid"]["forces_found_up_to"]
        self.between(proven, 0.3694, 0.3697)
        self.assertLessEqual(borne, proven)
        self.assertGreaterEqual(borne, proven * (1 - 1e-3))
        dome = Dome()
        least, most = limit(dome, 32), limit(dome, 32, around=True)
        self.assertLessEqual(most - least, 5e-3 * most)
        self.assertGreaterEqual(proven, least)
        self.assertLessEqual(borne, most)

    def test_coarse_pyramids_bear_less_within_and_more_around(self):
        dome = Dome()
        self.between(limit(dome, 12), 0.3658, 0.3658)
        self.between(limit(dome, 12, half_turned=True), 0.3647, 0.3647)
        self.between(limit(dome, 16, half_turned=True), 0.3669, 0.3669)
        self.between(limit(dome, 16, half_turned=True, around=True), 0.3721, 0.3721)

    def test_other_stones_bear_other_loads(self):
        dome = Dome()
        means = [(volume, x.mean(axis=0)) for (volume, _), x in zip(dome.volumes_and_middles(), dome.stones)]
        self.between(limit(Dome(turned=0.5), 16, half_turned=True), 0.3662, 0.3662)
        self.between(limit(dome, 16, weights=means, half_turned=True), 0.3636, 0.3636)
        self.between(limit(dome, 16, weights=dome.of_spheres(), half_turned=True), 0.3560, 0.3560)
        self.between(limit(Dome(inside=1.0), 16, half_turned=True), 0.3542, 0.3542)


if __name__ == "__main__":
    program.main()

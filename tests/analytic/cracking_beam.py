"""A prism with a joint at midspan, bent at three points until it parts, beside a solution of its own.

usage: cracking_beam.py PROGRAM MPIEXEC

Set-up    Two halves of a prism, 0.4 m x 0.1 m, 0.1 m thick, meet at midspan in a joint of tension strength T = 0.5 MPa that
          takes G = 20 J/m2. Their ends lean on rigid bearings through mortar that is stiff upwards and soft along the prism.
          The uppermost 10 mm of midspan go down, free to move along: from ways that keep the joint whole, past the largest
          force, to ways at which 2 % of that is left. E G / T^2 = 1.6 m is sixteen times the depth, so nothing snaps back.
Expected  The halves mirror each other, so one is solved here, with the same cells: plane stress, quadrilaterals of four
          nodes, dense matrices, condensed to the nodes at midspan. At a node of share w that has opened by g the joint pulls
          with T w (1 - T g / 2 G), or not at all beyond 2 G / T; the others are closed. For given sets of these it is a
          linear system. The sets are found by going down in small steps, and every solution is held to the law. Nothing of
          the program is used.
Tolerance Both solve the same equations, the program to 1e-10 of its largest force: openings, pulls and the force agree to
          1e-6 of their largest, in eighteen load steps and in a single one. Mesh: error falls faster than the size of cells.
"""

import sys
import unittest

import numpy as np

from cracked_joints import Programs, run, scenes
from drawing import Drawing

LENGTH, DEPTH, THICK, PLATEN = 0.2, 0.1, 0.1, 0.01  # [m] half of the prism; what goes down of midspan
MODULUS, POISSON, TENSION, ENERGY = 20e9, 0.2, 0.5e6, 20.0  # [Pa, -, Pa, J/m2]
BEARING = 1e6, 1e12  # [Pa/m] along the prism and upwards
WAYS = np.array([2, 4, 6, 8, 10, 12, 15, 18, 22, 28, 36, 46, 60, 75, 90, 130, 200, 400]) * 1e-6  # [m] down


def cell_stiffness(a, b):
    """Of a rectangle a x b in plane stress [N/m]; nodes counter-clockwise from the lower left."""
    law = MODULUS / (1 - POISSON**2) * np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, (1 - POISSON) / 2]])
    corner = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    stiffness = np.zeros((8, 8))
    for place in np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) / np.sqrt(3):
        dx = corner[:, 0] * (1 + corner[:, 1] * place[1]) / 4 * 2 / a
        dy = corner[:, 1] * (1 + corner[:, 0] * place[0]) / 4 * 2 / b
        strain = np.zeros((3, 8))
        strain[0, ::2] = strain[2, 1::2] = dx
        strain[1, 1::2] = strain[2, ::2] = dy
        stiffness += strain.T @ law @ strain * a * b / 4 * THICK
    return stiffness


class Half:
    """The left half, -LENGTH < x < 0: what its nodes at midspan and its bearing feel of a way down and of gaps at midspan."""

    def __init__(self, cells):
        size = DEPTH / cells
        along, up = round(LENGTH / size), cells
        node = np.arange((along + 1) * (up + 1)).reshape(up + 1, along + 1)
        whole = np.zeros((2 * node.size,) * 2)
        small = cell_stiffness(size, size)
        for j in range(up):
            for i in range(along):
                dofs = np.repeat(2 * np.array([node[j, i], node[j, i + 1], node[j + 1, i + 1], node[j + 1, i]]), 2)
                dofs[1::2] += 1
                whole[np.ix_(dofs, dofs)] += small
        platen = node[up - round(PLATEN / size):, -1]
        face = 2 * node[:, -1]
        held = 2 * platen + 1
        share = np.full(up + 1, size * THICK)
        share[[0, -1]] /= 2
        end = 2 * node[:, 0]
        whole[end, end] += BEARING[0] * share
        whole[end + 1, end + 1] += BEARING[1] * share
        free = np.setdiff1d(np.arange(2 * node.size), np.concatenate([held, face]))
        # A way down of 1 m, then motions of the face by 1 m, node by node.
        moved = np.zeros((2 * node.size, 1 + face.size))
        moved[2 * platen + 1, 0] = -1
        moved[face, np.arange(1, 1 + face.size)] = 1
        moved[free] = -np.linalg.solve(whole[np.ix_(free, free)], (whole @ moved)[free])
        forces = whole @ moved
        self.stiffness, self.by_way = forces[face, 1:], forces[face, 0]
        bearing = -BEARING[1] * share @ moved[end + 1]
        self.bearing_by_face, self.bearing_by_way = bearing[1:], bearing[0]
        self.share = share

    def opened(self, way, gap):
        """Gaps at midspan and pulls there [m, N] for a way down, from the gaps of one that is a little less."""
        force, slope = TENSION * self.share, TENSION**2 / (2 * ENERGY) * self.share
        parted, cracked = gap >= 2 * ENERGY / TENSION, gap > 0
        for _ in range(100):
            # The face moves by -gap / 2 and is pulled by T w - slope gap where it has cracked.
            soft = cracked & ~parted
            system = -self.stiffness / 2 + np.diag(slope * soft)
            found = np.zeros_like(gap)
            found[cracked] = np.linalg.solve(system[np.ix_(cracked, cracked)],
                                             (force * soft - self.by_way * way)[cracked])
            pull = -self.stiffness @ found / 2 + self.by_way * way
            now_cracked, now_parted = (cracked & (found > 0)) | (~cracked & (pull > force)), found >= 2 * ENERGY / TENSION
            if (now_cracked == cracked).all() and (now_parted == parted).all():
                law = np.where(cracked, np.maximum(force - slope * found, 0), np.minimum(pull, force))
                assert np.abs(pull - law).max() < 1e-9 * force.max()
                return found, pull
            cracked, parted = now_cracked, now_parted
        raise AssertionError("no set of open nodes is consistent")

    def bent(self, ways):
        """Gaps [m] and pull of the joint [Pa] node by node from below, and the force that goes down [N], for each way."""
        gap, gaps, pulls, forces = np.zeros_like(self.share), [], [], []
        last = 0.0
        for way in ways:
            for between in np.linspace(last, way, 68)[1:]:
                before = gap
                gap, pull = self.opened(between, gap)
                assert (gap >= before * (1 - 1e-9)).all()  # no node comes back, so the law needs no memory
            last = way
            gaps.append(gap)
            pulls.append(pull / self.share)
            forces.append(2 * (self.bearing_by_way * way - self.bearing_by_face @ gap / 2))
        return np.array(gaps), np.array(pulls), np.array(forces)


def prism(name, cells, ways):
    """Steps of a run, and which of its points are at midspan, from below; the force that goes down [N] after every step."""
    drawing = Drawing(DEPTH / cells)
    for side in (-1, 1):
        left, right = sorted([0, side * LENGTH])
        middle = [(0, -PLATEN)]  # the platen begins there
        corners = [(left, -DEPTH), (right, -DEPTH), *middle[side > 0:], (right, 0), (left, 0), *middle[side < 0:]]
        drawing.stone(corners, corners=(0, 1, 3, 4) if side < 0 else (0, 1, 2, 3), sets=("prism",))
        drawing.box(side * (LENGTH + DEPTH / 2) - DEPTH / 2, -DEPTH, DEPTH, DEPTH, sets=("bearing",),
                    **{"right" if side < 0 else "left": "ends"})
    drawing.name("platen", (0, -PLATEN), (0, 0))
    scene = scenes.scene(
        drawing, supports={"ends": {"on": "ends", "blocks": "bearing"},
                           "platen": {"on": "platen", "components": "y", "blocks": "all"}},
        loads={"down": {"type": "settlement", "support": "platen", "uy": -1.0}},
        stages={f"down {k}": {"loads": {"weight": 0.0, "down": float(way)}}
                for k, way in enumerate(ways)},
        stone={"Young modulus": MODULUS, "Poisson ratio": POISSON}, model={"thickness": THICK},
        newton={"tolerance": 1e-10})
    scene["joints"] = {
        "mortar": {"friction coefficient": 0.6, "tension strength": TENSION, "cohesion": 2 * TENSION,
                   "fracture energy": ENERGY, "shear fracture energy": 10 * ENERGY},
        "bearings": {"between": "prism", "and": "bearing", "tension strength": np.inf, "cohesion": np.inf,
                     "normal stiffness": BEARING[0], "tangential stiffness": BEARING[1]}}
    scene["steps"].pop("expect collapse")
    result, steps = run(f"cracking_beam/{name}", scene)
    midspan = np.abs(steps.position[:, 0]) < 1e-9
    force = np.abs(steps.shear[:, ~midspan]) @ steps.area[~midspan]
    print(f"{name}: {force[-1]:.4f} N, {result['linear_solves']} solves, fracture {result['energy']['fracture_J']:.6g} J")
    order = np.argsort(np.where(midspan, steps.position[:, 1], np.inf))[:midspan.sum()]
    return steps, order, force


class CrackingBeam(unittest.TestCase):
    def test_openings_pulls_and_force_are_those_of_the_other_solution(self):
        for cells in (10, 20):
            gaps, pulls, forces = Half(cells).bent(WAYS)
            self.assertGreater(np.argmax(forces), 4)
            self.assertLess(forces[-1], 0.02 * forces.max())
            steps, midspan, force = prism(f"steps {cells}", cells, WAYS)
            np.testing.assert_allclose(np.maximum(steps.gap[:, midspan], 0), gaps, atol=1e-6 * gaps.max())
            np.testing.assert_allclose(-steps.pressure[:, midspan], pulls, atol=1e-6 * TENSION)
            np.testing.assert_allclose(force, forces, atol=1e-6 * forces.max())
            for k in (1, 4, 8, 12):
                *_, force = prism(f"at once {cells} {k}", cells, WAYS[k:k + 1])
                np.testing.assert_allclose(force, forces[k], atol=1e-6 * forces.max())

    def test_finer_cells_come_to_a_limit(self):
        forces = [Half(cells).bent(WAYS[:10])[2] for cells in (10, 20, 40)]
        coarse, fine = (np.abs(f - forces[-1]).max() for f in forces[:-1])
        self.assertLess(fine, 0.5 * coarse)
        self.assertLess(fine, 0.02 * forces[-1].max())


if __name__ == "__main__":
    Programs.take(sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

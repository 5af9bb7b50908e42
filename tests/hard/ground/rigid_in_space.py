"""The largest load factor of rigid convex stones in space, by a linear programme of its own (scipy's HiGHS).

Joints are where faces of two stones lie on each other, without tension, with Coulomb's friction as associated flow: in
every corner of a joint a pyramid within the cone, or one around it, so that the factor is enclosed.
"""

import itertools
import math

import numpy
from scipy.optimize import linprog
from scipy.sparse import coo_matrix

FLAT = 1e-9  # of the size of the structure: places that are the same


def cross(a, b):
    return numpy.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def area_vector(points):
    return sum((cross(a - points[0], b - points[0]) for a, b in zip(points[1:], points[2:])), numpy.zeros(3)) / 2


def centre_of_face(points):
    parts = [((points[0] + a + b) / 3, numpy.linalg.norm(cross(a - points[0], b - points[0])))
             for a, b in zip(points[1:], points[2:])]
    return sum(at * size for at, size in parts) / sum(size for _, size in parts)


def centre_and_volume(stone):
    """Of a closed surface, from a place within it."""
    points, faces = stone
    points = numpy.array(points)
    middle, total, moment = points.mean(axis=0), 0.0, numpy.zeros(3)
    for face in faces:
        for k in range(1, len(face) - 1):
            corners = points[[face[0], face[k], face[k + 1]]] - middle
            volume = corners[0] @ cross(corners[1], corners[2]) / 6
            total += volume
            moment += volume * corners.sum(axis=0) / 4
    return middle + moment / total, total


def common(face, other, normal, short):
    """The part of a convex face within another in the same plane, whose corners go the other way round."""
    for a, b in zip(other, numpy.roll(other, 1, axis=0)):
        inward = cross(normal, b - a)
        inward = inward / numpy.linalg.norm(inward)
        depth = [float((p - a) @ inward) for p in face]
        kept = []
        for k, (p, d) in enumerate(zip(face, depth)):
            q, e = face[k - 1], depth[k - 1]
            if min(d, e) < -short and max(d, e) > short:
                kept.append(q + (p - q) * e / (e - d))
            if d >= -short:
                kept.append(p)
        face = [p for k, p in enumerate(kept) if numpy.linalg.norm(p - kept[k - 1]) > short]
        if len(face) < 3:
            return []
    return face


class RigidStonesInSpace:
    """Stones by name: convex, points and faces, counter-clockwise from outside. Held ones do not move."""

    def __init__(self, stones, held, friction):
        self.stones, self.held, self.friction = stones, held, friction
        self.free = {name: 6 * k for k, name in enumerate(n for n in stones if n not in held)}
        self.middle = {name: centre_and_volume(stone)[0] for name, stone in stones.items()}
        every = numpy.array([p for points, _ in stones.values() for p in points])
        self.size = float(numpy.ptp(every, axis=0).max())
        self.joints = []  # (stone, other, corners, normal from the stone to the other)
        boxes = {name: (numpy.min(points, axis=0), numpy.max(points, axis=0)) for name, (points, _) in stones.items()}
        for one, other in itertools.combinations(stones, 2):
            low = numpy.maximum(boxes[one][0], boxes[other][0])
            if (low < numpy.minimum(boxes[one][1], boxes[other][1]) + FLAT * self.size).all():
                self.join(one, other)

    def join(self, one, other):
        short = FLAT * self.size
        faces = {name: [numpy.array([self.stones[name][0][k] for k in face]) for face in self.stones[name][1]]
                 for name in (one, other)}
        for mine, theirs in itertools.product(faces[one], faces[other]):
            normal = area_vector(mine)
            normal = normal / numpy.linalg.norm(normal)
            if max(abs((theirs - mine[0]) @ normal)) > short or area_vector(theirs) @ normal > 0:
                continue
            corners = common(list(mine), theirs, normal, short)
            if len(corners) >= 3 and numpy.linalg.norm(area_vector(corners)) > short * self.size:
                self.joints.append((one, other, corners, normal))

    def largest_factor(self, fixed, raised, largest, lines, around):
        """None where the fixed forces alone cannot be balanced. Forces are lists of (stone, place, force).

        lines: of the pyramids that stand for the cones; around: they lie around the cones, else within them.
        """
        rows, columns, values = [], [], []
        count = 0

        def column(stone, other, place, force):
            nonlocal count
            for name, sign in ((stone, -1.0), (other, 1.0)):
                if name in self.free:
                    wrench = [*force, *(cross(place - self.middle[name], force) / self.size)]
                    rows.extend(self.free[name] + c for c in range(6))
                    columns.extend([count] * 6)
                    values.extend(sign * w for w in wrench)
            count += 1

        wide = self.friction / (math.cos(math.pi / lines) if around else 1.0)
        for one, other, corners, normal in self.joints:
            first = corners[1] - corners[0]
            first = first / numpy.linalg.norm(first)
            second = cross(normal, first)
            for place in corners:
                for k in range(lines if self.friction > 0 else 1):
                    angle = 2 * math.pi * k / lines
                    column(one, other, place, normal + wide * (math.cos(angle) * first + math.sin(angle) * second))
        size = 6 * len(self.free)
        pattern, constant = self.sums(raised), self.sums(fixed)
        unit = max(abs(pattern).max(), abs(constant).max())
        rows.extend(range(size))
        columns.extend([count] * size)
        values.extend(pattern / unit)
        equal = coo_matrix((values, (rows, columns)), shape=(size, count + 1))
        cost = numpy.zeros(count + 1)
        cost[-1] = -1.0
        # What is balanced to the tolerance of the programme alone must not pass for borne.
        options = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
        found = linprog(cost, A_eq=equal, b_eq=-constant / unit, bounds=[(0, None)] * count + [(0, largest)],
                        method="highs", options=options)
        if found.status == 2:
            return None
        if found.status != 0:
            raise RuntimeError(found.message)
        return found.x[-1]

    def sums(self, forces):
        result = numpy.zeros(6 * len(self.free))
        for name, place, force in forces:
            if name in self.free:
                k = self.free[name]
                result[k:k + 3] += force
                result[k + 3:k + 6] += cross(numpy.array(place) - self.middle[name], force) / self.size
        return result

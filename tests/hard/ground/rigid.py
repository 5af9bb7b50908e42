"""The largest load factor of rigid stones as drawn, by a linear programme of its own (scipy's HiGHS).

Stones are polygons; sides of equal ends are joints without tension, with Coulomb's friction as associated flow.
"""

import numpy
from scipy.optimize import linprog
from scipy.sparse import coo_matrix


def centre_and_area(points):
    x, y = (numpy.array(v) for v in zip(*points))
    x0, y0 = x[0], y[0]
    x, y = x - x0, y - y0
    cross = x * numpy.roll(y, -1) - numpy.roll(x, -1) * y
    area = float(cross.sum() / 2)
    cx = float(((x + numpy.roll(x, -1)) * cross).sum() / (6 * area))
    cy = float(((y + numpy.roll(y, -1)) * cross).sum() / (6 * area))
    return (cx + x0, cy + y0), area


class RigidStones:
    """Polygons, which of their sides are held, and forces on them: lists of (stone, place, force)."""

    def __init__(self, stones, held, friction):
        self.stones, self.friction = stones, friction
        self.middle = [centre_and_area(points)[0] for points in stones]
        self.entries, self.columns = [], 0  # (row, column, value)
        self.bounds, self.less = [], []
        sides = {}
        for number, points in enumerate(stones):
            for a, b in zip(points, points[1:] + points[:1]):
                if (b, a) in sides:
                    self.joint(sides[b, a], number, b, a)
                sides[a, b] = number
        for a, b in held:
            stone = sides[a, b] if (a, b) in sides else sides[b, a]
            for place in (a, b):
                for force in ((1.0, 0.0), (0.0, 1.0)):
                    self.column([(stone, place, force)], (None, None))

    def wrench(self, stone, place, force):
        x, y = place[0] - self.middle[stone][0], place[1] - self.middle[stone][1]
        return [force[0], force[1], x * force[1] - y * force[0]]

    def column(self, forces, bounds):
        for stone, place, force in forces:
            for c, value in enumerate(self.wrench(stone, place, force)):
                self.entries.append((3 * stone + c, self.columns, value))
        self.bounds.append(bounds)
        self.columns += 1

    def joint(self, i, j, a, b):
        """a to b along stone i, which lies to the left."""
        length = ((b[0] - a[0])**2 + (b[1] - a[1])**2)**0.5
        along = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
        for place in (a, b):
            for force, bounds in (((along[1], -along[0]), (0, None)), (along, (None, None))):
                self.column([(j, place, force), (i, place, (-force[0], -force[1]))], bounds)
            self.less.append((self.columns - 2, self.columns - 1))

    def sums(self, forces):
        result = numpy.zeros(3 * len(self.stones))
        for stone, place, force in forces:
            result[3 * stone:3 * stone + 3] += self.wrench(stone, place, force)
        return result

    def largest_factor(self, fixed, raised, largest):
        """None where the fixed forces alone cannot be balanced."""
        unit = max(abs(self.sums(fixed)).max(), abs(self.sums(raised)).max())
        rows, columns, values = (list(v) for v in zip(*self.entries))
        for row, value in enumerate(self.sums(raised) / unit):
            if value != 0:
                rows.append(row)
                columns.append(self.columns)
                values.append(value)
        equal = coo_matrix((values, (rows, columns)), shape=(3 * len(self.stones), self.columns + 1))
        rows, columns, values = [], [], []
        for normal, shear in self.less:
            for sign in (1.0, -1.0):
                row = rows[-1] + 1 if rows else 0
                rows += [row, row]
                columns += [normal, shear]
                values += [-self.friction, sign]
        less = coo_matrix((values, (rows, columns)), shape=(2 * len(self.less), self.columns + 1))
        cost = numpy.zeros(self.columns + 1)
        cost[-1] = -1.0
        # What is balanced to the tolerance of the programme alone must not pass for borne.
        options = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
        found = linprog(cost, A_ub=less, b_ub=numpy.zeros(2 * len(self.less)), A_eq=equal,
                        b_eq=-self.sums(fixed) / unit, bounds=self.bounds + [(0, largest)], method="highs",
                        options=options)
        if found.status == 2:
            return None
        if found.status != 0:
            raise RuntimeError(found.message)
        return found.x[-1]

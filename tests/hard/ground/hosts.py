"""Random masonry that stands by itself: what stones are planted in.

A host is drawn with further corners on two of its faces, one that looks down and one that looks up, so that stones fit there.
"""

import math

from drawing import Drawing

MARGIN = 0.1  # [m] between an end of a face and what is planted there
SLOPE = 0.35  # at most, of a face that looks down: a prop of friction 0.7 holds what stands on it


class Face:
    """A part of a side: u [m] along it from left to right, v [m] away from the stone."""

    def __init__(self, a, b, margin, down):
        length = math.dist(a, b)
        self.along = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
        self.out = (self.along[1], -self.along[0]) if down else (-self.along[1], self.along[0])
        self.origin = (a[0] + margin * self.along[0], a[1] + margin * self.along[1])

    def at(self, u, v=0.0):
        return tuple(o + u * t + v * n for o, t, n in zip(self.origin, self.along, self.out))

    def corners(self, us):
        return [self.at(u) for u in us]


class Host:
    """The stones, their area, and the largest stone that may be planted."""

    push = (0.1, 0.3)  # [g] to the right, that it bears when it is drawn to be pushed

    def __init__(self, random_numbers):
        self.random = random_numbers
        self.drawing = Drawing(random_numbers.choice([0.25, 0.5]), cells="triangle")
        self.area = 0.0

    def stone(self, points, sets=("host",)):
        """Adds a stone; its area."""
        rounded = [rounded_off(p) for p in points]
        area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(rounded, rounded[1:] + rounded[:1])) / 2
        if sets == ("host",):
            self.area += area
        self.drawing.stone(rounded, corners=(), sets=sets)
        return area

    def ground(self, a, b):
        self.drawing.name("ground", rounded_off(a), rounded_off(b))

    def courses(self, levels, joints, corners):
        """Courses on each other: their levels, the ends of the stones of each, further corners by the number of a level."""
        ends = [[round(x, 9) for x in course] for course in joints]
        for j, course in enumerate(ends):
            low, high = (sorted({round(x, 9) for x in (*(ends[n - 1] if n else ()), *corners.get(n, ()), *course,
                                                       *(ends[n] if n < len(ends) else ()))}) for n in (j, j + 1))
            for a, b in zip(course, course[1:]):
                self.stone([(x, levels[j]) for x in low if a <= x <= b] +
                           [(x, levels[j + 1]) for x in reversed(high) if a <= x <= b])

    def on_ground(self, ends):
        for a, b in zip(ends, ends[1:]):
            self.ground((a, 0.0), (b, 0.0))

    def ring(self, inner, outer, looks_down=None, looks_up=None):
        """Voussoirs between corners of two polygons; looks_*: number of a voussoir and corners on its side."""
        for k in range(len(inner) - 1):
            below, above = (side[1] if side and side[0] == k else [] for side in (looks_down, looks_up))
            self.stone([inner[k], *below, inner[k + 1], outer[k + 1], *reversed(above), outer[k]])


def rounded_off(point):
    return tuple(round(x, 9) for x in point)


def polygon(centre, radius, half_angle, count):
    """Corners of so many chords of an arc, from left to right."""
    angles = [half_angle * (2 * k / count - 1) for k in range(count + 1)]
    return [(centre[0] + radius * math.sin(a), centre[1] + radius * math.cos(a)) for a in angles]


class Slab(Host):
    """Columns of stones without bond, and on them a slab that overhangs on the right."""

    def __init__(self, random_numbers, pushed, columns=1):
        super().__init__(random_numbers)
        r = random_numbers
        self.columns, self.width = columns, r.uniform(0.8, 2.0)
        # The slab overhangs by half a stone at most: it stands on the last column alone.
        self.size = r.uniform(0.05, (self.width / 2 - MARGIN) / 3)
        self.height, self.thickness = r.uniform(0.4, 1.0), r.uniform(0.4, 1.0)
        self.rows = r.randint(1 if columns == 1 else 2, 5)
        while pushed and self.rows * self.height + self.thickness > 1.5 * self.width:
            self.rows, self.height, self.thickness = max(1, self.rows - 1), 0.9 * self.height, 0.9 * self.thickness

    def draw(self, below, above):
        xs = [self.width * k for k in range(self.columns + 1)]
        ys = [self.height * k for k in range(self.rows + 1)]
        ys.append(ys[-1] + self.thickness)
        end = xs[-1] + MARGIN + 3 * self.size
        low = Face((xs[-1], ys[-2]), (end, ys[-2]), MARGIN, down=True)
        high = Face((0.0, ys[-1]), (end, ys[-1]), MARGIN, down=False)
        self.courses(ys, [xs] * self.rows + [[0.0, end]],
                     {self.rows: [x for x, _ in low.corners(below)], self.rows + 1: [x for x, _ in high.corners(above)]})
        self.on_ground(xs)
        return low, high


class Pier(Slab):
    """One column."""


class Wall(Slab):
    """Columns beside each other."""

    def __init__(self, random_numbers, pushed):
        super().__init__(random_numbers, pushed, random_numbers.randint(2, 5))


class BondedWall(Host):
    """A wall in running bond: courses are set off by half a stone, and the last stone of the highest is longer."""

    def __init__(self, random_numbers, pushed):
        super().__init__(random_numbers)
        r = random_numbers
        self.stones, self.rows = r.randint(2, 4), r.randint(2, 5)
        self.width = r.uniform(0.7, 1.3)
        self.height = self.width * r.uniform(0.3, 0.5 if pushed else 0.8)
        if pushed:
            self.rows = min(self.rows, 2 * self.stones - 1)
        self.size = r.uniform(0.05, (0.6 * self.width - MARGIN) / 3)

    def draw(self, below, above):
        w, whole = self.width, [self.width * k for k in range(self.stones + 1)]
        half = [0.0, *(x + w / 2 for x in whole[:-1]), whole[-1]]
        joints = [half if (self.rows - 1 - j) % 2 else whole for j in range(self.rows)]
        end = whole[-1] + MARGIN + 3 * self.size
        joints[-1] = [*whole[:-1], end]
        ys = [self.height * j for j in range(self.rows + 1)]
        low = Face((whole[-1], ys[-2]), (end, ys[-2]), MARGIN, down=True)
        high = Face((0.0, ys[-1]), (w, ys[-1]), MARGIN, down=False)
        self.courses(ys, joints, {self.rows - 1: [x for x, _ in low.corners(below)],
                                  self.rows: [x for x, _ in high.corners(above)]})
        self.on_ground(joints[0])
        return low, high


class Arch(Host):
    """Half a ring of voussoirs; stones are planted below and on its keystone."""

    def __init__(self, random_numbers, pushed):
        super().__init__(random_numbers)
        r = random_numbers
        self.count, self.radius = 2 * r.randint(3, 6) + 1, r.uniform(2.0, 4.0)
        self.thickness = self.radius * (r.uniform(0.25, 0.35) if pushed else r.uniform(0.14, 0.35))
        self.size = r.uniform(0.05, 0.1)  # three of them fit on the smallest keystone

    def draw(self, below, above):
        inner, outer = (polygon((0.0, 0.5), self.radius + t, math.pi / 2, self.count) for t in (0.0, self.thickness))
        crown = self.count // 2
        margin = (inner[crown + 1][0] - inner[crown][0]) / 8
        low = Face(inner[crown], inner[crown + 1], margin, down=True)
        high = Face(outer[crown], outer[crown + 1], margin, down=False)
        self.ring(inner, outer, (crown, low.corners(below)), (crown, high.corners(above)))
        self.ground(outer[0], inner[0])
        self.ground(inner[-1], outer[-1])
        return low, high


class Bridge(Host):
    """One or two rings on piers, backing that is cut to their backs, courses in bond above.

    A stone of the backing stands on one voussoir or on two. Stones hang from a voussoir near a crown.
    """

    def __init__(self, random_numbers, pushed):
        super().__init__(random_numbers)
        r = random_numbers
        self.spans = r.randint(1, 2)
        self.count = r.choice([7, 9, 11] if self.spans == 1 else [5, 7])
        self.half_angle, self.radius = math.radians(r.uniform(50, 75)), r.uniform(1.5, 2.5)
        self.thickness = self.radius * r.uniform(0.18, 0.28)
        self.pier = r.uniform(0.3, 0.5) * self.radius  # its height
        self.widths = [r.uniform(0.9, 1.2) * self.radius if k in (0, self.spans) else
                       2 * self.thickness + r.uniform(0.3, 0.6) * self.radius for k in range(self.spans + 1)]
        self.grouped = r.randint(1, 2)  # voussoirs below a stone of the backing
        self.heights = [r.uniform(0.25, 0.4) for _ in range(r.randint(1, 3 - self.spans))]  # of courses
        self.cover = r.uniform(0.15, 0.3)  # of the crown, below the courses
        chord = 2 * self.radius * math.sin(self.half_angle / self.count)
        self.size = r.uniform(0.05, min(0.3, chord / 3))

    def draw(self, below, above):
        r, count, alpha = self.random, self.count, self.half_angle
        rings, x = [], self.widths[0]
        for width in self.widths[1:]:
            centre = (x + self.radius * math.sin(alpha), self.pier - self.radius * math.cos(alpha))
            rings.append([polygon(centre, self.radius + t, alpha, count) for t in (0.0, self.thickness)])
            x += 2 * self.radius * math.sin(alpha) + width
        outer = rings[0][1]
        top = outer[count // 2][1] + self.cover
        backs = self.backing(rings, x)
        # Joints of the lowest course are in the middle of stones below, of the others in the middle of that course's.
        ends, joints = [back[0][0] for back in backs] + [x], []
        for n in range(len(self.heights)):
            middles = [(a + b) / 2 for a, b in zip(ends, ends[1:])]
            ends = [0.0, *(middles[1:-1:2] if n == 0 and self.grouped == 1 else middles[1:-1]), x]
            joints.append(ends)
        a, b = r.choice([pair for pair in zip(ends, ends[1:]) if pair[1] - pair[0] > 3 * self.size + 2 * MARGIN])
        levels = [top]
        for height in self.heights:
            levels.append(levels[-1] + height)
        high = Face((a, levels[-1]), (b, levels[-1]), MARGIN, down=False)
        self.courses(levels, joints, {0: [back[0][0] for back in backs],
                                      len(joints): [p[0] for p in high.corners(above)]})
        for back in backs:
            a, b = back[0][0], back[-1][0]
            self.stone([*back, *((x, top) for x in [b, *(y for y in reversed(joints[0]) if a < y < b), a])])
        return self.hang(rings, below), high

    def hang(self, rings, below):
        """Draws the rings."""
        r, crown = self.random, self.count // 2
        near = [k for k in range(crown - 1, crown + 2)
                if abs(math.tan(2 * self.half_angle / self.count * (k - crown))) < SLOPE]
        chosen, k = r.randrange(self.spans), r.choice(near)
        for number, (inner, outer) in enumerate(rings):
            if number == chosen:
                low = Face(inner[k], inner[k + 1], MARGIN, down=True)
            self.ring(inner, outer, (k, low.corners(below)) if number == chosen else None)
        return low

    def backing(self, rings, end):
        """Draws piers with the stones that the rings lean on; the lower sides of the stones of the backing."""
        backs, left = [], 0.0
        for k, width in enumerate(self.widths):
            before, after = (rings[k - 1] if k else None), (rings[k] if k < self.spans else None)
            right = left + width
            # The stone that rings lean on, from its left end to its right one.
            ends = [(0.0, self.pier), (end, self.pier)]
            lean_left = [before[0][-1], before[1][-1]] if before else [(left, self.pier), None]
            lean_right = [after[0][0], after[1][0]] if after else [(right, self.pier), None]
            height = (before or after)[1][0][1]
            upper_left = lean_left[1] or (0.0, height)
            upper_right = lean_right[1] or (end, height)
            self.stone([(left, 0.0), (right, 0.0), lean_right[0], lean_left[0]])
            self.ground((left, 0.0), (right, 0.0))
            self.stone([lean_left[0], lean_right[0], upper_right, upper_left])
            backs.append([upper_left, upper_right])
            if after:
                outer = after[1]
                cuts = list(range(0, self.count, self.grouped)) + [self.count]
                backs += [outer[a:b + 1] for a, b in zip(cuts, cuts[1:])]
                left = right + 2 * self.radius * math.sin(self.half_angle)
        return backs


KINDS = {"pier": Pier, "wall": Wall, "bonded wall": BondedWall, "arch": Arch, "bridge": Bridge}

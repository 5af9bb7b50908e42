"""Stones in space drawn from a few numbers, and written as a file of them, for tests of the whole program.

    obj(stones)   the text of an .obj file, stones by name
    drawn(stones, ...)   the same with the stones turned, moved, in another unit, with another axis upwards, in any order
"""

import math

MOVED = (3.0, -2.0, 0.0)  # [m] of drawn()


def box(low, high):
    """A stone as points and faces, counter-clockwise from outside."""
    points = [tuple(high[c] if corner >> c & 1 else low[c] for c in range(3)) for corner in range(8)]
    return points, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def prism(outline, low, high):
    """An outline in x and z, counter-clockwise seen from the front, from y = low to y = high."""
    n = len(outline)
    points = [(x, y, z) for y in (low, high) for x, z in outline]
    sides = [((k + 1) % n, k, n + k, n + (k + 1) % n) for k in range(n)]
    return points, [tuple(range(n)), tuple(range(2 * n - 1, n - 1, -1)), *sides]


def arch(radius, thickness, width, voussoirs, embrace=180.0):
    """Stones of a circular arch across x, its middle line of that radius."""
    start, step = math.radians((180 - embrace) / 2), math.radians(embrace / voussoirs)
    stones = {}
    for k in range(voussoirs):
        a, b = start + k * step, start + (k + 1) * step
        inner, outer = radius - thickness / 2, radius + thickness / 2
        outline = [(r * math.cos(t), r * math.sin(t)) for r, t in ((inner, a), (outer, a), (outer, b), (inner, b))]
        stones[f"voussoir {k}"] = prism(outline, 0.0, width)
    return stones


def obj(stones):
    text, first = [], 1
    for name, (points, faces) in stones.items():
        text.append(f"o {name}")
        text += ["v " + " ".join(repr(float(c)) for c in p) for p in points]
        text += ["f " + " ".join(str(first + k) for k in face) for face in faces]
        first += len(points)
    return "\n".join(text) + "\n"


def drawn(stones, random, *, turned, unit, up):
    """Places of a file: turned about the vertical axis [rad], moved, in its unit [m], with its axis upwards."""
    c, s = math.cos(turned), math.sin(turned)

    def place(p):
        x, y, z = c * p[0] - s * p[1] + MOVED[0], s * p[0] + c * p[1] + MOVED[1], p[2] + MOVED[2]
        at = {"z": (x, y, z), "x": (z, x, y), "y": (y, z, x)}[up]
        return tuple(v / unit for v in at)

    names = list(stones)
    random.shuffle(names)
    return obj({name: ([place(p) for p in stones[name][0]], stones[name][1]) for name in names})

"""Writes cross-vault.obj: the stones of a groin vault, whose faces are plane and meet their neighbours'.

usage: cross_vault.py FILE

Two barrels of the same radius cross over a square, with their axes along x and y at z = 0. From each of the four corners
rises a springer; on it courses go up to the crown. A course of a quarter of the vault is a strip of one barrel that turns
at the groin, the vertical plane x = y, into the same strip of the other: there a groin stone has an arm in each. The rest
of either strip is divided from the free edge inward, by half a stone from course to course. A stone with arms along all
four strips closes the crown.
"""

import math
import sys

RADIUS = 4.0        # [m] of the intrados
THICKNESS = 0.4     # [m]
EDGE = 4.9          # [m] of the free edges from the middle
SPRINGING = 20.0    # [degree] where the beds of the springers rise to
COURSES = 7         # between springers and crown
LENGTH = 0.68       # [m] of a stone along its course
SHORTEST = 0.3      # [m] of an arm of a groin stone, along its shortest edge

FACES = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]  # of a straight piece


def section(lower, upper):
    """Corners (across, up) of a course between two angles [radian]: inner and outer of the lower bed, then of the upper."""
    inner, outer = RADIUS, RADIUS + THICKNESS
    return [(r * math.cos(t), r * math.sin(t)) for r, t in ((inner, lower), (outer, lower), (outer, upper), (inner, upper))]


def web_stone(corners, start, end):
    """A straight piece of a strip along x, in the quarter of positive x and y."""
    return [(x, across, up) for x in (start, end) for across, up in corners], FACES


def groin_stone(corners, end):
    """From the end of one arm, at x = end, over the groin to that of the other, at y = end."""
    points = [(end, across, up) for across, up in corners] + [(across, across, up) for across, up in corners]
    points += [(across, end, up) for across, up in corners]
    faces = [(0, 1, 2, 3), (11, 10, 9, 8)]
    for k in range(4):
        a, b = k, (k + 1) % 4
        faces += [(b, a, 4 + a, 4 + b), (4 + b, 4 + a, 8 + a, 8 + b)]
    return points, faces


def crown_stone(half_lower, half_upper, low, high, end):
    """A cross from above: arms to x = +-end and y = +-end, narrower below."""
    points = []
    for half, up in ((half_lower, low), (half_upper, high)):
        points += [(x, y, up) for x, y in ((end, -half), (end, half), (half, half), (half, end), (-half, end), (-half, half),
                                           (-end, half), (-end, -half), (-half, -half), (-half, -end), (half, -end), (half, -half))]
    faces = [tuple(range(11, -1, -1)), tuple(range(12, 24))]
    return points, faces + [(k, (k + 1) % 12, 12 + (k + 1) % 12, 12 + k) for k in range(12)]


def cuts(course, last):
    """Ends of stones along a strip, from the edge inward, no farther than `last`."""
    places, at = [EDGE], EDGE - LENGTH * (1 if course % 2 == 1 else 0.5)
    while at >= last:
        places.append(at)
        at -= LENGTH
    return places


def mirrored(stone, flip_x, flip_y, swap):
    """In another eighth of the vault. An odd number of mirrors turns faces around."""
    points, faces = stone
    moved = []
    for x, y, z in points:
        x, y = (y, x) if swap else (x, y)
        moved.append((-x if flip_x else x, -y if flip_y else y, z))
    odd = (flip_x + flip_y + swap) % 2
    return moved, [face[::-1] for face in faces] if odd else faces


def vault():
    """Stones by name."""
    step = math.radians((90 - SPRINGING) / (COURSES + 0.5))
    beds = [0.0] + [math.radians(SPRINGING) + k * step for k in range(COURSES + 1)]
    stones = {}
    for corner, (flip_x, flip_y) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)), start=1):
        stones[f"springer {corner}"] = mirrored(groin_stone(section(beds[0], beds[1]), EDGE), flip_x, flip_y, 0)
        for course in range(1, COURSES + 1):
            corners = section(beds[course], beds[course + 1])
            ends = cuts(course, corners[1][0] + SHORTEST)
            stones[f"groin {corner} course {course}"] = mirrored(groin_stone(corners, ends[-1]), flip_x, flip_y, 0)
            for swap in (0, 1):
                for k in range(len(ends) - 1):
                    stone = web_stone(corners, ends[k + 1], ends[k])
                    stones[f"web {corner}{'ab'[swap]} course {course} stone {k + 1}"] = mirrored(stone, flip_x, flip_y, swap)
    lower, upper = section(beds[-1], math.pi - beds[-1])[0], section(beds[-1], math.pi - beds[-1])[1]
    ends = cuts(COURSES + 1, upper[0] + SHORTEST)
    stones["crown"] = crown_stone(lower[0], upper[0], lower[1], upper[1], ends[-1])
    corners = [(-lower[0], lower[1]), (lower[0], lower[1]), (upper[0], upper[1]), (-upper[0], upper[1])]
    for k in range(len(ends) - 1):
        for arm, (flip, swap) in enumerate(((0, 0), (0, 1), (1, 0), (1, 1)), start=1):
            stone = web_stone(corners, ends[k + 1], ends[k])
            stones[f"crown {arm} stone {k + 1}"] = mirrored(stone, flip and not swap, flip and swap, swap)
    return stones


def volume(stone):
    """[m3] inside the faces; positive where they are counter-clockwise from outside."""
    points, faces = stone
    total = 0.0
    for face in faces:
        (ax, ay, az) = points[face[0]]
        for b, c in zip(face[1:], face[2:]):
            (bx, by, bz), (cx, cy, cz) = points[b], points[c]
            total += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6
    return total


def obj(stones):
    text, first = [f"# {len(stones)} stones of a groin vault [m], written by cross_vault.py"], 1
    for name, (points, faces) in stones.items():
        text.append(f"o {name}")
        text += ["v " + " ".join(f"{c:.5f}".rstrip("0").rstrip(".") for c in point) for point in points]
        text += ["f " + " ".join(str(first + k) for k in face) for face in faces]
        first += len(points)
    return "\n".join(text).replace(" -0\n", " 0\n") + "\n"


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(obj(vault()))

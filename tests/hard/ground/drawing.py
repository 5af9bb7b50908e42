"""Stones drawn corner by corner, written as the .geo of gmsh."""

import math


class Drawing:
    """Stones as polygons. Sides of equal ends are one curve, so stones that share a side meet in a joint.

    Corners may be given again and again; those equal to the last bit are one point. A stone of three or four points, or
    with such of its points named as corners, is divided regularly; any other, or one with corners=(), freely.
    """

    def __init__(self, size, *, cells="quadrilateral", scale=1.0, offset=(0.0, 0.0), apart=False):
        self.size, self.cells, self.scale, self.offset, self.apart = size, cells, scale, offset, apart
        self.points, self.sides, self.divisions = {}, {}, {}
        self.stones, self.sets, self.curves = [], {}, {}

    def stone(self, points, *, corners=None, sets=()):
        """Adds a stone; its number, from 0."""
        if self.apart:  # sides of its own: what coincides is found by the reader
            points = [(*p, len(self.stones)) for p in points]
        loop = [self.side(a, b) for a, b in zip(points, points[1:] + points[:1])]
        if corners is None and len(points) <= 4:
            corners = range(len(points))
        self.stones.append((loop, [self.points[points[k]] for k in corners] if corners else None))
        for name in sets:
            self.sets.setdefault(name, []).append(len(self.stones))
        return len(self.stones) - 1

    def box(self, x, y, width, height, *, sets=(), **named):
        """Adds a rectangle; named = bottom, right, top, left put a side into the set of facets of that name."""
        corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
        number = self.stone(corners, sets=sets)
        if self.apart:
            corners = [(*p, number) for p in corners]
        ends = dict(bottom=(0, 1), right=(1, 2), top=(2, 3), left=(3, 0))
        for side, name in named.items():
            a, b = ends[side]
            self.name(name, corners[a], corners[b])
        return number

    def name(self, name, a, b):
        """Puts the side from a to b into a set of facets."""
        self.curves.setdefault(name, []).append(abs(self.side(a, b)))

    def divide(self, a, b, cells):
        """Cells along a side, instead of as many as their size asks for."""
        self.divisions[abs(self.side(a, b))] = cells

    def side(self, a, b):
        for point in (a, b):
            self.points.setdefault(point, len(self.points) + 1)
        if (b, a) in self.sides:
            return -self.sides[b, a]
        return self.sides.setdefault((a, b), len(self.sides) + 1)

    def section(self, folder):
        """Writes the drawing; the section mesh of its scene."""
        (folder / "drawing.geo").write_text(self.text())
        return {"type": "gmsh", "gmsh": {"file": str(folder / "drawing.geo"), "cells": self.cells}}

    def text(self):
        lines = ["DefineConstant[ recombine = 0 ];"]
        for (x, y, *_), number in self.points.items():
            x, y = (self.scale * value + shift for value, shift in zip((x, y), self.offset))
            lines.append(f"Point({number}) = {{{x!r}, {y!r}, 0}};")
        for (a, b), number in self.sides.items():
            cells = self.divisions.get(number) or max(1, round(math.dist(a[:2], b[:2]) / self.size))
            lines += [f"Line({number}) = {{{self.points[a]}, {self.points[b]}}};",
                      f"Transfinite Curve{{{number}}} = {cells + 1};"]
        for number, (loop, corners) in enumerate(self.stones, 1):
            lines += [f"Curve Loop({number}) = {{{', '.join(map(str, loop))}}};",
                      f"Plane Surface({number}) = {{{number}}};"]
            if corners:
                lines.append(f"Transfinite Surface{{{number}}} = {{{', '.join(map(str, corners))}}};")
        lines.append(f"If(recombine)\n  Recombine Surface{{1:{len(self.stones)}}};\nEndIf")
        groups = [("Surface", self.sets), ("Curve", self.curves)]
        for kind, sets in groups:
            for name, members in sets.items():
                lines.append(f'Physical {kind}("{name}") = {{{", ".join(map(str, members))}}};')
        return "\n".join(lines) + "\n"


def grid(columns, rows, width, height, size, **how):
    """Stones on each other without bond: four at every inner corner. Facets: ground, left, right, top."""
    drawing = Drawing(size, **how)
    for row in range(rows):
        for column in range(columns):
            sides = {}
            if row == 0:
                sides["bottom"] = "ground"
            if row == rows - 1:
                sides["top"] = "top"
            if column == 0:
                sides["left"] = "left"
            if column == columns - 1:
                sides["right"] = "right"
            # Products, so that a corner has the same coordinates for all its stones.
            x, y = column * width, row * height
            corners = [(x, y), ((column + 1) * width, y), ((column + 1) * width, (row + 1) * height),
                       (x, (row + 1) * height)]
            drawing.stone(corners, sets=(f"row {row}", f"column {column}"))
            ends = dict(bottom=(0, 1), right=(1, 2), top=(2, 3), left=(3, 0))
            for side, name in sides.items():
                drawing.name(name, corners[ends[side][0]], corners[ends[side][1]])
    return drawing


def foundations_and_wall(stones, courses, width, height, size, **how):
    """A wall in bond on stones side by side whose feet, 'foot 0' and so on, are supports; sets: foundation, wall.

    Half a stone at both ends of every other course, from the lowest; vertices where three stones meet.
    """
    drawing = Drawing(size, **how)

    def stone(first, last, row, kind):
        # Products, so that a corner has the same coordinates for all its stones.
        below = [(k * (width / 2), row * height) for k in range(first, last + 1)]
        above = [(x, (row + 1) * height) for x, _ in reversed(below)]
        drawing.stone(below + above, corners=(0, last - first, last - first + 1, 2 * (last - first) + 1), sets=(kind,))
        return below

    for i in range(stones):
        foot = stone(2 * i, 2 * i + 2, -1, "foundation")
        for ends in zip(foot, foot[1:]):
            drawing.name(f"foot {i}", *ends)
    for row in range(courses):
        ends = [*range(0, 2 * stones + 1, 2)] if row % 2 else [0, *range(1, 2 * stones, 2), 2 * stones]
        for first, last in zip(ends, ends[1:]):
            stone(first, last, row, "wall")
    return drawing


def block_on_bed(width=1.0, height=0.5, slope=0.0, size=0.25, depth=0.25, **how):
    """A block on a bed as wide as itself, both turned by the angle whose tangent is the slope; facets: ground, top."""
    c = 1 / math.sqrt(1 + slope**2)
    s = slope * c

    def at(u, v):
        return (u * c - v * s, u * s + v * c)

    drawing = Drawing(size, **how)
    levels = [-depth, 0.0, height]
    for name, low, high in zip(("bed", "block"), levels, levels[1:]):
        drawing.stone([at(0, low), at(width, low), at(width, high), at(0, high)], sets=(name,))
    drawing.name("ground", at(0, -depth), at(width, -depth))
    drawing.name("top", at(width, height), at(0, height))
    return drawing

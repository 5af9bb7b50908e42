"""The scenes W(n) and A(n), xml/wall.xml and xml/arch.xml with n courses or voussoirs, for other programs.

Blocks of Q1 cells with nodes of their own, pairs of nodes that touch, nodes that are held.
"""
import math
from dataclasses import dataclass, field

YOUNG, POISSON, DENSITY, GRAVITY, FRICTION, THICKNESS = 10e9, 0.2, 2000.0, 9.81, 0.6, 1.0
PUSH = 1.4715  # m/s2, sideways on walls in the second load step
SPREAD = 0.005  # m, outward at the right springing of arches in the second load step


@dataclass
class Pair:
    """Nodes of two blocks at one place; the normal runs from i to j."""
    i: int
    j: int
    normal: tuple
    length: float = 0.0  # [m] of the joint that belongs to it


@dataclass
class Scene:
    name: str
    position: list = field(default_factory=list)
    block: list = field(default_factory=list)     # of each node
    cells: list = field(default_factory=list)     # 4 nodes, counter-clockwise
    joints: list = field(default_factory=list)    # nodes of block i, nodes of block j, in the same order
    pairs: list = field(default_factory=list)
    held: list = field(default_factory=list)      # (node, its displacement in the second step)
    push: float = 0.0                             # m/s2 in the second step

    def add_block(self, rows, columns, place):
        """Nodes row by row; place(column, row) [m]. Returns the number of its node at (column, row)."""
        first, number = len(self.position), (self.block[-1] + 1 if self.block else 0)
        for r in range(rows + 1):
            for c in range(columns + 1):
                self.position.append(place(c, r))
                self.block.append(number)
        at = lambda c, r: first + r * (columns + 1) + c
        for r in range(rows):
            for c in range(columns):
                self.cells.append((at(c, r), at(c + 1, r), at(c + 1, r + 1), at(c, r + 1)))
        return at

    def add_joint(self, nodes_i, nodes_j, normal):
        """Nodes of two blocks along a joint, in the same order."""
        pairs = [Pair(i, j, normal) for i, j in zip(nodes_i, nodes_j)]
        for a, b in zip(pairs, pairs[1:]):
            half = math.dist(self.position[a.i], self.position[b.i]) / 2
            a.length += half
            b.length += half
        self.pairs += pairs
        self.joints.append((nodes_i, nodes_j))

    def without_redundant_pairs(self):
        """Where three blocks meet two pairs tie them all: the upright one goes."""
        many = {}
        for pair in self.pairs:
            key = tuple(round(x, 6) for x in self.position[pair.i])
            many.setdefault(key, []).append(pair)
        return [pair for pairs in many.values() for pair in pairs if len(pairs) < 3 or abs(pair.normal[1]) > 0.5]


def wall(n, cells_along=4, cells_up=2, length=0.5, height=0.25):
    scene = Scene(f"W({n})", push=PUSH)
    dx, dy = length / cells_along, height / cells_up
    courses = []
    for course in range(n):
        wide = [cells_along] * n if course % 2 == 0 else [cells_along // 2] + [cells_along] * (n - 1) + [cells_along // 2]
        blocks, start = [], 0
        for cells in wide:
            at = scene.add_block(cells_up, cells,
                                 lambda c, r, s=start, k=course: ((s + c) * dx, (k * cells_up + r) * dy))
            blocks.append((start, cells, at))
            start += cells
        for (_, cells, left), (_, _, right) in zip(blocks, blocks[1:]):
            rows = range(cells_up + 1)
            scene.add_joint([left(cells, r) for r in rows], [right(0, r) for r in rows], (1.0, 0.0))
        if courses:
            for start, cells, upper in blocks:
                for below, wide_below, lower in courses[-1]:
                    common = range(max(start, below), min(start + cells, below + wide_below) + 1)
                    if len(common) > 1:
                        scene.add_joint([lower(x - below, cells_up) for x in common],
                                        [upper(x - start, 0) for x in common], (0.0, 1.0))
        courses.append(blocks)
    scene.held = [(at(c, 0), (0.0, 0.0)) for _, cells, at in courses[0] for c in range(cells + 1)]
    return scene


def arch(n, radial=4, along=2, radius=5.0, depth=1.0):
    scene = Scene(f"A({n})")
    before = None
    for k in range(n):
        def place(c, r, k=k):
            angle = math.pi * (k * along + r) / (n * along)
            rho = radius - depth / 2 + depth * c / radial
            return rho * math.cos(angle), rho * math.sin(angle)
        at = scene.add_block(along, radial, place)
        if before:
            angle = math.pi * k / n
            nodes = range(radial + 1)
            scene.add_joint([before(c, along) for c in nodes], [at(c, 0) for c in nodes],
                            (-math.sin(angle), math.cos(angle)))
        else:
            scene.held += [(at(c, 0), (SPREAD, 0.0)) for c in range(radial + 1)]
        before = at
    scene.held += [(before(c, along), (0.0, 0.0)) for c in range(radial + 1)]
    return scene


def scene_of(name):
    """W16, A31, ..."""
    return (wall if name[0] == "W" else arch)(int(name[1:]))

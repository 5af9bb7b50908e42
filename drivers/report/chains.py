"""Chains of stones through which force passes from one support to another: rings of an arch, columns of a tower.

They are read from the joints and what these carry, whatever sets are called. A stone passes on the force of a joint to
another one: to the only other that presses on it, or else to the only one on its far side; but not where it comes down on
the stone from both sides, as on a pier between two arches. So a chain ends on a pier, at a held stone, or where force divides.

A chain is an arch where both of its ends stand on something and it rises between them, and a column where it stands on
something and is upright. Courses of a wall end free; in its bond every stone stands on two, so there is no chain.
"""
from dataclasses import dataclass

import numpy as np

LEAST = 3              # stones of a chain
OPPOSITE = 0.35        # cosine: joints whose outward normals are more than 110 degrees apart lie on two sides of a stone
CARRIES = 0.1          # of the force that enters: what carries less on the far side is not its way
SAGS = 0.1             # upwards, of the sum of the outward normals of two joints: force comes down from both sides
NOTHING = 1e-6         # of the largest force of a joint
RISE = 0.05            # of the distance of its ends: less is a course, unless nothing presses on it
UPRIGHT = 0.85         # of the way of a column from foot to head is upwards
NONE = ("No line of thrust is drawn: no row of three or more stones was found through which force passes to a support or to other stones "
        "at both of its ends, rising between them, or upright from one. In the bond of a wall force divides at every stone.")


@dataclass
class Chain:
    """Stones in a row and the joints between them, with those at its ends: an arch from left to right, a column upwards."""
    name: str
    kind: str         # "arch" or "column"
    blocks: list      # stones the force passes through, without those it comes from and goes to
    joints: list      # contact points of each joint, in the order of the chain
    directions: list  # per joint: +1 / -1 per point, turning its normal along the chain
    alone: bool       # nothing else presses on its stones


@dataclass
class Side:
    """A joint as one of its stones sees it."""
    joint: int
    other: int
    outward: np.ndarray  # unit
    force: float         # N, the largest of the steps


def joint_points(joints):
    """Contact points of every joint, as a list of arrays."""
    order = np.argsort(joints.joint, kind="stable")
    return np.split(order, np.flatnonzero(np.diff(joints.joint[order])) + 1) if len(order) else []


def centroids(mesh):
    """[blocks, 2] m, mean of the cell centres: good enough to order blocks."""
    centre, count = np.zeros((mesh.blocks, 2)), np.bincount(mesh.block_of_cell, minlength=mesh.blocks)
    middle = mesh.coordinates[mesh.cells].mean(1)
    for k in range(2):
        centre[:, k] = np.bincount(mesh.block_of_cell, middle[:, k], mesh.blocks) / np.maximum(count, 1)
    return centre


def sides_of_stones(joints, of_joint, steps):
    """Stone -> its joints that press in one of the steps."""
    force = np.zeros(len(of_joint))
    for step in steps:
        force = np.maximum(force, [max(step.normal_force[points].sum(), 0) for points in of_joint])
    pressing = np.flatnonzero(force > NOTHING * force.max(initial=0))
    sides = {}
    for k in pressing.tolist():
        points = of_joint[k]
        i, j = int(joints.block_i[points[0]]), int(joints.block_j[points[0]])
        normal = (joints.area[points, None] * joints.normal[points]).sum(0)
        size = np.linalg.norm(normal)
        if len(points) < 2 or not size > 0:
            continue
        sides.setdefault(i, []).append(Side(k, j, normal / size, force[k]))
        sides.setdefault(j, []).append(Side(k, i, -normal / size, force[k]))
    return sides


def ways_out(side, sides):
    """The joints of a stone to which the force of one of them may pass."""
    others = [s for s in sides if s is not side and s.force >= CARRIES * side.force]
    far = [s for s in others if s.outward @ side.outward < -OPPOSITE]
    if not far and len(others) == 1 and others[0].outward @ side.outward < OPPOSITE:
        return others  # round a corner, as from a lintel into its jamb
    return far


def links(sides, held):
    """(stone, joint) -> the joint to which the stone passes the force of that one; what is held keeps it."""
    passes = {}
    for stone, around in ((stone, around) for stone, around in sides.items() if stone not in held):
        for side in around:
            (out, *more) = ways_out(side, around) or [None]
            if out is None or more or [s.joint for s in ways_out(out, around)] != [side.joint]:
                continue
            if (side.outward + out.outward)[1] < SAGS or len(around) == 2:
                passes[stone, side.joint] = out.joint
    return passes


def follow(stone, joint, passes, ends_of):
    """Stones and joints from a joint on into a stone, as far as force is passed on; the last stone is where it is not."""
    stones, chain = [stone], []
    while (stone, joint) in passes and len(chain) <= len(ends_of):
        joint = passes[stone, joint]
        a, b = ends_of[joint]
        stone = b if stone == a else a
        chain.append(joint)
        stones.append(stone)
    return stones, chain


def rows(sides, passes, ends_of):
    """Maximal rows: joints in order and the stones around them, one more than joints. Rows that close have none."""
    seen, found = set(), []
    for around in sides.values():
        for side in around:
            joint = side.joint
            if joint in seen:
                continue
            a, b = ends_of[joint]
            back, before = follow(a, joint, passes, ends_of)
            on, after = follow(b, joint, passes, ends_of)
            chain = before[::-1] + [joint] + after
            seen.update(chain)
            if len(set(chain)) == len(chain):
                found.append((chain, back[::-1] + on))
    return found


def kind_of(x, tops, stands, alone):
    """The kind of a row whose joints have their middles at x, its stones at the heights tops, whose ends stand or not."""
    way = x[-1] - x[0]
    size = np.linalg.norm(way)
    if abs(way[1]) > UPRIGHT * size:
        upwards = np.all(np.diff(x[:, 1]) * way[1] > 0)
        return "column" if upwards and stands[0 if way[1] > 0 else 1] else ""
    # What stands at both ends and nowhere between is an arch, a flat one too.
    rises = tops.max(initial=-np.inf) > x[[0, -1], 1].max() + RISE * size
    return "arch" if all(stands) and (rises or alone) else ""


def name_of(blocks, kind, sets):
    """The set that holds most of the stones, the smallest of several; at least half of them."""
    held = sorted((-len(set(blocks) & set(members.tolist())), len(members), name) for name, members in sets.items())
    return held[0][2] if held and -2 * held[0][0] >= len(blocks) else kind


def find_chains(mesh, joints, steps):
    """Arches and columns, by what joints carry in one of some steps."""
    of_joint = joint_points(joints)
    ends_of = [(int(joints.block_i[p[0]]), int(joints.block_j[p[0]])) for p in of_joint]
    sides = sides_of_stones(joints, of_joint, steps)
    held, middle = mesh.held_blocks, centroids(mesh)
    chains = []
    for row, stones in rows(sides, links(sides, held), ends_of):
        x = np.array([joints.position[of_joint[k]].mean(0) for k in row])
        # An end stands where its stone is held or hands the force to others; else it is the last stone, and free.
        passes_on = [len(sides[stone]) > 1 and stone not in held for stone in (stones[0], stones[-1])]
        stands = [more or stone in held for more, stone in zip(passes_on, (stones[0], stones[-1]))]
        own = list(dict.fromkeys(stones[1:-1] + [s for s, more in zip((stones[0], stones[-1]), passes_on) if not more]))
        through = len(stones) - sum(len(sides[stone]) > 1 for stone in (stones[0], stones[-1]))
        alone = all(side.joint in row for stone in own for side in sides[stone])
        kind = kind_of(x, middle[stones[1:-1], 1], stands, alone) if through >= LEAST else ""
        if not kind:
            continue
        if (x[0, 0] > x[-1, 0]) if kind == "arch" else (x[0, 1] > x[-1, 1]):
            row, stones = row[::-1], stones[::-1]
        ways = [np.where(joints.block_i[of_joint[k]] == before, 1.0, -1.0) for k, before in zip(row, stones)]
        chains.append(Chain(name_of(own, kind, mesh.sets), kind, own, [of_joint[k] for k in row], ways, alone))
    left = lambda chain: tuple(joints.position[chain.joints[0]].mean(0))
    return numbered(sorted(chains, key=left))


def numbered(chains):
    """Chains of one name are told apart by numbers, from left to right."""
    names = [chain.name for chain in chains]
    for name in set(names):
        same = [chain for chain in chains if chain.name == name]
        for k, chain in enumerate(same if len(same) > 1 else [], start=1):
            chain.name = f"{name} {k}"
    return chains

"""Statics of joints: resultants, rings of voussoirs, line of thrust, hinges.

The force of block i on block j at a contact point is p n + q t, with n the normal from i to j and t = (-n_y, n_x).
The resultant of a joint passes where the moment of the normal forces alone puts it: on a straight joint the
tangential forces have no moment about a point of the joint.

A hinge is a joint of a ring that is open at one edge while its resultant has moved to the other. Elastic blocks smear
a hinge over a few neighbouring joints that open on the same side; the one that opens most stands for them.
"""
from dataclasses import dataclass

import numpy as np

from read_results import OPEN

NEGLIGIBLE_OPENING = 0.05  # [-] of the widest edge of the ring: less is elastic rounding beside a real hinge
OUTSIDE_MIDDLE_THIRD = 1 / 6  # [-] of the joint length: beyond it a joint without tension opens at the far edge


@dataclass
class Resultant:
    """What one joint carries, as force of its first block on its second."""
    force: np.ndarray     # [2] N
    normal: float         # N, compression positive
    place: np.ndarray     # [2] m, where it passes; NaN if the joint carries no compression
    eccentricity: float   # [-] distance from the middle over the length of the joint: +-0.5 are the edges
    ends: np.ndarray      # [2, 2] m, edges of the joint
    end_points: tuple     # contact points at the two edges
    middle: np.ndarray    # [2] m


def resultant(joints, step, points, reference):
    """Resultant over contact points, as force on the side of `reference` x n > 0, i.e. signs follow block_i -> block_j."""
    x, n = joints.position[points], joints.normal[points] * reference[:, None]
    p, q = step.normal_force[points], step.tangential_force[points]
    t = np.stack([-n[:, 1], n[:, 0]], 1)
    force = (p[:, None] * n + q[:, None] * t).sum(0)
    along = np.array([-n.mean(0)[1], n.mean(0)[0]])
    along /= max(np.linalg.norm(along), 1e-12)
    s = (x - x.mean(0)) @ along
    low, high = int(np.argmin(s)), int(np.argmax(s))
    middle, length, total = (x[low] + x[high]) / 2, s[high] - s[low], p.sum()
    offset = (p @ s) / total - (s[low] + s[high]) / 2 if total > 0 else np.nan
    return Resultant(force, float(total), middle + offset * along, offset / length if length > 0 else np.nan,
                     np.stack([x[low], x[high]]), (int(points[low]), int(points[high])), middle)


def joint_points(joints):
    """Contact points of every joint, as a list of arrays."""
    order = np.argsort(joints.joint, kind="stable")
    return np.split(order, np.flatnonzero(np.diff(joints.joint[order])) + 1) if len(order) else []


@dataclass
class Ring:
    """Voussoirs in a row, from one springing to the other, and the joints between them."""
    name: str
    blocks: list
    joints: list        # contact points of each joint, in the order of the row
    directions: list    # per joint: +1 / -1 per point, turning its normal along the row
    centre: np.ndarray  # [2] m, of the circle through the voussoirs


def centroids(mesh):
    """[blocks, 2] m, mean of the cell centres: good enough to order blocks."""
    centre, count = np.zeros((mesh.blocks, 2)), np.bincount(mesh.block_of_cell, minlength=mesh.blocks)
    middle = mesh.coordinates[mesh.cells].mean(1)
    for k in range(2):
        centre[:, k] = np.bincount(mesh.block_of_cell, middle[:, k], mesh.blocks) / np.maximum(count, 1)
    return centre


def rows_of(blocks, neighbours):
    """Maximal rows b0 - b1 - ... of a set of blocks; parts that branch or close are left out."""
    member, rows, seen = set(blocks), [], set()
    inside = {b: [c for c in neighbours.get(b, ()) if c in member] for b in blocks}
    for start in blocks:
        if start in seen or len(inside[start]) != 1:
            continue
        row, previous = [start], None
        while True:
            following = [c for c in inside[row[-1]] if c != previous]
            if len(following) != 1:
                break
            previous = row[-1]
            row.append(following[0])
        seen.update(row)
        if not following and len(row) >= 3:
            rows.append(row)
    return rows


def circle_centre(x):
    """Centre of the circle that fits points in the least-squares sense, wherever the origin lies."""
    middle = x.mean(0)
    arm = x - middle
    solution, *_ = np.linalg.lstsq(np.column_stack([2 * arm, np.ones(len(x))]), (arm**2).sum(1), rcond=None)
    return middle + solution[:2]


def is_arch(x):
    """The row rises between its ends: a column or a course does not."""
    return x[1:-1, 1].max() > x[[0, -1], 1].max() + 0.02 * np.linalg.norm(x[-1] - x[0])


def springing(joints, by_block, end, inner, centre):
    """Contact points of the end voussoir with what carries it: those that face away from the row."""
    along = centre[end] - centre[inner]
    along /= np.linalg.norm(along)
    points = by_block.get(end, np.zeros(0, int))
    other = np.where(joints.block_i[points] == end, joints.block_j[points], joints.block_i[points])
    outward = np.where(joints.block_i[points] == end, 1.0, -1.0)[:, None] * joints.normal[points]
    return points[(other != inner) & (outward @ along > 0.7)]


def find_rings(mesh, joints):
    """Rings: sets of blocks whose name begins with 'ring', else the whole structure if it is one row that rises."""
    of_pair, neighbours = {}, {}
    for points in joint_points(joints):
        if len(points) > 1:
            a, b = joints.pairs[joints.joint[points[0]]].tolist()
            of_pair[a, b] = points
            neighbours.setdefault(a, []).append(b)
            neighbours.setdefault(b, []).append(a)
    both = np.concatenate([joints.block_i, joints.block_j])
    order = np.argsort(both, kind="stable")
    parts = np.split(order % max(len(joints.area), 1), np.flatnonzero(np.diff(both[order])) + 1) if len(order) else []
    by_block = {int(b): part for b, part in zip(np.unique(both), parts)}

    centre = centroids(mesh)
    named = {name: blocks for name, blocks in mesh.sets.items() if name.lower().startswith("ring")}
    rings = []
    for name, blocks in (named or {"arch": np.arange(mesh.blocks)}).items():
        rows = [row for row in rows_of(blocks.tolist(), neighbours) if is_arch(centre[row])]
        for k, row in enumerate(rows):
            row = row if centre[row[0], 0] <= centre[row[-1], 0] else row[::-1]
            chain = [of_pair[min(a, b), max(a, b)] for a, b in zip(row, row[1:])]
            ways = [np.where(joints.block_i[p] == a, 1.0, -1.0) for p, a in zip(chain, row)]
            first, last = (springing(joints, by_block, e, i, centre) for e, i in ((row[0], row[1]), (row[-1], row[-2])))
            if len(first) > 1:
                chain, ways = [first] + chain, [np.where(joints.block_i[first] == row[0], -1.0, 1.0)] + ways
            if len(last) > 1:
                chain, ways = chain + [last], ways + [np.where(joints.block_i[last] == row[-1], 1.0, -1.0)]
            rings.append(Ring(name if len(rows) == 1 else f"{name} {k + 1}", row, chain, ways, circle_centre(centre[row])))
    return rings


def ring_resultants(ring, joints, step):
    return [resultant(joints, step, points, way) for points, way in zip(ring.joints, ring.directions)]


def thrust_line(resultants):
    """[joints, 2] m; NaN where a joint carries next to nothing, so that the drawn line is interrupted there."""
    largest = max((r.normal for r in resultants), default=0.0)
    return np.array([r.place if r.normal > 1e-3 * largest else [np.nan, np.nan] for r in resultants]).reshape(-1, 2)


def horizontal_thrust(resultants):
    """[N] horizontal force through the joint nearest to the crown."""
    crown = max(resultants, key=lambda r: r.middle[1])
    return abs(float(crown.force[0]))


def geometrical_factor(resultants):
    """[-] half the length of a joint over the eccentricity of its resultant, the least of all; at least 1."""
    farthest = max((abs(r.eccentricity) for r in resultants if r.normal > 0 and np.isfinite(r.eccentricity)), default=0.0)
    return max(0.5 / farthest, 1.0) if farthest > 0 else np.inf


@dataclass
class Hinge:
    ring: str
    blocks: tuple      # the two blocks, or the springing voussoir alone
    opens_at: str      # "intrados" or "extrados"
    turns_at: str      # the other one: where the force passes
    opening: float     # [m] at the open edge
    place: np.ndarray  # [2] m, on the joint where the resultant passes
    points: tuple      # contact points (open edge, compressed edge)
    joint: int         # number in the ring, from the left springing


def find_hinges(ring, joints, step, resultants):
    """Hinges of a ring, from the left springing to the right."""
    signs, openings = [], []
    for r in resultants:
        gap = step.gap[list(r.end_points)]
        open_end = int(np.argmax(gap))
        shifted = (0.5 - open_end) * r.eccentricity > 0 and abs(r.eccentricity) > OUTSIDE_MIDDLE_THIRD
        is_open = step.status[r.end_points[open_end]] == OPEN and step.status[r.end_points[1 - open_end]] != OPEN
        distance = np.linalg.norm(r.ends - ring.centre, axis=1)
        outward = 1 if distance[open_end] > distance[1 - open_end] else -1
        signs.append(outward if shifted and is_open else 0)
        openings.append(float(gap[open_end]) if shifted and is_open else 0.0)
    enough, hinges, k = NEGLIGIBLE_OPENING * max(openings, default=0.0), [], 0
    while k < len(signs):
        run = [k]
        while run[-1] + 1 < len(signs) and signs[run[-1] + 1] == signs[k]:
            run.append(run[-1] + 1)
        top = max(run, key=lambda m: openings[m])
        if signs[k] and openings[top] > enough:
            r, names = resultants[top], ("intrados", "extrados")
            gap = step.gap[list(r.end_points)]
            ends = r.end_points if gap[0] > gap[1] else r.end_points[::-1]
            edge = r.ends[1] if gap[0] > gap[1] else r.ends[0]
            place = r.place if abs(r.eccentricity) < 0.5 else edge
            pair = tuple(int(b) for b in joints.pairs[joints.joint[ring.joints[top][0]]])
            hinges.append(Hinge(ring.name, pair, names[signs[top] > 0], names[signs[top] < 0], openings[top], place, ends, top))
        k = run[-1] + 1
    return hinges

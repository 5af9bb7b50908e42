"""Statics of joints: resultants, line of thrust of a chain of stones, hinges.

The force of block i on block j at a contact point is p n + q t, with n the normal from i to j and t = (-n_y, n_x).
The resultant of a joint passes where the moment of the normal forces alone puts it: on a straight joint the
tangential forces have no moment about a point of the joint.

A hinge is a joint of a chain that is open at one edge while its resultant has moved to the other. Elastic blocks smear
a hinge over a few neighbouring joints that open on the same side; the one that opens most stands for them.
"""
from dataclasses import dataclass

import numpy as np

from read_results import OPEN

NEGLIGIBLE_OPENING = 0.05  # [-] of the widest edge of the chain: less is elastic rounding beside a real hinge
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


def chain_resultants(chain, joints, step):
    return [resultant(joints, step, points, way) for points, way in zip(chain.joints, chain.directions)]


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
    chain: str
    blocks: tuple      # the two blocks
    opens_at: str      # "intrados" or "extrados" of an arch, a face of a column
    turns_at: str      # the other one: where the force passes
    opening: float     # [m] at the open edge
    place: np.ndarray  # [2] m, on the joint where the resultant passes
    points: tuple      # contact points (open edge, compressed edge)
    joint: int         # number in the chain


FACES = {"arch": ("intrados", "extrados"), "column": ("right face", "left face")}  # to the right of its way, to the left


def find_hinges(chain, joints, step, resultants):
    """Hinges of a chain, from its beginning."""
    signs, openings = [], []
    for r, points, way in zip(resultants, chain.joints, chain.directions):
        gap = step.gap[list(r.end_points)]
        open_end = int(np.argmax(gap))
        shifted = (0.5 - open_end) * r.eccentricity > 0 and abs(r.eccentricity) > OUTSIDE_MIDDLE_THIRD
        is_open = step.status[r.end_points[open_end]] == OPEN and step.status[r.end_points[1 - open_end]] != OPEN
        along = (way[:, None] * joints.normal[points]).sum(0)
        outward = 1 if np.array([-along[1], along[0]]) @ (r.ends[open_end] - r.ends[1 - open_end]) > 0 else -1
        signs.append(outward if shifted and is_open else 0)
        openings.append(float(gap[open_end]) if shifted and is_open else 0.0)
    enough, hinges, k = NEGLIGIBLE_OPENING * max(openings, default=0.0), [], 0
    while k < len(signs):
        run = [k]
        while run[-1] + 1 < len(signs) and signs[run[-1] + 1] == signs[k]:
            run.append(run[-1] + 1)
        top = max(run, key=lambda m: openings[m])
        if signs[k] and openings[top] > enough:
            r, names = resultants[top], FACES[chain.kind]
            gap = step.gap[list(r.end_points)]
            ends = r.end_points if gap[0] > gap[1] else r.end_points[::-1]
            edge = r.ends[1] if gap[0] > gap[1] else r.ends[0]
            place = r.place if abs(r.eccentricity) < 0.5 else edge
            pair = tuple(int(b) for b in joints.pairs[joints.joint[chain.joints[top][0]]])
            hinges.append(Hinge(chain.name, pair, names[signs[top] > 0], names[signs[top] < 0], openings[top], place, ends, top))
        k = run[-1] + 1
    return hinges

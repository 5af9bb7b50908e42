"""The motion of a structure for the page: outlines of stones at the recorded steps, joints that are open, loads at points. The
script motion_player.js draws them, one step at a time or all in turn.

Places are whole numbers of 1/65535 of the size, displacements of 1/32767 of the largest of all steps.
"""
import base64
import json
from pathlib import Path

import numpy as np

import draw_structure
from draw_common import SET_COLOURS, STONE
from draw_loads import POINTS, arrows_of
from geometry import force_text, length_text, round_number, span
from read_results import OPEN

FRAMES, FEWEST = 60, 12
BYTES = 1_500_000  # of all displacements together: a page that can still be sent by mail
SHARE = 0.05       # of the span, drawn for the largest displacement at first
SECONDS_IN_TIME, SECONDS_OF_STEPS = 4.0, 0.6  # all of a motion in time; each load step
WHOLE, HALF = 65535, 32767
SCRIPT = Path(__file__).resolve().parent / "motion_player.js"


def packed(values, kind):
    return base64.b64encode(np.ascontiguousarray(values, kind).tobytes()).decode("ascii")


def chosen_frames(times, count):
    """Numbers of at most `count` recorded steps, even in time (in load steps: in number), with the first and the last."""
    if len(times) <= count:
        return np.arange(len(times))
    course = np.array(times) if np.isfinite(times).all() else np.arange(float(len(times)))
    wanted = np.linspace(course[0], course[-1], count)
    return np.unique(np.abs(course[None, :] - wanted[:, None]).argmin(1))


def frames_for(nodes):
    return int(np.clip(BYTES // max(4 * nodes, 1), FEWEST, FRAMES))


def loops(edges):
    """Closed rows of nodes along directed edges."""
    following = {}
    for a, b in edges.tolist():
        following.setdefault(a, []).append(b)
    found = []
    while following:
        first = node = next(iter(following))
        loop = []
        while node in following:
            ways = following[node]
            loop.append(node)
            then = ways.pop()
            if not ways:
                del following[node]
            node = then
            if node == first:
                break
        found.append(loop)
    return found


def polygons_of(mesh, edges, faces):
    """Areas to be filled, the farthest first, and the block of each: outlines of plane stones, or faces that are seen."""
    if faces:
        return [list(dict.fromkeys(cell)) for cell in mesh.cells.tolist()], mesh.block_of_cell
    block_of_node = np.zeros(len(mesh.coordinates), int)
    block_of_node[mesh.cells] = mesh.block_of_cell[:, None]
    found = loops(edges)
    return found, block_of_node[[loop[0] for loop in found]]


def words_of(step_number, stage, time, displacement):
    largest = length_text(float(np.linalg.norm(displacement, axis=1).max(initial=0.0)))
    clock = f"t = {time:.4g} s" if np.isfinite(time) else f"step {step_number}"
    return f"{clock}, {stage}: largest displacement {largest}"


def arrows_at_points(frame, x, edges):
    """Rows (x, y, force x, force y) of loads that act at points, and their words."""
    rows, words = [], []
    for load in frame.loads:
        if load.kind in POINTS and len(load.node):
            for arrow in arrows_of(load, x, edges)[0]:
                rows.append([*arrow.at.tolist(), *arrow.force.tolist()])
                words.append(f"{load.name} {force_text(float(np.linalg.norm(arrow.force)))}")
    return rows, "; ".join(dict.fromkeys(words))


def data_of(mesh, edges, frames, pieces=None, joints=None, faces=False, sizes=None):
    """The numbers of the player; None when nothing moves.

    frames  FrameOfMotion of each step, displacements as they are seen
    sizes   [frames, nodes, 3]: displacements in space, where those seen are shorter
    """
    largest = max((float(np.abs(f.displacement).max(initial=0)) for f in frames), default=0)
    if len(frames) < 2 or not np.isfinite(largest) or largest <= 0:
        return None
    x = mesh.coordinates
    polygons, block = polygons_of(mesh, edges, faces)
    shown = pieces.point if pieces is not None else np.zeros((0, 2), int)
    points = np.unique(shown)
    ends = np.stack([joints.node_i[points], joints.node_j[points]], 1) if len(points) else np.zeros((0, 2), int)
    kept = np.unique(np.concatenate([edges.reshape(-1), ends.reshape(-1), np.concatenate([np.array(p) for p in polygons])]))
    new = np.zeros(len(x), int)
    new[kept] = np.arange(len(kept))
    index = np.uint32 if len(kept) > WHOLE else np.uint16
    least, size = x[kept].min(0), float(np.ptp(x[kept], axis=0).max())
    hexadecimal = [STONE, *SET_COLOURS]
    colour, _ = draw_structure.colours_by_set(mesh)
    number = np.zeros(int(joints.node_i.shape[0]) if joints is not None else 0, int)
    number[points] = np.arange(len(points))
    told = []
    for k, frame in enumerate(frames):
        arrows, said = arrows_at_points(frame, x, edges) if not faces else ([], "")
        seen = np.nan_to_num(frame.displacement[kept])
        told.append({"words": words_of(frame.number, frame.stage, frame.time, frame.displacement if sizes is None else sizes[k])
                     + (f"; {said}" if said else ""),
                     "u": packed(np.round(seen * (HALF / largest)), np.int16), "arrows": arrows,
                     "open": packed(frame.status[points] == OPEN, np.uint8)})
    in_time = bool(np.isfinite([f.time for f in frames]).all())
    # As far as the largest motion is drawn at first, with room for more.
    margin = 1.2 * SHARE * span(x)
    return {"least": least.tolist(), "unit": size / WHOLE, "largest": largest / HALF,
            "box": [float(x[kept, 0].min() - margin), float(x[kept, 0].max() + margin), float(x[kept, 1].min() - margin), float(x[kept, 1].max() + margin)],
            "scale": round_number(SHARE * span(x) / max(float(np.linalg.norm(f.displacement, axis=1).max(initial=0)) for f in frames)),
            "places": packed(np.round((x[kept] - least) * (WHOLE / size)), np.uint16), "index": index().itemsize,
            "corners": packed(new[np.concatenate([np.array(p) for p in polygons])], index), "counts": packed([len(p) for p in polygons], np.uint32),
            "colours": hexadecimal, "colour": packed([hexadecimal.index(c) for c in colour[block]], np.uint8), "apart": bool(faces),
            "edges": packed(new[edges], index), "ends": packed(new[ends], index), "pieces": packed(number[shown], np.uint32),
            "seconds": SECONDS_IN_TIME / len(frames) if in_time else SECONDS_OF_STEPS, "frames": told}


def text_of(data):
    return json.dumps(data, separators=(",", ":"))

"""What a page needs to let a reader turn a structure in space: its places, faces and edges, what it does at the end of each
stage, and the scripts that draw it (view_in_space.js on three.js). Nothing of it is asked of a network.

Places are whole numbers of 1/65535 of the size, displacements of 1/32767 of the largest: joints that are closed stay closed
to the last digit, since both sides of one have the same place.
"""
import base64
import json
from pathlib import Path

import numpy as np

import draw_structure
import solids
from draw_common import SET_COLOURS, STONE
from geometry import counted, deformation_scale, force_text, length_text
from read_results import BONDED, OPEN, SLIP, STICK, is_mechanism

THREE = Path("/usr/share/javascript/three")  # of the package libjs-three
SCRIPTS = (THREE / "three.min.js", THREE / "examples" / "js" / "controls" / "OrbitControls.js",
           Path(__file__).resolve().parent / "view_in_space.js")
KINDS = 40           # of sets that a reader can choose from
BYTES = 2_500_000    # of all displacements together
SEEN = 0.06          # of the size: how far the largest displacement is drawn at first
SMALL = 0.01         # of the largest resultant: less is not drawn
WHOLE, HALF = 65535, 32767


class NoScripts(OSError):
    """three.js is not there."""


def packed(values, kind):
    return base64.b64encode(np.ascontiguousarray(values, kind).tobytes()).decode("ascii")


def resultants(joints, force):
    """Force of each joint on its second stone and where it acts, [joints, 3] each, by size."""
    normal = (force * joints.normal).sum(1)
    count = len(joints.pairs)
    add = lambda values: np.stack([np.bincount(joints.joint, values[:, c], count) for c in range(3)], 1)
    total, pressed = add(force), np.bincount(joints.joint, normal, count)
    weight = np.where((pressed > 0)[joints.joint], normal, 1.0)  # a joint that is pulled is drawn at its middle
    at = add(joints.position * weight[:, None]) / np.bincount(joints.joint, weight, count)[:, None]
    return at, total


def arrows(joints, force):
    """Places and sizes, of the largest one, of the resultants that can be seen, [arrows, 6]; the largest in words."""
    if force is None or not len(joints.area):
        return np.zeros((0, 6)), 0.0
    at, total = resultants(joints, np.nan_to_num(force))
    size = np.linalg.norm(total, axis=1)
    largest = size.max(initial=0.0)
    shown = (size > SMALL * largest) & np.isfinite(at).all(1)
    return np.concatenate([at[shown], total[shown] / max(largest, 1e-300)], 1), largest


def stage_of(mesh, joints, step, kept):
    u = np.nan_to_num(step.displacement)[kept]
    largest = max(float(np.abs(u).max(initial=0.0)), 1e-300)
    mechanism = is_mechanism(step)
    drawn, force = arrows(joints, None if mechanism else step.force)
    words = (f"{step.stage}: the motion the collapse begins with" if mechanism else
             f"{step.stage} (step {step.number}): largest displacement {length_text(step.largest_displacement)}"
             + (f", largest resultant of a joint {force_text(force)}" if len(drawn) else ""))
    return {"name": step.stage, "words": words, "mechanism": mechanism, "largest": largest, "scale": float(deformation_scale(mesh, step, SEEN)),
            "displacement": packed(np.round(u * (HALF / largest)), np.int16),
            "status": packed(np.where(np.isin(step.status, (OPEN, STICK, SLIP)), step.status, BONDED), np.uint8),
            "arrows": packed(drawn, np.float32)}


def as_built(kept, joints):
    return {"name": "as built", "words": "as built", "mechanism": False, "largest": 1.0, "scale": 1.0,
            "displacement": packed(np.zeros((len(kept), 3)), np.int16), "status": packed(np.full(len(joints.area), BONDED), np.uint8),
            "arrows": packed(np.zeros(0), np.float32)}


def colours_of_sets(mesh):
    """Ways to colour stones: alike, all sets at once, sets of one kind alone; and the colours that they use."""
    hexadecimal = [STONE, *SET_COLOURS]
    palette = [[int(c[k:k + 2], 16) for k in (1, 3, 5)] for c in hexadecimal]
    ways = [{"words": "alike", "name": "", "members": [], "colours": None}]
    if not mesh.sets:
        return ways, palette
    colour, _ = draw_structure.colours_by_set(mesh)
    ways.append({"words": "by set", "name": "", "members": [], "colours": [hexadecimal.index(c) for c in colour]})
    for kind, names in list(draw_structure.kinds_of_sets(mesh).items())[:KINDS]:
        members = np.unique(np.concatenate([mesh.sets[name] for name in names]))
        alone = np.zeros(mesh.blocks, int)
        alone[members] = 1
        ways.append({"words": kind, "name": kind, "members": members.tolist(), "colours": alone.tolist()})
    return ways, palette


def data_of(results):
    """The numbers of the view."""
    mesh, joints = results.mesh, results.joints
    faces, _ = solids.surfaces(mesh)
    edges = solids.outlines(mesh, faces)
    kept = np.unique(np.concatenate([faces.reshape(-1), joints.node_j]))
    new = np.zeros(len(mesh.coordinates), int)
    new[kept] = np.arange(len(kept))
    index = np.uint32 if len(kept) > WHOLE else np.uint16
    block_of_node = np.zeros(len(mesh.coordinates), int)
    block_of_node[mesh.cells] = mesh.block_of_cell[:, None]
    x = mesh.coordinates[kept]
    least, size = x.min(0), float(np.ptp(x, axis=0).max())
    stages = draw_structure.chosen_stages(results.stage_ends)
    most = max(1, BYTES // max(1, 8 * len(kept)))
    told = [stage_of(mesh, joints, step, kept) for step in stages[-most:]] or [as_built(kept, joints)]
    ways, palette = colours_of_sets(mesh)
    return {"least": least.tolist(), "unit": size / WHOLE, "size": float(np.linalg.norm(np.ptp(x, axis=0))),
            "middle": ((x.min(0) + x.max(0)) / 2).tolist(), "stones": mesh.blocks,
            "places": packed(np.round((x - least) * (WHOLE / size)), np.uint16),
            "stone_of_node": packed(block_of_node[kept], np.uint32 if mesh.blocks > WHOLE else np.uint16),
            "faces": packed(new[solids.triangles(faces)], index), "edges": packed(new[edges], index), "points": packed(new[joints.node_j], index),
            "open": OPEN, "slip": SLIP, "stick": STICK, "pale": palette[0], "palette": palette, "sets": ways,
            "stages": told}


def add_view(page, results):
    """The view, where three.js is installed."""
    missing = [str(path) for path in SCRIPTS if not path.exists()]
    if missing:
        raise NoScripts(f"{missing[0]} is not there (Debian's package libjs-three)")
    data = data_of(results)
    text = json.dumps(data, separators=(",", ":"))
    shown, all_stages = len(data["stages"]), max(1, len(results.stage_ends))
    page.view_in_space(text, [path.read_text(encoding="utf-8") for path in SCRIPTS], [s["name"] for s in data["stages"]],
                       [way["words"] for way in data["sets"]],
                       f"The structure to be turned, at the end of {shown} of {counted(all_stages, 'stage')}. Red points are open, orange ones slip; green "
                       "arrows are the resultants of joints, as one stone presses on the next. Drag to turn, with the right button to move, "
                       "wheel or pinch to come nearer; click a stone for its number.")

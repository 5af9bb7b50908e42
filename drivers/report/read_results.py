"""Reads what a run left behind: result.json, history.csv, fields.h5, scene.xml.

Any of them may be missing or damaged; what could not be read is collected in `Results.remarks`, in words for the reader
of the report. Units: m, N, Pa, J, s. Signs: gap > 0 open, normal force > 0 compression, stress > 0 tension.
"""
import csv
import json
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from pathlib import Path

import h5py
import numpy as np

OPEN, STICK, SLIP, BONDED = 0, 1, 2, 3
MECHANISM = ": mechanism"  # ends the stage of a step that shows how a collapse begins

# Damaged files end in one of these; anything else is a mistake of ours and should be seen.
UNREADABLE = (OSError, ValueError, KeyError, IndexError, csv.Error, ElementTree.ParseError)


@dataclass
class Mesh:
    """Nodes and cells of all blocks; every block has its own copies of the nodes on its joints."""
    coordinates: np.ndarray    # [nodes, 2 or 3] m
    cells: np.ndarray          # [cells, 3, 4 or 8] nodes; a cell in a table of more repeats its last node
    block_of_cell: np.ndarray  # [cells]
    blocks: int
    rank_of_block: np.ndarray  # [blocks]
    sets: dict                 # name -> ascending block numbers
    held_blocks: set           # blocks of which a support holds a node
    held: np.ndarray           # [nodes] what supports hold: the sum of 1 for x, 2 for y, 4 for z
    projected: bool = False    # a structure in space as it is seen: cells are faces, the farthest first

    @property
    def in_space(self):
        return self.coordinates.shape[1] == 3


@dataclass
class Joints:
    """All candidate contact points."""
    position: np.ndarray  # [points, 2 or 3] m
    normal: np.ndarray    # [points, 2 or 3], unit, from block_i to block_j
    block_i: np.ndarray
    block_j: np.ndarray
    node_i: np.ndarray
    node_j: np.ndarray
    area: np.ndarray      # [points] m2
    joint: np.ndarray = field(init=False)  # [points] number of the joint = pair of blocks
    pairs: np.ndarray = field(init=False)  # [joints, 2] blocks of a joint

    def __post_init__(self):
        pairs = np.stack([np.minimum(self.block_i, self.block_j), np.maximum(self.block_i, self.block_j)], 1)
        self.pairs, joint = np.unique(pairs.reshape(-1, 2), axis=0, return_inverse=True)
        self.joint = joint.reshape(-1)


@dataclass
class Load:
    """A load as it acts at the end of a step."""
    name: str
    kind: str           # its type in the scene
    factor: float       # of its stage times its function of time
    of_stones: bool     # acts on all of stones, so that no node is named
    total: np.ndarray   # [2 or 3] N
    node: np.ndarray    # [rows]
    force: np.ndarray   # [rows, 2 or 3] N


@dataclass
class Step:
    """State at the end of one load step."""
    number: int
    stage: str
    load_factor: float
    displacement: np.ndarray      # [nodes, 2 or 3] m
    stress: np.ndarray            # [cells, 3] Pa: xx, yy, xy; in space [cells, 6]: xx, xy, xz, yy, yz, zz
    gap: np.ndarray               # [points] m
    slip: np.ndarray              # [points] m
    normal_force: np.ndarray      # [points] N
    tangential_force: np.ndarray  # [points] N
    status: np.ndarray            # [points] OPEN, STICK, SLIP or BONDED
    selected: np.ndarray          # [points] bool
    force: np.ndarray             # [points, 3] N of block_i on block_j in space; None in the plane
    damage: np.ndarray            # [points] share of the strength that is lost; None where joints have none to lose
    loads: list = field(default_factory=list)
    time: float = np.nan          # [s] of a time step

    @property
    def largest_displacement(self):
        return float(np.linalg.norm(self.displacement, axis=1).max(initial=0.0))


@dataclass
class Results:
    folder: Path
    result: dict = field(default_factory=dict)   # result.json as it is
    history: list = field(default_factory=list)  # one dict of strings per step
    title: str = ""
    mesh: Mesh = None
    joints: Joints = None
    stage_ends: list = field(default_factory=list)  # last step of every stage, in the order of loading
    margins: list = field(default_factory=list)  # joints.csv: one dict of strings per joint, of a run that ends in statics
    times: list = field(default_factory=list)       # [s] of every recorded step of the motion, NaN for a load step
    remarks: list = field(default_factory=list)

    @property
    def last(self):
        return self.stage_ends[-1] if self.stage_ends else None

    @property
    def standing(self):
        """The last step of every stage, without mechanisms."""
        return [step for step in self.stage_ends if not is_mechanism(step)]

    @property
    def equilibrium(self):
        """The last step that is no mechanism, where there is one."""
        return self.standing[-1] if self.standing else self.last

    @property
    def ends_in_time(self):
        """Whether the last step took time: a load factor means nothing there."""
        return bool(self.history) and number(self.history[-1].get("time_s")) is not None


def is_mechanism(step):
    """The motion a collapse begins with: a direction, whose size, stresses and forces mean nothing."""
    return step.stage.endswith(MECHANISM)


def plain(key):
    """A key without units and punctuation: 'largest_displacement_m', 'Largest displacement [m]' -> 'largest displacement'."""
    words = re.sub(r"\[.*?\]", " ", str(key)).replace("_", " ").replace("-", " ").split()
    if len(words) > 1 and words[-1] in ("m", "J", "N", "Pa", "s", "MB", "bytes", "B"):
        words = words[:-1]
    return " ".join(words).lower()


def find(tree, *names):
    """First value in a nested dict whose plain key is one of `names`; outer levels and earlier names win."""
    level = [tree] if isinstance(tree, dict) else []
    while level:
        for name in names:
            for node in level:
                for key, value in node.items():
                    if plain(key) == name:
                        return value
        level = [v for node in level for v in node.values() if isinstance(v, dict)]
    return None


def number(value):
    """A finite float, or None for anything else."""
    try:
        value = float(value)
    except (TypeError, ValueError):
        return None
    return value if np.isfinite(value) else None


def text(value):
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def read_sets(mesh_group, blocks):
    """Sets by name, from the list of the sets of every block."""
    if "block_sets" not in mesh_group or "block_set_names" not in mesh_group:
        return {}
    names = [text(n) for n in np.atleast_1d(mesh_group["block_set_names"][()])]
    table = mesh_group["block_sets"][()].reshape(blocks, -1)
    if table.max(initial=-1) >= len(names):
        raise ValueError(f"/mesh/block_sets names set {table.max()}, and there are {len(names)}")
    members = [np.flatnonzero((table == k).any(axis=1)) for k in range(len(names))]
    return {name: blocks_of for name, blocks_of in zip(names, members) if len(blocks_of)}


def read_mesh(file):
    group = file["mesh"]
    block_of_cell = group["block_of_cell"][()].astype(int).reshape(-1)
    block_of_node = group["block_of_node"][()].astype(int).reshape(-1)
    blocks = int(block_of_node.max()) + 1
    rank = group["rank_of_block"][()].astype(int) if "rank_of_block" in group else np.zeros(blocks, int)
    held = group["held"][()].reshape(-1).astype(int) if "held" in group else np.zeros(len(block_of_node), int)
    return Mesh(group["coordinates"][()], group["cells"][()].astype(int), block_of_cell, blocks, rank,
                read_sets(group, blocks), set(block_of_node[held > 0].tolist()), held)


def read_joints(file):
    group = file["joints"]
    integer = lambda name: group[name][()].astype(int).reshape(-1)
    return Joints(group["position"][()].reshape(-1, group["position"].shape[-1]),
                  group["normal"][()].reshape(-1, group["normal"].shape[-1]),
                  integer("block_i"), integer("block_j"), integer("node_i"), integer("node_j"),
                  group["area"][()].reshape(-1))


def read_loads(step_group):
    """The loads that act at the end of a step, in the order of the scene."""
    if "loads" not in step_group:
        return []
    group = step_group["loads"]
    table = {name: group[name][()] for name in group}
    names, kinds = ([text(n) for n in np.atleast_1d(table[key])] for key in ("name", "type"))
    total = table["total_N"].reshape(len(names), -1)
    of = table["load_of"].reshape(-1).astype(int)
    node, force = table["node"].reshape(-1).astype(int), table["force_N"].reshape(len(of), total.shape[1])
    return [Load(name, kind, float(factor), bool(whole), total[k], node[of == k], force[of == k])
            for k, (name, kind, factor, whole) in enumerate(zip(names, kinds, np.ravel(table["factor"]), np.ravel(table["of_stones"])))]


def step_nearest(results, time):
    """The recorded step nearest to a time [s], with all its fields."""
    with h5py.File(results.folder / "fields.h5", "r") as file:
        name = steps_of_motion(file["steps"])[int(np.nanargmin(np.abs(np.array(results.times) - time)))]
        return read_step(name, file["steps"][name], len(results.joints.area))


def read_step(name, group, points):
    value = lambda key: group[key][()].reshape(-1) if key in group else np.zeros(points)
    status = value("joint_status").astype(int) if "joint_status" in group else np.full(points, BONDED)
    selected = value("joint_selected") > 0 if "joint_selected" in group else status != BONDED
    return Step(int(group.attrs.get("step", name)), text(group.attrs.get("stage", "")),
                float(group.attrs.get("load_factor", np.nan)), group["displacement"][()], group["stress"][()],
                value("joint_gap_m"), value("joint_slip_m"), value("joint_normal_force_N"),
                value("joint_tangential_force_N"), status, selected,
                group["joint_force_N"][()].reshape(-1, 3) if "joint_force_N" in group else None,
                value("joint_damage") if "joint_damage" in group else None, read_loads(group), float(group.attrs.get("time_s", np.nan)))


def last_of_each_stage(steps):
    """Names of the step groups that end a stage, in order."""
    names = sorted((name for name in steps if name.isdigit()), key=int)
    stages = [text(steps[name].attrs.get("stage", "")) for name in names]
    return [name for k, name in enumerate(names) if k + 1 == len(names) or stages[k] != stages[k + 1]]


def steps_of_motion(steps):
    """Names of the step groups in order, without the mechanism of a collapse, which is a direction and no state."""
    names = sorted((name for name in steps if name.isdigit()), key=int)
    return [name for name in names if not text(steps[name].attrs.get("stage", "")).endswith(MECHANISM)]


@dataclass
class Frame:
    """What the motion is drawn from, of one recorded step."""
    number: int
    stage: str
    time: float               # [s] or NaN
    displacement: np.ndarray  # [nodes, 2 or 3] m
    status: np.ndarray        # [points]
    loads: list


def read_frames(results, chosen):
    """Frames of the recorded steps with these numbers."""
    with h5py.File(results.folder / "fields.h5", "r") as file:
        steps, points = file["steps"], len(results.joints.area)
        names = steps_of_motion(steps)
        rows = []
        for k in chosen:
            group = steps[names[k]]
            status = group["joint_status"][()].astype(int).reshape(-1) if "joint_status" in group else np.full(points, BONDED)
            rows.append(Frame(int(group.attrs.get("step", names[k])), text(group.attrs.get("stage", "")), results.times[k],
                              group["displacement"][()], status, read_loads(group)))
        return rows


def largest_over_time(results):
    """Of every point over all recorded steps the widest gap and the longest slip [m], and the numbers of those steps."""
    points = len(results.joints.area)
    largest = {"gap": np.zeros(points), "slip": np.zeros(points)}
    when = {"gap": np.full(points, -1), "slip": np.full(points, -1)}
    with h5py.File(results.folder / "fields.h5", "r") as file:
        for k, name in enumerate(steps_of_motion(file["steps"])):
            group = file["steps"][name]
            status, selected = (group[f"joint_{key}"][()].reshape(-1) for key in ("status", "selected"))
            for key, among in (("gap", status == OPEN), ("slip", selected > 0)):
                size = np.where(among, np.abs(group[f"joint_{key}_m"][()].reshape(-1)), 0)
                wider = size > largest[key]
                largest[key][wider], when[key][wider] = size[wider], k
    return largest, when


def read_fields(path, results):
    with h5py.File(path, "r") as file:
        results.mesh = read_mesh(file)
        results.joints = read_joints(file)
        steps = file.get("steps", {})
        results.stage_ends = [read_step(name, steps[name], len(results.joints.area)) for name in last_of_each_stage(steps)]
        results.times = [float(steps[name].attrs.get("time_s", np.nan)) for name in steps_of_motion(steps)]
    if not results.stage_ends:
        results.remarks.append("fields.h5 holds no load step; only the undeformed structure is drawn.")


def read_title(path, results):
    for parameter in ElementTree.parse(path).getroot().findall("Parameter"):
        if parameter.get("name") == "title":
            results.title = parameter.get("value", "")


def read_result(path, results):
    content = json.loads(path.read_text(encoding="utf-8", errors="replace"))
    if not isinstance(content, dict):
        raise ValueError("the top level is not an object")
    results.result = content


def read_history(path, results):
    with open(path, newline="", encoding="utf-8", errors="replace") as file:
        results.history = list(csv.DictReader(file))


def read_margins(path, results):
    with open(path, newline="", encoding="utf-8", errors="replace") as file:
        results.margins = list(csv.DictReader(file))


def read_results(folder):
    """Everything that can be read in `folder`; the rest is named in `remarks`."""
    results = Results(Path(folder))
    for name, reader, loss in (
            ("result.json", read_result, "the summary of the run is incomplete"),
            ("history.csv", read_history, "there are no tables per load step"),
            ("fields.h5", read_fields, "no picture of the structure can be drawn"),
            ("joints.csv", read_margins, "there are no margins of joints"),
            ("scene.xml", read_title, "the title is taken from the name of the folder or of the scene")):
        path = results.folder / name
        if name == "result.json" and not path.exists():
            path = results.folder / "interrupted.json"  # what is known of a run that was stopped
        if not path.exists():
            if name == "joints.csv" and "hinges" not in (results.result.get("statics") or {}):
                continue  # a run that ends in time, or whose first step failed
            results.remarks.append(f"{name} is missing: {loss}.")
            continue
        try:
            reader(path, results)
        except UNREADABLE as problem:
            results.remarks.append(f"{name} could not be read ({problem}): {loss}.")
    scene = find(results.result, "title", "scene", "name")
    results.title = results.title or (Path(str(scene)).stem if scene else results.folder.resolve().name)
    return results

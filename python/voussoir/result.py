"""What a run left behind, as arrays: result.json, history.csv, joints.csv, fields.h5.

Units: m, N, Pa, J, s. Signs: gap > 0 open, normal force > 0 compression, stress > 0 tension. Every block has its own
nodes. What a key or a column means is said in src/output/README.md.
"""

import csv
import functools
import json
import pathlib

import numpy

from . import program

OPEN, STICK, SLIP, BONDED = 0, 1, 2, 3
MECHANISM = ": mechanism"  # ends the stage of a step that shows how a collapse begins: a direction, no state


def words(value):
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def number(value):
    """A number, or not a number where a cell is empty or holds a word."""
    try:
        return float(value)
    except (TypeError, ValueError):
        return numpy.nan


def table(path):
    """Columns of a CSV file by name: arrays of numbers where all cells are numbers or empty, else lists of words."""
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.reader(file)
        names = next(reader, [])
        rows = list(reader)
    columns = {}
    for k, name in enumerate(names):
        cells = [row[k] if k < len(row) else "" for row in rows]
        numbers = numpy.array([number(cell) for cell in cells])
        columns[name] = numbers if all(cell == "" or number(cell) == number(cell) for cell in cells) else cells
    return columns


class Mesh:
    """Nodes and cells of the blocks."""

    def __init__(self, file):
        group = file["mesh"]
        self.coordinates = group["coordinates"][()]  # [nodes, dim] m, as built
        self.cells = group["cells"][()].astype(int)  # [cells, 3, 4 or 8] nodes; one of fewer repeats its last node
        self.block_of_node = group["block_of_node"][()].astype(int).reshape(-1)
        self.block_of_cell = group["block_of_cell"][()].astype(int).reshape(-1)
        self.held = group["held"][()].reshape(-1) > 0  # nodes that a support holds
        self.blocks = int(self.block_of_node.max()) + 1
        self.sets = {}  # name -> numbers of its blocks
        if "block_sets" in group:
            names = [words(name) for name in numpy.atleast_1d(group["block_set_names"][()])]
            of_block = group["block_sets"][()].reshape(self.blocks, -1)
            self.sets = {name: numpy.flatnonzero((of_block == k).any(axis=1)) for k, name in enumerate(names)}

    @property
    def centres(self):
        """[blocks, dim] m, the mean of the nodes of each block."""
        return self.mean_of_blocks(self.coordinates)

    def mean_of_blocks(self, of_nodes):
        count = numpy.bincount(self.block_of_node, minlength=self.blocks)
        sums = [numpy.bincount(self.block_of_node, column, minlength=self.blocks) for column in of_nodes.T]
        return numpy.stack(sums, axis=1) / count[:, None]


class Joints:
    """Contact points, and the joints they make: pairs of blocks."""

    def __init__(self, file):
        group = file["joints"]
        self.position = group["position"][()]  # [points, dim] m
        self.normal = group["normal"][()]      # [points, dim], from block_i to block_j
        self.area = group["area"][()].reshape(-1)  # [points] m2
        self.block_i, self.block_j = (group[name][()].astype(int).reshape(-1) for name in ("block_i", "block_j"))
        both = numpy.stack([numpy.minimum(self.block_i, self.block_j), numpy.maximum(self.block_i, self.block_j)], axis=1)
        self.pairs, of_point = numpy.unique(both.reshape(-1, 2), axis=0, return_inverse=True)
        self.joint_of_point = of_point.reshape(-1)


class Step:
    """State at the end of a step; tables are read when they are asked for."""

    def __init__(self, result, name, attributes):
        self._result, self._name = result, name
        self.number = int(attributes.get("step", name))
        self.stage = words(attributes.get("stage", ""))
        self.load_factor = float(attributes.get("load_factor", numpy.nan))
        self.time = float(attributes.get("time_s", numpy.nan))  # [s], not a number for a load step
        self.is_mechanism = self.stage.endswith(MECHANISM)

    def field(self, name):
        """A table of this step by its name in fields.h5, None where there is none."""
        with self._result.fields() as file:
            group = file["steps"][self._name]
            return group[name][()] if name in group else None

    displacement = property(lambda self: self.field("displacement"))  # [nodes, dim] m
    velocity = property(lambda self: self.field("velocity"))          # [nodes, dim] m/s, in stages with a duration
    stress = property(lambda self: self.field("stress"))              # [cells, 3] Pa: xx, yy, xy; in space six
    gap = property(lambda self: self.field("joint_gap_m"))            # [points] m
    slip = property(lambda self: self.field("joint_slip_m"))          # [points] m
    normal_force = property(lambda self: self.field("joint_normal_force_N"))
    tangential_force = property(lambda self: self.field("joint_tangential_force_N"))
    status = property(lambda self: self.field("joint_status"))        # OPEN, STICK, SLIP or BONDED
    damage = property(lambda self: self.field("joint_damage"))

    @property
    def force(self):
        """[points, dim] N, of block_i on block_j."""
        given = self.field("joint_force_N")
        if given is not None:
            return given
        normal = self._result.joints.normal
        across = numpy.stack([-normal[:, 1], normal[:, 0]], axis=1)
        return self.normal_force.reshape(-1, 1) * normal + self.tangential_force.reshape(-1, 1) * across

    @property
    def joint_forces(self):
        """[joints, dim] N, of the lower block of each pair of `joints.pairs` on the other."""
        joints, force = self._result.joints, self.force
        sign = numpy.where(joints.block_i <= joints.block_j, 1.0, -1.0)
        return numpy.stack([numpy.bincount(joints.joint_of_point, sign * column, minlength=len(joints.pairs))
                            for column in force.T], axis=1)

    @property
    def block_motions(self):
        """Of every block the matrix [blocks, 4, 4] that carries it as built to where it is: a turn about its centre and
        a translation, the rigid motion nearest to that of its nodes."""
        mesh, dim = self._result.mesh, self._result.mesh.coordinates.shape[1]
        before = mesh.coordinates
        after = before + self.displacement
        centre, moved = mesh.centres, mesh.mean_of_blocks(after)
        motions = numpy.tile(numpy.eye(4), (mesh.blocks, 1, 1))
        order = numpy.argsort(mesh.block_of_node, kind="stable")
        ends = numpy.cumsum(numpy.bincount(mesh.block_of_node, minlength=mesh.blocks))
        for block, nodes in enumerate(numpy.split(order, ends[:-1])):
            turn = nearest_turn(before[nodes] - centre[block], after[nodes] - moved[block])
            motions[block, :dim, :dim] = turn
            motions[block, :dim, 3] = moved[block] - turn @ centre[block]
        return motions


def nearest_turn(before, after):
    """The rotation that carries one cloud of places nearest to another (Kabsch, Acta Cryst. A 32 (1976) 922)."""
    left, _, right = numpy.linalg.svd(after.T @ before)
    signs = numpy.ones(len(left))
    signs[-1] = numpy.sign(numpy.linalg.det(left @ right)) or 1.0
    return (left * signs) @ right


class Result:
    """The results in a folder; of a run that was stopped what was known by then."""

    def __init__(self, folder, code=None, said=""):
        self.folder, self.code, self.said = pathlib.Path(folder), code, said
        found = [path for path in (self.folder / "result.json", self.folder / "interrupted.json") if path.exists()]
        self.json = json.loads(found[0].read_text(encoding="utf-8")) if found else {}

    def __repr__(self):
        return f"<Result {self.folder}: {self.outcome}>"

    @property
    def outcome(self):
        """equilibrium, collapse, not_converged, out_of_range; interrupted where the run has not come to its end."""
        return self.json.get("outcome", "interrupted")

    message = property(lambda self: self.json.get("message", ""))
    warnings = property(lambda self: self.json.get("warnings", []))  # what the result leaves open
    collapse = property(lambda self: self.json.get("collapse"))      # of a search for a load factor, else None
    rigid = property(lambda self: self.json.get("rigid"))            # of limit analysis alone, else None
    load_factor = property(lambda self: self.json.get("load_factor"))

    @property
    def factor(self):
        """(largest factor that is found to stand, smallest that is excluded); None for an end that is not known."""
        found, borne = self.collapse or {}, (self.rigid or {}).get("forces_found_up_to")
        return found.get("lower") if borne is None else borne, found.get("upper")

    @property
    def reactions(self):
        """Force of each support on the structure in the last equilibrium of a run that ends in statics: name -> array [N]."""
        found = (self.json.get("statics") or {}).get("reactions") or {}
        return {name: numpy.array([number(force[key]) for key in ("x_N", "y_N", "z_N") if key in force])
                for name, force in found.items()}

    @functools.cached_property
    def history(self):
        """Columns of history.csv, a row a step."""
        path = self.folder / "history.csv"
        return table(path) if path.exists() else {}

    @functools.cached_property
    def joint_table(self):
        """Columns of joints.csv, a row a joint in the last equilibrium of a run that ends in statics."""
        path = self.folder / "joints.csv"
        return table(path) if path.exists() else {}

    def fields(self):
        """fields.h5, open for reading."""
        import h5py  # here, so that what reads tables alone needs no HDF5

        return h5py.File(self.folder / "fields.h5", "r")

    @functools.cached_property
    def mesh(self):
        with self.fields() as file:
            return Mesh(file)

    @functools.cached_property
    def joints(self):
        with self.fields() as file:
            return Joints(file)

    @functools.cached_property
    def steps(self):
        """All recorded steps in their order, without the mechanism of a collapse."""
        return [step for step in self._all_steps if not step.is_mechanism]

    @property
    def mechanism(self):
        """The motion a collapse begins with, the largest displacement being 1; None where there is none."""
        return next((step for step in reversed(self._all_steps) if step.is_mechanism), None)

    @functools.cached_property
    def _all_steps(self):
        if not (self.folder / "fields.h5").exists():
            return []
        with self.fields() as file:
            groups = file.get("steps", {})
            return [Step(self, name, dict(groups[name].attrs)) for name in sorted(groups, key=int)]

    @functools.cached_property
    def peaks(self):
        """The largest over all recorded steps: `slip_m` and `opening_m` of a contact point, `drift` of a node over the
        height of the structure, and `places`: of every observed place its largest displacement [m]."""
        history = self.history
        names = [name[len("ux_m of "):] for name in history if name.startswith("ux_m of ")]
        ways = {name: sum(history[column] ** 2 for column in (f"{axis}_m of {name}" for axis in ("ux", "uy", "uz"))
                          if column in history) for name in names}
        found = {"slip_m": 0.0, "opening_m": 0.0, "places": {name: float(numpy.sqrt(numpy.nanmax(square, initial=0)))
                                                              for name, square in ways.items()}}
        if not self.steps:
            return {**found, "slip_m": None, "opening_m": None, "drift": None}
        for step in self.steps:
            status = step.status.reshape(-1)
            for key, size in (("slip_m", numpy.where(status != BONDED, numpy.abs(step.slip.reshape(-1)), 0)),
                              ("opening_m", numpy.where(status == OPEN, step.gap.reshape(-1), 0))):
                found[key] = max(found[key], float(size.max(initial=0.0)))
        up = self.mesh.coordinates[:, -1]
        largest = numpy.nanmax(history.get("largest_displacement_m", numpy.array([0.0])), initial=0.0)
        return {**found, "drift": float(largest / (up.max() - up.min()))}

    def report(self):
        """Draws the report; its path."""
        path = program.make_report(self.folder)
        if path is None:
            raise program.ResourceError(f"{self.folder}: report\n  could not be made; report.log in that folder says why, "
                                        "or drivers/report of the repository is missing.")
        return path

    @property
    def pictures(self):
        """Pictures of the report by kind, such as `deformed` -> path of the PNG; the report is drawn when there are none."""
        if not (self.folder / "pictures").is_dir():
            self.report()
        return {path.stem: path for path in sorted((self.folder / "pictures").iterdir())
                if not path.stem.endswith("-narrow")}

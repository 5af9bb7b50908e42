"""Models of COMPAS: handed over as the JSON that compas_dem, compas_cra and compas_assembly write, and what was computed
handed back in the same form. COMPAS need not be installed.

    scene["mesh"] = compas.mesh("vault.json")
    result = scene.run()
    compas.hand_back(result, "vault.json", "vault-computed.json")

An Assembly comes back as it was, with `displacement` on its nodes (that of the centre, then a vector of rotation) and on its
edges interfaces with `forces`, as compas_cra leaves them. A BlockModel, or a Problem that holds one, comes back as the Results of
compas_dem: `transformation` of each block; of each pair `contact_data` with forces, `resultant_global` and what its viewer asks.
Forces are in N. The points of an interface are the contact points of the joint, in order around its middle; its frame has its
third axis along the mean normal from the first block of the edge to the second, and forces are those of the first on the second.
"""

import json
import pathlib
import uuid

import numpy

from . import program

GUID = 36  # letters of a key that a machine made; the program numbers such stones
STATUS = ("open", "stick", "slip", "bonded")


def mesh(path, **options):
    """The section `mesh` of a scene for a file of COMPAS; options are further keys, such as unit=0.001, up="z"."""
    return {"type": "stones", "stones": {"file": str(pathlib.Path(path).resolve()),
                                         **{key.replace("_", " "): value for key, value in options.items()}}}


def read(path):
    try:
        document = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as problem:
        raise program.InputError(f"{path}\n  cannot be read as JSON ({problem}).\n  Give what compas.json_dump has written.") from None
    return document


def data_of(value):
    """What an object of COMPAS holds, whether it is wrapped in its type or not."""
    return value["data"] if isinstance(value, dict) and "data" in value and "dtype" in value else value


def model_in(document):
    """The Assembly or BlockModel in a document, with its kind: the outermost object that has a graph."""
    data = data_of(document)
    if isinstance(data, dict):
        if "graph" in data:
            return ("blocks" if "elements" in data else "assembly"), document, data
        for child in data.values():
            found = model_in(child) if isinstance(child, dict) else None
            if found:
                return found
    return None


class Model:
    """Blocks of a document and how the program calls them."""

    def __init__(self, path):
        self.path, self.document = path, read(path)
        found = model_in(self.document)
        if not found:
            raise program.InputError(f"{path}\n  holds no Assembly and no BlockModel (nothing with a graph of blocks)\n"
                                     "  so that there is nothing to hand results back to.")
        self.kind, self.root, self.data = found
        self.graph = data_of(self.data["graph"])
        self.nodes = list(self.graph["node"])
        if self.kind == "assembly":
            shapes = {node: data_of(values["block"]) for node, values in self.graph["node"].items() if values.get("block")}
            self.names = {node: node for node in shapes}
        else:
            order = {guid: k for k, guid in enumerate(self.data["elements"])}
            elements = {node: values["element"] for node, values in self.graph["node"].items() if values.get("element") in order}
            shapes = {node: None for node in elements}
            self.names = {node: str(order[guid]) if len(guid) == GUID else guid for node, guid in elements.items()}
        self.shapes = shapes

    def blocks_of(self, result):
        """Node of the graph -> number of the block."""
        found = {}
        for node, name in self.names.items():
            blocks = result.mesh.sets.get(name, [])
            if len(blocks) != 1:
                raise program.InputError(f"{self.path}: block {name}\n  is no stone of {result.folder}\n"
                                         "  Give the file that this result was computed from.")
            found[node] = int(blocks[0])
        return found


def scale_of(result):
    """[m] length that the file calls 1; refused where the file was turned as it was read."""
    from .scene import Scene

    scene = Scene.read(result.folder / "scene.xml")
    if scene["mesh/type"] != "stones" or scene["mesh/stones/up"] not in ("usual", "z"):
        raise program.InputError(f"{result.folder}: mesh\n  was not read from a file of COMPAS with up = z\n"
                                 "  so that places cannot be handed back in its axes.")
    return scene["mesh/stones/unit"]


def frame_of(normal, middle):
    """Frame of a joint as COMPAS writes it, and its three axes: the third along the normal."""
    across = numpy.eye(3)[numpy.argmin(numpy.abs(normal))]
    first = numpy.cross(across, normal)
    first /= numpy.linalg.norm(first)
    second = numpy.cross(normal, first)
    return typed("compas.geometry/Frame", {"point": middle.tolist(), "xaxis": first.tolist(), "yaxis": second.tolist()}), \
        numpy.stack([first, second, normal])


def typed(kind, data):
    return {"dtype": kind, "data": data, "guid": str(uuid.uuid4())}


class Interface:
    """What a pair of blocks carries, seen from the first to the second, lengths in the unit of the file."""

    def __init__(self, result, step, pair, first, unit):
        joints = result.joints
        points = numpy.flatnonzero(joints.joint_of_point == pair)
        sign = numpy.where(joints.block_i[points] == first, 1.0, -1.0)[:, None]
        normal = (sign * joints.normal[points] * joints.area[points][:, None]).sum(axis=0)
        normal /= numpy.linalg.norm(normal)
        places = joints.position[points] / unit
        middle = places.mean(axis=0)
        self.frame, axes = frame_of(normal, middle)
        around = numpy.argsort(numpy.arctan2(*((places - middle) @ axes[:2].T).T[::-1]))
        points, sign = points[around], sign[around]
        self.points = places[around]
        self.vectors = sign * step.force[points]
        self.local = self.vectors @ axes.T  # along the first, the second axis, the normal
        self.size = float(joints.area[points].sum() / unit**2)
        self.gap = (step.gap.reshape(-1)[points] / unit).tolist()
        self.status = [STATUS[int(status)] for status in step.status.reshape(-1)[points]]
        self.forces = [{"c_np": max(n, 0.0), "c_nn": max(-n, 0.0), "c_u": u, "c_v": v} for u, v, n in self.local.tolist()]


def rotation_vector(turn):
    """Axis times angle of a rotation, from its unsymmetric part; angles of stones are small against half a turn."""
    skew = numpy.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2
    sine = numpy.linalg.norm(skew)
    return skew if sine == 0 else skew * numpy.arctan2(sine, (numpy.trace(turn) - 1) / 2) / sine


def pairs_of(result, blocks):
    """(node, node, number of the pair, block of the first node) of all pairs that touch."""
    node_of = {block: node for node, block in blocks.items()}
    for pair, (i, j) in enumerate(result.joints.pairs.tolist()):
        if i in node_of and j in node_of:
            yield node_of[i], node_of[j], pair, i


def fill_assembly(model, result, step, unit, blocks, motions):
    edges = model.graph.setdefault("edge", {})
    centres = result.mesh.centres
    for node, block in blocks.items():
        turn, centre = motions[block][:3, :3], centres[block]
        way = (turn @ centre + motions[block][:3, 3] - centre) / unit
        model.graph["node"][node]["displacement"] = [*way.tolist(), *rotation_vector(turn).tolist()]
    for first, second, pair, block in pairs_of(result, blocks):
        if first in edges.get(second, {}):  # the edge runs the other way
            first, second, block = second, first, blocks[second]
        joint = Interface(result, step, pair, block, unit)
        kept = edges.setdefault(first, {}).setdefault(second, {})
        kept["interfaces"] = [typed("compas_assembly.datastructures/Interface", {
            "points": joint.points.tolist(), "type": "face_face", "size": joint.size, "frame": joint.frame, "forces": joint.forces,
            "mesh": None, "viewmesh": None, "interaction": None})]
        for one, other in ((first, second), (second, first)):
            if "adjacency" in model.graph:
                model.graph["adjacency"].setdefault(one, {})[other] = None
    return model.document


def results_document(model, result, step, unit, blocks, motions):
    nodes, edges = {}, {}
    for node, block in blocks.items():
        matrix = motions[block].copy()
        matrix[:3, 3] /= unit
        nodes[node] = {"transformation": typed("compas.geometry/Transformation", {"matrix": matrix.tolist()})}
    for first, second, pair, block in pairs_of(result, blocks):
        joint = Interface(result, step, pair, block, unit)
        force, local = joint.vectors.sum(axis=0), joint.local.sum(axis=0)
        points = joint.points.tolist()
        contact = {"points": [typed("compas.geometry/Point", point) for point in points], "frame": joint.frame, "size": joint.size,
                   "mesh": None, "name": "FrictionContact", "forces": joint.forces}
        edges[f"{first},{second}"] = {
            "contact_data": typed("compas_dem.interactions/FrictionContact", contact), "face_contact": True,
            "contact_points": points, "contact_polygon": typed("compas.geometry/Polygon", {"points": points}),
            "contact_frame": joint.frame, "resultant_global": force.tolist(), "resultant_local": local.tolist(),
            "force_magnitude": float(numpy.linalg.norm(force)), "force_vector": joint.vectors.tolist(),
            "force_normal": joint.local[:, 2].tolist(), "force_tangent1": joint.local[:, 0].tolist(),
            "force_tangent2": joint.local[:, 1].tolist(), "gap": joint.gap, "status": joint.status}
    return typed("compas_dem.problem/Results", {
        "model_id": model.root.get("guid", ""), "problem_id": data_of(model.document).get("guid", "") or "", "displacement_scale": 1.0,
        "node_data": nodes, "edge_data": edges,
        "metadata": {"solver": "Voussoir", "outcome": result.outcome, "stage": step.stage, "load_factor": step.load_factor}})


def hand_back(result, model, path, step=-1):
    """Writes what was computed in the form that the file of the model has; the path.

    @param model  the file that the scene was computed from
    @param step   a number in result.steps, or a Step
    """
    if not result.steps:
        raise program.InputError(f"{result.folder}: fields.h5\n  holds no step, so that there is nothing to hand back.")
    unit, model = scale_of(result), Model(model)
    step = result.steps[step] if isinstance(step, int) else step
    write = fill_assembly if model.kind == "assembly" else results_document
    document = write(model, result, step, unit, model.blocks_of(result), step.block_motions)
    program.write_atomically(path, json.dumps(document))
    return pathlib.Path(path)

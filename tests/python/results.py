"""Runs and results in Python: what is read is what the program wrote, stones become drawings, COMPAS gets its own form back.

    results.py PROGRAM MPIEXEC
"""

import json
import pathlib
import sys
import threading
import _thread

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402
import sweeps  # noqa: E402

voussoir = sweeps.package()
from voussoir import compas, stones  # noqa: E402

WEIGHT = 9.81 * 2000  # N/m3


def posed(mesh, support, friction=0.6):
    """A scene of stones under their own weight."""
    scene = voussoir.Scene("posed")
    scene["mesh"] = mesh
    scene["materials/stone"] = {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000}
    scene["joints/dry/friction coefficient"] = friction
    scene["supports/ground"] = support
    scene["loads/weight/type"] = "self weight"
    scene["steps/stages/own weight/loads/weight"] = 1
    return scene


class Runs(sweeps.SweepTest):
    def test_arrays_are_what_the_program_wrote(self):
        scene = voussoir.Scene.read(self.write(sweeps.wall(factor=sweeps.FACTOR)))
        lines = []
        result = scene.run(out=self.folder / "out", progress=lines.append, ranks=2)
        self.assertEqual((result.outcome, result.code), ("collapse", 0))
        self.assertIn("Collapse: ", "\n".join(line.line for line in lines))
        self.assertEqual(result.factor, (result.json["collapse"]["lower"], result.json["collapse"]["upper"]))
        step, mesh = result.steps[-1], result.mesh
        self.assertEqual(step.displacement.shape, mesh.coordinates.shape)
        self.assertAlmostEqual(numpy.linalg.norm(step.displacement, axis=1).max(), result.history["largest_displacement_m"][-1], places=12)
        self.assertIsNotNone(result.mechanism)
        # Forces of joints and of the support hold every stone: its weight, the push, and what its neighbours give.
        weight = WEIGHT * 0.2 * 2 * 0.5 * 0.75 / 2  # two stones a course, three courses
        self.assertAlmostEqual(result.reactions["ground"][1] / (2 * weight), 1, places=6)
        below = {0, 1}
        upward = sum(force[1] for (i, j), force in zip(result.joints.pairs.tolist(), step.joint_forces) if i in below and j not in below)
        self.assertAlmostEqual(upward / (2 * weight * 2 / 3), 1, places=6)

    def test_motions_of_blocks_are_rigid_and_carry_their_nodes(self):
        result = voussoir.Scene.read(self.write(sweeps.wall(factor=sweeps.FACTOR))).run(out=self.folder / "out")
        step, mesh = result.mechanism, result.mesh  # stones move as rigid bodies, the farthest by 1 m
        small = 1e-6
        class Small:  # the mechanism is a direction: a small motion of it is one of stones
            displacement = small * step.displacement
            _result = result
        motions = type(step).block_motions.fget(Small)
        for block in range(mesh.blocks):
            nodes = mesh.block_of_node == block
            places = mesh.coordinates[nodes] @ motions[block, :2, :2].T + motions[block, :2, 3]
            self.assertLess(numpy.abs(places - mesh.coordinates[nodes] - Small.displacement[nodes]).max(), 1e-3 * small)
            self.assertAlmostEqual(numpy.linalg.det(motions[block, :2, :2]), 1, places=12)

    def test_a_callback_that_fails_stops_the_run_which_goes_on_later(self):
        scene = voussoir.Scene.read(self.write(sweeps.wall(time=sweeps.SHAKEN)))
        scene["steps/stages/rest/duration"] = 0.4

        def fail(progress):
            if "stage 'rest'" in progress.line:
                raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            scene.run(out=self.folder / "out", progress=fail)
        stopped = voussoir.Result(self.folder / "out")
        self.assertEqual(stopped.outcome, "interrupted")
        result = scene.run(out=self.folder / "out", restart=True)
        self.assertEqual((result.outcome, len(result.history["step"])), ("equilibrium", 401))

    def test_ctrl_c_lets_the_program_save(self):
        scene = voussoir.Scene.read(self.write(sweeps.wall(time=sweeps.SHAKEN)))
        scene["steps/stages/rest/duration"] = 4
        begun = threading.Event()

        def interrupt(progress):
            if "stage 'rest'" in progress.line and not begun.is_set():
                begun.set()
                threading.Timer(0.2, _thread.interrupt_main).start()

        with self.assertRaises(KeyboardInterrupt):
            scene.run(out=self.folder / "out", progress=interrupt)
        self.assertTrue((self.folder / "out/checkpoint.h5").exists())

    def test_a_refusal_is_an_error_with_its_words(self):
        with self.assertRaisesRegex(voussoir.InputError, "must be >= 0"):
            voussoir.run(self.write(sweeps.wall()), out=self.folder / "out", set={"joints/dry/friction coefficient": -1})

    def test_pictures_are_those_of_the_report(self):
        result = voussoir.run(self.write(sweeps.wall()), out=self.folder / "out")
        self.assertIn("structure", result.pictures)
        self.assertTrue((self.folder / "out/report.html").exists())

    def test_meshio_gets_stones_with_their_fields(self):
        import meshio

        result = voussoir.run(self.write(sweeps.wall()), out=self.folder / "out")
        from voussoir import export
        export.to_meshio(result).write(self.folder / "out.vtu")
        back = meshio.read(self.folder / "out.vtu")
        self.assertEqual(len(back.points), len(result.mesh.coordinates))
        self.assertEqual(float(abs(back.point_data["displacement"][:, 1]).max()), float(abs(result.steps[-1].displacement[:, 1]).max()))


class Drawings(sweeps.SweepTest):
    def test_polygons_that_fit_to_a_millimetre_stand(self):
        drawn = stones.Stones(snap=0.003)
        drawn.rectangle(0, 0, 2, 0.2, "slab")
        drawn.polygon([(0.2, 0.2), (0.7, 0.201), (0.7, 0.7), (0.2, 0.7)], "left", "jambs")
        drawn.polygon([(1.301, 0.2), (1.8, 0.2), (1.8, 0.7), (1.3, 0.699)], "right", "jambs")
        drawn.polygon([(0.2, 0.7), (1.8, 0.7), (1.8, 1), (0.2, 1)], "lintel")
        drawn.edges("ground", lambda x, y: y < 0.01)
        scene = posed(drawn.write(self.folder / "door.geo", element_size=0.1), {"on": "ground"})
        self.assertIn("4 blocks", scene.validate())
        result = scene.run(out=self.folder / "out")
        self.assertEqual(result.outcome, "equilibrium")
        self.assertEqual(len(result.joints.pairs), 4)
        self.assertEqual(result.mesh.sets["jambs"].tolist(), [1, 2])
        self.assertTrue(0.0003 < drawn.moved < 0.003)
        # The lintel weighs 1.6 m x 0.3 m and lies on both jambs alike, to what was moved.
        lintel = [force[1] for (i, j), force in zip(result.joints.pairs.tolist(), result.steps[-1].joint_forces) if j == 3]
        self.assertAlmostEqual(sum(lintel) / (WEIGHT * 1.6 * 0.3), 1, delta=0.002)
        self.assertAlmostEqual(lintel[0] / lintel[1], 1, delta=0.02)

    def test_corners_as_they_are_are_fitted_together_by_the_program(self):
        drawn = stones.Stones(snap=0.003)
        drawn.rectangle(0, 0, 2, 0.2, "slab", "lower")
        drawn.polygon([(0.2, 0.2), (0.7, 0.201), (0.7, 0.7), (0.2, 0.7)], "left", "jambs")
        drawn.polygon([(1.301, 0.2), (1.8, 0.2), (1.8, 0.7), (1.3, 0.699)], "right", "jambs")
        drawn.polygon([(0.2, 0.7), (1.8, 0.7), (1.8, 1), (0.2, 1)], "lintel")
        scene = posed(drawn.write(self.folder / "door.csv", element_size=0.1), {"on": "base", "blocks": "lower"})
        self.assertIn("snap 0.003 m", scene.validate())
        result = scene.run(out=self.folder / "out")
        self.assertEqual(result.outcome, "equilibrium")
        self.assertEqual(len(result.joints.pairs), 4)
        self.assertEqual(result.mesh.sets["jambs"].tolist(), [1, 2])
        lintel = [force[1] for (i, j), force in zip(result.joints.pairs.tolist(), result.steps[-1].joint_forces) if j == 3]
        self.assertAlmostEqual(sum(lintel) / (WEIGHT * 1.6 * 0.3), 1, delta=0.002)

    def test_what_a_table_of_corners_cannot_hold_is_refused(self):
        two = stones.Stones()
        two.rectangle(0, 0, 1, 1, "a", ["one", "other"])
        held = stones.Stones()
        held.rectangle(0, 0, 1, 1, "a")
        held.edges("ground", lambda x, y: y < 0.01)
        named = stones.Stones()
        named.rectangle(0, 0, 1, 1, "a, b")
        for drawn, words in ((two, "in the sets one and other"), (held, "edges ground"), (named, "cannot be a name")):
            with self.assertRaisesRegex(voussoir.InputError, words):
                drawn.write(self.folder / "a.csv")

    def test_what_is_no_stone_is_refused(self):
        drawn = stones.Stones()
        drawn.rectangle(0, 0, 1, 1, "a")
        for wrong in (lambda: drawn.rectangle(2, 0, 1, 1, "a"), lambda: drawn.polygon([(0, 0), (1, 1)]),
                      lambda: drawn.polygon([(0, 0), (1, 1), (2, 2)]), lambda: drawn.box((0, 0, 0), (1, 1, 1)),
                      lambda: drawn.write(self.folder / "a.obj"), lambda: stones.Stones().write(self.folder / "a.geo")):
            with self.assertRaises(voussoir.InputError):
                wrong()

    def test_boxes_in_space_stand(self):
        drawn = stones.Stones()
        drawn.box((0, 0, 0), (1, 1, 0.2), "slab")
        drawn.box((0.2, 0.2, 0.2), (0.5, 0.5, 0.5), "cube")
        scene = posed(drawn.write(self.folder / "cube.obj", element_size=0.25), {"blocks": "slab", "on": "base"})
        result = scene.run(out=self.folder / "out")
        self.assertEqual(result.outcome, "equilibrium")
        force = result.steps[-1].joint_forces[0] * (1 if result.mesh.sets["slab"][0] == 0 else -1)
        self.assertAlmostEqual(force[2] / (WEIGHT * 0.125), 1, places=5)


def box_mesh(low, high):
    """A box as COMPAS writes a mesh."""
    corners = [(x, y, z) for z in (low[2], high[2]) for x, y in ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]))]
    faces = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    return {"attributes": {}, "vertex": {str(k): dict(zip("xyz", corner)) for k, corner in enumerate(corners)},
            "face": {str(k): list(face) for k, face in enumerate(faces)}, "facedata": {}, "edgedata": {}, "max_vertex": 7, "max_face": 5}


def assembly(boxes, edges=()):
    """An Assembly as compas_assembly writes it; the first block is a support."""
    nodes = {name: {"block": {"dtype": "compas_assembly.datastructures/Block", "data": box_mesh(*box)}, "is_support": k == 0}
             for k, (name, box) in enumerate(boxes.items())}
    edge = {name: {} for name in boxes}
    for u, v in edges:
        edge[u][v] = {"interfaces": []}
    graph = {"attributes": {}, "node": nodes, "edge": edge, "adjacency": {name: {} for name in boxes}, "max_node": len(boxes)}
    return {"dtype": "compas_assembly.datastructures/Assembly",
            "data": {"attributes": {"name": "Assembly"}, "graph": {"dtype": "compas.datastructures/Graph", "data": graph}}, "guid": "g"}


def block_model(boxes):
    """A BlockModel as compas_dem writes it."""
    guids = [f"{k:08d}-0000-4000-8000-000000000000" for k in range(len(boxes))]
    elements = {guid: {"dtype": "compas_dem.elements/Block", "guid": guid,
                       "data": {"transformation": None, "features": [], "name": "Block", "is_support": k == 0,
                                "geometry": {"dtype": "compas.datastructures/Mesh", "data": box_mesh(*box)}}}
                for k, (guid, box) in enumerate(zip(guids, boxes))}
    nodes = {str(k): {"element": guid} for k, guid in enumerate(guids)}
    return {"dtype": "compas_dem.models/BlockModel", "guid": "the model",
            "data": {"transformation": None, "elements": elements, "tree": {}, "graph": {"node": nodes, "edge": {}}}}


def carried(points, frame, forces):
    """Force and moment about the origin of an interface as COMPAS reads it: the first block on the second."""
    x, y = numpy.array(frame["data"]["xaxis"]), numpy.array(frame["data"]["yaxis"])
    vectors = [(f["c_np"] - f["c_nn"]) * numpy.cross(x, y) + f["c_u"] * x + f["c_v"] * y for f in forces]
    return numpy.sum(vectors, axis=0), numpy.sum([numpy.cross(place, force) for place, force in zip(points, vectors)], axis=0)


class Compas(sweeps.SweepTest):
    BOXES = {"7": ((0, 0, 0), (100, 100, 20)), "3": ((10, 10, 20), (60, 60, 70)), "5": ((10, 20, 70), (60, 70, 100))}  # cm
    WEIGHTS = [WEIGHT * volume for volume in (0.2, 0.125, 0.075)]

    def computed(self, document):
        path = self.folder / "model.json"
        path.write_text(json.dumps(document), encoding="utf-8")
        scene = posed(compas.mesh(path, unit=0.01, element_size=0.25), {"blocks": "supports", "on": "base"})
        result = scene.run(out=self.folder / "out")
        self.assertEqual(result.outcome, "equilibrium", result.said)
        return json.loads(compas.hand_back(result, path, self.folder / "back.json").read_text(encoding="utf-8"))

    def test_an_assembly_comes_back_with_forces_and_displacements(self):
        given = assembly(self.BOXES, edges=[("3", "7")])  # from the upper block to the lower
        back = self.computed(given)
        self.assertEqual((back["dtype"], back["guid"]), (given["dtype"], "g"))
        graph = back["data"]["graph"]["data"]
        self.assertEqual(list(graph["node"]), ["7", "3", "5"])
        self.assertEqual(sorted(len(node["displacement"]) for node in graph["node"].values()), [6, 6, 6])
        self.assertLess(graph["node"]["5"]["displacement"][2], graph["node"]["3"]["displacement"][2])
        lower = graph["edge"]["3"]["7"]["interfaces"][0]["data"]
        upper = (graph["edge"]["3"].get("5") or graph["edge"]["5"]["3"])["interfaces"][0]["data"]
        force, moment = carried(lower["points"], lower["frame"], lower["forces"])
        weight = self.WEIGHTS[1] + self.WEIGHTS[2]
        self.assertLess(abs(force - (0, 0, -weight)).max(), 1e-5 * weight)  # the upper block presses on the lower
        # The weight of both passes where their common centre is: moments in N cm.
        self.assertLess(abs(moment[0] - -(self.WEIGHTS[1] * 35 + self.WEIGHTS[2] * 45)), 1e-4 * weight * 100)
        force, _ = carried(upper["points"], upper["frame"], upper["forces"])
        self.assertLess(abs(abs(force[2]) - self.WEIGHTS[2]), 1e-5 * weight)
        self.assertAlmostEqual(lower["size"], 2500, places=6)  # cm2

    def test_a_block_model_comes_back_as_results(self):
        back = self.computed(block_model(self.BOXES.values()))
        self.assertEqual(back["dtype"], "compas_dem.problem/Results")
        data = back["data"]
        self.assertEqual((data["model_id"], sorted(data["node_data"]), sorted(data["edge_data"])), ("the model", ["0", "1", "2"], ["0,1", "1,2"]))
        edge = data["edge_data"]["0,1"]
        weight = self.WEIGHTS[1] + self.WEIGHTS[2]
        self.assertLess(abs(numpy.array(edge["resultant_global"]) - (0, 0, weight)).max(), 1e-5 * weight)
        contact = edge["contact_data"]["data"]
        force, _ = carried([point["data"] for point in contact["points"]], contact["frame"], contact["forces"])
        self.assertLess(abs(force - edge["resultant_global"]).max(), 1e-9 * weight)
        self.assertEqual(len(contact["forces"]), len(edge["gap"]))
        matrix = numpy.array(data["node_data"]["1"]["transformation"]["data"]["matrix"])
        self.assertLess(abs(matrix - numpy.eye(4)).max(), 1e-2)
        self.assertLess(matrix[2, 3], 0)


if __name__ == "__main__":
    program.main()

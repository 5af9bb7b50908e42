"""Volumes of gmsh, each a stone: drawings (.geo) and finished meshes (.msh), kept as they are where they fit.

usage: gmsh_volumes.py PROGRAM MPIEXEC

Set-up    Two stones on a longer one, drawn one by one and with common faces, and written as meshes of hexahedra and of
          tetrahedra; the same from OBJ. A stone turned off all axes, held along the normals of three of its faces.
Expected  Meshes that match node to node are kept, others are made anew from their outlines, with hexahedra for boxes; both
          as the stones of OBJ, whose hexahedra are the same. Physical groups are sets. Lengths in millimetres, ranks and
          parts change nothing. Each of three faces bears what of the weight lies along its normal. What is inside out is
          turned and said; stones in each other, cells that are inverted, pieces, surfaces that are not closed, groups that
          bound nothing and cells of the second order are refused by volume and place.
Tolerance Reactions 1e-8 of the weight, the tolerance of the solver; motions 1e-6 of the largest.
"""

import itertools
import math
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import solids  # noqa: E402
from stones import xml  # noqa: E402

DENSITY, GRAVITY = 2000.0, 9.81
BOXES = {"lower": ((0, 0, 0), (1, 0.5, 0.5)), "west": ((0, 0, 0.5), (0.5, 0.5, 1)), "east": ((0.5, 0, 0.5), (1, 0.5, 1))}
WEIGHT = 0.5 * DENSITY * GRAVITY
KEPT, ANEW = "as the file has them meshed", "volumes are meshed anew"


def scene(file, supports=None, mesh=None, loads=None, stages=None, **sections):
    tree = {"mesh": {"type": "stones", "stones": {"file": file, **(mesh or {})}},
            "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": DENSITY}},
            "joints": {"dry": {"friction coefficient": 0.6}},
            "supports": supports or {"ground": {"on": "bed"}},
            "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, **(loads or {})},
            "steps": {"stages": stages or {"own weight": {"loads": {"weight": 1.0}}}}, **sections}
    return xml("volumes", tree) + "\n"


SEEN = {"west": {"place": "mean", "blocks": "west"}}


def geo(common, size=0.25, boxes=None, unit=1.0, more=""):
    """A drawing of boxes by the kernel of solids, with common faces or each with its own."""
    text = 'SetFactory("OpenCASCADE");\n'
    boxes = boxes or BOXES
    for k, (low, high) in enumerate(boxes.values(), start=1):
        sides = [h - l for l, h in zip(low, high)]
        text += f"Box({k}) = {{{', '.join(repr(float(c / unit)) for c in (*low, *sides))}}};\n"
    if common:
        text += f"BooleanFragments{{ Volume{{{', '.join(map(str, range(1, len(boxes) + 1)))}}}; Delete; }}{{}}\n"
    for k, name in enumerate(boxes, start=1):
        text += f'Physical Volume("{name}") = {{{k}}};\n'
    e = 1e-3 / unit
    corner = ", ".join(repr(c) for c in (-e, -e, -e, 1 / unit + e, 0.5 / unit + e, e))
    return text + f'Physical Surface("bed") = Surface In BoundingBox{{{corner}}};\nMesh.MeshSizeMax = {size / unit!r};\n' + more


def lattice(low, high, cells, tetrahedra=False):
    """Nodes and cells of a box."""
    steps = [[l + (h - l) * k / n for k in range(n + 1)] for l, h, n in zip(low, high, cells)]
    nodes = list(itertools.product(*steps))
    number = {index: k for k, index in enumerate(itertools.product(*(range(n + 1) for n in cells)))}
    out = []
    for i, j, k in itertools.product(*(range(n) for n in cells)):
        corner = [number[i + a, j + b, k + c] for a, b, c in
                  ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
        if not tetrahedra:
            out.append(corner)
            continue
        for axes in itertools.permutations(range(3)):  # six round the diagonal, the same on both sides of a face
            at, chain = [0, 0, 0], [number[i, j, k]]
            for axis in axes:
                at[axis] = 1
                chain.append(number[i + at[0], j + at[1], k + at[2]])
            even = axes in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
            out.append(chain if even else [chain[1], chain[0], *chain[2:]])
    return nodes, out


def msh(stones, bed=True):
    """A mesh of format 2.2 of stones with nodes of their own: {name: (nodes, cells)}; the faces at z = 0 are the bed."""
    names = [f'3 {k} "{name}"' for k, name in enumerate(stones, start=1)] + (['2 100 "bed"'] if bed else [])
    nodes, elements = [], []
    for k, (places, cells) in enumerate(stones.values(), start=1):
        first = len(nodes) + 1
        nodes += places
        for cell in cells:
            elements.append((5 if len(cell) == 8 else 4, k, k, [first + n for n in cell]))
        for cell in cells:
            sides = [(0, 1, 2, 3)] if len(cell) == 8 else [(0, 1, 2), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
            for side in sides:
                if bed and all(places[cell[c]][2] == 0 for c in side):
                    elements.append((3 if len(side) == 4 else 2, 100, 100, [first + cell[c] for c in side]))
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names, "$EndPhysicalNames", "$Nodes",
             str(len(nodes))]
    lines += [f"{n} {' '.join(map(repr, map(float, x)))}" for n, x in enumerate(nodes, start=1)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{n} {kind} 2 {group} {entity} {' '.join(map(str, of))}" for n, (kind, group, entity, of) in enumerate(elements, start=1)]
    return "\n".join([*lines, "$EndElements"]) + "\n"


def meshes(tetrahedra=False, boxes=None):
    return {name: lattice(low, high, [round((h - l) / 0.25) for l, h in zip(low, high)], tetrahedra)
            for name, (low, high) in (boxes or BOXES).items()}


class Volumes(program.SceneTest):
    def run_file(self, text, ending, *options, scene_of=None, **more):
        (self.folder / f"stones{ending}").write_text(text, encoding="utf-8")
        return self.run_scene(scene_of or scene(f"stones{ending}"), *options, **more)

    def check_weight(self, run, weight=WEIGHT, support="ground"):
        self.assertEqual(run.outcome, "equilibrium", run.said)
        found = run.result["statics"]["reactions"][support]
        self.assertLess(abs(found["z_N"] - weight), 1e-8 * weight, run.said)

    def compare(self, one, other):
        ours, theirs = ([run.history[-1][f"u{c}_m of west"] for c in "xyz"] for run in (one, other))
        for a, b in zip(ours, theirs):
            self.assertLess(abs(a - b), 1e-6 * max(map(abs, ours)), (ours, theirs))

    def test_hexahedra_of_a_mesh_are_those_of_the_same_stones(self):
        seen = {"observations": SEEN}
        kept = self.run_file(msh(meshes()), ".msh", scene_of=scene("stones.msh", **seen), out="kept")
        self.assertIn(KEPT, kept.words)
        self.assertIn("0 tetrahedra, 32 hexahedra", kept.words)
        self.assertEqual(kept.warnings, [])
        self.check_weight(kept)
        drawn = {name: solids.box(*box) for name, box in BOXES.items()}
        obj = self.run_file(solids.obj(drawn), ".obj", out="obj",
                            scene_of=scene("stones.obj", {"ground": {"on": "base"}}, {"element size": 0.25}, **seen))
        self.check_weight(obj)
        self.compare(kept, obj)
        anew = self.run_file(geo(False), ".geo", out="anew", scene_of=scene("stones.geo", mesh={"element size": 0.25}, **seen))
        self.assertIn(ANEW, anew.words)
        self.assertIn("match node to node", anew.words)
        self.assertIn("3 stones of hexahedra", anew.words)
        self.check_weight(anew)
        self.compare(kept, anew)

    def test_ranks_and_parts_change_nothing(self):
        two = {"own weight": {"loads": {"weight": 1.0}}, "push": {"loads": {"weight": 1.0, "push": 1.0}}}
        push = {"push": {"type": "acceleration", "ax": 0.2 * GRAVITY}}
        text = scene("stones.msh", loads=push, stages=two, observations=SEEN)
        one = self.run_file(msh(meshes(True)), ".msh", scene_of=text, out="one")
        self.assertIn("0 hexahedra", one.words)
        self.assertIn(KEPT, one.words)
        self.check_weight(one)
        both = self.run_scene(text, out="both", ranks=2)
        self.check_weight(both)
        self.compare(one, both)
        self.run_scene(scene("stones.msh", loads=push, observations=SEEN), out="first")
        parts = self.run_scene(text, f"--restart-from={self.folder / 'first'}", out="second")
        self.check_weight(parts)
        self.compare(one, parts)

    def test_a_drawing_with_common_faces_keeps_the_mesh_of_gmsh(self):
        run = self.run_file(geo(True), ".geo", out="metres")
        self.assertIn(KEPT, run.words)
        self.assertIn("3 pairs of stones share 0.75 m2", run.words)
        self.check_weight(run)
        small = self.run_file(geo(True, unit=1e-3), ".geo", out="millimetres", scene_of=scene("stones.geo", mesh={"unit": 1e-3}))
        self.assertIn(KEPT, small.words)
        self.check_weight(small)
        finer = self.run_file(geo(True), ".geo", out="finer", scene_of=scene("stones.geo", mesh={"element size": 0.1}))
        self.assertGreater(self.cells(finer), 1.5 * self.cells(run))

    @staticmethod
    def cells(run):
        return int(re.search(r"nodes, (\d+) tetrahedra", run.words).group(1))

    def test_a_drawing_takes_numbers(self):
        text = geo(True).replace("Box(1)", "DefineConstant[ deep = 0.5 ];\nBox(1)").replace(
            "{0.0, 0.0, 0.0, 1.0, 0.5, 0.5}", "{0.0, 0.0, 0.5 - deep, 1.0, 0.5, deep}").replace("{-0.001, -0.001, -0.001", "{-1, -1, -0.501").replace(
            "0.501, 0.001}", "1, -0.499}")
        run = self.run_file(text, ".geo", scene_of=scene("stones.geo", mesh={"geometry": {"deep": 1.0}}))
        self.check_weight(run, 1.5 * WEIGHT)
        wrong = self.run_file(text, ".geo", scene_of=scene("stones.geo", mesh={"geometry": {"high": 1.0}}), out="wrong")
        self.assertEqual(wrong.code, 2, wrong.said)
        self.assertIn("mesh > stones > geometry > high", wrong.words)

    def test_up_may_be_another_axis(self):
        lying = {name: ([(y, z, x) for x, y, z in nodes], cells) for name, (nodes, cells) in meshes().items()}
        run = self.run_file(msh(lying, bed=False), ".msh", scene_of=scene("stones.msh", {"ground": {"on": "base"}}, {"up": "y"}))
        self.assertIn(KEPT, run.words)
        self.check_weight(run)

    def test_a_mesh_is_made_anew_where_asked(self):
        run = self.run_file(msh(meshes()), ".msh", scene_of=scene("stones.msh", mesh={"cells": "tetrahedra", "element size": 0.2}))
        self.assertIn(ANEW, run.words)
        self.assertIn("3 of tetrahedra", run.words)
        self.check_weight(run)

    def test_faces_of_a_stone_turned_off_all_axes_bear_what_lies_along_their_normals(self):
        axis, angle = (1 / math.sqrt(14), 2 / math.sqrt(14), 3 / math.sqrt(14)), 0.7
        text = ('SetFactory("OpenCASCADE");\nBox(1) = {0, 0, 0, 1, 0.6, 0.5};\n'
                f"Rotate {{ {{1, 2, 3}}, {{0, 0, 0}}, {angle} }} {{ Volume{{1}}; }}\n"
                'Physical Surface("toe") = {1};\nPhysical Surface("side") = {3};\nPhysical Surface("bed") = {5};\n'
                "Mesh.MeshSizeMax = 0.3;\n")
        supports = {name: {"on": name, "components": "normal"} for name in ("toe", "side", "bed")}
        weight = 0.3 * DENSITY * GRAVITY

        def turned(v):
            along = sum(a * b for a, b in zip(axis, v)) * (1 - math.cos(angle))
            crossed = [axis[(c + 1) % 3] * v[(c + 2) % 3] - axis[(c + 2) % 3] * v[(c + 1) % 3] for c in range(3)]
            return [math.cos(angle) * v[c] + math.sin(angle) * crossed[c] + along * axis[c] for c in range(3)]

        for ranks in (1, 2):
            run = self.run_file(text, ".geo", scene_of=scene("stones.geo", supports), ranks=ranks, out=f"ranks {ranks}")
            self.assertEqual(run.outcome, "equilibrium", run.said)
            for name, normal in (("toe", (1, 0, 0)), ("side", (0, 1, 0)), ("bed", (0, 0, 1))):
                n = turned(normal)
                for c, along in zip("xyz", n):
                    self.assertLess(abs(run.result["statics"]["reactions"][name][c + "_N"] - weight * n[2] * along), 1e-8 * weight)

    def test_what_is_inside_out_is_turned_and_said(self):
        stones = meshes()
        nodes, cells = stones["east"]
        stones["east"] = nodes, [cell[4:] + cell[:4] for cell in cells]
        run = self.run_file(msh(stones), ".msh")
        self.assertIn("volumes_turned", run.warnings, run.said)
        self.check_weight(run)

    def refused(self, text, ending, *words, scene_of=None, out="refused"):
        run = self.run_file(text, ending, scene_of=scene_of, out=out)
        self.assertEqual(run.code, 2, run.said)
        for word in ("mesh > stones", *words):
            self.assertIn(word, run.words)

    def test_what_is_broken_is_refused_by_volume_and_place(self):
        stones = meshes()
        nodes, cells = stones["east"]
        inverted = {**stones, "east": (nodes, [cells[0][4:] + cells[0][:4], *cells[1:]])}
        self.refused(msh(inverted), ".msh", "volume 3 (east), cell 0 with a corner at", "inverted", out="inverted")
        apart = lattice((3, 0, 0), (3.5, 0.5, 0.5), (2, 2, 2))
        both = nodes + apart[0], cells + [[len(nodes) + n for n in cell] for cell in apart[1]]
        self.refused(msh({**stones, "east": both}), ".msh", "volume 3 (east) is in pieces", out="pieces")
        deep = {**BOXES, "east": ((0.3, 0, 0.5), (1, 0.5, 1))}
        self.refused(msh(meshes(boxes=deep)), ".msh", "volume 2", "volume 3", "in each other", out="overlap")
        self.refused(msh({**stones, "twice": stones["east"]}), ".msh", "volume 3 (east)", "twice", out="twice")
        second = msh(stones).replace("\n1 5 2 1 1 ", "\n1 12 2 1 1 " + "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 ", 1)
        self.refused(second, ".msh", out="second order")

    def test_drawings_that_are_broken_are_refused(self):
        hole = geo(False, boxes={"lower": BOXES["lower"]}, more="").replace("Physical Volume", "// Physical Volume")
        plane = "Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {0, 1, 0};\nLine(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 1};\n"
        plane += "Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1};\n"
        self.refused(plane, ".geo", "has no volume", out="plane")
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        open_ = "".join(f"Point({k}) = {{{x}, {y}, {z}, 0.5}};\n" for k, (x, y, z) in enumerate(corners, start=1))
        open_ += "".join(f"Line({k}) = {{{a}, {b}}};\n" for k, (a, b) in enumerate(((1, 2), (1, 3), (1, 4), (2, 3), (2, 4), (3, 4)), start=1))
        open_ += ("Curve Loop(1) = {1, 4, -2}; Plane Surface(1) = {1};\nCurve Loop(2) = {1, 5, -3}; Plane Surface(2) = {2};\n"
                  "Curve Loop(3) = {2, 6, -3}; Plane Surface(3) = {3};\nSurface Loop(1) = {1, 2, 3}; Volume(1) = {1};\n")
        self.refused(open_, ".geo", "stones.geo", out="open")
        self.refused(hole + 'SystemCall "true";\n', ".geo", "SystemCall", out="script")
        loose = 'Rectangle(100) = {2, 2, 2, 1, 1};\nPhysical Surface("loose") = {100};\n'
        self.refused(geo(True, more=loose), ".geo", '"loose"', "bounds no volume", out="loose")
        self.refused(geo(True, more='Physical Surface("faces") = {1};\n'), ".geo", "faces", out="faces")
        self.refused(geo(True, more='Physical Volume("all") = {1};\n'), ".geo", "all", out="all")

    def test_without_physical_groups_stones_have_names_and_ends(self):
        text = "\n".join(line for line in geo(True).splitlines() if not line.startswith("Physical"))
        run = self.run_file(text, ".geo", scene_of=scene("stones.geo", {"ground": {"on": "base"}}, observations={
            "stone": {"place": "mean", "blocks": "volume 2"}}))
        self.check_weight(run)

    def test_surfaces_of_one_plane_are_told_apart_in_a_mesh_made_anew(self):
        # Two boxes drawn as one long one below: its bed is of two surfaces, of which one alone is held along x too.
        boxes = {"left": ((0, 0, 0), (0.5, 0.5, 0.5)), "upper": ((0, 0, 0.5), (1, 0.5, 1)), "right": ((0.5, 0, 0), (1, 0.5, 0.5))}
        text = geo(False, boxes=boxes)
        run = self.run_file(text, ".geo", scene_of=scene("stones.geo", {"ground": {"on": "bed", "blocks": "left"},
                                                                        "other": {"on": "bed", "components": "z", "blocks": "right"}}))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        found = run.result["statics"]["reactions"]
        for name in ("ground", "other"):
            self.assertLess(abs(found[name]["z_N"] - WEIGHT / 2), 0.2 * WEIGHT)
        self.assertLess(abs(found["ground"]["z_N"] + found["other"]["z_N"] - WEIGHT), 1e-8 * WEIGHT)


if __name__ == "__main__":
    program.main()

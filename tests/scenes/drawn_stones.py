"""Walls from drawings in the plane: CSV, DXF, SVG and GeoJSON, in any unit, exact or surveyed, and drawings that are wrong.

    drawn_stones.py PROGRAM MPIEXEC

Set-up    A wall in running bond, 4 courses of 4 stones, as the generator has it and as drawings of each kind; the same with
          corners off by 1 to 5 mm; a stack of 8 stones that tips over the lowest.
Expected  Drawn exactly it is the wall of the generator: reactions, displacements and limit factor. Surveyed its limit factor
          is that of the stack by hand, half its width over half its height. What does not fit is refused with the names of
          stones and the place.
Tolerance 1e-9, since nodes are equal to round-off; 1 % for surveys, twice the error of 5 mm on a lever of 1 m.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import drawings  # noqa: E402  (folders of their own)
import program  # noqa: E402
from stones import xml  # noqa: E402

COURSES, COUNT, LENGTH, HEIGHT = 4, 4, 0.5, 0.25
WALL = {"courses": COURSES, "blocks per course": COUNT, "block length": LENGTH, "block height": HEIGHT, "cells along": 4,
        "cells up": 2, "cells": "quadrilateral"}
WEIGHT = COURSES * COUNT * LENGTH * HEIGHT * 2000 * 9.81


def scene(mesh, stages=None, friction=0.6, supports=None, **sections):
    tree = {"mesh": mesh, "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"dry": {"friction coefficient": friction}}, "supports": {"ground": supports or {"on": "base"}},
            "loads": {"weight": {"type": "self weight"}, "push": {"type": "acceleration", "ax": 9.81}},
            "steps": {"stages": stages or {"rest": {"loads": {"weight": 1.0}}, "pushed": {"loads": {"push": 0.1}}}}}
    tree.update({name.replace("_", " "): section for name, section in sections.items()})
    return xml("wall", tree) + "\n"


def stones(file, **keys):
    return {"type": "stones", "stones": {"file": file, "element size": 0.125, **keys}}


RAISED = {"stages": {"rest": {"loads": {"weight": 1.0}}}, "load_factor": {"pattern": {"push": 1.0}}}


class DrawnStones(program.SceneTest):
    def draw(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def solved(self, mesh, out, **sections):
        run = self.run_scene(scene(mesh, **sections), out=out)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run

    def limit(self, mesh, out, friction=0.6):
        run = self.run_scene(scene(mesh, friction=friction, **RAISED), "--limit-analysis", out=out)
        self.assertEqual(run.code, 0, run.said)
        return run.result["collapse"]["certified_upper"]

    def test_every_kind_is_the_wall_of_the_generator(self):
        wall = drawings.bond(COURSES, COUNT, LENGTH, HEIGHT)
        generated = {"type": "wall", "wall": WALL}
        run, factor = self.solved(generated, "generated"), self.limit(generated, "limit")
        kinds = {"csv": (drawings.csv(wall), {}), "mm.csv": (drawings.csv(wall, scale=1000.0), {"unit": 0.001}),
                 "down.csv": (drawings.csv(wall, up=-1), {"up": "-y"}), "dxf": (drawings.dxf(wall), {}),
                 "svg": (drawings.svg(wall, scale=1000.0), {"unit": 0.001}), "geojson": (drawings.geojson(wall), {})}
        for kind, (text, keys) in kinds.items():
            with self.subTest(kind=kind):
                self.draw(f"wall.{kind}", text)
                mesh = stones(f"wall.{kind}", **keys)
                drawn = self.solved(mesh, kind)
                for key in ("x_N", "y_N"):
                    self.assertLess(abs(drawn.result["statics"]["reactions"]["ground"][key] -
                                        run.result["statics"]["reactions"]["ground"][key]), 1e-9 * WEIGHT)
                self.assertLess(abs(drawn.result["largest_displacement_m"] / run.result["largest_displacement_m"] - 1), 1e-6)
                self.assertLess(abs(self.limit(mesh, f"{kind} limit") / factor - 1), 1e-9)
                self.assertTrue((drawn.folder / "drawing.svg").read_text(encoding="utf-8").startswith("<svg"))

    def test_a_survey_bears_what_the_wall_bears(self):
        stack = {f"s{k}": drawings.box(0.0, 0.5 * k, 2.0, 0.5) for k in range(8)}
        hand = 2.0 / 3.5  # seven stones tip over the lowest, which is held
        for seed in (1, 2):
            chance = drawings.random.Random(seed)
            off = {name: [drawings.survey(p, 5e-3, chance) for p in corners] for name, corners in stack.items()}
            for kind, text in (("csv", drawings.csv(off)), ("dxf", drawings.dxf(off)), ("svg", drawings.svg(off))):
                self.draw(f"survey{seed}.{kind}", text)
                factor = self.limit(stones(f"survey{seed}.{kind}"), f"{kind} {seed}", friction=0.8)
                self.assertLess(abs(factor / hand - 1), 0.01)

    def test_validation_tells_what_was_moved(self):
        self.draw("survey.csv", drawings.csv(drawings.bond(COURSES, COUNT, LENGTH, HEIGHT, 5e-3, seed=3)))
        run = self.run_scene(scene(stones("survey.csv")), "--validate")
        self.assertEqual(run.code, 0, run.said)
        for words in ("18 stones, 2.0", "joints by snap: does not fit at ", "from the middle of the widest range that fits",
                      "moved by up to 0.00", 'of stone "', "18 stones of quadrilaterals, 0 of triangles"):
            self.assertIn(words, run.words)
        self.solved(stones("survey.csv"), "solved")

    def test_sets_are_layers_and_messages_name_stones_with_their_place(self):
        wall = drawings.bond(COURSES, COUNT, LENGTH, HEIGHT)
        self.draw("wall.dxf", drawings.dxf(wall, {name: "foot" for name in wall if name.startswith("0")}))
        held = self.solved(stones("wall.dxf"), "held", supports={"on": "faces", "blocks": "foot"})
        self.assertLess(abs(held.result["statics"]["reactions"]["ground"]["y_N"] - WEIGHT), 1e-6 * WEIGHT)
        run = self.run_scene(scene(stones("wall.dxf"), materials={"m": {"blocks": "foot"}}), out="refused")
        self.assertNotEqual(run.code, 0)
        self.assertIn("no material for stone 5 at (0.125, 0.375)", run.words)
        run = self.run_scene(scene(stones("wall.dxf"), supports={"on": "faces", "blocks": "feet"}), out="refused")
        self.assertIn('did you mean "foot"?', run.words)

    def test_blocks_of_cad_and_uses_of_svg_are_drawn_as_often_as_they_are_used(self):
        """The wall of the generator, every stone of which is one brick: in rows, scaled, turned, mirrored, in pairs."""
        generated = {"type": "wall", "wall": WALL}
        run, factor = self.solved(generated, "generated"), self.limit(generated, "limit")
        insert, half = drawings.insert, {"c41": 0.5}
        cad = drawings.dxf_of_blocks(
            {"Brick": ((1, 2), [drawings.outline(drawings.box(1, 2, LENGTH, HEIGHT))]),
             "PAIR": ((0, 0), [insert("BRICK", 0, 0), insert("brick", LENGTH, 0)])},
            [insert("Brick", 0, 0, layer="foot", c70=4, c44=LENGTH),
             insert("Brick", 0, 0.25, **half), insert("Brick", 0.25, 0.25, c70=3, c71=1, c44=LENGTH), insert("Brick", 1.75, 0.25, **half),
             insert("pair", 0, 0.5), insert("pair", 1, 0.5),
             insert("Brick", 0, 0.75, **half), insert("Brick", -0.75, 0.75, c230=-1), insert("Brick", 1.25, 0.75, c41=-1),
             insert("Brick", 1.75, 0.75, c41=0.5, c42=2, c50=90), insert("Brick", 2, 1, c41=0.5, c50=180)])
        page = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"><defs>
          <path id="brick" d="M0 0h.5v-.25h-.5z"/><g id="pair"><use id="l" href="#brick"/><use id="r" href="#brick" x=".5"/></g></defs>
          <symbol id="half"><rect id="it" y="-.25" width=".25" height=".25"/></symbol><g class="foot">
          <use href="#brick"/><use href="#brick" x=".5"/><use xlink:href="#brick" x="1"/><use href="#brick" x="1.5"/></g>
          <use id="h" href="#half" y="-.25"/><use href="#brick" x=".25" y="-.25"/><use href="#brick" x=".75" y="-.25"/>
          <use href="#brick" x="1.25" y="-.25"/><use href="#half" x="1.75" y="-.25"/>
          <use id="a" href="#pair" y="-.5"/><use id="b" href="#pair" transform="translate(1 -.5)"/>
          <use href="#half" y="-.75"/><use href="#brick" transform="translate(.75 -.75) scale(-1 1)"/>
          <use href="#brick" transform="translate(1.25 -.75) rotate(-90) scale(.5 2)"/>
          <use href="#brick" x="1.25" y="-.75"/><use href="#half" x="1.75" y="-.75"/></svg>"""
        for name, text in (("wall.dxf", cad), ("wall.svg", page)):
            with self.subTest(name):
                self.draw(name, text)
                mesh = stones(name)
                drawn = self.solved(mesh, f"run {name}")
                self.assertEqual(drawn.result["blocks"], run.result["blocks"])
                for key in ("x_N", "y_N"):
                    self.assertLess(abs(drawn.result["statics"]["reactions"]["ground"][key] -
                                        run.result["statics"]["reactions"]["ground"][key]), 1e-9 * WEIGHT)
                self.assertLess(abs(self.limit(mesh, f"{name} limit") / factor - 1), 1e-9)
                held = self.solved(mesh, f"{name} held", supports={"on": "faces", "blocks": "foot"})
                self.assertLess(abs(held.result["statics"]["reactions"]["ground"]["y_N"] - WEIGHT), 1e-6 * WEIGHT)
        for name in ("h it", "a l", "b r"):  # names of what is used within what is used
            run = self.run_scene(scene(stones("wall.svg"), supports={"on": "faces", "blocks": name}), "--validate", out="named")
            self.assertEqual(run.code, 0, run.said)
        run = self.run_scene(scene(stones("wall.dxf"), supports={"on": "faces", "blocks": "Brick"}), "--validate", out="named")
        self.assertEqual(run.code, 0, run.said)

    def test_triangles_that_bend_are_nearer_to_fine_cells(self):
        """An arm on a stone that is held, bonded: linear triangles are too stiff where it bends."""
        beam = {"wall": drawings.box(-0.4, 0, 0.4, 0.4), "arm": drawings.box(0, 0, 0.8, 0.4)}
        self.draw("beam.csv", drawings.csv(beam))
        found = {}
        for name, cells, size in (("fine", "by shape", 0.02), ("bends", "quadratic triangles", 0.2), ("linear", "triangles", 0.2)):
            mesh = stones("beam.csv", **{"cells": cells, "element size": size})
            run = self.solved(mesh, name, supports={"on": "left"}, selection={"mode": "bonded"})
            found[name] = run.history[0]["largest_displacement_m"]
        self.assertLess(abs(found["bends"] / found["fine"] - 1), 0.02, found)
        self.assertLess(found["linear"] / found["fine"], 0.85, found)
        mesh = stones("beam.csv", cells="quadratic triangles")
        self.assertIn("0 stones of quadrilaterals, 2 of quadratic triangles", self.run_scene(scene(mesh), "--validate", out="seen").words)
        run = self.run_scene(scene(mesh, model={"rotations": "finite"}), "--validate", out="turned")
        self.assertEqual(run.code, 2)
        self.assertIn('does not go with cells = "quadratic triangles"', run.words)
        run = self.run_scene(scene({"type": "stones", "stones": {"file": "a.obj", "cells": "quadratic triangles"}}), "--validate", out="space")
        self.assertEqual(run.code, 2)
        self.assertIn("is of drawings in the plane", run.words)

    def test_two_ranks_and_a_restart_find_the_same(self):
        self.draw("survey.svg", drawings.svg(drawings.bond(COURSES, COUNT, LENGTH, HEIGHT, 3e-3, seed=5)))
        text = scene(stones("survey.svg"))
        one = self.run_scene(text, out="one")
        two = self.run_scene(text, out="two", ranks=2)
        first = self.run_scene(scene(stones("survey.svg"), stages={"rest": {"loads": {"weight": 1.0}}},
                                     output={"checkpoint at end": True}), out="branched")
        self.assertEqual(first.code, 0, first.said)
        more = self.run_scene(text, "--restart", out="branched")
        for run in (two, more):
            self.assertEqual(run.outcome, "equilibrium", run.said)
            for key in ("x_N", "y_N"):
                self.assertLess(abs(run.result["statics"]["reactions"]["ground"][key] -
                                    one.result["statics"]["reactions"]["ground"][key]), 1e-7 * WEIGHT)

    def test_what_is_wrong_is_told_by_stone_and_place(self):
        good = {"left": drawings.box(0, 0, 1, 1), "right": drawings.box(1, 0, 1, 1)}

        def change(**other):
            return drawings.csv({**good, **other})

        wrong = {
            "gap": (change(right=drawings.box(1.02, 0, 1, 1)), {"snap": 0.005}, ("do not touch: 0.02 m apart at (1", "above 0.02 m")),
            "overlap": (change(right=drawings.box(0.9, 0.1, 1, 0.7)), {},
                        ('stone "left" (wall.csv, line 2) at (0.5, 0.5) and stone "right" (wall.csv, line 6)', "by 0.1 m")),
            "twice": (change(copy=drawings.box(1, 0, 1, 1)), {}, ("is there twice", "Delete one")),
            "sliver": (change(thin=drawings.box(0, 1, 1, 0.002)), {"snap": 0.01},
                       ('stone "thin"', "is somewhere narrower than snap")),
            "itself": (change(right=[(1, 0), (2, 1), (2, 0), (1, 1)]), {}, ("crosses itself at (1.5, 0.5)",)),
            "two": (change(right=[(1, 0), (2, 1)]), {}, ('stone "right"', "has 2 corners")),
            "empty": ("", {}, ("Is empty",)),
            "head": ("stone,x,y\n", {}, ("no row below its head",)),
            "column": ("stone,x,z\na,0,0\n", {}, ('no column "y": its columns are stone, x, z',)),
            "comma": ("stone;x;y\na;0,5;0\n", {}, ("Line 2", "decimal points")),
            "apart": ("stone,x,y\na,0,0\nb,0,0\na,1,0\n", {}, ("Line 4", "goes on with stone")),
            "key": (change(), {"joint tolerance": 0.01}, ("joint tolerance", "the file is a drawing in the plane", "Give snap")),
            "up": (change(), {"up": "z"}, ('up = "z"', "Give usual, y, x or -y")),
        }
        for name, (text, keys, words) in wrong.items():
            with self.subTest(name):
                self.draw("wall.csv", text)
                run = self.run_scene(scene(stones("wall.csv", **keys)), "--validate", out=name)
                self.assertEqual(run.code, 2, run.said)
                for word in words:
                    self.assertIn(word, run.words)

    def test_other_kinds_say_where_too(self):
        good = {"left": drawings.box(0, 0, 1, 1)}
        wrong = {
            "open.dxf": (drawings.dxf(good, closed=False), ("is not closed: its ends at (0, 0) and (0, 1) are 1 apart",)),
            "cut.dxf": (drawings.dxf(good)[:120], ("without EOF",)),
            "lines.dxf": ("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n0\nENDSEC\n0\nEOF\n",
                          ("Holds no stone", "1 LINE", "PEDIT")),
            "open.svg": ('<svg><path id="k" d="M0 0h1v1"/></svg>', ('the path "k" is not closed', "(0, 0) and (1, 1)")),
            "none.svg": ("<svg><text>a</text></svg>", ("Holds no stone", "1 text")),
            "line.geojson": ('{"type": "Feature", "geometry": {"type": "LineString", "coordinates": []}}', ("Feature 1 is a LineString",)),
            "inserted.dxf": (drawings.dxf_of_blocks({}, [drawings.insert("door", 0, 0)]),
                             ('inserts the block "door", which the file does not hold',)),
            "elsewhere.dxf": (drawings.dxf_of_blocks({"door": ((0, 0), [])}, [drawings.insert("door", 0, 0)]).replace("70\n0", "70\n4"),
                              ("which is in another file", "Bind it")),
            "itself.dxf": (drawings.dxf_of_blocks({"a": ((0, 0), [drawings.insert("a", 1, 0)])}, [drawings.insert("a", 0, 0)]),
                           ("in blocks more than 20 deep",)),
            "many.dxf": (drawings.dxf_of_blocks({"a": ((0, 0), [])}, [drawings.insert("a", 0, 0, c70=1000, c71=1000)]),
                         ("more than 100000 times",)),
            "used.svg": ('<svg><use href="#k"/></svg>', ('uses "#k", which is nothing of this drawing',)),
            "view.svg": ('<svg><symbol id="k" viewBox="0 0 1 1"/><use href="#k"/></svg>', ("a symbol with a viewBox",)),
            "round.svg": ('<svg><g id="k"><use href="#k"/></g></svg>', ("Nests groups more than 100 deep",)),
            "plan.json": (drawings.geojson(good), ("Is GeoJSON, a drawing in the plane", "Give it the ending .geojson")),
            "bad.geojson": ('{"type": ', ("Is no JSON",)),
            "wall.dwg": ("x", ("by its ending", "a .dwg is saved as .dxf")),
        }
        for name, (text, words) in wrong.items():
            with self.subTest(name):
                self.draw(name, text)
                run = self.run_scene(scene(stones(name)), "--validate", out=name)
                self.assertEqual(run.code, 2, run.said)
                for word in words:
                    self.assertIn(word, run.words)


if __name__ == "__main__":
    program.main()

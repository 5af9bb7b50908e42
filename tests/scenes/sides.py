"""Curves between stones have two sides, meshes lie about their unit and their stones: what is refused, what is said, and
what the keys that answer do.

    sides.py PROGRAM MPIEXEC

A bed 2 m x 0.5 m under two stones of 1 m x 0.5 m; friction 0.4, 1 m thick. The curves between bed and stones are the set
"joint", that between the stones is "crack".
"""

import json
import pathlib
import subprocess
import sys
import unittest

FOLDER = pathlib.Path("sides").resolve()
PROGRAM = MPIEXEC = None
GEO = """
DefineConstant[ scale = 1 ];
x() = {0, 1, 2}; y() = {0, 0.5, 1};
For j In {0:2}
  For i In {0:2}
    Point(1 + i + 3 * j) = {scale * x(i), scale * y(j), 0};
  EndFor
EndFor
Line(1) = {1, 3}; Line(2) = {3, 6}; Line(3) = {4, 1};
Line(4) = {4, 5}; Line(5) = {5, 6};
Line(6) = {4, 7}; Line(7) = {5, 8}; Line(8) = {6, 9}; Line(9) = {7, 8}; Line(10) = {8, 9};
Transfinite Curve{1} = 9; Transfinite Curve{4, 5, 9, 10} = 5; Transfinite Curve{2, 3, 6, 7, 8} = 3;
Curve Loop(1) = {1, 2, -5, -4, 3}; Plane Surface(1) = {1};
Curve Loop(2) = {4, 7, -9, -6}; Plane Surface(2) = {2};
Curve Loop(3) = {5, 8, -10, -7}; Plane Surface(3) = {3};
Physical Surface("bed") = {1}; Physical Surface("west") = {2}; Physical Surface("east") = {3};
Physical Surface("stones") = {2, 3};
Physical Curve("foot") = {1}; Physical Curve("joint") = {4, 5}; Physical Curve("crack") = {7};
Physical Curve("roof") = {9, 10};
"""


def xml(name, value):
    if isinstance(value, dict):
        return f'<ParameterList name="{name}">' + "".join(xml(*item) for item in value.items()) + "</ParameterList>\n"
    kind = {str: "string", float: "double", bool: "bool"}[type(value)]
    return f'<Parameter name="{name}" type="{kind}" value="{str(value).lower() if kind == "bool" else value}"/>\n'


def scene(support=None, load=None, joints=None, mesh=None, factor=False, weight=1.0):
    """A scene as a dictionary: the bed held at its foot, unless told otherwise."""
    loads = {"weight": {"type": "self weight"}, "push": {"type": "acceleration", "ax": 9.81}}
    factors = {"weight": weight}
    if load:
        loads["q"] = load
        factors["q"] = 1.0
    s = {"mesh": {"type": "gmsh", "gmsh": {"file": "stones.geo", "cells": "triangle", **(mesh or {})}},
         "materials": {"stone": {"Young modulus": 1e10, "Poisson ratio": 0.2, "density": 2000.0}},
         "joints": joints or {"dry": {"friction coefficient": 0.4}},
         "supports": {"ground": support or {"on": "foot"}}, "loads": loads,
         "steps": {"expect collapse": True, "stages": {"all": {"loads": factors}}}}
    if factor:
        s["load factor"] = {"pattern": {"push": 1.0}, "first factor": 0.1, "largest factor": 10.0, "accuracy": 0.002}
    return s


class Scenes(unittest.TestCase):
    count = 0

    def run_scene(self, contents, *options, ranks=1):
        FOLDER.mkdir(exist_ok=True)
        (FOLDER / "stones.geo").write_text(GEO, encoding="utf-8")
        Scenes.count += 1
        self.out = FOLDER / f"out{Scenes.count}"
        file = FOLDER / f"scene{Scenes.count}.xml"
        file.write_text(xml("sides", contents), encoding="utf-8")
        command = [MPIEXEC, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        return subprocess.run([*command, PROGRAM, f"--xml={file}", f"--out={self.out}", "--overwrite",
                               "--set", "output/fields=false", *options], capture_output=True, text=True, check=False)

    def result(self, contents, *options, ranks=1):
        done = self.run_scene(contents, *options, ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return json.loads((self.out / "result.json").read_text(encoding="utf-8"))

    def warnings(self, contents, ranks=1):
        """Of a scene that is only looked at: kinds and texts."""
        done = self.run_scene(contents, "--validate", ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return [line for line in done.stdout.splitlines() if "WARNING" in line]

    def refusal(self, contents, ranks=1):
        done = self.run_scene(contents, "--validate", ranks=ranks)
        self.assertEqual(done.returncode, 2, done.stdout)
        return done.stderr


class Supports(Scenes):
    def test_both_sides_are_named(self):
        said = self.warnings(scene(support={"on": "joint"}), ranks=2)
        self.assertEqual(len(said), 1, said)
        for words in ('supports > ground', '"joint"', "between surface 1 (bed) and surface 2 (west, stones)",
                      "between surface 1 (bed) and surface 3 (east, stones)", 'blocks = "bed"', '"stones"'):
            self.assertIn(words, said[0])

    def test_one_side_lets_the_stones_slide_at_their_friction(self):
        result = self.result(scene(support={"on": "joint", "blocks": "bed"}, factor=True), ranks=2)
        self.assertLessEqual(result["collapse"]["lower"], 0.4001)
        self.assertGreaterEqual(result["collapse"]["upper"], 0.3999)
        self.assertEqual(result["warnings"], [])

    def test_both_sides_are_told_in_the_result_and_silent_when_meant(self):
        result = self.result(scene(support={"on": "joint"}))
        self.assertEqual([w["what"] for w in result["warnings"]], ["support_on_both_sides"])
        self.assertAlmostEqual(result["warnings"][0]["how_much"], 2.0)  # m of joint
        self.assertEqual(self.warnings(scene(support={"on": "joint", "blocks": "all"})), [])

    def test_the_reaction_is_that_of_the_side(self):
        # The bed hangs below its own upper face: 2 m x 0.5 m; the stones press on it.
        result = self.result(scene(support={"on": "joint", "blocks": "bed"}))
        self.assertAlmostEqual(result["statics"]["reactions"]["ground"]["y_N"], 2000 * 9.81 * 2, delta=1e-3)

    def test_a_side_without_facets_is_refused(self):
        said = self.refusal(scene(support={"on": "foot", "blocks": "east"}))
        self.assertIn('supports > ground > blocks = "east"', said)
        self.assertIn('has no facet of "foot"', said)
        said = self.refusal(scene(support={"on": "foot", "blocks": "nowhere"}))
        self.assertIn("is no set of blocks of this mesh", said)


class Loads(Scenes):
    def test_what_would_count_twice_is_refused(self):
        crowd = {"type": "crowd", "on": "joint"}
        train = {"type": "moving train", "on": "joint", "axle loads": "1e3", "position": 0.3}
        traction = {"type": "traction", "on": "joint", "ty": -1000.0}
        for load in (traction, crowd, train):
            said = self.refusal(scene(load=load), ranks=1 if load is not traction else 2)
            for words in ('loads > q > on = "joint"', "surface 1 (bed) and surface 2 (west, stones)",
                          'Say which side is meant: blocks = "bed"', load["type"]):
                self.assertIn(words, said)
        # A set that has both sides although it is named; a joint that stands upright bears no crowd.
        self.assertIn("both sides", self.refusal(scene(load={"type": "traction", "on": "crack", "tx": 1.0,
                                                            "blocks": "stones"})))
        self.assertEqual(self.warnings(scene(load={"type": "crowd", "on": "crack"})), [])
        self.assertEqual(self.warnings(scene(load={"type": "crowd", "on": "joint", "x to": -1.0})), [])

    def test_one_side_bears_the_load_once(self):
        load = {"type": "traction", "on": "joint", "ty": -1000.0, "blocks": "stones"}
        result = self.result(scene(load=load, weight=0.0), ranks=2)
        self.assertAlmostEqual(result["statics"]["reactions"]["ground"]["y_N"], 2000.0, delta=1e-6)  # 2 m

    def test_pressure_in_a_joint_is_a_question(self):
        water = {"type": "water pressure", "on": "crack", "level": 1.0}
        for load in (water, {"type": "traction", "on": "crack", "pressure": 100.0}):
            said = self.warnings(scene(load=load))
            self.assertEqual(len(said), 1, said)
            for words in ("loads > q", '"crack"', "pushes the stones apart", 'blocks = "west"', 'blocks = "all"'):
                self.assertIn(words, said[0])
        self.assertEqual(self.warnings(scene(load={**water, "blocks": "all"})), [])
        self.assertEqual(self.warnings(scene(load={**water, "blocks": "west"})), [])

    def test_a_point_load_where_three_stones_meet_says_who_bears_it(self):
        load = {"type": "point load", "x": 1.0, "y": 0.5, "fy": -100.0}
        warnings = self.result(scene(load=load), ranks=2)["warnings"]
        self.assertEqual([w["what"] for w in warnings], ["load_on_several_stones"])
        self.assertIn("surface 1 (bed) bears the load", warnings[0]["text"])
        self.assertEqual(self.result(scene(load={**load, "blocks": "east"}))["warnings"], [])


class Meshes(Scenes):
    def test_large_stones_ask_for_the_unit(self):
        # Drawn in millimetres: the bed is 2000 m long.
        mm = {"geometry": {"scale": 1000.0}}
        said = self.warnings(scene(mesh=mm))
        self.assertEqual(len(said), 1, said)
        self.assertIn("surface 1 (bed) is 2000 m long and 2 more exceed 50 m", said[0])
        self.assertIn("mesh > gmsh > unit", said[0])
        self.assertEqual(self.warnings(scene(mesh={**mm, "unit": "mm"})), [])
        self.assertIn("is the file drawn in metres", self.warnings(scene(mesh={"unit": "mm"}))[0])  # 2 mm
        weight = self.result(scene(mesh={**mm, "unit": "mm"}))["statics"]["reactions"]["ground"]["y_N"]
        self.assertAlmostEqual(weight, 2000 * 9.81 * 2, delta=1e-3)

    def test_the_element_size_works_without_a_number_in_the_file(self):
        nodes = [self.result(scene(mesh={"element size": size}))["nodes"] for size in (0.25, 0.125)]
        self.assertGreater(nodes[1], 2.5 * nodes[0])

    def test_supports_that_leave_the_whole_free_to_move_are_named(self):
        def free(components, on="foot", ranks=1):
            result = self.result(scene(support={"on": on, "components": components}), ranks=ranks)
            return [w["text"].split(" free to move ")[1].split(":")[0] for w in result["warnings"]
                    if w["what"] == "free_to_move"]
        for ranks in (1, 2):
            self.assertEqual(free("xy", ranks=ranks), [])
            self.assertEqual(free("y", ranks=ranks), ["along x"])  # weight alone: it stands, anywhere

    def test_an_energy_below_what_the_stones_can_follow_is_named(self):
        def raised(energy):
            law = {"friction coefficient": 0.4, "tension strength": 5e4, "cohesion": 1e5, "fracture energy": energy,
                   "shear fracture energy": 50.0}
            return [(w["where"].split(" > ")[-1], w["how_much"]) for w in self.result(scene(joints={"mortar": law}))["warnings"]
                    if w["what"] == "raised_energy"]
        self.assertEqual(raised(10.0), [])
        (key, share), = raised(1e-4)
        self.assertEqual(key, "fracture energy")
        # T^2 h / (2 s k) of a point with the share h = 0.25 m of the joint, where s = 1/4 and k = E: 0.125 J/m2.
        self.assertAlmostEqual(share, 5e4**2 * 0.25 / (2 * 0.25 * 1e10) / 1e-4, delta=1e-6 * share)
        self.assertAlmostEqual(raised(1e-5)[0][1], 10 * share, delta=1e-6 * share)

    def test_laws_that_hold_nowhere_are_named(self):
        base = {"friction coefficient": 0.4}
        between = {"between": "east", "and": "bed", "friction coefficient": 0.6}
        nowhere = {"between": "west", "and": "west", "friction coefficient": 0.6}

        def idle(joints, ranks=1):
            return [(w["where"].split(" > ")[-1], w["how_much"]) for w in self.result(scene(joints=joints),
                    ranks=ranks)["warnings"] if w["what"] == "law_without_joint"]
        self.assertEqual(idle({"dry": base, "east": between}), [])
        self.assertEqual(idle({"dry": base, "west": nowhere}, ranks=2), [("west", 0)])
        self.assertEqual(idle({"east": between, "dry": base}), [("east", 1)])  # the last one takes all

    def test_a_stone_that_touches_no_other_is_named(self):
        far = GEO + """Point(21) = {5, 0, 0}; Point(22) = {6, 0, 0}; Point(23) = {5.5, 1, 0};
Line(21) = {21, 22}; Line(22) = {22, 23}; Line(23) = {23, 21}; Curve Loop(9) = {21, 22, 23}; Plane Surface(9) = {9};
Physical Curve("post") = {21};"""
        FOLDER.mkdir(exist_ok=True)
        (FOLDER / "far.geo").write_text(far, encoding="utf-8")
        lone = scene(mesh={"file": "far.geo"})
        lone["supports"]["post"] = {"on": "post"}
        said = self.warnings(lone)
        self.assertEqual(len(said), 1, said)
        self.assertIn("surface 9 shares no joint with any other stone", said[0])


if __name__ == "__main__":
    MPIEXEC = sys.argv.pop(2)
    PROGRAM = sys.argv.pop(1)
    unittest.main()

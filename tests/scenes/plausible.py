"""What is drawn or given in another unit than meant is said before anything is computed, and drawings run no programs.

    plausible.py PROGRAM MPIEXEC
"""

import math
import pathlib
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
import solids
import stones

INPUT = 2
WALL = {"a": stones.rectangle(0, 0, 1, 0.5), "b": stones.rectangle(0, 0.5, 1, 1.0)}
EDGES = {"ground": ("a", 0), "foot": ("a", 1), "top": ("b", 2)}
DRAWING = stones.geo(WALL, 0.25, EDGES)


def scene(size=0.25, **more):
    mesh = {"gmsh": {"file": "stones.geo", "element size": size}} if size else {}
    return stones.scene("stones.geo", ["ground"], more.pop("loads", {}), more.pop("stages", {"own": stones.OWN_WEIGHT}),
                        mesh=mesh, **more)


class Plausible(program.SceneTest):
    def refused(self, words, text, *options, drawing=DRAWING, seconds=30, **how):
        begin = time.monotonic()
        run = self.run_scene(text, "--validate", *options, drawing=drawing, **how)
        self.assertEqual(run.code, INPUT, run.said)
        self.assertLess(time.monotonic() - begin, seconds)  # it would mesh for minutes
        for word in words:
            self.assertIn(word, run.words)

    def test_friction_without_bound_is_named_where_a_step_has_no_answer(self):
        for friction, told in ((math.inf, True), (3.0, False)):
            with self.subTest(friction=friction):
                text = scene(loads={"push": {"type": "acceleration", "ax": 9.81}}, friction=friction,
                             stages={"own": {"loads": {"weight": 1.0, "push": 1.6}}},
                             selection={"mode": "all"}, newton={"largest iterations": 1})
                run = self.run_scene(text, drawing=DRAWING)
                self.assertEqual(run.outcome, "not_converged", run.said)
                self.assertEqual("friction without bound" in run.result["message"], told, run.result["message"])

    def test_a_drawing_in_millimetres(self):
        millimetres = stones.geo({name: [(1e4 * x, 1e4 * y) for x, y in corners] for name, corners in WALL.items()},
                                 1000, EDGES)
        words = ["element size = 0.1 m asks for 1e+10 cells", "10000 x 10000 m", "mesh > gmsh > unit = mm", "(now: m)"]
        for ranks in (1, 2):
            self.refused(words, scene(0.1), drawing=millimetres, ranks=ranks)
        self.assertEqual(self.run_scene(scene(0.1), "--validate", "--set", "mesh/gmsh/unit=mm").code, 0)

    def test_an_element_size_of_a_micrometre(self):
        self.refused(["element size = 1e-06 m asks for 1e+12 cells"], scene(1e-6))
        own = DRAWING.replace("Transfinite", "//") + "MeshSize{:} = 1e-6;\n"
        self.refused(["stones.geo asks for", "cells", "1 x 1 m"], scene(0), drawing=own)

    def test_a_wall_of_too_many_stones(self):
        xml = pathlib.Path(__file__).resolve().parents[2] / "xml" / "wall.xml"
        run = self.run_scene(xml, "--validate", "--set", "mesh/wall/courses=1000000", "--set",
                             "mesh/wall/blocks per course=1000000")
        self.assertEqual(run.code, INPUT, run.said)
        self.assertIn("cells, and this machine's memory", run.words)

    def test_stones_in_space_with_millimetres_for_metres(self):
        (self.folder / "stones.obj").write_text(solids.obj({"a": solids.box((0, 0, 0), (1, 1, 0.5)),
                                                            "b": solids.box((0, 0, 0.5), (1, 1, 1))}), encoding="utf-8")
        mesh = {"type": "stones", "stones": {"file": "stones.obj", "element size": 2e-4}}
        text = stones.scene(mesh, {"foot": {"on": "base"}}, {}, {"own": stones.OWN_WEIGHT})
        self.refused(["mesh > stones > element size = 0.0002 m", "asks for 1.25e+11 cells", "1 m3"], text, drawing=None)

    def test_values_in_another_unit(self):
        text = scene(joints={"dry": {"friction coefficient": 35.0, "cohesion": 0.1, "tension strength": 0.1,
                                     "fracture energy": 10.0}})
        checked = self.run_scene(text, "--validate", drawing=DRAWING)
        for words in ("friction coefficient: 35 (a pure number) is unusual, usual is 0.001 to 2",
                      "cohesion: 0.1 Pa is unusual", "10 J/m2 parts the joint at tension strength = 0.1 Pa only after"):
            self.assertIn(words, checked.words)
        run = self.run_scene(text)
        self.assertEqual(run.code, 0, run.said)
        self.assertEqual(run.warnings.count("unusual_value"), 4)
        self.assertNotIn("unusual_value", self.run_scene(scene()).warnings)

    def test_a_load_that_is_zero_at_the_time_of_load_steps(self):
        gust = {"type": "acceleration", "ax": 50.0, "time function": {"type": "pulse", "duration": 0.5}}
        pushed = {"loads": {"weight": 1.0, "gust": 1.0}}
        told = self.run_scene(scene(loads={"gust": gust}, stages={"own": stones.OWN_WEIGHT, "push": pushed}), drawing=DRAWING)
        self.assertEqual(told.warnings, ["zero_at_rest"], told.said)
        self.assertIn("in the load steps of this stage", told.words)
        raised = {"load factor": {"pattern": {"gust": 1.0}, "largest factor": 2.0}}
        told = self.run_scene(scene(loads={"gust": gust}, stages={"own": stones.OWN_WEIGHT}, **raised))
        self.assertEqual(told.warnings, ["zero_at_rest"], told.said)
        # In the middle of the pulse, and after stages of so long: it pushes.
        for stages in ({"push": {**pushed, "duration": 0.01, "time step": 0.01}},
                       {"rest": {**stones.OWN_WEIGHT, "duration": 0.25, "time step": 0.01}, "push": {"loads": {"weight": 1.0, "gust": 0.001}}}):
            run = self.run_scene(scene(loads={"gust": gust}, stages=stages))
            self.assertNotIn("zero_at_rest", run.warnings, run.said)

    def test_what_a_scene_says_for_nothing(self):
        thrown = {"initial velocities": {"a": {"blocks": "all", "vx": 1.0}}}
        idle = {"own": {**stones.OWN_WEIGHT, "at once": True}}
        told = self.run_scene(scene(loads={"wind": {"type": "acceleration", "ax": 1.0}}, stages=idle, **thrown), drawing=DRAWING)
        self.assertEqual(told.warnings, ["probably_not_meant"], told.said)
        self.assertIn("has no duration, so at once has no effect in it", told.words)
        # What may be a part of a longer scene is told in the head alone.
        self.assertIn("initial velocities: have no effect", told.words)
        self.assertIn("loads > wind: never acts", told.words)

    def test_a_load_that_supports_bear_where_it_acts(self):
        held = {"press": {"type": "traction", "on": "ground", "pressure": 1e4}}
        stages = {"own": stones.OWN_WEIGHT}
        search = {"load factor": {"pattern": {"press": 1.0}, "largest factor": 2.0}}
        text = scene(loads=held, stages=stages, **search)
        run = self.run_scene(text, drawing=DRAWING)
        self.assertEqual(run.warnings, ["load_on_supports"], run.said)
        self.assertIn("at any load factor", run.words)
        for where in ("foot", "top"):  # of which one corner is held, and none
            text = scene(loads={"press": {"type": "traction", "on": where, "pressure": 1e4}},
                         stages={"own": {"loads": {"weight": 1.0, "press": 1.0}}})
            self.assertEqual(self.run_scene(text).warnings, [], where)

    def test_soil_and_water_that_reach_nothing(self):
        """Levels are heights: one that is forgotten is 0, and the foot of a wall may be there."""
        for load in ({"type": "earth pressure", "on": "top"}, {"type": "water pressure", "on": "top", "level": -1.0}):
            text = scene(loads={"press": load}, stages={"own": {"loads": {"weight": 1.0, "press": 1.0}}})
            run = self.run_scene(text, drawing=DRAWING)
            self.assertEqual(run.warnings, ["load_without_force"], run.said)
            self.assertIn("presses on none of its facets", run.words)

    def test_a_load_that_is_nowhere_is_told_before_a_run(self):
        text = scene(loads={"beam": {"type": "point load", "x": 0.0, "y": 100.0, "fy": -1e3}},
                     stages={"own": {"loads": {"weight": 1.0, "beam": 1.0}}})
        self.refused(["scene > loads > beam > tolerance = 0.05 [m]", "the node nearest to (0, 100) m"], text)

    def test_lists_that_libraries_refuse(self):
        head, tail = scene().rsplit("</ParameterList>", 1)
        for key, name, value, words in (("MueLu", "smoother: type", "NONSENSE", "NONSENSE"), ("MueLu", "smother: type", "CHEBYSHEV", "smother: type"),
                                        ("Belos", "Verbosity", "loud", "Verbosity"), ("Belos unsymmetric", "Orthogonalization", "NOPE", "rthogonalization")):
            section = (f'<ParameterList name="solver"><ParameterList name="{key}"><Parameter name="{name}" type="string" value="{value}"/>'
                       "</ParameterList></ParameterList></ParameterList>")
            for ranks in (1, 2):
                self.refused([f"scene > solver > {key}", "is refused by", words], head + section + tail, ranks=ranks)

    def test_a_drawing_runs_no_programs(self):
        script = DRAWING + 'SystemCall "touch ran";\n'
        self.refused(["has SystemCall, which runs programs", "--trust"], scene(), drawing=script)
        self.refused(["Exit, which ends gmsh before it has meshed"], scene(), drawing=DRAWING + "Exit;\n")
        rooms = self.folder / "rooms"
        rooms.mkdir()
        self.refused(["made gmsh end by itself", "Exit"], scene(), "--trust", drawing=DRAWING + "Exit;\n",
                     environment={"TMPDIR": str(rooms)})
        self.assertEqual([path.name for path in rooms.glob("voussoir*")], [])
        trusted = self.run_scene(scene(), "--validate", "--trust", drawing=DRAWING + 'Printf("x") >> "said";\n')
        self.assertEqual(trusted.code, 0, trusted.said)
        harmless = DRAWING + '// SystemCall "touch ran";\nPrintf("Merge, Exit; and SystemCall");\n'
        self.assertEqual(self.run_scene(scene(), "--validate", drawing=harmless).code, 0)

    def test_a_drawing_that_fails_far_from_its_origin(self):
        far = stones.geo({name: [(x + 4e6, y + 4e6) for x, y in corners] for name, corners in WALL.items()}, 0.25, EDGES)
        self.refused(["gmsh could not mesh", "5.66e+06 m from its origin", "Move its origin"], scene(0.03),
                     drawing=far.replace("Transfinite", "//"))


if __name__ == "__main__":
    program.main()

"""A run says when it leaves what the model can tell: slips beyond a cell, turns beyond first order, stones in each other.

    range_of_the_model.py PROGRAM MPIEXEC
"""

import json
import math
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "restart"))
from runs import empty  # noqa: E402  (folders of their own)
from stones import OWN_WEIGHT, geo, polygon, rectangle, scene  # noqa: E402

XML = pathlib.Path(__file__).resolve().parents[2] / "xml"
PROGRAM = MPIEXEC = None
OUT_OF_RANGE = 3  # the exit code


class Run:
    def __init__(self, name, file, *settings, ranks=1):
        self.out = empty(f"range/{name}")
        launch = [MPIEXEC, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        command = [*launch, PROGRAM, f"--xml={file}", f"--out={self.out}"]
        for setting in settings:
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.code, self.text = done.returncode, done.stdout + done.stderr
        if self.code not in (0, OUT_OF_RANGE):
            raise AssertionError(f"exit code {self.code}\n{self.text}")
        self.result = json.loads((self.out / "result.json").read_text())
        self.outcome, self.last = self.result["outcome"], next(
            line for line in self.text.splitlines() if "Results are in" in line)

    def warnings(self, kind=None):
        return [w for w in self.result["warnings"] if kind in (None, w["what"])]

    def first_told(self):
        """Load factor or time of the first warning of a step: before, there was nothing to tell."""
        lines = [line for line in self.text.splitlines() if line.lstrip().startswith("WARNING")]
        found = filter(None, (re.search(r"load factor ([0-9.e-]+)|, ([0-9.e-]+) s:", line) for line in lines))
        return float(next(found).expand(r"\1\2").rstrip(":"))


def pose(name, stones, size, edges, *arguments, **sections):
    """Writes a drawing and its scene; the scene's file."""
    folder = pathlib.Path("range_scenes").resolve()
    folder.mkdir(exist_ok=True)
    (folder / f"{name}.geo").write_text(geo(stones, size, edges))
    file = folder / f"{name}.xml"
    file.write_text(scene(f"{name}.geo", list(edges), *arguments, **sections))
    return file


def ram_scene(name, table, far, pushes, increments, stone=(0.0, 1.0), side=1, **more):
    """A ram pushes a stone along a table of one stone or several, flush with each other; side -1 mirrors all."""
    def mirrored(x0, y0, x1, y1):
        return rectangle(x0, y0, x1, y1) if side > 0 else rectangle(-x1, y0, -x0, y1)
    west, east = stone
    stones = {"table" if k == 0 else f"table {k}": mirrored(x0, -0.5, x1, 0)
              for k, (x0, x1) in enumerate(zip(table, table[1:]))}
    edges = {f"foot of {name}": (name, 0) for name in stones}
    stones |= {"stone": mirrored(west, 0, east, 0.25), "ram": mirrored(west - 0.5, 0.1, west, 0.2)}
    edges["grip"] = ("ram", 3 if side > 0 else 1)
    loads = {"move": {"type": "settlement", "support": "grip", "ux": side * far}}
    stages = {"own weight": OWN_WEIGHT, "push": {"increments": increments, "loads": {"move": 1.0}}} if pushes else {
        "own weight": OWN_WEIGHT}
    smooth = {"smooth": {"between": "ram", "and": "stone", "friction coefficient": 0.0}}
    return pose(name, stones, 0.125, edges, loads, stages, 0.5, smooth, **more)


class Slips(unittest.TestCase):
    """A stone of 1 m, cells of 0.125 m. Over the edge it tips when its middle passes it, at 0.5 m."""

    def push(self, name, *arguments, settings=(), ranks=1, **how):
        return Run(name, ram_scene(name, *arguments, **how), *settings, ranks=ranks)

    def test_over_the_edge_on_either_side_the_run_ends_before_the_stone_would_tip(self):
        found = []
        for name, side, ranks, settings in (("east", 1, 1, ()), ("west", -1, 2, ("model/rotations=finite",))):
            run = self.push(name, (0, 1), 0.8, True, 8, side=side, ranks=ranks, settings=settings)
            self.assertEqual((run.outcome, run.code), ("out_of_range", OUT_OF_RANGE))
            self.assertLess(0.8 * run.result["load_factor"], 0.5)
            slip, = run.warnings("slip_beyond_cell")
            self.assertGreater(slip["how_much"], 0.125)
            self.assertIn("table", slip["where"])
            self.assertIn("stone", slip["where"])
            self.assertIn("stage 'push'", slip["when"])
            self.assertIn("Out of range: stage 'push'", run.last)
            self.assertTrue((run.out / "checkpoint.h5").exists())
            found.append((slip["how_much"], run.result["load_factor"]))
        # The same on the other side and on other ranks, to the tolerance of the solver; turns are nothing here.
        self.assertAlmostEqual(found[0][0], found[1][0], delta=1e-4)
        self.assertEqual(found[0][1], found[1][1])

    def test_on_a_long_table_a_warning_says_how_far_and_within_a_cell_nothing_is_said(self):
        run = self.push("long", (-1, 3), 0.3, True, 3)
        self.assertEqual((run.outcome, run.code), ("equilibrium", 0))
        slip, = run.warnings()
        self.assertEqual(slip["what"], "slip_beyond_cell")
        self.assertAlmostEqual(slip["how_much"], 0.3, delta=1e-4)
        self.assertAlmostEqual(run.first_told(), 2 / 3, delta=1e-5)  # 0.2 m; 0.1 m is within a cell
        self.assertNotIn("in line", slip["text"])
        self.assertIn("WARNING", run.last)
        self.assertIn("Equilibrium", run.last)

    def test_onto_the_next_stones_of_a_flush_bed_the_run_goes_on_with_a_warning(self):
        # The first and the last stone of the bed do not touch.
        run = self.push("flush", (0, 1, 1.25, 2), 0.9, True, 2, side=-1, ranks=2)
        self.assertEqual((run.outcome, run.code), ("equilibrium", 0))
        slip, = run.warnings()
        self.assertEqual(slip["what"], "slip_beyond_cell")
        self.assertAlmostEqual(slip["how_much"], 0.9, delta=1e-4)
        self.assertIn("forces go to the wrong ones of the stones in line", slip["text"])
        self.assertIn("WARNING", run.last)

    def test_a_lower_stone_does_not_continue_a_bed_and_all_points_end_like_adaptive(self):
        stones = {"table": rectangle(0, -0.5, 1, 0), "next": rectangle(1, -0.5, 2.5, -0.01),
                  "stone": rectangle(0, 0, 1, 0.25), "ram": rectangle(-0.5, 0.1, 0, 0.2)}
        edges = {"foot": ("table", 0), "foot of next": ("next", 0), "grip": ("ram", 3)}
        loads = {"move": {"type": "settlement", "support": "grip", "ux": 0.8}}
        stages = {"own weight": OWN_WEIGHT, "push": {"increments": 8, "loads": {"move": 1.0}}}
        smooth = {"smooth": {"between": "ram", "and": "stone", "friction coefficient": 0.0}}
        found = []
        for mode in ("adaptive", "all"):
            run = Run(f"lower {mode}", pose("lower", stones, 0.125, edges, loads, stages, 0.5, smooth),
                      f"selection/mode={mode}")
            self.assertEqual(run.outcome, "out_of_range")
            found.append(run.result["load_factor"])
        self.assertEqual(*found)

    def test_a_course_slides_over_a_course_until_it_passes_the_last_stone(self):
        # Two stones, the second pushed by the first, on stones that no support holds.
        for name, beds, ranks, outcome in (("course", (0, 0.5, 1, 1.5), 2, "equilibrium"),
                                           ("beyond the course", (0, 0.5, 1), 1, "out_of_range")):
            stones = {"ground": rectangle(-0.5, -0.25, 2, 0), "first": rectangle(0, 0.25, 0.5, 0.5),
                      "second": rectangle(0.5, 0.25, 1, 0.5), "ram": rectangle(-0.5, 0.3, 0, 0.4)}
            stones |= {f"bed {k}": rectangle(x0, 0, x1, 0.25) for k, (x0, x1) in enumerate(zip(beds, beds[1:]))}
            loads = {"move": {"type": "settlement", "support": "grip", "ux": 0.4}}
            stages = {"own weight": OWN_WEIGHT, "push": {"increments": 2, "loads": {"move": 1.0}}}
            smooth = {f"of the {stone}": {"between": stone, "friction coefficient": 0.1} for stone in ("first", "second")}
            run = Run(name, pose(name, stones, 0.125, {"foot": ("ground", 0), "grip": ("ram", 3)}, loads, stages, 0.6,
                                 smooth), ranks=ranks)
            self.assertEqual(run.outcome, outcome)
            self.assertIn("in line", run.warnings("slip_beyond_cell")[0]["text"])

    def test_a_load_factor_that_pushes_over_the_edge_is_no_equilibrium(self):
        file = ram_scene("factor", (0, 1), 0.8, False, 1,
                         load_factor={"pattern": {"move": 1.0}, "first factor": 0.2, "accuracy": 0.1})
        run = Run("factor", file)
        self.assertEqual((run.outcome, run.code), ("out_of_range", OUT_OF_RANGE))
        self.assertLess(0.8 * run.result["collapse"]["lower"], 0.5)
        self.assertIsNone(run.result["collapse"]["upper"])
        self.assertTrue(run.warnings("slip_beyond_cell"))

    def sliding(self, name, speed, ends):
        stones = {"table" if k == 0 else f"table {k}": rectangle(x0, -0.25, x1, 0)
                  for k, (x0, x1) in enumerate(zip(ends, ends[1:]))}
        feet = {f"foot of {name}": (name, 0) for name in stones}
        stones["stone"] = rectangle(0, 0, 1, 0.25)
        stages = {"own weight": OWN_WEIGHT, "sliding": {"duration": 0.6, "time step": 0.01}}
        file = pose(name, stones, 0.125, feet, {}, stages, 0.3,
                    initial_velocities={"push": {"blocks": "stone", "vx": speed}})
        return Run(name, file)

    def test_in_time_a_stone_passes_a_flush_stone_and_ends_the_run_at_the_last_edge(self):
        run = self.sliding("flung far", 3.5, (-0.5, 1, 1.5))  # would come to rest after v^2 / (2 mu g) = 2.1 m
        self.assertEqual(run.outcome, "out_of_range")
        slip = run.warnings("slip_beyond_cell")[0]
        self.assertIn("in line", slip["text"])
        self.assertIn(" s", slip["when"])
        self.assertGreater(run.first_told(), 0.125 / 3.5)  # within a cell nothing is said
        self.assertTrue(0.65 < slip["how_much"] < 1.0)  # of the whole bed: 0.5 m farther than over one stone


class Turns(unittest.TestCase):
    """Piers that turn with their ground: the weight passes b / h of the way when they have turned by half of b / h."""

    def pier(self, name, turn, stones, heat=0.0, **sections):
        outlines = {"ground": rectangle(0, -0.25, 0.5, 0)}
        for k, (low, high) in enumerate(zip(stones, stones[1:])):
            outlines[f"stone {k}"] = rectangle(0, low, 0.5, high)
        loads = {"turn": {"type": "settlement", "support": "foot", "rotation": turn, "about x": 0.25, "about y": 0.0}}
        stages = {"own weight": OWN_WEIGHT, "turn": {"increments": 5, "loads": {"turn": 1.0}}}
        if heat:
            loads["heat"] = {"type": "temperature", "change": heat}
            stages["own weight"] = {"loads": {**OWN_WEIGHT["loads"], "heat": 1.0}}
        return Run(name, pose(name, outlines, 0.25, {"foot": ("ground", 0)}, loads, stages, 5.0, **sections))

    def test_a_turn_is_told_as_a_share_of_the_angle_at_which_the_pier_topples(self):
        # 0.5 m wide and 2 m high it topples at 0.25 rad; in one piece or many. Elastic stones: 1e-4 of it.
        for name, stones in (("one", (0, 2)), ("five", (0, 0.5, 0.75, 1, 1.5, 2))):
            run = self.pier(name, 0.1, stones)
            self.assertEqual(run.outcome, "equilibrium")
            turn, = run.warnings("turn_beyond_first_order")
            self.assertAlmostEqual(turn["how_much"], 0.4, delta=4e-3)
            self.assertIn("ground", turn["where"])
            self.assertIn("WARNING", run.last)
            self.assertAlmostEqual(run.first_told(), 0.4, delta=1e-6)  # 16 %; 0.02 rad, 8 %, is not told of

    def test_what_heat_does_within_stones_turns_with_them(self):
        # The nodal forces of heat are a hundred times the weight; about the centre of their stone they have no moment.
        warm = self.pier("warm", 0.1, (0, 0.5, 2), heat=20.0)
        self.assertEqual(warm.outcome, "equilibrium")
        self.assertAlmostEqual(warm.warnings("turn_beyond_first_order")[0]["how_much"], 0.4, delta=4e-3)
        self.assertAlmostEqual(warm.first_told(), 0.4, delta=1e-6)

    def test_past_its_point_of_balance_a_pier_is_not_in_equilibrium(self):
        run = self.pier("fallen in three", -0.26, (0, 0.5, 1, 2))
        self.assertEqual((run.outcome, run.code), ("out_of_range", OUT_OF_RANGE))
        self.assertIn("point of balance", run.last)

    def test_a_bed_that_turns_by_half_its_angle_of_friction_says_so(self):
        stones = {"ground": rectangle(0, -0.25, 1, 0), "slab": rectangle(0, 0, 1, 0.125)}
        loads = {"turn": {"type": "settlement", "support": "foot", "rotation": 0.1}}
        stages = {"own weight": OWN_WEIGHT, "turn": {"loads": {"turn": 1.0}}}
        run = Run("slope", pose("slope", stones, 0.25, {"foot": ("ground", 0)}, loads, stages, 0.2))
        self.assertAlmostEqual(run.warnings("turn_beyond_first_order")[0]["how_much"], 0.5, delta=0.01)

    def test_a_wall_that_leans_as_one_counts_as_one(self):
        # Running bond, 4 courses of 0.25 m on a ground course, 1 m long: b / h = 1.
        size = ["mesh/wall/courses=4", "mesh/wall/blocks per course=2"]
        text = (XML / "wall.xml").read_text()
        file = pathlib.Path("range_scenes").resolve() / "wall.xml"
        file.parent.mkdir(exist_ok=True)
        tilt = ('<ParameterList name="tilt"><Parameter name="type" type="string" value="settlement"/>'
                '<Parameter name="support" type="string" value="ground"/>'
                '<Parameter name="rotation" type="double" value="0.2"/></ParameterList>')
        self.assertIn('<ParameterList name="sideways">', text)
        text = text.replace('<ParameterList name="sideways">', tilt + '<ParameterList name="sideways">', 1)
        text = text.replace('name="sideways" type="double"', 'name="tilt" type="double"')
        file.write_text(text)
        shares = []
        for ranks in (1, 2):
            run = Run(f"wall{ranks}", file, *size, ranks=ranks)
            shares.append(run.warnings("turn_beyond_first_order")[0]["how_much"])
        # The joints of a bond hold it together: it is as stable as one piece, give or take how they share.
        self.assertGreater(shares[0], 0.15)
        self.assertLess(shares[0], 0.6)
        self.assertAlmostEqual(shares[0], shares[1], delta=1e-6)

    def rocking(self, name, pulse, stones):
        outlines = {"ground": rectangle(0, -0.25, 0.6, 0)}
        for k, (low, high) in enumerate(zip(stones, stones[1:])):
            outlines[f"stone {k}"] = rectangle(0, low, 0.6, high)
        loads = {"pulse": {"type": "ground motion", "ax": pulse,
                           "time function": {"type": "pulse", "duration": 0.6}}}
        stages = {"own weight": OWN_WEIGHT,
                  "shaking": {"duration": 1.0, "time step": 0.01, "at once": True, "loads": {"pulse": 1.0}}}
        file = pose(name, outlines, 0.3, {"foot": ("ground", 0)}, loads, stages, 2.0,
                    steps={"time": {"stiffness damping": 1e-4}})
        return Run(name, file)

    def test_in_time_a_pier_that_rocks_is_told_of_and_one_past_its_balance_ends_the_run(self):
        # 0.6 m x 3 m topples at 0.2 rad. Rigid stones, first order: from 0.2 g on it rocks; by a third of it at 0.37 g.
        self.assertEqual(self.rocking("stands", 0.15 * 9.81, (0, 3)).warnings(), [])
        some = self.rocking("rocks", 0.37 * 9.81, (0, 3))
        self.assertEqual(some.outcome, "equilibrium")
        self.assertTrue(0.15 < some.warnings("turn_beyond_first_order")[0]["how_much"] < 0.8)
        far = self.rocking("topples in two", 0.7 * 9.81, (0, 1.2, 3))
        self.assertEqual((far.outcome, far.code), ("out_of_range", OUT_OF_RANGE))
        self.assertIn("point of balance", far.last)
        self.assertTrue(far.warnings("turn_beyond_first_order"))


class Overlaps(unittest.TestCase):
    """Stones drawn apart, or touching elsewhere, that end in one place."""

    def leaning(self, name, *settings, ranks=1, **more):
        gap = 0.04
        stones = {"west foot": rectangle(0, -0.25, 0.5, 0), "west": rectangle(0, 0, 0.5, 2),
                  "east foot": rectangle(0.5 + gap, -0.25, 1 + gap, 0), "east": rectangle(0.5 + gap, 0, 1 + gap, 2)}
        loads = {"turn": {"type": "settlement", "support": "west ground", "rotation": -0.04, "about x": 0.5,
                          "about y": 0.0}}
        stages = {"own weight": OWN_WEIGHT, "turn": {"increments": 4, "loads": {"turn": 1.0}}, **more.pop("then", {})}
        edges = {"west ground": ("west foot", 0), "east ground": ("east foot", 0)}
        return Run(name, pose(name, stones, 0.25, edges, loads, stages, 0.7, **more), *settings, ranks=ranks)

    def test_a_pier_that_leans_into_its_neighbour_is_told_by_how_much(self):
        # The top moves by 2 m sin 0.04 = 0.08 m; elastic stones bend by microns. At half of it they only touch.
        alone, = self.leaning("leaning alone", "model/rotations=finite").warnings()
        run = self.leaning("leaning", "model/rotations=finite", ranks=4)
        self.assertAlmostEqual(alone["how_much"], run.warnings()[0]["how_much"], delta=1e-8)
        overlap, = run.warnings()  # none of a turn by 16 % of the angle at which it topples: finite rotations follow it
        self.assertEqual(overlap["what"], "stones_overlap")
        self.assertAlmostEqual(overlap["how_much"], 2 * math.sin(0.04) - 0.04, delta=2e-5)
        self.assertIn("(west)", overlap["where"])
        self.assertIn("(east)", overlap["where"])
        self.assertIn("WARNING", run.last)
        self.assertAlmostEqual(run.first_told(), 0.75, delta=1e-6)

    def test_small_rotations_find_it_too_and_stones_not_built_are_not_there(self):
        building = {"wait": {"blocks": "east", "appears": "later"}}
        without = self.leaning("not built", then={"later": {"loads": {"turn": 1.0}}}, construction=building)
        overlap, = without.warnings("stones_overlap")
        self.assertIn("'later'", overlap["when"])
        self.assertNotIn("'turn', load factor 1: these stones", without.text)
        self.assertAlmostEqual(overlap["how_much"], 0.04, delta=1e-3)

    def test_in_time_a_stone_that_slides_into_another_is_found(self):
        stones = {"table": rectangle(-0.5, -0.25, 3, 0), "stone": rectangle(0, 0, 0.5, 0.25),
                  "other": rectangle(0.55, 0, 1.05, 0.25)}
        stages = {"own weight": OWN_WEIGHT, "sliding": {"duration": 0.3, "time step": 0.01}}
        file = pose("driven", stones, 0.25, {"foot": ("table", 0)}, {}, stages, 0.3,
                    initial_velocities={"push": {"blocks": "stone", "vx": 0.9}})
        run = Run("driven", file)
        overlap, = run.warnings("stones_overlap")
        way = 0.9**2 / (2 * 0.3 * 9.81)  # until friction has stopped it
        self.assertAlmostEqual(overlap["how_much"], way - 0.05, delta=2e-3)

    def test_stones_that_touch_along_one_joint_may_meet_elsewhere(self):
        # A stone on the foot of a block, pushed into the block's upright.
        block = polygon([(0, 0), (1.25, 0), (1.25, 0.75), (1, 0.75), (1, 0.25), (0, 0.25)])
        stones = {"block": block, "stone": rectangle(0.25, 0.25, 0.75, 0.5), "ram": rectangle(-0.25, 0.3, 0.25, 0.4)}
        edges = {"foot": ("block", 0), "grip": ("ram", 3)}
        loads = {"move": {"type": "settlement", "support": "grip", "ux": 0.3}}
        stages = {"own weight": OWN_WEIGHT, "push": {"increments": 2, "loads": {"move": 1.0}}}
        smooth = {"smooth": {"between": "ram", "and": "stone", "friction coefficient": 0.0}}
        run = Run("upright", pose("upright", stones, 0.25, edges, loads, stages, 0.5, smooth))
        overlap, = run.warnings("stones_overlap")
        self.assertAlmostEqual(overlap["how_much"], 0.05, delta=1e-3)
        self.assertIn("(block)", overlap["where"])

    def test_a_wall_that_is_pushed_is_not_told_of(self):
        run = Run("pushed", XML / "wall.xml", "mesh/wall/courses=4", "mesh/wall/blocks per course=4")
        self.assertEqual(run.warnings(), [])
        self.assertNotIn("WARNING", run.text)


if __name__ == "__main__":
    MPIEXEC = sys.argv.pop(2)
    PROGRAM = sys.argv.pop(1)
    unittest.main()

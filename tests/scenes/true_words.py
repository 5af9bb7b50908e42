"""What is said of a result is true of it: mechanisms, margins, the largest of a motion, factors of safety, lines of thrust.

    true_words.py PROGRAM MPIEXEC
"""

import math
import pathlib
import random
import subprocess
import sys

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "support"), str(ROOT / "drivers" / "report")]
import chains  # noqa: E402
import program  # noqa: E402
import read_results  # noqa: E402
import stones  # noqa: E402

PUSH = {"push": {"type": "acceleration", "ax": 9.81}}
RAISED = {"load_factor": {"pattern": {"push": 1.0}}}
SLAB = stones.rectangle(-0.8, -0.3, 0.8, 0)


def scene(supports=("ground",), loads=None, stages=None, **sections):
    return stones.scene("stones.geo", list(supports), loads or {}, stages or {"own weight": stones.OWN_WEIGHT}, **sections)


def surveyed_wall(seed, courses=4, across=4, uneven=0.03):
    """A wall in bond on a slab, whose beds bend at every joint above or below, as far as a survey finds them uneven [m]."""
    lot, height, width = random.Random(seed), 0.3, 0.5

    def joints(row):
        return [0.0, *[width * (k + row % 2 / 2) for k in range(1 - row % 2, across)], width * across]

    beds = []
    for row in range(courses + 1):
        places = {x for r in (row - 1, row) if 0 <= r < courses for x in joints(r)}
        flat = row in (0, courses)
        beds.append(sorted((x, round(height * row + (0 if flat else lot.uniform(-uneven, uneven)), 6)) for x in sorted(places)))
    end = width * across
    outlines = {"slab": stones.polygon([(-0.3, -0.3), (end + 0.3, -0.3), (end + 0.3, 0), *beds[0][::-1], (-0.3, 0)])}
    for row in range(courses):
        for k, (a, b) in enumerate(zip(joints(row), joints(row)[1:])):
            low, high = ([p for p in bed if a <= p[0] <= b] for bed in beds[row:row + 2])
            outlines[f"stone {row} {k}"] = stones.polygon([*low, *high[::-1]])
    return outlines


def ring(name, radius, depth, voussoirs, x=0.0, y=0.0, first=0.0, last=math.pi):
    """Voussoirs from left to right between two angles from the left horizon; their names begin with a name."""
    def at(rho, k):
        angle = math.pi - first - (last - first) * k / voussoirs
        return (round(x + rho * math.cos(angle), 9), round(y + rho * math.sin(angle), 9))

    return {f"{name} {k}": stones.polygon([at(radius, k), at(radius, k + 1), at(radius + depth, k + 1), at(radius + depth, k)])
            for k in range(voussoirs)}


def sets(drawing, groups):
    """Adds sets of stones by their names."""
    number = {line.split('"')[1]: line.split("{")[1].split("}")[0] for line in drawing.splitlines() if "Physical Surface" in line}
    return drawing + "".join(f'Physical Surface("{name}") = {{{", ".join(number[s] for s in members)}}};\n'
                             for name, members in groups.items())


def springings(*names):
    """Sets of the joints of springers with the ground: the last side of a first voussoir, the first of a last one."""
    return {f"{name} {side}": (stone, edge) for name, first, last in names
            for side, stone, edge in (("left", first, 3), ("right", last, 1))}


class Mechanisms(program.SceneTest):
    def fallen(self, outlines, *options, friction=0.6, ground=("slab", 0), **sections):
        run = self.run_scene(scene(loads=PUSH, friction=friction, **(sections or RAISED)), *options,
                             drawing=stones.geo(outlines, 0.1, {"ground": ground}))
        self.assertEqual(run.outcome, "collapse", run.said)
        return run

    def motion(self, run):
        """Displacements of the mechanism on all nodes; its largest component is 1."""
        with h5py.File(run.folder / "fields.h5", "r") as file:
            last = file["steps"][max(file["steps"])]
            self.assertIn("mechanism", last.attrs["stage"] if isinstance(last.attrs["stage"], str) else last.attrs["stage"].decode())
            return last["displacement"][()]

    def test_a_flat_stone_that_is_pushed_slides_to_the_right_and_does_not_rise(self):
        outlines = {"slab": SLAB, "stone": stones.rectangle(-0.5, 0, 0.5, 0.2)}
        for options in ((), ("--limit-analysis",)):
            with self.subTest(options=options):
                run = self.fallen(outlines, *options)
                self.assertIn("(stone): to the right; joints that slide:", run.result["message"])
                self.assertFalse(run.result["mechanism"]["dilates"])
                self.assertLess(np.abs(self.motion(run)[:, 1]).max(), 1e-4)

    def test_a_stack_a_row_and_a_wall_slide_without_rising(self):
        # Beds are rougher above, so that all slide on the slab.
        stack = {"slab": SLAB, "lower": stones.rectangle(-0.6, 0, 0.6, 0.15), "upper": stones.rectangle(-0.5, 0.15, 0.5, 0.3)}
        run = self.run_scene(scene(loads=PUSH, joints={"upper bed": {"friction coefficient": 0.9, "between": "lower", "and": "upper"}},
                                   friction=0.4, **RAISED), drawing=stones.geo(stack, 0.1, {"ground": ("slab", 0)}))
        self.assertEqual(run.outcome, "collapse", run.said)
        self.assertNotIn(" up", run.result["message"].split("blocks move")[1].split(";")[0])
        self.assertLess(np.abs(self.motion(run)[:, 1]).max(), 1e-4)

    def test_a_stone_goes_down_its_slope(self):
        slope = 0.7
        bed = stones.polygon([(-1, -2), (1, -2), (1, -slope), (-1, slope)])
        stone = stones.polygon([(-1, slope), (1, -slope), (1, 0.3 - slope), (-1, 0.3 + slope)])
        run = self.run_scene(scene(friction=0.6), drawing=stones.geo({"bed": bed, "stone": stone}, 0.2, {"ground": ("bed", 0)}))
        self.assertEqual(run.outcome, "collapse", run.said)
        self.assertIn("(stone): down and to the right; joints that slide", run.result["message"])
        motion = self.motion(run)
        moved = motion[np.abs(motion).max(1) > 0.1]
        self.assertLess(np.abs(moved[:, 1] + slope * moved[:, 0]).max(), 1e-4)

    def test_a_stone_that_tips_rises(self):
        run = self.fallen({"slab": SLAB, "stone": stones.rectangle(-0.1, 0, 0.1, 0.5)})
        self.assertIn("turning clockwise", run.result["message"])
        self.assertIn("joints that open like hinges", run.result["message"])
        self.assertGreater(self.motion(run)[:, 1].max(), 0.1)

    def test_a_wedge_goes_down_between_stones_that_it_drives_apart(self):
        outlines = {"slab": stones.rectangle(-3, -0.3, 3, 0), "left": stones.polygon([(-2, 0), (-0.2, 0), (-0.5, 0.8), (-2, 0.8)]),
                    "right": stones.polygon([(0.2, 0), (2, 0), (2, 0.8), (0.5, 0.8)]),
                    "wedge": stones.polygon([(-0.35, 0.4), (0.35, 0.4), (0.5, 0.8), (-0.5, 0.8)])}
        # The flanks of the boxes are longer than those of the wedge: their upper half alone is a joint.
        press = {"press": {"type": "traction", "on": "top", "pressure": 1e4}}
        run = self.run_scene(scene(loads=press, friction=0.2, load_factor={"pattern": {"press": 1.0}}), "--limit-analysis",
                             drawing=stones.geo(outlines, 0.2, {"ground": ("slab", 0), "top": ("wedge", 2)}))
        self.assertEqual(run.outcome, "collapse", run.said)
        self.assertIn("(wedge)", run.result["message"])
        self.assertIn("down", run.result["message"].split("(wedge)")[1].split(";")[0])
        self.assertGreater(self.motion(run)[:, 1].max(), -1e-9)
        self.assertLess(self.motion(run)[:, 1].max(), 1e-4)  # nothing rises

    def test_stones_of_a_surveyed_wall_slide_to_the_right(self):
        # The last two move otherwise than their mechanisms, in which what slides must lift: as slip without dilatancy does.
        for seed, friction in ((0, 0.25), (5, 0.4), (1, 0.4), (6, 0.4)):
            with self.subTest(seed=seed):
                run = self.run_scene(scene(loads=PUSH, friction=friction, **RAISED), "--limit-analysis", out=f"wall {seed}",
                                     drawing=stones.geo(surveyed_wall(seed), 0.15, {"ground": ("slab", 0)}))
                self.assertEqual(run.outcome, "collapse", run.said)
                self.assertFalse(run.result["mechanism"]["dilates"])
                words = run.result["message"].split(" move")[1]
                self.assertIn("to the right; joints that", words)
                self.assertNotIn(" up ", words.split(";")[0])

    def test_what_must_lift_in_the_proof_says_so(self):
        # The second wall of Ferris and Tin-Loi falls at 0.563 where slip does not dilate: the proof is of 0.580.
        run = self.run_scene(ROOT / "xml" / "ferris-tin-loi-wall.xml", "--limit-analysis", "--set", "mesh/gmsh/geometry/wall=2")
        self.assertTrue(run.result["mechanism"]["dilates"])
        self.assertIn("this is the motion of slip that dilates", run.result["message"])

    def test_ranks_tell_the_same_motion(self):
        outlines = {"slab": SLAB, "stone": stones.rectangle(-0.5, 0, 0.5, 0.2)}
        drawing = stones.geo(outlines, 0.1, {"ground": ("slab", 0)})
        told = [self.run_scene(scene(loads=PUSH, **RAISED), drawing=drawing, out=f"on {ranks}", ranks=ranks).result["message"]
                for ranks in (1, 2)]
        self.assertEqual(*told)


class Margins(program.SceneTest):
    """Stones lie on beds that bend and in corners, pushed as far as they stand: no joint is told to bear more than it can."""

    def margins(self, outlines, push, friction=0.6, size=0.1):
        stages = {"own weight": stones.OWN_WEIGHT, "push": {"increments": 2, "loads": {"push": push}}}
        run = self.run_scene(scene(loads=PUSH, stages=stages, friction=friction),
                             drawing=stones.geo(outlines, size, {"ground": ("slab", 0)}))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        rows = [row for row in run.table("joints.csv") if not math.isnan(row["friction_margin"])]
        self.assertTrue(rows)
        for row in rows:
            self.assertGreaterEqual(row["friction_margin"], 0)
            self.assertGreaterEqual(row["edge_margin"], 0)
        self.assertGreaterEqual(run.result["statics"]["least_friction_margin"], 0)
        self.assertGreaterEqual(run.result["statics"]["least_edge_margin"], 0)
        return rows

    def bed(self, top, height=0.4):
        """A slab and a stone between x = -0.5 and 0.5 whose joint is a line of points from left to right."""
        slab = stones.polygon([(-0.8, -0.3), (0.8, -0.3), (0.8, top[-1][1]), *top[::-1], (-0.8, top[0][1])])
        return {"slab": slab, "stone": stones.polygon([*top, (0.5, height), (-0.5, height)])}

    def test_a_ridge_of_two_facets(self):
        h = 0.5 * math.tan(math.radians(5))
        (row,) = self.margins(self.bed([(-0.5, 0.0), (0.0, h), (0.5, 0.0)]), 0.62)
        self.assertEqual(row["sides"], 2)
        self.assertLess(row["friction_margin"], 0.2)

    def test_a_bed_of_three_directions(self):
        (row,) = self.margins(self.bed([(-0.5, 0.0), (-0.2, 0.04), (0.2, 0.04), (0.5, 0.0)]), 0.6)
        self.assertEqual(row["sides"], 3)

    def test_a_curved_bed_of_many_facets(self):
        line = [(round(-0.5 + k / 12, 9), round(0.1 * math.cos(math.pi * (k / 12 - 0.5)), 9)) for k in range(13)]
        (row,) = self.margins(self.bed(line), 0.6)
        self.assertEqual(row["sides"], 1)

    def test_a_stone_in_a_corner_has_two_sides(self):
        slab = stones.polygon([(-0.8, -0.3), (0.9, -0.3), (0.9, 0.5), (0.5, 0.5), (0.5, 0), (-0.8, 0)])
        (row,) = self.margins({"slab": slab, "stone": stones.rectangle(-0.5, 0, 0.5, 0.3)}, 1.5)
        self.assertEqual(row["sides"], 2)
        self.assertLess(row["friction_margin"], 0.5)

    def test_a_straight_bed_is_as_statics_has_it(self):
        (row,) = self.margins(self.bed([(-0.5, 0.0), (0.5, 0.0)], 0.2), 0.3)
        self.assertAlmostEqual(row["friction_margin"], 0.5, delta=1e-6)
        self.assertAlmostEqual(row["edge_margin"], 0.5 - 0.3 * 0.1, delta=1e-6)
        self.assertAlmostEqual(row["edge_x_m"], 0.5, delta=1e-9)


class LargestOverTime(program.SceneTest):
    """A little tower is shaken and left to itself: what it moved by at most is told, when that was, and what is left."""

    LOADS = {"shock": {"type": "ground motion", "ax": 2.5, "time function": {"type": "pulse", "duration": 0.2}}}
    OUTLINES = {"base": stones.rectangle(-0.6, -0.3, 0.6, 0),
                **{f"stone {k}": stones.rectangle(-0.25, 0.25 * k, 0.25, 0.25 * (k + 1)) for k in range(3)}}
    SHAKING = {"own weight": stones.OWN_WEIGHT,
               "shaking": {"duration": 0.4, "time step": 0.005, "at once": True, "loads": {"shock": 1.0}}}

    def shake(self, stages, *options, out="out"):
        text = scene(loads=self.LOADS, stages=stages, steps={"time": {"mass damping": 20.0}}, output={"checkpoint at end": True})
        run = self.run_scene(text, *options, drawing=stones.geo(self.OUTLINES, 0.15, {"ground": ("base", 0)}), out=out)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run

    def check(self, run):
        """The result against the rows of the history."""
        moved = [row["largest_displacement_m"] for row in run.history]
        largest = max(range(len(moved)), key=moved.__getitem__)
        self.assertEqual(run.result["largest_displacement_m"], moved[largest])
        self.assertEqual(run.result["residual_displacement_m"], moved[-1])
        self.assertAlmostEqual(run.result["largest_displacement_time_s"], run.history[largest]["time_s"], delta=1e-12)
        return moved

    def test_the_largest_of_all_steps_is_told_with_its_time_and_the_residual_beside_it(self):
        run = self.shake(self.SHAKING)
        moved = self.check(run)
        self.assertGreater(max(moved), 2 * moved[-1])
        page = self.report(run)
        self.assertIn(f"at {run.result['largest_displacement_time_s']:.4g} s; at the end", page)
        self.assertIn("the residual", page)
        self.assertNotIn("Load factor reached", page)
        self.assertIn("Time reached", page)
        self.assertIn("over the", page)  # openings and slips of all recorded steps

    def report(self, run):
        subprocess.run([sys.executable, "-B", ROOT / "drivers" / "report" / "make_report.py", run.folder], check=True,
                       stdout=subprocess.DEVNULL)
        page = (run.folder / "report.html").read_text(encoding="utf-8")
        self.assertNotIn("could not be drawn", page)
        return page

    def test_it_is_kept_through_further_stages_in_time_and_in_load_steps(self):
        longer = {**self.SHAKING, "rest": {"duration": 0.1, "time step": 0.01, "at once": True, "loads": {"shock": 0.0}}}
        first = self.shake(self.SHAKING, out="first")
        again = self.shake(longer, "--restart", out="first")
        whole = self.shake(longer, out="whole")
        for run in (again, whole):
            self.check(run)
        for key in ("largest_displacement_m", "largest_displacement_time_s"):
            self.assertEqual(again.result[key], first.result[key])
            self.assertEqual(again.result[key], whole.result[key])
        at_rest = self.shake({**self.SHAKING, "at rest": {"loads": {"shock": 0.0}}}, out="rest")
        moved = [row["largest_displacement_m"] for row in at_rest.history]
        self.assertEqual(at_rest.result["largest_displacement_m"], max(moved))
        self.assertEqual(at_rest.result["largest_displacement_time_s"], first.result["largest_displacement_time_s"])
        self.assertEqual(at_rest.result["residual_displacement_m"], moved[-1])
        self.assertIn("Load factor reached", self.report(at_rest))

    def test_load_steps_alone_have_no_time(self):
        run = self.shake({"own weight": stones.OWN_WEIGHT, "lighter": {"loads": {"weight": 0.5}}})
        self.assertIsNone(run.result["largest_displacement_time_s"])
        self.assertGreater(run.result["largest_displacement_m"], 1.5 * run.result["residual_displacement_m"])
        self.assertIn("of all steps; at the end", self.report(run))


TWO = {**ring("inner", 2.0, 0.2, 9, first=0.4, last=math.pi - 0.4), **ring("outer", 2.2, 0.2, 9, first=0.4, last=math.pi - 0.4)}
TWO_SPRINGINGS = springings(("inner", "inner 0", "inner 8"), ("outer", "outer 0", "outer 8"))
ONE = ring("voussoir", 2.0, 0.4, 9, first=0.4, last=math.pi - 0.4)
ONE_SPRINGINGS = springings(("", "voussoir 0", "voussoir 8"))


class FactorsOfSafety(program.SceneTest):
    def limit(self, outlines, edges, **sections):
        run = self.run_scene(scene(supports=edges, **sections), "--limit-analysis", drawing=stones.geo(outlines, 0.2, edges))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run.result

    def test_an_arch_of_one_ring_has_one(self):
        result = self.limit(ONE, ONE_SPRINGINGS)
        factor = result["rigid"]["geometric_factor_of_safety"]
        self.assertAlmostEqual(factor, 1 / (1 - result["rigid"]["free_share_of_joints"]), delta=1e-9)
        self.assertIn(f"a geometric factor of safety of {factor:.6g} or more", result["message"])

    def test_two_rings_have_the_share_of_every_joint_and_no_factor(self):
        result = self.limit(TWO, TWO_SPRINGINGS)
        self.assertIsNone(result["rigid"]["geometric_factor_of_safety"])
        self.assertNotIn("factor of safety", result["message"])
        self.assertIn("a share of every joint, of those between rings, courses and backing too, and not the factor of one arch",
                      result["message"])

    def test_where_the_search_ends_at_least_is_said_and_no_factor(self):
        wall = {"slab": stones.rectangle(0, -0.3, 2, 0)}
        for row in range(2):
            for k in range(2):
                wall[f"stone {row} {k}"] = stones.rectangle(k, 0.5 * row, k + 1, 0.5 * (row + 1))
        for outlines in (wall, {"slab": SLAB, "stone": stones.rectangle(-0.5, 0, 0.5, 0.5)}):
            result = self.limit(outlines, {"ground": ("slab", 0)})
            self.assertTrue(result["rigid"]["free_share_is_at_least"])
            self.assertIsNone(result["rigid"]["geometric_factor_of_safety"])
            self.assertIn("they can leave at least 99.9023 % of every dry joint free, where the search for more ends", result["message"])
            self.assertNotIn("factor of safety", result["message"])


class LinesOfThrust(program.SceneTest):
    def found(self, outlines, edges, groups=None, size=0.2, report=False, **sections):
        """The chains of a structure under its weight, and its report where that is asked for."""
        run = self.run_scene(scene(supports=edges, **sections), drawing=sets(stones.geo(outlines, size, edges), groups or {}))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        results = read_results.read_results(run.folder)
        found = chains.find_chains(results.mesh, results.joints, results.standing)
        if not report:
            return found, ""
        subprocess.run([sys.executable, "-B", ROOT / "drivers" / "report" / "make_report.py", run.folder], check=True,
                       stdout=subprocess.DEVNULL)
        page = (run.folder / "report.html").read_text(encoding="utf-8")
        self.assertNotIn("could not be drawn", page)
        return found, page

    def test_each_of_two_rings_has_one_whatever_sets_are_called_also_where_stones_lie_in_two(self):
        groups = {"ring": list(TWO), "soffit": [s for s in TWO if s.startswith("inner")], "back": [s for s in TWO if s.startswith("outer")]}
        found, page = self.found(TWO, TWO_SPRINGINGS, groups, report=True)
        self.assertEqual([(c.name, c.kind, len(c.joints)) for c in found], [("back", "arch", 8), ("soffit", "arch", 8)])
        self.assertIn("line of thrust, through the resultants", page)
        self.assertNotIn("No line of thrust", page)
        self.assertIn("<td>none</td>", page)  # a ring that another presses on has no factor of its own

    def test_a_ring_with_backing_keeps_its_line(self):
        corner = lambda k: ONE[f"voussoir {k}"][3]
        left = stones.polygon([(-2.7, corner(0)[1]), corner(0), corner(1), corner(2), (-2.7, corner(2)[1])])
        right = stones.polygon([(-x, y) for x, y in left][::-1])
        outlines = {**ONE, "left": left, "right": right}
        edges = {**ONE_SPRINGINGS, "left ground": ("left", 0), "left wall": ("left", 4),
                 "right ground": ("right", 3), "right wall": ("right", 4)}
        found, _ = self.found(outlines, edges)
        self.assertEqual([(c.kind, len(c.blocks)) for c in found], [("arch", 9)])
        self.assertFalse(found[0].alone)

    def test_three_spans_have_three(self):
        outlines, edges = {}, {}
        for k in range(3):
            outlines.update(ring(f"span {k}", 1.0, 0.25, 7, x=2.8 * k, first=0.5, last=math.pi - 0.5))
        half = 1.25 * math.cos(0.5), 1.25 * math.sin(0.5)
        inner = math.cos(0.5), math.sin(0.5)
        for k in range(2):  # a pier of three blocks, whose top carries both springings
            a, b = 2.8 * k, 2.8 * (k + 1)
            top = [(round(a + inner[0], 9), round(inner[1], 9)), (round(b - inner[0], 9), round(inner[1], 9)),
                   (round(b - half[0], 9), round(half[1], 9)), (round(a + half[0], 9), round(half[1], 9))]
            low = [(top[0][0], 0.0), (top[1][0], 0.0)]
            outlines[f"pier {k} top"] = stones.polygon([*low, top[1], top[2], top[3], top[0]])
            for row, y in enumerate((-0.5, -1.0)):
                outlines[f"pier {k} {row}"] = stones.rectangle(low[0][0], y, low[1][0], y + 0.5)
            edges[f"foot {k}"] = (f"pier {k} 1", 0)
        edges.update({"west": ("span 0 0", 3), "east": ("span 2 6", 1)})
        found, _ = self.found(outlines, edges)
        arches = [c for c in found if c.kind == "arch"]
        self.assertEqual([len(c.blocks) for c in arches], [7, 7, 7])

    def test_a_tower_has_one_and_a_wall_in_its_bond_the_word_why_it_has_none(self):
        tower = {f"stone {k}": stones.rectangle(0, 0.3 * k, 0.6, 0.3 * (k + 1)) for k in range(5)}
        found, page = self.found(tower, {"ground": ("stone 0", 0)}, report=True)
        self.assertEqual([(c.kind, len(c.joints), c.alone) for c in found], [("column", 4, True)])
        self.assertNotIn("No line of thrust", page)
        wall = {}
        for row in range(5):
            joints = [0, 1, 2, 3] if row % 2 else [0, 0.5, 1.5, 2.5, 3]
            for k, (a, b) in enumerate(zip(joints, joints[1:])):
                wall[f"stone {row} {k}"] = stones.rectangle(a, 0.5 * row, b, 0.5 * (row + 1))
        ground = {f"ground {k}": (f"stone 0 {k}", 0) for k in range(4)}
        found, page = self.found(wall, ground, size=0.25, report=True)
        self.assertEqual(found, [])
        self.assertIn("No line of thrust is drawn: no row of three or more stones", page)

    def test_a_doorway_has_one_from_jamb_to_jamb(self):
        outlines = {"slab": stones.rectangle(-1.2, -0.3, 1.2, 0), "left": stones.rectangle(-1, 0, -0.5, 1), "right": stones.rectangle(0.5, 0, 1, 1)}
        outlines["key"] = stones.polygon([(-0.2, 1), (0.2, 1), (0.3, 1.4), (-0.3, 1.4)])
        outlines["left lintel"] = stones.polygon([(-1, 1), (-0.5, 1), (-0.2, 1), (-0.3, 1.4), (-1, 1.4)])
        outlines["right lintel"] = stones.polygon([(0.2, 1), (0.5, 1), (1, 1), (1, 1.4), (0.3, 1.4)])
        found, _ = self.found(outlines, {"ground": ("slab", 0)})
        self.assertEqual([c.kind for c in found], ["arch"])


if __name__ == "__main__":
    program.main()

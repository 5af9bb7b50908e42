"""Supports along the normals of faces that are inclined: what they hold slides freely along them.

usage: inclined_supports.py PROGRAM MPIEXEC

Set-up    Two stones, one on the other, on a slope of 25 degrees without friction, held on their lower side: both supports
          hold along the normal alone. The same drawn level, with gravity turned. A barrel vault of 120 degrees whose
          springings are held along their normals, which slide along the abutments.
Expected  The slope bears W cos and the side W sin, each along its normal. The level drawing gives the motions turned back.
          A support that moves takes the stones along by what of it lies along the normal. The upper stone slides down when
          gravity along the slope has grown by mu cos - sin. Springings of half an angle b bear W / (2 sin b) each.
Tolerance 1e-8 of the weight, the tolerance of the solver; motions 1e-7 of the largest.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import stones  # noqa: E402

GRAVITY = 9.81
SLOPE = math.radians(25.0)
MU = 0.6
WEIGHT = 2000 * GRAVITY * 1.0  # [N] of two stones of 1 m x 0.5 m, one metre thick
NORMAL = {"bed": {"on": "bed", "components": "normal"}, "toe": {"on": "toe", "components": "normal"}}


def turned(x, y, angle):
    return x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)


def drawing(angle):
    def stone(low, high):
        return stones.polygon([turned(x, y, angle) for x, y in ((0, low), (1, low), (1, high), (0, high))])
    return stones.geo({"lower": stone(0, 0.5), "upper": stone(0.5, 1)}, 0.25, {"bed": ("lower", 0), "toe": ("lower", 3)}) + (
        "Transfinite Surface{1, 2};\n")  # the same cells, whichever way they are turned


def scene(supports=None, loads=None, stages=None, **sections):
    return stones.scene("stones.geo", supports or NORMAL, loads or {}, stages or {"own weight": stones.OWN_WEIGHT}, MU,
                        observations={"upper": {"place": "mean", "blocks": "upper"}, "lower": {"place": "mean", "blocks": "lower"},
                                      "toe": {"place": "support", "support": "toe"}}, **sections)


def motions(row):
    return [row[f"u{c}_m of {name}"] for name in ("upper", "lower") for c in "xy"]


class OnASlope(program.SceneTest):
    def check_reactions(self, reactions, angle=SLOPE, weight=WEIGHT):
        expected = {"bed": turned(0, weight * math.cos(angle), angle), "toe": turned(weight * math.sin(angle), 0, angle)}
        for name, force in expected.items():
            for c, value in zip("xy", force):
                self.assertLess(abs(reactions[name][c + "_N"] - value), 1e-8 * weight, (name, reactions[name], force))

    def test_what_each_bears_on_any_number_of_ranks(self):
        first = None
        for ranks in (1, 2, 4):
            run = self.run_scene(scene(), drawing=drawing(SLOPE), out=f"ranks {ranks}", ranks=ranks)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            self.assertEqual(run.warnings, [], run.said)
            self.check_reactions(run.result["statics"]["reactions"])
            # A support that is observed shows the same force.
            for c in "xy":
                self.assertLess(abs(run.history[-1][f"f{c}_N of toe"] - run.result["statics"]["reactions"]["toe"][c + "_N"]),
                                1e-8 * WEIGHT)
            first = first or motions(run.history[-1])
            for a, b in zip(first, motions(run.history[-1])):
                self.assertLess(abs(a - b), 1e-7 * max(map(abs, first)))

    def test_a_turned_drawing_gives_the_turned_answer(self):
        push = {"gravity": {"type": "acceleration", "ax": -GRAVITY * math.sin(SLOPE), "ay": -GRAVITY * math.cos(SLOPE)}}
        stage = {"own weight": {"loads": {"gravity": 1.0}}}
        along_axes = {"bed": {"on": "bed", "components": "y"}, "toe": {"on": "toe", "components": "x"}}
        everything = {"selection": {"mode": "all"}}
        inclined = self.run_scene(scene(**everything), drawing=drawing(SLOPE), out="inclined")
        level = self.run_scene(scene(None, push, stage, **everything), drawing=drawing(0.0), out="level")
        axes = self.run_scene(scene(along_axes, push, stage, **everything), drawing=drawing(0.0), out="axes")
        found = motions(inclined.history[-1])
        for other in (level, axes):
            at = motions(other.history[-1])
            back = [*turned(*at[:2], SLOPE), *turned(*at[2:], SLOPE)]
            for a, b in zip(found, back):
                self.assertLess(abs(a - b), 1e-7 * max(map(abs, found)), (found, back))

    def test_it_goes_on_after_a_restart(self):
        two = {"own weight": stones.OWN_WEIGHT, "more": {"loads": {"weight": 1.5}}}
        whole = self.run_scene(scene(stages=two), drawing=drawing(SLOPE), out="whole")
        self.run_scene(scene(), drawing=drawing(SLOPE), out="first")
        run = self.run_scene(scene(stages=two), f"--restart-from={self.folder / 'first'}", drawing=drawing(SLOPE), out="second")
        self.assertEqual(run.outcome, "equilibrium", run.said)
        self.check_reactions(run.result["statics"]["reactions"], weight=1.5 * WEIGHT)
        for a, b in zip(motions(whole.history[-1]), motions(run.history[-1])):
            self.assertLess(abs(a - b), 1e-7 * max(map(abs, motions(whole.history[-1]))))

    def test_a_support_that_moves_takes_along_what_lies_along_its_normal(self):
        move = {"move": {"type": "settlement", "support": "toe", "ux": 2e-3, "uy": 1e-3}}
        run = self.run_scene(scene(loads=move, stages={"own weight": stones.OWN_WEIGHT, "move": {"loads": {"weight": 1.0, "move": 1.0}}}),
                             drawing=drawing(SLOPE))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        along = 2e-3 * math.cos(SLOPE) + 1e-3 * math.sin(SLOPE)
        expected = 2 * turned(along, 0, SLOPE)
        for before, after, way in zip(motions(run.history[-2]), motions(run.history[-1]), expected):
            self.assertLess(abs(after - before - way), 1e-7 * along)
        self.check_reactions(run.result["statics"]["reactions"])

    def test_a_corner_of_two_supports_that_are_not_square(self):
        # The side is held along x, which is neither along the slope nor across it: each bears what lies along its own.
        supports = {"bed": NORMAL["bed"], "toe": {"on": "toe", "components": "x"}}
        for order in (("bed", "toe"), ("toe", "bed")):
            move = {"move": {"type": "settlement", "support": "toe", "ux": 1e-3}}
            run = self.run_scene(scene({name: supports[name] for name in order}, move,
                                       {"own weight": stones.OWN_WEIGHT, "move": {"loads": {"weight": 1.0, "move": 1.0}}}),
                                 drawing=drawing(SLOPE), out=" ".join(order))
            self.assertEqual(run.outcome, "equilibrium", run.said)
            found = run.result["statics"]["reactions"]
            bed, toe = WEIGHT / math.cos(SLOPE), WEIGHT * math.tan(SLOPE)
            for name, force in (("bed", turned(0, bed, SLOPE)), ("toe", (toe, 0))):
                for c, value in zip("xy", force):
                    self.assertLess(abs(found[name][c + "_N"] - value), 1e-8 * WEIGHT, (order, found))
            # Along the slope, so that the side moves by 1 mm along x.
            for before, after, way in zip(motions(run.history[-2]), motions(run.history[-1]),
                                          2 * turned(1e-3 / math.cos(SLOPE), 0, SLOPE)):
                self.assertLess(abs(after - before - way), 1e-7 * 1e-3)

    def rigid_and_elastic(self, supports, *options, **how):
        """Ends of reactions of rigid stones by support and axis, reactions of elastic ones, and what was printed."""
        name = " ".join(map(str, (*supports, *options, *how.values())))
        rigid = self.run_scene(scene(supports), "--limit-analysis", drawing=drawing(SLOPE), out="rigid " + name, **how)
        self.assertEqual(rigid.outcome, "equilibrium", rigid.said)
        elastic = self.run_scene(scene(supports), drawing=drawing(SLOPE), out="elastic " + name, **how)
        ranges = {(support, c): tuple(found[f"{end}_{c}_N"] for end in ("least", "most"))
                  for support, found in rigid.result["rigid"]["reactions"].items() for c in "xy"}
        return ranges, elastic.result["statics"]["reactions"], rigid.words

    def test_rigid_stones_tell_what_each_of_two_supports_of_a_stone_bears(self):
        side = {"toe": {"on": "toe", "components": "x"}, "bed": NORMAL["bed"]}
        bed = turned(0, WEIGHT / math.cos(SLOPE), SLOPE)
        oblique = {"bed": bed, "toe": (WEIGHT * math.tan(SLOPE), 0)}
        square = {"bed": turned(0, WEIGHT * math.cos(SLOPE), SLOPE), "toe": turned(WEIGHT * math.sin(SLOPE), 0, SLOPE)}
        for supports, expected in ((NORMAL, square), (dict(reversed(NORMAL.items())), square), (side, oblique),
                                   (dict(reversed(side.items())), oblique)):
            for ranks in (1, 2, 4):
                ranges, elastic, words = self.rigid_and_elastic(supports, ranks=ranks)
                for (support, c), ends in ranges.items():
                    for force in (*ends, elastic[support][c + "_N"]):
                        self.assertLess(abs(force - expected[support]["xy".index(c)]), 1e-7 * WEIGHT, (supports, ranges))
                self.assertNotIn("any force", words)

    def test_what_two_supports_hold_of_a_stone_has_no_end(self):
        # Held whole, both press against each other as one likes. Held upwards twice, and along x by the side alone.
        whole = {"bed": {"on": "bed"}, "toe": {"on": "toe"}}
        upwards = {"bed": {"on": "bed", "components": "y"}, "toe": {"on": "toe"}}
        for supports in (whole, dict(reversed(whole.items())), upwards, dict(reversed(upwards.items()))):
            ranges, elastic, words = self.rigid_and_elastic(supports, ranks=1)
            for (support, c), (least, most) in ranges.items():
                force, shared = elastic[support][c + "_N"], c == "y" or supports["bed"] == whole["bed"]
                self.assertEqual((least, most) == (None, None), shared, (supports, ranges))
                if not shared:
                    self.assertLess(max(abs(force), abs(least), abs(most)), 1e-7 * WEIGHT, (ranges, elastic))
            self.assertIn("any force upwards or downwards", words)
            self.assertEqual("any force to the right or left" in words, supports["bed"] == whole["bed"], words)

    def test_rigid_stones_bear_heat_and_settlements_at_any_factor(self):
        loads = {"heat": {"type": "temperature", "change": 10.0}, "move": {"type": "settlement", "support": "toe", "ux": 1e-3}}
        for pattern in ({"heat": 1.0}, {"move": 1.0}, {"heat": -3.0, "move": 1.0}):
            run = self.run_scene(scene(loads=loads, load_factor={"pattern": pattern}), "--limit-analysis", drawing=drawing(SLOPE),
                                 out=" ".join(pattern))
            self.assertEqual((run.code, run.outcome), (0, "equilibrium"), run.said)
            self.assertIn("so they do at any factor of the pattern, since joints balance it alone", run.words)

    def test_limits_and_mechanisms_know_it(self):
        push = {"push": {"type": "acceleration", "ax": -GRAVITY * math.cos(SLOPE), "ay": -GRAVITY * math.sin(SLOPE)}}
        run = self.run_scene(scene(loads=push, load_factor={"pattern": {"push": 1.0}, "accuracy": 0.01}), drawing=drawing(SLOPE))
        found = run.result["collapse"]
        limit = MU * math.cos(SLOPE) - math.sin(SLOPE)
        self.assertLessEqual(found["lower"], limit * (1 + 1e-6), run.said)
        self.assertGreaterEqual(found["upper"], limit * (1 - 1e-6), run.said)
        self.assertLess(found["upper"] - found["lower"], 0.02 * limit)

    def test_nothing_holds_along_the_slope_without_the_side(self):
        bed = stones.scene("stones.geo", {"bed": NORMAL["bed"]}, {}, {"own weight": stones.OWN_WEIGHT}, MU)
        slides = self.run_scene(bed, drawing=drawing(SLOPE), out="slope")
        self.assertNotEqual(slides.outcome, "equilibrium", slides.said)
        level = self.run_scene(bed, drawing=drawing(0.0), out="level")
        self.assertIn("free_to_move", level.warnings, level.said)

    def test_time_steps_keep_it(self):
        # Let go from rest, the stones are pressed by their weight: forces swing about those at rest, and nothing leaves.
        stages = {"own weight": stones.OWN_WEIGHT,
                  "gust": {"duration": 0.02, "time step": 0.001, "loads": {"weight": 1.2}}}
        run = self.run_scene(scene(stages=stages, joints={"dry": {"cohesion": 1e6, "tension strength": 1e6}}), drawing=drawing(SLOPE))
        self.assertEqual(run.code, 0, run.said)
        for row in run.history:
            fx, fy = row["fx_N of toe"], row["fy_N of toe"]
            self.assertLess(abs(turned(fx, fy, -SLOPE)[1]), 1e-6 * WEIGHT)  # along its normal alone

    def test_a_support_that_turns_far_is_refused(self):
        move = {"move": {"type": "settlement", "support": "toe", "rotation": 0.1}}
        run = self.run_scene(scene(loads=move, stages={"all": {"loads": {"weight": 1.0, "move": 1.0}}}, model={"rotations": "finite"}),
                             drawing=drawing(SLOPE))
        self.assertEqual(run.code, 2, run.said)
        self.assertIn("holds along a normal", run.words)


class Vault(program.SceneTest):
    RADIUS, THICKNESS, LENGTH, HALF = 2.0, 0.5, 1.0, math.radians(60.0)

    def vault(self, **sections):
        mesh = {"type": "barrel vault", "barrel vault": {
            "radius": self.RADIUS, "thickness": self.THICKNESS, "embrace": 2 * math.degrees(self.HALF), "length": self.LENGTH,
            "voussoirs": 5, "stones along": 2, "bond": "running", "cells radial": 2, "cells round": 2, "cells along": 2,
            "ground height": 0.0}}
        tree = {"mesh": mesh, "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000.0}},
                "joints": {"dry": {"friction coefficient": MU}},
                "supports": {**{side: {"on": f"springing {side}", "components": "normal"} for side in ("left", "right")},
                             "front": {"on": "front", "components": "y"}},
                "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}},
                "steps": {"stages": {"own weight": stones.OWN_WEIGHT}}, **sections}
        return stones.xml("vault", tree) + "\n"

    def test_springings_slide_along_their_abutments(self):
        for ranks in (1, 2):
            run = self.run_scene(self.vault(), out=f"ranks {ranks}", ranks=ranks)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            found = run.result["statics"]["reactions"]
            weight = sum(found[side]["z_N"] for side in ("left", "right"))
            # Cells have chords for arcs: the area of a ring of polygons.
            cells, outer, inner = 10, self.RADIUS + self.THICKNESS / 2, self.RADIUS - self.THICKNESS / 2
            area = cells * math.sin(2 * self.HALF / cells) / 2 * (outer ** 2 - inner ** 2)
            self.assertLess(abs(weight - 2000 * GRAVITY * area * self.LENGTH), 1e-8 * weight)
            for side, sign in (("left", 1), ("right", -1)):
                self.assertLess(abs(found[side]["z_N"] - weight / 2), 1e-8 * weight)
                self.assertLess(abs(found[side]["x_N"] - sign * weight / 2 / math.tan(self.HALF)), 1e-8 * weight)
                self.assertLess(abs(found[side]["y_N"]), 1e-8 * weight)


if __name__ == "__main__":
    program.main()

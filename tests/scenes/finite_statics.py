"""What finite rotations cost where no forces balance the loads, and beyond the limit of a search.

    finite_statics.py PROGRAM MPIEXEC

The static theorem is asked first, of the stones as drawn. A stone on a slope that is too steep for its friction falls
at once, not five times under less and less of its weight. A slender column of dry stones under a load off its middle
falls by its own deflection, and no attempt beyond that goes on without end. A brick that is pushed over two others takes what
its friction asks for, whatever the way: where three stones meet their faces stay one plane, though each has turned a little
by what presses it, or forces that run round between the three would be as large as the way.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import stones  # noqa: E402

FINITE = {"model": {"rotations": "finite"}}


def turned(points, angle):
    c, s = math.cos(angle), math.sin(angle)
    return stones.polygon([(round(c * x - s * y, 12), round(s * x + c * y, 12)) for x, y in points])


def column(eccentricity, courses, width=0.5, high=0.125):
    """Courses of a column; the load stands this far off the middle, at a corner of the cells."""
    drawn = {}
    for k in range(courses):
        drawn[f"c{k}"] = stones.rectangle(0, k * high, width, (k + 1) * high)
    loads = {"P": {"type": "point load", "x": width / 2 + eccentricity, "y": courses * high, "fy": -1000.0}}
    scene = stones.scene("stones.geo", ["ground"], loads, {"first": {"loads": {"P": 1.0}}}, friction=1.0,
                         materials={"stone": {"Young modulus": 2e9, "Poisson ratio": 0.0}},
                         load_factor={"pattern": {"P": 1.0}, "first factor": 50.0, "largest factor": 5000.0,
                                      "accuracy": 0.02}, steps={"expect collapse": True}, **FINITE)
    return scene, stones.geo(drawn, width / 8, {"ground": ("c0", 0)})


def largest_load(eccentricity, length, width=0.5, modulus=2e9):
    """What an elastic cantilever of this length bears that bears no tension, 1 m thick [N].

    The curvature where the force is e off the middle: of a whole section 12 P e / (E t^3), of a cracked one
    P / (E x 4.5 (t/2 - e)^2). The deflection along the column from its top is integrated for each slope of the top that
    leads to a foot without slope; the load is largest where a further deflection asks for less.
    """
    def load_of(top_slope, load):
        e, slope, steps = eccentricity, top_slope, 400
        for _ in range(steps):
            if e >= width / 2:
                return None
            if e <= width / 6:
                curvature = 12 * load * e / (modulus * width**3)
            else:
                curvature = load / (modulus * 4.5 * (width / 2 - e) ** 2)
            slope -= curvature * length / steps
            e += slope * length / steps
        return slope

    def stands(load):
        low, high = 0.0, 2.0 * width / length
        trials = [low + (high - low) * k / 400 for k in range(401)]
        slopes = [load_of(s, load) for s in trials]
        return any(s is not None and s >= 0 for s in slopes)

    low, high = 0.0, 1e7
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if stands(middle) else (low, middle)
    return low


class FiniteStatics(program.SceneTest):
    def slope(self, angle, stages, ranks=1, **more):
        drawn = {"slope": turned([(-1, -0.5), (1, -0.5), (1, 0), (-1, 0)], angle),
                 "stone": turned([(-0.3, 0), (0.3, 0), (0.3, 0.2), (-0.3, 0.2)], angle)}
        scene = stones.scene("stones.geo", ["ground"], more.pop("loads", {}), stages, **FINITE, **more)
        return self.run_scene(scene, drawing=stones.geo(drawn, 0.1, {"ground": ("slope", 0)}), ranks=ranks,
                              out=f"out{ranks}", seconds=100)

    def test_a_stone_on_a_steep_slope_falls_at_once(self):
        for ranks in (1, 2):
            run = self.slope(math.radians(40), {"own weight": stones.OWN_WEIGHT}, ranks)
            self.assertEqual(run.outcome, "collapse", run.said)
            self.assertEqual(run.words.count("at 1: collapse"), 1)
            self.assertNotIn("0.5: collapse", run.words)
            for words in ("load factor 1", "static theorem", "surface 2 (stone)", "none balance them either"):
                self.assertIn(words, run.words)

    def test_on_a_flatter_slope_it_stands(self):
        run = self.slope(math.radians(30), {"own weight": stones.OWN_WEIGHT})
        self.assertEqual(run.outcome, "equilibrium", run.said)

    def test_a_push_that_half_of_it_is_borne_is_halved(self):
        loads = {"push": {"type": "acceleration", "ax": 9.81 * 1.2}}
        run = self.slope(0.0, {"rest": stones.OWN_WEIGHT, "push": {"loads": {"push": 1.0}}}, loads=loads)
        self.assertEqual(run.outcome, "collapse", run.said)
        # Friction of 0.6 bears half of it: what was reached is the last row.
        self.assertGreaterEqual(run.history[-1]["load_factor"], 0.4)

    def pushed_over_two(self, way, gap=0.0):
        """Shear of the beds [N] below two bricks, once a third has been pushed over both of them."""
        drawn = {"g": [(0, -0.2), (0.8, -0.2), (0.8, 0), (0.4, 0), (0, 0)], "a": [(0, 0), (0.4, 0), (0.4, 0.2), (0.2, 0.2), (0, 0.2)],
                 "b": [(0.4, 0), (0.8, 0), (0.8, 0.2), (0.6, 0.2), (0.4, 0.2)],
                 "c": [(0.2, 0.2), (0.4, 0.2), (0.6, 0.2), (0.6, 0.4), (0.2, 0.4)],
                 "d": [(0.2, 0.4), (0.6, 0.4), (0.6, 0.9), (0.2, 0.9)]}
        drawing = stones.geo({name: stones.polygon(corners) for name, corners in drawn.items()}, 0.1,
                             {"ground": ("g", 0), "side": ("c", 4)})
        scene = stones.scene("stones.geo", {"ground": {"on": "ground"}, "side": {"on": "side", "components": "x"}},
                             {"push": {"type": "settlement", "support": "side", "ux": way}},
                             {"rest": stones.OWN_WEIGHT, "pushed": {"increments": 5, "loads": {"weight": 1.0, "push": 1.0}}},
                             joints={"top": {"between": "c", "and": "all", "friction coefficient": 0.4, "initial gap": gap}},
                             materials={"stone": {"Young modulus": 1e9, "Poisson ratio": 0.2, "density": 2000.0}},
                             selection={"mode": "all"}, **FINITE)
        run = self.run_scene(scene, drawing=drawing)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return [joint["shear_N"] for joint in run.table("joints.csv")][:2]

    def test_a_brick_on_two_takes_its_friction_whatever_the_way(self):
        first, second = self.pushed_over_two(0.005)
        self.assertLess(abs(first + second - 0.4 * 560 * 9.81), 1)  # of all that the pushed one carries
        for way, gap in (0.01, 0.0), (0.02, 0.0), (0.02, 1e-6):
            left, right = self.pushed_over_two(way, gap)
            self.assertLess(max(abs(left - first), abs(right - second)), 0.01 * first)

    def test_a_slender_column_falls_by_its_deflection(self):
        scene, drawing = column(0.125, 24)
        expected = largest_load(0.125, 3.0) / 1000
        solves = {}
        for ranks in (1, 2):
            run = self.run_scene(scene, drawing=drawing, ranks=ranks, out=f"out{ranks}", seconds=300)
            self.assertEqual(run.outcome, "collapse", run.said)
            collapse = run.result["collapse"]
            # Cells an eighth of the depth long bear a few percent more than the rod.
            self.assertGreater(collapse["lower"], 0.97 * expected)
            self.assertLess(collapse["upper"], 1.15 * expected)
            solves[ranks] = max(a["linear_solves"] for a in collapse["attempts"])
        self.assertLess(max(solves.values()), 400, solves)


if __name__ == "__main__":
    program.main()

"""A flying buttress: how hard can the nave push on it, and does it come to that when the nave wall moves out?

usage: buttress.py PROGRAM MPIEXEC [names of tests]

Set-up    A pier of six courses on a foundation, 2.1 m wide and 9 m high, a skewback on it, a flyer of ten voussoirs whose last
          joint is upright, and the nave wall, a stone that may be moved and has no friction. Limestone, friction 0.6, 1 m thick.
Expected  By hand: the nave pushes with H at the head of the flyer, upright forces pass there none. When the pier begins to turn
          about its toe, H times the lowest height of the head is the moment of all weights about the toe: 71 kN.
          Limit analysis finds that as the most that the nave can push; the elastic structure stands below it when the wall is at
          rest, and comes to it when the wall is pushed outward.
Tolerance 1 %: the hand calculation lets the pressure be a line at the toe and at the lowest point of the head; limit analysis
          does as well, so that it is exact but for the digits of its programme. Elastic stones are pressed together there: 2 %.
"""

import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import jobs  # noqa: E402  (a folder of its own)
import program  # noqa: E402

DENSITY, GRAVITY = 2200.0, 9.81
WIDTH, COURSES, HEIGHT = 2.1, 6, 9.0     # [m] of the pier
RADIUS, DEPTH, FIRST = 6.0, 0.6, math.radians(50)  # [m] of the flyer's intrados; its joints turn by so much from the crown
VOUSSOIRS, PINNACLE = 10, 2.0  # [m] of height


def outlines():
    """Stones by name, corners counter-clockwise; the middle of the flyer's circle."""
    stones = {}
    for row in range(COURSES):
        y = HEIGHT / COURSES * row
        stones[f"course {row}"] = [(0, y), (WIDTH, y), (WIDTH, y + HEIGHT / COURSES), (0, y + HEIGHT / COURSES)]
    # The lowest corner of the flyer stands on the inner edge of the pier.
    middle = (WIDTH + RADIUS * math.sin(FIRST), HEIGHT - RADIUS * math.cos(FIRST))
    at = lambda radius, k: (middle[0] - radius * math.sin(FIRST * (1 - k / VOUSSOIRS)), middle[1] + radius * math.cos(FIRST * (1 - k / VOUSSOIRS)))
    back = at(RADIUS + DEPTH, 0)
    stones["skewback"] = [(0, HEIGHT), (WIDTH, HEIGHT), back, (0, back[1])]
    stones["pinnacle"] = [(0, back[1]), (back[0], back[1]), (back[0], back[1] + PINNACLE), (0, back[1] + PINNACLE)]
    for k in range(VOUSSOIRS):
        stones[f"voussoir {k}"] = [at(RADIUS, k), at(RADIUS, k + 1), at(RADIUS + DEPTH, k + 1), at(RADIUS + DEPTH, k)]
    return stones, middle


def area_and_middle(corners):
    """[m2] and x [m] of a polygon."""
    area = moment = 0.0
    for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1]):
        cross = x0 * y1 - x1 * y0
        area += cross / 2
        moment += cross * (x0 + x1) / 6
    return area, moment / area


def most_by_hand():
    """[N] at which the pier turns about its toe, the corner at 0."""
    stones, middle = outlines()
    weights = [(DENSITY * GRAVITY * area, x) for area, x in map(area_and_middle, stones.values())]
    return sum(weight * x for weight, x in weights) / (middle[1] + RADIUS)


def scene():
    stones, middle = outlines()
    drawn = jobs.package().stones.Stones(snap=1e-6)
    for name, corners in stones.items():
        drawn.polygon(corners, name, sets="flyer" if name.startswith("voussoir") else "pier")
    drawn.rectangle(-0.5, -0.5, WIDTH + 1, 0.5, "foundation")  # the pier may lift off it
    nave = drawn.rectangle(middle[0], middle[1] + RADIUS, 0.5, DEPTH, "nave")
    drawn.edges("ground", lambda x, y: y < -0.5 + 1e-6)
    drawn.edges("nave wall", lambda x, y: abs(x - middle[0] - 0.5) < 1e-6)
    return drawn, {
        "materials/stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": DENSITY},
        "joints/dry/friction coefficient": 0.6, "joints/smooth": {"between": nave, "and": "all", "friction coefficient": 0.0},
        "supports/ground/on": "ground", "supports/nave/on": "nave wall",
        "loads/weight": {"type": "self weight", "gravity": GRAVITY},
        "loads/nave moves out": {"type": "settlement", "support": "nave", "ux": -0.001},
        "steps/stages/own weight/loads/weight": 1.0}


class Buttress(jobs.JobTest):
    def test_the_most_that_the_nave_can_push_is_that_of_the_hand_calculation(self):
        hand = most_by_hand()
        result = self.run_job("buttress", *scene(), limit_analysis=True)
        self.assertLess(abs(hand / 71e3 - 1), 0.01)
        ends = result.json["rigid"]["reactions"]["nave"]
        self.assertLess(abs(-ends["least_x_N"] / hand - 1), 0.01, ends)

    def test_the_elastic_buttress_comes_to_it_when_the_wall_moves_out(self):
        drawn, keys = scene()
        at_rest = self.run_job("at_rest", drawn, keys)
        hand = most_by_hand()
        push = lambda result: -result.reactions["nave"][0]
        self.assertLess(push(at_rest), 0.95 * hand)
        keys["steps/stages/pushed"] = {"increments": 5, "loads": {"nave moves out": 20.0}}
        pushed = self.run_job("pushed", drawn, keys)
        self.assertLess(abs(push(pushed) / hand - 1), 0.02)
        page = self.page(pushed)
        self.assertIn("nave moves out", page)
        self.assertIn("Hinges", page)


if __name__ == "__main__":
    program.main()

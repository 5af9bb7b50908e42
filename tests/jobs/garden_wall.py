"""A garden wall whose foundation is missing over three metres: does it bridge the gap, on what does that hang, and what do
winter and summer do?

usage: garden_wall.py PROGRAM MPIEXEC [names of tests]

Set-up    Six courses in bond, 12 m long and 1.8 m high, 0.4 m thick, on foundation stones on the ground; those below the
          middle go down by 30 mm. Then winter, 20 K colder, and summer, 20 K warmer.
Expected  By hand: the missing support carries the weight over 3 m. An arch of height 1.5 m needs a thrust of weight x 3 m / 8 over
          its rise, which friction at the base of one side can give: friction x weight of a side. So the wall stands, its
          middle stays above the gap, and what supports the wall is what it weighs. A course is as
          long as its stones and its open joints. From winter to summer stones grow by what a free wall would, twice
          expansion x change x length, and joints that have opened close. Those can be open in winter by no more than stones
          have shrunk, half of that, since the ends of the wall do not move out when it gets colder. So the wall grows
          by less than a free one, and by at least a half less what the thrust of summer presses it together, thrust x
          length over (modulus x area). With friction of 0.05 at the base the arch has no abutment: it comes down on the gap.
Tolerance Forces 1e-6, the tolerance of the solver; the others are bounds.
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import jobs  # noqa: E402  (a folder of its own)
import program  # noqa: E402

LENGTH, COURSES, HEIGHT, THICKNESS = 12.0, 6, 0.3, 0.4  # [m] of the wall; of a course
BRICK, FRICTION, DENSITY, GRAVITY, MODULUS = 1.0, 0.6, 2000.0, 9.81, 5e9
GAP = (4.5, 7.5)                     # [m] where the foundation goes down
SINKS, EXPANSION, CHANGE = 0.03, 6e-6, 20.0


def scene():
    drawn = jobs.package().stones.Stones(snap=1e-6)
    for name, first, last in (("west pad", 0.0, GAP[0]), ("middle pad", *GAP), ("east pad", GAP[1], LENGTH)):
        drawn.rectangle(first, -0.3, last - first, 0.3, name, sets="pads")
    for row in range(COURSES):
        joints = [0.0, *[BRICK * (k + row % 2 / 2) for k in range(1 - row % 2, int(LENGTH / BRICK))], LENGTH]
        for k, (a, b) in enumerate(zip(joints, joints[1:])):
            drawn.rectangle(a, HEIGHT * row, b - a, HEIGHT, f"brick {row} {k}", sets="wall")
    for name, first, last in (("west", 0.0, GAP[0]), ("middle", *GAP), ("east", GAP[1], LENGTH)):
        drawn.edges(name, lambda x, y, a=first, b=last: y < -0.3 + 1e-6 and a - 1e-6 < x < b + 1e-6)
    return drawn, {
        "model/thickness": THICKNESS, "materials/brick": {"Young modulus": MODULUS, "Poisson ratio": 0.2, "density": DENSITY},
        "joints/dry/friction coefficient": FRICTION,
        "supports/west/on": "west", "supports/middle/on": "middle", "supports/east/on": "east",
        "loads/weight": {"type": "self weight", "gravity": GRAVITY},
        "loads/foundation": {"type": "settlement", "support": "middle", "uy": -SINKS},
        "loads/winter": {"type": "temperature", "blocks": "wall", "change": -CHANGE, "expansion": EXPANSION},
        "observations/middle": {"x": LENGTH / 2, "y": 0.0, "tolerance": 0.3, "blocks": "wall"},
        "observations/west end": {"x": 0.0, "y": HEIGHT * COURSES, "tolerance": 0.3},
        "observations/east end": {"x": LENGTH, "y": HEIGHT * COURSES, "tolerance": 0.3},
        "steps/stages/own weight/loads/weight": 1.0,
        "steps/stages/the foundation goes": {"increments": 2, "loads": {"foundation": 1.0}},
        "steps/stages/winter": {"increments": 2, "loads": {"winter": 1.0}},
        "steps/stages/summer": {"increments": 2, "loads": {"winter": -1.0}}}


class GardenWall(jobs.JobTest):
    def test_it_bridges_the_gap_by_friction_and_goes_with_the_seasons(self):
        weight_of = lambda length: DENSITY * GRAVITY * THICKNESS * HEIGHT * COURSES * length
        needed = weight_of(GAP[1] - GAP[0]) * (GAP[1] - GAP[0]) / 8 / 1.5
        self.assertLess(needed, FRICTION * weight_of(GAP[0]))  # so it can stand
        drawn, keys = scene()
        result = self.run_job("garden_wall", drawn, keys, element_size=0.25)
        self.assertEqual(result.outcome, "equilibrium", result.message)
        last = {row["stage"]: row for row in program.Run(result.folder, DONE).history}
        self.assertGreater(last["the foundation goes"]["uy_m of middle"], -SINKS / 10)
        pads = DENSITY * GRAVITY * THICKNESS * 0.3
        bears = {name: force for name, force in result.reactions.items()}
        self.assertLess(abs(bears["middle"][1] / (pads * (GAP[1] - GAP[0])) - 1), 1e-6, "nothing but its own pad")
        self.assertLess(abs(sum(f[1] for f in bears.values()) / (weight_of(LENGTH) + pads * LENGTH) - 1), 1e-6)
        length = {stage: row["ux_m of east end"] - row["ux_m of west end"] for stage, row in last.items()}
        grows = (length["summer"] - length["winter"]) / (EXPANSION * 2 * CHANGE * LENGTH)
        self.assertLess(length["winter"], length["the foundation goes"])  # its ends have not moved out
        pressed = abs(bears["west"][0]) / (MODULUS * THICKNESS * HEIGHT * COURSES) / (EXPANSION * 2 * CHANGE)
        self.assertTrue(0.5 - pressed < grows < 1.0, (grows, pressed))
        self.assertIn("winter", self.page(result))

    def test_without_friction_at_its_base_it_cannot(self):
        drawn, keys = scene()
        keys["joints/base"] = {"between": "wall", "and": "pads", "friction coefficient": 0.05}
        for stage in ("winter", "summer"):
            del keys[f"steps/stages/{stage}"]
        result = self.run_job("slippery", drawn, keys, element_size=0.5)
        self.assertEqual(result.outcome, "equilibrium", result.message)
        # It comes down on to what has sunk.
        self.assertLess(result.history["uy_m of middle"][-1], -0.99 * SINKS)
        self.assertGreater(result.reactions["middle"][1], 1.2 * DENSITY * GRAVITY * THICKNESS * 0.3 * (GAP[1] - GAP[0]))


DONE = type("Done", (), {"returncode": 0, "stdout": "", "stderr": ""})

if __name__ == "__main__":
    program.main()

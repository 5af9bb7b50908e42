"""A bridge of two rings under an axle at nine positions: how far can the axle be raised, and where does it stand worst?

usage: bridge.py PROGRAM MPIEXEC [names of tests]

Set-up    Two rings of bricks in bond over 120 degrees, the weight of the fill on them, an axle of 50 kN that is moved along them
          by drivers/sweep, one command: limit analysis of each position.
Expected  The bridge is its own mirror image, so that two positions alike to its middle have one factor. The worst is near a quarter
          of the span and not at the crown, where the axle goes down both haunches alike. By hand: the supports together bear the
          weight of the rings, whose cross-section is that of 20 chords of a circle, the fill over its width, and the axle.
          What the sweep says of a position is what the program says when it is asked for that one alone, and the elastic bridge
          stands at 0.8 of the factor of the worst position and not above it: where slip does not dilate it may fall before.
Tolerance Factors of mirror images 0.1 %: a programme ends where its forces balance to 1e-9, its factor is that exact, but positions
          that lie on a corner of two slices belong to one of them; the drawing has corners to 1e-9 m.
"""

import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import jobs  # noqa: E402  (a folder of its own)
import program  # noqa: E402

RADIUS, DEPTH = 2.5, 0.25               # [m] of the lower ring's soffit; of a ring
FILL = 10e3                             # [N/m2] what the fill weighs above the rings
HALF, BRICKS = math.radians(60), 10     # of the opening; of a ring
AXLE, GRAVITY = 50e3, 9.81              # [N], [m/s2]
POSITIONS = [-1.6, -1.2, -0.8, -0.4, 0, 0.4, 0.8, 1.2, 1.6]


def at(radius, k):
    """The place k half bricks from the left springing."""
    angle = -HALF + HALF * k / BRICKS
    return (round(radius * math.sin(angle), 9), round(radius * math.cos(angle), 9))


def bricks(radius, joints):
    """Corners of the bricks of a ring between joints, with those of the bricks above and below."""
    for first, last in zip(joints, joints[1:]):
        yield [at(radius, k) for k in range(first, last + 1)] + [at(radius + DEPTH, k) for k in range(last, first - 1, -1)]


def scene():
    drawn = jobs.package().stones.Stones(snap=1e-6)
    whole, bonded = list(range(0, 2 * BRICKS + 1, 2)), [0, *range(1, 2 * BRICKS, 2), 2 * BRICKS]
    for k, corners in enumerate(bricks(RADIUS, whole)):
        drawn.polygon(corners, f"lower {k}", sets="lower ring")
    for k, corners in enumerate(bricks(RADIUS + DEPTH, bonded)):
        drawn.polygon(corners, f"upper {k}", sets="upper ring")
    back = RADIUS + 2 * DEPTH
    slope = math.tan(math.pi / 2 - HALF)  # of the springing joints
    for side, sign in (("west", -1), ("east", 1)):
        drawn.edges(f"{side} springing", lambda x, y, s=sign: abs(y - slope * s * x) < 1e-6)
    drawn.edges("road", lambda x, y: math.hypot(x, y) > back - 1e-6)
    return drawn, {
        "materials/brick": {"Young modulus": 5e9, "Poisson ratio": 0.2, "density": 2000.0},
        "joints/dry/friction coefficient": 0.6,
        "supports/west/on": "west springing", "supports/east/on": "east springing",
        "loads/weight": {"type": "self weight", "gravity": GRAVITY},
        "loads/fill": {"type": "crowd", "on": "road", "intensity": FILL, "x from": -9.0, "x to": 9.0},
        "loads/axle": {"type": "moving train", "on": "road", "axle loads": f"{AXLE:g}", "position": 0.0},
        "steps/stages/dead load/loads": {"weight": 1.0, "fill": 1.0},
        "load factor": {"pattern": {"axle": 1.0}, "largest factor": 64.0, "accuracy": 0.01}}


def dead_by_hand():
    """[N] of rings, whose bricks are polygons of so many chords, and of the fill above them."""
    chords = 2 * BRICKS
    area = chords * math.sin(2 * HALF / chords) / 2 * ((RADIUS + 2 * DEPTH) ** 2 - RADIUS**2)
    return area * 2000.0 * GRAVITY + FILL * 2 * (RADIUS + 2 * DEPTH) * math.sin(HALF)


class Bridge(jobs.JobTest):
    def test_nine_positions_by_one_command_are_symmetric_and_worst_near_the_quarter(self):
        path = self.write_job("bridge", *scene())
        done = self.sweep(path, "--set", f"loads/axle/position={','.join(map(str, POSITIONS))}", "--limit-analysis", "--envelope")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        rows = {float(row["loads/axle/position"]): row for row in self.rows()}
        self.assertEqual(sorted(rows), POSITIONS)
        factor = {x: float(row["factor_falls"] or "inf") for x, row in rows.items()}
        for x in POSITIONS[:4]:
            self.assertLess(abs(1 / factor[x] - 1 / factor[-x]), 1e-3 / min(factor.values()), factor)
        worst = min(POSITIONS, key=factor.get)
        self.assertIn(abs(worst), (0.8, 1.2), factor)
        self.assertGreater(factor[0], 1.2 * factor[worst])
        self.assertIn(f"{worst:g}", done.stdout)
        page = (self.folder / "sweep" / "sweep.html").read_text(encoding="utf-8")
        self.assertEqual(page.count("<img"), 1)
        self.check_alone(path, worst, factor[worst])

    def check_alone(self, path, worst, factor):
        scene = jobs.package().Scene.read(path)
        scene["loads/axle/position"] = float(worst)
        alone = scene.run(out=self.folder / "alone", ranks=1, limit_analysis=True)
        self.assertLess(abs(alone.factor[1] / factor - 1), 1e-9)
        for share, stands in ((0.8, True), (1.02, False)):
            tried = jobs.package().Scene.read(path)
            del tried["load factor"]
            tried["loads/axle/position"] = float(worst)
            tried["steps/stages/axle/loads/axle"] = share * factor
            tried["steps/expect collapse"] = not stands
            result = tried.run(out=self.folder / f"elastic {share}", ranks=1)
            self.assertEqual(result.outcome, "equilibrium" if stands else "collapse", result.message)
            if stands:
                total = sum(reaction[1] for reaction in result.reactions.values())
                self.assertLess(abs(total / (dead_by_hand() + share * factor * AXLE) - 1), 1e-6)
                self.assertIn("axle", self.page(result))


if __name__ == "__main__":
    program.main()

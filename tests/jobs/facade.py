"""A facade under a record scaled from 0.1 to 0.6 g: how far does it move, what is left, and from which peak on is it unsafe?

usage: facade.py PROGRAM MPIEXEC [all] [names of tests]

Set-up    A dry wall of six courses with a door, friction 0.5, shaken along itself by two cycles at 2 Hz (record()), whose peak of
          0.15 g is scaled by drivers/sweep: one command. By default to 0.1 and 0.3 g, with `all` to six peaks up to 0.6 g.
Expected  By hand: a course slides on the one below when the peak exceeds friction x g, 0.5 g; limit analysis says that a steady
          push brings the wall down from 0.47 g on. Below both nothing slides: slips stay below a tenth of a millimetre, and
          what is left is what its weight has moved it and what has slipped. At 0.6 g, above both, courses slide by more than
          a millimetre.
Tolerance Bounds; what is left beyond own weight 0.01 mm up to 0.3 g, since points that slip by less near edges stay where they
          are. At 0.4 g it is 0.02 mm, with every point and with half the time step too, and must be no more than the slip.
"""

import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import jobs  # noqa: E402  (a folder of its own)
import program  # noqa: E402

FRICTION, GRAVITY, PEAK = 0.5, 9.81, 0.15  # [-], [m/s2], [g] of the record
PEAKS, DURATION, STEP = [0.1, 0.3], 1.1, 0.01
ALL, WHOLE = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], 2.5


def record():
    """Two cycles at 2 Hz that swell and fade within a second, then rest: times [s] and accelerations [m/s2]."""
    rows = []
    for k in range(int(WHOLE / STEP) + 1):
        time = STEP * k
        rows.append((time, math.sin(math.pi * time) ** 2 * math.sin(4 * math.pi * time) if time < 1 else 0.0))
    largest = max(abs(a) for _, a in rows)
    return "time [s], acceleration [m/s2]\n" + "".join(f"{t:.2f}, {PEAK * GRAVITY * a / largest:.6f}\n" for t, a in rows)


def scene(duration, file):
    scene = jobs.package().Scene("facade")
    opening = lambda x0, x1, y0, y1: {"x from": x0, "x to": x1, "y from": y0, "y to": y1}
    scene["title"] = "Facade with a door and a window, shaken"
    scene["mesh"] = {"type": "wall", "wall": {"courses": 6, "blocks per course": 4, "openings": {
        "door": opening(0.5, 1.0, 0.0, 0.75)}}}
    scene["model/thickness"] = 0.4
    scene["materials/stone"] = {"Young modulus": 5e9, "Poisson ratio": 0.2, "density": 2000.0}
    scene["joints/dry/friction coefficient"] = FRICTION
    scene["supports/ground/on"] = "base"
    scene["loads/weight"] = {"type": "self weight", "gravity": GRAVITY}
    scene["loads/quake"] = {"type": "ground motion", "x record": str(file), "scale": 1.0, "baseline": "corrected"}
    scene["loads/push"] = {"type": "acceleration", "ax": GRAVITY}
    scene["observations/top"] = {"x": 2.0, "y": 1.5, "tolerance": 0.3}
    scene["steps/stages/own weight/loads/weight"] = 1.0
    if duration:
        scene["steps/stages/earthquake"] = {"duration": duration, "time step": STEP, "at once": True, "loads": {"quake": 1.0}}
        scene["steps/time/mass damping"] = 0.3
    else:
        scene["load factor/pattern/push"] = 1.0
    return scene


class Facade(jobs.JobTest):
    def rows_of(self, peaks, duration, seconds=300):
        path = self.folder / "facade.xml"
        (self.folder / "record.csv").write_text(record(), encoding="utf-8")
        scene(duration, self.folder / "record.csv").write(path)
        scales = ",".join(f"{peak / PEAK:.6g}" for peak in peaks)
        done = self.sweep(path, "--set", f"loads/quake/scale={scales}", "--envelope", seconds=seconds)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return {round(float(row["loads/quake/scale"]) * PEAK, 3): row for row in self.rows()}

    def check(self, rows):
        static = scene(0, self.folder / "record.csv").run(out=self.folder / "static", ranks=1, limit_analysis=True)
        falls = static.factor[1]
        self.assertTrue(0.1 < falls < FRICTION + 1e-9, falls)
        self.assertGreater(falls, 0.3)
        own = jobs.package().Result(self.folder / "sweep" / "runs" / rows[min(rows)]["run"]).history["largest_displacement_m"][0]
        for peak, row in rows.items():
            slip, rest = float(row["peak_slip_m"]), float(row["residual_displacement_m"])
            if peak < min(falls, FRICTION):
                self.assertEqual(row["outcome"], "equilibrium")
                self.assertLess(slip, 1e-4, peak)
                self.assertLessEqual(rest - own, slip, peak)
                if peak <= PEAKS[-1]:
                    self.assertLess(rest - own, 1e-5, peak)
            elif peak > 1.1 * max(falls, FRICTION):
                self.assertGreater(slip, 1e-3, peak)
        drifts = [float(rows[peak]["peak_drift"]) for peak in sorted(rows)]
        self.assertEqual(drifts, sorted(drifts))

    def test_fragility_by_one_command(self):
        rows = self.rows_of(PEAKS, DURATION)
        self.assertEqual(sorted(rows), PEAKS)
        self.check(rows)
        run = next((self.folder / "sweep" / "runs").glob("*"))
        page = self.page(jobs.package().Result(run))
        self.assertIn("residual, at the end", page)
        self.assertNotIn("Load factor reached", page)


class WholeRecord(Facade):
    def test_fragility_by_one_command(self):
        rows = self.rows_of(ALL, WHOLE, seconds=1700)
        self.assertEqual(sorted(rows), ALL)
        self.check(rows)


if __name__ == "__main__":
    whole = sys.argv[3:4] == ["all"]
    if whole:
        del sys.argv[3]
    sys.argv[3:] = sys.argv[3:] or ["WholeRecord" if whole else "Facade"]
    program.main()

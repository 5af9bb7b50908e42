"""The motion of a structure in its report, and the loads that are drawn: what the page shows is what the run wrote.

usage: motion_player.py PROGRAM MPIEXEC [names of tests]

Set-up    A column of stones under its weight, pressed and pushed in steps; the same shaken in time.
Expected  The player has a frame for every recorded step with the displacements of fields.h5, and a browser steps through them and
          stops; loads stand in fields.h5 and in the caption with their sizes, and balance the reactions.
Tolerance Places to 1/65535 of the size, displacements to 1/32767 of the largest; forces to the tolerance of the solver.
"""

import base64
import json
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "support"), str(ROOT / "drivers" / "report")]
import program  # noqa: E402  (a folder of its own)
import read_results  # noqa: E402
import stones  # noqa: E402

BROWSER = ["chromium", "--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
           "--disable-component-update", "--disable-sync", "--enable-logging=stderr", "--virtual-time-budget=3000", "--dump-dom"]
# Frames shown after each touch: at first, one back, one on, one on from the last; then what the button says.
TRIES = """<script>setTimeout(() => {
  const at = (name) => document.querySelector("#motion [name=" + name + "]"), said = [], frame = () => said.push(at("frame").value);
  frame(); at("back").click(); frame(); at("on").click(); frame(); at("on").click(); frame();
  at("play").click(); said.push(at("play").textContent); at("play").click(); said.push(at("play").textContent); frame();
  at("scale").value = 90; at("scale").dispatchEvent(new Event("input"));
  said.push(document.querySelector("#motion").dataset.drawn);
  document.body.dataset.tried = said.join(" ");
}, 300);</script>"""
UNITS = {"m": 1.0, "mm": 1e-3, "µm": 1e-6}
OUTLINES = {"base": stones.rectangle(-0.6, -0.3, 0.6, 0),
            **{f"stone {k}": stones.rectangle(-0.25, 0.25 * k, 0.25, 0.25 * (k + 1)) for k in range(3)}}


def motion_of(text):
    """The numbers of the player of a page."""
    return json.loads(re.search(r'id="motion-data">(.*?)</script>', text, re.DOTALL)[1])


def numbers(text, kind):
    return np.frombuffer(base64.b64decode(text), kind)


def scene(stages, loads=None, **sections):
    return stones.scene("stones.geo", ["ground"], {**LOADS, **(loads or {})}, stages, selection={"mode": "all"}, **sections)


LOADS = {"press": {"type": "traction", "on": "top", "pressure": 1e5}, "statue": {"type": "point load", "x": 0.25, "y": 0.5, "fx": -2e3, "tolerance": 0.1},
         "shock": {"type": "ground motion", "ax": 2.5, "time function": {"type": "pulse", "duration": 0.1}}}
IN_STEPS = {"own weight": stones.OWN_WEIGHT, "pressed": {"increments": 2, "loads": {"press": 1.0, "statue": 1.0}}}
IN_TIME = {"own weight": stones.OWN_WEIGHT, "shaking": {"duration": 0.2, "time step": 0.005, "at once": True, "loads": {"shock": 1.0}}}
OBSERVED = {"top": {"x": 0.0, "y": 0.75, "tolerance": 0.3}}


class Drawn(program.SceneTest):
    def draw(self, stages, **sections):
        drawing = stones.geo(OUTLINES, 0.15, {"ground": ("base", 0), "top": ("stone 2", 2)})
        run = self.run_scene(scene(stages, **sections), drawing=drawing)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        subprocess.run([sys.executable, "-B", ROOT / "drivers" / "report" / "make_report.py", run.folder], check=True, stdout=subprocess.DEVNULL)
        page = (run.folder / "report.html").read_text(encoding="utf-8")
        self.assertNotIn("could not be", page)
        return run, page

    def check_motion(self, run, page, step, frame):
        data = motion_of(page)
        with h5py.File(run.folder / "fields.h5") as fields:
            x, u = fields["mesh/coordinates"][:], fields[f"steps/{step:04d}/displacement"][:]
        places = np.array(data["least"]) + data["unit"] * numbers(data["places"], np.uint16).reshape(-1, 2)
        moved = data["largest"] * numbers(data["frames"][frame]["u"], np.int16).reshape(-1, 2)
        for place, way in zip(places, moved):  # nodes of several stones may be in one place
            here = np.abs(x - place).max(1) < 2 * data["unit"]
            self.assertLess(np.abs(u[here] - way).max(1).min(), data["largest"])

    def test_the_motion_has_a_frame_for_every_recorded_step_with_the_displacements_of_the_run(self):
        run, page = self.draw(IN_STEPS)
        self.assertEqual(len(motion_of(page)["frames"]), len(run.history))
        self.check_motion(run, page, 3, 2)
        self.assertIn("statue 2 kN", motion_of(page)["frames"][2]["words"])

    def test_loads_are_drawn_with_their_sizes_and_balance_the_reactions(self):
        run, page = self.draw(IN_STEPS)
        self.assertIn("On all of the stones: “weight” (self weight)", page)
        self.assertIn("what supports answer", page)
        weight, press, statue = read_results.read_results(run.folder).last.loads
        self.assertEqual((weight.name, press.name, press.kind, statue.kind), ("weight", "press", "traction", "point load"))
        self.assertEqual((len(weight.node), weight.of_stones, press.of_stones, len(statue.node)), (0, True, False, 1))
        self.assertLess(abs(press.total[1] / (-1e5 * 0.5) - 1), 1e-12)
        self.assertLess(np.abs(press.force.sum(0) - press.total).max(), 1e-9 * 5e4)
        reaction = run.result["statics"]["reactions"]["ground"]
        # Equilibrium: to the tolerance of the solver, 1e-8 of the largest force.
        total = weight.total + press.total + statue.total
        self.assertLess(abs(total[1] + reaction["y_N"]), 1e-6 * abs(total[1]))
        self.assertLess(abs(total[0] + reaction["x_N"]), 1e-6 * abs(total[1]))

    def test_supports_are_told_by_their_directions(self):
        run, _ = self.draw(IN_STEPS)
        mesh = read_results.read_results(run.folder).mesh
        low = np.abs(mesh.coordinates[:, 1] + 0.3) < 1e-9
        self.assertEqual(set(mesh.held[low]), {3})
        self.assertEqual(set(mesh.held[~low]), {0})

    def test_peaks_stand_beside_what_is_left_in_time_and_no_load_factor_is_told(self):
        run, page = self.draw(IN_TIME, observations=OBSERVED, steps={"time": {"mass damping": 20.0}})
        rows = re.findall(r"<td class=[^>]*>top</td>(.*?)</tr>", page)
        cells = re.findall(r"<td>(.*?)</td>", rows[0])
        size = [np.hypot(row["ux_m of top"], row["uy_m of top"]) for row in run.history]
        peak = int(np.argmax(size))
        metres = lambda text: float(text.split()[0]) * UNITS[text.split()[1]]
        self.assertLess(abs(metres(cells[0]) / size[peak] - 1), 5e-3)  # three digits are shown
        self.assertLess(abs(float(cells[1].split()[0]) - run.history[peak]["time_s"]), 1e-4)
        self.assertLess(abs(metres(cells[2]) / size[-1] - 1), 5e-3)
        self.assertIn("the structure, its farthest node", page)
        words = re.sub(r"<script.*?</script>", "", page, flags=re.DOTALL)
        self.assertNotIn("oad factor", words)
        self.check_motion(run, page, len(run.history), -1)

    @unittest.skipUnless(shutil.which("chromium"), "Debian's chromium is not installed")
    def test_a_browser_steps_through_the_motion_and_stops_it(self):
        run, page = self.draw(IN_STEPS)
        tried = self.folder / "tried.html"
        tried.write_text(page.replace("</body>", TRIES + "</body>"), encoding="utf-8")
        done = subprocess.run(BROWSER + [f"--user-data-dir={self.folder / 'browser'}", tried.as_uri()], capture_output=True, text=True, check=False)
        self.assertNotIn("Uncaught", done.stderr)
        said = re.search(r'data-tried="([^"]*)"', done.stdout)
        self.assertTrue(said, done.stderr[-2000:])
        last = len(run.history) - 1
        self.assertEqual(said[1], f"{last} {last - 1} {last} 0 Stop Play 0 yes", done.stdout[:200])


if __name__ == "__main__":
    program.main()

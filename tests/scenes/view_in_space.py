"""The view of a structure in space in the report: what it draws is what the run wrote, and a browser draws it.

usage: view_in_space.py PROGRAM MPIEXEC [names of tests]

Set-up    A prism on rigid ground, pushed until it tips; a set that is called to break the page.
Expected  Places, displacements, statuses and resultants in the page are those of fields.h5; the page asks for no other file;
          Chromium, where it is there, draws it, and says so when every stage and control has been tried. A page of 144
          stones stays below 4 MB, 4.7 with pictures of all colours.
Tolerance Places to half of 1/65535 of the size, displacements to half of 1/32767 of the largest, resultants 1e-5.
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
sys.path.insert(0, str(ROOT / "tests" / "support"))
import program  # noqa: E402  (a folder of its own)
from stones import xml  # noqa: E402

GRAVITY = 9.81
SIZES = (1.0, 0.6, 2.0)  # [m] of the prism
GROUND = 0.5
STAGE = "</script><script>alert(1)</script>"
# Of a headless browser that may use no network and has no graphics card.
BROWSER = ["chromium", "--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
           "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
           "--ignore-gpu-blocklist", "--enable-logging=stderr", "--virtual-time-budget=8000", "--dump-dom"]
TRIES = """<script>setTimeout(() => {
  const at = (name) => document.querySelector("[name=" + name + "]"), tell = (name) => at(name).dispatchEvent(new Event("input"));
  for (const box of ["closed", "forces", "through", "built", "points"]) { at(box).click(); tell(box); }
  for (const list of ["stage", "set"]) for (const option of at(list).options) { at(list).value = option.value; tell(list); }
  at("scale").value = 0; tell("scale"); at("play").click(); at("play").click(); at("home").click();
  document.body.dataset.tried = "yes";
}, 500);</script>"""


def scene():
    push = {"type": "acceleration", "ay": GRAVITY}
    mesh = {"courses": 1, "blocks per course": 1, "block length": SIZES[0], "block height": SIZES[2], "thickness": SIZES[1],
            "bond": "stack", "ground height": GROUND}
    return xml("prism", {
        "mesh": {"type": "wall in space", "wall in space": mesh},
        "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000.0}},
        "joints": {"dry": {"friction coefficient": 0.6}}, "supports": {"ground": {"on": "ground"}},
        "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, "push": push}, "selection": {"mode": "all"},
        "steps": {"stages": {"own weight": {"loads": {"weight": 1.0}},
                             STAGE: {"loads": {"weight": 1.0, "push": 0.15}},
                             "over": {"loads": {"weight": 1.0, "push": 0.31}}}}}) + "\n"


def numbers(text, kind):
    return np.frombuffer(base64.b64decode(text), kind)


class ViewInSpace(program.SceneTest):
    def page(self):
        run = self.run_scene(scene())
        self.assertEqual(run.outcome, "collapse", run.said)
        make = ROOT / "drivers" / "report" / "make_report.py"
        subprocess.run([sys.executable, "-B", make, run.folder], check=True, capture_output=True)
        return run, (run.folder / "report.html").read_text(encoding="utf-8")

    def test_it_holds_what_the_run_wrote(self):
        run, page = self.page()
        self.assertNotIn("could not be drawn", page)
        data = json.loads(re.search(r'id="view-in-space-data">(.*?)</script>', page, re.DOTALL)[1])
        with h5py.File(run.folder / "fields.h5") as fields:
            x = fields["mesh/coordinates"][:]
            steps = [fields["steps"][name] for name in sorted(fields["steps"])]
            last = {step.attrs["stage"].decode(): step for step in steps}
            found = np.array(data["least"]) + data["unit"] * numbers(data["places"], np.uint16).reshape(-1, 3)
            self.assertEqual(len(found), len(x) - 1, "the node in the middle of the prism is not seen")
            near = np.abs(found[:, None, :] - x[None, :, :]).max(2)
            self.assertLess(near.min(1).max(), 0.5001 * data["unit"])
            # The prism of 2 x 2 x 2 cells and its ground of 2 x 2 x 1: two triangles for each face of a cell, twelve edges each.
            triangles = numbers(data["faces"], np.uint16).reshape(-1, 3)
            self.assertEqual(len(triangles), 2 * (24 + 16))
            self.assertEqual(len(numbers(data["edges"], np.uint16)) // 2, 12 * 2 + 8 * 2 + 4)
            a, b, c = (found[triangles[:, k]] for k in range(3))
            volume = (np.cross(b - a, c - a) * a).sum() / 6  # of what is outside: positive where faces look outward
            self.assertLess(abs(volume - SIZES[0] * SIZES[1] * (SIZES[2] + GROUND)), 1e-3)
            self.assertEqual([s["name"] for s in data["stages"]], list(last))
            for told, step in zip(data["stages"], last.values()):
                u = numbers(told["displacement"], np.int16).reshape(-1, 3) * told["largest"] / 32767
                expected = step["displacement"][:]
                self.assertLess(abs(np.abs(u).max() - np.abs(expected).max()), 1e-4 * told["largest"])
                self.assertEqual(numbers(told["status"], np.uint8).tolist(), step["joint_status"][:].reshape(-1).tolist())
            arrow = numbers(data["stages"][1]["arrows"], np.float32).reshape(-1, 6)
            self.assertEqual(len(arrow), 1)
            # The prism presses on the ground, or the ground on it, by its weight and what pushes it, 0.3 m from its middle.
            force = np.array([0, 0.15, -1.0]) / np.hypot(0.15, 1)
            self.assertLess(min(np.abs(arrow[0, 3:] - sign * force).max() for sign in (1, -1)), 1e-5)
            self.assertLess(np.abs(arrow[0, :2] - [SIZES[0] / 2, SIZES[1] / 2 + 0.15 * SIZES[2] / 2]).max(), 1e-5)

    def test_it_needs_no_other_file(self):
        _, page = self.page()
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:|#)[^"]*"', page), [])
        self.assertNotIn("<script>alert", page)

    def test_a_page_of_a_hundred_stones_can_be_sent_by_mail(self):
        run = self.run_scene((ROOT / "xml" / "dome.xml").read_text(encoding="utf-8"))
        make = ROOT / "drivers" / "report" / "make_report.py"
        subprocess.run([sys.executable, "-B", make, run.folder], check=True, capture_output=True)
        self.assertLess((run.folder / "report.html").stat().st_size, 4e6)

    @unittest.skipUnless(shutil.which("chromium"), "needs a browser, Debian's chromium")
    def test_a_browser_draws_it(self):
        run, page = self.page()
        tried = run.folder / "tried.html"
        tried.write_text(page.replace("</body>", TRIES + "</body>"), encoding="utf-8")
        done = subprocess.run([*BROWSER, f"--user-data-dir={run.folder}/browser", tried.as_uri()], capture_output=True, text=True, timeout=300)
        self.assertIn('data-ready="yes"', done.stdout, done.stderr[-2000:])
        self.assertIn('data-tried="yes"', done.stdout)
        problems = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
        self.assertEqual(problems, [])


if __name__ == "__main__":
    program.main()

"""drivers/sweep: all combinations, each a row; stopped and killed without loss; what is wrong is refused at once.

    sweep.py PROGRAM MPIEXEC
"""

import json
import pathlib
import re
import signal
import sys
import time
import xml.etree.ElementTree as tree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402
import sweeps  # noqa: E402

voussoir = sweeps.package()

FRICTION = "joints/dry/friction coefficient"
QUICK = ("--limit-analysis", "--no-reports")


class Combinations(sweeps.SweepTest):
    def test_every_combination_is_a_row_with_what_a_single_run_finds(self):
        scene = self.write(sweeps.wall(factor=sweeps.FACTOR))
        done = self.sweep(scene, "--set", f"{FRICTION}=0.2,0.4", "--set", "mesh/wall/courses=3:5:3", "--no-reports")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.rows()
        self.assertEqual([(row[FRICTION], row["mesh/wall/courses"]) for row in rows],
                         [(mu, n) for mu in ("0.2", "0.4") for n in ("3", "4", "5")])
        alone = self.run_scene(scene, "--set", f"{FRICTION}=0.4", "--set", "mesh/wall/courses=3", out="alone").result
        row = rows[3]
        self.assertEqual((row["outcome"], row["exit_code"], row["stands"]), ("collapse", "0", "yes"))
        self.assertEqual(float(row["factor_stands"]), alone["collapse"]["lower"])
        self.assertEqual(float(row["factor_falls"]), alone["collapse"]["upper"])
        self.assertEqual(float(row["largest_displacement_m"]), alone["largest_displacement_m"])
        self.assertEqual(float(row["least_friction_margin"]), alone["statics"]["least_friction_margin"])
        self.assertEqual(float(row["thrust_x_N of ground"]), alone["statics"]["reactions"]["ground"]["x_N"])
        for name in ("peak_slip_m", "peak_drift", "peak_m of top", "seconds"):
            self.assertGreater(float(row[name]), 0, name)

    def test_zip_takes_values_together(self):
        scene = self.write(sweeps.wall(factor=sweeps.FACTOR))
        rows = voussoir.sweep(scene, {FRICTION: [0.2, 0.4], "mesh/wall/courses": [3, 4], "mesh/wall/cells up": [2]}, together=True,
                              out=self.folder / "sweep", page=False, limit_analysis=True)
        self.assertEqual([(row[FRICTION], row["mesh/wall/courses"], row["mesh/wall/cells up"]) for row in rows],
                         [("0.2", "3", "2"), ("0.4", "4", "2")])
        for row, mu in zip(rows, (0.2, 0.4)):  # courses slide on each other
            self.assertAlmostEqual(row["factor_falls"], mu, places=6)

    def test_a_combination_that_is_wrong_among_good_ones_is_a_row(self):
        scene = self.write(sweeps.wall(openings=sweeps.OPENING))
        done = self.sweep(scene, "--set", "mesh/wall/openings/door/x from=0.5,1", "--set", "mesh/wall/openings/door/x to=1,1.1",
                          "--set", "mesh/wall/blocks per course=4", "--no-reports")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        rows = self.rows()
        self.assertEqual([row["outcome"] for row in rows], ["equilibrium", "equilibrium", "refused", "equilibrium"])
        self.assertEqual(rows[2]["exit_code"], "2")
        self.assertIn("must be >", rows[2]["message"])


class Page(sweeps.SweepTest):
    def test_a_curve_and_links_that_lead_to_reports(self):
        scene = self.write(sweeps.wall(factor=sweeps.FACTOR))
        done = self.sweep(scene, "--set", f"{FRICTION}=0.2,0.4")
        self.assertEqual(done.returncode, 0, done.stderr)
        folder = self.folder / "sweep"
        page = (folder / "sweep.html").read_text(encoding="utf-8")
        links = re.findall(r'<a href="([^"]+)"', page)
        self.assertEqual(len(links), 2)
        for link in links:
            self.assertTrue((folder / link).is_file(), link)
        self.assertTrue(tree.parse(folder / "sweep.svg").getroot().tag.endswith("svg"))
        self.assertRegex(page, r'alt="Curve over friction coefficient. Load factor that stands: least 0\.\d+')

    def test_units_titles_and_marks_are_those_of_the_scene(self):
        """Of a modulus the axis has Pa, nothing fell so that no mark is explained, and one sentence has what all runs share."""
        scene = self.write(sweeps.wall())
        done = self.sweep(scene, "--set", "materials/stone/Young modulus=2e9,4e9", "--no-reports")
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.folder / "sweep/sweep.html").read_text(encoding="utf-8")
        self.assertIn('alt="Curve over Young modulus [Pa]. Largest displacement: least', page)
        self.assertIn("2 in equilibrium", page)
        self.assertNotIn("runs that fell", page)
        self.assertRegex(page, r"The same in all: load factor 1[,.]")
        self.assertNotIn("<th>load factor</th>", page)

    def test_a_map_over_two_inputs_and_the_worst_of_all(self):
        scene = self.write(sweeps.wall(factor=sweeps.FACTOR))
        done = self.sweep(scene, "--set", f"{FRICTION}=0.2,0.3,0.4", "--set", "mesh/wall/courses=3,6", *QUICK, "--envelope")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('alt="Map over', (self.folder / "sweep/sweep.html").read_text(encoding="utf-8"))
        found = json.loads((self.folder / "sweep/envelope.json").read_text(encoding="utf-8"))
        worst = next(one for one in found["worst"] if one["column"] == "factor_falls")
        factors = {row["run"]: float(row["factor_falls"]) for row in self.rows()}
        self.assertEqual(worst["value"], min(factors.values()))
        self.assertEqual(factors[worst["run"]], worst["value"])

    def test_fragility_tells_up_to_where_all_stand(self):
        scene = self.write(sweeps.wall(steps=sweeps.EXPECTED, loads=sweeps.PUSHED))
        path = "steps/stages/own weight/loads/push"
        done = self.sweep(scene, "--set", f"{path}=0.1,0.3,0.7,1", "--no-reports", "--envelope")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = json.loads((self.folder / "sweep/envelope.json").read_text(encoding="utf-8"))
        # Friction of 0.5 holds 0.3 g and not 0.7 g.
        self.assertEqual([row["stands"] for row in self.rows()], ["yes", "yes", "no", "no"])
        self.assertEqual(found["stands"], [{"input": path, "stands_up_to": 0.3, "falls_at": 0.7}])


class Refused(sweeps.SweepTest):
    def test_what_is_wrong_is_said_at_once_and_leaves_nothing(self):
        scene = self.write(sweeps.wall())
        for options, words in (
                (("--set", "joints/dry/frictoin coefficient=1,2"), "did you mean"),
                (("--set", f"{FRICTION}=0.5,-1"), "must be >= 0"),
                (("--set", f"{FRICTION}=0:1"), "is no range"),
                (("--set", f"{FRICTION}=0:1:1"), "is no range"),
                (("--set", f"{FRICTION}=0:1:x"), "is no range"),
                (("--set", f"{FRICTION}=0.5,,0.6"), "has an empty value"),
                (("--set", f"{FRICTION}=0.5,0.5"), "has 0.5 twice"),
                (("--set", "selection/mode=all,everything"), "must be one of"),
                ((), "No input is varied"),
                (("--set", "a=1,2", "--set", "b=1,2,3", "--zip"), "a has 2, b has 3"),
                (("--set", "a=1,2", "--jobs", "0"), "--jobs = 0"),
                (("--set", "a=1,2", "--nonsense"), "--nonsense")):
            done = self.sweep(scene, *options)
            self.assertEqual(done.returncode, 2, options)
            self.assertIn(words, done.stderr, options)
            self.assertFalse((self.folder / "sweep").exists(), options)

    def test_a_scene_that_is_not_there(self):
        done = self.sweep("nowhere.xml", "--set", "a=1,2")
        self.assertEqual(done.returncode, 2)
        self.assertIn("scene = nowhere.xml", done.stderr)

    def test_a_scene_or_a_program_that_has_changed_is_noticed(self):
        scene = self.write(sweeps.wall(factor=sweeps.FACTOR))
        options = ("--set", f"{FRICTION}=0.2,0.4", *QUICK)
        self.assertEqual(self.sweep(scene, *options).returncode, 0)
        wrapped = self.folder / "voussoir"
        wrapped.write_text(f'#!/bin/sh\nexec "{pathlib.Path(program.PROGRAM).resolve()}" "$@"\n', encoding="utf-8")
        wrapped.chmod(0o755)
        done = self.sweep(scene, *options, VOUSSOIR_PROGRAM=str(wrapped))
        self.assertEqual(done.returncode, 2)
        self.assertIn("another program", done.stderr)
        scene.write_text(scene.read_text().replace("2000", "2400"), encoding="utf-8")
        done = self.sweep(scene, *options)
        self.assertEqual(done.returncode, 2)
        self.assertIn("other content of wall.xml", done.stderr)
        self.assertEqual(self.sweep(scene, *options, "--overwrite").returncode, 0)


class Stopped(sweeps.SweepTest):
    OPTIONS = ("--set", "steps/stages/rest/duration=0.01,0.02,0.2,0.015", "--set", "output/every=50",
               "--jobs", "1", "--no-reports")

    def row_files(self):
        return {path.parent.name: path.stat().st_mtime_ns for path in (self.folder / "sweep/runs").glob("*/row.json")}

    def begun_and(self, what):
        """A sweep whose third run, a long one, is stopped in its middle; what it had written by then."""
        self.scene = self.write(sweeps.wall(time=sweeps.SHAKEN))
        begun = self.begin(self.scene, *self.OPTIONS)
        third = self.folder / "sweep/runs/duration=0.2+every=50/history.csv"
        until = time.monotonic() + 120
        while not (third.exists() and len(third.read_text().splitlines()) > 5):
            self.assertLess(time.monotonic(), until)
            self.assertIsNone(begun.poll(), "the sweep has ended too soon")
            time.sleep(0.02)
        begun.send_signal(what)
        said = begun.communicate(timeout=120)[0]
        return begun.returncode, said

    def goes_on(self, before):
        done = self.sweep(self.scene, *self.OPTIONS)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        after = self.row_files()
        self.assertEqual(len(after), 4)
        for name in ("duration=0.01+every=50", "duration=0.02+every=50"):
            self.assertEqual(before[name], after[name], f"{name} has been run again")
        rows = self.rows()
        self.assertEqual([row["outcome"] for row in rows], ["equilibrium"] * 4)
        history = (self.folder / "sweep/runs/duration=0.2+every=50/history.csv").read_text().splitlines()
        self.assertEqual(len(history), 1 + 1 + 200)  # heading, own weight, steps of a millisecond

    def test_ctrl_c_saves_and_the_same_command_goes_on(self):
        code, said = self.begun_and(signal.SIGINT)
        self.assertEqual(code, 5, said)
        rows = self.rows()
        self.assertEqual([row["outcome"] for row in rows], ["equilibrium", "equilibrium", "interrupted", "not_run"])
        self.assertTrue((self.folder / "sweep/runs/duration=0.2+every=50/checkpoint.h5").exists())
        self.goes_on(self.row_files())
        # From its checkpoint, not from its beginning.
        self.assertIn("Going on after step", (self.folder / "sweep/runs/duration=0.2+every=50/run.log").read_text())

    def test_a_run_whose_time_is_over_is_a_row_with_what_it_knows_and_goes_on(self):
        scene = self.write(sweeps.wall(time=sweeps.SHAKEN))
        lengths = []
        for _ in range(2):
            rows = voussoir.sweep(scene, {"steps/stages/rest/duration": [0.005, 60], "output/every": [100]}, out=self.folder / "sweep",
                                  page=False, at_most="2s")
            self.assertEqual([(row["outcome"], row["exit_code"]) for row in rows], [("equilibrium", 0), ("interrupted", 5)])
            self.assertIn("stopped because its time was over after", rows[1]["message"])
            self.assertEqual(rows[1]["stands"], "")
            history = self.folder / "sweep/runs/duration=60+every=100/history.csv"
            lengths.append(len(history.read_text().splitlines()))
        self.assertGreater(lengths[1], lengths[0])

    def test_a_sweep_that_is_killed_loses_nothing(self):
        code, _ = self.begun_and(signal.SIGKILL)
        self.assertEqual(code, -signal.SIGKILL)
        self.assertEqual([row["outcome"] for row in self.rows()][:2], ["equilibrium", "equilibrium"])
        self.goes_on(self.row_files())


if __name__ == "__main__":
    program.main()

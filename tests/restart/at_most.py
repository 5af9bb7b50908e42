"""A run that is stopped, by its time or by a signal, ends with what it knows by then, with exit code 5, and can be gone on with.

    at_most.py PROGRAM MPIEXEC
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402
import sweeps  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
# With this many stones an attempt at a load factor that turns far takes a second, the whole search minutes: processors may
# be ten times as fast, or as slow.
SLOW = ROOT / "xml/spreading-arch.xml"
SLOWLY = ("--set", "mesh/arch/voussoirs=192", "--set", "load factor/accuracy=1e-5", "--set", "load factor/first factor=0.02")
# Beside the time that was asked for: the start of the program, its last linear solve, what it writes; on a busy machine.
SPARE = 20.0


class AtMost(sweeps.SweepTest):
    def known(self, out="out"):
        return json.loads((self.folder / out / "interrupted.json").read_text(encoding="utf-8"))

    def long_stage(self, duration):
        return sweeps.wall(time=sweeps.SHAKEN).replace('name="duration" type="double" value="0.1"',
                                                       f'name="duration" type="double" value="{duration}"')

    def test_a_search_ends_in_time_with_its_bracket(self):
        # On a slow machine no factor may be known to stand after the shorter time.
        for seconds in 6, 60:
            began = time.monotonic()
            run = self.run_scene(SLOW, f"--at-most={seconds}s", "--overwrite", *SLOWLY)
            self.assertEqual(run.code, 5, run.said)
            self.assertLess(time.monotonic() - began, seconds + SPARE)
            known = self.known()
            self.assertEqual(known["outcome"], "interrupted")
            self.assertFalse((self.folder / "out/result.json").exists())
            self.assertTrue(known["message"].startswith("stopped because its time was over after "), known["message"])
            self.assertIn(known["message"][1:], run.words)  # with a capital there
            self.assertIn("--restart", run.said)
            if known["collapse"]["lower"] > 0:
                break
        self.assertIn(f"it stands at {known['collapse']['lower']:.6g}", known["message"])
        self.assertEqual(known["collapse"]["attempts"][0]["outcome"], "equilibrium")

    def test_a_motion_goes_on_where_its_time_was_over_on_all_ranks_alike(self):
        scene = self.long_stage(0.6)
        options = ("--set", "output/every=100", "--at-most=2.5s")
        run = self.run_scene(scene, *options, ranks=2)
        rounds = 1
        while run.code == 5:
            self.assertRegex(run.words, r"Stopped because its time was over after \d+ steps?: ", run.said)
            self.assertEqual(self.known()["outcome"], "interrupted")
            self.assertLess(rounds, 60)
            run = self.run_scene(scene, *options, "--restart", ranks=2)
            rounds += 1
        self.assertEqual((run.code, run.outcome), (0, "equilibrium"), run.said)
        self.assertFalse((self.folder / "out/interrupted.json").exists())
        self.assertEqual([row["step"] for row in run.history], list(range(1, 602)))

    def test_the_scene_may_say_so(self):
        steps = '<Parameter name="at most" type="double" value="1.5"/>'
        run = self.run_scene(self.long_stage(20).replace('<ParameterList name="steps">', f'<ParameterList name="steps"> {steps}'))
        self.assertEqual(run.code, 5, run.said)
        self.assertRegex(self.known()["message"], r"stage 'rest' .*", run.said)
        # A key that decides nothing that was computed may change when the run goes on.
        run = self.run_scene(self.long_stage(20), "--restart", "--at-most=1s")
        self.assertEqual(run.code, 5, run.said)
        self.assertIn("Going on after step", run.said)

    def test_what_is_no_time_is_refused(self):
        for text in ("0", "-5", "soon", "5days", "5 min 3", ""):
            run = self.run_scene(self.long_stage(1), f"--at-most={text}")
            self.assertEqual(run.code, 2, text)
            self.assertIn("--at-most", run.said)
        for text in ("1h", "2.5min", "90", "90 s"):
            self.assertEqual(self.run_scene(sweeps.wall(), f"--at-most={text}", "--validate").code, 0, text)

    def stopped_by(self, what, command):
        """What a run says that gets a signal in its stage of many steps."""
        scene = self.write(self.long_stage(20))
        begun = subprocess.Popen([*command, str(scene), f"--out={self.folder / 'out'}"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                 text=True, env=sweeps.environment(), start_new_session=True)
        history = self.folder / "out/history.csv"
        until = time.monotonic() + 60
        while not (history.exists() and len(history.read_text().splitlines()) > 10):
            self.assertLess(time.monotonic(), until)
            time.sleep(0.05)
        os.kill(begun.pid, what)
        said = begun.communicate(timeout=60)[0]
        self.assertEqual(begun.returncode, 5, said)
        return said

    def test_ctrl_c_on_the_program_saves_as_sigterm_does(self):
        for what in (signal.SIGINT, signal.SIGTERM):
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            said = self.stopped_by(what, [str(pathlib.Path(program.PROGRAM).resolve()), "--overwrite", "--xml"])
            self.assertIn("Stopped by a signal after", said)
            self.assertTrue((self.folder / "out/checkpoint.h5").exists())
            known = self.known()
            self.assertEqual(known["steps"], len((self.folder / "out/history.csv").read_text().splitlines()) - 1)
            self.assertIn(f"stopped by a signal after {known['steps']} steps: stage 'rest' is passed to ", known["message"])

    def test_limit_analysis_ends_within_its_programmes(self):
        # Those of a wall of 40 x 40 stones take most of a minute.
        large = [f"--set=mesh/wall/{key}=40" for key in ("courses", "blocks per course")]
        for ranks in 1, 2:
            began = time.monotonic()
            run = self.run_scene(ROOT / "xml/wall.xml", "--limit-analysis", "--at-most=4s", *large, ranks=ranks, out=f"on {ranks}")
            self.assertEqual(run.code, 5, run.said)
            self.assertLess(time.monotonic() - began, 4 + SPARE)
            known = self.known(f"on {ranks}")
            self.assertEqual(known["outcome"], "interrupted")
            self.assertRegex(known["message"], "^stopped because its time was over: .* is not known$")
            self.assertFalse((self.folder / f"on {ranks}/result.json").exists())
            self.assertIsNone(known["rigid"].get("free_share_of_joints"))
            self.assertNotIn("--restart", run.said)

    def test_a_run_that_was_stopped_has_a_report(self):
        said = self.stopped_by(signal.SIGINT, [str(ROOT / "drivers/run"), "--ranks=1", "--overwrite"])
        page = (self.folder / "out/report.html").read_text(encoding="utf-8")
        self.assertIn("Report: ", said)
        self.assertIn("stopped before its end", page)
        self.assertRegex(page, r"The run has not come to its end: stopped by a signal after \d+ steps")


if __name__ == "__main__":
    program.main()

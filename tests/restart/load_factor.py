"""A load factor analysis that is stopped goes on to the last bit; one that ended undecided can be tried again.

    load_factor.py PROGRAM MPIEXEC
"""

import pathlib
import signal
import sys
import time
import unittest

from runs import ROOT, Program, differences, empty, history, result

PROGRAM = None
PATIENCE = 1000  # seconds, also under sanitizers
INTERRUPTED = 5
WALL = f"--xml={ROOT / 'xml' / 'ferris-tin-loi-wall.xml'}"
ARCH = f"--xml={ROOT / 'xml' / 'oppenheim-arch.xml'}"
SPREADING = f"--xml={ROOT / 'xml' / 'spreading-arch.xml'}"
ROUGH = ["load factor/accuracy=0.05"]  # six attempts after the doubling


def rows(folder):
    path = folder / "history.csv"
    return len(path.read_text().splitlines()) - 1 if path.exists() else 0


class LoadFactor(unittest.TestCase):
    def stop_after(self, steps, out, scene=WALL, settings=ROUGH):
        """Stops a run by a signal when so many steps are in its history: the attempt that follows takes longer."""
        process = PROGRAM.start(out, scene, settings=settings)
        while process.poll() is None and rows(out) < steps:
            time.sleep(0.002)
        process.send_signal(signal.SIGUSR1)
        return process.wait(timeout=PATIENCE)

    def test_a_stopped_search_goes_on_to_the_last_bit(self):
        reference = empty("restart/load_factor/reference")
        done = PROGRAM.run(reference, WALL, settings=ROUGH)
        self.assertEqual(done.returncode, 0, done.stderr)
        # Rows: weight, 0.1, 0.2, 0.4, and just below the estimate of limit analysis, 0.64; just above it collapses.
        stopped = empty("restart/load_factor/stopped")
        self.assertEqual(self.stop_after(4, stopped), INTERRUPTED)
        done = PROGRAM.run(stopped, WALL, "--restart", settings=ROUGH)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Going on after step 4, load factor 0.4", done.stdout)
        self.assertEqual(differences(stopped, reference), [])

    def test_stones_that_have_turned_go_on_to_the_last_bit(self):
        reference, stopped = empty("restart/load_factor/turned"), empty("restart/load_factor/turned_and_stopped")
        short = ["load factor/largest factor=1"]  # m, where it still stands
        done = PROGRAM.run(reference, SPREADING, settings=short)
        self.assertEqual(done.returncode, 0, done.stderr)
        # Rows: weight, 0.4 m, 0.8 m, 1 m.
        self.assertEqual(self.stop_after(3, stopped, SPREADING, short), INTERRUPTED)
        done = PROGRAM.run(stopped, SPREADING, "--restart", settings=short)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Going on after step 3, load factor 0.8", done.stdout)
        self.assertEqual(differences(stopped, reference), [])

    def test_undecided_is_no_collapse_and_can_be_tried_again(self):
        # 24 linear solves are enough where the arch stands, and for nothing else: limit analysis alone ends the bracket.
        out = empty("restart/load_factor/undecided")
        done = PROGRAM.run(out, ARCH, settings=["newton/largest iterations=24"])
        self.assertEqual(done.returncode, 0, done.stderr)
        found = result(out)
        self.assertIn("static theorem", found["message"])
        self.assertEqual(found["collapse"]["upper"], found["collapse"]["certified_upper"])
        self.assertNotIn("collapse", [a["outcome"] for a in found["collapse"]["attempts"]])
        steps = rows(out)
        done = PROGRAM.run(out, ARCH, "--restart", settings=[])
        self.assertEqual(done.returncode, 0, done.stderr)
        found = result(out)
        self.assertEqual(found["outcome"], "collapse")
        self.assertLess(found["collapse"]["lower"], 0.371)
        self.assertLess(0.369, found["collapse"]["upper"])
        self.assertLessEqual(steps, len(history(out)))

    def test_a_search_cannot_go_on_in_a_scene_that_asks_for_none(self):
        out = empty("restart/load_factor/none")
        self.assertEqual(self.stop_after(4, out), INTERRUPTED)
        text = (out / "scene.xml").read_text()
        start = text.index('<ParameterList name="pattern">')
        end = text.index("</ParameterList>", start)
        scene = pathlib.Path("restart/load_factor/without.xml").resolve()
        scene.write_text(text[:start] + '<ParameterList name="pattern">' + text[end:])
        done = PROGRAM.run(out, f"--xml={scene}", "--restart", settings=[])
        self.assertEqual(done.returncode, 2)
        self.assertIn("stands in a load factor analysis", done.stderr)


if __name__ == "__main__":
    PROGRAM = Program(*sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

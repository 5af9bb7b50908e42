"""Time steps that a signal stops go on to the last bit: velocities, the length of steps and the energy book with them.

    in_time.py PROGRAM MPIEXEC

A block that slides with a given step, and bars that collide with steps the program chooses.
"""

import shutil
import signal
import sys
import time
import unittest

import runs
from runs import Program, differences, empty, history, tables

PROGRAM = None
INTERRUPTED, PATIENCE = 5, 1000


def stop_after(rows, out, settings):
    process = PROGRAM.start(out, settings=settings)
    path = out / "history.csv"
    while process.poll() is None and not (path.exists() and len(path.read_text().splitlines()) > rows):
        time.sleep(0.002)
    process.send_signal(signal.SIGUSR1)
    return process.wait(timeout=PATIENCE)


class RestartInTime(unittest.TestCase):
    def check(self, scene, settings, stops):
        runs.SCENE = runs.ROOT / "xml" / f"{scene}.xml"
        reference = empty(f"in_time/reference-{scene}")
        done = PROGRAM.run(reference, settings=settings)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        steps = len(history(reference))
        self.assertGreater(steps, max(stops) + 20, "too short to be stopped")
        for stop in stops:
            out = empty(f"in_time/{scene}")
            self.assertEqual(stop_after(stop, out, settings), INTERRUPTED, f"not stopped after step {stop} of {steps}")
            self.assertTrue((out / "checkpoint.h5").exists())
            done = PROGRAM.run(out, "--restart", settings=settings)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(differences(out, reference), [])
            shutil.rmtree(out)
        self.assertGreater(len(tables(reference)), 10)

    def test_a_block_slides_on(self):
        self.check("sliding-block", ["output/every=20"], (0, 100))

    def test_bars_collide_after_the_restart(self):
        self.check("impact-bars", ["output/every=20"], (0, 60))


if __name__ == "__main__":
    PROGRAM = Program(sys.argv.pop(1), sys.argv.pop(1))
    unittest.main()

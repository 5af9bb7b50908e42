"""A scene that is built in stages goes on to the last bit from between any two of them: births, gaps and history kept.

    construction.py PROGRAM MPIEXEC

A wall of five courses. The two upper ones appear late, the one on top goes again; it is pushed before and after.
"""

import shutil
import signal
import sys
import time
import unittest

import runs
from runs import Program, differences, empty, history, largest_difference

PROGRAM = None
INTERRUPTED, PATIENCE = 5, 1000

SCENE = """<ParameterList name="built">
  <ParameterList name="mesh">
    <Parameter name="type" type="string" value="wall"/>
    <ParameterList name="wall">
      <Parameter name="courses" type="int" value="5"/> <Parameter name="blocks per course" type="int" value="5"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="materials"><ParameterList name="stone"/></ParameterList>
  <ParameterList name="joints">
    <ParameterList name="dry"><Parameter name="friction coefficient" type="double" value="0.6"/></ParameterList>
  </ParameterList>
  <ParameterList name="supports">
    <ParameterList name="ground"><Parameter name="on" type="string" value="base"/></ParameterList>
  </ParameterList>
  <ParameterList name="loads">
    <ParameterList name="weight"><Parameter name="type" type="string" value="self weight"/></ParameterList>
    <ParameterList name="push">
      <Parameter name="type" type="string" value="acceleration"/> <Parameter name="ax" type="double" value="1.5"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="construction">
    <ParameterList name="fourth">
      <Parameter name="blocks" type="string" value="course 3"/> <Parameter name="appears" type="string" value="higher"/>
    </ParameterList>
    <ParameterList name="fifth">
      <Parameter name="blocks" type="string" value="course 4"/> <Parameter name="appears" type="string" value="top"/>
      <Parameter name="disappears" type="string" value="cut"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="steps"><ParameterList name="stages">STAGES</ParameterList></ParameterList>
</ParameterList>
"""
STAGES = (("low", 1, "weight=1"), ("pushed", 2, "push=1"), ("higher", 2, "push=0.5"), ("top", 2, "push=0"),
          ("again", 3, "push=1"), ("cut", 2, "push=0.2"))
STEPS = sum(increments for _, increments, _ in STAGES)


def stage(name, increments, load):
    load, factor = load.split("=")
    return (f'<ParameterList name="{name}"><Parameter name="increments" type="int" value="{increments}"/>'
            f'<ParameterList name="loads"><Parameter name="{load}" type="double" value="{factor}"/></ParameterList>'
            "</ParameterList>")


def rows(out):
    path = out / "history.csv"
    return len(path.read_text().splitlines()) - 1 if path.exists() else 0


class RestartOfConstruction(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = empty("built")
        folder.mkdir(parents=True)
        runs.SCENE = folder / "built.xml"
        runs.SCENE.write_text(SCENE.replace("STAGES", "".join(stage(*s) for s in STAGES)))
        cls.reference = folder / "reference"
        done = PROGRAM.run(cls.reference, settings=[])
        assert done.returncode == 0, done.stdout + done.stderr

    def stopped_after(self, steps, name):
        out = empty(f"built/{name}")
        process = PROGRAM.start(out, settings=[])
        while process.poll() is None and rows(out) < steps:
            time.sleep(0.002)
        process.send_signal(signal.SIGUSR1)
        self.assertEqual(process.wait(timeout=PATIENCE), INTERRUPTED)
        return out

    def test_the_reference_is_built_and_slips(self):
        steps = history(self.reference)
        self.assertEqual(len(steps), STEPS)
        self.assertGreater(float(steps[-1]["friction_J"]), 0)
        self.assertGreater(int(steps[-1]["open_points"]), 0)
        # 20 to 80 each; stones that are not there once led the way to the solution astray for 2000.
        self.assertLess(max(int(row["linear_solves"]) for row in steps), 400)

    def test_it_goes_on_to_the_last_bit_from_every_stage(self):
        for steps in (1, 3, 5, 7, 10):  # the end of every stage but the last
            out = self.stopped_after(steps, "stopped")
            done = PROGRAM.run(out, "--restart", settings=[])
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(differences(out, self.reference), [], f"stopped after step {steps}")
            shutil.rmtree(out)

    def test_it_goes_on_with_other_ranks_to_the_tolerance_of_the_solver(self):
        out = self.stopped_after(5, "ranks")
        done = PROGRAM.run(out, "--restart", ranks=2, settings=[])
        self.assertEqual(done.returncode, 0, done.stderr)
        # Newton stops at 1e-8 of the forces; displacements of loose stones are known to a hundred times that.
        self.assertLess(largest_difference(out, self.reference, "displacement"), 1e-6)


if __name__ == "__main__":
    PROGRAM = Program(sys.argv.pop(1), sys.argv.pop(1))
    unittest.main()

"""Two runs without mpirun at the same time, as a sweep starts them: neither is heard in the other.

usage: side_by_side.py PROGRAM MPIEXEC

Set-up    The same small scene, run by two programs at once, four times each.
Expected  Every run ends with 0 and says nothing on standard error: what a library of MPI shares between runs of one machine,
          such as files that the one removes while the other makes them, would be told there.
"""

import os
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import program  # noqa: E402  (a folder of its own)

SCENE = ROOT / "xml" / "arch.xml"


class SideBySide(program.SceneTest):
    def test_runs_do_not_meet(self):
        environment = {**os.environ, **program.ENVIRONMENT}
        for turn in range(4):
            pair = [subprocess.Popen([program.PROGRAM, f"--xml={SCENE}", f"--out={self.folder / f'{turn}-{one}'}"],
                                     stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=environment) for one in range(2)]
            for one in pair:
                _, said = one.communicate(timeout=300)
                self.assertEqual((one.returncode, said), (0, ""))


if __name__ == "__main__":
    program.main()

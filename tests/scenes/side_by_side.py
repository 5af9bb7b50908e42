"""Two runs without mpirun at the same time, as a sweep starts them: neither is heard in the other.

usage: side_by_side.py PROGRAM MPIEXEC

Set-up    The same small scene, run by two programs at once, four times each; read by eight at once, ten times each: these
          begin and end so often that some end while others begin.
Expected  Every run ends with 0 and says nothing on standard error: what a library of MPI shares between runs of one machine,
          such as files that the one removes while the other makes them, would be told there.
"""

import concurrent.futures
import os
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import program  # noqa: E402  (a folder of its own)

SCENE = ROOT / "xml" / "arch.xml"
AT_ONCE, TIMES = 8, 10


class SideBySide(program.SceneTest):
    def test_runs_do_not_meet(self):
        environment = {**os.environ, **program.ENVIRONMENT}
        for turn in range(4):
            pair = [subprocess.Popen([program.PROGRAM, f"--xml={SCENE}", f"--out={self.folder / f'{turn}-{one}'}"],
                                     stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=environment) for one in range(2)]
            for one in pair:
                _, said = one.communicate(timeout=300)
                self.assertEqual((one.returncode, said), (0, ""))

    def test_what_begins_does_not_meet_what_ends(self):
        environment = {**os.environ, **program.ENVIRONMENT}

        def read(_):
            done = subprocess.run([program.PROGRAM, f"--xml={SCENE}", "--validate"], capture_output=True, text=True, env=environment,
                                  check=False)
            return done.returncode, done.stderr

        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            self.assertEqual(set(pool.map(read, range(AT_ONCE * TIMES))), {(0, "")})


if __name__ == "__main__":
    program.main()

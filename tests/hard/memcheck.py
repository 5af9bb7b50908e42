"""Three small scenes on two ranks under valgrind's memcheck: nothing read that was not written, nothing beyond its end,
nothing lost.

usage: memcheck.py PROGRAM MPIEXEC

Set-up    A dry stone wall pushed sideways, adaptive, with checkpoints; an arch whose springing moves out; a block that
          gmsh meshes and that falls on another in ten time steps. memcheck.supp names what Open MPI, its libraries and
          the loader do themselves.
Expected  No error in any process, gmsh's own included, and the outcome the scene has without valgrind.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "ground"))
sys.path.insert(0, str(HERE.parent / "restart"))
from case import ENVIRONMENT  # noqa: E402  (folders of their own)
from drawing import grid  # noqa: E402
from runs import empty  # noqa: E402
import scenes  # noqa: E402

PROGRAM = MPIEXEC = None
FOUND = 99  # exit code when memcheck found something
VALGRIND = ["valgrind", "--tool=memcheck", f"--error-exitcode={FOUND}", f"--suppressions={HERE / 'memcheck.supp'}",
            "--num-callers=40", "--trace-children=yes", "--leak-check=full", "--show-leak-kinds=definite",
            "--errors-for-leak-kinds=definite", "--keep-debuginfo=yes"]  # of plug-ins that are gone by the end


def falling_block():
    """A block 1 mm above another falls on it."""
    return scenes.scene(grid(1, 2, 0.5, 0.25, 0.25), stages={"falls": {"duration": 0.02, "time step": 0.002,
                                                                        "loads": {"weight": 1.0}}},
                        joints={"dry": {"friction coefficient": 0.6, "initial gap": 0.001}})


def settling_arch():
    return scenes.scene(scenes.arch(5), supports=("springing left", "springing right"),
                        loads={"moves": {"type": "settlement", "support": "springing right", "ux": 0.001}},
                        stages={"own weight": {"loads": {"weight": 1.0}}, "moves": {"loads": {"moves": 1.0}}})


class Memcheck(unittest.TestCase):
    def check(self, name, content, processes=2):
        folder = empty(f"memcheck/{name}")
        folder.mkdir(parents=True)
        scene = scenes.write(content, folder)
        command = [MPIEXEC, "--oversubscribe", "-np", "2", *VALGRIND, f"--log-file={folder}/memcheck-%p.txt", PROGRAM,
                   f"--xml={scene}", f"--out={folder / 'out'}", "--quiet"]
        done = subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, **ENVIRONMENT})
        logs = [log.read_text() for log in folder.glob("memcheck-*.txt")]
        self.assertEqual(len(logs), processes, done.stderr)
        for log in logs:
            self.assertIn("ERROR SUMMARY: 0 errors", log, log[:8000])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(json.loads((folder / "out" / "result.json").read_text())["outcome"], "equilibrium")

    def test_a_wall_is_pushed(self):
        self.check("wall", scenes.pushed_wall(3, output={"report": False, "checkpoint every": 1}))

    def test_a_springing_moves(self):
        self.check("arch", settling_arch())

    def test_a_block_falls(self):
        self.check("block", falling_block(), processes=5)  # gmsh: one that waits, one that looks and one that meshes


if __name__ == "__main__":
    PROGRAM, MPIEXEC = sys.argv.pop(1), sys.argv.pop(1)
    if not shutil.which("valgrind"):
        sys.exit("valgrind is not installed: apt-get install valgrind")
    unittest.main()

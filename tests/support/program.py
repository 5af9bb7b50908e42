"""Runs the program on small scenes, for tests that are written in Python.

    class Fall(program.SceneTest):
        def test_a_stone_falls(self):
            run = self.run_scene(stones.scene(...), drawing=stones.geo(...))
            self.assertEqual(run.outcome, "equilibrium", run.said)

    if __name__ == "__main__":
        program.main()          # test.py PROGRAM MPIEXEC [names of tests]
"""

import csv
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

PROGRAM = MPIEXEC = None
# What runs of several ranks need where cores are few and users are root; see cmake/voussoir_add_test.cmake.
ENVIRONMENT = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
               "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
               "OMPI_MCA_mpi_yield_when_idle": os.environ.get("OMPI_MCA_mpi_yield_when_idle", "1"), "OMPI_MCA_hwloc_base_binding_policy": "none"}


def number(text):
    """A cell of a table: a number, a word, or not a number where it is empty."""
    try:
        return float(text)
    except ValueError:
        return text or math.nan


class Run:
    """What one run said and left behind."""

    def __init__(self, folder, done):
        self.folder, self.code = folder, done.returncode
        self.said = done.stdout + done.stderr
        self.words = " ".join(self.said.split())  # without the breaks of lines
        file = folder / "result.json"
        self.result = json.loads(file.read_text()) if file.exists() else {}

    @property
    def outcome(self):
        return self.result.get("outcome")

    @property
    def warnings(self):
        """The names of its warnings."""
        return [w["what"] for w in self.result.get("warnings", [])]

    def table(self, name):
        """Rows of a table of the results, such as history.csv."""
        with open(self.folder / name, newline="", encoding="utf-8") as file:
            return [{key: number(value) for key, value in row.items()} for row in csv.DictReader(file)]

    @property
    def history(self):
        return self.table("history.csv")


def run(scene, out, *options, ranks=1, environment=None, seconds=600):
    """Runs the scene of that path into a folder."""
    launch = [MPIEXEC, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    done = subprocess.run([*launch, PROGRAM, f"--xml={scene}", f"--out={out}", *options], capture_output=True, text=True,
                          check=False, timeout=seconds, env={**os.environ, **ENVIRONMENT, **(environment or {})})
    return Run(out, done)


class SceneTest(unittest.TestCase):
    """Every test has a folder of its own, which is empty when it begins."""

    def setUp(self):
        self.folder = pathlib.Path(type(self).__name__, self._testMethodName).resolve()
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def run_scene(self, scene, *options, drawing=None, out="out", ranks=1, environment=None, seconds=600):
        """Runs a scene: its text, which is written beside its drawing `stones.geo`, or the path of one."""
        if not isinstance(scene, os.PathLike):
            text, scene = scene, self.folder / f"{out}.xml"
            scene.write_text(text, encoding="utf-8")
        if drawing is not None:
            (self.folder / "stones.geo").write_text(drawing, encoding="utf-8")
        return run(scene, self.folder / out, *options, ranks=ranks, environment=environment, seconds=seconds)


def main():
    global PROGRAM, MPIEXEC
    PROGRAM, MPIEXEC = sys.argv[1:3]
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], module="__main__")

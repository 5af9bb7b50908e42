"""drivers/report/compare_runs.py tells how far two runs are apart.

usage: compare_runs.py PROGRAM MPIEXEC

Set-up    A wall of triangles under its weight and pushed, with all points and adaptively, in plane stress and in plane strain.
Expected  The norm that it compares with is the elastic energy that the program tells, to round-off: stresses of linear triangles
          are constant. A run is not apart from itself. Adaptive selection is apart from all points by less than its
          tolerance allows, and not by nothing.
"""

import csv
import pathlib
import sys
import unittest

import h5py

ROOT = pathlib.Path(__file__).resolve().parents[2]
for folder in ("tests/hard/ground", "tests/restart", "drivers/report"):
    sys.path.insert(0, str(ROOT / folder))
import compare_runs  # noqa: E402  (folders of their own)
import scenes  # noqa: E402
from drawing import grid  # noqa: E402
from runs import empty, run_scene  # noqa: E402

PROGRAM = MPIEXEC = None


class CompareRuns(unittest.TestCase):
    def run_wall(self, plane, mode):
        folder = empty(f"compare_runs/{plane}-{mode}")
        (folder / "scene").mkdir(parents=True)
        made = scenes.scene(grid(3, 3, 0.6, 0.4, 0.2, cells="triangle"), selection={"mode": mode},
                            model={"plane": plane, "thickness": 0.5},
                            loads={"push": {"type": "acceleration", "ax": 2.0}},
                            stages={"weight": {"loads": {"weight": 1.0}}, "push": {"loads": {"push": 1.0}}})
        run_scene(PROGRAM, MPIEXEC, folder / "run", scenes.write(made, folder / "scene"))
        return folder / "run"

    def test_the_norm_is_that_of_elastic_energy(self):
        for plane in ("stress", "strain"):
            run = self.run_wall(plane, "all")
            with open(run / "history.csv", encoding="utf-8", newline="") as file:
                told = float(list(csv.DictReader(file))[-1]["elastic_J"])
            ratio = compare_runs.effective_poisson_ratio(run / "scene.xml")
            modulus = scenes.STONE["Young modulus"] / (1 if plane == "stress" else 1 - scenes.STONE["Poisson ratio"]**2)
            with h5py.File(run / "fields.h5") as fields:
                area = compare_runs.areas(fields["mesh/coordinates"][()], fields["mesh/cells"][()])
                stress = fields["steps"][sorted(fields["steps"])[-1]]["stress"][()]
            self.assertAlmostEqual(0.5 * 0.5 * compare_runs.energy(stress, area, ratio) / modulus / told, 1, delta=1e-9)

    def test_runs_are_as_far_apart_as_they_are(self):
        every, some = self.run_wall("stress", "all"), self.run_wall("stress", "adaptive")
        self.assertEqual([d[1:] for d in compare_runs.differences(every, every)], [(0, 0), (0, 0)])
        apart = compare_runs.differences(some, every)
        self.assertEqual([d[0][0] for d in apart], ["weight", "push"])
        self.assertLess(0, max(d[1] for d in apart))
        self.assertLess(max(d[1] for d in apart), 0.05)


if __name__ == "__main__":
    PROGRAM, MPIEXEC = (str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

"""A wall measured by hand, from CSV, DXF and SVG, to how far it can be pushed: one command each.

    survey.py PROGRAM MPIEXEC

Set-up    22 stones in running bond, in millimetres, corners off by 1 to 5 mm. Friction coefficient 0.6.
Expected  The right end of the wall slides on beds that the survey has falling to the right. By hand: the last stone of the top
          course on its bed, from the mean of the corners measured at its left end to the mean of those at its right end,
          at tan(friction angle - fall).
Tolerance 1 %: ends of beds are known to a millimetre or two of 600, and where the halves of a bed fall differently the flatter
          one may bear the stone.
"""

import csv
import math
import pathlib
import shutil
import sys

import h5py

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
import program  # noqa: E402  (a folder of its own)


def bed():
    """The ends [mm] of the bed of the last stone, as measured."""
    with open(HERE / "survey.csv", newline="", encoding="utf-8") as file:
        corners = {}
        for row in csv.DictReader(file):
            corners.setdefault(row["stone"], []).append((float(row["x"]), float(row["y"])))
    near = [p for stone in corners.values() for p in stone]
    own = corners["5d"][:2]

    def mean(at):
        members = [p for p in near if math.dist(p, at) < 20]
        return [sum(c) / len(members) for c in zip(*members)]
    return [mean(p) for p in own]


class Survey(program.SceneTest):
    def test_a_survey_is_computed_as_it_comes(self):
        (x0, y0), (x1, y1) = bed()
        hand = math.tan(math.atan(0.6) + math.atan2(y1 - y0, x1 - x0))
        shutil.copy(HERE / "survey.xml", self.folder / "survey.xml")
        for kind in ("csv", "dxf", "svg"):
            shutil.copy(HERE / f"survey.{kind}", self.folder)
            run = self.run_scene(self.folder / "survey.xml", "--limit-analysis", "--set", f"mesh/stones/file=survey.{kind}", out=kind)
            self.assertEqual(run.code, 0, run.said)
            self.assertLess(abs(run.result["collapse"]["certified_upper"] / hand - 1), 0.01, (kind, hand))
            self.assertIn("moved by up to 0.00673 m", run.words)
            self.assertIn("22 stones, 3.62551 m2", run.words)
            self.assertTrue((run.folder / "drawing.svg").exists())
            self.assertLess(self.largest_at_the_limit(run.folder), run.result["rigid"]["reactions"]["ground"]["most_y_N"])

    def largest_at_the_limit(self, folder):
        """[N] of a joint's points: stones of the lowest course are held, and press on each other no more than they must."""
        with h5py.File(folder / "fields.h5", "r") as file:
            step = next(step for step in file["steps"].values() if step.attrs["stage"].decode().endswith(": limit"))
            return float(abs(step["joint_normal_force_N"][()]).max())


if __name__ == "__main__":
    program.main()

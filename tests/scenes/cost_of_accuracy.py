"""What accuracy costs, on a small wall: the table of the study, what must be ordered in it, and its picture.

    cost_of_accuracy.py PROGRAM

The wall is W(6): 39 blocks, 279 contact points, own weight and then 0.15 g sideways.
"""

import csv
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path("cost_of_accuracy").resolve()
PROGRAM = None
THRESHOLDS = (0.3, 0.03, 0.003)
COLUMNS = ("sweep,mode,threshold,element_size_m,blocks,unknowns,candidate_points,selected_points,error_energy,"
           "error_displacement,estimate,effectivity,seconds,linear_solves,krylov_iterations,outcome,last_estimate,"
           "largest_displacement_m,energy_J").split(",")
# Friction remembers the path: two right solutions of this wall may differ by this much in energy norm.
PATH = 1e-3


def study(out, *options):
    return subprocess.run([PROGRAM, f"--xml={ROOT / 'xml/wall.xml'}", f"--out={out}", "--set", "mesh/wall/courses=6",
                           "--set", "mesh/wall/blocks per course=6",
                           "--set", "selection/largest share=1", *options], capture_output=True, text=True, check=False)


class Study(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        done = study(FOLDER, "--thresholds=" + ",".join(map(str, THRESHOLDS)), "--sizes=1,0.5")
        assert done.returncode == 0, done.stderr
        with open(FOLDER / "accuracy.csv", newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file)
            cls.columns = reader.fieldnames
            cls.rows = list(reader)
        cls.selection = [row for row in cls.rows if row["sweep"] == "selection"]
        cls.sizes = [row for row in cls.rows if row["sweep"] == "element size"]
        cls.adaptive = [row for row in cls.selection if row["mode"] == "adaptive"]

    def test_the_table_has_the_columns_that_are_documented(self):
        self.assertEqual(self.columns, COLUMNS)

    def test_every_run_is_there_and_solved(self):
        self.assertEqual([row["mode"] for row in self.selection], ["all"] + ["adaptive"] * len(THRESHOLDS) + ["bonded"])
        self.assertEqual([float(row["threshold"]) for row in self.adaptive], list(THRESHOLDS))
        self.assertEqual(len(self.sizes), 2)
        self.assertEqual({row["outcome"] for row in self.rows}, {"equilibrium"})

    def test_the_error_falls_with_the_threshold_and_the_selection_grows(self):
        errors = [float(row["error_energy"]) for row in self.adaptive]
        for coarse, fine in zip(errors, errors[1:]):
            self.assertLessEqual(fine, coarse + PATH)
        self.assertLess(errors[-1], errors[0] / 10)  # a hundredth of the threshold must buy a digit
        selected = [int(row["selected_points"]) for row in self.adaptive]
        self.assertEqual(selected, sorted(selected))
        self.assertEqual(self.selection[0]["selected_points"], self.selection[0]["candidate_points"])
        self.assertEqual(self.selection[-1]["selected_points"], "0")

    def test_truth_has_no_error_and_bonded_has_the_largest(self):
        truth, bonded = self.selection[0], self.selection[-1]
        self.assertEqual((float(truth["error_energy"]), float(truth["error_displacement"])), (0, 0))
        for row in self.adaptive:
            self.assertLessEqual(float(row["error_energy"]), float(bonded["error_energy"]) + PATH)

    def test_the_estimate_stops_the_run_and_is_near_the_truth(self):
        for row in self.adaptive:
            self.assertLessEqual(float(row["estimate"]), float(row["threshold"]))
            # What users are promised of an estimate: between half the error and five times it.
            self.assertGreater(float(row["effectivity"]), 0.5)
            self.assertLess(float(row["effectivity"]), 5)
            self.assertAlmostEqual(float(row["effectivity"]), float(row["estimate"]) / float(row["error_energy"]), places=6)

    def test_finer_cells_have_more_unknowns_and_the_finest_is_the_truth(self):
        coarse, fine = self.sizes
        self.assertAlmostEqual(float(fine["element_size_m"]), float(coarse["element_size_m"]) / 2)
        self.assertGreater(int(fine["unknowns"]), 2 * int(coarse["unknowns"]))
        self.assertEqual(float(fine["error_energy"]), 0)
        self.assertGreater(float(coarse["error_energy"]), 0)
        # Finer displacement elements are softer under given loads.
        self.assertGreater(float(fine["energy_J"]), float(coarse["energy_J"]))

    def test_the_picture_is_drawn(self):
        content = (FOLDER / "accuracy.png").read_bytes()
        self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(content[-8:-4], b"IEND")
        self.assertGreater(int.from_bytes(content[16:20], "big"), 500)  # pixels
        self.assertIn("</svg>", (FOLDER / "accuracy.svg").read_text(encoding="utf-8"))


class Command(unittest.TestCase):
    def test_wrong_options_are_refused_with_advice(self):
        for option, words in (("--thresholds=2", "must be numbers above 0 and below 1"), ("--sizes=0", "above 0"),
                              ("--thresholds=nan", "must be numbers"), ("--unknown=1", "is no option")):
            done = study(FOLDER / "refused", option)
            self.assertEqual(done.returncode, 2, option)
            self.assertIn(words, done.stderr)
        self.assertFalse((FOLDER / "refused").exists())

    def test_a_study_needs_no_picture(self):
        out = FOLDER / "without"
        done = study(out, "--thresholds=0.3", "--sizes=none", "--draw=none")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((out / "accuracy.csv").exists())
        self.assertFalse((out / "accuracy.png").exists())


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()

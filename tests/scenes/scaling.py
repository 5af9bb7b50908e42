"""What a structure costs beside a continuum, on small walls and arches: the tables of the study, and its picture.

    scaling.py PROGRAM
"""

import csv
import json
import pathlib
import subprocess
import sys
import unittest

FOLDER = pathlib.Path("scaling").resolve()
PROGRAM = None


def study(out, *options):
    return subprocess.run([PROGRAM, f"--out={out}", *options], capture_output=True, text=True, check=False)


class Study(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        done = study(FOLDER, "--families=walls,arches", "--largest=16", "--modes=bonded,adaptive,all")
        assert done.returncode == 0, done.stderr
        with open(FOLDER / "scaling.csv", newline="", encoding="utf-8") as file:
            cls.rows = list(csv.DictReader(file))
        cls.json = json.loads((FOLDER / "scaling.json").read_text(encoding="utf-8"))

    def runs(self, family, mode):
        return [row for row in self.rows if row["family"] == family and row["mode"] == mode]

    def test_every_run_is_there_and_solved(self):
        self.assertEqual([(row["family"], float(row["size"]), row["mode"], int(row["step"])) for row in self.rows],
                         [(family, size, mode, step) for family, size in (("walls", 16), ("arches", 15), ("arches", 31))
                          for mode in ("bonded", "adaptive", "all") for step in (1, 2)])
        self.assertEqual({row["outcome"] for row in self.rows}, {"equilibrium"})

    def test_both_tables_say_the_same(self):
        self.assertEqual(len(self.json), len(self.rows))
        for row, entry in zip(self.rows, self.json):
            self.assertEqual(list(row), list(entry))
            for name, value in entry.items():
                if isinstance(value, str):
                    self.assertEqual(row[name], value)
                else:
                    self.assertAlmostEqual(float(row[name]), value, delta=1e-6 * abs(value))

    def test_a_bonded_wall_is_a_continuum(self):
        for row in self.runs("walls", "bonded"):
            # The same system; the first step takes one solve, the estimate a second one that is not bonded.
            self.assertEqual(row["unknowns"], row["continuum_unknowns"])
            self.assertEqual(row["selected_points"], "0")

    def test_all_selects_all_and_adaptive_what_it_needs(self):
        for family in ("walls", "arches"):
            for row in self.runs(family, "all"):
                self.assertEqual(row["selected_points"], row["candidate_points"])
        weight = self.runs("walls", "adaptive")[0]
        self.assertLess(int(weight["selected_points"]), int(weight["candidate_points"]) / 2)
        self.assertLessEqual(float(weight["estimate"]), 0.01)

    def test_ratios_are_those_of_their_columns(self):
        for row in self.rows:
            self.assertGreater(float(row["continuum_s"]), 0)
            self.assertAlmostEqual(float(row["in_continua"]) * float(row["continuum_s"]) / float(row["seconds"]), 1, places=4)
            krylov = float(row["krylov_iterations"])
            self.assertAlmostEqual(float(row["krylov_in_continua"]) * float(row["continuum_krylov"]), krylov, places=4)
            self.assertAlmostEqual(float(row["mean_krylov"]) * float(row["linear_solves"]), krylov, delta=1e-4 * krylov + 1e-9)

    def test_memory_and_factorisations_are_counted(self):
        for row in self.runs("walls", "all"):
            # No more than one a solve; both numbers are those of solves with contact.
            self.assertLessEqual(int(row["factorised"]) + int(row["reused"]), int(row["linear_solves"]))
            self.assertGreater(int(row["factorised"]), 0)
            self.assertLessEqual(int(row["factored_whole"]), int(row["linear_solves"]))
            self.assertEqual(float(row["whole_bytes_per_unknown"]) > 0, int(row["factored_whole"]) > 0)
            for part in ("matrix", "block", "motion"):
                self.assertGreater(float(row[f"{part}_bytes_per_unknown"]), 8)  # at least a number each
            self.assertGreater(float(row["stiffness_bytes_per_unknown"]), 0)  # of shapes, however many blocks have them

    def test_the_picture_is_drawn(self):
        content = (FOLDER / "scaling.png").read_bytes()
        self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(content[-8:-4], b"IEND")
        self.assertGreater(int.from_bytes(content[16:20], "big"), 500)  # pixels
        self.assertIn("</svg>", (FOLDER / "scaling.svg").read_text(encoding="utf-8"))


class Systems(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        done = study(FOLDER / "systems", "--systems=open", "--largest=10")
        assert done.returncode == 0, done.stderr
        cls.rows = json.loads((FOLDER / "systems/systems.json").read_text(encoding="utf-8"))

    def contrast(self, *options):
        """Levels of multigrid and iterations of a wall of 32 courses, stones alike first, then up to 1e6 times as stiff."""
        folder = FOLDER / f"contrast-{len(options)}"
        done = study(folder, "--systems=contrast", "--largest=32", *options)
        assert done.returncode == 0, done.stderr
        rows = json.loads((folder / "systems.json").read_text(encoding="utf-8"))
        self.assertEqual([row["contrast"] for row in rows], [1, 1e2, 1e4, 1e6])
        return [len(row["level_rows"].split()) for row in rows], [row["iterations"] for row in rows]

    def test_iterations_do_not_see_how_stiff_stones_are(self):
        levels, iterations = self.contrast()
        self.assertGreater(levels[0], 1)
        self.assertEqual(levels[1:], [0, 0, 0])  # the continuum is factored
        self.assertLessEqual(max(iterations), 16)  # multigrid alone would take 28 to 41 where stones differ

    def test_a_scene_that_has_wishes_for_multigrid_gets_one(self):
        levels, _ = self.contrast("--set", "solver/MueLu/coarse: max size=1000")
        self.assertGreater(min(levels), 1)

    def test_iterations_stay_bounded_with_open_joints(self):
        shares = {row["open"]: row["iterations"] for row in self.rows if row["family"] == "open"}
        self.assertEqual(sorted(shares), [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
        self.assertLessEqual(max(shares.values()), 44)  # 36, and a fifth more

    def test_one_rank_sends_nothing(self):
        for row in self.rows:
            self.assertEqual(sum(value for name, value in row.items() if name.endswith(("messages", "collectives"))), 0)
            self.assertEqual((row["edge_cut"], row["unknowns_imbalance"], row["neighbours"]), (0, 1, 0))


class Motions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        done = study(FOLDER / "motions", "--families=walls", "--largest=16", "--motions=0.01,0.5")
        assert done.returncode == 0, done.stderr
        rows = json.loads((FOLDER / "motions/motions.json").read_text(encoding="utf-8"))
        cls.rows = {(row["peak_m_s2"], row["mode"]): row for row in rows}

    def test_every_run_is_there_and_done(self):
        self.assertEqual(set(self.rows), {(peak, mode) for peak in (0.01, 0.5) for mode in ("bonded", "adaptive")})
        self.assertEqual({(row["outcome"], row["steps"]) for row in self.rows.values()}, {("done", 80)})

    def test_what_is_not_stirred_costs_what_a_bonded_wall_costs(self):
        still, bonded = self.rows[0.01, "adaptive"], self.rows[0.01, "bonded"]
        self.assertEqual((still["selected_points"], still["changed_points"]), (0, 0))
        self.assertLessEqual(still["solves_per_step"], 1.05 * bonded["solves_per_step"])
        self.assertLessEqual(still["krylov_per_step"], 1.05 * bonded["krylov_per_step"])

    def test_what_is_stirred_is_selected_and_costs_solves(self):
        stirred = self.rows[0.5, "adaptive"]
        self.assertGreater(stirred["changed_points"], 50)
        self.assertGreater(stirred["selected_points"], stirred["changed_points"])
        self.assertLessEqual(stirred["solves_per_step"], 6.4)  # 5.3, and a fifth more
        self.assertLessEqual(stirred["krylov_in_bonded"], 4)  # 3.35, and a fifth more
        self.assertLessEqual(stirred["estimate"], 0.005)  # half of the error tolerance

    def test_bonded_steps_are_the_measure(self):
        for peak in (0.01, 0.5):
            row, bonded = self.rows[peak, "adaptive"], self.rows[peak, "bonded"]
            self.assertEqual((bonded["in_bonded"], bonded["krylov_in_bonded"], bonded["selected_points"]), (1, 1, 0))
            self.assertAlmostEqual(row["in_bonded"] * bonded["seconds_per_step"] / row["seconds_per_step"], 1, places=9)


class Peers(unittest.TestCase):
    def test_whoever_is_installed_finds_the_same_displacement(self):
        done = study(FOLDER / "peers", "--peers=W4")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(FOLDER / "peers/peers.csv", newline="", encoding="utf-8") as file:
            rows = {row["program"]: row for row in csv.DictReader(file)}
        for name, accuracy in (("Voussoir, all points", 1e-12), ("Voussoir, adaptive", 1e-2), ("GetFEM", 1e-4),
                               ("CalculiX", 5e-2)):  # GetFEM lacks redundant pairs, CalculiX has penalty joints
            if name not in rows:
                self.assertIn(f"{name} is not installed", done.stdout)
                continue
            self.assertEqual(rows[name]["outcome"], "")
            self.assertLessEqual(float(rows[name]["off"]), accuracy, name)


class Command(unittest.TestCase):
    def test_wrong_options_are_refused_with_advice(self):
        for option, words in (("--families=domes", "must be words between commas"), ("--largest=0", "must be a whole number > 0"),
                              ("--modes=some", "must be words"), ("--motions=0.1,fast", "must be numbers above 0"),
                              ("--motions=0", "must be numbers above 0"), ("--unknown=1", "is no option")):
            done = study(FOLDER / "refused", option)
            self.assertEqual(done.returncode, 2, option)
            self.assertIn(words, done.stderr)
        done = study(FOLDER / "refused", "--families=arches", "--motions=1")
        self.assertEqual((done.returncode, "moves walls and bridge" in done.stderr), (2, True))
        self.assertFalse((FOLDER / "refused").exists())


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()

"""drivers/scaling: its table says what the runs counted, its picture what the table says; wrong words are refused in words.

    scaling_command.py PROGRAM MPIEXEC
"""

import csv
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as tree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = [sys.executable, "-B", str(ROOT / "drivers" / "scaling")]
PARTS = ("krylov", "block_motions", "transfer", "continuum")
SVG = "{http://www.w3.org/2000/svg}"
# Plays srun: --mpi=... --exact --ntasks N PROGRAM ...
SRUN = """#!/bin/bash
echo "$1 $2 $3 $4" >> "$OUT/../calls"
shift 3
exec MPIEXEC --oversubscribe -np "$@"
"""


class Study(program.SceneTest):
    def study(self, *options, out="study", command=(), **more):
        environment = {**os.environ, **program.ENVIRONMENT, "VOUSSOIR_PROGRAM": str(pathlib.Path(program.PROGRAM).resolve()), **more}
        return subprocess.run([*(command or COMMAND), *options, *([] if command else ["--out", str(self.folder / out)])],
                              capture_output=True, text=True, check=False, env=environment, cwd=ROOT)

    def rows(self, out="study"):
        with open(self.folder / out / "ranks.csv", newline="", encoding="utf-8") as file:
            return [{name: program.number(value) for name, value in row.items()} for row in csv.DictReader(file)]

    def done(self, *options, **more):
        done = self.study(*options, **more)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def counted(self, ranks, courses):
        """What the program itself counts of the same wall."""
        folder = self.folder / f"by-hand-{ranks}"
        scaling = pathlib.Path(program.PROGRAM).resolve().parent / "scaling"
        several = [program.MPIEXEC, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        subprocess.run([*several, scaling, "--systems=blocks", f"--smallest={courses}", f"--largest={courses}", f"--out={folder}"],
                       check=True, capture_output=True, env={**os.environ, **program.ENVIRONMENT})
        return json.loads((folder / "systems.json").read_text(encoding="utf-8"))[0]

    def drawn(self, name, out="study"):
        """Heights of the points of a curve, upwards, in the order of ranks."""
        picture = tree.parse(self.folder / out / "ranks.svg").getroot()
        group = next(g for g in picture.iter(f"{SVG}g") if g.get("id") == name)
        path = next(group.iter(f"{SVG}path")).get("d")
        return [-float(y) for y in re.findall(r"[ML] \S+ (\S+)", path)]


class Walls(Study):
    def test_the_table_says_what_runs_counted_and_the_picture_what_the_table_says(self):
        said = self.done("--ranks=1,2", "--strong", "--blocks=256")
        alone, two = self.rows()
        self.assertEqual([(row["kind"], row["ranks"], row["blocks"]) for row in (alone, two)], [("strong", 1, 264), ("strong", 2, 264)])
        for row, ranks in ((alone, 1), (two, 2)):
            by_hand = self.counted(ranks, 16)
            for ours, its in (("iterations", "iterations"), ("unknowns", "unknowns"), ("points", "candidate_points"),
                              ("unknowns_imbalance", "unknowns_imbalance"), ("points_imbalance", "points_imbalance")):
                self.assertAlmostEqual(row[ours], by_hand[its], delta=1e-5 * by_hand[its], msg=ours)
            iterations = by_hand["iterations"] + 1  # what goes before the first counts as another
            for ours, its, unit in (("messages", "messages", 1), ("kB", "bytes", 1e3), ("sums", "collectives", 1)):
                total = sum(by_hand[f"{part}_total_{its}"] for part in PARTS) / unit / iterations
                self.assertAlmostEqual(row[ours], total, delta=1e-5 * total, msg=ours)
            for name in ("clock_s", "processor_s", "work_s", "memory_MB"):
                self.assertGreater(row[name], 0, name)
            self.assertGreaterEqual(row["seconds_imbalance"], 1)
        self.assertEqual((alone["efficiency"], alone["work_efficiency"], alone["memory_over_share"]), (1, 1, 1))
        self.assertAlmostEqual(two["efficiency"], alone["clock_s"] / two["clock_s"] / 2, delta=1e-4)
        self.assertAlmostEqual(two["work_efficiency"], alone["work_s"] / two["work_s"] / 2, delta=1e-4)
        self.assertAlmostEqual(two["memory_over_share"], 2 * two["memory_MB"] / alone["memory_MB"], delta=1e-4)
        # Messages are predicted without a fit; what the model is worth is the matter of performance.rank_model.
        self.assertAlmostEqual(two["predicted_messages"] / two["messages"], 1, delta=0.06)
        for row in (alone, two):
            self.assertGreater(row["predicted_efficiency"], 0.1)
        self.assertIn("ranks.csv", said)
        self.check_picture(alone, two)

    def check_picture(self, alone, two):
        ideal = self.drawn("strong-ideal")[0]
        columns = ("efficiency", "work_efficiency", "predicted_efficiency")
        heights = {name: self.drawn(f"strong-{name}") for name in columns}
        for name in columns:
            self.assertEqual(len(heights[name]), 2, name)
            self.assertAlmostEqual(heights[name][0], ideal, delta=1e-3, msg=name)  # one rank is what others are compared with
        # The axis is linear: what is missing to the ideal is drawn as long as it is.
        scale = (ideal - heights["predicted_efficiency"][1]) / (1 - two["predicted_efficiency"])
        for name in columns:
            self.assertAlmostEqual(ideal - heights[name][1], scale * (1 - two[name]), delta=0.01 * abs(scale), msg=name)
        content = (self.folder / "study/ranks.png").read_bytes()
        self.assertEqual((content[:8], content[-8:-4]), (b"\x89PNG\r\n\x1a\n", b"IEND"))

    def test_what_is_there_is_not_run_again_and_other_runs_do_not_come_beside(self):
        self.done("--ranks=1", "--blocks=100", "--strong")
        first = self.rows()
        self.assertTrue(first[0]["predicted_efficiency"] != first[0]["predicted_efficiency"])  # nothing to fit a model to
        said = self.done("--ranks=1,2", "--blocks=100", "--strong")
        self.assertNotIn("1 rank ...", said)
        self.assertIn("2 ranks ...", said)
        self.assertEqual(self.rows()[0]["clock_s"], first[0]["clock_s"])
        other = self.study("--ranks=1", "--blocks=200", "--strong")
        self.assertEqual(other.returncode, 2)
        self.assertIn("holds runs with another blocks (strong)", other.stderr)
        self.done("--ranks=1", "--blocks=200", "--strong", "--overwrite")
        self.assertEqual([(row["ranks"], row["blocks"]) for row in self.rows()], [(1, 203)])

    def test_weak_scaling_in_space_brings_blocks_with_every_rank(self):
        self.done("--ranks=1,2", "--weak", "--scene=xml/wall-in-space.xml", "--blocks-per-rank=144", "--repeat=2")
        alone, two = self.rows()
        self.assertEqual((alone["kind"], alone["ranks"], two["ranks"]), ("weak", 1, 2))
        self.assertAlmostEqual(two["blocks"] / alone["blocks"], 2, delta=0.1)  # 12 and 17 courses, and the ground
        self.assertEqual(alone["unknowns"] / alone["blocks"] > 30, True)  # 12 nodes of 3 components
        rate = two["blocks"] / two["clock_s"] / 2 / (alone["blocks"] / alone["clock_s"])
        self.assertAlmostEqual(two["efficiency"], rate, delta=1e-4)
        self.assertTrue((self.folder / "study/runs/weak-2-1/systems.json").exists())
        self.assertLessEqual(abs(two["iterations"] - alone["iterations"]), 3)

    def test_a_scene_that_is_no_wall_is_taken_as_it_stands(self):
        self.done("--ranks=1,2", "--scene=xml/arch.xml")
        self.assertEqual([(row["kind"], row["ranks"]) for row in self.rows()], [("strong", 1), ("strong", 2)])
        self.assertEqual(len({(row["blocks"], row["points"]) for row in self.rows()}), 1)


class Batch(Study):
    def test_tasks_of_an_array_bring_their_ranks_to_one_table(self):
        srun = self.folder / "srun"
        srun.write_text(SRUN.replace("MPIEXEC", program.MPIEXEC), encoding="utf-8")
        srun.chmod(0o755)
        more = {"PATH": f"{self.folder}:{os.environ['PATH']}", "PROGRAM": str(pathlib.Path(program.PROGRAM).resolve()),
                "OUT": str(self.folder / "study"), "OPTIONS": "--weak --blocks-per-rank=64"}
        for task in ("1", "0"):
            done = self.study(command=["bash", str(ROOT / "drivers/slurm/scaling.sbatch")], SLURM_ARRAY_TASK_ID=task, **more)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            if task == "1":
                self.assertIn("run 1 rank into the same folder", done.stdout)
        self.assertEqual([(row["kind"], row["ranks"], row["efficiency"] > 0) for row in self.rows()],
                         [("weak", 1, True), ("weak", 2, True)])
        calls = (self.folder / "calls").read_text(encoding="utf-8").splitlines()
        self.assertEqual(calls, ["--mpi=pmix --exact --ntasks 2", "--mpi=pmix --exact --ntasks 1"])


class Refused(Study):
    def test_wrong_words_are_refused_before_anything_is_built_or_run(self):
        for options, words in ((["--ranks=0"], "--ranks = 0\n  must be a whole number, 1 or more."),
                               (["--ranks=1,two"], "--ranks = two"), (["--ranks=2,2"], "names a number twice"),
                               (["--ranks="], "must be a whole number"), (["--blocks=10"], "--blocks = 10\n  must be a whole number, 64"),
                               (["--strong", "--weak"], "leave both out to have both"),
                               (["--weak", "--blocks=100"], "--blocks\n  is of the other kind"),
                               (["--latency=0"], "--latency = 0\n  must be a number above 0"), (["--bandwidth=nan"], "above 0"),
                               (["--repeat=0"], "--repeat = 0"), (["--set=5"], "must be PATH=VALUE"), (["--hepl"], "--hepl"),
                               (["--scene=no.xml"], "scene = no.xml\n  is not a file"),
                               (["--scene=xml/arch.xml", "--weak"], "no wall that a\n  generator makes. Ask for --strong"),
                               (["--scene=xml/arch.xml", "--blocks=100"], "--blocks\n  wants a structure that can be made larger"),
                               (["--scene=drivers/ranks.md"], "is no XML")):
            refused = self.study(*options, out="refused", VOUSSOIR_PROGRAM="nothing")
            self.assertEqual(refused.returncode, 2, f"{options}: {refused.stdout}{refused.stderr}")
            self.assertIn(words, refused.stderr)
            self.assertFalse((self.folder / "refused").exists(), options)

    def test_what_the_program_refuses_is_told_in_its_words(self):
        refused = self.study("--ranks=1", "--set", "joints/dry/friction coefficient=-1")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("friction coefficient", refused.stderr)

    def test_what_cannot_be_started_is_named(self):
        refused = self.study("--ranks=2", "--launch=no-such-launcher -n")
        self.assertEqual(refused.returncode, 4)
        self.assertIn("no-such-launcher\n  cannot be started", refused.stderr)

    def test_options_of_the_program_are_handed_to_it(self):
        done = self.study(command=[*COMMAND, "--systems=blocks", "--largest=8", "--out", str(self.folder / "systems")])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "systems/systems.csv").exists())
        refused = self.study("--systems=scene")
        self.assertEqual((refused.returncode, "name it in --scene" in refused.stderr), (2, True))
        refused = self.study("--systems=blocks", f"--scene={ROOT / 'xml/arch.xml'}")
        self.assertEqual((refused.returncode, "--systems=scene takes it as it stands" in refused.stderr), (2, True))
        refused = self.study("--families=walls", f"--scene={ROOT / 'xml/arch.xml'}")
        self.assertEqual((refused.returncode, "neither is asked for" in refused.stderr), (2, True))
        self.assertFalse((self.folder / "study").exists())

    def test_help_names_every_option(self):
        said = self.study(command=[*COMMAND, "--help"]).stdout
        for option in ("--ranks", "--strong", "--weak", "--scene", "--blocks-per-rank", "--launch", "--overwrite"):
            self.assertIn(option, said)


if __name__ == "__main__":
    program.main()

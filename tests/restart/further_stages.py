"""Runs that have come to their end go on with further stages, and others begin where they stand.

    further_stages.py PROGRAM MPIEXEC

A wall of five courses under its own weight is pushed, then pushed back, loaded, cut or searched for its load factor; a
block slides on in time.
"""

import json
import shutil
import subprocess
import sys
import unittest

import runs
from runs import Program, differences, empty, history, largest_difference, result, tables

PROGRAM = None
INPUT, RESOURCE = 2, 4
PUSH = (("own weight", 1, {"weight": 1}), ("push", 2, {"push": 1}))
BACK = PUSH + (("back", 2, {"push": -1}),)
PRESS = PUSH + (("press", 1, {"press": 1}),)


def parameter(name, kind, value):
    return f'<Parameter name="{name}" type="{kind}" value="{value}"/>'


def section(name, *content):
    return f'<ParameterList name="{name}">{"".join(content)}</ParameterList>'


def stage(name, increments, loads):
    return section(name, parameter("increments", "int", increments),
                   section("loads", *(parameter(*load) for load in ((k, "double", v) for k, v in loads.items()))))


def scene(stages, *more):
    return section(
        "built", section("mesh", parameter("type", "string", "wall"),
                         section("wall", parameter("courses", "int", 5), parameter("blocks per course", "int", 5))),
        section("materials", section("stone")),
        section("joints", section("dry", parameter("friction coefficient", "double", 0.6))),
        section("supports", section("ground", parameter("on", "string", "base"))),
        section("loads", section("weight", parameter("type", "string", "self weight")),
                section("push", parameter("type", "string", "acceleration"), parameter("ax", "double", 1.9)),
                section("press", parameter("type", "string", "traction"), parameter("on", "string", "top"),
                        parameter("pressure", "double", 2e4))),
        section("steps", section("stages", *(stage(*s) for s in stages))), *more)


def search(load):
    return section("load factor", section("pattern", parameter(load, "double", 1)),
                   parameter("accuracy", "double", 0.1))


def cut(when):
    return section("construction", section("top", parameter("blocks", "string", "course 4"),
                                           parameter("disappears", "string", when)))


class FurtherStages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = empty("further")
        cls.folder.mkdir(parents=True)
        cls.first = cls.folder / "first"
        done = cls.compute(cls.first, scene(PUSH))
        assert done.returncode == 0, done.stdout + done.stderr

    @classmethod
    def compute(cls, out, text, *options, ranks=1, settings=()):
        """Runs a scene written as its own file, so that names of files differ as users' do."""
        cls.number = getattr(cls, "number", 0) + 1
        runs.SCENE = cls.folder / f"scene{cls.number}.xml"
        runs.SCENE.write_text(text)
        return PROGRAM.run(out, *options, ranks=ranks, settings=list(settings))

    def copy(self, name):
        return shutil.copytree(self.first, empty(self.folder / name))

    def snapshot(self, folder):
        return {p.name: p.read_bytes() for p in folder.iterdir()}

    def expect(self, out, text, *options, **how):
        done = self.compute(out, text, *options, **how)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def whole(self, name, text):
        self.expect(self.folder / name, text)
        return self.folder / name

    def test_a_further_stage_alone_is_computed_and_ends_as_all_in_one_run(self):
        out, whole = self.copy("on"), self.whole("whole", scene(BACK))
        done = self.expect(out, scene(BACK), "--restart")
        self.assertIn("Going on after step 3, stage 'back'", done.stdout)
        self.assertNotIn("own weight", done.stdout.split("Going on")[1])
        self.assertEqual(differences(out, whole), [])
        self.assertGreater(float(history(out)[-1]["friction_J"]), 0)

    def test_two_variants_begin_where_one_run_stands_and_leave_it_alone(self):
        before = self.snapshot(self.first)
        for name, stages in (("back", BACK), ("press", PRESS)):
            out = self.folder / f"branch-{name}"
            self.expect(out, scene(stages), f"--restart-from={self.first}")
            self.assertEqual(differences(out, self.whole(f"whole-{name}", scene(stages))), [])
            self.assertEqual(self.snapshot(self.first), before)
        # What a variant finds in its folder is kept beside, as of any new run.
        done = self.expect(out, scene(BACK), "--restart-from", str(self.first))
        self.assertIn(f"kept in {out}.1", done.stdout)
        self.assertEqual(len(history(out.with_name(out.name + ".1"))), 4)
        self.assertEqual(len(history(out)), 5)

    def test_a_variant_of_a_variant_and_other_ranks(self):
        out, on = self.folder / "second", self.folder / "third"
        self.expect(out, scene(BACK), f"--restart-from={self.first}", ranks=2)
        longer = BACK + (("press", 1, {"press": 0.5}),)
        self.expect(on, scene(longer), f"--restart-from={out}")
        # Newton stops at 1e-8 of the forces; displacements of loose stones are known to a hundred times that.
        self.assertLess(largest_difference(on, self.whole("whole-longer", scene(longer)), "displacement"), 1e-6)

    def test_nothing_left_to_compute_is_said_and_nothing_is_touched(self):
        before = self.snapshot(self.first)
        done = self.expect(self.first, scene(PUSH), "--restart")
        self.assertIn("Nothing is left to compute", done.stdout)
        self.assertEqual(self.snapshot(self.first), before)

    def test_a_run_killed_before_its_result_was_written_still_gets_it(self):
        out = self.copy("no-result")
        (out / "result.json").unlink()
        (out / "joints.csv").unlink()
        self.expect(out, scene(PUSH), "--restart")
        self.assertEqual(differences(out, self.first), [])
        self.assertEqual((out / "joints.csv").read_bytes(), (self.first / "joints.csv").read_bytes())

    def test_a_fresh_run_takes_a_finished_one_for_no_interrupted_one(self):
        out = self.copy("fresh")
        before = self.snapshot(out)
        done = self.expect(out, scene(PUSH))
        self.assertIn(f"kept in {out}.1", done.stdout)
        self.assertEqual(self.snapshot(out.with_name("fresh.1")), before)

    def test_stages_that_have_passed_must_be_as_they_were(self):
        out = self.copy("past")
        before = self.snapshot(out)
        harder = (PUSH[0], ("push", 2, {"push": 1.2})) + BACK[2:]
        renamed = (PUSH[0], ("shove", 2, {"push": 1})) + BACK[2:]
        for stages, more in ((harder, []), (renamed, []), (PUSH[:1], []), (BACK, [cut("push")])):
            for option, where in (("--restart", out), (f"--restart-from={out}", self.folder / "past-branch")):
                done = self.compute(where, scene(stages, *more), option)
                self.assertEqual(done.returncode, INPUT, done.stdout)
                self.assertIn("checkpoint.h5", done.stderr)
                self.assertEqual(self.snapshot(out), before)
        # How finely a stage was stepped through is no part of where it ended.
        finer = (PUSH[0], ("push", 7, {"push": 1})) + BACK[2:]
        self.expect(self.folder / "finer", scene(finer), f"--restart-from={out}")

    def test_blocks_may_go_in_a_stage_that_follows(self):
        out = self.folder / "cut"
        self.expect(out, scene(BACK, cut("back")), f"--restart-from={self.first}")
        whole = self.whole("whole-cut", scene(BACK, cut("back")))
        # Construction takes what solvers leave off closed gaps at every step, 1e-15 m here: no other bits decide.
        mine, theirs = (float(history(f)[-1]["largest_displacement_m"]) for f in (out, whole))
        self.assertLess(abs(mine - theirs), 1e-8 * theirs)

    def test_searches_for_load_factors_begin_at_the_end_of_one_run(self):
        for load in ("push", "press"):
            out, text = self.folder / f"search-{load}", scene(PUSH, search(load))
            settings = ["load factor/largest factor=1"]
            self.expect(out, text, f"--restart-from={self.first}", settings=settings)
            whole = empty(self.folder / f"whole-search-{load}")
            self.expect(whole, text, settings=settings)
            self.assertEqual(differences(out, whole), [])
        # A search goes on to a larger factor, but neither with another pattern nor with a stage before it.
        on = self.folder / "search-on"
        self.expect(on, text, f"--restart-from={out}", settings=["load factor/largest factor=2"])
        self.assertEqual(result(on)["collapse"]["lower"], 2)
        for other in (scene(PUSH, search("push")), scene(BACK, search("press"))):
            done = self.compute(self.folder / "search-other", other, f"--restart-from={out}")
            self.assertEqual(done.returncode, INPUT)
            self.assertIn("--restart-from", done.stderr)

    def test_a_collapse_that_was_found_is_sought_more_exactly(self):
        out, text = self.folder / "collapse", scene(PUSH[:1], search("push"))
        self.expect(out, text)
        found = result(out)["collapse"]
        self.assertEqual(result(out)["outcome"], "collapse")
        done = self.expect(out, text, "--restart")
        self.assertIn("Nothing is left to compute", done.stdout)
        before = len([name for name in tables(out) if name.endswith("displacement")])
        self.expect(out, text, "--restart", settings=["load factor/accuracy=0.02"])
        finer = result(out)["collapse"]
        self.assertEqual(finer["attempts"][:len(found["attempts"])], found["attempts"])
        self.assertLessEqual(finer["upper"] - finer["lower"], 0.02 * finer["upper"])
        stood = sum(a["outcome"] == "equilibrium" for a in finer["attempts"])
        after = len([name for name in tables(out) if name.endswith("displacement")])
        self.assertEqual(after, 1 + stood + 1)  # weight, equilibria, and the mechanism once, not that of before
        self.assertGreaterEqual(after, before)

    def test_the_last_state_is_not_kept_where_nobody_wants_it(self):
        out = self.folder / "without"
        without = ["output/checkpoint at end=false", "output/checkpoint every=1"]
        self.expect(out, scene(PUSH), settings=without)
        self.assertFalse((out / "checkpoint.h5").exists())
        for option, where in (("--restart", out), (f"--restart-from={out}", self.folder / "without-branch")):
            done = self.compute(where, scene(BACK), option)
            self.assertEqual(done.returncode, RESOURCE)
        self.assertFalse((self.folder / "without-branch").exists())

    def test_what_cannot_be_meant_is_refused(self):
        before = self.snapshot(self.first)
        inside = self.folder / "holder" / "first"
        shutil.copytree(self.first, inside)
        for out, options, code in ((self.first, [f"--restart-from={self.first}"], RESOURCE),
                                   (inside.parent, [f"--restart-from={inside}"], RESOURCE),
                                   (self.folder / "x", [f"--restart-from={self.folder / 'nowhere'}"], RESOURCE),
                                   (self.folder / "x", ["--restart", f"--restart-from={self.first}"], INPUT)):
            done = self.compute(out, scene(BACK), *options)
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertEqual(self.snapshot(self.first), before)
        self.assertFalse((self.folder / "x").exists())

    def test_the_scene_of_the_folder_is_taken_when_none_is_given(self):
        out = self.folder / "same-scene"
        done = subprocess.run([PROGRAM.program, f"--restart-from={self.first}", f"--out={out}", "--quiet", "--set",
                               "steps/stages/push/increments=2"], check=False)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(differences(out, self.first), [])


class InTime(unittest.TestCase):
    def test_a_block_slides_on_in_a_further_stage(self):
        xml = (runs.ROOT / "xml" / "sliding-block.xml").read_text()
        xml = xml.replace("incline.geo", str(runs.ROOT / "meshes" / "incline.geo"))
        end = xml.index("</ParameterList>", xml.index('name="time step"')) + len("</ParameterList>")
        further = ('<ParameterList name="on"><Parameter name="duration" type="double" value="0.05"/>'
                   '<Parameter name="time step" type="double" value="2e-3"/></ParameterList>')
        folder = empty("further-in-time")
        folder.mkdir(parents=True)
        short = ["steps/stages/sliding/duration=0.05", "output/every=17"]
        for name, text in (("first", xml), ("more", xml[:end] + further + xml[end:])):
            (folder / f"{name}.xml").write_text(text)
        runs.SCENE = folder / "more.xml"
        self.assertEqual(PROGRAM.run(folder / "whole", settings=short).returncode, 0)
        self.assertEqual(PROGRAM.run(folder / "on", f"--xml={folder / 'first.xml'}", settings=short).returncode, 0)
        done = PROGRAM.run(folder / "on", "--restart", settings=short)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(differences(folder / "on", folder / "whole"), [])
        # 1 + 50 + 25 steps: fields are due at the end of the first part in both ways.
        self.assertEqual(json.loads((folder / "on" / "result.json").read_text())["time_s"], 0.1)


if __name__ == "__main__":
    PROGRAM = Program(*sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

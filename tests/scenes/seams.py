"""The seams of stages: what passes from load steps to time, to stones that come and go, to a load factor, over a restart.

Every cell of the table in src/dynamics/seams.md is right, refused or warned of; the tests below walk it row by row.
"""

import math
import pathlib
import sys

import h5py
import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402
import stones  # noqa: E402

SEAMS = pathlib.Path(__file__).resolve().parents[2] / "src" / "dynamics" / "seams.md"
KEEP = {"output": {"checkpoint at end": True}}
G = 9.81

# A stone on a bed.
BED = {"bed": stones.rectangle(0.0, -0.25, 2.0, 0.0), "block": stones.rectangle(0.0, 0.0, 2.0, 0.5)}
SLIDING = stones.geo(BED, 0.25, {"ground": ("bed", 0), "top": ("block", 2)})
# A lintel on two jambs, over a prop that has a support of its own.
LINTEL = {"left": stones.rectangle(0.0, -1.0, 0.4, 0.0), "right": stones.rectangle(2.0, -1.0, 2.4, 0.0),
          "prop": stones.rectangle(1.1, -1.0, 1.3, 0.0), "lintel": stones.rectangle(0.0, 0.0, 2.4, 0.4)}
PROPPED = stones.geo(LINTEL, 0.1, {"lg": ("left", 0), "rg": ("right", 0), "pg": ("prop", 0), "top": ("lintel", 2)})
PROPPED += 'Physical Surface("timber") = {3};\n'  # the prop once more, in another set
WEIGHT = 2000.0 * G * (2.4 * 0.4 + 2 * 0.4)  # N without the prop

OWN, STRIKE = stones.OWN_WEIGHT, {"loads": {"weight": 1.0}}
GOES = {"prop": {"blocks": "prop", "disappears": "strike"}}


def sliding(stages, friction=0.3, velocity=0.4, **sections):
    return stones.scene("stones.geo", ["ground"], sections.pop("loads", {}), stages, friction=friction,
                        initial_velocities={"push": {"blocks": "block", "vx": velocity}} if velocity else {},
                        observations={"m": {"place": "mean", "blocks": "block"}}, **sections)


def propped(stages, construction, loads=None, **sections):
    return stones.scene("stones.geo", ["lg", "rg", "pg"], loads or {}, stages, construction=construction, **sections)


def timed(duration, **keys):
    return {"duration": duration, "time step": 0.002, **keys}


class SeamTest(program.SceneTest):
    def done(self, scene, drawing, *options, outcome="equilibrium", warnings=(), out="out", ranks=1):
        run = self.run_scene(scene, *options, drawing=drawing, out=out, ranks=ranks)
        self.assertEqual(run.outcome, outcome, run.said)
        self.assertEqual(sorted(set(run.warnings)), sorted(warnings), run.said)
        return run

    def refused(self, scene, drawing, *words):
        run = self.run_scene(scene, "--validate", drawing=drawing)
        self.assertEqual(run.code, 2, run.said)
        for word in words:
            self.assertIn(word, run.words.replace('"', "'"))

    def in_two(self, stages, first, scene_of, drawing, **expected):
        """A run stopped between two stages and taken up again is the one that was not stopped."""
        whole = self.done(scene_of(stages), drawing, out="whole", **expected)
        part = dict(list(stages.items())[:first])
        self.done(scene_of(part, **KEEP), drawing, out="parts", warnings=expected.get("early", ()))
        on = self.done(scene_of(stages, **KEEP), drawing, "--restart", out="parts",
                       **{k: v for k, v in expected.items() if k != "early"})
        for name in ("displacement", "stress", "joint_normal_force_N"):
            with h5py.File(whole.folder / "fields.h5") as a, h5py.File(on.folder / "fields.h5") as b:
                last = sorted(a["steps"])[-1]
                self.assertEqual(sorted(b["steps"])[-1], last)
                np.testing.assert_array_equal(a["steps"][last][name][()], b["steps"][last][name][()], name)
        return whole


class Velocity(SeamTest):
    STAGES = {"own weight": OWN, "slides": timed(0.4), "at rest": STRIKE, "later": timed(0.1)}

    def scene(self, stages, friction=0.3, **sections):
        scene = sliding(stages, friction, **sections)
        return scene.replace('<ParameterList name="stages">',
                             '<ParameterList name="time">\n' + stones.xml("stiffness damping", 1e-4) +
                             '\n</ParameterList>\n<ParameterList name="stages">')

    def test_it_is_given_as_time_begins_and_once(self):
        run = self.done(self.scene(self.STAGES), SLIDING)
        way = 0.4**2 / (2 * 0.3 * G)
        self.assertAlmostEqual(run.history[-1]["ux_m of m"], way, delta=0.01 * way)
        self.assertAlmostEqual(run.history[-1]["external_work_J"], 160.0, delta=0.1)  # and that of its weight
        self.assertLess(abs(run.result["energy"]["removed_J"]), 1e-3)

    def test_it_is_dropped_where_load_steps_begin_and_that_is_said(self):
        run = self.done(self.scene({**self.STAGES, "slides": timed(0.02)}, friction=0.0), SLIDING,
                        warnings=["velocity_dropped"])
        energy = run.result["energy"]
        self.assertAlmostEqual(energy["removed_J"], 160.0, delta=0.1)
        self.assertLess(abs(energy["imbalance_J"]), 1e-4)
        self.assertAlmostEqual(run.history[-1]["ux_m of m"], 0.4 * 0.02, delta=1e-6)

    def test_what_inertia_held_back_goes_with_it(self):
        """A load that is there at once does twice the work of one that grows; half of it is in the vibration, in motion
        or as what is stored beyond rest, whenever load steps end it."""
        press, pressed = {"p": {"type": "traction", "on": "top", "ty": -2e4}}, {"loads": {"p": 1.0}}
        slowly = self.done(sliding({"own weight": OWN, "pressed": pressed, "twice": {"loads": {"p": 2.0}}}, velocity=0,
                                   loads=press), SLIDING)
        of_own, of_one, of_two = (step["external_work_J"] for step in slowly.history)
        elastic = slowly.history[1]["elastic_J"]
        work = ((of_two - of_own) - 2 * (of_one - of_own)) / 2  # that of the weight along the way is left out
        for steps in (3, 7, 8):
            with self.subTest(steps=steps):
                stages = {"own weight": OWN, "held": pressed,
                          "at once": {**pressed, "duration": steps * 5e-5, "time step": 5e-5, "at once": True}}
                stages = {name: stages[name] for name in ("own weight", "at once", "held")}
                run = self.done(sliding(stages, velocity=0, loads=press), SLIDING, warnings=["velocity_dropped"])
                energy = run.result["energy"]
                self.assertAlmostEqual(energy["removed_J"], work, delta=1e-3 * work)
                self.assertLess(abs(energy["imbalance_J"]), 1e-5 * work)
                self.assertAlmostEqual(energy["elastic_J"], elastic, delta=1e-3 * work)

    def test_a_restart_at_the_seam_gives_it_once(self):
        stages = {"own weight": OWN, "slides": timed(0.02), "on": timed(0.02)}
        for first in (1, 2):
            with self.subTest(first=first):
                run = self.in_two(stages, first, self.scene, SLIDING)
                self.assertAlmostEqual(run.history[-1]["external_work_J"], 160.0, delta=0.5)

    def test_what_knows_no_velocity_refuses_stages_with_a_duration(self):
        stages = {"own weight": OWN, "slides": timed(0.02)}
        self.refused(sliding(stages, model={"rotations": "finite"}), SLIDING, "time steps know of small rotations")
        self.refused(sliding(stages, construction={"b": {"blocks": "block", "appears": "slides"}}), SLIDING,
                     "does not go with construction stages")
        self.refused(sliding(stages, load_factor={"pattern": {"weight": 1.0}}), SLIDING, "a load factor is one of statics")


class AbsentStones(SeamTest):
    def fields(self, run):
        with h5py.File(run.folder / "fields.h5") as file:
            joints = {name: file["joints"][name][()].ravel() for name in ("block_i", "block_j")}
            step = file["steps"][sorted(file["steps"])[-1]]
            of_cell = file["mesh/block_of_cell"][()].ravel()
            return joints, of_cell, {name: table[()] for name, table in step.items() if isinstance(table, h5py.Dataset)}

    def test_a_prop_that_is_gone_bears_and_tells_nothing(self):
        scene = propped({"own weight": OWN, "strike": STRIKE}, GOES,
                        observations={"p": {"place": "support", "support": "pg"}, "m": {"x": 1.2, "y": 0.4}})
        run = self.done(scene, PROPPED)
        reactions = run.result["statics"]["reactions"]
        self.assertLess(abs(reactions["pg"]["y_N"]), 1e-6 * WEIGHT)
        self.assertAlmostEqual(sum(r["y_N"] for r in reactions.values()), WEIGHT, delta=1e-5 * WEIGHT)
        first, last = run.history
        self.assertGreater(first["fy_N of p"], 5000)
        self.assertEqual(last["fy_N of p"], 0)
        self.assertTrue(math.isnan(last["uy_m of p"]))
        # The book: what the prop had, and what it took as the lintel came down on it.
        energy = run.result["energy"]
        self.assertGreater(energy["removed_J"], 1e-3 * energy["elastic_J"])
        self.assertLess(abs(energy["imbalance_J"]), 0.02 * energy["removed_J"])
        joints, of_cell, step = self.fields(run)
        gone = (joints["block_i"] == 2) | (joints["block_j"] == 2)
        self.assertTrue(gone.any())
        for name in ("joint_gap_m", "joint_slip_m"):
            np.testing.assert_array_equal(np.isnan(step[name].ravel()), gone)
        self.assertFalse(step["joint_selected"].ravel()[gone].any())
        self.assertFalse(step["joint_normal_force_N"].ravel()[gone].any())
        np.testing.assert_array_equal(np.isnan(step["stress"]).all(axis=1), of_cell == 2)
        self.assertLess(run.result["largest_displacement_m"], 1e-3)
        self.assertEqual([math.isnan(row["opening_m"]) for row in run.table("joints.csv")],
                         [2 in (row["block_i"], row["block_j"]) for row in run.table("joints.csv")])

    def test_ranks_tell_the_same(self):
        scene = propped({"own weight": OWN, "strike": STRIKE}, GOES)
        one, two = (self.done(scene, PROPPED, out=f"ranks{n}", ranks=n).result["energy"] for n in (1, 2))
        for name in ("elastic_J", "removed_J", "external_work_J"):
            self.assertAlmostEqual(one[name], two[name], delta=1e-5 * one["elastic_J"])

    def test_a_stage_that_only_takes_stones_away_changes_something(self):
        run = self.done(propped({"own weight": OWN, "strike": {}}, GOES), PROPPED)
        self.assertNotIn("nothing changes", run.words)

    def test_loads_and_settlements_on_them_are_named(self):
        loads = {"push": {"type": "point load", "x": 1.1, "y": -0.5, "fx": 5000.0, "blocks": "prop"},
                 "sink": {"type": "settlement", "support": "pg", "uy": -0.001},
                 "warm": {"type": "temperature", "blocks": "prop", "change": 10.0, "expansion": 1e-5}}
        stages = {"own weight": OWN, "strike": STRIKE}
        for name, load in loads.items():
            scene = propped({**stages, "more": {"loads": {name: 1.0}}}, GOES, {name: load})
            run = self.done(scene, PROPPED, out=name, warnings=["load_on_absent_stones"])
            self.assertIn(f"scene > loads > {name}", run.result["warnings"][0]["where"])
            self.assertIn('"more"', run.result["warnings"][0]["text"])
        # A crowd on the lintel, which is there, and a weight of all stones are nobody's mistake.
        crowd = {"crowd": {"type": "crowd", "on": "top", "intensity": 1000.0}}
        self.done(propped({**stages, "more": {"loads": {"crowd": 1.0}}}, GOES, crowd), PROPPED, out="crowd")

    def test_a_pattern_on_them_is_named(self):
        scene = propped({"own weight": OWN, "strike": STRIKE}, GOES,
                        {"push": {"type": "point load", "x": 1.1, "y": -0.5, "fx": 5000.0, "blocks": "prop"}},
                        load_factor={"pattern": {"push": 1.0}, "largest factor": 0.1})
        run = self.done(scene, PROPPED, warnings=["load_on_absent_stones"])
        self.assertIn("the search for a load factor", run.result["warnings"][0]["text"])

    def test_a_stone_has_one_time_of_being_there(self):
        stages = {"own weight": OWN, "strike": STRIKE}
        twice = {"first": {"blocks": "prop", "disappears": "strike"}, "second": {"blocks": "timber", "appears": "strike"}}
        self.refused(propped(stages, twice), PROPPED, "scene > construction > second", "scene > construction > first",
                     "surface 3")
        alike = {**GOES, "again": {"blocks": "timber", "disappears": "strike"}}
        self.done(propped(stages, alike), PROPPED)

    def test_a_stage_has_stones(self):
        self.refused(propped({"own weight": OWN, "strike": STRIKE}, {"all": {"blocks": "all", "disappears": "strike"}}),
                     PROPPED, "stages > strike", "has no block")
        self.refused(propped({"own weight": OWN, "strike": STRIKE}, {"all": {"blocks": "all", "appears": "strike"}}),
                     PROPPED, "stages > own weight", "has no block")

    def test_stones_appear_loaded_and_on_what_has_settled(self):
        later = {"later": {"blocks": "lintel", "appears": "strike"}}
        sink = {"sink": {"type": "settlement", "support": "lg", "uy": -0.001}}
        stages = {"own weight": {"loads": {"weight": 1.0, "sink": 1.0}}, "strike": STRIKE}
        run = self.done(propped(stages, later, sink, observations={"m": {"x": 1.2, "y": 0.4}}), PROPPED,
                        warnings=["observed_absent_stones"])
        reactions = run.result["statics"]["reactions"]
        self.assertAlmostEqual(sum(r["y_N"] for r in reactions.values()), WEIGHT + 2000.0 * G * 0.2,
                               delta=1e-5 * WEIGHT)
        first, last = run.history
        self.assertTrue(math.isnan(first["uy_m of m"]))
        self.assertLess(abs(last["uy_m of m"]), 1e-4)  # since its birth, not with the jamb
        self.assertLess(abs(run.result["energy"]["imbalance_J"]), 1e-3 * run.result["energy"]["elastic_J"])

    def test_a_support_that_has_moved_takes_along_what_appears_on_it(self):
        later = {"later": {"blocks": "prop", "appears": "strike"}}
        sink = {"sink": {"type": "settlement", "support": "pg", "uy": -0.001}}
        stages = {"own weight": {"loads": {"weight": 1.0, "sink": 1.0}}, "strike": STRIKE}
        self.done(propped(stages, later, sink), PROPPED, warnings=["load_on_absent_stones"])

    def test_joints_of_them_do_not_break(self):
        glued = {"glue": {"friction coefficient": 0.6, "cohesion": 1e5, "tension strength": 1e5, "fracture energy": 50.0,
                          "shear fracture energy": 50.0}}
        for name, mode in (("adaptive", {}), ("all", {"selection": {"mode": "all"}})):
            run = self.done(propped({"own weight": OWN, "strike": STRIKE, "on": STRIKE}, GOES, joints=glued, **mode), PROPPED,
                            out=name)
            energy = run.result["energy"]
            self.assertLess(abs(energy["fracture_J"]), 1e-6 * energy["elastic_J"])
            self.assertLess(abs(energy["imbalance_J"]), 0.02 * energy["removed_J"])
            joints, _, step = self.fields(run)
            gone = (joints["block_i"] == 2) | (joints["block_j"] == 2)
            np.testing.assert_array_equal(np.isnan(step["joint_damage"].ravel()), gone)

    def test_a_restart_while_they_are_away(self):
        stages = {"own weight": OWN, "strike": {**STRIKE, "increments": 2}, "crowd": {"loads": {"crowd": 1.0}}}
        crowd = {"crowd": {"type": "crowd", "on": "top", "intensity": 1000.0}}

        def scene(some, **sections):
            there = GOES if "strike" in some else {}
            return propped(some, there, crowd, **sections)

        for first in (1, 2):
            with self.subTest(first=first):
                self.in_two(stages, first, scene, PROPPED)

    def test_the_last_equilibrium_has_its_stones(self):
        # Without its right jamb the lintel falls: what is told is the equilibrium before, with the jamb.
        stages = {"own weight": OWN, "strike": STRIKE}
        both = {"jamb": {"blocks": "right", "disappears": "strike"}, "prop": {"blocks": "prop", "disappears": "strike"}}
        run = self.done(propped(stages, both, steps={"expect collapse": True}), PROPPED, outcome="collapse")
        self.assertAlmostEqual(sum(r["y_N"] for r in run.result["statics"]["reactions"].values()), WEIGHT + 2000.0 * G * 0.2,
                               delta=1e-5 * WEIGHT)


class Counts(SeamTest):
    def test_what_was_tried_in_vain_is_counted(self):
        # Glue that bears the first third of a lift breaks at half of it: the step is halved, and the last one fails.
        glued = {"glue": {"friction coefficient": 0.6, "cohesion": 1e6, "tension strength": 1e4}}
        scene = stones.scene("stones.geo", ["ground"], {"lift": {"type": "acceleration", "ay": 3 * G}},
                             {"own weight": OWN, "lift": {"loads": {"lift": 1.0}}}, joints=glued,
                             steps={"expect collapse": True})
        run = self.run_scene(scene, drawing=SLIDING)
        rows = run.history
        halved = max(row["load_factor"] for row in rows if row["stage"] == "lift")
        self.assertGreater(halved, 0.25)
        self.assertLess(halved, 1.0)
        self.assertNotEqual(run.outcome, "equilibrium", run.said)
        for count in ("linear_solves", "newton_iterations", "krylov_iterations", "selection_rounds"):
            self.assertGreater(run.result[count], sum(row[count] for row in rows))  # attempts after the last step
        first = next(row for row in rows if row["stage"] == "lift")
        again = self.run_scene(scene, "--set", f"loads/lift/ay={3 * G * halved}", drawing=SLIDING, out="again")
        self.assertEqual(again.outcome, "equilibrium", again.said)
        # The row of a step that stands has what its whole and its halves took before it.
        self.assertGreater(first["linear_solves"], again.history[-1]["linear_solves"])
        self.assertEqual(again.result["linear_solves"], sum(row["linear_solves"] for row in again.history))


class Table(program.SceneTest):
    def test_no_cell_is_left_open(self):
        rows = [line.strip().strip("|").split("|") for line in SEAMS.read_text(encoding="utf-8").splitlines()
                if line.startswith("| **")]
        self.assertEqual(len(rows), 7)
        for row in rows:
            self.assertEqual(len(row), 7, row)
            self.assertTrue(all(cell.strip() for cell in row), row)


if __name__ == "__main__":
    program.main()

"""What a scene in space asks for is what it gets: whole loads, every point, on ranks without stones too.

usage: asked_in_space.py PROGRAM MPIEXEC [names of tests]

Set-up    Walls and prisms of boxes of a few stones.
Expected  A train along the back of a wall bears on it whole, whether a return starts there or at the front. A crowd on all
          faces stands on those that look up. Selection of all points selects all, where some were let go before: by an
          initial velocity, or in a run that goes on from one that selected fewer. Stones that are not there yet and are
          observed are told of alike on any number of ranks. A settlement along which its support holds nothing is told.
          In time the ground bears, in every step, the weight and what changes the momentum of all stones, when one falls on it
          and when it moves under it. Stones that are glued on one another fall as one does.
          A pressure on a stone of tetrahedra shortens it as one of hexahedra.
Tolerance Forces 1e-8 of them, that of the solver. The stone under pressure 2 %, what so few cells differ by.
"""

import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import solids  # noqa: E402
from stones import xml  # noqa: E402

WALL = {"courses": 3, "blocks per course": 3, "block length": 0.4, "block height": 0.2, "thickness": 0.2, "cells along": 2,
        "cells up": 1, "cells across": 1, "ground height": 0.2}
PRISM = {"length": 1.0, "width": 0.6, "height": 2.0, "stones": 1, "ground height": 0.2}
OWN = {"own weight": {"loads": {"weight": 1.0}}}
BORNE = {"ground": {"place": "support", "support": "ground"}}


def scene(kind, mesh, loads=None, stages=None, **sections):
    tree = {"mesh": {"type": kind, kind: mesh},
            "materials": {"stone": {"Young modulus": 1e9, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"dry": {"friction coefficient": 0.6}}, "supports": {"ground": {"on": "ground"}},
            "loads": {"weight": {"type": "self weight"}, **(loads or {})}, "steps": {"stages": stages or OWN},
            "selection": {"mode": "all"}, **{name.replace("_", " "): s for name, s in sections.items()}}
    return xml("asked", tree) + "\n"


class AskedInSpace(program.SceneTest):
    def borne(self, mesh, load, out):
        stages = {**OWN, "loaded": {"loads": {"weight": 1.0, "load": 1.0}}}
        run = self.run_scene(scene("wall in space", mesh, {"load": load}, stages, observations=BORNE), out=out)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run.history[1]["fz_N of ground"] - run.history[0]["fz_N of ground"]

    def test_a_train_along_a_face_is_borne_whole(self):
        for to in ("back", "front"):
            for y, gauge in ((0.1, 0.2), (0.2, 0.0), (0.0, 0.0)):
                train = {"type": "moving train", "on": "top", "axle loads": "2000", "position": 0.7, "y": y, "gauge": gauge}
                found = self.borne({**WALL, "return left": 2, "returns to": to}, train, f"{to}-{y}")
                self.assertLess(abs(found - 2000), 1e-8 * 2000, f"return to {to}, y = {y}")

    def test_a_crowd_stands_on_what_looks_up(self):
        opening = {"x from": 0.4, "x to": 0.8, "z from": 0.0, "z to": 0.4}
        wall = {**WALL, "openings": {"door": opening}}
        found = self.borne(wall, {"type": "crowd", "on": "top", "intensity": 4000.0}, "crowd")
        self.assertLess(abs(found - 4000 * 1.2 * 0.2), 1e-8 * 4000)
        found = self.borne(wall, {"type": "crowd", "on": "base", "intensity": 4000.0}, "below")
        self.assertLess(abs(found), 1e-8 * 4000)

    def counts(self, run):
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run.history[-1]["selected_points"], run.result["candidate_points"]

    def test_all_points_are_all(self):
        prism = {**PRISM, "stones": 2}
        thrown = {"up": {"blocks": "course 1", "vx": 0.5}}
        flight = {"flight": {"duration": 0.01, "time step": 0.001, "loads": {"weight": 1.0}}}
        selected, points = self.counts(self.run_scene(
            scene("prism", prism, stages={**OWN, **flight}, initial_velocities=thrown), out="thrown"))
        self.assertEqual(selected, points)
        selected, points = self.counts(self.run_scene(scene("prism", prism, stages=flight, initial_velocities=thrown), out="at once"))
        self.assertEqual(selected, points)

    def test_a_run_that_goes_on_selects_all(self):
        push = {"push": {"type": "acceleration", "ay": 0.8}}
        pushed = {"pushed": {"loads": {"weight": 1.0, "push": 1.0}}}
        few = self.run_scene(scene("wall in space", WALL, push, {**OWN, **pushed}, selection={"mode": "adaptive"}), out="parts")
        self.assertLess(*self.counts(few))
        more = {**OWN, **pushed, "again": {"loads": {"weight": 1.0, "push": 1.0}}}
        whole = self.run_scene(scene("wall in space", WALL, push, more), out="whole")
        parts = self.run_scene(scene("wall in space", WALL, push, more), "--restart", out="parts")
        for run in (whole, parts):
            selected, points = self.counts(run)
            self.assertEqual(selected, points)

    def test_a_settlement_that_moves_nothing_is_told(self):
        for way, told in (({"ux": 1e-5, "uz": -1e-5}, True), ({"ux": 1e-5}, False)):
            run = self.run_scene(scene("wall in space", WALL, {"sink": {"type": "settlement", "support": "end", **way}},
                                       {**OWN, "sunk": {"loads": {"weight": 1.0, "sink": 1.0}}},
                                       supports={"ground": {"on": "ground"}, "end": {"on": "right", "components": "x"}}),
                                 out=str(told))
            self.assertEqual(run.outcome, "equilibrium", run.said)
            texts = [w["text"] for w in run.result["warnings"] if w["what"] == "settlement_not_held"]
            self.assertEqual(len(texts), told, run.said)
            self.assertTrue(not told or 'moves "end" along z' in texts[0], texts)

    def test_stones_that_are_not_there_yet_are_told_of_on_any_rank(self):
        stages = {"empty": {"loads": {"weight": 1.0}}, "built": {"loads": {"weight": 1.0}}}
        text = scene("prism", PRISM, stages=stages, construction={"stone": {"blocks": "course 0", "appears": "built"}},
                     observations={"stone": {"place": "mean", "blocks": "course 0"}})
        told = []
        for ranks in (1, 3):
            run = self.run_scene(text, ranks=ranks, out=f"{ranks}", seconds=120)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            told.append(json.dumps(sorted(w["text"] for w in run.result["warnings"])))
        self.assertIn("observes stones that are not there", told[0])
        self.assertEqual(*told)

    def falls(self, stones, law, **more):
        """A stone, or two that are glued, 1 x 0.6 x 1 m, that falls by 0.1 mm."""
        mesh = {**PRISM, "height": 1.0, "stones": stones, "cells along": 2, "cells across": 2, "cells up": 4 // stones}
        stages = {"fall": {"duration": 0.012, "time step": 0.0005, "at once": True,
                           "loads": {name: 1.0 for name in ("weight", *more.get("loads", {}))}}}
        whole = {"all": {"place": "mean", "blocks": "all"}}
        glued = {f"{name} {kind}": math.inf for name, kind in (("friction", "coefficient"), ("tension", "strength"))}
        joints = {"bed": law, "glue": {"between": "course 0", "and": "course 1", "cohesion": math.inf, **glued}}
        text = scene("prism", mesh, stages=stages, joints=dict(list(joints.items())[:stones]), observations={**BORNE, **whole}, **more)
        run = self.run_scene(text, out=f"{stones}")
        self.assertEqual(run.outcome, "equilibrium", run.said)
        mass, rows = 2000 * 0.6 * 1.2, run.history
        largest = max(abs(row["fz_N of ground"]) for row in rows)
        for before, row in zip(rows, rows[1:]):
            for axis, weight in (("x", 0.0), ("y", 0.0), ("z", 9.81 * mass)):
                gained = mass * (row[f"v{axis}_m_per_s of all"] - before[f"v{axis}_m_per_s of all"]) / 0.0005
                self.assertLess(abs(row[f"f{axis}_N of ground"] - weight - gained), 1e-6 * largest, (axis, row["time_s"]))
        self.assertGreater(largest, 2 * 9.81 * mass)
        return rows

    def test_the_ground_bears_what_changes_momentum(self):
        bed = {"friction coefficient": 0.3, "initial gap": 1e-4}
        one, two = (self.falls(stones, bed) for stones in (1, 2))
        for row, expected in zip(two, one):
            self.assertLess(abs(row["kinetic_J"] / expected["kinetic_J"] - 1), 1e-6)
        shaken = {"shock": {"type": "settlement", "support": "ground", "ux": 1e-4, "uz": 2e-4,
                            "time function": {"type": "sine", "frequency": 200.0}}}
        for joint in (bed, {"friction coefficient": 0.3}):
            self.falls(1, joint, loads=shaken)

    def test_a_pressure_is_borne_alike_by_all_cells(self):
        (self.folder / "stones.obj").write_text(solids.obj({"stone": solids.box((0, 0, 0), (1, 1, 1))}), encoding="utf-8")
        found = {}
        for name, mesh in (("hexahedra", {"element size": 0.125}), ("linear", {"cells": "tetrahedra", "element": "linear"}),
                           ("quadratic", {"cells": "tetrahedra"})):
            text = scene("stones", {"file": "stones.obj", "element size": 0.2, **mesh},
                         {"press": {"type": "traction", "on": "top", "pressure": 1e6}}, {"pressed": {"loads": {"press": 1.0}}},
                         supports={"ground": {"on": "base"}})
            run = self.run_scene(text, out=name)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            found[name] = run.history[-1]["elastic_J"]
        for name in ("linear", "quadratic"):
            self.assertLess(abs(found[name] / found["hexahedra"] - 1), 0.02, found)


if __name__ == "__main__":
    program.main()

"""Loads on stones of quadratic cells, whose edges bend on loaded faces too: what they store, and that runs go on.

usage: loads_on_what_bends.py PROGRAM MPIEXEC

Set-up    A cube on the ground that is pressed, warmed or stands half under water; an arm that sticks out of a wall and is
          pressed from above, in space and in the plane; a column of three boxes under every load on faces.
Expected  A cube of quadratic tetrahedra stores what one of fine hexahedra does. The arm gives way as far as one of fine cells.
          A run goes on with a load on faces that its first scene did not name, as if it had been there. The same on any
          number of ranks, and energies that the work of loads explains, where stones come and go warm too.
Tolerance Cubes 1 %, of heat 2 %: its stresses grow without bound at the edges of the held face, so energies of both kinds of
          cells fall by 3 % from one row of a mesh to the next. Arms 1 %. Other ranks 1e-6 of the largest value, what is left
          of forces.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import solids  # noqa: E402
import stones as plane  # noqa: E402
from stones import xml  # noqa: E402

CUBE = {"stone": solids.box((0, 0, 0), (1, 1, 1))}
ARM = {"wall": solids.box((-0.4, 0, 0), (0, 0.4, 0.4)), "arm": solids.box((0, 0, 0), (0.8, 0.4, 0.4))}
COLUMN = {f"drum {k}": solids.box((0, 0, 0.5 * k), (0.6, 0.4, 0.5 * k + 0.5)) for k in range(3)}
PRESS = {"press": {"type": "traction", "on": "top", "pressure": 1e6}}
WATER = {"lift": {"type": "buoyancy", "level": 0.5}}
HEAT = {"heat": {"type": "temperature", "change": 30.0, "expansion": 1e-5}}
WEIGHT = {"weight": {"type": "self weight"}}
OWN = {"weight": 1.0}
GLUED = {"joints": {"glue": {"friction coefficient": 0.6, "cohesion": 1e8, "tension strength": 1e8}}}
TETRAHEDRA = {"cells": "tetrahedra"}


def scene(loads, stages=None, mesh=None, supports=None, **sections):
    stages = stages or {"loaded": dict.fromkeys(loads, 1.0)}
    tree = {"mesh": {"type": "stones", "stones": {"file": "stones.obj", **(mesh or {})}},
            "materials": {"stone": {"Young modulus": 1e9, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"dry": {"friction coefficient": 0.6}}, "supports": supports or {"ground": {"on": "base"}},
            "loads": loads, "steps": {"stages": {name: {"loads": dict(factors)} for name, factors in stages.items()}},
            "selection": {"mode": "all"}, "newton": {"tolerance": 1e-12}, **sections}
    return xml("bending", tree) + "\n"


class LoadsOnWhatBends(program.SceneTest):
    def history(self, stones, text, *options, **more):
        (self.folder / "stones.obj").write_text(solids.obj(stones), encoding="utf-8")
        run = self.run_scene(text, *options, **more)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        for row in run.history:
            self.assertLess(abs(row["imbalance_J"]), 1e-8 * max(abs(r["external_work_J"]) for r in run.history), run.said)
        return run.history

    def test_a_cube_stores_what_one_of_fine_hexahedra_does(self):
        for loads, tolerance in ((PRESS, 0.01), (WATER, 0.01), (HEAT, 0.02)):
            name = next(iter(loads))
            fine = self.history(CUBE, scene(loads, mesh={"element size": 0.0834}), out=f"{name} hexahedra")[-1]
            few = self.history(CUBE, scene(loads, mesh={**TETRAHEDRA, "element size": 0.17}), out=name)[-1]
            self.assertLess(abs(few["elastic_J"] / fine["elastic_J"] - 1), tolerance, name)

    def test_an_arm_that_is_pressed_bends_as_fine_cells_say(self):
        held = {"ground": {"on": "faces", "blocks": "wall"}}
        press = {"press": {"type": "traction", "on": "top", "blocks": "arm", "pressure": 1e5}}
        ways = [self.history(ARM, scene(press, mesh=mesh, supports=held, selection={"mode": "bonded"}), out=out)[-1]["largest_displacement_m"]
                for out, mesh in (("fine", {"element size": 0.05}), ("few", {**TETRAHEDRA, "element size": 0.2}))]
        self.assertLess(abs(ways[1] / ways[0] - 1), 0.01, ways)

    def test_an_arm_in_the_plane_too(self):
        outlines = {"wall": plane.rectangle(-0.4, 0, 0, 0.4), "arm": plane.rectangle(0, 0, 0.8, 0.4)}
        recombined = "DefineConstant[ recombine = {0} ];\nIf (recombine)\nRecombine Surface{:};\nEndIf\n"
        ways = []
        for name, cells, size in (("fine", "quadrilateral", 0.02), ("few", "quadratic triangle", 0.2)):
            text = plane.scene({"type": "gmsh", "gmsh": {"file": "stones.geo", "cells": cells}}, ["left"],
                               {"press": {"type": "traction", "on": "above", "pressure": 1e5}},
                               {"pressed": {"loads": {"press": 1.0}}}, selection={"mode": "bonded"})
            run = self.run_scene(text, out=name, drawing=plane.geo(outlines, size, {"left": ("wall", 3), "above": ("arm", 2)}) + recombined)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            ways.append(run.history[-1]["largest_displacement_m"])
        self.assertLess(abs(ways[1] / ways[0] - 1), 0.01, ways)

    def test_a_run_goes_on_with_a_load_on_faces(self):
        mesh = {**TETRAHEDRA, "element size": 0.3}
        stages = {"own weight": OWN, "pressed": {"press": 1.0}}
        whole = self.history(CUBE, scene({**WEIGHT, **PRESS}, stages, mesh), out="whole")
        self.history(CUBE, scene(WEIGHT, {"own weight": OWN}, mesh), out="parts")
        parts = self.history(CUBE, scene({**WEIGHT, **PRESS}, stages, mesh), "--restart", out="parts")
        for ours, theirs in zip(whole, parts):
            for name in ("elastic_J", "external_work_J", "largest_displacement_m"):
                self.assertLess(abs(ours[name] / theirs[name] - 1), 1e-9, name)

    def test_stones_that_come_and_go_leave_nothing_unexplained(self):
        built = {"top": {"blocks": "drum 2", "appears": "warm", "disappears": "gone"}}
        loads = {**WEIGHT, **HEAT, "press": {"type": "traction", "on": "top", "pressure": 1e5}}
        stages = {"own weight": OWN, "warm": {"heat": 1.0, "press": 1.0}, "gone": {}, "cold": {"heat": 0.0}}
        rows = self.history(COLUMN, scene(loads, stages, {**TETRAHEDRA, "element size": 0.2}, **GLUED, construction=built))
        again = self.history(COLUMN, scene(WEIGHT, {"own weight": OWN}, {**TETRAHEDRA, "element size": 0.2}, **GLUED,
                                           construction={"top": {"blocks": "drum 2", "disappears": "own weight"}}), out="never")
        self.assertLess(rows[-1]["removed_J"], rows[1]["elastic_J"], "what goes takes no more than there was")
        self.assertLess(abs(rows[-1]["elastic_J"] / again[-1]["elastic_J"] - 1), 1e-6)

    def test_a_column_stands_alike_on_any_number_of_ranks(self):
        loads = {**WEIGHT, "press": {"type": "traction", "on": "top", "pressure": 1e5, "tx": 2e3},
                 "water": {"type": "water pressure", "on": "faces", "blocks": "drum 1", "level": 0.8},
                 "lift": {"type": "buoyancy", "level": 0.7},
                 "heat": {"type": "temperature", "blocks": "drum 1", "change": 20.0, "expansion": 1e-5},
                 "cart": {"type": "moving train", "on": "top", "axle loads": "5e3", "position": 0.25, "y": 0.17}}
        stages = {"own weight": OWN, "loaded": dict.fromkeys(loads, 1.0), "cold": {"heat": 0.0, "press": 0.5}}
        text = scene(loads, stages, {**TETRAHEDRA, "element size": 0.2}, **GLUED)
        rows = self.history(COLUMN, text)
        for ranks in (2, 4):
            for ours, theirs in zip(rows, self.history(COLUMN, text, out=f"on {ranks}", ranks=ranks)):
                for name in ("elastic_J", "external_work_J", "largest_displacement_m"):
                    self.assertLess(abs(ours[name] - theirs[name]), 1e-6 * max(row[name] for row in rows), name)


if __name__ == "__main__":
    program.main()

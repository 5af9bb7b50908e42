"""Stones of quadratic cells that are linear on joints and condensed to their corners: how they bend, and at the seams.

usage: stones_that_bend.py PROGRAM MPIEXEC

Set-up    A stone that sticks out of a wall; an arch of wedges; a column of boxes that is built, bonded by mortar, shaken; a
          slab between plates; the cross vault of others, whose folder VOUSSOIR_STONES names. In the plane an arm and a wall.
Expected  Few quadratic cells bend as many hexahedra do, linear ones by a quarter less. Points that all stick are the bonded
          continuum. What stands on a support weighs what is there; a column in mortar shortens by what mortar and stone
          each do; energy is kept in time. The same on any number of ranks, and in parts. One cell between joints is warned of.
Tolerance Bending 3 %, that of beams of as few cells; sticking points 1e-10, of what the solver leaves with 1e-12; reactions
          1e-8 of the weight.
"""

import os
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import h5py  # noqa: E402  (folders of their own)
import numpy as np  # noqa: E402
import program  # noqa: E402
import solids  # noqa: E402
import stones as plane  # noqa: E402
from stones_in_space import DENSITY, GRAVITY, push, scene  # noqa: E402

OTHERS = os.environ.get("VOUSSOIR_STONES")
GLUED = {"joints": {"glue": {"friction coefficient": 0.6, "cohesion": 1e8, "tension strength": 1e8}}}
TETRAHEDRA = {"cells": "tetrahedra"}
ARM = {"wall": solids.box((-0.4, 0, 0), (0, 0.4, 0.4)), "arm": solids.box((0, 0, 0), (0.8, 0.4, 0.4))}
COLUMN = {f"drum {k}": solids.box((0, 0, 0.5 * k), (0.6, 0.4, 0.5 * k + 0.5)) for k in range(3)}
DRUM = 0.6 * 0.4 * 0.5 * DENSITY * GRAVITY
OWN = {"loads": {"weight": 1.0}}
FOOT = {"ground": {"on": "base"}}


class StonesThatBend(program.SceneTest):
    def run_stones(self, stones, text, *options, **more):
        (self.folder / "stones.obj").write_text(solids.obj(stones), encoding="utf-8")
        return self.run_scene(text, *options, **more)

    def stands(self, run):
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run.history

    def test_an_arm_bends_as_fine_hexahedra_say(self):
        held = {"ground": {"on": "faces", "blocks": "wall"}}
        found = {}
        for name, mesh in (("fine", {"element size": 0.05}), ("quadratic", {**TETRAHEDRA, "element size": 0.2}),
                           ("linear", {**TETRAHEDRA, "element size": 0.2, "element": "linear"})):
            run = self.run_stones(ARM, scene(held, mesh=mesh, selection={"mode": "bonded"}), out=name)
            found[name] = self.stands(run)[-1]["largest_displacement_m"]
        self.assertLess(abs(found["quadratic"] / found["fine"] - 1), 0.03, found)
        self.assertLess(found["linear"] / found["fine"], 0.8, found)

    def displacements(self, run):
        self.stands(run)
        with h5py.File(run.folder / "fields.h5") as fields:
            return fields[f"steps/{len(fields['steps']):04d}/displacement"][:], fields["mesh/coordinates"][:]

    def test_points_that_stick_are_the_bonded_continuum(self):
        stones = solids.arch(5.0, 1.0, 0.8, 5, 120.0)
        held = {"ground": {"on": "faces", "blocks": "one neighbour"}}
        found = []
        for mode in ("bonded", "all"):
            run = self.run_stones(stones, scene(held, selection={"mode": mode}, newton={"tolerance": 1e-12}, **GLUED), out=mode)
            found.append(self.displacements(run)[0])
        self.assertLess(abs(found[0] - found[1]).max(), 1e-10 * abs(found[0]).max())

    def test_a_column_that_is_built_weighs_what_is_there(self):
        stages = {"two": OWN, "three": OWN, "two again": OWN}
        built = {"top": {"blocks": "drum 2", "appears": "three", "disappears": "two again"}}
        run = self.run_stones(COLUMN, scene(FOOT, stages=stages, mesh=TETRAHEDRA, construction=built))
        for row, drums in zip(self.stands(run), (2, 3, 2)):
            self.assertLess(abs(row["fz_N of ground"] - drums * DRUM), 1e-8 * DRUM)

    def test_a_column_in_mortar_shortens_by_mortar_and_stone(self):
        stiffness, pressure, area = 1e10, 1e6, 0.6 * 0.4
        loads = {"press": {"type": "traction", "on": "top", "pressure": pressure}}
        mortar = {"joints": {"lime": {"friction coefficient": 0.6, "normal stiffness": stiffness, "tangential stiffness": stiffness,
                                      "cohesion": 1e6, "tension strength": 1e6}}}
        top = {"top": {"place": "mean", "blocks": "drum 2"}, "ground": {"place": "support", "support": "ground"}}
        found = []
        for joints in (mortar, GLUED):
            run = self.run_stones(COLUMN, scene(FOOT, loads, {"press": {"loads": {"press": 1.0}}}, mesh=TETRAHEDRA, observations=top,
                                                selection={"mode": "all"}, **joints), out=f"{len(found)}")
            row = self.stands(run)[-1]
            self.assertLess(abs(row["fz_N of ground"] - pressure * area), 1e-8 * pressure * area)
            found.append(row["uz_m of top"])
        self.assertLess(abs(found[1] - found[0] - 2 * pressure / stiffness), 0.02 * 2 * pressure / stiffness)

    def test_energy_is_kept_in_time_and_runs_go_on(self):
        shake = push(30, 0.3)
        swing = {"duration": 0.02, "time step": 0.0005, "loads": {"weight": 1.0, "push": 0.0}}
        drums = {**TETRAHEDRA, "element size": 0.2}
        stages = {"own weight": OWN, "pushed": {"loads": {"weight": 1.0, "push": 1.0}}, "let go": {**swing, "at once": True}}
        text = scene(FOOT, shake, stages, mesh=drums, **GLUED)
        whole = self.run_stones(COLUMN, text, out="whole")
        rows = self.stands(whole)
        swung = max(row["kinetic_J"] for row in rows)
        self.assertGreater(swung, 0)
        self.assertLess(max(abs(row["imbalance_in_time_J"]) for row in rows), 1e-6 * swung)
        fewer = scene(FOOT, shake, dict(list(stages.items())[:2]), mesh=drums, **GLUED)
        self.run_stones(COLUMN, fewer, out="parts")
        parts = self.run_stones(COLUMN, text, "--restart", out="parts")
        self.assertEqual([{k: v for k, v in row.items() if k != "seconds"} for row in rows],
                         [{k: v for k, v in row.items() if k != "seconds"} for row in parts.history], parts.said)
        linear = scene(FOOT, shake, stages, mesh={**drums, "element": "linear"}, **GLUED)
        other = self.run_stones(COLUMN, linear, "--restart", out="parts")
        self.assertEqual(other.code, 2, "cells that bend otherwise are another structure")
        self.assertIn("mesh > stones > element", other.words)
        for ranks in (2, 4):
            other = self.run_stones(COLUMN, text, out=f"on {ranks}", ranks=ranks)
            for ours, theirs in zip(rows, self.stands(other)):
                self.assertLess(abs(ours["largest_displacement_m"] - theirs["largest_displacement_m"]),
                                1e-6 * rows[1]["largest_displacement_m"])

    def test_stresses_know_of_the_edges(self):
        tower = {f"drum {k}": solids.box((0, 0, k), (1, 1, k + 1)) for k in range(2)}
        run = self.run_stones(tower, scene(FOOT, mesh={**TETRAHEDRA, "element size": 0.5}, selection={"mode": "bonded"}))
        self.stands(run)
        with h5py.File(run.folder / "fields.h5") as fields:
            stress, corners = fields["steps/0001/stress"][:, 5], fields["mesh/coordinates"][:][fields["mesh/cells"][:, :4]]
            block = fields["mesh/block_of_cell"][:]
        height, volume = corners[:, :, 2].mean(axis=1), abs(np.linalg.det(corners[:, 1:] - corners[:, :1]))
        exact = -(2 - height) * DENSITY * GRAVITY
        off = [abs(np.average((stress - exact)[block == k], weights=volume[block == k])) for k in range(2)]
        self.assertLess(max(off), 1e-3 * DENSITY * GRAVITY, "by sections, stones bear what lies above")
        high = block == 1  # away from the foot, which is held across, the state is nearly that of a bar
        self.assertLess(abs(stress - exact)[high].max(), 0.1 * DENSITY * GRAVITY)

    def test_one_cell_between_joints_is_warned_of(self):
        slab = {"low": solids.box((0, 0, 0), (1, 1, 0.5)), "slab": solids.box((0, 0, 0.5), (1, 1, 0.6)),
                "high": solids.box((0, 0, 0.6), (1, 1, 1.1))}
        run = self.run_stones(slab, scene(mesh={**TETRAHEDRA, "element size": 0.3}), "--validate")
        self.assertEqual(run.code, 0, run.said)
        self.assertIn("stone slab has joints or supports all round and one cell between them", run.words)
        for better in ({"element size": 0.05}, {"element size": 0.3, "element": "linear"}):
            run = self.run_stones(slab, scene(mesh={**TETRAHEDRA, **better}), "--validate")
            self.assertNotIn("one cell between them", run.words)


class InThePlane(program.SceneTest):
    TRIANGLES = "quadratic triangle"

    def posed(self, mesh, supports, **sections):
        """Own weight, and pushed by a tenth of it."""
        push = {"push": {"type": "acceleration", "ax": 0.1 * GRAVITY}}
        stages = {"own weight": OWN, "pushed": {"loads": {"push": 1.0}}}
        return plane.scene(mesh, supports, push, stages, **sections)

    def wall(self, cells, mode, joints=None, **more):
        wall = {"courses": 4, "blocks per course": 3, "block length": 0.5, "block height": 0.25, "cells along": 4, "cells up": 2,
                "cells": cells}
        return self.posed({"type": "wall", "wall": wall}, ["base"], joints=joints or {"dry": {"friction coefficient": 0.6}},
                          selection={"mode": mode}, newton={"tolerance": 1e-12}, **more)

    def displacements(self, run):
        self.assertEqual(run.outcome, "equilibrium", run.said)
        with h5py.File(run.folder / "fields.h5") as fields:
            return fields[f"steps/{len(fields['steps']):04d}/displacement"][:]

    def test_an_arm_bends_as_fine_cells_say(self):
        outlines = {"wall": plane.rectangle(-0.4, 0, 0, 0.4), "arm": plane.rectangle(0, 0, 0.8, 0.4)}
        found = {}
        for name, cells, size in (("fine", "quadrilateral", 0.02), ("quadratic", self.TRIANGLES, 0.2), ("linear", "triangle", 0.2)):
            mesh = {"type": "gmsh", "gmsh": {"file": "stones.geo", "cells": cells}}
            recombined = "DefineConstant[ recombine = {0} ];\nIf (recombine)\nRecombine Surface{:};\nEndIf\n"
            run = self.run_scene(self.posed(mesh, ["left"], selection={"mode": "bonded"}), out=name,
                                 drawing=plane.geo(outlines, size, {"left": ("wall", 3)}) + recombined)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            found[name] = run.history[0]["largest_displacement_m"]
        self.assertLess(abs(found["quadratic"] / found["fine"] - 1), 0.02, found)
        self.assertLess(found["linear"] / found["fine"], 0.85, found)

    def test_points_that_stick_are_the_bonded_continuum(self):
        glue = {"dry": {"friction coefficient": 0.6, "cohesion": 1e8, "tension strength": 1e8}}
        bonded, every = (self.displacements(self.run_scene(self.wall(self.TRIANGLES, mode, glue), out=mode)) for mode in ("bonded", "all"))
        self.assertLess(abs(bonded - every).max(), 1e-10 * abs(bonded).max())

    def test_contact_is_nearer_to_fine_cells_on_any_number_of_ranks(self):
        found = {}
        for name, cells, settings in (("fine", "quadrilateral", {"along": 32, "up": 16}), ("coarse", "quadrilateral", {}),
                                      ("quadratic", self.TRIANGLES, {})):
            given = [f"--set=mesh/wall/cells {key}={value}" for key, value in settings.items()]
            run = self.run_scene(self.wall(cells, "all"), *given, out=name)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            found[name] = run.history[-1]["largest_displacement_m"]
        self.assertLess(found["coarse"], found["quadratic"])
        self.assertLess(found["quadratic"], found["fine"])
        for ranks in 2, 4:
            run = self.run_scene(self.wall(self.TRIANGLES, "all"), out=f"on {ranks}", ranks=ranks)
            self.assertLess(abs(run.history[-1]["largest_displacement_m"] / found["quadratic"] - 1), 1e-6, run.said)

    def test_cells_that_bend_otherwise_are_another_structure(self):
        self.run_scene(self.wall(self.TRIANGLES, "all"), out="run")
        run = self.run_scene(self.wall("triangle", "all"), "--restart", out="run")
        self.assertEqual(run.code, 2, run.said)
        self.assertIn("mesh > wall > cells = triangle, was quadratic triangle", run.words)

    def test_large_rotations_are_refused(self):
        run = self.run_scene(self.wall(self.TRIANGLES, "all", model={"rotations": "finite"}), "--validate")
        self.assertEqual(run.code, 2)
        self.assertIn("does not go with cells = \"quadratic triangle\"", run.words)

    def test_a_mesh_of_quadrilaterals_has_none(self):
        mesh = {"type": "gmsh", "gmsh": {"file": "stones.geo", "cells": self.TRIANGLES}}
        drawing = plane.geo({"a": plane.rectangle(0, 0, 1, 1)}, 0.5, {"base": ("a", 0)}) + "Transfinite Surface{:};\nRecombine Surface{:};\n"
        run = self.run_scene(self.posed(mesh, ["base"]), "--validate", drawing=drawing)
        self.assertEqual(run.code, 2)
        self.assertIn("has quadrilaterals only", run.words)


@unittest.skipUnless(OTHERS, "VOUSSOIR_STONES names no folder with files of others")
class VaultOfOthers(program.SceneTest):
    def work(self, size, element="quadratic"):
        """Of the weight on its way in the bonded vault."""
        springers = {"ground": {"on": "base", "blocks": "one neighbour"}}
        mesh = {"file": f"{OTHERS}/compas_dem_crossvault.obj", "unit": 0.025, "joint tolerance": 1e-3, "element size": size,
                "element": element}
        run = self.run_scene(scene(springers, mesh=mesh, selection={"mode": "bonded"}), out=f"{element} {size}", seconds=3000)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run.history[-1]["elastic_J"]

    def test_a_hundred_corners_a_stone_are_within_one_per_cent(self):
        fine, coarse = self.work(0.2), self.work(0.27)
        self.assertLess(abs(coarse / fine - 1), 0.01)


if __name__ == "__main__":
    program.main()

"""Walls with returns and openings, domes and barrel vaults from a scene to its results: weight, thrust, pushes.

usage: masonry_in_space.py PROGRAM MPIEXEC

Set-up    Dry walls of stones of 0.4 x 0.2 x 0.2 m, 10 courses, a facade of 2.4 m and returns of 1.2 m, straight, L and U;
          domes of 16 lunes x 8 courses from 5 degrees; barrel vaults. Each on ground.
Expected  Reactions are the weight by closed forms of volumes. Below what rigid stones bear with slip that dilates (0.2193 g
          for L, 0.2878 g for U, both outwards, 0.3647 g for the dome; by linear programmes) walls and domes stand. A vault
          of one row whose sides may not move across is the arch of the plane strained in its plane.
Tolerance Reactions 1e-8 of the weight, the tolerance of the solver; the plane 1e-7 of the motion and of the thrust.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import h5py  # noqa: E402  (folders of their own)
import numpy as np  # noqa: E402
import program  # noqa: E402
from wall_in_space import DENSITY, GRAVITY, scene, stages  # noqa: E402

COARSE = {"cells along": 2, "cells up": 1, "cells across": 1}
FIELD = {"courses": 10, "blocks per course": 6, "block length": 0.4, "block height": 0.2, "thickness": 0.2,
         "ground height": 0.2, **COARSE}
L_WALL, U_WALL = {**FIELD, "return left": 3}, {**FIELD, "return left": 3, "return right": 3}
HOUSE = {**L_WALL, "openings": {"door": {"x from": 0.8, "x to": 1.4, "z from": 0.0, "z to": 1.2}}}
DOME = {"radius": 5.0, "thickness": 0.4, "oculus": 5.0, "springing": 90.0, "courses": 8, "lunes": 16, "bond": "stack",
        "faces": "plane", "cells radial": 1, "cells round": 1, "cells up": 1, "ground height": 0.3}
VAULT = {"radius": 2.0, "thickness": 0.4, "embrace": 160.0, "length": 2.0, "voussoirs": 11, "stones along": 3,
         "bond": "running", "cells radial": 1, "cells round": 1, "cells along": 2, "ground height": 0.3}


def wall_volume(wall):
    """Of stones and ground [m3]."""
    length = wall["blocks per course"] * wall["block length"]
    for side in ("return left", "return right"):
        length += wall[side] * wall["block length"] - wall["thickness"] if side in wall else 0
    holes = sum((o["x to"] - o["x from"]) * (o["z to"] - o["z from"]) for o in wall.get("openings", {}).values())
    return (length * (wall["courses"] * wall["block height"] + wall["ground height"]) - holes) * wall["thickness"]


def dome_volume(dome):
    """Of polyhedra between two spheres, pyramids over plane faces of which smaller ones are taken off, and of the ground
    under a dome that springs at 90 degrees: between two polygons."""
    around, up = dome["lunes"] * (2 if dome["bond"] == "running" else 1), dome["courses"]
    outer, inner = dome["radius"] + dome["thickness"] / 2, dome["radius"] - dome["thickness"] / 2
    step, turn = math.radians(90 - dome["oculus"]) / up, math.sin(2 * math.pi / around) * around
    sines = sum(math.cos(ring * step) for k in range(up) for ring in (k, k + 1))
    return ((outer ** 3 - inner ** 3) / 6 * math.sin(step) * sines
            + (outer ** 2 - inner ** 2) / 2 * dome["ground height"]) * turn


def vault_volume(vault):
    step = math.radians(vault["embrace"]) / vault["voussoirs"] / vault["cells round"]
    edges = vault["voussoirs"] * vault["cells round"]
    ring = vault["radius"] * vault["thickness"] * math.sin(step) * edges
    return (ring + 2 * vault["ground height"] * vault["thickness"]) * vault["length"]


def pushed(x, y, shares):
    """A push [g] and stages that raise it to shares of itself."""
    steps = stages()
    steps.update({f"push {share}": {"loads": {"weight": 1.0, "push": share}} for share in shares})
    return {"push": {"type": "acceleration", "ax": x * GRAVITY, "ay": y * GRAVITY}}, steps


class MasonryInSpace(program.SceneTest):
    def own_weight(self, mesh, kind, volume, grounds=("ground",), most=10, ranks=2):
        weight = volume * DENSITY * GRAVITY
        for mode, ranks in (("all", 1), ("adaptive", 1), ("adaptive", ranks)):
            name = f"{kind}, {mode}, {ranks}"
            run = self.run_scene(scene(mesh, {}, stages(), kind=kind, selection={"mode": mode},
                                       supports={ground: {"on": ground} for ground in grounds},
                                       observations={g: {"place": "support", "support": g} for g in grounds}),
                                 out=name.replace(", ", "-").replace(" ", "-"), ranks=ranks)
            self.assertEqual(run.outcome, "equilibrium", name + run.said)
            row = run.history[0]
            self.assertLessEqual(row["linear_solves"], most, name)
            for c, expected in (("x", 0), ("y", 0), ("z", weight)):
                found = sum(row[f"f{c}_N of {ground}"] for ground in grounds)
                self.assertLess(abs(found - expected), 1e-8 * weight, f"{name}: {c}")

    def test_walls_with_returns_and_openings_stand_under_their_own_weight(self):
        self.own_weight(L_WALL, "wall in space", wall_volume(L_WALL))
        self.own_weight(HOUSE, "wall in space", wall_volume(HOUSE), most=20)  # a lintel slips on its bearings

    def test_a_wall_between_two_returns_stands_under_its_own_weight(self):
        self.own_weight(U_WALL, "wall in space", wall_volume(U_WALL))

    def test_domes_stand_under_their_own_weight(self):
        for bond in ("stack", "running"):
            mesh = {**DOME, "bond": bond, "cells round": 2 if bond == "running" else 1}
            self.own_weight(mesh, "dome", dome_volume(mesh))

    def test_a_barrel_vault_stands_under_its_own_weight(self):
        self.own_weight(VAULT, "barrel vault", vault_volume(VAULT), ("ground left", "ground right"), ranks=4)

    def pushes(self, mesh, kind, way, shares, most):
        loads, steps = pushed(*way, shares)
        run = self.run_scene(scene(mesh, loads, steps, kind=kind, selection={"mode": "all"}, model={"hexahedra": "plain"}))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        self.assertEqual([row["load_factor"] for row in run.history if row["load_factor"] == 1], [1] * (1 + len(shares)))
        self.assertLessEqual(max(row["linear_solves"] for row in run.history), most)

    def test_a_straight_wall_falls_where_its_weight_passes_over_its_edge(self):
        loads = {"push": {"type": "acceleration", "ay": -GRAVITY}}
        run = self.run_scene(scene(FIELD, loads, stages(), kind="wall in space", model={"hexahedra": "plain"},
                                   load_factor={"pattern": {"push": 1.0}, "accuracy": 0.01}))
        self.assertEqual(run.code, 0, run.said)
        bracket = run.result["collapse"]
        self.assertLessEqual(bracket["lower"], 0.1 * (1 + 1e-6))
        self.assertGreaterEqual(bracket["upper"], 0.1 * (1 - 1e-9))  # a certificate is exact to round-off
        self.assertLess(bracket["upper"] - bracket["lower"], 0.011 * 0.1)

    def test_a_wall_with_one_return_is_pushed_outwards(self):
        self.pushes(L_WALL, "wall in space", (0, -0.2193), (0.3, 0.6, 0.8), 150)

    def test_a_wall_between_two_returns_is_pushed_outwards(self):
        self.pushes(U_WALL, "wall in space", (0, -0.2878), (0.3, 0.6, 0.9), 150)

    def test_a_dome_is_pushed_sideways(self):
        self.pushes(DOME, "dome", (0.3647, 0), (0.3, 0.6), 150)

    def test_a_barrel_vault_of_one_row_is_the_arch_of_the_plane(self):
        ring = {"radius": 2.0, "thickness": 0.4, "embrace": 160.0, "voussoirs": 11, "cells radial": 2}
        loads, steps = pushed(0.05, 0, (1.0,))
        loads["spreading"] = {"type": "settlement", "support": "springing left", "ux": -1e-4}
        steps["spreading"] = {"loads": {"weight": 1.0, "spreading": 1.0}}
        held = {f"springing {side}": {"on": f"springing {side}", "components": "all"} for side in ("left", "right")}
        seen = {side: {"place": "support", "support": f"springing {side}"} for side in ("left", "right")}
        common = {"selection": {"mode": "all"}, "observations": seen}
        plane = self.run_scene(scene({**ring, "cells along": 2}, loads, steps, kind="arch", supports=held,
                                     model={"plane": "strain", "thickness": 0.5}, **common), out="plane")
        sides = {**held, "front": {"on": "front", "components": "y"}, "back": {"on": "back", "components": "y"}}
        row = {**ring, "length": 0.5, "stones along": 1, "bond": "stack", "cells round": 2, "cells along": 1}
        space = self.run_scene(scene(row, loads, steps, kind="barrel vault", supports=sides,
                                     model={"hexahedra": "plain"}, **common), out="space")
        for run in (plane, space):
            self.assertEqual(run.outcome, "equilibrium", run.said)
        for flat, solid in zip(plane.history, space.history):
            self.assertGreater(flat["slip_points"] + flat["open_points"], 0)
            for column in ("largest_displacement_m", "elastic_J"):
                self.assertLess(abs(flat[column] - solid[column]), 1e-7 * flat[column], column)
            for side in ("left", "right"):
                for of_plane, of_space in (("x", "x"), ("y", "z")):
                    expected = flat[f"f{of_plane}_N of {side}"]
                    self.assertLess(abs(expected - solid[f"f{of_space}_N of {side}"]), 1e-7 * abs(flat["fy_N of left"]))

    def test_wind_blows_on_the_faces_that_stones_leave_free(self):
        """On the front of a house of two returns with a door, and on the inside and the end of one return."""
        door = {"x from": 0.8, "x to": 1.4, "z from": 0.0, "z to": 1.2}
        house = {**U_WALL, "openings": {"door": door}}
        loads = {"wind": {"type": "traction", "on": "front", "ty": 10.0},
                 "inside": {"type": "traction", "on": "return left inside", "tx": -20.0},
                 "end": {"type": "traction", "on": "return ends", "blocks": "return right", "ty": -50.0}}
        steps = stages()
        steps["wind"] = {"loads": {"weight": 1.0, "wind": 1.0, "inside": 1.0, "end": 1.0}}
        run = self.run_scene(scene(house, loads, steps, observations={"ground": {"place": "support", "support": "ground"}}))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        expected = {"x": 20.0 * 1.0 * 2.0, "y": -10.0 * (2.4 * 2.0 - 0.6 * 1.2) + 50.0 * 0.2 * 2.0}
        for c, force in expected.items():
            found = run.history[-1][f"f{c}_N of ground"] - run.history[0][f"f{c}_N of ground"]
            self.assertLess(abs(found - force), 1e-8 * wall_volume(house) * DENSITY * GRAVITY, c)

    def test_a_vault_whose_abutment_moves_out_has_three_hinges(self):
        run = self.run_scene(pathlib.Path(__file__).resolve().parents[2] / "xml" / "barrel-vault-spreading.xml")
        self.assertEqual(run.outcome, "equilibrium", run.said)
        before, after = run.history
        self.assertLess(after["fx_N of left"], 0.9 * before["fx_N of left"])  # the least thrust
        self.assertLess(abs(after["fz_N of left"] - before["fz_N of left"]), 1e-3 * before["fz_N of left"])
        self.assertLess(abs(after["ux_m of crown"] + 0.005), 1e-5)  # half of the way of one abutment
        self.assertLess(after["uz_m of crown"], -0.004)
        with h5py.File(run.folder / "fields.h5") as fields:
            open_ = fields["steps/0002/joint_gap_m"][:] > 5e-4
            places = fields["mesh/coordinates"][:][fields["joints/node_j"][:][open_]]
        angle = np.degrees(np.arctan2(places[:, 0], places[:, 2]))
        radius = np.hypot(places[:, 0], places[:, 2])
        crown = np.abs(angle) < 6
        self.assertTrue(crown.any() and (radius[crown] < 2.51).all())
        self.assertTrue((radius[~crown] > 2.49).all())
        for side in (-1, 1):
            self.assertTrue((side * angle > 55).any())

    def test_a_prism_stands_and_tips_where_statics_says(self):
        prism = {"length": 1.0, "width": 0.6, "height": 2.0, "stones": 1, "ground height": 0.5}
        loads, steps = pushed(0, -0.3, (0.999, 1.001))
        run = self.run_scene(scene(prism, loads, steps, kind="prism"))
        self.assertEqual(run.outcome, "collapse", run.said)
        stood = [row["stage"] for row in run.history if row["load_factor"] == 1]
        self.assertEqual(stood, ["own weight", "push 0.999"])

    def test_what_cannot_be_built_is_refused_in_words(self):
        window = {"x from": 0.8, "x to": 1.4, "z from": 0.5, "z to": 1.2}
        for words, mesh, kind in (
                ("mesh > wall in space > openings > window > z from = 0.5 [m] must be a multiple of 0.2 m, a course",
                 {**FIELD, "openings": {"window": window}}, "wall in space"),
                ("mesh > wall in space > thickness = 0.3 [m] must be half a block, 0.2 m, in a wall with returns",
                 {**L_WALL, "thickness": 0.3}, "wall in space"),
                ("openings > door > x to = 0.5 [m] must be > x from = 0.8",
                 {**FIELD, "openings": {"door": {**window, "x to": 0.5}}}, "wall in space"),
                ("mesh > dome > lunes = 2 [-] must be >= 3", {**DOME, "lunes": 2}, "dome"),
                ("mesh > dome > oculus = 95 [degree] must be < springing = 90", {**DOME, "oculus": 95.0}, "dome"),
                ("mesh > barrel vault > cells along = 3 [-] must be even in running bond", {**VAULT, "cells along": 3},
                 "barrel vault"),
                ("asks for", {**DOME, "courses": 100000, "lunes": 100000}, "dome")):
            run = self.run_scene(scene(mesh, {}, stages(), kind=kind), "--validate")
            self.assertEqual(run.code, 2, run.said)
            self.assertIn(words, run.words)


if __name__ == "__main__":
    program.main()

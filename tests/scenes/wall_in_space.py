"""Walls in space from a scene to its results: weight and reactions, pushes in directions that are no axis, the plane.

usage: wall_in_space.py PROGRAM MPIEXEC

Set-up    A wall in running bond on rigid ground; a prism of 1 x 0.6 x 2 m, pushed at angles from x.
Expected  Reactions are the weight, with all points and with those that selection lets go. A prism with friction 0.6 tips
          when the push along an edge's normal passes the edge: 0.5, 0.5774, 0.4243, 0.3464 g at 0, 30, 45, 60 degrees;
          with friction 0.2 it slides at 0.2 g. A plane wall and its extrusion by one plain cell, whose faces may not
          move across, are one: plane strain.
Tolerance Reactions 1e-8 of the weight, the tolerance of the solver; the plane 1e-7 of the motion.
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import h5py  # noqa: E402  (folders of their own)
import program  # noqa: E402
from stones import xml  # noqa: E402

DENSITY, GRAVITY = 2000.0, 9.81
STACK = {"courses": 3, "blocks per course": 1, "block length": 1.0, "block height": 0.5, "thickness": 0.6, "bond": "stack",
         "cells along": 2, "cells up": 1, "cells across": 2, "ground height": 0.2}
WALL = {"courses": 4, "blocks per course": 3, "block length": 0.4, "block height": 0.2, "thickness": 0.2,
        "cells along": 2, "cells up": 1, "cells across": 1, "ground height": 0.2}
PRISM = {"courses": 1, "blocks per course": 1, "block length": 1.0, "block height": 2.0, "thickness": 0.6, "bond": "stack",
         "ground height": 0.5}


def scene(mesh, loads, stages, friction=0.6, supports=None, kind="wall in space", **sections):
    tree = {"mesh": {"type": kind, kind: mesh},
            "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": DENSITY}},
            "joints": {"dry": {"friction coefficient": friction}},
            "supports": supports or {"ground": {"on": "ground"}},
            "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, **loads},
            "steps": {"stages": stages}, **{name.replace("_", " "): section for name, section in sections.items()}}
    return xml("walls", tree) + "\n"


def stages(*pushes):
    """Own weight, then so much of the push."""
    steps = {"own weight": {"loads": {"weight": 1.0}}}
    for push in pushes:
        steps[f"push {push}"] = {"loads": {"weight": 1.0, "push": push}}
    return steps


def push(degrees, share):
    """A share of the weight in a direction from x to y."""
    a = share * GRAVITY
    return {"push": {"type": "acceleration", "ax": a * math.cos(math.radians(degrees)), "ay": a * math.sin(math.radians(degrees))}}


class WallsInSpace(program.SceneTest):
    def volume(self, mesh):
        along = mesh["blocks per course"] * mesh["block length"] * mesh["thickness"]
        return along * (mesh["courses"] * mesh["block height"] + mesh["ground height"])

    def own_weight_and_push(self, mode, ranks=1, joints=None):
        observations = {"ground": {"place": "support", "support": "ground"}, "top": {"place": "mean", "blocks": "course 3"}}
        law = {"joints": {"law": {"friction coefficient": 0.6, **joints}}} if joints else {}
        return self.run_scene(scene(WALL, push(30, 0.05), stages(1.0), selection={"mode": mode}, observations=observations, **law),
                              out=f"{mode}-{ranks}", ranks=ranks)

    def reactions(self, mode, ranks=1, joints=None):
        """The run, whose ground bears the weight and the push."""
        weight = self.volume(WALL) * DENSITY * GRAVITY
        run = self.own_weight_and_push(mode, ranks, joints)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        for row, share in zip(run.history, (0.0, 0.05)):
            force = [row[f"f{c}_N of ground"] for c in "xyz"]
            way = [-share * math.cos(math.radians(30)), -share * math.sin(math.radians(30)), 1.0]
            for found, expected in zip(force, way):
                self.assertLess(abs(found - expected * weight), 1e-8 * weight)
        return run

    def test_reactions_are_the_weight_and_the_push(self):
        tops = []
        for mode, ranks in (("all", 1), ("adaptive", 1), ("adaptive", 2)):
            run = self.reactions(mode, ranks)
            tops.append([run.history[-1][f"u{c}_m of top"] for c in "xyz"])
        size = math.hypot(*tops[0])
        for top in tops[1:]:
            self.assertLess(math.dist(top, tops[0]), 0.02 * size, "what selection leaves tied is a few per cent stiffer")

    def test_so_they_are_where_joints_hold(self):
        # Where three stones meet forces can run round; how they are split may not change what stones bear.
        for name, joints in (("shear", {"cohesion": 1e6}), ("both", {"cohesion": 1e6, "tension strength": 1e6}),
                             ("little", {"cohesion": 500.0, "tension strength": 300.0}),
                             ("mortar", {"cohesion": 1e5, "tension strength": 5e4, "fracture energy": 10.0,
                                         "shear fracture energy": 50.0, "normal stiffness": 2e9, "tangential stiffness": 1e9})):
            with self.subTest(name):
                run = self.reactions("all", 2 if name == "both" else 1, joints)
                self.assertLess(run.result["linear_solves"], 40)

    def test_fields_are_hexahedra(self):
        run = self.own_weight_and_push("adaptive")
        with h5py.File(run.folder / "fields.h5") as fields:
            corners, places = fields["mesh/cells"][:], fields["mesh/coordinates"][:]
            self.assertEqual(corners.shape[1], 8)
            first = places[corners[0]]
            self.assertGreater(abs((first[6] - first[0]) @ [1, 1, 1]), 0)
            self.assertEqual(fields["steps/0001/stress"].shape, (len(corners), 6))
            self.assertEqual(fields["steps/0001/displacement"].shape[1], 3)
            # What lies lowest bears what lies above: vertical stress of the course above the ground, in the mean.
            low = (places[corners][:, :, 2].min(axis=1) == 0)
            above = 0.8 * DENSITY * GRAVITY - 0.1 * DENSITY * GRAVITY
            self.assertLess(abs(fields["steps/0001/stress"][:][low, 5].mean() + above), 0.05 * above)
        text = (run.folder / "fields.xdmf").read_text(encoding="utf-8")
        self.assertIn('TopologyType="Hexahedron"', text)
        self.assertIn('GeometryType="XYZ"', text)

    def test_the_report_shows_it(self):
        run = self.own_weight_and_push("all")
        make = pathlib.Path(__file__).resolve().parents[2] / "drivers" / "report" / "make_report.py"
        subprocess.run([sys.executable, "-B", make, run.folder], check=True, capture_output=True)
        page = (run.folder / "report.html").read_text(encoding="utf-8")
        self.assertNotIn("could not be drawn", page)
        for picture in ("structure", "deformed", "stages", "joints"):
            self.assertTrue((run.folder / "pictures" / f"{picture}.png").exists(), picture)
        self.assertIn("through x [m]</th><th>y [m]</th><th>z [m]", page.replace("\n", ""))

    def prism(self, degrees, limit, friction, mode):
        name = f"{degrees}-{friction}-{mode}"
        run = self.run_scene(scene(PRISM, push(degrees, limit), stages(0.999, 1.001), friction=friction,
                                   selection={"mode": mode}), out=name)
        self.assertEqual(run.outcome, "collapse", name + run.said)
        stood = [row["stage"] for row in run.history if row["load_factor"] == 1]
        self.assertEqual(stood, ["own weight", "push 0.999"], f"{name}: it stands at 0.999 and falls at 1.001 of the closed form")

    def test_a_prism_tips_where_statics_says(self):
        for degrees, limit in ((0, 0.5), (30, 0.5 / math.cos(math.radians(30))), (45, 0.3 / math.sin(math.radians(45))),
                               (60, 0.3 / math.sin(math.radians(60)))):
            self.prism(degrees, limit, 0.6, "adaptive")
        self.prism(45, 0.3 / math.sin(math.radians(45)), 0.6, "all")

    def test_a_prism_slides_in_every_direction(self):
        for degrees in (0, 17, 45):
            run = self.run_scene(scene(PRISM, push(degrees, 1.0), stages(), friction=0.2,
                                       load_factor={"pattern": {"push": 1.0}, "accuracy": 0.005}), out=str(degrees))
            self.assertEqual(run.code, 0, run.said)
            bracket = run.result["collapse"]
            self.assertLessEqual(bracket["lower"], 0.2 * (1 + 1e-6))
            self.assertGreaterEqual(bracket["upper"], 0.2 * (1 - 1e-9))  # the certificate, to round-off
            self.assertLess(bracket["upper"] - bracket["lower"], 0.006 * 0.2)

    def test_a_stone_flies(self):
        # The weight grows from nothing within the stage, so that it falls by g t^2 / 6.
        duration = 0.05
        flight = {"up": {"blocks": "course 0", "vx": 0.5, "vy": 0.2, "vz": 1.0}}
        run = self.run_scene(scene(PRISM, {}, {"flight": {"duration": duration, "loads": {"weight": 1.0}}},
                                   initial_velocities=flight, observations={"stone": {"place": "mean", "blocks": "course 0"}}))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        end = run.history[-1]
        for c, way in zip("xyz", (0.5 * duration, 0.2 * duration, duration - GRAVITY * duration ** 2 / 6)):
            self.assertLess(abs(end[f"u{c}_m of stone"] - way), 1e-4 * way)  # steps of a twentieth of the stage and less
        self.assertLess(abs(end["vz_m_per_s of stone"] - (1 - GRAVITY * duration / 2)), 1e-9)
        self.assertLess(abs(end["imbalance_J"]), 1e-9 * end["kinetic_J"])

    def test_the_plane_is_an_extrusion(self):
        wall = {"courses": 4, "blocks per course": 3, "block length": 0.4, "block height": 0.2, "cells along": 2, "cells up": 1}
        seen = {"top": {"place": "mean", "blocks": "course 3"}, "ground": {"place": "support", "support": "ground"}}
        sideways = {"push": {"type": "acceleration", "ax": 0.1 * GRAVITY}}
        common = {"selection": {"mode": "all"}, "observations": seen}
        plane = self.run_scene(scene(wall, sideways, stages(1.0), kind="wall", supports={"ground": {"on": "base"}},
                                     model={"plane": "strain", "thickness": 0.2}, **common), out="plane")
        sides = {"ground": {"on": "base", "components": "all"}, "front": {"on": "front", "components": "y"},
                 "back": {"on": "back", "components": "y"}}
        space = self.run_scene(scene({**wall, "thickness": 0.2, "cells across": 1}, sideways, stages(1.0), supports=sides,
                                     model={"hexahedra": "plain"}, **common), out="space")
        for run in (plane, space):
            self.assertEqual(run.outcome, "equilibrium", run.said)
        for flat, solid in zip(plane.history, space.history):
            size = math.hypot(flat["ux_m of top"], flat["uy_m of top"])
            self.assertLess(abs(flat["ux_m of top"] - solid["ux_m of top"]), 1e-7 * size)
            self.assertLess(abs(flat["uy_m of top"] - solid["uz_m of top"]), 1e-7 * size)
            self.assertLess(abs(solid["uy_m of top"]), 1e-12 * size)
            force = abs(flat["fy_N of ground"])
            self.assertLess(abs(flat["fy_N of ground"] - solid["fz_N of ground"]), 1e-7 * force)

    def stack(self, joints=None, loads=None, steps=None, out="run", **sections):
        """Three boxes of 1 x 0.6 x 0.5 m on each other, nu 0: columns in one dimension."""
        tree = {"mesh": {"type": "wall in space", "wall in space": STACK},
                "materials": {"stone": {"Young modulus": 20e9, "Poisson ratio": 0.0, "density": DENSITY}},
                "joints": {"law": {"friction coefficient": 0.6, **(joints or {})}}, "supports": {"ground": {"on": "ground"}},
                "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, **(loads or {})},
                "steps": {"stages": steps or stages()}, **sections}
        return self.run_scene(xml("stack", tree) + "\n", out=out)

    def test_mortar_gives_way_by_what_weighs_on_it(self):
        stiffness, course = 1e9, 0.5 * DENSITY * GRAVITY  # [Pa/m], [Pa] of a course
        dry = self.stack(out="dry").history[-1]["largest_displacement_m"]
        mortar = self.stack({"normal stiffness": stiffness, "tangential stiffness": stiffness}, out="mortar")
        self.assertEqual(mortar.outcome, "equilibrium", mortar.said)
        way = mortar.history[-1]["largest_displacement_m"] - dry
        self.assertLess(abs(way - (3 + 2 + 1) * course / stiffness), 1e-7 * way)

    def test_a_glued_stack_bears_its_strength_and_no_more(self):
        strength = 3 * 0.5 * DENSITY * GRAVITY  # of the lowest bed, when all above pulls by its weight
        lift = {"lift": {"type": "acceleration", "az": 2 * GRAVITY}}
        for share, outcome in ((0.999, "equilibrium"), (1.001, "collapse")):
            run = self.stack({"cohesion": 10 * strength, "tension strength": strength}, lift,
                             {**stages(), "up": {"loads": {"lift": 0.5 + 0.5 * share}}}, out=outcome)
            self.assertEqual(run.outcome, outcome, run.said)
            if outcome == "equilibrium":
                self.assertEqual(run.warnings, [])  # what pulls alike everywhere is told rightly by any cells

    def test_a_course_that_is_built_later_bears_nothing_before(self):
        own = {"loads": {"weight": 1.0}}
        run = self.stack(steps={"two courses": own, "the third": own},
                         construction={"third": {"blocks": "course 2", "appears": "the third"}},
                         observations={"ground": {"place": "support", "support": "ground"}})
        self.assertEqual(run.outcome, "equilibrium", run.said)
        for row, courses in zip(run.history, (2, 3)):
            weight = (courses * 0.5 + STACK["ground height"]) * 0.6 * DENSITY * GRAVITY
            self.assertLess(abs(row["fz_N of ground"] - weight), 1e-8 * weight)

    def test_a_run_goes_on_where_it_was(self):
        whole = self.run_scene(scene(WALL, push(30, 0.09), stages(1.0)), out="whole")
        self.run_scene(scene(WALL, push(30, 0.09), stages()), out="parts")
        parts = self.run_scene(scene(WALL, push(30, 0.09), stages(1.0)), "--restart", out="parts")
        self.assertEqual(parts.outcome, "equilibrium", parts.said)
        for ours, theirs in zip(whole.history, parts.history):
            self.assertEqual({k: v for k, v in ours.items() if k != "seconds"},
                             {k: v for k, v in theirs.items() if k != "seconds"})

    def test_what_is_of_the_plane_is_refused_by_name(self):
        for words, run in (
                ("scene > model > thickness = 0.5 [m] is of plane meshes",
                 self.run_scene(scene(WALL, {}, stages(), model={"thickness": 0.5}), "--validate")),
                ("scene > loads > lift > az = 1 [m/s2] is across the plane of this mesh",
                 self.run_scene(scene({"courses": 2, "blocks per course": 2}, {"lift": {"type": "acceleration", "az": 1.0}},
                                      stages(), kind="wall", supports={"ground": {"on": "base"}}), "--validate")),
                ("mesh > wall in space > cells along = 3 [-] must be even in running bond",
                 self.run_scene(scene({**WALL, "cells along": 3}, {}, stages()), "--validate"))):
            self.assertEqual(run.code, 2, run.said)
            self.assertIn(words, run.words)


if __name__ == "__main__":
    program.main()

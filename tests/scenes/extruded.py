"""A scene of the plane and its extrusion are one: every load, support and effect by the answer of the plane.

usage: extruded.py PROGRAM MPIEXEC

Set-up    A wall of three by four stones in plane strain, and the same in space: one plain cell thick, with its two faces
          held across. Heights along y become heights along z, a turn from x to y one from x to z. A load at a point is
          shared by the two ends of a line through the wall.
Expected  What either writes of motions, forces of supports and energies is the same.
Tolerance 1e-6 of the largest value of a column, a hundred times what the solver leaves of forces.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
from stones import xml  # noqa: E402

GRAVITY = 9.81
THICKNESS = 0.2  # [m]
MESH = {"courses": 4, "blocks per course": 3, "block length": 0.4, "block height": 0.2, "cells along": 2, "cells up": 2}
SEEN = {"corner": {"x": 1.2, "y": 0.8, "tolerance": 1e-6, "blocks": "course 3"}, "top": {"place": "mean", "blocks": "course 3"},
        "foot": {"place": "support", "support": "foot"}}
WEIGHT = {"weight": {"type": "self weight", "gravity": GRAVITY}}
OWN = {"loads": {"weight": 1.0}}
RELATIVE = 1e-6
# Where three stones meet their points can share a force in many ways, and what friction holds in an impact hangs on how
# they do. In time the stones are glued, so that the two scenes go one way.
GLUED = {"cohesion": 1e6, "tension strength": 1e6}


def plane(loads=None, stages=None, joints=None, **sections):
    """A scene as a tree; stages are own weight, and then the loads too, unless told otherwise."""
    loads = loads or {}
    stages = stages or {"own weight": OWN, "loads": {"loads": {"weight": 1.0, **{name: 1.0 for name in loads}}}}
    return {"mesh": {"type": "wall", "wall": dict(MESH)}, "model": {"plane": "strain", "thickness": THICKNESS},
            "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"law": {"friction coefficient": 0.6, **(joints or {})}}, "supports": {"foot": {"on": "base"}},
            "loads": {**WEIGHT, **loads}, "selection": {"mode": "all"}, "observations": dict(SEEN),
            "steps": {"stages": stages}, **{name.replace("_", " "): section for name, section in sections.items()}}


def upright(tree):
    """Keys along y become keys along z."""
    turned = {}
    for key, value in tree.items():
        words = {"ay": "az", "ty": "tz", "uy": "uz", "fy": "fz", "vy": "vz", "y": "z", "about y": "about z",
                 "y record": "z record", "y column": "z column"}
        turned[words.get(key, key)] = value
    if "rotation" in turned:
        turned.update({"axis y": -1.0, "axis z": 0.0})
    return turned


def in_space(tree):
    tree = dict(tree)
    tree["mesh"] = {"type": "wall in space", "wall in space": {**tree["mesh"]["wall"], "thickness": THICKNESS, "cells across": 1}}
    tree["model"] = {"hexahedra": "plain"}
    sides = {side: {"on": side, "components": "y"} for side in ("front", "back")}
    held = {"x": "x", "y": "z", "all": "all"}
    tree["supports"] = {**{n: {**s, "components": held[s.get("components", "all")]} for n, s in tree["supports"].items()}, **sides}
    loads, factors = {}, {}
    for name, load in tree["loads"].items():
        load = upright(load)
        if load["type"] != "point load":
            loads[name] = load
            continue
        for end, y in (("front", 0.0), ("back", THICKNESS)):
            loads[f"{name} {end}"] = {**load, "y": y, **{f: load[f] / 2 for f in ("fx", "fz") if f in load}}
        factors[name] = [f"{name} front", f"{name} back"]
    tree["loads"] = loads
    tree["observations"] = {name: upright(place) for name, place in tree["observations"].items()}
    if "initial velocities" in tree:
        tree["initial velocities"] = {name: upright(velocity) for name, velocity in tree["initial velocities"].items()}
    stages = {}
    for name, stage in tree["steps"]["stages"].items():
        there = {}
        for load, factor in stage["loads"].items():
            there.update({part: factor for part in factors.get(load, [load])})
        stages[name] = {**stage, "loads": there}
    tree["steps"] = {**tree["steps"], "stages": stages}
    return tree


class Extruded(program.SceneTest):
    def compare(self, tree, extruded=None, only=""):
        """Columns whose name ends in `only`, of a scene and of its extrusion."""
        flat = self.run_scene(xml("plane", tree) + "\n", out="plane")
        solid = self.run_scene(xml("space", extruded or in_space(tree)) + "\n", out="space")
        for run in (flat, solid):
            self.assertEqual(run.outcome, "equilibrium", run.said)
        self.assertEqual(len(flat.history), len(solid.history))
        compared = 0
        for column in flat.history[0]:
            other = column
            if column[:2] in ("uy", "vy", "fy") and " of " in column:
                other = column[0] + "z" + column[2:]
            if not column.endswith(only) or not (" of " in column or column.endswith(("_J", "displacement_m"))):
                continue
            ours, theirs = [row[column] for row in flat.history], [row[other] for row in solid.history]
            size = self.size(column, flat.history)
            for a, b in zip(ours, theirs):
                self.assertTrue(abs(a - b) <= RELATIVE * size or math.isnan(a) and math.isnan(b),
                                f"{column}: {ours} in the plane, {theirs} in space")
            compared += any(v != 0 for v in ours)
        self.assertGreaterEqual(compared, 4 if only else 7)

    @staticmethod
    def size(column, rows):
        """The largest of its kind: a motion beside all motions, a force beside all forces, an energy beside all."""
        kind = column.split(" of ")[0][:1] if " of " in column else column[-2:]
        alike = [c for c in rows[0] if (" of " in c and c[:1] == kind) or (" of " not in c and c.endswith(kind))]
        return max((abs(row[c]) for row in rows for c in alike if not math.isnan(row[c])), default=0.0)

    def test_tractions_and_pressures(self):
        self.compare(plane({"wind": {"type": "traction", "on": "left", "tx": 900.0, "ty": -300.0},
                            "jack": {"type": "traction", "on": "top", "pressure": 2e4}}))

    def test_a_force_at_a_point(self):
        self.compare(plane({"load": {"type": "point load", "x": 0.8, "y": 0.8, "fx": 150.0, "fy": -900.0, "blocks": "course 3"}}))

    def test_people_on_a_part_of_the_top(self):
        self.compare(plane({"crowd": {"type": "crowd", "on": "top", "intensity": 2e4, "x from": 0.3, "x to": 0.9}}))

    def test_axles_along_the_top(self):
        # One line of wheels along the middle would bend what is between; two along the faces do not.
        train = {"type": "moving train", "on": "top", "axle loads": "900, 600", "spacings": "0.35", "position": 0.75}
        tree = plane({"train": train}, {"own weight": OWN, "train": {"loads": {"weight": 1.0, "train": 1.0}}})
        solid = in_space(tree)
        solid["loads"]["train"].update({"y": THICKNESS / 2, "gauge": THICKNESS})
        self.compare(tree, solid)

    def test_soil_against_an_end(self):
        self.compare(plane({"soil": {"type": "earth pressure", "on": "left", "surface": 0.7, "surcharge": 500.0, "unit weight": 3e3}}))

    def test_water_on_both_sides_and_in_the_joints(self):
        self.compare(plane({"left": {"type": "water pressure", "on": "left", "level": 0.5},
                            "right": {"type": "water pressure", "on": "right", "level": 0.35},
                            "lift": {"type": "buoyancy", "blocks": "course 0", "level": 0.2}}))

    def test_heat(self):
        self.compare(plane({"sun": {"type": "temperature", "blocks": "course 3", "change": 30.0}}))

    def test_a_support_that_settles_and_turns(self):
        self.compare(plane({"move": {"type": "settlement", "support": "foot", "ux": 1e-4, "uy": -2e-3, "rotation": 2e-3}}))
        self.compare(plane({"move": {"type": "settlement", "support": "foot", "rotation": 2e-3, "about x": 0.3, "about y": -1.0}}))

    def test_a_support_that_turns_far(self):
        # By 9 degrees, in two steps: stones are followed, and reactions work along an arc.
        turning = {"type": "settlement", "support": "foot", "ux": 0.05, "uy": -0.02, "rotation": 0.16}
        stages = {"own weight": OWN, "half": {"loads": {"weight": 1.0, "turning": 0.5}},
                  "all": {"loads": {"weight": 1.0, "turning": 1.0}}}
        tree = plane({"turning": turning}, stages)
        tree["model"]["rotations"] = "finite"
        solid = in_space(tree)
        solid["model"]["rotations"] = "finite"
        self.compare(tree, solid)

    def test_a_side_that_slides(self):
        tree = plane({"move": {"type": "settlement", "support": "side", "ux": 1e-4}})
        tree["supports"]["side"] = {"on": "left", "components": "x"}
        self.compare(tree)

    def test_ground_that_moves_by_a_record(self):
        record = self.folder / "shake.txt"
        rows = [(0.002 * k, 0.8 * math.sin(2 * math.pi * k / 12), 0.3 * math.sin(2 * math.pi * k / 5)) for k in range(26)]
        record.write_text("".join(f"{t:.6f} {x:.9f} {y:.9f}\n" for t, x, y in rows), encoding="utf-8")
        shake = {"type": "ground motion", "x record": str(record), "y record": str(record), "time column": 1, "x column": 2,
                 "y column": 3}
        time = {"duration": 0.05, "time step": 0.0025, "loads": {"weight": 1.0, "shake": 1.0}}
        self.compare(plane({"shake": shake}, {"own weight": OWN, "shaking": time}, GLUED))

    def test_stones_that_fly_off(self):
        # Without their weight stones spring apart and rattle, so that round-off soon decides who touches whom; the mass
        # centre of the course does not know of it.
        flight = {"top": {"blocks": "course 3", "vx": 0.2, "vy": 0.5, "rotation": 0.3}}
        self.compare(plane(stages={"own weight": OWN, "flight": {"duration": 0.02, "time step": 0.001, "loads": {"weight": 1.0}}},
                           initial_velocities=flight), only="of top")

    def test_a_pulse_of_wind(self):
        wind = {"type": "traction", "on": "left", "tx": 4e3, "time function": {"type": "pulse", "duration": 0.02}}
        self.compare(plane({"wind": wind}, {"own weight": OWN, "gust": {"duration": 0.03, "time step": 0.0015,
                                                                        "loads": {"weight": 1.0, "wind": 1.0}}}, GLUED))

    def test_lime_mortar(self):
        self.compare(plane({"push": {"type": "acceleration", "ax": 0.15 * GRAVITY}},
                           joints={"normal stiffness": 2e9, "tangential stiffness": 1e9, "cohesion": 1e5, "tension strength": 5e4}))

    def test_mortar_that_softens(self):
        mortar = {"cohesion": 1e5, "tension strength": 5e4, "fracture energy": 10.0, "shear fracture energy": 50.0}
        stages = {"own weight": OWN, **{name: {"loads": {"weight": 1.0, "push": share}}
                                         for name, share in (("half", 0.5), ("push", 1.0), ("back", 0.2))}}
        self.compare(plane({"push": {"type": "acceleration", "ax": 1.6 * GRAVITY}}, stages, mortar))

    def test_a_course_that_appears_and_one_that_goes(self):
        stages = {"three": OWN, "four": OWN, "three again": OWN}
        self.compare(plane(stages=stages, construction={"top": {"blocks": "course 3", "appears": "four", "disappears": "three again"}}))

    def both(self, tree):
        """A scene and its extrusion, run."""
        return [self.run_scene(xml(name, t) + "\n", out=name) for name, t in (("plane", tree), ("space", in_space(tree)))]

    def test_what_joints_carry(self):
        # Depth and sides of the plane are those of space; held sides bear what would widen, and no friction acts across.
        flat, solid = self.both(plane({"push": {"type": "acceleration", "ax": 0.3 * GRAVITY}}))
        ours, theirs = flat.table("joints.csv"), solid.table("joints.csv")
        self.assertEqual([(r["block_i"], r["block_j"]) for r in ours], [(r["block_i"], r["block_j"]) for r in theirs])
        largest = max(abs(r["normal_force_N"]) for r in ours)
        told = {"edge_margin": 0, "friction_margin": 0, "eccentricity_m": 0}
        within = 1e-3  # [-], [m] how points share a force where three stones meet hangs on the way they were closed
        for a, b in zip(ours, theirs):
            if a["normal_force_N"] < 0.05 * largest:
                continue
            for column in ("x_m", "edge_x_m", "through_x_m", "opening_m", *told):
                size = abs(a[column]) if column == "eccentricity_m" else a[column]
                self.assertTrue(abs(size - b[column]) <= within or math.isnan(a[column]) and math.isnan(b[column]), (column, a, b))
                if column in told:
                    told[column] += not math.isnan(a[column])
            for column, other in (("force_x_N", "force_x_N"), ("force_y_N", "force_z_N"), ("normal_force_N", "normal_force_N")):
                self.assertLessEqual(abs(a[column] - b[other]), 1e-4 * largest, (column, a, b))
            self.assertLessEqual(abs(a["length_m"] * THICKNESS - b["area_m2"]), 1e-12)
            for column in ("sides", "hinge", "slides"):
                self.assertEqual(a[column], b[column], (a, b))
        self.assertGreater(min(told.values()), 5)
        for key in ("hinges", "sliding_joints"):
            self.assertEqual(flat.result["statics"][key], solid.result["statics"][key])

    def test_joints_with_few_cells(self):
        for push, strength in ((1.0, 2e4), (1.5, 3e4)):
            tree = plane({"push": {"type": "acceleration", "ax": push * GRAVITY}}, joints={"tension strength": strength, "cohesion": 1e6})
            told = [[w for w in run.result["warnings"] if w["what"] == "coarse_joint"] for run in self.both(tree)]
            self.assertEqual([len(t) for t in told], [1, 1], told)
            ours, theirs = told[0][0], told[1][0]
            self.assertEqual((ours["where"], ours["when"]), (theirs["where"], theirs["when"]))
            self.assertLessEqual(abs(ours["how_much"] - theirs["how_much"]), 1e-5 * ours["how_much"])
            self.assertIn(" x 1 cells along it", theirs["text"])

    def test_so_many_stones_that_multigrid_groups_their_nodes(self):
        """Of groups in which all are held across nothing is left of motions across."""
        tree = plane({"wind": {"type": "traction", "on": "left", "tx": 900.0}})
        tree["mesh"] = {"type": "wall", "wall": {**MESH, "courses": 12, "blocks per course": 20}}
        tree["observations"]["top"] = {"place": "mean", "blocks": "course 11"}
        self.compare(tree)
        split = self.run_scene(xml("space", in_space(tree)) + "\n", out="split", ranks=2)
        self.assertEqual(split.outcome, "equilibrium", split.said)

    def test_the_factor_of_a_push(self):
        tree = plane({"push": {"type": "acceleration", "ax": GRAVITY}}, {"own weight": OWN}, load_factor={"pattern": {"push": 1.0}, "accuracy": 0.01})
        flat = self.run_scene(xml("plane", tree) + "\n", out="plane")
        solid = self.run_scene(xml("space", in_space(tree)) + "\n", out="space")
        for run in (flat, solid):
            self.assertEqual(run.code, 0, run.said)
        ours, theirs = flat.result["collapse"], solid.result["collapse"]
        self.assertLessEqual(theirs["lower"], ours["upper"] * (1 + 1e-9))
        self.assertGreaterEqual(theirs["upper"], ours["lower"] * (1 - 1e-9))


if __name__ == "__main__":
    program.main()

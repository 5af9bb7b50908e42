"""Stones from files: from a scene to its results and its report, and what is said of files that are wrong.

usage: stones_in_space.py PROGRAM MPIEXEC

Set-up    A wall of boxes in bond and a column of boxes on a slab; an arch of wedges; a stone with a step under another and a box on
          a box side by side, which become tetrahedra and hexahedra; files of others, whose folder VOUSSOIR_STONES names.
Expected  Reactions are the weight, and pressure times area; a column with friction 0.6 tips where the push passes its edge;
          the same on any number of ranks and in parts; a file with a face missing, a stone twice or stones in each other
          is refused, and the stone is named.
Tolerance Reactions 1e-8 of the weight, the tolerance of the solver.
"""

import math
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import h5py  # noqa: E402  (folders of their own)
import meshio.xdmf  # noqa: E402
import numpy as np  # noqa: E402
import program  # noqa: E402
import solids  # noqa: E402
from stones import xml  # noqa: E402

DENSITY, GRAVITY = 2000.0, 9.81
OTHERS = os.environ.get("VOUSSOIR_STONES")
COLUMN = {"slab": solids.box((-0.5, -0.5, -0.2), (1.5, 1.1, 0)),
          **{f"drum {k}": solids.box((0, 0, k), (1, 0.6, k + 1)) for k in range(2)}}
SIDE_BY_SIDE = {"foot": solids.box((0, 0, 0), (1, 1, 1)), "head": solids.box((0, 0, 1), (1, 1, 2)),
                "step": solids.prism([(3, 0), (4, 0), (4, 1.5), (3.5, 1.5), (3.5, 1), (3, 1)], 0.0, 1.0),
                "cap": solids.prism([(3, 1), (3.5, 1), (3.5, 1.5), (4, 1.5), (4, 2), (3, 2)], 0.0, 1.0)}


def wall(courses=3, long=3):
    """Boxes of 0.4 x 0.2 x 0.2 m in running bond."""
    stones = {}
    for c in range(courses):
        ends = [0.4 * k for k in range(long + 1)] if c % 2 == 0 else [0.0, *[0.4 * k + 0.2 for k in range(long)], 0.4 * long]
        for k, (a, b) in enumerate(zip(ends, ends[1:])):
            stones[f"stone {c}.{k}"] = solids.box((a, 0, 0.2 * c), (b, 0.2, 0.2 * c + 0.2))
    return stones


def scene(supports=None, loads=None, stages=None, friction=0.6, mesh=None, **sections):
    tree = {"mesh": {"type": "stones", "stones": {"file": "stones.obj", **(mesh or {})}},
            "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": DENSITY}},
            "joints": {"dry": {"friction coefficient": friction}},
            "supports": supports or {"ground": {"on": "base"}},
            "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, **(loads or {})},
            "steps": {"stages": stages or {"own weight": {"loads": {"weight": 1.0}}}},
            "observations": {"ground": {"place": "support", "support": "ground"}}, **sections}
    return xml("stones", tree) + "\n"


def push(degrees, share):
    """A share of the weight in a direction from x to y."""
    a = math.radians(degrees)
    return {"push": {"type": "acceleration", "ax": share * GRAVITY * math.cos(a), "ay": share * GRAVITY * math.sin(a)}}


class StonesFromFiles(program.SceneTest):
    def run_stones(self, stones, text, *options, **more):
        (self.folder / "stones.obj").write_text(solids.obj(stones) if isinstance(stones, dict) else stones, encoding="utf-8")
        return self.run_scene(text, *options, **more)

    def check_reaction(self, run, weight, row=-1, tolerance=1e-8):
        self.assertEqual(run.outcome, "equilibrium", run.said)
        found = run.history[row]
        self.assertLess(abs(found["fz_N of ground"] - weight), tolerance * weight, run.said)
        return found

    def test_reactions_are_the_weight(self):
        weight = 1.2 * 0.2 * 0.6 * DENSITY * GRAVITY
        for cells, words in (("by shape", "10 stones of hexahedra, 0 of tetrahedra"),
                             ("tetrahedra", "0 stones of hexahedra, 10 of tetrahedra")):
            for mode in ("all", "adaptive"):
                run = self.run_stones(wall(), scene(mesh={"cells": cells}, selection={"mode": mode}), out=f"{cells} {mode}"[3:])
                row = self.check_reaction(run, weight)
                self.assertLess(abs(row["fx_N of ground"]) + abs(row["fy_N of ground"]), 1e-8 * weight)
                self.assertIn(words, run.said)

    def test_an_arch_of_wedges_thrusts(self):
        stones = solids.arch(5.0, 1.0, 0.8, 9, 150.0)
        volume = 0.5 * (5.5 ** 2 - 4.5 ** 2) * math.sin(math.radians(150 / 9)) * 0.8 * 9  # of chords
        held = {"ground": {"on": "faces", "blocks": "one neighbour"}}
        run = self.run_stones(stones, scene(held))
        row = self.check_reaction(run, volume * DENSITY * GRAVITY)
        self.assertLess(abs(row["fx_N of ground"]), 1e-7 * volume * DENSITY * GRAVITY)
        self.assertIn("8 joints of 8 pairs of stones", run.said)
        self.assertIn('stones with one neighbour: voussoir 0, voussoir 8', run.words)

    def test_pressure_acts_on_the_faces_of_both_kinds(self):
        load = {"pressure": {"type": "traction", "on": "top", "pressure": 1e5}}
        both = {"own weight": {"loads": {"weight": 1.0, "pressure": 1.0}}}
        run = self.run_stones(SIDE_BY_SIDE, scene(loads=load, stages=both))
        self.check_reaction(run, 4 * DENSITY * GRAVITY + 2 * 1e5)
        self.assertIn("2 stones of hexahedra, 2 of tetrahedra", run.said)

    def test_supports_and_loads_find_stones_by_name(self):
        held = {"ground": {"on": "base", "blocks": "foot"}, "other": {"on": "base", "blocks": "step"}}
        load = {"pressure": {"type": "traction", "on": "top", "blocks": "cap", "pressure": 1e5}}
        both = {"own weight": {"loads": {"weight": 1.0, "pressure": 1.0}}}
        run = self.run_stones(SIDE_BY_SIDE, scene(held, load, both))
        self.check_reaction(run, 2 * DENSITY * GRAVITY)  # the pressure is on the other pair
        lone = self.run_stones(SIDE_BY_SIDE, scene({"ground": {"on": "base", "blocks": "foot"}}), "--validate")
        self.assertEqual(lone.code, 2)
        self.assertIn("stone step and 1 more block joined to it have no support", lone.words)

    def test_a_column_tips_where_statics_says(self):
        for cells, degrees, limit in (("by shape", 0, 0.5), ("tetrahedra", 90, 0.3)):
            stages = {"own weight": {"loads": {"weight": 1.0}},
                      **{f"push {s}": {"loads": {"weight": 1.0, "push": s}} for s in (0.999, 1.001)}}
            held = {"ground": {"on": "faces", "blocks": "slab"}}
            run = self.run_stones(COLUMN, scene(held, push(degrees, limit), stages, mesh={"cells": cells, "element size": 0.5}),
                                  out=f"{cells}"[3:])
            self.assertEqual(run.outcome, "collapse", run.said)
            stood = [row["stage"] for row in run.history if row["load_factor"] == 1]
            self.assertEqual(stood, ["own weight", "push 0.999"], f"{cells}: stands at 0.999, falls at 1.001")

    def test_tetrahedra_that_swing_keep_their_energy(self):
        glue = {"glue": {"friction coefficient": 0.6, "cohesion": 1e8, "tension strength": 1e8}}
        swing = {"duration": 0.01, "time step": 0.001, "at once": True, "loads": {"weight": 1.0, "push": 0.0}}
        stages = {"pushed": {"loads": {"weight": 1.0, "push": 1.0}}, "let go": swing}
        mesh = {"cells": "tetrahedra", "element size": 0.5}
        run = self.run_stones(COLUMN, scene(loads=push(30, 0.3), stages=stages, mesh=mesh, joints=glue))
        self.assertEqual(run.outcome, "equilibrium", run.said)
        swung = max(row["kinetic_J"] for row in run.history)
        self.assertGreater(swung, 0)
        self.assertLess(max(abs(row["imbalance_in_time_J"]) for row in run.history), 1e-8 * swung)

    def test_units_and_axes_of_the_file(self):
        turned = {name: ([(1000 * y, 1000 * z, 1000 * x) for x, y, z in points], faces) for name, (points, faces) in wall().items()}
        run = self.run_stones(turned, scene(mesh={"unit": 0.001, "up": "y"}))
        self.check_reaction(run, 1.2 * 0.2 * 0.6 * DENSITY * GRAVITY)

    def test_the_same_on_ranks_and_in_parts(self):
        stones = solids.arch(5.0, 1.0, 0.8, 9, 150.0)
        held = {"ground": {"on": "faces", "blocks": "one neighbour"}}
        own, pushed = {"own weight": {"loads": {"weight": 1.0}}}, {"push": {"loads": {"weight": 1.0, "push": 1.0}}}
        text = scene(held, push(90, 0.05), {**own, **pushed})
        whole = self.run_stones(stones, text, out="whole")
        for ranks in (2, 4):
            other = self.run_stones(stones, text, out=f"on {ranks}", ranks=ranks)
            for ours, theirs in zip(whole.history, other.history):
                for key in ("largest_displacement_m", "fy_N of ground", "fz_N of ground"):
                    self.assertLess(abs(ours[key] - theirs[key]), 1e-6 * abs(whole.history[-1][key]), f"{key} on {ranks}")
        self.run_stones(stones, scene(held, push(90, 0.05), own), out="parts")
        parts = self.run_stones(stones, text, "--restart", out="parts")
        self.assertEqual([{k: v for k, v in row.items() if k != "seconds"} for row in whole.history],
                         [{k: v for k, v in row.items() if k != "seconds"} for row in parts.history], parts.said)
        moved = self.run_stones(solids.arch(5.0, 1.1, 0.8, 9, 150.0), text, "--restart", out="parts")
        self.assertEqual(moved.code, 2, "a file of other stones is another structure")

    def test_viewers_and_the_report_show_mixed_cells(self):
        run = self.run_stones(SIDE_BY_SIDE, scene())
        with meshio.xdmf.TimeSeriesReader(run.folder / "fields.xdmf") as reader:
            points, cells = reader.read_points_cells()
            _, at_nodes, in_cells = reader.read_data(0)
        volume = {"hexahedron": 0.0, "tetra": 0.0}
        for block in cells:
            for corners in points[block.data]:
                a, b, c = (corners[k] - corners[0] for k in ((1, 2, 3) if block.type == "tetra" else (1, 3, 4)))
                det = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
                volume[block.type] += det / (6 if block.type == "tetra" else 1)  # hexahedra are boxes here
        for kind in volume:
            self.assertLess(abs(volume[kind] - 2), 1e-12, kind)
        self.assertEqual(at_nodes["displacement [m]"].shape, points.shape)
        self.assertEqual(sum(len(part) for part in in_cells["block"]), sum(len(block.data) for block in cells))
        with h5py.File(run.folder / "fields.h5") as fields:  # the lowest cells bear what lies above
            stress, block = fields["steps/0001/stress"][:, 5], fields["mesh/block_of_cell"][:]
            self.assertLess(abs(stress[block == 0].mean() + 1.5 * DENSITY * GRAVITY), 0.01 * DENSITY * GRAVITY)
        make = pathlib.Path(__file__).resolve().parents[2] / "drivers" / "report" / "make_report.py"
        subprocess.run([sys.executable, "-B", make, run.folder], check=True, capture_output=True)
        page = (run.folder / "report.html").read_text(encoding="utf-8")
        self.assertNotIn("could not be drawn", page)

    def test_what_is_wrong_with_a_file_is_said(self):
        low, high = solids.box((0, 0, 0), (1, 1, 1)), solids.box((0, 0, 1), (1, 1, 2))
        open_stone = (high[0], high[1][:-1])
        deep = solids.box((0, 0, 0.95), (1, 1, 2))
        for words, stones in (
                (("stone \"high\" (stones.obj, line", "is not closed"), {"low": low, "high": open_stone}),
                (("stone \"high\" (stones.obj, line", "lies in each other by more than the joint tolerance"), {"low": low, "high": deep}),
                (("stone \"again\" (stones.obj, line", "lies in each other by more than the joint tolerance"),
                 {"low": low, "high": high, "again": high}),
                (("Line 3 has \"x\" where a number is wanted",), "o a\nv 0 0 0\nv 1 x 0\n"),
                (("Has no faces",), "# nothing\n")):
            run = self.run_stones(stones, scene(), "--validate")
            self.assertEqual(run.code, 2, run.said)
            for word in words:
                self.assertIn(word, run.words)
        for words, mesh in (("scene > mesh > stones > file = \"nowhere.obj\" cannot be found", {"file": "nowhere.obj"}),
                            ("scene > mesh > stones > unit = -1 [m]", {"unit": -1.0}),
                            ("Is no file of stones by its ending", {"file": "stones.xyz"})):
            (self.folder / "stones.xyz").write_text("nothing", encoding="utf-8")
            run = self.run_stones({"low": low}, scene(mesh=mesh), "--validate")
            self.assertEqual(run.code, 2, run.said)
            self.assertIn(words, run.words)

    def test_the_vault_of_the_gallery_is_what_its_script_writes(self):
        top = pathlib.Path(__file__).resolve().parents[2]
        written = self.folder / "cross-vault.obj"
        subprocess.run([sys.executable, "-B", top / "meshes" / "cross_vault.py", written], check=True)
        self.assertEqual(written.read_text(encoding="utf-8"), (top / "meshes" / "cross-vault.obj").read_text(encoding="utf-8"))
        run = self.run_scene(top / "xml" / "cross-vault.xml", "--validate")
        self.assertEqual(run.code, 0, run.said)
        for words in ("520 joints of 488 pairs of stones", "stones with one neighbour: springer 1, springer 2, springer 3, springer 4",
                      "The scene is valid: 185 blocks"):
            self.assertIn(words, run.said)
        self.assertNotIn("WARNING", run.said)

    def test_what_is_doubtful_is_warned_of(self):
        apart = {"low": solids.box((0, 0, 0), (1, 1, 1)), "high": solids.box((0, 0, 1.01), (1, 1, 2))}
        run = self.run_stones(apart, scene({"ground": {"on": "faces"}}))
        self.assertIn("stones_without_joint", run.warnings)
        self.assertIn("open_joints", run.warnings)
        self.assertEqual(run.warnings.count("stones_without_joint"), 1)
        self.assertIn("facing each other open by up to 0.01 m", run.words)


@program.unittest.skipUnless(OTHERS, "VOUSSOIR_STONES names no folder with files of others")
class StonesOfOthers(program.SceneTest):
    def own_weight(self, file, volume, supports, mesh, mode, ranks=1):
        run = self.run_scene(scene(supports, mesh={"file": f"{OTHERS}/{file}", **mesh}, selection={"mode": mode}),
                             out=f"{mode} {ranks}", ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        with h5py.File(run.folder / "fields.h5") as fields:
            corners = fields["mesh/coordinates"][:][fields["mesh/cells"][:, :4]]
        sides = corners[:, 1:] - corners[:, :1]
        inside = abs(np.linalg.det(sides).sum()) / 6
        self.assertLess(abs(inside - volume), 1e-4 * volume)
        weight = inside * DENSITY * GRAVITY
        self.assertLess(abs(run.history[-1]["fz_N of ground"] - weight), 1e-8 * weight)

    def test_cross_vault(self):
        springers = {"ground": {"on": "base", "blocks": "one neighbour"}}
        mesh = {"unit": 0.025, "joint tolerance": 1e-3, "element size": 0.4}
        for mode, ranks in (("all", 1), ("adaptive", 2), ("adaptive", 4)):
            self.own_weight("compas_dem_crossvault.obj", 55.0665, springers, mesh, mode, ranks)

    def test_bridge(self):
        self.own_weight("compas_cra_bridge.json", 0.9118, {"ground": {"on": "base"}}, {"element size": 0.15}, "adaptive")


if __name__ == "__main__":
    program.main()

"""The same structure wherever the drawing has its origin.

usage: far_from_the_origin.py PROGRAM MPIEXEC

Set-up    Small structures drawn at the origin and again in survey coordinates, and at 1e7 m, places of loads and
          observations with them: stones on a foot that turns far, nine stones under every load that has a place, stones
          that turn in flight and a cart that crosses, stones whose common sides are found by the reader.
Expected  The same reactions, motion, energies and joints; places shifted by as much as the origin was.
Tolerance 1e-6, of the largest where sums are small. Places at 1e7 m are known to 2e-9 m, of cells of 50 mm that is 4e-8.
"""

import csv
import math
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hard" / "ground"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "restart"))
from drawing import Drawing, grid  # noqa: E402  (folders of their own)
import scenes  # noqa: E402
from runs import empty, run_scene  # noqa: E402

PROGRAM = MPIEXEC = None
# In time a joint that closes passes a difference on some times over.
SAME, SAME_IN_TIME = 1e-6, 1e-5
SURVEY, FAR = (412345.25, 5071234.75), (1e7, -1e7)


def run(name, made, *settings, ranks=1):
    """Folder and result.json of a run."""
    folder = empty(f"far_from_the_origin/{name}")
    (folder / "scene").mkdir(parents=True)
    path = scenes.write(made, folder / "scene")
    return folder / "run", run_scene(PROGRAM, MPIEXEC, folder / "run", path, *settings, ranks=ranks)


def table(path):
    """Columns of a table of numbers; what is no number is left out."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    columns = {}
    for key in rows[0]:
        try:
            columns[key] = np.array([float(row[key] or "nan") for row in rows])
        except ValueError:
            pass
    return columns


class FarFromTheOrigin(unittest.TestCase):
    def same(self, one, other, size=None, within=SAME):
        """Two numbers or arrays are equal to 1e-6 of the larger, or of a size."""
        one, other = np.asarray(one, float), np.asarray(other, float)
        np.testing.assert_array_equal(np.isnan(one), np.isnan(other))
        largest = size or max(np.nanmax(abs(one), initial=0), np.nanmax(abs(other), initial=0))
        self.assertLessEqual(np.nanmax(abs(one - other), initial=0), within * largest)

    def compare(self, near, far, shift, size=1.0):
        """Two runs of one structure; size [m] of it."""
        (near_folder, near), (far_folder, far) = near, far
        self.assertEqual(near["outcome"], far["outcome"])
        self.assertEqual([w["what"] for w in near["warnings"]], [w["what"] for w in far["warnings"]])
        histories = [table(folder / "history.csv") for folder in (near_folder, far_folder)]
        self.assertEqual(len(histories[0]["step"]), len(histories[1]["step"]))
        moved = max(np.nanmax(abs(histories[0][key])) for key in histories[0] if key.startswith(("u", "largest_displ")))
        within = SAME_IN_TIME if "kinetic_J" in histories[0] and np.any(histories[0]["kinetic_J"]) else SAME
        # Work is the sum over nodes of forces, known to 1e-8 of the largest, times ways, and may come to next to nothing.
        energy = max(np.max(abs(histories[0][key])) for key in ("elastic_J", "kinetic_J", "external_work_J"))
        reactions = near.get("statics", {}).get("reactions", {}).values()
        energy = max([energy, *(math.hypot(r["x_N"], r["y_N"]) * moved for r in reactions)])
        for key in histories[0]:
            if key.endswith("_J"):
                self.same(histories[0][key], histories[1][key], energy, within)
            elif key.startswith("u") or key == "largest_displacement_m":
                self.same(histories[0][key], histories[1][key], moved, within)
        if "statics" not in near:
            return
        one, other = near["statics"]["reactions"], far["statics"]["reactions"]
        force = max(math.hypot(r["x_N"], r["y_N"]) for r in one.values())
        for name, reaction in one.items():
            for key in ("x_N", "y_N"):
                self.same(reaction[key], other[name][key], force)
            for axis, key in enumerate(("through_x_m", "through_y_m")):
                self.same(reaction[key], other[name][key] - shift[axis], size)
        joints = [table(folder / "joints.csv") for folder in (near_folder, far_folder)]
        for key in joints[0]:
            axis = {"x_m": 0, "y_m": 1, "through_x_m": 0, "through_y_m": 1}.get(key)
            if axis is not None:
                self.same(joints[0][key], joints[1][key] - shift[axis], size)
            elif key.endswith("_N"):
                self.same(joints[0][key], joints[1][key], force)
            elif key in ("length_m", "eccentricity_m"):
                self.same(joints[0][key], joints[1][key], size)
            elif key in ("hinge", "slides", "block_i", "block_j"):
                np.testing.assert_array_equal(joints[0][key], joints[1][key])

    def shifted(self, name, made, places=(SURVEY, FAR), size=1.0, ranks=(1,)):
        """Runs a scene, made for a shift of the origin, near and far; the result near."""
        near = run(f"{name} near", made((0.0, 0.0)))
        for number, shift in enumerate(places):
            for count in ranks:
                with self.subTest(name, shift=shift, ranks=count):
                    self.compare(near, run(f"{name} {number} {count}", made(shift), ranks=count), shift, size)
        return near[1]

    def test_stones_on_a_foot_that_turns_far(self):
        def made(shift, **about):
            return scenes.scene(grid(1, 3, 0.2, 0.1, 0.05, offset=shift), friction=0.8, supports=("ground",),
                                loads={"tilt": {"type": "settlement", "support": "ground", "rotation": -0.1, **about}},
                                stages={"own weight": {"loads": {"weight": 1.0}},
                                        "tilt": {"increments": 2, "loads": {"tilt": 1.0}}},
                                stone={"Young modulus": 5e10}, model={"rotations": "finite"})

        near = self.shifted("tilt", made, ranks=(1, 4))
        corner = self.shifted("corner", lambda shift: made(shift, **{"about x": shift[0], "about y": shift[1]}),
                              places=(SURVEY,))
        for result in (near, corner):  # nothing but the weight of three stones
            reaction = result["statics"]["reactions"]["ground"]
            self.same(reaction["y_N"], 0.06 * 2000 * 9.81)
            self.same(reaction["x_N"], 0, reaction["y_N"])
        # About its own middle, which is the default, the foot stays where it is.
        middle = self.shifted("middle", lambda shift: made(shift, **{"about x": shift[0] + 0.1, "about y": shift[1]}),
                              places=(SURVEY,))
        self.same(near["largest_displacement_m"], middle["largest_displacement_m"])
        self.assertGreater(corner["largest_displacement_m"], 1.01 * middle["largest_displacement_m"])

    def test_loads_and_observations_have_places(self):
        def made(shift):
            x, y = shift
            loads = {"post": {"type": "point load", "x": x + 0.8, "y": y + 0.9, "fx": 300.0, "fy": -2000.0},
                     "soil": {"type": "earth pressure", "on": "left", "surface": y + 0.75},
                     "flood": {"type": "water pressure", "on": "right", "level": y + 0.5},
                     "lift": {"type": "buoyancy", "level": y + 0.5},
                     "crowd": {"type": "crowd", "on": "top", "x from": x + 0.1, "x to": x + 0.7},
                     "cart": {"type": "moving train", "on": "top", "axle loads": "1e3, 2e3", "spacings": "0.3",
                              "position": x + 1.0},
                     "tilt": {"type": "settlement", "support": "ground", "rotation": 1e-3, "uy": -1e-3}}
            made = scenes.scene(grid(3, 3, 0.4, 0.3, 0.1, offset=shift), supports=("ground",), loads=loads,
                                stages={"own weight": {"loads": {"weight": 1.0}},
                                        "all": {"loads": {name: 1.0 for name in loads}}})
            made["observations"] = {"corner": {"x": x + 1.2, "y": y + 0.9}, "mean": {"place": "mean"}}
            return made

        self.shifted("loads", made, size=1.5)

    def test_sides_that_the_reader_finds(self):
        def made(shift):
            drawing = Drawing(0.05, offset=shift, apart=True)
            drawing.box(0.0, 0.0, 0.3, 0.1, bottom="ground")
            drawing.box(0.0, 0.1, 0.1, 0.1)
            drawing.box(0.1, 0.1, 0.2, 0.1)
            return scenes.pushed(drawing)

        near = self.shifted("apart", made, places=(SURVEY,))["statics"]["reactions"]["ground"]
        # At 1e7 m gmsh divides curves to 3e-6 m: nodes are found to coincide, the forces are the same.
        far = run("apart far", made(FAR))[1]["statics"]["reactions"]["ground"]
        self.same([near["x_N"], near["y_N"]], [far["x_N"], far["y_N"]])

    def test_motion_in_time(self):
        def made(shift):
            x, _ = shift
            loads = {"cart": {"type": "moving train", "on": "top", "axle loads": "2e3", "position": x - 0.01, "speed": 30.0}}
            made = scenes.scene(grid(2, 1, 0.4, 0.3, 0.1, offset=shift), supports=("ground",), loads=loads,
                                stages={"own weight": {"loads": {"weight": 1.0}},
                                        "passing": {"duration": 0.02, "time step": 5e-4, "loads": {"cart": 1.0}}})
            made["observations"] = {"corner": {"x": shift[0] + 0.8, "y": shift[1] + 0.3}}
            return made

        self.shifted("cart", made, places=(SURVEY,))

        def flying(shift):
            made = scenes.scene(grid(1, 1, 0.4, 0.3, 0.1, offset=shift), supports={},
                                stages={"flight": {"duration": 0.02, "time step": 1e-3}})
            made["initial velocities"] = {"spin": {"rotation": 3.0, "vx": 1.0}}
            made["observations"] = {"mean": {"place": "mean"}, "corner": {"x": shift[0], "y": shift[1]}}
            return made

        near = self.shifted("spin", flying)
        mass = 0.4 * 0.3 * 2000  # which turns about its centre, where nobody says about what
        self.same(near["energy"]["external_work_J"], mass / 2 + mass * (0.4**2 + 0.3**2) / 12 * 3.0**2 / 2)

    def test_how_far_an_arch_bears(self):
        def made(shift):
            drawing = Drawing(0.28, offset=shift)  # three cells along, two across
            ray = [(-math.cos(k * math.pi / 8), math.sin(k * math.pi / 8)) for k in range(9)]
            for a, b in zip(ray, ray[1:]):
                drawing.stone([tuple(2.0 * x for x in a), tuple(2.5 * x for x in a), tuple(2.5 * x for x in b),
                               tuple(2.0 * x for x in b)], sets=("ring",))
            for side, end in (("left", ray[0]), ("right", ray[-1])):
                drawing.name(side, tuple(2.0 * x for x in end), tuple(2.5 * x for x in end))
            return scenes.scene(drawing, supports=("left", "right"), loads={"push": {"type": "acceleration", "ax": 9.81}},
                                load_factor={"accuracy": 0.02, "pattern": {"push": 1.0}})

        near = run("arch near", made((0.0, 0.0)))[1]["collapse"]
        far = run("arch far", made(SURVEY))[1]["collapse"]
        self.assertTrue(near["sharp"] and far["sharp"])
        self.same([near["lower"], near["upper"]], [far["lower"], far["upper"]])


if __name__ == "__main__":
    PROGRAM, MPIEXEC = (str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

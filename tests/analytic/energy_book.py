"""What sliding costs in load steps, however long they are.

usage: energy_book.py PROGRAM MPIEXEC

Set-up    A stone of 9810 N that a jack moves to and fro on its bed, friction 0.6: on one joint and on two bearers, dry and
          on mortar; under a weight that comes while it moves; a stone too rough to slip; two piers that lean.
Expected  Friction takes force times way, less the elastic way: that of a few micrometres of the stones, or of the mortar,
          which gives way by 2 F / (k A) at every reversal. It never gives anything back. The jack does that work and the
          elastic energy, so the book closes; where the pressure grows while the stone slips, work is exact, friction that of
          the pressure at the end, and the imbalance is the difference.
Tolerance 0.1 % of friction: stones of 10 GPa give way by 2 micrometres of 4 mm. What never slips: to round-off.
"""

import csv
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hard" / "ground"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "restart"))
from drawing import Drawing  # noqa: E402  (folders of their own)
import scenes  # noqa: E402
from runs import empty, run_scene  # noqa: E402

PROGRAM = MPIEXEC = None
WEIGHT = 0.5 * 2000 * 9.81  # N, of a stone 1 m x 0.5 m
FRICTION = 0.6
MOVES = (2, -2, 4, -4, 0)  # mm
WAY = 24e-3  # m


def stone_on(*bearers):
    """A stone 1 m wide on bearers (from, to), with a jack on its right side."""
    drawing = Drawing(0.125)
    levels = sorted({x for bearer in bearers for x in bearer})
    for left, right in bearers:
        drawing.box(left, -0.25, right - left, 0.25, sets=("bed",), bottom="ground")
    bottom = [(x, 0.0) for x in levels]
    drawing.stone([*bottom, (1.0, 0.5), (0.0, 0.5)], corners=None if len(bottom) == 2 else (), sets=("stone",))
    drawing.name("jack", (1.0, 0.0), (1.0, 0.5))
    drawing.name("top", (1.0, 0.5), (0.0, 0.5))
    return drawing


def moved(drawing, moves=MOVES, increments=1, **more):
    stages = {"own weight": {"loads": {"weight": 1.0}}}
    for number, move in enumerate(moves, 1):
        stages[f"move {number}"] = {"increments": increments, "loads": {"move": move / 1000}}
    how = dict(friction=FRICTION, stages=stages, supports={"ground": {"on": "ground"}, "jack": {"on": "jack", "components": "x"}},
               loads={"move": {"type": "settlement", "support": "jack", "ux": 1.0}})
    return scenes.scene(drawing, **{**how, **more})


def run(name, scene, *settings, ranks=1):
    """The energies of a run; friction has never fallen."""
    folder = empty(f"energy_book/{name}")
    (folder / "scene").mkdir(parents=True)
    result = run_scene(PROGRAM, MPIEXEC, folder / "run", scenes.write(scene, folder / "scene"), *settings, ranks=ranks)
    with open(folder / "run" / "history.csv", encoding="utf-8") as file:
        friction = [float(row["friction_J"]) for row in csv.DictReader(file)]
    assert all(a <= b for a, b in zip([0.0] + friction, friction)), friction
    energy = {key.removesuffix("_J"): value for key, value in result["energy"].items()}
    print(name, {key: float(f"{value:.6g}") for key, value in energy.items() if value})
    return energy


class EnergyBook(unittest.TestCase):
    def check(self, energy, way, within=1e-3):
        expected = FRICTION * WEIGHT * way
        self.assertLess(abs(energy["friction"] / expected - 1), within)
        self.assertLess(abs((energy["external_work"] - energy["elastic"]) / expected - 1), within)
        self.assertLess(abs(energy["imbalance"]), within * expected)

    def test_a_stone_moved_to_and_fro(self):
        for increments, ranks in ((1, 1), (4, 1), (1, 2), (1, 4)):
            with self.subTest(increments=increments, ranks=ranks):
                energy = run(f"one {increments} {ranks}", moved(stone_on((0.0, 1.0)), increments=increments), ranks=ranks)
                self.check(energy, WAY)

    def test_a_stone_on_two_bearers_whose_shares_change_with_the_way_it_is_pushed(self):
        self.check(run("bearers", moved(stone_on((0.0, 0.25), (0.75, 1.0)))), WAY)

    def test_mortar_gives_way_before_it_slips(self):
        stiffness = 1e7  # Pa/m: 0.59 mm each way
        joints = {"dry": {"friction coefficient": FRICTION, "normal stiffness": 100 * stiffness,
                          "tangential stiffness": stiffness}}
        give = FRICTION * WEIGHT / stiffness
        energy = run("mortar", moved(stone_on((0.0, 1.0)), joints=joints))
        self.check(energy, WAY - (2 * len(MOVES) - 1) * give, within=2e-3)

    def test_what_does_not_slip_costs_nothing(self):
        energy = run("rough", moved(stone_on((0.0, 1.0)), moves=(1e-3, -1e-3, 0), friction=1e3))
        self.assertEqual(energy["friction"], 0)
        self.assertLess(abs(energy["imbalance"]), 1e-9 * energy["elastic"])

    def test_a_pressure_that_grows_with_the_slip_is_told(self):
        pressure = 1e5
        loads = {"move": {"type": "settlement", "support": "jack", "ux": 1.0},
                 "press": {"type": "traction", "on": "top", "pressure": pressure}}
        slip, imbalance = 4e-3, []
        work = FRICTION * (WEIGHT + pressure / 2) * slip
        for increments in (1, 10):
            stages = {"own weight": {"loads": {"weight": 1.0}},
                      "both": {"increments": increments, "loads": {"move": slip, "press": 1.0}}}
            energy = run(f"growing {increments}", moved(stone_on((0.0, 1.0)), loads=loads, stages=stages))
            self.assertLess(abs(energy["external_work"] / work - 1), 5e-3)
            excess = FRICTION * pressure / 2 * slip / increments
            self.assertLess(abs(energy["imbalance"] / excess - 1), 0.02)
            self.assertLess(abs(energy["friction"] / (work + excess) - 1), 5e-3)

    def test_stones_that_lean_far(self):
        drawing = Drawing(0.25)
        for x, ground in ((0.0, "west"), (0.52, "east")):
            drawing.box(x, -0.3, 0.5, 0.3, bottom=ground)
            drawing.box(x, 0.0, 0.5, 1.0)
            drawing.box(x, 1.0, 0.5, 1.0)
        loads = {"turn": {"type": "settlement", "support": "west", "rotation": 0.03}}
        stages = {"own weight": {"loads": {"weight": 1.0}}, "turn": {"increments": 3, "loads": {"turn": 1.0}}}
        energy = run("leaning", scenes.scene(drawing, loads=loads, stages=stages, supports=("west", "east"),
                                             model={"rotations": "finite"}))
        # A pier 2.3 m high that turns by 0.03 rad about the middle of its foot goes down by 1.15 m x 0.03^2 / 2.
        fall = 2.3 * 0.5 * 2000 * 9.81 * 1.15 * 0.03**2 / 2
        self.assertLess(energy["friction"], 1e-3 * fall)
        self.assertLess(abs(energy["external_work"]), 1e-2 * fall)  # what weight does the support takes


if __name__ == "__main__":
    PROGRAM, MPIEXEC = (str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

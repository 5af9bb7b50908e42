"""Stones on supports that move, in time: whoever moves, friction takes and never gives.

usage: moving_supports.py PROGRAM MPIEXEC

Set-up    A stone on a bed. The bed begins to move under it, at once or slowly, alone or under two stones, or shakes; or the
          stone is thrown on the bed at rest.
Expected  In every step friction takes at least nothing and the book closes to 1e-9 of the energy. A stone is caught up with
          after v / (mu g), at mu g; until then friction takes m v^2 / 2 of its motion relative to the bed, the same for a
          bed that moves and a stone that is thrown.
Tolerance 3 %: stones are elastic, their damping takes a little. The two ways of looking at one motion differ by as much.
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
MASS, SPEED, FRICTION, DURATION = 0.4 * 0.2 * 2000.0, 0.05, 0.3, 0.03  # kg, m/s, -, s


def bed_with(*stones):
    """A bed 1.2 m long, driven at its bottom, under stones 0.4 m wide that begin at x."""
    drawing = Drawing(0.1)
    ends = sorted({0.0, 1.2, *(x for x in stones), *(x + 0.4 for x in stones)})
    for left, right in zip(ends, ends[1:]):
        drawing.box(left, -0.1, right - left, 0.1, sets=("bed",), bottom="drive")
    for number, x in enumerate(stones):
        drawing.box(x, 0.0, 0.4, 0.2, sets=("stones", f"stone {number}"))
    return drawing


def scene(drawing, drive, damping=0.0, velocities=None):
    """drive: the motion of the bed in DURATION, a time function of a settlement; none for a bed at rest."""
    loads = {"drive": {"type": "settlement", "support": "drive", **drive}} if drive else {}
    stages = {"own weight": {"loads": {"weight": 1.0}},
              "moving": {"duration": DURATION, "time step": 1e-4, "at once": True, "loads": {name: 1.0 for name in loads}}}
    more = {"initial velocities": velocities} if velocities else {}
    made = scenes.scene(drawing, friction=FRICTION, supports=("drive",), loads=loads, stages=stages,
                        stone={"Young modulus": 2e10, "Poisson ratio": 0.0}, **more)
    made["steps"]["time"] = {"stiffness damping": damping}
    made["observations"] = {"stone": {"blocks": "stone 0", "place": "mean"}}
    made["output"]["fields"] = False
    return made


BELT = {"ux": SPEED * DURATION, "time function": {"type": "ramp", "start": 0.0, "duration": DURATION}}
SHAKING = {"ux": 2e-5, "time function": {"type": "sine", "frequency": 100.0}}
THROWN = {"thrown": {"blocks": "stones", "vx": -SPEED}}


class MovingSupports(unittest.TestCase):
    def run_scene(self, name, made, *settings, ranks=1):
        """Rows of history.csv as numbers, after what must hold in each."""
        folder = empty(f"moving_supports/{name}")
        (folder / "scene").mkdir(parents=True)
        run_scene(PROGRAM, MPIEXEC, folder / "run", scenes.write(made, folder / "scene"), *settings, ranks=ranks)
        with open(folder / "run" / "history.csv", encoding="utf-8") as file:
            rows = [{key: float(value) for key, value in row.items() if key != "stage" and value} for row in csv.DictReader(file)]
        largest = max(row["elastic_J"] + row["kinetic_J"] for row in rows)
        for before, row in zip(rows, rows[1:]):
            self.assertGreaterEqual(row["friction_J"], before["friction_J"])
            self.assertLess(abs(row["imbalance_in_time_J"] - before["imbalance_in_time_J"]), 1e-9 * largest)
        last = rows[-1]
        print(name, "friction", last["friction_J"], "work", last["external_work_J"], "damping", last["damping_J"])
        return rows

    def test_a_belt_that_catches_a_stone_and_a_stone_that_is_thrown(self):
        energy = MASS * SPEED**2 / 2
        belt = self.run_scene("belt", scene(bed_with(0.4), BELT, damping=1e-5))
        thrown = self.run_scene("thrown", scene(bed_with(0.4), None, damping=1e-5, velocities=THROWN))
        for rows in (belt, thrown):
            self.assertLess(abs(rows[-1]["friction_J"] / energy - 1), 0.03)
            # Between the shock with which a belt starts and the end of the slip.
            begin, end = (min(rows[1:], key=lambda row: abs(row["time_s"] - time)) for time in (4e-3, 14e-3))
            gained = end["vx_m_per_s of stone"] - begin["vx_m_per_s of stone"]
            self.assertLess(abs(gained / (FRICTION * 9.81 * 0.01) - 1), 0.03)
        self.assertLess(abs(belt[-1]["friction_J"] / thrown[-1]["friction_J"] - 1), 0.03)

    def test_undamped_whatever_is_selected(self):
        for name, settings in (("adaptive", ()), ("all", ("selection/mode=all",))):
            with self.subTest(name):
                self.run_scene(f"undamped {name}", scene(bed_with(0.4), BELT), *settings)

    def test_two_stones_and_ranks(self):
        made = scene(bed_with(0.1, 0.7), BELT, damping=1e-5)
        rows = self.run_scene("two", made)
        self.assertLess(abs(rows[-1]["friction_J"] / (MASS * SPEED**2) - 1), 0.03)
        made["steps"]["stages"]["moving"]["duration"] = 2e-3  # the shock and the first slip
        alone, *others = (self.run_scene(f"two on {ranks}", made, ranks=ranks)[-1] for ranks in (1, 2, 4))
        for other in others:
            for key in ("friction_J", "external_work_J"):
                self.assertLess(abs(other[key] / alone[key] - 1), 1e-6)

    def test_a_bed_that_shakes(self):
        rows = self.run_scene("shaken", scene(bed_with(0.4), SHAKING))
        self.assertGreater(rows[-1]["friction_J"], 0)


if __name__ == "__main__":
    PROGRAM, MPIEXEC = (str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

"""Stones on supports that move, in time: whoever moves, friction takes and never gives.

usage: moving_supports.py PROGRAM MPIEXEC

Set-up    A stone on a bed. The bed begins to move under it at once, under two stones or a pair glued on one another, turns back,
          or shakes; or the stone is thrown on the bed at rest.
Expected  In every step friction takes at least nothing, the book closes to 1e-9 of the energy, and supports bear the weight and
          what changes the momentum of all stones, in that step and not only in the mean. While it slips a stone gains
          mu g, towards the velocity of the bed; until it has caught up friction takes m v^2 / 2 of its motion relative to the
          bed, the same for a bed that moves and a stone that is thrown. Stones that are glued on one another and fall on the
          bed move as one stone of the same cells does. Of two beds the one on which a stone falls bears the blow alone.
Tolerance 2 % of the bed's velocity, at any time: stones rebound by as much in the shock with which the bed starts. Energies
          3 %: stones are elastic, their damping takes a little; the two ways of looking at one motion differ by as much.
"""

import csv
import math
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
    made["observations"] = {"stone": {"blocks": "stone 0", "place": "mean"}, "all": {"blocks": "all", "place": "mean"},
                            **{bed: {"place": "support", "support": bed} for bed in made["supports"]}}
    made["output"]["fields"] = False
    return made


def mass_of(drawing):
    """[kg] of boxes, drawn counter-clockwise."""
    ends = {number: pair for pair, number in drawing.sides.items()}

    def area(loop):
        corners = [ends[abs(side)][side < 0] for side in loop]
        return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1])) / 2

    return 2000.0 * sum(area(loop) for loop, _ in drawing.stones)


BELT = {"ux": SPEED * DURATION, "time function": {"type": "ramp", "start": 0.0, "duration": DURATION}}
SHAKING = {"ux": 2e-5, "time function": {"type": "sine", "frequency": 100.0}}
TURN = 20.0  # [Hz] of a bed that turns back
TURNING = {"ux": SPEED / (2 * math.pi * TURN), "time function": {"type": "sine", "frequency": TURN}}
THROWN = {"thrown": {"blocks": "stones", "vx": -SPEED}}


def rigid_stone(velocity_of_bed, times, begins=0.0):
    """Velocity of a rigid stone on a bed: what friction gives in a step, no more than it takes to catch up."""
    velocity, at = [begins], 0.0
    for time in times:
        most = FRICTION * 9.81 * (time - at)
        velocity.append(velocity[-1] + max(-most, min(most, velocity_of_bed(time) - velocity[-1])))
        at = time
    return velocity[1:]


class MovingSupports(unittest.TestCase):
    def run_scene(self, name, made, *settings, ranks=1):
        """Rows of history.csv as numbers, after what must hold in each."""
        folder = empty(f"moving_supports/{name}")
        (folder / "scene").mkdir(parents=True)
        run_scene(PROGRAM, MPIEXEC, folder / "run", scenes.write(made, folder / "scene"), *settings, ranks=ranks)
        with open(folder / "run" / "history.csv", encoding="utf-8") as file:
            rows = [{key: float(value) for key, value in row.items() if key != "stage" and value} for row in csv.DictReader(file)]
        thrown = "initial velocities" in made  # between a first row at rest and the next
        self.balances_momentum(rows[thrown:], made["supports"], mass_of(made["mesh"]))
        largest = max(row["elastic_J"] + row["kinetic_J"] for row in rows)
        for before, row in zip(rows, rows[1:]):
            self.assertGreaterEqual(row["friction_J"], before["friction_J"])
            self.assertLess(abs(row["imbalance_in_time_J"] - before["imbalance_in_time_J"]), 1e-9 * largest)
        last = rows[-1]
        print(name, "friction", last["friction_J"], "work", last["external_work_J"], "damping", last["damping_J"])
        return rows

    def balances_momentum(self, rows, beds, mass):
        """What beds bear is the weight, and what changes the momentum of all stones from row to row."""
        def borne(row, axis):
            return sum(row[f"f{axis}_N of {bed}"] for bed in beds)

        def speed(row, axis):
            return row.get(f"v{axis}_m_per_s of all", 0.0)  # none in load steps

        def time(row):
            return row.get("time_s", 0.0)

        largest = max(abs(borne(row, axis)) for row in rows for axis in "xy")
        for before, row in zip(rows, rows[1:]):
            for axis, weight in (("x", 0.0), ("y", 9.81 * mass)):
                gained = mass * (speed(row, axis) - speed(before, axis)) / (time(row) - time(before))
                self.assertLess(abs(borne(row, axis) - weight - gained), 1e-6 * largest, (axis, time(row)))

    def moves_as_a_rigid_stone(self, rows, velocity_of_bed, begins=0.0):
        rows = rows[1:]
        times = [row["time_s"] for row in rows]
        for row, expected in zip(rows, rigid_stone(velocity_of_bed, times, begins)):
            if row["time_s"] > 4e-3:  # the shock with which a bed starts has gone
                self.assertLess(abs(row["vx_m_per_s of stone"] - expected), 0.02 * SPEED, row["time_s"])

    def test_a_belt_that_catches_a_stone_and_a_stone_that_is_thrown(self):
        energy = MASS * SPEED**2 / 2
        belt = self.run_scene("belt", scene(bed_with(0.4), BELT, damping=1e-5))
        thrown = self.run_scene("thrown", scene(bed_with(0.4), None, damping=1e-5, velocities=THROWN))
        for rows, bed, begins in ((belt, SPEED, 0.0), (thrown, 0.0, -SPEED)):
            self.assertLess(abs(rows[-1]["friction_J"] / energy - 1), 0.03)
            self.moves_as_a_rigid_stone(rows, lambda _, bed=bed: bed, begins)
        self.assertLess(abs(belt[-1]["friction_J"] / thrown[-1]["friction_J"] - 1), 0.03)

    def test_a_bed_that_turns_back(self):
        for damping in (3e-6, 3e-5):
            rows = self.run_scene(f"turning {damping}", scene(bed_with(0.4), TURNING, damping=damping))
            self.moves_as_a_rigid_stone(rows, lambda time: SPEED * math.cos(2 * math.pi * TURN * time))

    def test_a_pair_that_is_one_body(self):
        drawing = bed_with(0.4)
        drawing.box(0.4, 0.2, 0.4, 0.1, sets=("top",))
        made = scene(drawing, BELT, damping=1e-5)
        made["joints"]["glue"] = {"friction coefficient": 0.6, "cohesion": 1e9, "tension strength": 1e9,
                                  "between": "stones", "and": "top"}
        self.moves_as_a_rigid_stone(self.run_scene("pair", made), lambda _: SPEED)

    def fallen(self, name, boxes, **run):
        """Stones of given heights on one another that fall by 0.1 mm on the first of two beds, glued together."""
        drawing = Drawing(0.1)
        for bed, x in (("drive", 0.0), ("beside", 2.0)):
            drawing.box(x, -0.1, 0.4, 0.1, sets=("beds", f"{bed} bed"), bottom=bed)
        y = 0.0
        for number, height in enumerate(boxes):
            drawing.box(0.0, y, 0.4, height, sets=("stones", f"stone {number}"))
            y += height
        made = scene(drawing, None, velocities={"thrown": {"blocks": "stones", "vx": 0.01}})
        made["joints"] = {"bed": {"friction coefficient": FRICTION, "initial gap": 1e-4, "between": "beds", "and": "stones"},
                          "glue": {"friction coefficient": math.inf, "cohesion": math.inf, "tension strength": math.inf}}
        made["supports"] = {bed: {"on": bed} for bed in ("drive", "beside")}
        made["observations"].update({bed: {"place": "support", "support": bed} for bed in made["supports"]})
        made["observations"]["other"] = {"blocks": "beside bed", "place": "mean"}
        made["steps"]["stages"] = {"fall": {"duration": 0.012, "time step": 1e-4, "at once": True, "loads": {"weight": 1.0}}}
        return self.run_scene(name, made, "selection/mode=all", **run)

    def test_stones_that_are_glued_fall_as_one(self):
        one, two, ranked = (self.fallen(name, boxes, ranks=ranks)
                            for name, boxes, ranks in (("one", (0.3,), 1), ("glued", (0.1, 0.2), 1), ("glued on 3", (0.1, 0.2), 3)))
        self.assertGreater(max(row["fy_N of drive"] for row in one), 2 * 9.81 * 0.4 * 0.3 * 2000)
        for rows in (one, two, ranked):
            others = [{key.replace(" of other", " of all"): value for key, value in row.items() if "of all" not in key} for row in rows]
            self.balances_momentum(others, ("beside",), 0.4 * 0.1 * 2000)
            for row, expected in zip(rows, one):
                self.assertLess(abs(row["kinetic_J"] - expected["kinetic_J"]), 1e-6 * one[-1]["external_work_J"])

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

"""A reaction belongs, component by component, to the support that holds the component.

usage: reactions.py PROGRAM MPIEXEC

Set-up    A stone on a bed whose floor and wall are supports that share a corner, named in either order: the floor holds y
          and the wall x, as on rollers; both hold x and y; a third holds one point of the top. The floor settles.
Expected  Rollers: the floor bears the weight and nothing sideways, the wall nothing, or what pushes sideways. Whatever is
          shared, the sums are weight and push, and no order of names changes what a support bears.
          Supports that a scene observes show, step by step, their way and that force; in time the mean of a step, whose sum
          over time is what weight and momentum leave.
Tolerance 1e-8 of the weight, the tolerance of the solver.
"""

import csv
import itertools
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hard" / "ground"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "restart"))
from drawing import grid  # noqa: E402  (folders of their own)
import scenes  # noqa: E402
from runs import empty, run_scene  # noqa: E402

PROGRAM = MPIEXEC = None
WEIGHT = 2 * 0.5 * 2000 * 9.81


class Reactions(unittest.TestCase):
    def reactions(self, name, supports, push=0.0, settles=True, ranks=1):
        """Reactions by support, and the warnings."""
        loads = {"push": {"type": "acceleration", "ax": push},
                 "sink": {"type": "settlement", "support": "floor", "uy": -1e-3}}
        made = scenes.scene(grid(1, 2, 1.0, 0.5, 0.25), loads=loads, supports=supports,
                            stages={"all": {"loads": {"weight": 1.0, "push": 1.0, "sink": 1.0 if settles else 0.0}}})
        folder = empty(f"reactions/{name}")
        (folder / "scene").mkdir(parents=True)
        result = run_scene(PROGRAM, MPIEXEC, folder / "run", scenes.write(made, folder / "scene"), ranks=ranks)
        return result["statics"]["reactions"], result["warnings"]

    def observed(self, name, supports, stages, ranks=1, **more):
        """Rows of the history with the supports observed, and the reactions at the end."""
        loads = {"push": {"type": "acceleration", "ax": 0.5}, "sink": {"type": "settlement", "support": "floor", "uy": -1e-3}}
        made = scenes.scene(grid(1, 2, 1.0, 0.5, 0.25), loads=loads, supports=supports, stages=stages, **more)
        made["observations"] = {**{k: {"place": "support", "support": k} for k in supports}, "all": {"place": "mean"}}
        folder = empty(f"reactions/{name}")
        (folder / "scene").mkdir(parents=True)
        result = run_scene(PROGRAM, MPIEXEC, folder / "run", scenes.write(made, folder / "scene"), ranks=ranks)
        with open(folder / "run" / "history.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file)), result.get("statics", {}).get("reactions")

    def close(self, one, other):
        self.assertLess(abs(one - other), 1e-8 * WEIGHT)

    def test_rollers_in_either_order(self):
        supports = {"floor": {"on": "ground", "components": "y"}, "wall": {"on": "left", "components": "x"}}
        for push, first, second, ranks in ((0.0, "floor", "wall", 1), (0.0, "wall", "floor", 1), (0.1, "floor", "wall", 2),
                                           (0.1, "wall", "floor", 4)):
            with self.subTest(push=push, first=first, ranks=ranks):
                found, warnings = self.reactions(f"rollers {push} {first} {ranks}",
                                                 {name: supports[name] for name in (first, second)}, push, ranks=ranks)
                self.close(found["floor"]["y_N"], WEIGHT)
                self.close(found["floor"]["x_N"], 0)
                self.close(found["wall"]["x_N"], -push / 9.81 * WEIGHT)
                self.close(found["wall"]["y_N"], 0)
                self.assertEqual(warnings, [])

    def test_what_two_hold_is_shared_in_any_order(self):
        supports = {"floor": {"on": "ground"}, "wall": {"on": "left", "components": "xy"},
                    "lid": {"on": "top", "components": "y"}}
        first = None
        for order in itertools.permutations(supports):
            found, _ = self.reactions("shared " + " ".join(order), {name: supports[name] for name in order}, 1.0,
                                      settles=False, ranks=2)
            self.close(sum(r["y_N"] for r in found.values()), WEIGHT)
            self.close(sum(r["x_N"] for r in found.values()), -WEIGHT / 9.81)
            self.close(found["lid"]["x_N"], 0)
            first = first or found
            for name in supports:
                for key in ("x_N", "y_N"):
                    self.close(found[name][key], first[name][key])

    def test_a_support_that_leaves_one_it_shares_nodes_with_is_told(self):
        supports = {"floor": {"on": "ground"}, "wall": {"on": "left", "components": "y"}}
        _, warnings = self.reactions("torn", supports)
        self.assertEqual([(w["what"], w["how_much"]) for w in warnings], [("supports_part", 1)])
        self.assertIn('"floor"', warnings[0]["text"])
        self.assertIn('"wall"', warnings[0]["text"])

    def test_observed_supports_show_way_and_force_of_every_step(self):
        supports = {"floor": {"on": "ground", "components": "y"}, "wall": {"on": "left", "components": "x"}}
        stages = {"all": {"increments": 4, "loads": {"weight": 1.0, "push": 1.0, "sink": 1.0}}}
        for ranks in (1, 2, 4):
            rows, reactions = self.observed(f"steps {ranks}", supports, stages, ranks)
            self.assertEqual(len(rows), 4)
            for k, row in enumerate(rows):
                share = (k + 1) / 4
                self.close(float(row["fy_N of floor"]), share * WEIGHT)
                self.close(float(row["fx_N of wall"]), -share * 0.5 / 9.81 * WEIGHT)
                self.close(float(row["fx_N of floor"]), 0)
                self.assertAlmostEqual(float(row["uy_m of floor"]), -1e-3 * share, delta=1e-15)
            for name in supports:
                for axis in "xy":
                    self.close(float(rows[-1][f"f{axis}_N of {name}"]), reactions[name][f"{axis}_N"])

    def test_forces_in_time_are_what_weight_and_momentum_leave(self):
        supports = {"floor": {"on": "ground"}}
        stages = {"shaken": {"duration": 0.05, "time step": 1e-3, "at once": True, "loads": {"weight": 1.0, "push": 1.0}}}
        rows, _ = self.observed("time", supports, stages, 2)
        mass, before, time, impulse = WEIGHT / 9.81, {"x": 0.0, "y": 0.0}, 0.0, {"x": 0.0, "y": 0.0}
        largest = 0.0
        for row in rows:
            step = float(row["time_s"]) - time
            time += step
            for axis, load in (("x", 0.5 * mass), ("y", -WEIGHT)):
                force, speed = float(row[f"f{axis}_N of floor"]), float(row[f"v{axis}_m_per_s of all"])
                largest = max(largest, abs(speed - before[axis]) * mass / step)
                impulse[axis] += (force + load) * step
                self.assertLess(abs(impulse[axis] - mass * speed), 1e-7 * WEIGHT * time)
                before[axis] = speed
        self.assertGreater(largest, 0.1 * WEIGHT)  # it is shaken

    def test_a_support_that_is_none_is_refused(self):
        made = scenes.scene(grid(1, 2, 1.0, 0.5, 0.25), supports={"floor": {"on": "ground"}},
                            stages={"all": {"loads": {"weight": 1.0}}})
        for place, pieces in (({"place": "support", "support": "flor"}, ("observations > a > support", "'flor'", "'floor'")),
                              ({"place": "support"}, ("observations > a > support", "missing")),
                              ({"support": "floor"}, ("observations > a > support", "place"))):
            made["observations"] = {"a": place}
            folder = empty("reactions/refused")
            (folder / "scene").mkdir(parents=True)
            done = subprocess.run([PROGRAM, f"--xml={scenes.write(made, folder / 'scene')}", f"--out={folder / 'run'}"],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 2)
            for piece in pieces:
                self.assertIn(piece.replace("'", ""), done.stderr.replace("'", "").replace('"', ""))


if __name__ == "__main__":
    PROGRAM, MPIEXEC = (str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

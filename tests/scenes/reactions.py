"""A reaction belongs, component by component, to the support that holds the component.

usage: reactions.py PROGRAM MPIEXEC

Set-up    A stone on a bed whose floor and wall are supports that share a corner, named in either order: the floor holds y
          and the wall x, as on rollers; both hold x and y; a third holds one point of the top. The floor settles.
Expected  Rollers: the floor bears the weight and nothing sideways, the wall nothing, or what pushes sideways. Whatever is
          shared, the sums are weight and push, and no order of names changes what a support bears.
Tolerance 1e-8 of the weight, the tolerance of the solver.
"""

import itertools
import pathlib
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


if __name__ == "__main__":
    PROGRAM, MPIEXEC = (str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

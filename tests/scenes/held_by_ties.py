"""A stone that only a tie holds, in a step that may release nothing more: an equilibrium with a warning that names it.

usage: held_by_ties.py PROGRAM MPIEXEC

Set-up    A column of six stones, pushed sideways so that its beds open, under a slab with an overhang. Below the overhang
          hangs a stone of 49 N from a dry joint: a millionth of the energy of the rest.
Expected  The one round of release that `largest rounds` = 1 leaves goes to the beds. The stone stands by its tie then, and the
          run says that all of its load is borne so. With one round more it is released and falls.
"""

import json
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hard" / "ground"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "restart"))
from drawing import Drawing  # noqa: E402  (folders of their own)
import scenes  # noqa: E402
from runs import empty, run_scene  # noqa: E402

PROGRAM = MPIEXEC = None
COURSES, SIZE = 6, 0.05  # of stones 1 m high; [m] of the stone that hangs
HANGS = COURSES + 1  # its number


def drawing():
    made = Drawing(0.25, cells="triangle")
    for k in range(COURSES):
        made.box(0.0, float(k), 1.0, 1.0, **({"bottom": "ground"} if k == 0 else {}))
    low, left, right = float(COURSES), 1.2, 1.2 + SIZE
    made.stone([(0.0, low), (1.0, low), (left, low), (right, low), (1.3, low), (1.3, low + 0.5), (0.0, low + 0.5)])
    made.stone([(left, low - SIZE), (right, low - SIZE), (right, low), (left, low)])
    return made


class HeldByTies(unittest.TestCase):
    def result(self, rounds, ranks, rotations="small", increments=1):
        folder = empty(f"held_by_ties/{rounds} on {ranks}, {rotations}, {increments}")
        (folder / "scene").mkdir(parents=True)
        made = scenes.scene(drawing(), loads={"push": {"type": "acceleration", "ax": 0.3}},
                            stages={"all": {"increments": increments, "loads": {"weight": 1.0, "push": 1.0}}})
        made["model"] = {**made.get("model", {}), "rotations": rotations}
        # A structure as small as this is not to be released at once.
        made["selection"] = {"largest rounds": rounds, "largest share": 1.0}
        run_scene(PROGRAM, MPIEXEC, folder / "run", scenes.write(made, folder / "scene"), ranks=ranks)
        return json.loads((folder / "run" / "result.json").read_text())

    def test_what_could_not_be_released_is_told(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                # The static theorem, which refuses the loads at the end of the stage, is not asked in the middle of it.
                result = self.result(1, ranks, increments=2)
                self.assertEqual((result["outcome"], result["steps"]), ("collapse", 1))
                warning, = result["warnings"]
                self.assertEqual((warning["what"], warning["where"]), ("held_by_ties", f"block {HANGS}"))
                # What its one joint bears is its weight, solved to 1e-8 of the largest force: 1e-4 of so light a stone.
                self.assertLess(abs(warning["how_much"] - 1), 1e-3)

    def test_what_could_not_be_released_is_refused_by_the_static_theorem(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                result = self.result(1, ranks, rotations="finite" if ranks == 2 else "small")
                self.assertEqual(result["outcome"], "collapse")
                self.assertIn("static theorem", result["message"])
                self.assertEqual(result["mechanism"]["largest_mover_block"], HANGS)

    def test_what_may_be_released_falls(self):
        self.assertEqual(self.result(2, 1)["outcome"], "collapse")


if __name__ == "__main__":
    PROGRAM, MPIEXEC = (str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])

"""The energy book of a glued stack that its support turns far, in one step and in several.

    turned_stack.py PROGRAM MPIEXEC

Set-up    Four stones, 0.5 m wide and 1.2 m high together, whose joints are too strong to open or slip, under their own
          weight. The support below turns by 0.3 rad about a point beside the stack, with finite rotations.
Expected  Nothing is lost: what loads and the support do is stored as elastic energy. The weight gains W h (1 - cos t) / 2
          and what it moves aside; the support does the opposite, by a moment that grows with the angle.
Came out  Out of balance by 3.4 % of the elastic energy of 0.0106 J in one step and by 2.7 % in four, 1e-7 of what the
          weight alone does.
Tolerance Stones are followed to 1e-4 rad, and what is left of their turn is no deformation: 10 % of the elastic energy.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import stones  # noqa: E402

TURN, WIDTH, HIGH, COURSES = 0.3, 0.5, 0.3, 4
STRONG = {"glue": {"friction coefficient": 0.6, "cohesion": 1e9, "tension strength": 1e9, "fracture energy": 1e9,
                   "shear fracture energy": 1e9}}


class TurnedStack(program.SceneTest):
    def turn(self, increments, ranks=1, back=False):
        drawn = {f"c{k}": stones.rectangle(0, k * HIGH, WIDTH, (k + 1) * HIGH) for k in range(COURSES)}
        loads = {"turn": {"type": "settlement", "support": "ground", "rotation": TURN, "about x": -1.0, "about y": 0.0}}
        stages = {"rest": stones.OWN_WEIGHT, "turned": {"increments": increments, "loads": {"turn": 1.0}}}
        if back:
            stages["back"] = {"increments": increments, "loads": {"turn": 0.0}}
        scene = stones.scene("stones.geo", ["ground"], loads, stages, joints=STRONG, model={"rotations": "finite"})
        run = self.run_scene(scene, drawing=stones.geo(drawn, 0.15, {"ground": ("c0", 0)}), ranks=ranks,
                             out=f"out{increments}-{ranks}", seconds=100)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run.history

    def test_what_the_support_does_is_stored(self):
        for increments, ranks in ((1, 1), (4, 1), (1, 2)):
            history = self.turn(increments, ranks)
            rest, end = history[0], history[-1]
            self.assertLess(abs(end["imbalance_J"] - rest["imbalance_J"]), 0.1 * end["elastic_J"], (increments, ranks))
            # The weight alone does ten thousand times as much.
            weight = 2000 * 9.81 * WIDTH * HIGH * COURSES
            self.assertGreater(weight * math.sin(TURN), 1e4 * end["elastic_J"])

    def test_there_and_back_nothing_is_left(self):
        history = self.turn(2, back=True)
        self.assertLess(abs(history[-1]["external_work_J"] - history[0]["external_work_J"]),
                        0.1 * history[0]["elastic_J"])


if __name__ == "__main__":
    program.main()

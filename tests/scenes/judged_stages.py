"""Limit analysis of a scene with several stages: each of load steps is judged, and what is not is told.

    judged_stages.py PROGRAM MPIEXEC

Set-up    A block on a slab, friction 0.6, pushed by 0.9 g in a stage amid others, or from a stage with a duration on.
Expected  It slides wherever it is pushed by more than 0.6 of its weight, whatever later stages ask.
"""

import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402
import stones  # noqa: E402

STONES = {"slab": stones.rectangle(-0.8, -0.3, 0.8, 0), "block": stones.rectangle(-0.25, 0, 0.25, 0.25),
          "boulder": stones.rectangle(0.4, 0, 0.8, 0.2)}
DRAWING = stones.geo(STONES, 0.125, {"ground": ("slab", 0)})
OWN, SOFT, HARD = {"loads": {"weight": 1.0}}, {"loads": {"push": 0.1}}, {"loads": {"push": 0.9}}


def scene(stages, **sections):
    return stones.scene("stones.geo", ["ground"], {"push": {"type": "acceleration", "ax": 9.81}}, stages, **sections)


class JudgedStages(program.SceneTest):
    def judged(self, stages, code=0, outcome="equilibrium", warnings=(), **sections):
        run = self.run_scene(scene(stages, **sections), "--limit-analysis", drawing=DRAWING)
        self.assertEqual(run.code, code, run.said)
        if code != 2:
            self.assertEqual(run.outcome, outcome, run.said)
            self.assertEqual(sorted(set(run.warnings)), sorted(warnings), run.said)
        return run

    def test_a_stage_that_falls_amid_others_is_named(self):
        run = self.judged({"own": OWN, "hard": HARD, "soft": SOFT}, code=3, outcome="collapse")
        self.assertIn("no forces that joints admit balance the loads at the end of stage 'hard'", run.result["message"])
        self.assertIn("slide", run.result["message"])

    def test_the_last_one_is_judged_as_the_others(self):
        run = self.judged({"own": OWN, "soft": SOFT, "hard": HARD}, code=3, outcome="collapse")
        self.assertIn("at the end of stage 'hard'", run.result["message"])

    def test_of_those_that_stand_the_last_is_told_of(self):
        run = self.judged({"own": OWN, "softer": {"loads": {"push": 0.3}}, "soft": SOFT})
        self.assertIn("balance the loads at the end of every stage; at that of the last, 'soft',", run.result["message"])

    def test_a_stone_that_goes_is_there_until_then(self):
        """The block is pushed hard while it is there, and again when it has gone and the boulder alone would slide."""
        goes = {"block": {"blocks": "block", "disappears": "soft"}, "boulder": {"blocks": "boulder", "disappears": "hard"}}
        run = self.judged({"own": OWN, "hard": HARD, "soft": SOFT}, code=3, outcome="collapse", construction=goes)
        self.assertIn("at the end of stage 'hard'", run.result["message"])
        self.assertIn("1 of ", run.result["message"])
        self.judged({"own": OWN, "soft": SOFT, "hard": {"loads": {"push": 0.5}}},
                    construction={"block": {"blocks": "block", "disappears": "soft"}})

    def test_stages_in_time_are_told_as_not_judged(self):
        run = self.judged({"own": OWN, "shaken": {**HARD, "duration": 0.1}}, warnings=["not_judged"])
        self.assertIn("at the end of stage 'own'", run.result["message"])
        run = self.judged({"shaken": {"loads": {"weight": 1.0, "push": 0.9}, "duration": 0.1}}, code=2)
        self.assertIn("scene > steps > stages > shaken > duration", run.words)


if __name__ == "__main__":
    program.main()

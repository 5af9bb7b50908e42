"""Walls of rigid joints with strength crack alike on any ranks, and in every run.

usage: rigid_joints.py PROGRAM MPIEXEC

Set-up    A wall of four courses in bond between plates, pressed, then pushed to and fro until most joints slide. Where three of its
          stones meet, neither equilibrium nor motion tells the forces of three rigid points apart, and strength is judged by them.
          Mode adaptive, systems factored whole and by Krylov's method.
Expected  The split is unique, so the force of the plate, what is lost and what is open are alike on 1, 2 and 4 ranks. On the same
          ranks two runs leave the same bits.
Tolerance 1e-6 of the largest force, a hundred times the tolerance of the solver.
"""

import json
import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import stones  # noqa: E402

LIME = {"friction coefficient": 0.6, "cohesion": 1e5, "tension strength": 5e4, "fracture energy": 10.0,
        "shear fracture energy": 50.0}
COURSES, PIECES = 4, 4


def wall():
    """Stones of 0.5 m x 0.25 m in bond, those at the ends of every other course halved."""
    outlines = {}
    for course in range(COURSES):
        cuts = [0.5 * i for i in range(PIECES + 1)]
        if course % 2:
            cuts = [0, *(x + 0.25 for x in cuts[:-1]), cuts[-1]]
        for i, (left, right) in enumerate(zip(cuts, cuts[1:])):
            outlines[f"c{course}s{i}"] = stones.rectangle(left, 0.25 * course, right, 0.25 * (course + 1))
    outlines["foot"] = stones.rectangle(0, -0.25, 0.5 * PIECES, 0)
    outlines["cap"] = stones.rectangle(0, 0.25 * COURSES, 0.5 * PIECES, 0.25 * (COURSES + 1))
    return stones.geo(outlines, 0.25, {"base": ("foot", 0), "top": ("cap", 2)})


def pushed():
    return stones.scene("stones.geo", ["base", "top"],
                        {"down": {"type": "settlement", "support": "top", "uy": -2e-5},
                         "side": {"type": "settlement", "support": "top", "ux": 3e-4}},
                        {"press": {"loads": {"weight": 1.0, "down": 1.0}},
                         "to": {"increments": 3, "loads": {"side": 0.7}}, "fro": {"increments": 2, "loads": {"side": -0.3}}},
                        joints={"dry": LIME}, observations={"plate": {"place": "support", "support": "top"}})


class RigidJoints(program.SceneTest):
    def run_on(self, ranks, out, *settings):
        run = self.run_scene(pushed(), *settings, drawing=wall(), out=out, ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run

    def test_ranks_agree(self):
        for settings, many in ((), (1, 2, 4)), (("--set", "preconditioner/factored up to=0"), (1, 2)):
            runs = [self.run_on(ranks, f"{len(settings)}_{ranks}", *settings).history for ranks in many]
            self.assertGreater(runs[0][-1]["fracture_J"], 0)
            for key in "fx_N of plate", "fy_N of plate", "fracture_J", "open_points", "slip_points":
                largest = max(abs(row[key]) for row in runs[0])
                for other in runs[1:]:
                    for row, same in zip(runs[0], other):
                        self.assertLessEqual(abs(row[key] - same[key]), 1e-6 * largest, (settings, key, row["step"]))

    def test_runs_are_alike_to_the_last_bit(self):
        runs = [self.run_on(2, f"again{i}") for i in range(2)]

        def told(run):
            return [{key: value for key, value in row.items() if key != "seconds"} for row in run.history]

        self.assertEqual(json.dumps(told(runs[0])), json.dumps(told(runs[1])))


if __name__ == "__main__":
    program.main()

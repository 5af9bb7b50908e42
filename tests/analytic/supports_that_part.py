"""Where two supports move differently and their stones meet each stone goes with its own.

usage: supports_that_part.py PROGRAM MPIEXEC

Set-up    Two stones side by side, each held along its bottom by a support of its own, and glued by a joint that nothing parts. One
          of the supports moves by a millimetre. Nothing violates the law of the joint, so all of it stays bonded.
Expected  In the lowest point of the joint both sides are held, each where its support is: that is no point to tie. What the
          structure stores is that of all points resolved as contact, whichever support moves, on 1 and 2 ranks.
Tolerance 1e-6 of the energy, a hundred times the tolerance of the solver; to tie the point misplaces a node of one stone by the
          whole millimetre, which takes several per cent of the energy.
"""

import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import stones  # noqa: E402


class Parting(program.SceneTest):
    def energy(self, moved, still, out, *settings, ranks=1):
        outlines = {"a": stones.rectangle(0, 0, 1, 1), "b": stones.rectangle(1, 0, 2, 1)}
        drawing = stones.geo(outlines, 0.25, {"moved": (moved, 0), "still": (still, 0)})
        glue = {"dry": {"friction coefficient": 0.6, "cohesion": float("inf"), "tension strength": float("inf")}}
        scene = stones.scene("stones.geo", ["moved", "still"],
                             {"down": {"type": "settlement", "support": "moved", "uy": -1e-3}},
                             {"moved": {"loads": {"down": 1.0}}}, joints=glue)
        run = self.run_scene(scene, *settings, drawing=drawing, out=out, ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run.history[-1]["elastic_J"]

    def test_each_stone_goes_with_its_support(self):
        for moved, still in ("a", "b"), ("b", "a"):
            right = self.energy(moved, still, f"{moved}_all", "--set", "selection/mode=all")
            self.assertGreater(right, 0)
            for ranks in 1, 2:
                energy = self.energy(moved, still, f"{moved}{ranks}", ranks=ranks)
                self.assertLess(abs(energy - right), 1e-6 * right, (moved, ranks))


if __name__ == "__main__":
    program.main()

"""Two supports that move differently where their stones meet tear neither stone.

usage: supports_that_part.py PROGRAM MPIEXEC

Set-up    Two stones side by side without friction, each held along its bottom by a support of its own. One of
          the supports moves down by a millimetre. Points are released one by one, not with all of their joint.
Expected  In the lowest point of the joint both sides are held. It is no point to tie: each stone moves with its support as a
          whole, without a force, on 1 and 2 ranks.
Tolerance Round-off of E times displacement: 1e-9 of the energy that one torn cell would have.
"""

import unittest

import program
import stones

YOUNG, WAY = 10e9, 1e-3  # [Pa, m]


class Parting(program.SceneTest):
    def energy(self, outlines, edges, ranks):
        scene = stones.scene("stones.geo", list(edges), {"down": {"type": "settlement", "support": "moved", "uy": -WAY}},
                             {"moved": {"loads": {"down": 1.0}}}, friction=0.0)
        run = self.run_scene(scene, "--set", "selection/whole joints=false", drawing=stones.geo(outlines, 0.25, edges),
                             out=f"out{ranks}", ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run.history[-1]["elastic_J"]

    def test_stones_with_supports_of_their_own(self):
        outlines = {"a": stones.rectangle(0, 0, 1, 1), "b": stones.rectangle(1, 0, 2, 1)}
        for moved, still in ("a", "b"), ("b", "a"):
            for ranks in 1, 2:
                energy = self.energy(outlines, {"moved": (moved, 0), "still": (still, 0)}, ranks)
                self.assertLess(abs(energy), 1e-9 * YOUNG * WAY**2 / 2, (moved, ranks))


if __name__ == "__main__":
    program.main()

"""A stone that comes down obliquely: friction takes no more than it may of what presses, in every step.

usage: oblique_impacts.py PROGRAM MPIEXEC

Set-up    A stone flies onto a held slab without gravity, slides while it presses and leaves again: in space in a direction
          that is no axis, in the plane; in time steps from a tenth of what a wave takes through the stone to ten times it.
Expected  Coulomb's law for impulses: in each step what the slab bears along it is at most mu times what it bears across (in
          space, where all of its faces are held), and so is what the stone loses of its momentum along the slab. While it slides throughout it loses that much but
          for points that begin or cease to press within a step.
Tolerance 1e-6 of the largest force for the bound; 3 % of the momentum.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import solids  # noqa: E402
import stones  # noqa: E402

SPACE = {"slab": ((-0.5, -0.5, -0.3), (1.5, 1.0, 0)), "stone": ((0, 0, 0), (0.6, 0.4, 0.5))}
MASS = {"space": 0.6 * 0.4 * 0.5 * 2000, "plane": 0.6 * 0.5 * 2000}  # [kg]


class ObliqueImpacts(program.SceneTest):
    def thrown(self, where, velocity, friction, step, ranks=1):
        """Changes of the stone's momentum, and the largest excess of the slab's shear over the bound, by the largest force."""
        names = "xyz" if where == "space" else "xy"
        if where == "space":
            (self.folder / "stones.obj").write_text(solids.obj({n: solids.box(*b) for n, b in SPACE.items()}), encoding="utf-8")
            mesh, drawing = {"type": "stones", "stones": {"file": "stones.obj", "element size": 0.2}}, None
            supports = {"slab": {"on": "faces", "blocks": "slab"}}
        else:
            mesh, supports = "stones.geo", {"slab": {"on": "slab"}}
            drawing = stones.geo({"s": stones.polygon([(-0.5, -0.3), (1.5, -0.3), (1.5, 0), (0.6, 0), (0, 0), (-0.5, 0)]),
                                  "stone": stones.rectangle(0, 0, 0.6, 0.5)}, 0.1, {"slab": ("s", 0)})
        scene = stones.scene(mesh, supports, {}, {"fly": {"duration": 0.012, "time step": step}},
                             joints={"dry": {"friction coefficient": friction, "initial gap": 1e-3}},
                             materials={"stone": {"Young modulus": 2e9, "Poisson ratio": 0.2, "density": 2000.0}},
                             initial_velocities={"v": {"blocks": "stone", **{f"v{c}": v for c, v in zip(names, velocity)}}},
                             observations={"stone": {"place": "mean", "blocks": "stone"},
                                           "slab": {"place": "support", "support": "slab"}})
        run = self.run_scene(scene, drawing=drawing, ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        energy = run.result["energy"]
        self.assertLess(abs(energy["imbalance_J"]), 1e-6 * energy["kinetic_J"])
        self.assertGreater(energy["friction_J"], 0)
        forces = [[row[f"f{c}_N of slab"] for c in names] for row in run.history]
        largest = max(abs(f[-1]) for f in forces)
        over = max(math.hypot(*f[:-1]) - friction * abs(f[-1]) for f in forces) / largest
        gained = [MASS[where] * (run.history[-1][f"v{c}_m_per_s of stone"] - v) for c, v in zip(names, velocity)]
        return gained, over

    def test_no_step_rubs_harder_than_it_presses(self):
        for where, velocity, friction, step, ranks in (
                ("space", (1.5, 0.5, -0.5), 0.3, 1e-4, 1), ("space", (1.5, 0.5, -0.5), 0.3, 1e-4, 2),
                ("space", (1.5, 0.5, -0.5), 0.3, 1e-3, 1), ("space", (1.0, 0.0, -1.0), 0.2, 3e-4, 1),
                ("space", (-0.7, 1.1, -0.9), 0.1, 2e-3, 1), ("plane", (1.0, -1.0), 0.2, 1e-4, 1),
                ("plane", (-1.5, -0.5), 0.3, 1e-3, 1), ("plane", (1.0, -1.0), 0.25, 3e-5, 2)):
            with self.subTest(where=where, velocity=velocity, step=step, ranks=ranks):
                gained, over = self.thrown(where, velocity, friction, step, ranks)
                if where == "space":
                    self.assertLess(over, 1e-6)
                rubbed, pressed = math.hypot(*gained[:-1]), gained[-1]
                self.assertGreater(pressed, 1.2 * MASS[where] * -velocity[-1])  # it comes back
                self.assertLess(rubbed, friction * pressed * (1 + 1e-6))
                self.assertGreater(rubbed, 0.97 * friction * pressed)

    def test_one_that_sticks_keeps_to_the_bound_too(self):
        for velocity, step in (((0.05, 0.0, -0.5), 1e-4), ((0.15, -0.1, -0.5), 3e-4)):
            gained, over = self.thrown("space", velocity, 0.6, step)
            self.assertLess(over, 1e-6)
            self.assertLess(math.hypot(*gained[:-1]), 0.6 * gained[-1])


if __name__ == "__main__":
    program.main()

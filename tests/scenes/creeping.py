"""Forces that creep round a vertex: a stone slides on props whose tops are not one plane, and no step is halved.

    creeping.py PROGRAM MPIEXEC

Three props stand side by side, the top of the middle one slopes by 1e-8 or 1e-10, and the stone that lies on all three
is pushed until it slides. It cannot lie on two of them at their vertex, and a linear solve moves little of a force from
one to the other. It slides as on level props, to 2e-3: how three stones share a force at a vertex is not unique, and
friction of an impact follows what presses at each point.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import stones  # noqa: E402

STEPS = 10


class Creeping(program.SceneTest):
    def slide(self, slope, ranks=1, unit=1.0, shift=0.0, out="out"):
        """Lengths of the drawing in `unit` metres, with its origin elsewhere."""
        top = 1 + slope
        drawn = {"a": [(0, 0), (1, 0), (1, 1), (0, 1)], "b": [(1, 0), (2, 0), (2, top), (1, 1)],
                 "c": [(2, 0), (3, 0), (3, 1), (2, top)],
                 "slider": [(0, 1), (1, 1), (2, top), (3, 1), (3, 1.5), (0, 1.5)]}
        moved = {name: stones.polygon([(x / unit + shift, y / unit + shift) for x, y in at])
                 for name, at in drawn.items()}
        drawing = stones.geo(moved, 0.5 / unit, {f"under {name}": (name, 0) for name in "abc"})
        stage = {"duration": STEPS * 1e-3, "time step": 1e-3, "at once": True, "loads": {"push": 1.0}}
        # Thickness, force and mass go with the length, so that stresses do.
        stone = {"Young modulus": 10e9, "density": 2000.0 * unit**2}
        scene = stones.scene("stones.geo", [f"under {name}" for name in "abc"],
                             {"weight": {"type": "self weight", "gravity": 9.81 / unit},
                              "push": {"type": "acceleration", "ax": 6.0 / unit}},
                             {"own weight": {"loads": {"weight": 1.0}}, "pushed": stage}, friction=0.3,
                             materials={"stone": stone}, model={"thickness": 1.0 / unit})
        run = self.run_scene(scene, drawing=drawing, ranks=ranks, out=out, seconds=120)
        self.assertEqual((run.code, run.outcome), (0, "equilibrium"), run.said)
        self.assertEqual(run.result["steps"], 1 + STEPS, "a step was halved")
        return run

    def far(self, run, unit=1.0):
        return run.history[-1]["largest_displacement_m"] * unit

    def test_it_slides_as_on_level_props(self):
        level = self.slide(0.0, out="level")
        for slope in (1e-8, 1e-10):
            run = self.slide(slope, out=f"{slope}")
            self.assertLess(run.result["linear_solves"], 1.5 * level.result["linear_solves"])
            self.assertLess(abs(self.far(run) / self.far(level) - 1), 2e-3)

    def test_on_two_ranks_in_other_units_and_far_from_the_origin(self):
        here = self.far(self.slide(1e-8))
        self.assertLess(abs(self.far(self.slide(1e-8, ranks=2, out="two")) / here - 1), 1e-6)
        self.assertLess(abs(self.far(self.slide(1e-8, unit=1e-3, out="units"), 1e-3) / here - 1), 1e-3)
        self.assertLess(abs(self.far(self.slide(1e-8, shift=100.0, out="far")) / here - 1), 1e-3)


if __name__ == "__main__":
    program.main()

"""A load step costs the same whatever the last bits of products are.

usage: any_processor.py PROGRAM MPIEXEC

Set-up    Walls of 8 and 64 courses in running bond, stones of 2 x 1 cells, contact points released as needed: the small one is
          pushed, which releases points whose shear is cut to what friction bears; the tall one stands under its weight, where
          patches bring stones to rest. Each is computed under every kernel of OpenBLAS that this processor can run.
Expected  The same numbers of linear solves, and of points that are open, stick and slip. If the status of a point whose shear
          lies on its bound hung on rounding, the small wall would take 15 or 17 solves, the tall one 54 to 69 of patches.
Tolerance None of statuses; one solve, and a tenth of those of patches, for systems that come to their accuracy at its edge.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of their own)
from kernels import kernels  # noqa: E402

WALL = pathlib.Path(__file__).resolve().parents[2] / "xml" / "wall.xml"
STATUSES = ("selected_points", "open_points", "stick_points", "slip_points")


class AnyProcessor(program.SceneTest):
    def wall(self, courses, push):
        settings = {"mesh/wall/courses": courses, "mesh/wall/blocks per course": courses, "mesh/wall/cells along": 2,
                    "mesh/wall/cells up": 1, "steps/stages/push/loads/sideways": push}
        options = [word for path, value in settings.items() for word in ("--set", f"{path}={value}")]
        able = [name for name, why in kernels(program.PROGRAM).items() if not why]
        rows = {}
        for kernel in able:
            run = self.run_scene(WALL, *options, out=kernel, environment={"OPENBLAS_CORETYPE": kernel})
            self.assertEqual(run.outcome, "equilibrium", run.said)
            rows[kernel] = run.history
            print(courses, kernel, [(r["linear_solves"], r["patch_solves"], *(r[s] for s in STATUSES)) for r in run.history])
        for kernel in able[1:]:
            for step, other in zip(rows[able[0]], rows[kernel], strict=True):
                self.assertEqual([step[s] for s in STATUSES], [other[s] for s in STATUSES], kernel)
                self.assertLessEqual(abs(step["linear_solves"] - other["linear_solves"]), 1, kernel)
                patches = (step["patch_solves"], other["patch_solves"])
                self.assertLessEqual(max(patches), 1.1 * min(patches) + 1, kernel)

    def test_a_wall_that_is_pushed(self):
        self.wall(8, 1)

    def test_a_tall_wall_under_its_weight(self):
        self.wall(64, 0)


if __name__ == "__main__":
    program.main()

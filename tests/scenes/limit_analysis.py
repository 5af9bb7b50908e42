"""--limit-analysis: what rigid stones alone tell, in words, in result.json, in fields.h5 and in the report, on any ranks.

    limit_analysis.py PROGRAM MPIEXEC
"""

import json
import pathlib
import subprocess
import sys
import unittest

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "restart"))
from runs import empty  # noqa: E402  (a folder of its own)

PROGRAM = MPIEXEC = None
STONE = 0.5 * 0.25 * 2000 * 9.81  # [N] weight of a whole stone of the wall, per metre of thickness


def analyse(name, scene, *settings, ranks=1):
    """Runs limit analysis of a scene: folder, what was printed, result.json."""
    out = empty(f"limit_analysis/{name} on {ranks}")
    launch = [MPIEXEC, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    command = [*launch, PROGRAM, f"--xml={ROOT / 'xml' / scene}", "--limit-analysis", f"--out={out}"]
    for setting in settings:
        command += ["--set", setting]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise AssertionError(run.stdout + run.stderr)
    return out, run.stdout, json.loads((out / "result.json").read_text(encoding="utf-8"))


def balance(out, step):
    """Force of the joints on every stone at a step [N], and places of stones."""
    with h5py.File(out / "fields.h5", "r") as file:
        joints, forces = file["joints"], file["steps"][step]
        normal = joints["normal"][()]
        tangent = np.stack([-normal[:, 1], normal[:, 0]], 1)
        force = forces["joint_normal_force_N"][()][:, None] * normal + forces["joint_tangential_force_N"][()][:, None] * tangent
        on = np.zeros((int(joints["block_j"][()].max()) + 1, 2))
        np.add.at(on, joints["block_j"][()].astype(int), force)
        np.add.at(on, joints["block_i"][()].astype(int), -force)
        return on, force


class LimitAnalysis(unittest.TestCase):
    def test_oppenheims_arch_has_its_factor_its_mechanism_and_its_forces_on_any_ranks(self):
        first = None
        for ranks in (1, 2, 4):
            with self.subTest(ranks=ranks):
                out, said, result = analyse("oppenheim", "oppenheim-arch.xml", ranks=ranks)
                collapse = result["collapse"]
                self.assertLess(abs(collapse["certified_upper"] - 0.37023), 1e-4)  # Oppenheim (1992): 0.37 g
                self.assertIn("Limit analysis: above 0.370235 times the pattern no equilibrium exists", said)
                self.assertEqual(result["linear_solves"], 0)
                self.assertNotIn("lower", collapse)  # no equilibrium was computed
                with h5py.File(out / "fields.h5", "r") as file:
                    stages = [file["steps"][k].attrs["stage"] for k in sorted(file["steps"])]
                    status = file["steps"]["0003"]["joint_status"][()]
                    moved = np.abs(file["steps"]["0003"]["displacement"][()]).max()
                self.assertEqual([s if isinstance(s, str) else s.decode() for s in stages],
                                 ["limit analysis", "limit analysis: limit", "limit analysis: mechanism"])
                self.assertTrue((status == 0).any() and (status == 1).any())  # joints that open, joints that keep
                self.assertLessEqual(moved, 1 + 1e-9)
                first = first or result
                self.assertLess(abs(collapse["certified_upper"] - first["collapse"]["certified_upper"]), 1e-9)
                self.assertEqual(result["mechanism"]["largest_mover_block"], first["mechanism"]["largest_mover_block"])

    def test_what_the_input_leaves_open_is_told_of_rigid_stones_too(self):
        for ranks in (1, 2):
            _, said, result = analyse("unusual", "wall.xml", "mesh/wall/courses=4", "mesh/wall/blocks per course=4",
                                      "loads/sideways/ax=1.0", "materials/stone/density=2.0", "selection/mode=bonded", ranks=ranks)
            self.assertEqual([w["what"] for w in result["warnings"]], ["unusual_value"])  # and nothing of bonds, of which there are none
            last = said[said.index("Limit analysis:"):]
            self.assertIn("WARNING: ", last)
            self.assertIn("density", last)

    def test_forces_that_are_drawn_balance_every_stone(self):
        out, _, result = analyse("wall", "wall.xml", "mesh/wall/courses=4", "mesh/wall/blocks per course=4", "loads/sideways/ax=1.0")
        self.assertEqual(result["outcome"], "equilibrium")
        on, force = balance(out, "0001")
        free = on[np.abs(on).sum(1) > 0]
        weights = free[:, 1] / STONE
        stones = weights[weights > 0]  # what joints press on the ground with is the rest
        self.assertTrue(np.all(np.isclose(stones, 1.0, atol=1e-6) | np.isclose(stones, 0.5, atol=1e-6)), weights)
        self.assertLess(abs(on.sum()), 1e-6 * STONE)
        # Lawful: nothing pulls, and the wall's resultant is its weight and its push.
        with h5py.File(out / "fields.h5", "r") as file:
            self.assertGreaterEqual(file["steps"]["0001"]["joint_normal_force_N"][()].min(), -1e-6 * STONE)
        support, = result["rigid"]["reactions"].values()
        weight = stones.sum() * STONE
        for end in ("least_y_N", "most_y_N"):  # one support alone bears all
            self.assertGreaterEqual(support[end], weight * (1 - 1e-6))
        self.assertLess(abs(support["least_x_N"] - support["most_x_N"]), 1e-6 * weight)
        self.assertGreater(result["rigid"]["free_share_of_joints"], 0)

    def test_loads_that_nothing_balances_are_refused_with_their_mechanism(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                launch = [MPIEXEC, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
                out = empty(f"limit_analysis/slides on {ranks}")
                run = subprocess.run([*launch, PROGRAM, f"--xml={ROOT / 'xml' / 'incline.xml'}", "--limit-analysis", f"--out={out}",
                                      "--set", "mesh/gmsh/geometry/slope=0.7"], capture_output=True, text=True, check=False)
                self.assertIn("no equilibrium exists, by the static theorem", run.stdout)
                result = json.loads((out / "result.json").read_text(encoding="utf-8"))
                self.assertEqual(result["outcome"], "collapse")
                self.assertIn("mechanism", result)

    def test_the_report_draws_the_line_of_thrust_and_says_the_factor(self):
        out, _, _ = analyse("report", "oppenheim-arch.xml")
        subprocess.run([sys.executable, ROOT / "drivers" / "report" / "make_report.py", out], check=True, capture_output=True)
        page = (out / "report.html").read_text(encoding="utf-8")
        for words in ("No equilibrium above", "0.370235", "line of thrust", "Least and most thrust", "How it falls"):
            self.assertIn(words, page)
        self.assertNotIn("could not be drawn", page)
        for picture in ("thrust.png", "thrust_at_the_limit.png", "deformed.png"):
            self.assertTrue((out / "pictures" / picture).is_file(), picture)


if __name__ == "__main__":
    PROGRAM, MPIEXEC = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1], verbosity=2)

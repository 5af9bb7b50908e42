"""One scene on 1, 2 and 4 ranks: the same results.

    ranks.py PROGRAM MPIEXEC SCENE [path=value ...]

Displacements agree to 1e-8 of the largest, gaps as well. So do the contact forces every block receives at its nodes,
to 1e-6 of the largest (forces of single points are not unique where three blocks meet). Newton is run to 1e-11 of the
forces, a thousandth of what is asked of the displacement. Error estimates agree to 1e-4 of themselves: their linear
solve stops at that residual.
"""

import json
import pathlib
import subprocess
import sys

import h5py
import numpy as np

RANKS = (1, 2, 4)
DISPLACEMENT, FORCE, ESTIMATE = 1e-8, 1e-6, 1e-4


def last_step(folder):
    with h5py.File(folder / "fields.h5") as file:
        step = file["steps"][sorted(file["steps"])[-1]]
        joints = {name: table[()] for name, table in file["joints"].items()}
        return {name: table[()] for name, table in step.items() if isinstance(table, h5py.Dataset)}, joints, file["mesh/rank_of_block"][()]


def node_forces(step, joints, nodes):
    """Contact force on every node of every block [N]: 2 columns."""
    normal = joints["normal"]
    tangent = np.stack([-normal[:, 1], normal[:, 0]], 1)
    force = step["joint_normal_force_N"][:, None] * normal + step["joint_tangential_force_N"][:, None] * tangent
    total = np.zeros((nodes, 2))
    np.add.at(total, joints["node_j"], force)
    np.add.at(total, joints["node_i"], -force)
    return total


def main():
    program, mpiexec, scene, *settings = sys.argv[1:]
    name = "-".join([pathlib.Path(scene).stem] + [s.split("=")[1] for s in settings])
    results, estimates = {}, {}
    for ranks in RANKS:
        folder = pathlib.Path("ranks") / f"{name}-np{ranks}"
        command = [mpiexec, "--oversubscribe", "-np", str(ranks), program, f"--xml={scene}", f"--out={folder}",
                   "--quiet", "--overwrite", "--set", "newton/tolerance=1e-11"]
        for setting in settings:
            command += ["--set", setting]
        subprocess.run(command, check=True)
        results[ranks] = last_step(folder)
        estimates[ranks] = json.loads((folder / "result.json").read_text(encoding="utf-8"))["error_estimate"]
        used = len(set(results[ranks][2]))
        assert used == ranks, f"{used} of {ranks} ranks own blocks"

    step, joints, _ = results[1]
    largest = np.abs(step["displacement"]).max()
    forces = node_forces(step, joints, len(step["displacement"]))
    failed = False
    for ranks in RANKS[1:]:
        other, other_joints, _ = results[ranks]
        differences = {
            "displacement": np.abs(other["displacement"] - step["displacement"]).max() / largest,
            "gap": np.abs(other["joint_gap_m"] - step["joint_gap_m"]).max() / largest,
            "force": np.abs(node_forces(other, other_joints, len(forces)) - forces).max() / np.abs(forces).max(),
            "selected": np.abs(other["joint_selected"] - step["joint_selected"]).max(),
            "estimate": abs(estimates[ranks] - estimates[1]) / max(estimates[1], np.finfo(float).tiny),
        }
        print(f"{name}, {ranks} ranks: " + ", ".join(f"{key} {value:.1e}" for key, value in differences.items()))
        for table in ("normal", "block_i", "block_j", "node_i", "node_j", "area"):
            assert np.array_equal(other_joints[table], joints[table]), f"joints/{table} depends on the ranks"
        failed |= differences["displacement"] > DISPLACEMENT or differences["gap"] > DISPLACEMENT
        failed |= differences["force"] > FORCE or differences["selected"] > 0
        failed |= differences["estimate"] > ESTIMATE
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

"""One scene of the plane or in space on several numbers of ranks: the same results.

    ranks.py PROGRAM MPIEXEC SCENE [path=value ...] [--ranks 1,2,...]

Displacements agree to 1e-8 of the largest, gaps as well. So do the contact forces every block receives at its nodes,
to 1e-6 of the largest (forces of single points are not unique where three blocks meet). Newton is run to 1e-11 of the
forces, a thousandth of what is asked of the displacement. Error estimates agree to 1e-4 of themselves: their linear
solve stops at that residual. A point has another status only where that is no matter of results: its gap and its force
are within those bounds of none, or it has not slipped by more than they allow.
"""

import json
import pathlib
import subprocess
import sys

import h5py
import numpy as np

RANKS = (1, 2, 4)  # unless others are asked for
DISPLACEMENT, FORCE, ESTIMATE = 1e-8, 1e-6, 1e-4
OPEN, SLIP = 0, 2  # joint_status


def last_step(folder):
    with h5py.File(folder / "fields.h5") as file:
        step = file["steps"][sorted(file["steps"])[-1]]
        joints = {name: table[()] for name, table in file["joints"].items()}
        return {name: table[()] for name, table in step.items() if isinstance(table, h5py.Dataset)}, joints, file["mesh/rank_of_block"][()]


def point_forces(step, joints):
    """[N] of every point on its second node; in space they are in the file."""
    if "joint_force_N" in step:
        return step["joint_force_N"]
    normal = joints["normal"]
    tangent = np.stack([-normal[:, 1], normal[:, 0]], 1)
    return step["joint_normal_force_N"][:, None] * normal + step["joint_tangential_force_N"][:, None] * tangent


def strict_differences(step, other, far, strong):
    """How many points have another status, though gap, force or slip in either run say which.

    far [m] and strong [N] are what gaps, slips and forces may differ by.
    """
    def says(run):
        is_open = run["joint_status"] == OPEN
        gap, normal = run["joint_gap_m"], run["joint_normal_force_N"]
        moved = np.abs(run["joint_slip_m"]) > far
        return np.where(is_open, gap > far, np.abs(normal) > strong), np.where(run["joint_status"] == SLIP, moved, False)

    mine, its = step["joint_status"], other["joint_status"]
    opens = (mine == OPEN) != (its == OPEN)
    slips = ~opens & ((mine == SLIP) != (its == SLIP))
    (open_a, slip_a), (open_b, slip_b) = says(step), says(other)
    return int(np.sum(opens & (open_a | open_b)) + np.sum(slips & (slip_a | slip_b)))


def node_forces(step, joints, nodes):
    """Contact force on every node of every block [N]: a column per component."""
    force = point_forces(step, joints)
    total = np.zeros((nodes, force.shape[1]))
    np.add.at(total, joints["node_j"], force)
    np.add.at(total, joints["node_i"], -force)
    return total


def main():
    program, mpiexec, scene, *settings = sys.argv[1:]
    counts = RANKS
    if "--ranks" in settings:
        at = settings.index("--ranks")
        counts = [int(n) for n in settings[at + 1].split(",")]
        del settings[at:at + 2]
    name = "-".join([pathlib.Path(scene).stem] + [s.split("=")[1] for s in settings])
    results, estimates = {}, {}
    for ranks in counts:
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
    for ranks in counts[1:]:
        other, other_joints, _ = results[ranks]
        differences = {
            "displacement": np.abs(other["displacement"] - step["displacement"]).max() / largest,
            "gap": np.abs(other["joint_gap_m"] - step["joint_gap_m"]).max() / largest,
            "force": np.abs(node_forces(other, other_joints, len(forces)) - forces).max() / np.abs(forces).max(),
            "selected": np.abs(other["joint_selected"] - step["joint_selected"]).max(),
            "statuses": strict_differences(step, other, DISPLACEMENT * largest, FORCE * np.abs(forces).max()),
            "estimate": abs(estimates[ranks] - estimates[1]) / max(estimates[1], np.finfo(float).tiny),
        }
        print(f"{name}, {ranks} ranks: " + ", ".join(f"{key} {value:.1e}" for key, value in differences.items()))
        for table in ("normal", "block_i", "block_j", "node_i", "node_j", "area"):
            assert np.array_equal(other_joints[table], joints[table]), f"joints/{table} depends on the ranks"
        failed |= differences["displacement"] > DISPLACEMENT or differences["gap"] > DISPLACEMENT
        failed |= differences["force"] > FORCE or differences["selected"] > 0 or differences["statuses"] > 0
        failed |= differences["estimate"] > ESTIMATE
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

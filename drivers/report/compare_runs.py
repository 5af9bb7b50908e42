"""How far two runs of one structure in the plane are apart, such as adaptive selection from all points.

usage: compare_runs.py OUTDIR OTHER

Prints, of the steps that both have recorded, the largest difference of stresses in the norm of elastic energy over that
norm of OTHER in the same step, and of displacements of nodes over the largest displacement of OTHER in the same step.
Meshes must be the same, and stones of one material: its Young's modulus is in neither ratio.
"""

import sys
from pathlib import Path
from xml.etree import ElementTree

import h5py
import numpy as np
from read_results import MECHANISM


def areas(coordinates, cells):
    """Of triangles and quadrilaterals; a triangle repeats its last node."""
    x, y = np.moveaxis(coordinates[cells], 2, 0)
    return 0.5 * abs(sum(x[:, k - 1] * y[:, k] - x[:, k] * y[:, k - 1] for k in range(cells.shape[1])))


def energy(stress, area, poisson_ratio):
    """Twice the elastic energy times Young's modulus, a metre thick; of cells with constant plane stress."""
    xx, yy, xy = stress.T
    return float(area @ (xx**2 + yy**2 - 2 * poisson_ratio * xx * yy + 2 * (1 + poisson_ratio) * xy**2))


def effective_poisson_ratio(scene):
    """Plane strain is plane stress of a stone with the ratio nu / (1 - nu)."""
    values = {p.get("name"): p.get("value") for p in ElementTree.parse(scene).iter("Parameter")}
    ratio = float(values["Poisson ratio"])
    return ratio / (1 - ratio) if values.get("plane") == "strain" else ratio


def moment(step):
    """What tells a step whatever the number of those before it: its stage, the share of its loads, its time [s]."""
    stage, factor = step.attrs["stage"].decode(), step.attrs["load_factor"]
    return stage, round(float(factor), 9), round(float(step.attrs.get("time_s", 0)), 9)


def differences(out, other):
    """Per step that both have: moment, of stresses, of displacements."""
    found = []
    ratio = effective_poisson_ratio(Path(other) / "scene.xml")
    with h5py.File(Path(out) / "fields.h5") as a, h5py.File(Path(other) / "fields.h5") as b:
        cells, coordinates = b["mesh/cells"][()], b["mesh/coordinates"][()]
        if not np.array_equal(a["mesh/cells"][()], cells):
            sys.exit(f"The meshes of {out} and {other} are not the same.")
        area = areas(coordinates, cells)
        steps = {moment(step): step for step in b["steps"].values()}
        for step in a["steps"].values():
            when = moment(step)
            if when not in steps or when[0].endswith(MECHANISM):
                continue
            mine, its = (s["stress"][()] for s in (step, steps[when]))
            u, v = (s["displacement"][()] for s in (step, steps[when]))
            found.append((when, np.sqrt(energy(mine - its, area, ratio) / energy(its, area, ratio)),
                          np.linalg.norm(u - v, axis=1).max() / np.linalg.norm(v, axis=1).max()))
    return found


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    found = differences(*sys.argv[1:])
    if not found:
        sys.exit("There is no step that both runs have recorded.")
    for name, k in (("stresses", 1), ("displacements", 2)):
        largest = max(found, key=lambda at: at[k])
        stage, factor, time = largest[0]
        print(f"{name}: {100 * largest[k]:.2f} %, in stage '{stage}' at load factor {factor:g}, {time:g} s; "
              f"{len(found)} steps compared")


if __name__ == "__main__":
    main()

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
from read_results import is_mechanism, read_mesh, read_step


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
    parameters = list(ElementTree.parse(scene).iter("Parameter"))
    values = lambda name: {p.get("value") for p in parameters if p.get("name") == name}
    if len(values("Young modulus")) != 1 or len(values("Poisson ratio")) != 1:
        sys.exit(f"{scene} has stones of several stiffnesses, which this comparison does not know.")
    ratio = float(values("Poisson ratio").pop())
    return ratio / (1 - ratio) if "strain" in values("plane") else ratio


def moment(step):
    """What tells a step, however many there are in a run: its stage, the share of its loads, its time [s]."""
    return step.stage, round(step.load_factor, 9), round(np.nan_to_num(step.time), 9)


def differences(out, other):
    """Per step that both have: moment, of stresses, of displacements."""
    found = []
    ratio = effective_poisson_ratio(Path(other) / "scene.xml")
    with h5py.File(Path(out) / "fields.h5") as a, h5py.File(Path(other) / "fields.h5") as b:
        mesh = read_mesh(b)
        if mesh.in_space:
            sys.exit(f"{other} is a structure in space; this comparison is of the plane.")
        if not np.array_equal(read_mesh(a).cells, mesh.cells):
            sys.exit(f"The meshes of {out} and {other} are not the same.")
        area = areas(mesh.coordinates, mesh.cells)
        steps = lambda file: [read_step(name, group, 0) for name, group in file["steps"].items()]
        known = {moment(step): step for step in steps(b)}
        for mine in steps(a):
            its = known.get(moment(mine))
            if its is None or is_mechanism(mine):
                continue
            apart = energy(mine.stress - its.stress, area, ratio) / energy(its.stress, area, ratio)
            moved = np.linalg.norm(mine.displacement - its.displacement, axis=1).max()
            found.append((moment(mine), np.sqrt(apart), moved / its.largest_displacement))
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

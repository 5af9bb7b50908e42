"""What ParaView's own reader makes of the XDMF files of a run, against fields.h5 as h5py reads it.

usage: pvpython in_paraview.py FOLDER     (Debian's packages paraview, python3-paraview and python3-h5py)

Prints "agrees: ..." with what was compared, and ends with an error at the first number that is another. Without a screen.
"""
import sys
from pathlib import Path

import h5py
import numpy as np
from paraview import servermanager
from paraview.simple import OpenDataFile
from paraview.vtk.util.numpy_support import vtk_to_numpy

# Fields of a viewer: name there, dataset of a step (or of the file, where it begins with /).
STONES = {"displacement [m]": "displacement", "velocity [m/s]": "velocity", "stress xx, yy, xy [Pa]": "stress", "stress [Pa]": "stress",
          "block": "/mesh/block_of_cell", "rank": "/mesh/rank_of_cell"}
JOINTS = {"normal": "/joints/normal", "gap [m]": "joint_gap_m", "slip [m]": "joint_slip_m", "normal force [N]": "joint_normal_force_N",
          "tangential force [N]": "joint_tangential_force_N", "force on block j [N]": "joint_force_N", "status": "joint_status",
          "selected": "joint_selected", "damage": "joint_damage"}


def opened(path):
    source = OpenDataFile(str(path))
    if source is None:
        sys.exit(f"{path}: ParaView opens it as nothing")
    return source, list(source.TimestepValues)


def grid_at(source, time):
    source.UpdatePipeline(time or 0.0)
    data = servermanager.Fetch(source)
    while data.IsA("vtkMultiBlockDataSet"):
        if data.GetNumberOfBlocks() != 1:
            sys.exit(f"{data.GetNumberOfBlocks()} grids at a step, where one is wanted")
        data = data.GetBlock(0)
    return data


def fields_of(data):
    return {attributes.GetArrayName(k): vtk_to_numpy(attributes.GetArray(k))
            for attributes in (data.GetPointData(), data.GetCellData()) for k in range(attributes.GetNumberOfArrays())}


def in_three(values):
    """Viewers see three components of vectors of the plane."""
    values = np.asarray(values)
    return np.pad(values, ((0, 0), (0, 3 - values.shape[1]))) if values.ndim == 2 and values.shape[1] == 2 else values


def compare(file, step, data, places, names):
    """Places and all fields, to the last bit. How many numbers."""
    assert np.array_equal(vtk_to_numpy(data.GetPoints().GetData()), in_three(file[places][()])), places
    fields, count = fields_of(data), data.GetNumberOfPoints()
    wanted = {name for name, table in names.items() if (table in file if table.startswith("/") else table in step)}
    stresses = {name for name in wanted if name.startswith("stress")}  # the plane has the first, space the second
    wanted -= stresses - set(fields)
    assert set(fields) == wanted, f"{sorted(fields)} are there, {sorted(wanted)} wanted"
    for name, found in fields.items():
        table = names[name]
        stored = in_three((file[table] if table.startswith("/") else step[table])[()])
        assert found.shape == stored.shape and np.array_equal(found, stored), f"{step.name}: {name} is another"
        count += found.size
    return count


def corners(data):
    """Of all cells, the nodes one after the other."""
    return np.concatenate([[data.GetCell(k).GetPointId(n) for n in range(data.GetCell(k).GetNumberOfPoints())]
                           for k in range(data.GetNumberOfCells())])


def stored_corners(file):
    cells = file["mesh/cells"][()]
    if cells.ndim == 1:  # kinds and corners in one row
        at, nodes = 0, []
        while at < len(cells):
            count = {6: 4, 9: 8}[int(cells[at])]
            nodes.append(cells[at + 1:at + 1 + count])
            at += 1 + count
        return np.concatenate(nodes)
    return cells.reshape(-1)


def main():
    folder, told = Path(sys.argv[1]), []
    with h5py.File(folder / "fields.h5", "r") as file:
        steps = [file["steps"][name] for name in sorted(file["steps"])]
        for name, places, names in (("fields", "mesh/coordinates", STONES), ("joints", "joints/position", JOINTS), ("stones", "mesh/coordinates", STONES)):
            source, times = opened(folder / f"{name}.xdmf")
            chosen = list(zip(times, steps)) if times else [(None, steps[-1])]
            assert times == [] if name == "stones" else len(times) == len(steps), f"{name}: {times}"
            told.append(f"{name} {sum(compare(file, step, grid_at(source, time), places, names) for time, step in chosen)} numbers of {len(chosen)} steps")
            if name != "joints":
                assert np.array_equal(corners(grid_at(source, chosen[-1][0])), stored_corners(file)), f"{name}: other cells"
    print("agrees: " + "; ".join(told))


main()

"""Opens the fields.h5 and the XDMF files that test_fields_file left in a folder as a viewer would, through meshio.

Usage: read_fields.py FOLDER. The structure and the formulas of its values are those of fields_file.cpp.
"""
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

try:
    import h5py
    import meshio
    import numpy as np
    from meshio.xdmf import TimeSeriesReader
except ImportError as missing:
    sys.exit(f"{missing}\n  This test reads XDMF as viewers do.\n"
             "  On Debian: apt-get install python3-meshio python3-h5py")

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "support"))
import viewers  # noqa: E402  (a folder of its own)

# Values pass through files unchanged; 1e-15 relative allows the two languages to multiply in another order.
CLOSE = dict(rtol=1e-15, atol=1e-18)


def read_steps(path):
    """Points, cells and all steps (time, point data, cell data)."""
    with TimeSeriesReader(path) as reader:
        points, cells = reader.read_points_cells()
        return points, cells, [reader.read_data(k) for k in range(reader.num_steps)]


def check_declared_shapes(folder):
    """Viewers trust the Dimensions, types and precisions of XDMF; meshio does not look at them."""
    with h5py.File(folder / "fields.h5", "r") as file:
        items = [item for name in ("fields", "stones", "joints") for item in ElementTree.parse(folder / f"{name}.xdmf").iter("DataItem")]
        for item in items:
            name, _, table = item.text.partition(":")
            assert name == "fields.h5"
            declared = tuple(int(d) for d in item.get("Dimensions").split())
            data = file[table]
            assert declared == data.shape, f"{table}: {declared} declared, {data.shape} stored"
            kind = {"Float": "f", "Int": "i"}[item.get("NumberType")]
            assert (kind, int(item.get("Precision"))) == (data.dtype.kind, data.dtype.itemsize), table


def check_blocks(folder):
    points, cells, steps = read_steps(folder / "fields.xdmf")
    np.testing.assert_array_equal(points[:, 0], [0, 1, 1, 0, 1, 2, 2, 1])
    assert [block.type for block in cells] == ["quad"]
    np.testing.assert_array_equal(cells[0].data, [[0, 1, 2, 3], [4, 5, 6, 6], [4, 6, 7, 7]])
    assert [time for time, _, _ in steps] == [1.0, 2.0]
    node, cell = np.arange(8), np.arange(3)
    for step, (_, at_nodes, in_cells) in enumerate(steps, start=1):
        displacement = np.stack([0.001 * step * node, -0.002 * step * node, 0 * node], axis=1)
        np.testing.assert_allclose(at_nodes["displacement [m]"], displacement, **CLOSE)
        stress = np.stack([100.0 * step + cell, 10.0 * step + cell, cell], axis=1)
        np.testing.assert_allclose(in_cells["stress xx, yy, xy [Pa]"][0], stress, **CLOSE)
        np.testing.assert_array_equal(in_cells["block"][0], [0, 1, 1])
        assert "rank" in in_cells


def check_joints(folder):
    points, cells, steps = read_steps(folder / "joints.xdmf")
    np.testing.assert_array_equal(points, [[1, 0], [1, 1]])
    assert [block.type for block in cells] == ["vertex"]
    np.testing.assert_array_equal(np.ravel(cells[0].data), [0, 1])
    for step, (_, values, _) in enumerate(steps, start=1):
        np.testing.assert_array_equal(values["normal"], [[1, 0, 0], [1, 0, 0]])
        np.testing.assert_allclose(values["gap [m]"], [0, 1e-4 * step], **CLOSE)
        np.testing.assert_allclose(values["slip [m]"], 1e-5 * step, **CLOSE)
        np.testing.assert_allclose(values["normal force [N]"], 1000.0 * step, **CLOSE)
        np.testing.assert_allclose(values["tangential force [N]"], [0, -100.0], **CLOSE)
        np.testing.assert_array_equal(values["status"], [2, 0])
        np.testing.assert_array_equal(values["selected"], [1, 0])


def check_last_step(folder):
    """meshio.read takes one grid of one step: the stones at the last."""
    mesh = meshio.read(folder / "stones.xdmf")
    assert [(block.type, len(block.data)) for block in mesh.cells] == [("quad", 3)]
    node = np.arange(8)
    np.testing.assert_allclose(mesh.point_data["displacement [m]"], np.stack([0.002 * node, -0.004 * node, 0 * node], axis=1), **CLOSE)
    np.testing.assert_array_equal(mesh.cell_data["block"][0], [0, 1, 1])


def main():
    folder = Path(sys.argv[1])
    check_declared_shapes(folder)
    check_blocks(folder)
    check_joints(folder)
    check_last_step(folder)
    print(viewers.in_paraview(folder))


main()

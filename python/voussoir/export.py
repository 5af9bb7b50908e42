"""Meshes and fields as objects of meshio and PyVista, where these are installed."""

import numpy

from . import program

KINDS = {3: "triangle", 4: "quad", 8: "hexahedron"}


def cells_of(mesh):
    """Pairs of a kind and its cells, and the numbers of those cells: a cell of fewer corners repeats its last node."""
    corners = mesh.cells.shape[1]
    fewer = {4: 3, 8: 4}.get(corners) if corners > 3 else None
    repeats = (mesh.cells[:, fewer:] == mesh.cells[:, fewer - 1:fewer]).all(axis=1) if fewer else numpy.zeros(len(mesh.cells), bool)
    kinds = [(KINDS[corners], mesh.cells[~repeats], numpy.flatnonzero(~repeats))]
    if repeats.any():
        kinds.append(("tetra" if corners == 8 else "triangle", mesh.cells[repeats][:, :fewer], numpy.flatnonzero(repeats)))
    return [kind for kind in kinds if len(kind[1])]


def in_space(vectors):
    """With three components, as viewers want them."""
    return vectors if vectors.shape[1] == 3 else numpy.column_stack([vectors, numpy.zeros(len(vectors))])


def tables(result, step):
    """Of nodes and of cells: the fields of a step, None for the structure as built."""
    mesh = result.mesh
    of_nodes, of_cells = {"block": mesh.block_of_node}, {"block": mesh.block_of_cell}
    if step is not None:
        of_nodes["displacement"] = in_space(step.displacement)
        if step.stress is not None:
            of_cells["stress"] = step.stress
    return of_nodes, of_cells


def chosen(result, step):
    return result.steps[step] if isinstance(step, int) else step


def to_meshio(result, step=-1):
    """The stones as a meshio.Mesh with displacements and stresses.

    @param step  a number in result.steps, a Step, or None
    """
    try:
        import meshio
    except ImportError:
        raise program.ResourceError("meshio is not installed\n  so that no mesh of it can be made.\n  Install python3-meshio.") from None
    step = chosen(result, step)
    of_nodes, of_cells = tables(result, step)
    cells = cells_of(result.mesh)
    return meshio.Mesh(in_space(result.mesh.coordinates), [(kind, nodes) for kind, nodes, _ in cells], point_data=of_nodes,
                       cell_data={name: [values[which] for _, _, which in cells] for name, values in of_cells.items()})


def to_pyvista(result, step=-1):
    """The stones as a pyvista.UnstructuredGrid with displacements and stresses."""
    try:
        import pyvista
    except ImportError:
        raise program.ResourceError("pyvista is not installed\n  so that no grid of it can be made.\n"
                                    "  Install it by pip install pyvista.") from None
    return pyvista.from_meshio(to_meshio(result, step))

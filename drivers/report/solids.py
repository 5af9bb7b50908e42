"""Faces and edges of stones in space, from the cells that they are made of."""

import numpy as np

# Corners of the faces of cells, counter-clockwise seen from outside; a triangle has its last corner twice.
OF_HEXAHEDRON = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
OF_TETRAHEDRON = np.array([[0, 2, 1, 1], [0, 1, 3, 3], [1, 2, 3, 3], [2, 0, 3, 3]])
SAME_SIDE = np.cos(np.radians(10))  # faces of one side of a stone, between whose normals there is no more
ROUND_OFF = 1e-9  # of the size of the structure: places that are one


def all_faces(mesh):
    """Faces of all cells, [faces, 4] nodes, and their stones. A tetrahedron in a table of width 8 repeats its last node."""
    solid = np.zeros(len(mesh.cells), bool) if mesh.cells.shape[1] == 4 else mesh.cells[:, 4] != mesh.cells[:, 7]
    faces = [mesh.cells[~solid][:, OF_TETRAHEDRON].reshape(-1, 4)]
    block = [np.repeat(mesh.block_of_cell[~solid], len(OF_TETRAHEDRON))]
    if solid.any():
        faces.append(mesh.cells[solid][:, OF_HEXAHEDRON].reshape(-1, 4))
        block.append(np.repeat(mesh.block_of_cell[solid], len(OF_HEXAHEDRON)))
    return np.concatenate(faces), np.concatenate(block)


def alone(faces, number):
    """Which faces no other one covers, where `number` tells which nodes are one."""
    corners = number[faces]
    corners[faces[:, 2] == faces[:, 3], 3] = -1  # which corner a triangle has twice tells nothing
    _, first, count = np.unique(np.sort(corners, 1), axis=0, return_index=True, return_counts=True)
    return np.sort(first[count == 1])


def surfaces(mesh):
    """Faces of every stone that no other cell of it has, [faces, 4] nodes, and their stones."""
    faces, block = all_faces(mesh)
    kept = alone(faces, np.arange(len(mesh.coordinates)))  # stones share no nodes
    return faces[kept], block[kept]


def outer_faces(mesh):
    """Those that lie on no other stone either."""
    faces, block = all_faces(mesh)
    size = np.ptp(mesh.coordinates, axis=0).max()
    _, place = np.unique(np.round(mesh.coordinates / (ROUND_OFF * size)).astype(np.int64), axis=0, return_inverse=True)
    kept = alone(faces, place.reshape(-1))
    return faces[kept], block[kept]


def triangles(faces):
    """[triangles, 3] nodes."""
    return np.concatenate([faces[:, [0, 1, 2]], faces[faces[:, 2] != faces[:, 3]][:, [0, 2, 3]]])


def normals(mesh, faces):
    x = mesh.coordinates[faces]
    normal = np.cross(x[:, 2] - x[:, 0], x[:, 3] - x[:, 1])
    return normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)


def outlines(mesh, faces):
    """Edges of these faces but for those within one side of a stone, [edges, 2] nodes."""
    edges = np.sort(np.concatenate([faces[:, [k, (k + 1) % 4]] for k in range(4)]), 1)
    face = np.tile(np.arange(len(faces)), 4)
    real = edges[:, 0] != edges[:, 1]
    order = np.lexsort(edges[real].T)
    edges, face = edges[real][order], face[real][order]
    pairs = np.flatnonzero((edges[1:] == edges[:-1]).all(1))  # an edge and the one after it
    normal = normals(mesh, faces)
    inner = pairs[(normal[face[pairs]] * normal[face[pairs + 1]]).sum(1) > SAME_SIDE]
    shown = np.ones(len(edges), bool)
    shown[inner] = shown[inner + 1] = False
    shown[pairs + 1] = False  # once
    return edges[shown]

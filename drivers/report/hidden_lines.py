"""Lines of structures in space that no face hides, in parallel projection."""

import numpy as np

PIECES = 6       # of a line, each seen or hidden as a whole
ROUND_OFF = 1e-6  # of the size of the structure: a line on a face is not behind it


def cut(edges, nodes):
    """Cuts edges into pieces: the pieces [edges x PIECES, 2] by numbers of nodes, and of each node that is new, from
    `nodes` on, the ends of its edge and its share of the way."""
    shares = np.arange(1, PIECES) / PIECES
    new = nodes + np.arange(len(edges) * (PIECES - 1)).reshape(len(edges), PIECES - 1)
    chain = np.concatenate([edges[:, :1], new, edges[:, 1:]], 1)
    pieces = np.stack([chain[:, :-1], chain[:, 1:]], 2).reshape(-1, 2)
    return pieces, np.repeat(edges, PIECES - 1, 0), np.tile(shares, len(edges))[:, None]


def with_new_nodes(values, ends, shares):
    """Values of nodes, with those of new nodes between theirs."""
    return np.concatenate([values, (1 - shares) * values[ends[:, 0]] + shares * values[ends[:, 1]]])


def seen(points, corners):
    """Which points [points, 3] no face [faces, 4, 3] hides; the third component is the nearness to the viewer."""
    visible = np.ones(len(points), bool)
    if not len(points):
        return visible
    order = np.argsort(points[:, 0], kind="stable")
    x, y, near = points[order].T
    behind = ROUND_OFF * np.ptp(points, axis=0).max()
    for triangle in np.concatenate([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]]):
        low, high = triangle.min(0), triangle.max(0)
        a, b = np.searchsorted(x, [low[0], high[0]])
        k = a + np.flatnonzero((y[a:b] > low[1]) & (y[a:b] < high[1]) & (near[a:b] < high[2] - behind))
        if not len(k):
            continue
        sides = np.stack([triangle[1] - triangle[0], triangle[2] - triangle[0]], 1)
        if abs(np.linalg.det(sides[:2])) <= 1e-12 * (high - low)[:2].prod():
            continue  # seen from its edge
        share = np.linalg.solve(sides[:2], np.stack([x[k], y[k]]) - triangle[0, :2, None])
        inside = (share >= 0).all(0) & (share.sum(0) <= 1)
        hidden = inside & (near[k] < triangle[0, 2] + sides[2] @ share - behind)
        visible[order[k[hidden]]] = False
    return visible

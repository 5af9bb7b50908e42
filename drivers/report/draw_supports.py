"""Where supports hold a structure: hatching along an edge that is held, rollers along one that is held in one direction; of
structures in space the edges of stones that are held."""
import numpy as np
from matplotlib.lines import Line2D

from draw_common import INK, draw_lines, line_entry
from geometry import span

WHOLE = 3           # held along x and y
STROKE = 0.014      # of the span: length of a stroke of the hatching
MOST_STROKES = 600  # in a picture; longer edges have them farther apart


def held_edges(mesh, edges):
    """Edges of the outline that are held, [edges, 2] nodes, and whether along x and y."""
    both = mesh.held[edges[:, 0]] & mesh.held[edges[:, 1]]
    if mesh.projected:
        return edges[both > 0], np.ones(int((both > 0).sum()), bool)
    return edges[both > 0], both[both > 0] == WHOLE


def one_after_the_other(ends):
    """The order of edges in which those that lie on one line follow each other along it."""
    along = ends[:, 1] - ends[:, 0]
    way = np.round(along / np.maximum(np.linalg.norm(along, axis=1), 1e-300)[:, None])  # measured lines are not quite straight
    middle = ends.mean(1) / max(span(ends.reshape(-1, 2)), 1e-300)
    aside = np.round(middle[:, 1] * way[:, 0] - middle[:, 0] * way[:, 1], 1)
    return np.lexsort(((middle * way).sum(1), aside, way[:, 1], way[:, 0]))


def places_along(ends, distance):
    """Places every `distance` along the edges, and which edge each is on; edges follow each other (one_after_the_other)."""
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    whole = np.concatenate([[0.0], np.cumsum(length)])
    at = np.arange(distance / 2, whole[-1], distance)
    if not len(at):
        at = np.array([whole[-1] / 2])
    edge = np.clip(np.searchsorted(whole, at, side="right") - 1, 0, len(ends) - 1)
    share = (at - whole[edge]) / np.maximum(length[edge], 1e-300)
    return ends[edge, 0] + share[:, None] * (ends[edge, 1] - ends[edge, 0]), edge


def single_nodes(mesh, edges):
    """Held nodes of which no edge is held."""
    held = np.flatnonzero(mesh.held > 0)
    if mesh.projected:
        return held[:0]
    return np.setdiff1d(held, held_edges(mesh, edges)[0])


def draw_supports(axes, mesh, x, edges):
    """On the outside of the stones, for node positions x."""
    size = STROKE * span(mesh.coordinates)
    held, whole = held_edges(mesh, edges)
    for part, kind in ((held[whole], "fixed"), (held[~whole], "rollers")):
        if not len(part):
            continue
        ends = x[part][one_after_the_other(x[part])] if not mesh.projected else x[part]
        draw_lines(axes, ends, INK, 2.2 if mesh.projected else 1.6, zorder=3, clip_on=False)
        if mesh.projected:
            continue
        along = ends[:, 1] - ends[:, 0]
        length = np.linalg.norm(along, axis=1)
        along /= np.maximum(length, 1e-300)[:, None]
        outward = np.stack([along[:, 1], -along[:, 0]], 1)  # cells are counter-clockwise
        at, edge = places_along(ends, max((0.8 if kind == "fixed" else 1.6) * size, length.sum() / MOST_STROKES))
        if kind == "fixed":
            draw_lines(axes, np.stack([at, at + size * (outward[edge] - along[edge])], 1), INK, 0.7, zorder=3, clip_on=False)
        else:
            middle = at + 0.4 * size * outward[edge]
            axes.plot(*middle.T, "o", ms=4, mfc="white", mec=INK, mew=0.8, zorder=3, clip_on=False)
    nodes = single_nodes(mesh, edges)
    if len(nodes):
        axes.plot(*x[nodes].T, "^", ms=7, color=INK, zorder=3, clip_on=False)


def support_entries(mesh, edges):
    """Of a legend."""
    held, whole = held_edges(mesh, edges)
    entries = []
    if whole.any():
        entries.append(line_entry("held", INK, 1.6))
        if not mesh.projected:
            entries[-1].set_marker((4, 2, 45))
    if (~whole).any():
        entries.append(Line2D([], [], color=INK, lw=1.6, marker="o", mfc="white", mec=INK, label="held in one direction"))
    if len(single_nodes(mesh, edges)):
        entries.append(Line2D([], [], color="none", marker="^", mfc=INK, mec=INK, markersize=7, label="node held"))
    return entries

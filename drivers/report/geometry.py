"""Lines and numbers the pictures are made of: outlines of blocks, pieces of joints, round scales.

All tables are numpy arrays over nodes, edges or points, so that a picture of many blocks is one call.
"""
import numpy as np

from read_results import is_mechanism


def outline_edges(mesh):
    """Edges that belong to one cell only, [edges, 2] nodes. Blocks share no nodes, so this outlines every block."""
    edges = np.vstack([np.stack([mesh.cells[:, k], np.roll(mesh.cells, -1, 1)[:, k]], 1) for k in range(mesh.cells.shape[1])])
    edges = edges[edges[:, 0] != edges[:, 1]]
    key = edges.min(1).astype(np.int64) * len(mesh.coordinates) + edges.max(1)
    _, first, count = np.unique(key, return_index=True, return_counts=True)
    return edges[first[count == 1]]


class JointPieces:
    """Straight pieces of joints between neighbouring contact points of one joint.

    point   [pieces, 2] contact points at both ends
    """

    def __init__(self, mesh, joints, edges):
        nodes = np.int64(len(mesh.coordinates))
        outline = set((edges.min(1) * nodes + edges.max(1)).tolist())
        by_node = {}
        for point, (node, joint) in enumerate(zip(joints.node_i.tolist(), joints.joint.tolist())):
            by_node.setdefault(node, []).append((joint, point))
        pieces, node_j = [], joints.node_j
        for a, b in edges.tolist():
            if a not in by_node or b not in by_node:
                continue
            at_b = dict(by_node[b])
            for joint, point in by_node[a]:
                if joint in at_b:
                    other = at_b[joint]
                    low, high = sorted((int(node_j[point]), int(node_j[other])))
                    if low * int(nodes) + high in outline:
                        pieces.append((point, other))
        self.point = np.array(pieces, int).reshape(-1, 2)

    def lines(self, x, joints):
        """[pieces, 2 ends, 2] m: the line half-way between the two blocks, for node positions x."""
        middle = (x[joints.node_i] + x[joints.node_j]) / 2
        return middle[self.point]

    def gaping(self, x, joints):
        """[pieces, 4 corners, 2] m: the space between the two blocks, for node positions x."""
        i, j = x[joints.node_i], x[joints.node_j]
        return np.stack([i[self.point[:, 0]], i[self.point[:, 1]], j[self.point[:, 1]], j[self.point[:, 0]]], 1)

    def halves(self, x, joints):
        """Each piece cut in the middle: [2 x pieces, 2, 2] m and the contact point that governs each half."""
        line = self.lines(x, joints)
        middle = line.mean(1)
        return (np.concatenate([np.stack([line[:, 0], middle], 1), np.stack([middle, line[:, 1]], 1)]),
                np.concatenate([self.point[:, 0], self.point[:, 1]]))


def round_number(value, steps=(1, 1.5, 2, 3, 4, 5, 6, 8, 10)):
    """The number of `steps` x power of ten that is nearest to value > 0 in ratio."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(min((s * power for s in steps), key=lambda r: abs(np.log(r / value))))


def bounds(x):
    """x low, x high, y low, y high [m]."""
    return x[:, 0].min(), x[:, 0].max(), x[:, 1].min(), x[:, 1].max()


def span(x):
    """The longer side of the structure [m]."""
    low, high, bottom, top = bounds(x)
    return max(high - low, top - bottom)


def deformation_scale(mesh, step, share=0.04):
    """Round magnification that draws the largest displacement as about `share` of the span; true to scale where that is
    smaller than life, as stones that have turned far would shrink, unless something is out of sight then. 1 if nothing moves.
    The size of a mechanism means nothing."""
    largest, size = step.largest_displacement, span(mesh.coordinates)
    if not np.isfinite(largest) or largest <= 0:
        return 1.0
    scale = round_number(share * size / largest)
    return 1.0 if scale < 1 and largest < size and not is_mechanism(step) else scale


def deformed(mesh, step, scale):
    return mesh.coordinates + scale * np.nan_to_num(step.displacement)


def factor_text(scale):
    """'x 1500' without needless digits."""
    return f"× {scale:,.0f}".replace(",", " ") if scale >= 10 else f"× {scale:.2g}"


def counted(number, one, many=None):
    """A number of things in words: 1 stone, 1 300 stones; 1 vertex, 2 vertices."""
    return f"{number:,.0f}".replace(",", " ") + " " + (one if number == 1 else many or one + "s")


def length_text(metres):
    """A displacement or opening in the unit an engineer would say it in."""
    size = abs(metres)
    if size == 0:
        return "0 mm"
    if size < 1e-4:
        return f"{metres * 1e6:.3g} µm"
    return f"{metres * 1e3:.3g} mm" if size < 1 else f"{metres:.3g} m"


def force_text(newtons):
    size = abs(newtons)
    if size >= 1e6:
        return f"{newtons / 1e6:.3g} MN"
    return f"{newtons / 1e3:.3g} kN" if size >= 1e3 else f"{newtons:.3g} N"

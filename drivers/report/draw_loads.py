"""What acts on a structure: loads as arrows with their size, what acts on all of stones in words, reactions of supports.

Along an edge an arrow is as long as the force per length there; arrows of one load are in proportion, those of different
loads are not, since a pressure and an axle have no common scale: sizes stand in words.
"""
from dataclasses import dataclass

import numpy as np
from matplotlib import patheffects
from matplotlib.transforms import Bbox

from draw_common import BLUE, GREEN, PAPER, PURPLE, RED, STONE_PALE, STONE_EDGE, draw_lines, drawing, fill_cells, in_both_widths, legend, limits, line_entry
from draw_common import add_room_above, add_room_below, outline_width, save, visible
from draw_supports import draw_supports, support_entries
from geometry import force_text, length_text, span
from read_results import number

COLOURS = (RED, BLUE, PURPLE, "#7a5200", "#00615c", "#5c5c5c")
ARROWS = 24          # of one load: more are a black band
ALONG_EDGE, CONCENTRATED, REACTION = 0.07, 0.12, 0.13  # of the span: the longest arrow
MOST_MOVES = 60      # of a label that makes way, 4 points each
MARGIN = 2           # pixels between a label and what it leaves free
SMALL = 1e-3         # of the largest force of a load: not drawn
POINTS = ("point load", "moving train")  # kinds that act at points


@dataclass
class Arrow:
    at: np.ndarray     # [2] m, on the structure
    force: np.ndarray  # [2] N, or N/m along an edge
    outward: np.ndarray  # [2] unit, away from the stone; zeros where no edge says


def neighbours(edges, nodes):
    """Edges of which both nodes are among `nodes`."""
    return edges[np.isin(edges, nodes).all(1)]


def outward_of_nodes(x, edges, count):
    """[nodes, 2] unit, away from the stone at its outline."""
    along = x[edges[:, 1]] - x[edges[:, 0]]
    normal = np.stack([along[:, 1], -along[:, 0]], 1)
    sum_of = np.zeros((count, 2))
    for end in (0, 1):
        np.add.at(sum_of, edges[:, end], normal)
    return sum_of / np.maximum(np.linalg.norm(sum_of, axis=1), 1e-300)[:, None]


def groups(edges, nodes):
    """Nodes in groups that edges connect."""
    leader = {int(n): int(n) for n in nodes}

    def top(n):
        while leader[n] != n:
            leader[n] = leader[leader[n]]
            n = leader[n]
        return n

    for a, b in neighbours(edges, nodes):
        leader[top(int(a))] = top(int(b))
    found = {}
    for n in leader:
        found.setdefault(top(n), []).append(n)
    return [np.array(group) for group in found.values()]


def arrows_of(load, x, edges):
    """Arrows of a load and whether they are forces per length."""
    force = np.zeros((len(x), 2))
    np.add.at(force, load.node, load.force)
    nodes = np.unique(load.node)
    size = np.linalg.norm(force, axis=1)
    outward = outward_of_nodes(x, edges, len(x))
    near = neighbours(edges, nodes)
    if load.kind in POINTS or not len(near):
        arrows = []
        for group in groups(edges, nodes):
            weight = size[group]
            if weight.sum() > 0:
                arrows.append(Arrow((x[group] * weight[:, None]).sum(0) / weight.sum(), force[group].sum(0), outward[group[weight.argmax()]]))
        return arrows, False
    share = np.zeros(len(x))
    half = np.linalg.norm(x[near[:, 1]] - x[near[:, 0]], axis=1) / 2
    for end in (0, 1):
        np.add.at(share, near[:, end], half)
    nodes = nodes[share[nodes] > 0]
    nodes = nodes[np.lexsort((x[nodes, 1], x[nodes, 0]))]
    shown = nodes[np.unique(np.linspace(0, len(nodes) - 1, min(len(nodes), ARROWS)).round().astype(int))]
    beside = outward_of_nodes(x, near, len(x))  # of the edges that are loaded: at a corner another one leads elsewhere
    return [Arrow(x[n], force[n] / share[n], beside[n]) for n in shown], True


def line_of(arrow, length):
    """Tail and tip of an arrow, outside of the stone where an edge says where that is."""
    way = arrow.force / np.linalg.norm(arrow.force)
    if way @ arrow.outward > 0.1:
        return arrow.at, arrow.at + length * way
    return arrow.at - length * way, arrow.at


def draw_arrow(axes, words, tail, tip, colour, width=1.3, head=9):
    words.leave_free(tail, tip)
    axes.annotate("", xy=tip, xytext=tail, annotation_clip=False, zorder=6,
                  arrowprops=dict(arrowstyle="-|>", color=colour, lw=width, shrinkA=0, shrinkB=0, mutation_scale=head))


SPACE = (("along x", "against x"), ("along y", "against y"), ("upwards", "downwards"))


def direction(force):
    """Where a force goes, in a word or two."""
    if len(force) == 3:
        parts = [SPACE[k][int(c < 0)] for k, c in enumerate(force) if abs(c) > 0.02 * np.abs(force).max()]
        return " and ".join(parts)
    x, y = (0 if abs(c) < 0.02 * np.abs(force).max() else c for c in force)
    side, up = "to the right" if x > 0 else "to the left", "upwards" if y > 0 else "downwards"
    return up if x == 0 else side if y == 0 else f"{up} and {side}"


def size_text(force):
    return f"{force_text(np.linalg.norm(force))} {direction(force)}"


class Words:
    """Labels that make way for those that were there before."""

    def __init__(self, figure, axes, stones):
        """@param stones  [n, 2] m, places that words leave free where there is room beside them"""
        self.figure, self.axes = figure, axes
        self.stones = axes.transData.transform(stones)
        self.arrows = np.empty((0, 2))
        bar = axes.get_window_extent(figure.canvas.get_renderer())  # the scale bar stands at its lower left corner
        self.taken = [Bbox.from_extents(bar.x0, bar.y0 - 14, bar.x0 + 0.35 * bar.width, bar.y0 + 8)]

    def leave_free(self, tail, tip):
        """Words do not stand on an arrow."""
        ends = self.axes.transData.transform([tail, tip])
        self.arrows = np.concatenate([self.arrows, np.linspace(*ends, 20)])

    def add(self, at, outward, text, colour):
        shift = np.where(np.abs(outward) > 0.3 * np.linalg.norm(outward), np.sign(outward), 0)
        label = self.axes.annotate(text, at, xytext=5 * shift, textcoords="offset points", color=colour, annotation_clip=False, zorder=8,
                                   ha={-1: "right", 0: "center", 1: "left"}[int(shift[0])],
                                   va={-1: "top", 0: "center", 1: "bottom"}[int(shift[1])] if shift.any() else "bottom",
                                   path_effects=[patheffects.withStroke(linewidth=3, foreground="white")])
        renderer, step = self.figure.canvas.get_renderer(), 1 if shift[1] >= 0 else -1
        width = self.figure.bbox.width
        box = label.get_window_extent(renderer)
        over = (min(width - box.x1, 0) - min(box.x0, 0)) * 72 / self.figure.dpi
        if over:  # on the paper first
            x, y = label.get_position()
            label.set_position((x + over, y))
        x, y = label.get_position()
        ways = (step,) if shift[1] else (1, -1)  # beside an arrow there is room above and below
        for around in (np.concatenate([self.stones, self.arrows]), self.arrows, np.empty((0, 2))):
            for k in range(MOST_MOVES):
                for way in ways:
                    label.set_position((x, y + 4 * way * k))
                    box = label.get_window_extent(renderer)
                    beside = np.all((around > box.min - MARGIN) & (around < box.max + MARGIN), axis=1)
                    if not beside.any() and not any(box.overlaps(other) for other in self.taken):
                        self.taken.append(box)
                        return
        self.taken.append(box)

    def make_room(self):
        """Lets the paper grow by what stands beyond its upper and lower edge."""
        inches = lambda pixels: max(pixels, 0) / self.figure.dpi
        height = self.figure.bbox.height
        above, below = (inches(max((f(box) for box in self.taken), default=0)) for f in (lambda b: b.y1 - height, lambda b: 30 - b.y0))
        add_room_below(self.figure, below)
        add_room_above(self.figure, above)


def draw_load(axes, words, load, x, edges, colour, whole):
    """Arrows and words of one load; the places that they need."""
    arrows, per_length = arrows_of(load, x, edges)
    largest = max((np.linalg.norm(a.force) for a in arrows), default=0.0)
    arrows = [a for a in arrows if np.linalg.norm(a.force) > SMALL * largest]
    longest = (ALONG_EDGE if per_length else CONCENTRATED) * whole
    tails = []
    for arrow in arrows:
        tail, tip = line_of(arrow, longest * np.linalg.norm(arrow.force) / largest)
        draw_arrow(axes, words, tail, tip, colour, 1.0 if per_length else 1.8, 7 if per_length else 12)
        tails.append((tail if tip is arrow.at else tip, arrow))
    if not tails:
        return []
    if per_length:
        # Above the arrows, or below those that come from below: beside them stand stones.
        ends = np.array([far for far, _ in tails])
        below = np.mean([(far - arrow.at)[1] for far, arrow in tails]) < -0.5 * longest
        at = np.array([ends[:, 0].mean(), ends[:, 1].min() if below else max(ends[:, 1].max(), max(a.at[1] for a in arrows))])
        total = f"{visible(load.name)}: {size_text(load.total)},\nup to {force_text(largest)}/m"
        words.add(at, np.array([0.0, -1.0 if below else 1.0]), total, colour)
    else:
        for far, arrow in tails:
            words.add(far, far - arrow.at, f"{visible(load.name)}: {size_text(arrow.force)}", colour)
    return [far for far, _ in tails]


def reactions_of(results):
    """Rows (name, force [N], place [m]) of the supports of a plane structure in its last equilibrium."""
    told = (results.result.get("statics") or {}).get("reactions")
    rows = []
    for name, r in (told.items() if isinstance(told, dict) else ()):
        values = [number(r.get(key)) for key in ("x_N", "y_N", "through_x_m", "through_y_m")]
        if None not in values and np.hypot(*values[:2]) > 0:
            rows.append((name, np.array(values[:2]), np.array(values[2:])))
    return rows


def room_for(loads, reactions, x, edges, whole):
    """Places that arrows reach."""
    places = []
    for load in loads:
        for arrow in arrows_of(load, x, edges)[0]:
            if np.linalg.norm(arrow.force) > 0:
                places += line_of(arrow, CONCENTRATED * whole)
    for _, force, at in reactions:
        places.append(at - REACTION * whole * force / np.linalg.norm(force))
    return np.array(places).reshape(-1, 2)


@in_both_widths
def draw_loads(mesh, edges, loads, reactions, folder):
    """Loads on the structure as it was built and what supports answer."""
    x, whole = mesh.coordinates, span(mesh.coordinates)
    placed = [load for load in loads if len(load.node)]
    room = room_for(placed, reactions, x, edges, whole)
    # Words stand above and beside arrows: letters are as high on any structure, so room is in shares of the paper.
    margin = (0.15 if PAPER.is_narrow else 0.05) * whole
    box = limits(x, *([room] if len(room) else []))
    figure, axes = drawing((box[0] - margin, box[1] + margin, box[2] - margin, box[3] + 2 * margin))
    fill_cells(axes, x, mesh, STONE_PALE)
    draw_lines(axes, x[edges], STONE_EDGE, 0.6 * outline_width(mesh.blocks))
    draw_supports(axes, mesh, x, edges)
    words, entries = Words(figure, axes, x), support_entries(mesh, edges)
    for k, load in enumerate(placed):
        draw_load(axes, words, load, x, edges, COLOURS[k % len(COLOURS)], whole)
    largest = max((np.linalg.norm(force) for _, force, _ in reactions), default=0.0)
    shown = [row for row in reactions if np.linalg.norm(row[1]) >= SMALL * largest]
    tails = []
    for _, force, at in shown:
        size = np.linalg.norm(force)
        tails.append(at - REACTION * whole * (0.4 + 0.6 * size / largest) * force / size)
        draw_arrow(axes, words, tails[-1], at, GREEN, 2.0, 13)
    for tail, (name, force, at) in zip(tails, shown):
        size = np.linalg.norm(force)
        parts = [(force_text(abs(part)), direction(np.eye(2)[k] * part)) for k, part in enumerate(force) if abs(part) > SMALL * size]
        # What comes from aside has little room beside the stones, and words of one line need the most.
        between = "\n" if len(parts) == 1 and abs(force[0]) > abs(force[1]) else " "
        inner = between if PAPER.is_narrow else " "
        words.add(tail, tail - at, f"{visible(name)}:{between}" + ",\n".join(inner.join(part) for part in parts), "#00664b")
    words.make_room()
    if reactions:
        entries.append(line_entry("reaction of a support", GREEN, 2.0))
    legend(figure, entries)
    return save(figure, folder, "loads")


def face_edges(cells):
    """Pairs of nodes that are corners of one face."""
    return np.concatenate([cells[:, [a, b]] for a in range(cells.shape[1]) for b in range(a)])


@in_both_widths
def draw_loads_in_space(mesh, edges, loads, axes_seen, folder):
    """Loads on a structure in space as it is seen. axes_seen: [3, 2] of the picture"""
    x, whole = mesh.coordinates, span(mesh.coordinates)
    placed = [load for load in loads if len(load.node)]
    margin = np.array([[-0.1, -0.1], [0.1, 0.16]]) * (whole if placed else 0.0)
    low_high = np.array([x.min(0), x.max(0)])
    figure, axes = drawing(limits(x, low_high + margin))
    fill_cells(axes, x, mesh, STONE_PALE)
    draw_lines(axes, x[edges], STONE_EDGE, outline_width(mesh.blocks))
    draw_supports(axes, mesh, x, edges)
    words = Words(figure, axes, np.empty((0, 2)))
    for k, load in enumerate(placed):
        size, nodes = np.linalg.norm(load.force, axis=1), load.node
        at_points = load.kind in POINTS
        if at_points:
            together = groups(face_edges(mesh.cells), np.unique(nodes))
        else:
            shown = np.unique(np.linspace(0, len(nodes) - 1, min(len(nodes), 2 * ARROWS)).round().astype(int))
            together = [nodes[[n]] for n in shown]
        arrows = []
        for group in together:
            here = np.isin(nodes, group)
            if size[here].sum() > 0:
                arrows.append(((x[nodes[here]] * size[here, None]).sum(0) / size[here].sum(), load.force[here].sum(0)))
        largest = max((np.linalg.norm(force) for _, force in arrows), default=0.0)
        tails = []
        for at, force in arrows:
            if np.linalg.norm(force) > SMALL * largest:
                tails.append(at - (CONCENTRATED if at_points else ALONG_EDGE) * whole * force @ axes_seen / largest)
                draw_arrow(axes, words, tails[-1], at, COLOURS[k % len(COLOURS)], 1.6 if at_points else 0.9, 11 if at_points else 6)
        if tails:
            top = max(tails, key=lambda tail: tail[1])
            words.add(top, np.array([0.0, 1.0]), f"{visible(load.name)}: {size_text(load.total)}", COLOURS[k % len(COLOURS)])
    words.make_room()
    legend(figure, support_entries(mesh, edges))
    return save(figure, folder, "loads")


def words_of_arrows(loads):
    """What the arrows say, for those who do not see them."""
    return "; ".join(f"“{load.name}” ({load.kind}): {size_text(load.total)}" for load in loads if len(load.node))


def way_of_supports(mesh, step):
    """[m] The farthest that a held node has moved, along what is held."""
    held = np.stack([(mesh.held >> c) & 1 for c in range(mesh.coordinates.shape[1])], 1)
    return float(np.linalg.norm(np.nan_to_num(step.displacement) * held, axis=1).max(initial=0.0))


def words_of_loads(loads, moved):
    """What the arrows do not say: loads on all of stones, and those that have no forces. moved: [m] of supports, the largest"""
    said = []
    for load in loads:
        if len(load.node):
            continue
        if np.abs(load.total).max(initial=0) > 0 and load.kind != "temperature":
            told = size_text(load.total)
        elif load.kind == "settlement":
            told = f"supports have moved by up to {length_text(moved)}"
        else:
            told = f"factor {load.factor:.4g}"
        said.append(f"“{load.name}” ({load.kind}): {told}")
    return "; ".join(said)

"""What all pictures share: colours, frame, scale bar, saving.

Colours are those of Okabe and Ito, told apart by colour-blind readers; nothing is said by colour alone that the caption
or the line weight does not say too.
"""
import contextlib
import functools

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from PIL import Image

from geometry import bounds, round_number

RED, ORANGE, BLUE, GREEN, SKY = "#c8321e", "#e69f00", "#0072b2", "#009e73", "#56b4e9"
PURPLE, DARK_SKY = "#8a4f7d", "#2b6f94"
INK, GREY, PALE = "#222222", "#8c8c8c", "#c9c9c9"
STONE, STONE_EDGE, STONE_PALE = "#e5dcc8", "#6f6655", "#f3efe6"
# Stones of different sets: muted, equally light, apart in hue; after the last they start again.
SET_COLOURS = ("#e3c58f", "#a9c4dd", "#b9d3a8", "#dfae9b", "#c9b7d8", "#9fd0c7", "#efe1b4", "#c4c4c4", "#d9a9c4", "#b3b98a")

DPI = 160     # sharp on a printed page, and below 1 MB per picture


class Paper:
    """What pictures are drawn on. Letters have the same size on both, so that they are read on the page they are for."""
    width = 10.0  # inch: 1100 px of the page at 110 px per inch
    least = 6.5   # inch: room for a scale bar and a legend
    suffix = ""   # of the name of the file

    @property
    def is_narrow(self):
        return bool(self.suffix)


PAPER = Paper()
COLOURS = 256        # of lines and stones, all that a palette can hold: a third of the bytes; a scale would show steps
NARROW = 5.0         # inch: on a screen of 400 px letters of 10 points are 10 px high
NARROW_COLOURS = 96  # of its palette, which a screen of that size does not show


@contextlib.contextmanager
def narrow_paper():
    PAPER.width, PAPER.least, PAPER.suffix = NARROW, NARROW, "-narrow"
    try:
        yield
    finally:
        del PAPER.width, PAPER.least, PAPER.suffix


def in_both_widths(draw):
    """Of a function that saves one picture: draws it for a page and once more for a narrow screen, NAME-narrow.png."""
    @functools.wraps(draw)
    def both(*arguments, **named):
        drawn = draw(*arguments, **named)
        with narrow_paper():
            draw(*arguments, **named)
        return drawn
    return both


def panels(heights, ratios):
    """Axes side by side, or below each other where the paper is narrow. heights: [inch] of one, side by side and below each other"""
    across, below = heights
    if PAPER.is_narrow:
        return plt.subplots(len(ratios), 1, figsize=(PAPER.width, below * len(ratios)), squeeze=False)
    return plt.subplots(1, len(ratios), figsize=(PAPER.width, across), gridspec_kw=dict(width_ratios=ratios), squeeze=False)

plt.rcParams.update({
    "font.family": "sans-serif", "font.size": 10, "axes.titlesize": 10, "axes.labelsize": 10, "legend.fontsize": 10,
    "xtick.labelsize": 9, "ytick.labelsize": 9, "axes.edgecolor": GREY, "axes.labelcolor": INK, "text.color": INK,
    "xtick.color": INK, "ytick.color": INK, "axes.spines.top": False, "axes.spines.right": False,
    "text.parse_math": False})  # names from the scene may hold dollar signs


def visible(name):
    """A name as matplotlib can draw it: no control characters, no endless lines, no first underscore (a legend drops it)."""
    name = "".join(c if c.isprintable() else " " for c in str(name))
    name = f" {name}" if name.startswith("_") else name
    return name if len(name) <= 40 else name[:38] + "…"


def limits(*shapes):
    """x low, x high, y low, y high of several [n, 2] tables with a margin of 2 %."""
    low, high, bottom, top = bounds(np.vstack(shapes))
    margin = 0.02 * max(high - low, top - bottom, 1e-9)
    return low - margin, high + margin, bottom - margin, top + margin


def frame_size(box, width, highest):
    """Width and height [inch] of a drawing with equal aspect."""
    height = width * (box[3] - box[2]) / (box[1] - box[0])
    return (width, height) if height <= highest else (width * highest / height, highest)


def prepare(axes, box, bar=True):
    axes.set_xlim(box[0], box[1])
    axes.set_ylim(box[2], box[3])
    axes.set_aspect("equal")
    axes.axis("off")
    if bar:
        scale_bar(axes, box)


def scale_bar(axes, box):
    """A bar of round length below the drawing."""
    length = round_number(0.15 * (box[1] - box[0]), (1, 2, 5, 10))
    y, tick = box[2] - 0.012 * (box[1] - box[0]), 0.006 * (box[1] - box[0])
    x0, x1 = box[0] + 0.02 * (box[1] - box[0]), box[0] + 0.02 * (box[1] - box[0]) + length
    axes.plot([x0, x0, x0, x1, x1, x1], [y - tick, y + tick, y, y, y - tick, y + tick], color=INK, lw=1.2, clip_on=False)
    label = f"{length:g} m" if length >= 0.01 else f"{length * 1000:g} mm"
    axes.annotate(label, (x1, y), xytext=(5, 0), textcoords="offset points", va="center", ha="left", annotation_clip=False)


def drawing(box, bottom=0.55, right=0.0, highest=7.5):
    """Figure and axes for one drawing of the structure, with room [inch] below and at the right for legends."""
    width, height = frame_size(box, PAPER.width - right, highest)
    total_width, total_height = max(width + right, PAPER.least), height + bottom + 0.1
    figure = plt.figure(figsize=(total_width, total_height))
    left = (total_width - right - width) / 2 / total_width
    axes = figure.add_axes([left, bottom / total_height, width / total_width, height / total_height])
    prepare(axes, box)
    return figure, axes


def add_room(figure, below, above):
    """Makes the figure higher [inch], what is drawn staying as large as it is."""
    width, height = figure.get_size_inches()
    whole = height + below + above
    places = [axes.get_position() for axes in figure.axes]
    figure.set_size_inches(width, whole)
    for axes, place in zip(figure.axes, places):
        axes.set_position([place.x0, (place.y0 * height + below) / whole, place.width, place.height * height / whole])


def add_room_below(figure, inches):
    add_room(figure, inches, 0.0)


def add_room_above(figure, inches):
    add_room(figure, 0.0, inches)


def legend(figure, entries, most=6, bar=True):
    """Legend below the drawing, in as many columns as fit.

    bar  a scale bar stands at the left of its first row
    """
    if not entries:
        return
    width = figure.get_size_inches()[0]
    make = lambda columns: figure.legend(handles=entries, loc="lower right", bbox_to_anchor=(0.995, 0.0), ncol=columns, frameon=False,
                                         handlelength=1.8, columnspacing=1.6, borderaxespad=0.2)
    size = lambda made: made.get_window_extent(figure.canvas.get_renderer())
    for columns in range(min(most, len(entries)), 0, -1):
        made = make(columns)
        if size(made).width / figure.dpi < width - (1.7 if bar and columns == len(entries) else 0.1) or columns == 1:
            break
        made.remove()
    if columns == len(entries):
        return
    add_room_below(figure, size(made).height / figure.dpi - (0.0 if bar else 0.25))


def line_entry(label, colour, width=2.0):
    return Line2D([], [], color=colour, lw=width, label=label)


def dot_entry(label, colour, size=7, edge="white", marker="o"):
    return Line2D([], [], color="none", marker=marker, markerfacecolor=colour, markeredgecolor=edge, markersize=size, label=label)


def fill_cells(axes, x, mesh, colours):
    """All cells in one call; no smoothing, so that no seams show between them."""
    axes.add_collection(PolyCollection(x[mesh.cells], facecolors=colours, edgecolors="none", antialiased=False))


def draw_lines(axes, lines, colour, width, **more):
    axes.add_collection(LineCollection(lines, colors=colour, linewidths=width, capstyle="round", **more))


def outline_width(blocks):
    """Thin lines for many stones, so that a bridge does not turn black."""
    return float(np.clip(8.0 / np.sqrt(max(blocks, 1)), 0.35, 0.9))


def save_study(figure, folder, name):
    """Writes NAME.png and NAME.svg beside the table of a study."""
    figure.savefig(folder / f"{name}.png", dpi=DPI, facecolor="white")
    figure.savefig(folder / f"{name}.svg", facecolor="white")
    print(f"Picture: {folder}/{name}.png")


def save(figure, folder, name, has_scale=False):
    """Writes pictures/NAME.png and closes the figure; returns its path. One with a scale of colours keeps them all."""
    path = folder / f"{name}{PAPER.suffix}.png"
    figure.savefig(path, dpi=DPI, facecolor="white")
    plt.close(figure)
    if has_scale and not PAPER.is_narrow:
        return path
    with Image.open(path) as image:
        few = image.convert("RGB").quantize(NARROW_COLOURS if PAPER.is_narrow else COLOURS, dither=Image.Dither.NONE)
    few.save(path, optimize=True)
    return path

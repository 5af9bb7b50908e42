"""The picture of a sweep: a curve over one input, a map over two, curves beside each other over more."""
import matplotlib.pyplot as plt
import numpy as np

from draw_common import BLUE, GREY, INK, ORANGE, PAPER, RED, in_both_widths, visible
from draw_time import STYLES
from read_results import number

FALLS = ("collapse", "out_of_range")
MOST_CURVES = 6  # more cannot be told apart
MOST_WORDS = 12  # labels on an axis of words
# What is worth drawing, the first of these that any run has: column, words, factor to the unit of the words, unit.
SHOWN = (("factor_stands", "load factor that stands", 1, ""), ("factor_falls", "load factor that falls", 1, ""),
         ("largest_displacement_m", "largest displacement", 1e3, "mm"))


def value_of(row, column):
    found = number(row.get(column))
    return np.nan if found is None else found


def varied(inputs):
    """Inputs of more than one value."""
    return [path for path, values in inputs.items() if len(values) > 1]


def shown_quantity(rows):
    return next((shown for shown in SHOWN if any(number(row.get(shown[0])) is not None for row in rows)), None)


def short(path):
    """The last name of a path of keys, which says what is varied: "Young modulus"."""
    return path.rsplit("/", 1)[-1]


def names_of(paths, units=None):
    """What is varied in words, with units: the last name of each path, or the whole path where others end alike."""
    last = [short(path) for path in paths]
    return {path: label(path if last.count(short(path)) > 1 else short(path), (units or {}).get(path, "")) for path in paths}


def label(words, unit):
    return f"{words} [{unit}]" if unit else words


class Axis:
    """Places of the values of an input: numbers where all are numbers, else words in their order."""

    def __init__(self, path, values):
        self.path, self.values = path, values
        found = [number(value) for value in values]
        self.words = any(value is None for value in found)
        self.places = {value: float(k) if self.words else found[k] for k, value in enumerate(values)}

    def mark(self, axis):
        if self.words:
            shown = self.values[::max(1, -(-len(self.values) // MOST_WORDS))]
            axis.set_ticks([self.places[value] for value in shown], [visible(value) for value in shown])
        elif len(self.values) <= MOST_WORDS // 2:
            axis.set_ticks(list(self.places.values()), [visible(value) for value in self.values])


def curve(axes, rows, axis, shown, style, words):
    """One quantity over one input; of a search for a load factor both ends of the bracket."""
    column, _, factor, _ = shown
    rows = sorted(rows, key=lambda row: axis.places[row[axis.path]])
    x = np.array([axis.places[row[axis.path]] for row in rows])
    y = factor * np.array([value_of(row, column) for row in rows])
    colour, line = style
    drawn = ~np.isnan(y)
    axes.plot(x[drawn], y[drawn], color=colour, ls=line, lw=1.8, marker="o", ms=5, label=words)
    if column == "factor_stands":
        top = np.array([value_of(row, "factor_falls") for row in rows])
        both = drawn & ~np.isnan(top)
        axes.vlines(x[both], y[both], top[both], color=colour, lw=1.2)
        axes.plot(x[both], top[both], color=colour, ls="none", marker="v", ms=5)
    elif column != "factor_falls":
        fell = drawn & np.array([row["outcome"] in FALLS for row in rows])
        axes.plot(x[fell], y[fell], color=RED, ls="none", marker="x", ms=9, mew=2)
    for k in np.flatnonzero(~drawn):
        axes.axvline(x[k], color=GREY, lw=0.8, ls=":")
        axes.text(x[k], 0.98, visible(rows[k]["outcome"].replace("_", " ")), rotation=90, ha="right", va="top", fontsize=9,
                  color=GREY, transform=axes.get_xaxis_transform())


def draw_curves(rows, inputs, paths, shown, names):
    """Over the first input, a curve for each combination of the others; None where there are too many."""
    others = paths[1:]
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[path] for path in others), []).append(row)
    if len(groups) > MOST_CURVES:
        return None
    figure, axes = plt.subplots(figsize=(PAPER.width, 3.8) if PAPER.is_narrow else (8, 4.5), layout="constrained")
    axis = Axis(paths[0], inputs[paths[0]])
    for (values, group), style in zip(groups.items(), STYLES):
        curve(axes, group, axis, shown, style, visible(", ".join(f"{names[path]} {value}" for path, value in zip(others, values))))
    axis.mark(axes.xaxis)
    axes.set_xlabel(visible(names[paths[0]]), fontsize=13)
    axes.set_ylabel(label(shown[1], shown[3]), fontsize=13)
    axes.tick_params(labelsize=12)
    axes.grid(color=GREY, alpha=0.25, lw=0.6)
    if others:
        axes.legend(frameon=False, fontsize=11)
    return figure


def draw_map(rows, inputs, paths, shown, names):
    """Over two inputs, with the number in every cell."""
    column, words, factor, unit = shown
    across, up = (inputs[path] for path in paths)
    table = np.full((len(up), len(across)), np.nan)
    outcome = {}
    for row in rows:
        place = up.index(row[paths[1]]), across.index(row[paths[0]])
        table[place] = factor * value_of(row, column)
        outcome[place] = row["outcome"]
    wide = max(PAPER.width if PAPER.is_narrow else 6, 1.2 + 1.1 * len(across))
    figure, axes = plt.subplots(figsize=(wide, max(3.5, 1.2 + 0.6 * len(up))), layout="constrained")
    image = axes.imshow(np.ma.masked_invalid(table), origin="lower", aspect="auto", cmap="cividis")
    low, high = np.nanmin(table), np.nanmax(table)
    small = len(across) > 12 or len(up) > 20
    for (j, i), what in outcome.items():
        told = np.isnan(table[j, i])
        dark = not told and table[j, i] < (low + high) / 2
        if not small or told:
            axes.text(i, j, visible(what.replace("_", " ")) if told else f"{table[j, i]:.3g}", ha="center", va="center",
                      fontsize=9 if told else 11, color=GREY if told else "white" if dark else INK)
        if not told and what in FALLS and not column.startswith("factor"):
            axes.add_patch(plt.Rectangle((i - 0.5, j - 0.5), 1, 1, fill=False, edgecolor=ORANGE, lw=3))
    axes.set_xticks(range(len(across)), [visible(value) for value in across])
    axes.set_yticks(range(len(up)), [visible(value) for value in up])
    axes.set_xlabel(visible(names[paths[0]]), fontsize=13)
    axes.set_ylabel(visible(names[paths[1]]), fontsize=13)
    axes.tick_params(labelsize=12)
    figure.colorbar(image, ax=axes, label=label(words, unit))
    return figure


def extremes(rows, shown):
    """Words with the numbers of the picture: least and most of what is drawn, and where."""
    column, words, factor, unit = shown
    known = [row for row in rows if number(row.get(column)) is not None]
    least, most = (choose(known, key=lambda row: value_of(row, column)) for choose in (min, max))
    open_end = lambda row: column == "factor_stands" and number(row.get("factor_falls")) is None  # the search ended there
    of = lambda row: (f"{'at least ' if open_end(row) else ''}{factor * value_of(row, column):.4g}{' ' + unit if unit else ''} "
                      f"({row['run']})")
    return f"{words[0].upper()}{words[1:]}: least {of(least)}, most {of(most)}."


@in_both_widths
def draw_sweep(rows, inputs, together, folder, units=None):
    """Writes sweep.svg; its path and its caption, or None and why there is none."""
    paths, shown, names = varied(inputs), shown_quantity(rows), names_of(list(inputs), units)
    fell = any(row["outcome"] in FALLS for row in rows)
    if not shown:
        return None, "No run has a quantity that could be drawn."
    if not paths:
        return None, "No input has more than one value, so there is nothing to draw over."
    if len(paths) == 2 and not together:
        figure = draw_map(rows, inputs, paths, shown, names)
        kind = f"Map over {names[paths[0]]} (across) and {names[paths[1]]} (up)"
        marks = " Cells with a frame fell." if fell and not shown[0].startswith("factor") else ""
    else:
        paths = paths[:1] if together else paths
        figure = draw_curves(rows, inputs, paths, shown, names)
        kind = f"Curve over {names[paths[0]]}" + (f", one for each combination of {' and '.join(names[path] for path in paths[1:])}" if paths[1:] else "")
        marks = (" Triangles: the smallest factor that is excluded." if shown[0] == "factor_stands"
                 else " Crosses: runs that fell." if fell and not shown[0].startswith("factor") else "")
    if figure is None:
        return None, f"More than {MOST_CURVES} curves cannot be told apart; the table has all rows."
    path = folder / f"sweep{PAPER.suffix}.svg"
    figure.savefig(path, facecolor="white", metadata={"Date": None})
    plt.close(figure)
    return path, f"{kind}. {extremes(rows, shown)}{marks}"

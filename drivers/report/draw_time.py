"""How energies and observed places move, over time where the run has time, else over load steps."""
import re

import matplotlib.pyplot as plt
import numpy as np

from draw_common import BLUE, DARK_SKY, GREEN, GREY, INK, ORANGE, PURPLE, RED, PAPER, add_room_below, in_both_widths, legend, panels, save, visible
from draw_cost import column

PLACES = 6  # in one picture: more lines than that cannot be told apart
STYLES = tuple(zip((BLUE, ORANGE, GREEN, RED, PURPLE, DARK_SKY), ("-", "--", "-.", (0, (5, 1)), (0, (1, 1)), (0, (3, 1, 1, 1)))))
# Column of history.csv -> what of which place, as src/output/README.md says.
OBSERVED = re.compile(r"([uvf][xyz])_(?:m|m_per_s|N) of (.*)", re.DOTALL)
ROUND_OFF = 1e-9  # of a way that stays
SMALLEST = 1e-16  # of the largest energy: round-off, and the bottom of a logarithmic axis


class Course:
    """What the rows of a history are drawn over: time in a unit that suits it, else the number of the step."""

    def __init__(self, history):
        time = column(history, "time_s")
        self.in_time = bool(np.isfinite(time).any())
        if not self.in_time:
            self.x, self.label = np.arange(1.0, len(history) + 1), "load step"
            return
        # Load steps take no time: they stand at the time that had passed before them.
        last = np.maximum.accumulate(np.where(np.isfinite(time), time, -np.inf))
        time = np.where(np.isfinite(last), last, 0.0)
        milli = time.max() < 0.1
        self.x, self.label = time * (1e3 if milli else 1), "time [ms]" if milli else "time [s]"

    def prepare(self, axes):
        axes.set_xlabel(self.label)
        axes.margins(x=0.01)
        axes.grid(axis="y", color=GREY, alpha=0.25, lw=0.6)
        if not self.in_time:
            axes.xaxis.set_major_locator(plt.MaxNLocator(integer=True, nbins=8))


def marks(count):
    return dict(marker="o", ms=3.0 if count < 40 else 0, lw=1.4)


def prefixed(largest, unit):
    """Factor and unit in which a quantity is read easily: (1e3, 'mJ') for 0.02 J."""
    for factor, prefix in ((1e-6, "M"), (1e-3, "k"), (1.0, ""), (1e3, "m"), (1e6, "µ")):
        if largest * factor >= 1:
            return factor, prefix + unit
    return 1e9, "n" + unit


@in_both_widths
def draw_energy(history, folder):
    """Energy book and what it cannot explain; path and the largest unexplained share, or None without a course."""
    if len(history) < 2 or "elastic_J" not in history[0]:
        return None
    course = Course(history)
    energies = {name: column(history, f"{key}_J") for name, key in
                (("external work", "external_work"), ("elastic", "elastic"), ("kinetic", "kinetic"), ("friction", "friction"),
                 ("fracture", "fracture"), ("damping", "damping"), ("jumps", "jump"))
                if f"{key}_J" in history[0]}
    present = {name: value for name, value in energies.items() if np.nanmax(np.abs(value), initial=0) > 0}
    largest = max((np.nanmax(np.abs(value)) for value in present.values()), default=0)
    if not largest > 0:
        return None
    factor, unit = prefixed(largest, "J")
    figure, axes = panels((3.6, 2.8), (1.6, 1))
    axes = axes.reshape(-1)
    shades = dict(zip(energies, ((INK, "--"), (BLUE, "-"), (GREEN, "-"), (ORANGE, "-"), (RED, "-"), (PURPLE, "-"), (RED, ":"))))
    for name, value in present.items():
        colour, style = shades[name]
        on_top = 3 if name == "external work" else 2  # dashed, so that what it hides shows through
        axes[0].plot(course.x, factor * value, color=colour, ls=style, label=name, zorder=on_top, **marks(len(history)))
    axes[0].set_title(f"energy book [{unit}]", loc="left")
    name = "imbalance_in_time_J" if course.in_time else "imbalance_J"
    share = np.abs(column(history, name)) / largest
    axes[1].plot(course.x, np.maximum(share, SMALLEST), color=INK, **marks(len(history)))
    axes[1].set_yscale("log")
    axes[1].yaxis.set_major_formatter(plt.FuncFormatter(lambda value, _: f"{value:.0e}"))
    axes[1].yaxis.set_minor_formatter(plt.NullFormatter())
    axes[1].set_title(f"not explained{' in time' if course.in_time else ''} / largest", loc="left")
    for panel in axes:
        course.prepare(panel)
    legend_of_lines(figure, axes[0])
    return save(figure, folder, "energy"), float(np.nanmax(share, initial=0)), course.in_time


def legend_of_lines(figure, axes):
    """The lines of one panel, below all panels."""
    lines, names = axes.get_legend_handles_labels()
    figure.tight_layout(w_pad=2)
    add_room_below(figure, 0.3)
    legend(figure, lines, most=6 if not PAPER.is_narrow else 3, bar=False)


def observed_places(history):
    """Name of a place -> {'ux': values, ...}, in the order of the scene."""
    places = {}
    for key in history[0] if history else ():
        found = OBSERVED.fullmatch(key) if isinstance(key, str) else None
        if found:
            places.setdefault(found.group(2), {})[found.group(1)] = column(history, key)
    return places


@in_both_widths
def draw_places(history, places, folder):
    """Displacements of the places, and velocities in time; None without a course."""
    if len(history) < 2 or not places:
        return None
    course = Course(history)
    shown = dict(list(places.items())[:PLACES])
    rows = [("u", "displacement", "m")]
    if course.in_time and any("vx" in values for values in shown.values()):
        rows.append(("v", "velocity", "m/s"))
    shape = (2 * len(rows), 1) if PAPER.is_narrow else (len(rows), 2)
    figure, axes = plt.subplots(*shape, figsize=(PAPER.width, 0.4 + 2.5 * shape[0]), squeeze=False)
    axes = axes.reshape(len(rows), 2)
    for (letter, what, unit), panels in zip(rows, axes):
        largest = max((np.nanmax(np.abs(v), initial=0) for values in shown.values() for k, v in values.items() if k[0] == letter),
                      default=0)
        factor, unit = prefixed(largest, unit) if largest > 0 else (1.0, unit)
        for panel, direction, sense in zip(panels, "xy", ("to the right", "upwards")):
            for (name, values), (colour, style) in zip(shown.items(), STYLES):
                if letter + direction in values:
                    panel.plot(course.x, factor * values[letter + direction], color=colour, ls=style, label=visible(name),
                               **marks(len(history)))
            panel.set_title(f"{what} {sense} [{unit}]", loc="left")
            course.prepare(panel)
    legend_of_lines(figure, axes[0][0])
    return save(figure, folder, "places")


@in_both_widths
def draw_supports(history, places, folder):
    """Force of each support that moves step by step over its way, one panel per direction; None where none does."""
    moving = {}  # direction -> name -> way [m], force [N]
    for name, values in places.items():
        for direction in "xy":
            way, force = values["u" + direction], values.get("f" + direction)
            if force is not None and np.ptp(way) > ROUND_OFF * np.abs(way).max() and np.nanmax(np.abs(force), initial=0) > 0:
                moving.setdefault(direction, {})[name] = way, force
    if len(history) < 2 or not moving:
        return None
    figure, axes = panels((3.4, 3.0), (1,) * len(moving))
    for panel, (direction, curves) in zip(axes.reshape(-1), moving.items()):
        sense = {"x": "to the right", "y": "upwards"}[direction]
        in_metres, metres = prefixed(max(np.nanmax(np.abs(way)) for way, _ in curves.values()), "m")
        in_newtons, newtons = prefixed(max(np.nanmax(np.abs(force)) for _, force in curves.values()), "N")
        for (name, (way, force)), (colour, style) in zip(list(curves.items())[:PLACES], STYLES):
            panel.plot(in_metres * way, in_newtons * force, color=colour, ls=style, label=visible(name), **marks(len(history)))
        panel.set_title(f"force on the structure {sense} [{newtons}]", loc="left")
        panel.set_xlabel(f"way {sense} [{metres}]")
        panel.grid(axis="y", color=GREY, alpha=0.25, lw=0.6)
        panel.legend(frameon=False, fontsize=9)
    figure.tight_layout(w_pad=2)
    return save(figure, folder, "supports")

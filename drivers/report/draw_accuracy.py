#!/usr/bin/python3
"""Draws what accuracy costs: draw_accuracy.py DIR

Reads DIR/accuracy.csv (see src/study/accuracy_study.hpp), writes DIR/accuracy.png and DIR/accuracy.svg.
"""
import csv
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FixedLocator, NullLocator

from draw_common import BLUE, GREEN, GREY, INK, ORANGE, PALE, PAPER, RED, save_study
from read_results import number

SOLVED = "equilibrium"
# An estimate within these factors of the error is good enough to stop by.
TRUSTED = (0.5, 5.0)
# Errors below this are those of the nonlinear solver; a logarithmic axis down there shows nothing.
LOWEST = 1e-6
EDGE = dict(markeredgecolor="white", markeredgewidth=0.8)


def column(rows, name):
    return np.array([np.nan if (v := number(row.get(name))) is None else v for row in rows])


def positive(rows, *names):
    """The solved rows whose columns are all positive, which a logarithmic axis can show."""
    return [r for r in rows if r["outcome"] == SOLVED and all((number(r.get(n)) or 0) > 0 for n in names)]


def percent(value):
    return f"{100 * value:.3g} %"


def by_threshold(rows):
    return sorted((r for r in rows if r["mode"] == "adaptive"), key=lambda r: -(number(r["threshold"]) or 0))


def set_ticks(axis, values, scale=1.0, most=8):
    """Labels a logarithmic axis at 1, 2, 5 of each decade, or at the decades alone where those would be too many."""
    low, high = np.nanmin(values) / 1.6, np.nanmax(values) * 1.6
    decades = range(int(np.floor(np.log10(low * scale))), int(np.ceil(np.log10(high * scale))) + 1)
    for steps in ((1, 2, 5), (1,)):
        ticks = [f * 10.0**d / scale for d in decades for f in steps]
        ticks = [t for t in ticks if low <= t <= high]
        if len(ticks) <= most:
            break
    axis.set_major_locator(FixedLocator(ticks))
    axis.set_major_formatter(plt.FuncFormatter(lambda v, _: f"{scale * v:.3g}"))
    axis.set_minor_locator(NullLocator())


def labels_of(rows):
    return " / ".join(f"{100 * number(r['threshold']):.3g}" for r in rows) + " %"


def label_apart(axes, points):
    """Labels of points, each where it covers no other nor what stands there. points: (x, y, label); limits of axes are set"""
    renderer = axes.figure.canvas.get_renderer()
    taken = [text.get_window_extent(renderer) for text in axes.texts]
    for x, y, label in points:
        text = axes.annotate(label, (x, y), xytext=(0, 0), textcoords="offset points", fontsize=9, color=BLUE)
        for offset, side in (((7, 3), "left"), ((7, -12), "left"), ((-7, 3), "right"), ((-7, -12), "right")):
            text.set(position=offset, ha=side)
            box = text.get_window_extent(renderer)
            if not any(box.overlaps(other) for other in taken):
                break
        taken.append(box)


def draw_cost(axes, rows):
    """Error over time: one point per threshold, those that coincide share a label."""
    solved = positive(by_threshold(rows), "seconds")
    shown = [r for r in solved if (number(r["error_energy"]) or 0) > LOWEST]
    exact = [r for r in solved if number(r["error_energy"]) is not None and number(r["error_energy"]) <= LOWEST]
    bonded = positive([r for r in rows if r["mode"] == "bonded"], "error_energy", "seconds")
    truth = [r for r in rows if r["outcome"] == SOLVED and r["mode"] == "all"]
    axes.set_xscale("log")
    axes.set_yscale("log")
    groups = {}
    for row in shown:
        groups.setdefault(round(np.log(number(row["error_energy"])), 3), []).append(row)
    points = [(min(column(g, "seconds")), number(g[0]["error_energy"]), labels_of(g)) for g in groups.values()]
    axes.plot([p[0] for p in points], [p[1] for p in points], "o", color=BLUE, ms=8, zorder=3, **EDGE)
    for row in bonded:
        at = number(row["seconds"]), number(row["error_energy"])
        axes.plot(*at, "s", color=ORANGE, ms=8, zorder=3, **EDGE)
        axes.annotate("bonded", at, xytext=(7, -12), textcoords="offset points", fontsize=9, color=INK)
    errors = [p[1] for p in points] + [number(r["error_energy"]) for r in bonded]
    times = [p[0] for p in points] + [number(r["seconds"]) for r in bonded + truth[:1] + exact]
    if errors:
        low, high = min(errors) / 5, max(errors) * 2
        axes.set_xlim(min(times) / 1.4, max(times) * 2)
        axes.set_ylim(low, high)
        set_ticks(axes.yaxis, [low * 1.6, high / 1.6], 100)
        set_ticks(axes.xaxis, [min(times) * 1.14, max(times) * 1.25])
        # Runs without error stand at the foot of the picture: a logarithmic axis has no place for them.
        for row in truth[:1]:
            axes.plot(number(row["seconds"]), low, "v", color=GREEN, ms=9, clip_on=False, zorder=4, **EDGE)
            axes.annotate("all points", (number(row["seconds"]), low), xytext=(-8, 6), ha="right",
                          textcoords="offset points", fontsize=9, color=GREEN)
        if exact:
            axes.plot(column(exact, "seconds"), [low] * len(exact), "o", color=BLUE, ms=8, clip_on=False, zorder=3, **EDGE)
            axes.annotate(f"{labels_of(exact)}:\nno error", (max(column(exact, "seconds")), low), xytext=(9, 6),
                          textcoords="offset points", fontsize=9, color=BLUE)
    label_apart(axes, points)
    failed = [r for r in rows if r["outcome"] != SOLVED]
    if failed:
        words = [f"{r['mode']}{' ' + percent(number(r['threshold'])) if number(r.get('threshold')) is not None else ''}: {r['outcome']}"
                 for r in failed]
        axes.annotate("\n".join(words), (0.02, 0.02), xycoords="axes fraction", fontsize=8, color=RED)
    axes.set_xlabel("seconds, mesh to solution")
    axes.set_ylabel("error, energy norm [%]")
    axes.set_title("Error over cost (label: threshold)", loc="left")


def draw_estimate(axes, rows):
    """What the program says of its error beside what it is."""
    shown = [r for r in positive(by_threshold(rows), "estimate", "threshold", "error_energy") if number(r["error_energy"]) > LOWEST]
    threshold, truth, estimate = (column(shown, n) for n in ("threshold", "error_energy", "estimate"))
    axes.set_xscale("log")
    axes.set_yscale("log")
    if shown:
        axes.fill_between(threshold, TRUSTED[0] * truth, TRUSTED[1] * truth, color=PALE, alpha=0.45, lw=0,
                          label=f"{TRUSTED[0]:g} to {TRUSTED[1]:g} × true error")
        axes.plot(threshold, threshold, color=GREY, lw=1.0, ls=":", label="threshold asked for")
        axes.plot(threshold, truth, "o-", color=BLUE, ms=7, lw=1.4, label="true error", **EDGE)
        axes.plot(threshold, estimate, "D--", color=ORANGE, ms=6, lw=1.4, label="estimate", **EDGE)
        set_ticks(axes.yaxis, np.concatenate([TRUSTED[0] * truth, TRUSTED[1] * truth, estimate]), 100)
        axes.xaxis.set_major_locator(FixedLocator(threshold))
        axes.xaxis.set_major_formatter(plt.FuncFormatter(lambda t, _: f"{100 * t:.3g}"))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.invert_xaxis()
        axes.legend(frameon=False, fontsize=8, loc="lower left")
    axes.set_xlabel("threshold [%]")
    axes.set_ylabel("relative error, energy norm [%]")
    axes.set_title("Estimate beside the truth", loc="left")


def draw_sizes(axes, rows):
    """Error of the mesh, against the finest."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    values, sizes = [], []
    for name, label, style in (("error_energy", "energy norm", dict(color=BLUE, marker="o", ms=7, ls="-")),
                               ("error_displacement", "largest displacement", dict(color=GREEN, marker="^", ms=7, ls="--"))):
        shown = positive(rows, name, "element_size_m")
        if not shown:
            continue
        axes.plot(column(shown, "element_size_m"), column(shown, name), lw=1.4, label=label, **style, **EDGE)
        values += list(column(shown, name))
        sizes += list(column(shown, "element_size_m"))
    finest = [r for r in rows if r["outcome"] == SOLVED and number(r.get("error_energy")) == 0]
    if values:
        set_ticks(axes.yaxis, values, 100)
        axes.xaxis.set_major_locator(FixedLocator(sorted(set(sizes))))
        axes.xaxis.set_major_formatter(plt.FuncFormatter(lambda v, _: f"{1e3 * v:.3g}"))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.legend(frameon=False, fontsize=8, loc="best")
    axes.set_xlabel("element size [mm]")
    axes.set_ylabel("relative error [%]")
    against = f", against {1e3 * number(finest[0]['element_size_m']):.3g} mm" if finest else ""
    axes.set_title(f"Error of the mesh{against}", loc="left")


def main(folder):
    with open(folder / "accuracy.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    selection = [r for r in rows if r["sweep"] == "selection"]
    sizes = [r for r in rows if r["sweep"] == "element size"]
    panels = ([draw_cost, draw_estimate] if selection else []) + ([draw_sizes] if sizes else [])
    if not panels:
        sys.exit(f"{folder}/accuracy.csv holds no run.\n  Nothing to draw.")
    figure, axes = plt.subplots(1, len(panels), figsize=(PAPER.width * max(len(panels), 1.4) / 2.6, 4.0), squeeze=False)
    for panel, draw in zip(axes[0], panels):
        panel.grid(True, which="major", color=PALE, lw=0.5, alpha=0.7)
        draw(panel, sizes if draw is draw_sizes else selection)
    figure.tight_layout(w_pad=2)
    save_study(figure, folder, "accuracy")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))

#!/usr/bin/python3
"""Draws what a structure costs beside a continuum: draw_scaling.py DIR

Reads DIR/scaling.csv (see src/study/scaling_study.hpp), writes DIR/scaling.png and DIR/scaling.svg.
"""
import csv
import sys
from pathlib import Path

import matplotlib.pyplot as plt

from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from draw_common import BLUE, GREEN, GREY, ORANGE, PALE, PAPER, PURPLE, RED, SKY, save_study
from read_results import number

COLOURS = {"walls": BLUE, "openings": PURPLE, "storeys": SKY, "arches": ORANGE, "bridge": GREEN}
LINES = {"adaptive": "-", "all": "--", "bonded": ":"}
# What a load step may cost in bonded solves, and what its linear solves may take.
MOST_CONTINUA, MOST_KRYLOV, MOST_SOLVES = 3, 25, 12


def curves(rows):
    """(family, mode) -> load steps of each run, by size."""
    found = {}
    for row in rows:
        runs = found.setdefault((row["family"], row["mode"]), {})
        runs.setdefault(number(row["size"]), []).append(row)
    return {key: [runs[size] for size in sorted(runs)] for key, runs in found.items()}


def total(run, name):
    return sum(number(row[name]) or 0 for row in run)


def largest(run, name):
    return max(number(row[name]) or 0 for row in run)


def draw(axes, found, value, ideal, title):
    """One curve per family and mode over the unknowns of the continuum; crosses are runs that did not end in equilibrium."""
    for (family, mode), runs in found.items():
        x = [number(run[0]["continuum_unknowns"]) for run in runs]
        y = [value(run) for run in runs]
        colour = COLOURS.get(family, GREY)
        axes.plot(x, y, LINES.get(mode, "-"), color=colour, marker="o", ms=5, lw=1.4, label=f"{family}, {mode}")
        failed = [k for k, run in enumerate(runs) if run[-1]["outcome"] != "equilibrium"]
        axes.plot([x[k] for k in failed], [y[k] for k in failed], "x", color=RED, ms=9, mew=2, zorder=4)
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1, 3)))
        axis.set_major_formatter(FuncFormatter(lambda v, _: f"{v:g}"))
        axis.set_minor_formatter(NullFormatter())
    if ideal:
        axes.axhline(ideal, color=GREY, lw=1.0, ls="-.")
        axes.annotate(f"asked for: {ideal:g}", (0.99, ideal), xycoords=("axes fraction", "data"), ha="right", va="bottom",
                      fontsize=8, color=GREY)
    axes.grid(True, which="major", color=PALE, lw=0.5, alpha=0.7)
    axes.set_xlabel("unknowns of the continuum")
    axes.set_title(title, loc="left")


def draw_seconds(axes, found):
    """Seconds of the bonded solve and of all load steps, with the ideal: proportional to the unknowns."""
    draw(axes, found, lambda run: total(run, "seconds"), None, "all load steps and one bonded solve [s]")
    price = sorted({(number(run[0]["continuum_unknowns"]), number(run[0]["continuum_s"]))
                    for runs in found.values() for run in runs})
    x, y = [p[0] for p in price], [p[1] for p in price]
    axes.plot(x, y, "s", color=GREY, ms=5, label="one bonded solve")
    if len(price) > 1:
        axes.plot([x[0], x[-1]], [y[-1] * x[0] / x[-1], y[-1]], color=GREY, lw=1.0, ls="-.", label="ideal: linear")


def main(folder):
    with open(folder / "scaling.csv", newline="", encoding="utf-8") as file:
        found = curves(list(csv.DictReader(file)))
    if not found:
        sys.exit(f"{folder}/scaling.csv holds no run.\n  Nothing to draw.")
    figure, axes = plt.subplots(2, 2, figsize=(PAPER.width, 7.2))
    draw_seconds(axes[0][0], found)
    draw(axes[0][1], found, lambda run: largest(run, "in_continua"), MOST_CONTINUA, "dearest load step [bonded solves]")
    draw(axes[1][0], found, lambda run: largest(run, "linear_solves"), MOST_SOLVES, "most linear solves of a load step")
    draw(axes[1][1], found, lambda run: largest(run, "largest_krylov"), MOST_KRYLOV, "most Krylov iterations of a solve")
    handles, labels = axes[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=4, frameon=False, fontsize=9)
    figure.tight_layout(rect=(0, 0.03 + 0.025 * (len(labels) // 4), 1, 1), w_pad=2)
    save_study(figure, folder, "scaling")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))

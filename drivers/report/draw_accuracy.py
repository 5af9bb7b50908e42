#!/usr/bin/python3
"""Draws what accuracy costs: draw_accuracy.py DIR

Reads DIR/accuracy.csv (see src/simulation/accuracy_study.hpp), writes DIR/accuracy.png and DIR/accuracy.svg.
"""
import csv
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from draw_common import BLUE, DPI, GREEN, GREY, INK, ORANGE, PALE, RED, WIDTH
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


def set_decades(axis, values):
    """Labels a logarithmic axis in percent, and keeps the small ticks unlabelled when it spans decades."""
    low, high = np.nanmin(values), np.nanmax(values)
    axis.set_major_formatter(plt.FuncFormatter(lambda v, _: f"{100 * v:g}"))
    if high / low > 5:
        axis.set_minor_formatter(plt.NullFormatter())


def draw_cost(axes, rows):
    """Error over time: one point per threshold, those that coincide share a label."""
    shown = positive(by_threshold(rows), "error_energy", "seconds")
    shown = [r for r in shown if number(r["error_energy"]) > LOWEST]
    bonded = positive([r for r in rows if r["mode"] == "bonded"], "error_energy", "seconds")
    truth = [r for r in rows if r["outcome"] == SOLVED and number(r.get("error_energy")) == 0]
    axes.set_xscale("log")
    axes.set_yscale("log")
    groups = {}
    for row in shown:
        groups.setdefault(round(np.log(number(row["error_energy"])), 3), []).append(row)
    points = [(min(column(g, "seconds")), number(g[0]["error_energy"]), " / ".join(percent(number(r["threshold"])) for r in g))
              for g in groups.values()]
    axes.plot([p[0] for p in points], [p[1] for p in points], color=BLUE, lw=1.2, zorder=2)
    axes.plot([p[0] for p in points], [p[1] for p in points], "o", color=BLUE, ms=8, zorder=3, **EDGE)
    for seconds, error, label in points:
        axes.annotate(label, (seconds, error), xytext=(7, 3), textcoords="offset points", fontsize=9, color=BLUE)
    for row in bonded:
        at = number(row["seconds"]), number(row["error_energy"])
        axes.plot(*at, "s", color=ORANGE, ms=8, zorder=3, **EDGE)
        axes.annotate("bonded", at, xytext=(7, -12), textcoords="offset points", fontsize=9, color=INK)
    for row in truth[:1]:
        seconds = number(row["seconds"])
        axes.axvline(seconds, color=GREEN, lw=1.4, ls="--", zorder=1)
        name = "all points" if row["mode"] == "all" else "threshold 0"
        axes.annotate(f"{name}: truth,\n{seconds:.3g} s", (seconds, 0.02), xycoords=("data", "axes fraction"), xytext=(-5, 0),
                      textcoords="offset points", fontsize=9, color=GREEN, ha="right")
    failed = [r for r in rows if r["outcome"] != SOLVED]
    if failed:
        words = [f"{r['mode']}{' ' + percent(number(r['threshold'])) if number(r.get('threshold')) is not None else ''}: {r['outcome']}"
                 for r in failed]
        axes.annotate("\n".join(words), (0.02, 0.02), xycoords="axes fraction", fontsize=8, color=RED)
    axes.set_xlabel("seconds, mesh to solution")
    axes.set_title("error over cost: energy norm [%]\n(label: threshold)", loc="left")
    errors = [p[1] for p in points] + [number(r["error_energy"]) for r in bonded]
    times = [p[0] for p in points] + [number(r["seconds"]) for r in bonded + truth[:1]]
    if errors:
        set_decades(axes.yaxis, errors)
        axes.set_xlim(min(times) / 1.6, max(times) * 4)
        axes.set_ylim(min(errors) / 3, max(errors) * 2)
    axes.xaxis.set_major_formatter(plt.FuncFormatter(lambda v, _: f"{v:g}"))
    axes.xaxis.set_minor_formatter(plt.NullFormatter())


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
        set_decades(axes.yaxis, np.concatenate([truth, estimate, threshold]))
        axes.set_xticks(threshold, [f"{100 * t:g}" for t in threshold])
        axes.invert_xaxis()
        axes.legend(frameon=False, fontsize=8, loc="best")
    axes.minorticks_off()
    axes.set_xlabel("threshold [%]")
    axes.set_title("estimate beside the truth:\nenergy norm [%]", loc="left")


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
        set_decades(axes.yaxis, values)
        ticks = sorted(set(sizes))
        axes.set_xticks(ticks, [f"{1e3 * s:.3g}" for s in ticks])
        axes.minorticks_off()
        axes.legend(frameon=False, fontsize=8, loc="best")
    axes.set_xlabel("element size [mm]")
    against = f"against {1e3 * number(finest[0]['element_size_m']):.3g} mm" if finest else "no truth"
    axes.set_title(f"error of the mesh, {against} [%]", loc="left")


def main(folder):
    with open(folder / "accuracy.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    selection = [r for r in rows if r["sweep"] == "selection"]
    sizes = [r for r in rows if r["sweep"] == "element size"]
    panels = ([draw_cost, draw_estimate] if selection else []) + ([draw_sizes] if sizes else [])
    if not panels:
        sys.exit(f"{folder}/accuracy.csv holds no run.\n  Nothing to draw.")
    figure, axes = plt.subplots(1, len(panels), figsize=(WIDTH * max(len(panels), 1.4) / 2.6, 4.0), squeeze=False)
    for panel, draw in zip(axes[0], panels):
        panel.grid(True, which="major", color=PALE, lw=0.5, alpha=0.7)
        draw(panel, sizes if draw is draw_sizes else selection)
    figure.tight_layout(w_pad=2)
    figure.savefig(folder / "accuracy.png", dpi=DPI, facecolor="white")
    figure.savefig(folder / "accuracy.svg", facecolor="white")
    print(f"Picture: {folder}/accuracy.png")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))

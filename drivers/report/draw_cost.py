"""How the run went: load path and work per step, seconds per phase."""
import matplotlib.pyplot as plt
import numpy as np

from draw_common import BLUE, GREEN, GREY, INK, ORANGE, RED, PAPER, in_both_widths, panels, save, visible
from read_results import number


def column(history, name):
    """One column of history.csv as floats, NaN where it holds none."""
    values = [number(row.get(name)) for row in history]
    return np.array([np.nan if v is None else v for v in values])


@in_both_widths
def draw_history(history, folder):
    """Displacement, state of the joints and work, step by step; None if there are too few steps for a curve."""
    if len(history) < 2:
        return None
    step = np.arange(1, len(history) + 1)
    figure, axes = panels((2.9, 2.3), (1, 1, 1))
    axes = axes.reshape(-1)
    marks = dict(marker="o", ms=3.5 if len(step) < 40 else 0, lw=1.4)
    axes[0].plot(step, 1e3 * column(history, "largest_displacement_m"), color=INK, **marks)
    axes[0].set_title("largest displacement [mm]", loc="left")
    for name, colour, label in (("selected_points", BLUE, "selected"), ("open_points", RED, "open"), ("slip_points", ORANGE, "slipping")):
        axes[1].plot(step, column(history, name), color=colour, label=label, **marks)
    axes[1].set_title("contact points", loc="left")
    axes[1].legend(frameon=False, fontsize=9)
    for name, colour, label in (("newton_iterations", GREEN, "Newton iterations"), ("linear_solves", BLUE, "linear solves")):
        axes[2].plot(step, column(history, name), color=colour, label=label, **marks)
    axes[2].set_title("work", loc="left")
    axes[2].legend(frameon=False, fontsize=9)
    stages = [row.get("stage", "") for row in history]
    changes = [k for k in range(1, len(stages)) if stages[k] != stages[k - 1]]
    for panel in axes:
        panel.set_xlabel("step")
        panel.set_ylim(bottom=0)
        panel.xaxis.set_major_locator(plt.MaxNLocator(integer=True, nbins=8))
        for k in changes:
            panel.axvline(k + 0.5, color=GREY, lw=0.8, ls=":")
    figure.tight_layout(w_pad=2)
    return save(figure, folder, "history")


def flat_phases(phases, above=""):
    """Phase name -> seconds; nested phases are named 'outer: inner'. Totals are not phases."""
    flat = {}
    for name, value in phases.items():
        if isinstance(value, dict):
            flat.update(flat_phases(value, f"{above}{name}: "))
        elif number(value) is not None and str(name).lower() not in ("total", "sum", "wall"):
            flat[f"{above}{name}"] = number(value)
    return flat


@in_both_widths
def draw_phases(phases, folder):
    """Horizontal bars, longest first, with seconds and share; None without numbers."""
    flat = sorted(flat_phases(phases).items(), key=lambda item: item[1])[-14:]
    total = sum(value for _, value in flat)
    if not flat or total <= 0:
        return None
    figure, axes = plt.subplots(figsize=(min(7.5, PAPER.width), 0.6 + 0.3 * len(flat)))
    axes.barh([visible(name) for name, _ in flat], [value for _, value in flat], color=BLUE, height=0.65)
    for k, (_, value) in enumerate(flat):
        axes.annotate(f"{value:.2f} s   {100 * value / total:.0f} %", (value, k), xytext=(5, 0), textcoords="offset points",
                      va="center", fontsize=9)
    axes.set_xlim(0, (1.8 if PAPER.is_narrow else 1.2) * flat[-1][1])
    axes.tick_params(left=False, labelsize=10)
    axes.spines["left"].set_visible(False)
    axes.set_xlabel("seconds")
    figure.tight_layout()
    return save(figure, folder, "phases")

"""How the structure carries its load: compressive stress in the stones, resultants in the joints, line of thrust."""
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize

from draw_common import (GREY, PAPER, RED, STONE, dot_entry, draw_lines, drawing, in_both_widths, legend, limits, line_entry, outline_width,
                         save)
from geometry import force_text, round_number
from chains import joint_points
from statics import chain_resultants, resultant, thrust_line

PERCENTILE = 99  # of the compressive stress: above it are a few cells at the edge of a hinge
BLUES = LinearSegmentedColormap.from_list("compression", ["#f7f7f2", "#cfdfee", "#8fbbdc", "#4a90c4", "#1b5f9e", "#08306b"])


def minor_principal(stress):
    """[cells] Pa, tension positive: the most compressive principal stress."""
    mean, difference = (stress[:, 0] + stress[:, 1]) / 2, (stress[:, 0] - stress[:, 1]) / 2
    return mean - np.hypot(difference, stress[:, 2])


def all_resultants(joints, step):
    return [resultant(joints, step, points, np.ones(len(points))) for points in joint_points(joints) if len(points) > 1]


@in_both_widths
def draw_stress(mesh, joints, edges, step, chains, folder):
    """Returns the path, the stress at the top of the colour scale [Pa] and the largest resultant [N]."""
    x = mesh.coordinates
    compression = np.maximum(-minor_principal(np.nan_to_num(step.stress)), 0)
    top = np.percentile(compression, PERCENTILE) if len(compression) else 0
    top = top if top > 0 else 1.0
    figure, axes = drawing(limits(x), right=1.1)
    colour = Normalize(0, top / 1e6)
    axes.add_collection(PolyCollection(x[mesh.cells], array=compression / 1e6, cmap=BLUES, norm=colour, edgecolors="none",
                                       antialiased=False))
    draw_lines(axes, x[edges], GREY, 0.6 * outline_width(mesh.blocks))
    place = axes.get_position()
    height = min(place.height, 4.0 / figure.get_size_inches()[1])
    bar = figure.colorbar(axes.collections[0], extend="max",
                          cax=figure.add_axes([place.x1 + 0.015, place.y0 + (place.height - height) / 2, 0.014, height]))
    if PAPER.is_narrow:
        bar.ax.set_title("MPa", fontsize=9)  # the caption says of what
    else:
        bar.set_label("compression [MPa]")
    bar.outline.set_visible(False)
    largest = draw_resultants(figure, axes, joints, step, chains)
    return save(figure, folder, "stress", has_scale=True), top, largest


@in_both_widths
def draw_thrust(mesh, joints, edges, step, chains, folder, name):
    """Resultants and lines of thrust on the stones alone; returns the path and the largest resultant [N]."""
    x = mesh.coordinates
    figure, axes = drawing(limits(x))
    axes.add_collection(PolyCollection(x[mesh.cells], facecolors=STONE, edgecolors="none", antialiased=False))
    draw_lines(axes, x[edges], GREY, 0.6 * outline_width(mesh.blocks))
    largest = draw_resultants(figure, axes, joints, step, chains)
    return save(figure, folder, name), largest


def draw_resultants(figure, axes, joints, step, chains):
    """Resultants of all joints as dots, the line of thrust of every chain, and their legend; the largest resultant [N]."""
    resultants = all_resultants(joints, step)
    largest = max((r.normal for r in resultants), default=0.0)
    shown = [r for r in resultants if r.normal > 1e-3 * largest]
    biggest = 36.0 if len(shown) < 300 else 14.0  # points^2, so that dots of a bridge do not hide it
    if shown:
        force = np.array([r.normal for r in shown])
        axes.scatter(*np.array([r.place for r in shown]).T, s=biggest * force / largest, color=RED, linewidths=0, zorder=4,
                     alpha=0.9 if len(shown) < 300 else 0.6)
    for chain in chains:
        axes.plot(*thrust_line(chain_resultants(chain, joints, step)).T, "-", color=RED, lw=1.8, zorder=5)
    draw_force_legend(figure, largest, biggest, bool(chains))
    return largest


def draw_force_legend(figure, largest, biggest, with_line):
    """Dots of a round force, so that the size of a dot can be read."""
    entries = []
    if largest > 0:
        force = round_number(0.7 * largest, (1, 2, 5, 10))
        entries.append(dot_entry(f"joint resultant {force_text(force)}", RED, np.sqrt(biggest * force / largest), edge="none"))
    if with_line:
        entries.append(line_entry("line of thrust", RED, 1.8))
    legend(figure, entries)


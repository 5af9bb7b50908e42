"""Joints: open, slipping, closed; hinges; and which of them were computed as contact at all."""
import numpy as np

from draw_common import (BLUE, INK, ORANGE, PALE, RED, SKY, STONE_EDGE, STONE_PALE, dot_entry, draw_lines, drawing, fill_cells,
                         in_both_widths, legend, limits, line_entry, outline_width, save)
from geometry import bounds, deformed, factor_text, length_text
from read_results import OPEN, SLIP, is_mechanism

CRACKED = 0.99  # damage
WIDEST, THINNEST = 5.0, 0.8  # points: line weight of the widest opening and of the smallest


@in_both_widths
def draw_joints(mesh, joints, pieces, edges, step, scale, hinges, folder):
    x = deformed(mesh, step, scale)
    lines, point = pieces.halves(x, joints)
    figure, axes = drawing(limits(x))
    fill_cells(axes, x, mesh, STONE_PALE)
    draw_lines(axes, x[edges], PALE, 0.5)
    status, gap = step.status[point], np.maximum(step.gap[point], 0)
    is_open, slips = status == OPEN, status == SLIP
    draw_lines(axes, lines[~is_open & ~slips], "#a8a8a8", outline_width(mesh.blocks))
    draw_lines(axes, lines[slips], ORANGE, 2.0)
    widest = gap[is_open].max(initial=0)
    weight = THINNEST + (WIDEST - THINNEST) * gap[is_open] / widest if widest > 0 else THINNEST
    draw_lines(axes, lines[is_open], RED, weight)
    opening = "open" if is_mechanism(step) else f"open, widest {length_text(widest)}"  # a direction has no size
    entries = [line_entry(opening if is_open.any() else "open (none)", RED, 3),
               line_entry("slipping" if slips.any() else "slipping (none)", ORANGE, 2), line_entry("closed", "#a8a8a8", 1)]
    if hinges:
        middle = (x[joints.node_i] + x[joints.node_j]) / 2
        place = np.array([middle[hinge.points[1]] for hinge in hinges])
        axes.plot(*place.T, "o", color=INK, ms=8, mec="white", mew=1.2, zorder=5, clip_on=False)
        entries.append(dot_entry("hinge, at the compressed edge", INK, 8))
    legend(figure, entries)
    return save(figure, folder, "joints")


@in_both_widths
def draw_damage(mesh, joints, pieces, edges, step, scale, folder):
    x = deformed(mesh, step, scale)
    lines, point = pieces.halves(x, joints)
    figure, axes = drawing(limits(x))
    fill_cells(axes, x, mesh, STONE_PALE)
    draw_lines(axes, x[edges], PALE, 0.5)
    damage = step.damage[point]
    cracked, softening = damage > CRACKED, (damage > 0) & (damage <= CRACKED)
    draw_lines(axes, lines[damage == 0], "#a8a8a8", outline_width(mesh.blocks))
    draw_lines(axes, lines[softening], ORANGE, 1.8)
    draw_lines(axes, lines[cracked], RED, 2.4)
    legend(figure, [line_entry("cracked: less than 1 % of the strength is left" if cracked.any() else "cracked (none)", RED, 2.4),
                    line_entry("softening" if softening.any() else "softening (none)", ORANGE, 1.8),
                    line_entry("sound", "#a8a8a8", 1)])
    return save(figure, folder, "damage")


@in_both_widths
def draw_selection(mesh, joints, pieces, edges, step, folder):
    x = mesh.coordinates
    lines, point = pieces.halves(x, joints)
    figure, axes = drawing(limits(x))
    fill_cells(axes, x, mesh, STONE_PALE)
    draw_lines(axes, x[edges], PALE, 0.5)
    selected = step.selected[point]
    draw_lines(axes, lines[~selected], SKY, 0.8, alpha=0.7)
    draw_lines(axes, lines[selected], BLUE, 2.4 if mesh.blocks < 1000 else 1.4)
    size = 72 * figure.get_size_inches()[0] / np.sqrt(max(len(joints.area), 1)) * 0.12
    if size > 1.2:  # points can be told apart
        place = joints.position[step.selected]
        axes.plot(*place.T, "o", color=BLUE, ms=min(size, 4), mec="none", zorder=4)
    legend(figure, [line_entry("selected: computed as contact", BLUE, 2.4), line_entry("bonded: part of the continuum", SKY, 1)])
    return save(figure, folder, "selection")

"""The structure before and after loading, and at the end of every stage."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Patch

from draw_common import (GREY, PAPER, SET_COLOURS, STONE, STONE_EDGE, STONE_PALE, draw_lines, drawing, fill_cells, frame_size,
                         in_both_widths, legend, limits, line_entry, outline_width, prepare, save, visible)
from draw_supports import draw_supports, support_entries
from geometry import deformation_scale, deformed, factor_text, length_text

PANELS = 6  # small multiples: more are too small to read


def kinds_of_sets(mesh):
    """Sets gathered by the first word of their name, as 'pier' for 'pier west' and 'pier east', if there are many."""
    if len(mesh.sets) <= len(SET_COLOURS):
        return {name: [name] for name in mesh.sets}
    kinds = {}
    for name in mesh.sets:
        kinds.setdefault((name.split() or [name])[0], []).append(name)
    if len(kinds) > len(SET_COLOURS):  # every stone has a name of its own: colours are for sets of several
        kinds = {kind: names for kind, names in kinds.items() if len(names) > 1 or len(mesh.sets[names[0]]) > 1}
    return kinds


def colours_by_set(mesh):
    """A colour per block, and the legend. A block of several sets takes the colour of the smallest."""
    colour, entries = np.full(mesh.blocks, STONE, dtype="<U7"), []
    kinds = kinds_of_sets(mesh)
    shade = {name: SET_COLOURS[k % len(SET_COLOURS)] for k, names in enumerate(kinds.values()) for name in names}
    for name in sorted(shade, key=lambda n: -len(mesh.sets[n])):
        colour[mesh.sets[name]] = shade[name]
    for kind, names in kinds.items():
        shown = set(colour[np.concatenate([mesh.sets[n] for n in names])]) & {shade[names[0]]}
        if shown:
            label = kind if len(names) == 1 else f"{kind} ({len(names)} sets)"
            entries.append(Patch(facecolor=shade[names[0]], edgecolor=STONE_EDGE, label=visible(label)))
    if entries and (colour == STONE).any():
        entries.append(Patch(facecolor=STONE, edgecolor=STONE_EDGE, label="other stones"))
    return colour, entries


@in_both_widths
def draw_undeformed(mesh, edges, folder):
    x = mesh.coordinates
    colour, entries = colours_by_set(mesh)
    figure, axes = drawing(limits(x))
    fill_cells(axes, x, mesh, colour[mesh.block_of_cell])
    draw_lines(axes, x[edges], STONE_EDGE, outline_width(mesh.blocks))
    draw_supports(axes, mesh, x, edges)
    legend(figure, entries + support_entries(mesh, edges))
    return save(figure, folder, "structure")


@in_both_widths
def draw_deformed(mesh, edges, step, scale, folder, edges_of=None):
    """`edges_of` tells, of a step and its magnification, the edges that are seen then; else they are those as built."""
    x = deformed(mesh, step, scale)
    colour, _ = colours_by_set(mesh)
    figure, axes = drawing(limits(mesh.coordinates, x), bottom=0.6)
    draw_lines(axes, mesh.coordinates[edges], GREY, 0.5)
    fill_cells(axes, x, mesh, colour[mesh.block_of_cell])
    draw_lines(axes, x[edges_of(step, scale) if edges_of else edges], STONE_EDGE, outline_width(mesh.blocks))
    legend(figure, [line_entry(f"deformed {factor_text(scale)}", STONE_EDGE, 1.5), line_entry("undeformed", GREY, 0.8)])
    return save(figure, folder, "deformed")


def chosen_stages(steps):
    """At most PANELS of the stages, evenly, with the first and the last."""
    if len(steps) <= PANELS:
        return steps
    return [steps[k] for k in np.unique(np.linspace(0, len(steps) - 1, PANELS).round().astype(int))]


@in_both_widths
def draw_stages(mesh, edges, steps, folder, edges_of=None):
    """One small picture per stage, each with its own magnification, stated above it."""
    steps = chosen_stages(steps)
    scales = [deformation_scale(mesh, step) for step in steps]
    shapes = [deformed(mesh, step, scale) for step, scale in zip(steps, scales)]
    box = limits(mesh.coordinates, *shapes)
    wide = (box[1] - box[0]) / (box[3] - box[2])
    columns = min(len(steps), 1 if PAPER.is_narrow and wide > 1.2 else 2 if PAPER.is_narrow or wide > 1.2 else 3)
    rows = -(-len(steps) // columns)
    gap, title = 0.3, 0.55
    width, height = frame_size(box, (PAPER.width - gap * (columns - 1)) / columns, 3.6)
    total_width, total_height = columns * width + gap * (columns - 1), rows * (height + title)
    figure = plt.figure(figsize=(total_width, total_height))
    for k, (step, scale, x) in enumerate(zip(steps, scales, shapes)):
        row, column = divmod(k, columns)
        axes = figure.add_axes([column * (width + gap) / total_width, 1 - ((row + 1) * (height + title)) / total_height,
                                width / total_width, height / total_height])
        prepare(axes, box, bar=False)
        fill_cells(axes, x, mesh, STONE_PALE)
        draw_lines(axes, mesh.coordinates[edges], GREY, 0.3, alpha=0.6)
        draw_lines(axes, x[edges_of(step, scale) if edges_of else edges], STONE_EDGE, min(0.6, outline_width(mesh.blocks)))
        axes.set_title(f"{visible(step.stage) or 'step'}  (step {step.number})\nlargest {length_text(step.largest_displacement)}, "
                       f"drawn {factor_text(scale)}", loc="left", fontsize=9, pad=4)
    return save(figure, folder, "stages")

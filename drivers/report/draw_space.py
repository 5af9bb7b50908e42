"""Structures in space, seen in parallel projection from the front, the right and above.

The faces of stones that look at the viewer become the cells of a plane mesh, the farthest first, so that the pictures of
plane structures draw them. Faces between stones are left out: they are seen where a joint opens, as a gap.
"""
from dataclasses import dataclass, replace

import numpy as np

import draw_loads
import draw_structure
import hidden_lines
import motion_player
import solids
import view_in_space
from draw_common import ORANGE, RED, STONE_EDGE, STONE_PALE, dot_entry, draw_lines, drawing, fill_cells, in_both_widths, legend, limits, outline_width, save
from geometry import counted, deformation_scale, deformed, factor_text, length_text
from read_results import OPEN, SLIP, Step, is_mechanism, read_frames

TOWARDS_VIEWER = np.array([0.55, -1.0, 0.6]) / np.linalg.norm([0.55, -1.0, 0.6])


@dataclass
class ProjectedStep(Step):
    """A step whose displacements are those seen; the largest is the one in space."""
    largest: float = 0.0
    nearer: np.ndarray = None  # [nodes] m, towards the viewer

    @property
    def largest_displacement(self):
        return self.largest


def screen():
    """[3, 2]: the axes of the picture."""
    right = np.cross([0, 0, 1.0], TOWARDS_VIEWER)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(TOWARDS_VIEWER, right)], 1)


def projected(results):
    """The results as a plane structure, the edges of its stones that are seen as it was built and, of a step and its
    magnification, those that are seen then, and what is seen of displacements."""
    mesh, axes = results.mesh, screen()
    faces, block = solids.outer_faces(mesh)
    facing = solids.normals(mesh, faces) @ TOWARDS_VIEWER > 1e-6
    faces, block = faces[facing], block[facing]
    order = np.argsort(mesh.coordinates[faces].mean(1) @ TOWARDS_VIEWER, kind="stable")
    pieces, *between = hidden_lines.cut(solids.outlines(mesh, faces), len(mesh.coordinates))
    places = hidden_lines.with_new_nodes(mesh.coordinates, *between) @ np.column_stack([axes, TOWARDS_VIEWER])
    seen_edges = lambda x: pieces[hidden_lines.seen(x[pieces].mean(1), x[faces])]
    then = {}  # of every state that is drawn, once for all widths of the page

    def edges_of(step, scale):
        if (step.number, scale) not in then:
            then[step.number, scale] = seen_edges(places + scale * np.column_stack([step.displacement, step.nearer]))
        return then[step.number, scale]

    # Where every stone has a name of its own, colours are for sets of several.
    kinds = {name.split()[0] for name in mesh.sets if name.split()}
    named = len(kinds) <= len(draw_structure.SET_COLOURS)
    sets = {name: blocks for name, blocks in mesh.sets.items() if named or len(blocks) > 1}
    held = np.concatenate([mesh.held, mesh.held[between[0][:, 0]] & mesh.held[between[0][:, 1]]])
    flat = replace(mesh, sets=sets, coordinates=places[:, :2], cells=faces[order], block_of_cell=block[order], held=held, projected=True)
    moved = lambda step: hidden_lines.with_new_nodes(np.nan_to_num(step.displacement), *between)
    steps = [ProjectedStep(**{**vars(step), "displacement": moved(step) @ axes}, largest=step.largest_displacement,
                           nearer=moved(step) @ TOWARDS_VIEWER) for step in results.stage_ends]
    seen_at = lambda values: hidden_lines.with_new_nodes(np.nan_to_num(values), *between) @ axes
    return replace(results, mesh=flat, stage_ends=steps), seen_edges(places), edges_of, seen_at


@in_both_widths
def draw_points(flat, edges, step, scale, folder):
    """Points that are open or slip, on the deformed shape."""
    mesh, joints = flat.mesh, flat.joints
    x = deformed(mesh, step, scale)
    figure, axes = drawing(limits(x), bottom=0.6)
    fill_cells(axes, x, mesh, STONE_PALE)
    draw_lines(axes, x[edges], STONE_EDGE, outline_width(mesh.blocks))
    for status, colour in ((SLIP, ORANGE), (OPEN, RED)):
        at = x[joints.node_j[step.status == status]]
        axes.plot(at[:, 0], at[:, 1], "o", color=colour, ms=2.5, mew=0)
    legend(figure, [dot_entry(words, colour) for status, words, colour in ((OPEN, "open", RED), (SLIP, "slips", ORANGE)) if (step.status == status).any()])
    return save(figure, folder, "joints")


def points_words(step):
    """How many points are open or slip."""
    opened, slips = (step.status == OPEN).sum(), (step.status == SLIP).sum()
    if opened + slips == 0:
        return "none is open or slips."
    return f"{opened} open (red), {counted(slips, 'slips', 'slip')} (orange); those behind stones are drawn as well."


def add_loads(page, results, flat, edges, folder):
    step = results.equilibrium
    if not step or not step.loads:
        return
    placed = draw_loads.words_of_arrows(step.loads)
    words = draw_loads.words_of_loads(step.loads, draw_loads.way_of_supports(results.mesh, step))
    page.picture(draw_loads.draw_loads_in_space(flat.mesh, edges, step.loads, screen(), folder),
                 f"What acts on the structure in stage “{step.stage}”, step {step.number}: arrows are forces of nodes, those of one load in "
                 "proportion, also behind stones; sizes of whole loads stand beside them. Heavy lines: edges that supports hold."
                 + (f" At edges and points: {placed}." if placed else "")
                 + (f" On all of the stones: {words}." if words else ""))


def add_motion(page, results, flat, edges, seen_at):
    """A section of its own, when something moves through enough recorded steps."""
    times = results.times
    if len(times) < 2:
        return
    nodes = len(np.unique(np.concatenate([edges.reshape(-1), flat.mesh.cells.reshape(-1)])))
    chosen = motion_player.chosen_frames(times, motion_player.frames_for(nodes))
    frames = read_frames(results, chosen)
    in_space = [frame.displacement for frame in frames]
    flat_frames = [replace(frame, displacement=seen_at(frame.displacement)) for frame in frames]
    data = motion_player.data_of(flat.mesh, edges, flat_frames, faces=True, sizes=in_space)
    if data:
        page.section("The motion")
        page.motion(motion_player.text_of(data), motion_player.SCRIPT.read_text(encoding="utf-8"), len(chosen),
                    f"The structure at {len(chosen)} of {counted(len(times), 'recorded step')}, all drawn with one magnification. Thin grey: the structure as built.")


def add_space_sections(page, results, folder, attempt):
    """The pictures of a structure in space."""
    flat, edges, edges_of, seen_at = projected(results)
    view = "in parallel projection from the front, the right and above (x along, y into the picture, z up); the bar holds along the picture"
    page.section("The structure")
    try:
        attempt(page, "The view of the structure", lambda: view_in_space.add_view(page, results))
    except view_in_space.NoScripts as problem:
        page.words(f"There is no view to be turned: {problem}.")
    attempt(page, "The undeformed structure", lambda: page.picture(
        draw_structure.draw_undeformed(flat.mesh, edges, folder), f"The structure as built: {counted(flat.mesh.blocks, 'stone')}, {view}."))
    step = flat.last
    if not step:
        return
    scale = deformation_scale(flat.mesh, step)
    what = ("The mechanism: the motion the collapse begins with, drawn as large as it can be seen" if is_mechanism(step) else
            f"Deformed shape: displacements drawn {factor_text(scale)}, the largest is {length_text(step.largest_displacement)}")
    attempt(page, "The deformed structure", lambda: page.picture(
        draw_structure.draw_deformed(flat.mesh, edges, step, scale, folder, edges_of),
        f"{what}. End of step {step.number}, stage “{step.stage}”. Thin grey: the structure as built."))
    attempt(page, "The loads", add_loads, page, results, flat, edges, folder)
    if len(flat.stage_ends) > 1:
        attempt(page, "The stages", lambda: page.picture(
            draw_structure.draw_stages(flat.mesh, edges, flat.stage_ends, folder, edges_of),
            "Deformed shape at the end of each stage, each with its own magnification, stated above it."))
    attempt(page, "The motion", add_motion, page, results, flat, edges, seen_at)
    page.section("Joints")
    attempt(page, "The joints", lambda: page.picture(
        draw_points(flat, edges_of(step, scale), step, scale, folder),
        f"Contact points at step {step.number} on the deformed shape ({factor_text(scale)}): {points_words(step)} joints.xdmf holds all of them for ParaView."))

#!/usr/bin/python3
"""Draws the report of a run: make_report.py OUTDIR

Reads result.json, history.csv, fields.h5 and scene.xml in OUTDIR; writes OUTDIR/report.html, which needs no other file,
and its pictures as files in OUTDIR/pictures. What is missing or cannot be read is named in the report.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

import chains
import draw_cost
import draw_forces
import draw_joints
import draw_loads
import draw_space
import draw_structure
import draw_time
import motion_player
import rigid_report
import tables
from geometry import JointPieces, counted, deformation_scale, factor_text, force_text, length_text, outline_edges
from html_page import Page
from read_results import OPEN, SLIP, find, is_mechanism, number, read_frames, read_results, step_nearest
from statics import chain_resultants, find_hinges

# A result with holes (a table of the wrong length, say) must not take the rest of the report with it.
DAMAGED = (ValueError, IndexError, KeyError, TypeError, AttributeError)


def attempt(page, what, action, *arguments):
    """Runs one part of the report; if the data do not allow it, says so in its place."""
    try:
        return action(*arguments)
    except DAMAGED as problem:
        page.words(f"{what} could not be drawn: {type(problem).__name__}: {problem}.")
        return None


def add_undeformed(page, results, edges, folder):
    mesh = results.mesh
    sets = " Stones are coloured by set." if draw_structure.kinds_of_sets(mesh) else ""
    page.picture(draw_structure.draw_undeformed(mesh, edges, folder),
                 f"The structure as built: {counted(mesh.blocks, 'stone')}, drawn by {'its outline' if mesh.blocks == 1 else 'their outlines'}, to scale (bar in metres).{sets}")


def add_loads(page, results, edges, folder):
    """What acts at the end, in time when the structure moves most."""
    step, when = results.equilibrium, ""
    peak = number(results.result.get("largest_displacement_time_s")) if results.ends_in_time else None
    if peak is not None:
        step = step_nearest(results, peak)
        when = f" at {step.time:.4g} s, of the recorded steps the nearest to the largest displacement" if np.isfinite(step.time) else ""
    if not step or not step.loads:
        return
    reactions = [] if results.ends_in_time else draw_loads.reactions_of(results)
    placed = draw_loads.words_of_arrows(step.loads)
    whole = draw_loads.words_of_loads(step.loads, draw_loads.way_of_supports(results.mesh, step))
    page.picture(draw_loads.draw_loads(results.mesh, edges, step.loads, reactions, folder),
                 f"What acts on the structure in stage “{step.stage}”{when or f', step {step.number}'}. Along edges arrows are forces per length, those of "
                 "one load in proportion; sizes stand beside them."
                 + (f" At edges and points: {placed}." if placed else "")
                 + (f" On all of the stones: {whole}." if whole else "")
                 + (" Green: what supports answer, where it passes." if reactions else ""))


def add_deformed(page, results, edges, scale, folder):
    step = results.last
    picture = draw_structure.draw_deformed(results.mesh, edges, step, scale, folder)
    if is_mechanism(step):
        dilates = (results.result.get("mechanism") or {}).get("dilates")
        page.picture(picture, "The mechanism: the motion the collapse begins with, drawn as large as it can be seen. Stones that move as one "
                     f"stay together, joints that work open or slide. Stage “{step.stage}”, factor {step.load_factor:.4g}."
                     + (" It is the motion of slip that dilates, which proves the limit: what slides in it rises by friction times its slip, "
                        "and the structure itself moves otherwise." if dilates else ""))
        return
    course = tables.when_and_rest(results, tables.largest_displacement(results))
    largest = f" (in the course of the run {length_text(tables.largest_displacement(results))} {course})" if "residual" in course else ""
    page.picture(picture,
                 f"Deformed shape at the end of step {step.number}, stage “{step.stage}”: displacements drawn {factor_text(scale)}, the largest is "
                 f"{length_text(step.largest_displacement)}{largest}. Thin grey: the structure as built. Look for where the shape kinks: "
                 "stones turn against each other there. Openings are magnified with the displacements.")


def add_stages(page, results, edges, folder):
    if len(results.stage_ends) < 2:
        return
    shown = draw_structure.chosen_stages(results.stage_ends)
    left_out = len(results.stage_ends) - len(shown)
    page.picture(draw_structure.draw_stages(results.mesh, edges, results.stage_ends, folder),
                 "Deformed shape at the end of each stage"
                 + (f" ({left_out} of {counted(len(results.stage_ends), 'stage')} left out)" if left_out else "")
                 + ". Each has its own magnification, stated above it: compare the shapes by eye, the sizes by number.")


def add_motion(page, results, pieces, edges):
    """A section of its own, when something moves through enough recorded steps."""
    times = results.times
    if len(times) < 2:
        return
    chosen = motion_player.chosen_frames(times, motion_player.frames_for(len(np.unique(edges))))
    data = motion_player.data_of(results.mesh, edges, read_frames(results, chosen), pieces, results.joints)
    if data:
        page.section("The motion")
        page.motion(motion_player.text_of(data), motion_player.SCRIPT.read_text(encoding="utf-8"), len(chosen),
                    f"The structure at {len(chosen)} of {counted(len(times), 'recorded step')}, all drawn with one magnification. Red: open joints; "
                    f"thin grey: the structure as built{'; blue: loads at points' if any(frame['arrows'] for frame in data['frames']) else ''}.")


def add_joints(page, results, pieces, edges, scale, found, folder):
    mesh, joints, step = results.mesh, results.joints, results.last
    hinges = [h for chain in found for h in find_hinges(chain, joints, step, chain_resultants(chain, joints, step))]
    which = ("Joints of the mechanism, openings relative to its largest motion of 1 m," if is_mechanism(step) else
             f"Joints at step {step.number},")
    page.picture(draw_joints.draw_joints(mesh, joints, pieces, edges, step, scale, hinges, folder),
                 f"{which} on the deformed shape ({factor_text(scale)}). Red: open, the heavier the wider, "
                 f"{counted((step.status == OPEN).sum(), 'point')}; orange: slipping, {counted((step.status == SLIP).sum(), 'point')}; grey: closed."
                 + (" Black dots: hinges, at the compressed edge where the force passes; the joint gapes at the other edge." if hinges else ""))
    if step.damage is not None and not is_mechanism(step):
        cracked = (step.damage > draw_joints.CRACKED).sum()
        page.picture(draw_joints.draw_damage(mesh, joints, pieces, edges, step, scale, folder),
                     f"Strength of the joints at step {step.number}: {cracked} of {counted(len(step.damage), 'contact point')} "
                     f"{'has' if cracked == 1 else 'have'} cracked, {counted((step.damage > 0).sum() - cracked, 'softens', 'soften')}.")
    if hinges:
        page.part("Hinges, from the left springing to the right or from the foot upwards")
        tables.hinge_table(page, mesh, hinges)
    elif found:
        page.words("No hinge: no joint of an arch or a column is open at one edge with its force at the other.")


def add_stress(page, results, edges, found, folder):
    mesh, joints, step = results.mesh, results.joints, results.equilibrium
    path, top, largest = draw_forces.draw_stress(mesh, joints, edges, step, found, folder)
    line = ("Red line: line of thrust, through the resultants of the joints of each arch or column; where it touches an edge a hinge can form. "
            if found else f"{chains.NONE} ")
    page.picture(path, f"Compression in the stones (the most compressive principal stress of each cell) at step {step.number}, in MPa; the scale "
                 f"ends at {top / 1e6:.3g} MPa, which {100 - draw_forces.PERCENTILE} % of the cells exceed. {line}"
                 f"Dots: resultant of each joint, sized by its force, largest {force_text(largest)}.")


def selected_words(selected, points):
    """How many contact points are computed as contact (dark blue in the picture), and what the others do."""
    if selected == points:
        return f"at all of {counted(points, 'candidate point')} (dark blue)."
    others = "carry their load without opening or slipping and stay bonded."
    if selected == 0:
        return f"at none of {counted(points, 'candidate point')}: they {others}"
    return (f"{selected} of {counted(points, 'candidate point')} ({100 * selected / points:.1f} %) {'is' if selected == 1 else 'are'} selected (dark blue); "
            f"the others (light) {others}")


def add_selection(page, results, pieces, edges, folder):
    step, points = results.equilibrium, len(results.joints.area)
    page.picture(draw_joints.draw_selection(results.mesh, results.joints, pieces, edges, step, folder),
                 f"Where contact was computed at step {step.number}: {selected_words(step.selected.sum(), points)}")


def add_structure_sections(page, results, folder):
    """The pictures that need fields.h5. Returns the arches and columns that were found."""
    mesh, joints, step = results.mesh, results.joints, results.last
    if mesh.in_space:
        draw_space.add_space_sections(page, results, folder, attempt)
        return []
    edges = outline_edges(mesh)
    page.section("The structure")
    attempt(page, "The undeformed structure", add_undeformed, page, results, edges, folder)
    if not step:
        return []
    scale = deformation_scale(mesh, step)
    pieces = JointPieces(mesh, joints, edges)
    found = attempt(page, "The arches", chains.find_chains, mesh, joints, results.standing) or []
    attempt(page, "The loads", add_loads, page, results, edges, folder)
    attempt(page, "The deformed structure", add_deformed, page, results, edges, scale, folder)
    attempt(page, "The stages", add_stages, page, results, edges, folder)
    attempt(page, "The motion", add_motion, page, results, pieces, edges)
    page.section("Joints")
    attempt(page, "The joints", add_joints, page, results, pieces, edges, scale, found, folder)
    page.section("How the load is carried")
    attempt(page, "The stress", add_stress, page, results, edges, found, folder)
    page.section("Which joints were computed as contact")
    attempt(page, "The selection", add_selection, page, results, pieces, edges, folder)
    return found


def add_cost(page, results, folder):
    page.section("Convergence and cost")
    history = results.history
    path = draw_cost.draw_history(history, folder)
    if path:
        page.picture(path, f"The course of the run and its work, {'time step by time step' if results.ends_in_time else 'load step by load step'}; dotted lines "
                     "part the stages.")
    if history:
        tables.step_table(page, history, tables.step_columns(history))
    else:
        page.words("No step is recorded in history.csv, hence there is no table of steps.")
    seconds, phases = tables.seconds_of(results)
    path = draw_cost.draw_phases(phases, folder) if phases else None
    if path:
        memory = find(results.result, "peak memory per rank", "peak memory mb per rank", "peak memory")
        page.picture(path, f"Seconds per phase, longest first{'' if seconds is None else f'; {seconds:.3g} s in all'}."
                     + tables.memory_words(memory))
    if history and "elastic_J" in history[0]:
        page.part("Energy book")
        page.words("External work, forces times ways of loads and moved supports, is stored as elastic energy or spent in friction and fracture, "
                   "or lost in a jump, where the structure let go faster than it was moved. The imbalance is what the book does not "
                   "explain: in time steps as little as the tolerance of the solver, in load steps it goes with their size.")
        tables.step_table(page, history, tables.ENERGY_COLUMNS)


def add_time(page, results, folder):
    """Observed places and energies over time or load steps."""
    history = results.history
    places = draw_time.observed_places(history)
    path = draw_time.draw_places(history, places, folder)
    supports = draw_time.draw_supports(history, places, folder)
    energy = draw_time.draw_energy(history, folder)
    if not path and not energy:
        return
    in_time = draw_time.Course(history).in_time
    page.section("Over time" if in_time else "Over the load steps")
    if in_time:
        tables.peak_table(page, results, places)
    if path:
        left_out = len(places) - draw_time.PLACES
        page.picture(path, "Motion of the places the scene observes"
                     + (f" (the first {draw_time.PLACES}; {counted(left_out, 'more is', 'more are')} in history.csv)." if left_out > 0 else "."))
    if supports:
        page.picture(supports, "Force of each support that moves, over its way.")
    if energy:
        path, share, in_time = energy
        page.picture(path, "Energy book: external work is stored as elastic and kinetic energy or lost in friction, fracture and damping. "
                     f"The second picture is what the book cannot explain{' of time steps' if in_time else ''}, at most {share:.2g} of the largest energy.")


def add_tables(page, results, found):
    if not results.last and not results.margins:
        return
    page.section("Tables")
    if results.last:
        attempt(page, "The tables of joints", tables.joint_tables, page, results)
    attempt(page, "The margins of joints", tables.margin_tables, page, results)
    attempt(page, "The support reactions", tables.reaction_table, page, results)
    if results.last and not results.mesh.in_space:
        attempt(page, "The thrust", tables.thrust_table, page,
                [(chain.name, chain, chain_resultants(chain, results.joints, results.equilibrium)) for chain in found])


def add_rigid(page, results, folder):
    """The report of a run that asked rigid limit analysis alone."""
    words, kind = tables.outcome(results)
    page.head("limit analysis: forces balance the loads" if words == "equilibrium" else f"limit analysis: {words}", kind)
    page.figures_asked_first(rigid_report.facts(results))
    page.remarks(results.remarks)
    page.contents()
    rigid_report.add_verdict(page, results)
    if results.mesh and results.mesh.in_space:
        draw_space.add_space_sections(page, results, folder, attempt)
    elif results.mesh:
        mesh, joints, step = results.mesh, results.joints, results.last
        edges = outline_edges(mesh)
        found = attempt(page, "The arches", chains.find_chains, mesh, joints, results.standing) or []
        page.section("The structure")
        attempt(page, "The undeformed structure", add_undeformed, page, results, edges, folder)
        if step:
            page.section("How the load is carried")
            attempt(page, "The thrust", rigid_report.add_thrust, page, results, edges, found, folder)
        if step and is_mechanism(step):
            page.section("How it falls")
            scale = deformation_scale(mesh, step)
            attempt(page, "The mechanism", add_deformed, page, results, edges, scale, folder)
            attempt(page, "The joints", add_joints, page, results, JointPieces(mesh, joints, edges), edges, scale, [], folder)
    attempt(page, "Least and most thrust", rigid_report.add_ranges, page, results)


def make_report(folder):
    """Writes report.html and pictures/ in `folder`; returns the path of the page."""
    results = read_results(folder)
    pictures = results.folder / "pictures"
    pictures.mkdir(exist_ok=True)
    page = Page(results.title)
    path = results.folder / "report.html"
    if rigid_report.asked_alone(results):
        add_rigid(page, results, pictures)
        page.write(path)
        return path
    page.head(*tables.outcome(results))
    page.warnings(tables.warnings(results))
    page.figures_asked_first(tables.facts_asked_first(results))
    page.remarks(results.remarks)
    page.contents()
    found = add_structure_sections(page, results, pictures) if results.mesh else []
    attempt(page, "The load factor", tables.load_factor_section, page, results)
    attempt(page, "The course of the run", add_time, page, results, pictures)
    attempt(page, "Convergence and cost", add_cost, page, results, pictures)
    add_tables(page, results, found)
    page.write(path)
    return path


def main():
    options = argparse.ArgumentParser(description="Draws the report of a run.")
    options.add_argument("folder", type=Path, help="folder a run wrote: result.json, history.csv, fields.h5, scene.xml")
    folder = options.parse_args().folder
    if not folder.is_dir():
        print(f"make_report.py: {folder} is not a folder.\n  Give the folder a run wrote, as out/arch.", file=sys.stderr)
        return 2
    print(make_report(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())

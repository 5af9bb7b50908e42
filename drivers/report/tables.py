"""Numbers of the report: the figures asked first, tables per step, of joints, of forces."""
import numpy as np

from draw_cost import column
from geometry import counted, force_text, length_text
from read_results import OPEN, SLIP, STICK, find, largest_over_time, number
from statics import geometrical_factor, horizontal_thrust

LONG = 60  # steps: longer histories are shown with every so many steps, and always the last


def count_text(value):
    return "not given" if number(value) is None else f"{number(value):,.0f}".replace(",", " ")


def ranks_text(value):
    return "not given" if number(value) is None else counted(number(value), "rank")


def short(value, digits=3):
    value = number(value)
    if value is None:
        return ""
    return f"{value:.0f}" if value == int(value) and abs(value) < 1e6 else f"{value:.{digits}g}"


def last_row(results, name):
    return number(results.history[-1].get(name)) if results.history else None


def either(results, history_name, *names):
    """From result.json, else from the last row of history.csv."""
    value = number(find(results.result, *names))
    return value if value is not None else last_row(results, history_name)


def outcome(results):
    """Words and the kind of outcome: good, warn, bad or ''."""
    words = str(find(results.result, "outcome") or "outcome not recorded").replace("_", " ")
    if words == "interrupted":
        return "stopped before its end", "warn"
    kind = {"equilibrium": "good", "collapse": "warn", "not converged": "bad", "out of range": "bad"}.get(words, "")
    return words, "warn" if kind == "good" and warnings(results) else kind


def warnings(results):
    """Rows (kind, where, when, text) of what the run could not vouch for, why it ended there first."""
    said = find(results.result, "warnings")
    rows = [tuple(str(w.get(key) or "") for key in ("what", "where", "when", "text"))
            for w in (said if isinstance(said, list) else []) if isinstance(w, dict)]
    if str(find(results.result, "outcome")) == "out_of_range":
        rows.insert(0, ("out_of_range", "The run ended", "", str(find(results.result, "message") or "no reason was kept")))
    if str(find(results.result, "outcome")) == "interrupted":
        rows.insert(0, ("interrupted", "The run has not come to its end", "", str(find(results.result, "message") or "no reason was kept")))
    return rows


def seconds_of(results):
    """Total seconds and the phases by name."""
    phases = find(results.result, "seconds per phase", "seconds", "phases", "timings")
    if not isinstance(phases, dict):
        return number(phases) or number(np.nansum(column(results.history, "seconds"))), {}
    total = number(find(phases, "total", "wall", "sum"))
    return total or sum(v for v in map(number, phases.values()) if v is not None), phases


def margin_text(value):
    value = number(value)
    return "not given" if value is None else f"{0 if abs(value) < 1e-9 else 100 * value:.3g} %"


def facts_asked_first(results):
    step, tree = results.last, results.result
    displacement = largest_displacement(results)
    candidates = number(find(tree, "candidate points")) or (len(results.joints.area) if results.joints else None)
    selected = either(results, "selected_points", "selected points")
    if selected is None and step:
        selected = step.selected.sum()
    points = []
    for name, status in (("open", OPEN), ("slip", SLIP), ("stick", STICK)):
        value = either(results, f"{name}_points", f"{name} points", f"{name} count", name)
        points.append(value if value is not None else (int((step.status == status).sum()) if step else None))
    load = either(results, "load_factor", "load factor", "load factor reached")
    error = either(results, "error_estimate", "error estimate")
    seconds, _ = seconds_of(results)
    share = f"{100 * selected / candidates:.1f} %" if selected is not None and candidates else "not given"
    stage = results.history[-1].get("stage", "") if results.history else (step.stage if step else "")
    lower, upper = collapse_bracket(results)
    asked = [] if lower is None else [
        ("Collapse load factor", f"above {short(lower, 4)}" if upper is None else f"{short(lower, 4)} to {short(upper, 4)}",
         "of the pattern: the first stands" + ("" if upper is None else ", above the second nothing stands" if by_theorem(results)
                                               else ", the second collapses"))]
    statics = results.result.get("statics")
    if isinstance(statics, dict) and "hinges" in statics:
        asked += [("Hinges / sliding joints", f"{count_text(statics.get('hinges'))} / {count_text(statics.get('sliding_joints'))}",
                   "in the last equilibrium; neighbours that open on one side make one hinge of an arch"
                   + ("; joints that stay bonded are judged by the forces of their bonds" if selected is not None and candidates and selected < candidates else "")),
                  ("Least margins", f"{margin_text(statics.get('least_edge_margin'))} / {margin_text(statics.get('least_friction_margin'))}",
                   "of a resultant from its edge, of the joint's width; of friction")]
    where = f"in stage “{stage}”" if stage else ""
    whole = [("Computing time", "not given" if seconds is None else f"{seconds:.3g} s", ranks_text(find(tree, "ranks"))),
             ("Blocks / joints", f"{count_text(find(tree, 'blocks'))} / {count_text(find(tree, 'joints'))}", ""),
             ("Unknowns", count_text(find(tree, "unknowns")), "")]
    if number(find(tree, "steps")) == 0 and lower is None:
        return [("Steps", "none", "nothing is known of displacements and forces yet"), *whole]
    reached = ("Time reached", f"{last_row(results, 'time_s'):.4g} s", where) if results.ends_in_time else (
        "Load factor reached", short(load) or "not given", where)
    return asked + [
        ("Largest displacement", "not given" if displacement is None else length_text(displacement), when_and_rest(results, displacement)),
        reached,
        ("Open / slipping / sticking points", " / ".join(count_text(p) for p in points),
         f"of the selected contact points{', at the end' if results.ends_in_time else ''}"),
        ("Selected as contact", share, f"{count_text(selected)} of {counted(candidates or 0, 'candidate point')}"),
        ("Error estimate", "not given" if error is None else f"{100 * error:.2g} %", "every joint was computed as contact" if share == "100.0 %" else
         "energy norm, of what stays bonded: no bound; displacements may be several times as far off"),
        *whole]


def largest_displacement(results):
    """[m] of the whole run, or of its last step where nothing else is known; None without any."""
    largest = either(results, "largest_displacement_m", "largest displacement")
    return results.last.largest_displacement if largest is None and results.last else largest


def when_and_rest(results, largest):
    """When the displacement was largest, where time passed, and the residual one where it is another."""
    when, rest = number(results.result.get("largest_displacement_time_s")), number(results.result.get("residual_displacement_m"))
    words = "" if when is None else f"at {when:.4g} s"
    if rest is not None and largest is not None and rest < 0.999 * largest:
        words += f"{'; ' if words else 'of all steps; '}at the end {length_text(rest)}, the residual"
    return words


def collapse_bracket(results):
    """The load factor that stands and the one that collapses, as far as they were found."""
    found = results.result.get("collapse")
    return (number(found.get("lower")), number(found.get("upper"))) if isinstance(found, dict) else (None, None)


def by_theorem(results):
    """Whether the upper end is that of the static theorem: no mechanism was found below."""
    found = results.result.get("collapse") or {}
    upper, certified = number(found.get("upper")), number(found.get("certified_upper"))
    return upper is not None and certified is not None and upper >= certified


def load_factor_section(page, results):
    """How far the pattern of loads could be raised, and every attempt."""
    found = results.result.get("collapse")
    if not isinstance(found, dict):
        return
    lower, upper = collapse_bracket(results)
    page.section("How far the loads can be raised")
    pattern = " + ".join(f"{short(share)} x {load}" for load, share in found.get("pattern", {}).items())
    stands = f"The structure stands with {short(lower, 5)} times the pattern ({pattern}) on top of the loads of the last stage"
    certified, estimate = number(found.get("certified_upper")), number(found.get("estimate_without_dilatancy"))
    if upper is None:
        page.words(f"{stands}; no factor was found at which it collapses.")
    elif by_theorem(results):
        page.words(f"{stands}. The mechanism drawn here is that of rigid stones at the limit"
                   + (", whose slip dilates as in the proof." if (results.result.get("mechanism") or {}).get("dilates") else "."))
    else:
        page.words(f"{stands} and collapses with {short(upper, 5)} times it: there the solver found a mechanism, which is the last step drawn here. "
                   "Every attempt is one load step from the last equilibrium; with friction the way of the loads matters.")
    if certified is not None:
        page.words(f"No equilibrium exists above {short(certified, 5)} times the pattern, by the static theorem (rigid limit analysis)."
                   + ("" if estimate is None else f" Where slip does not dilate it is estimated at {short(estimate, 5)}, no bound on either side."))
    if found.get("sharp") is False:
        page.words("Factors between these two were tried and neither an equilibrium nor a mechanism was found there.")
    page.table(["load factor", "found", "linear solves"],
               [[short(a.get("factor"), 5), str(a.get("outcome", "")), count_text(a.get("linear_solves"))] for a in found.get("attempts", [])], words=(1,))


def shown_rows(history):
    stride = -(-len(history) // LONG)
    rows = history[::-1][::max(stride, 1)][::-1]
    return rows, stride


def step_columns(history):
    """Those of the table per step. In time a step is told by its time: a load factor means nothing there."""
    times = [number(row.get("time_s")) for row in history]
    if all(time is None for time in times):
        return STEP_COLUMNS
    told = [("time [s]", "time_s") if key == "load_factor" else (heading, key) for heading, key in STEP_COLUMNS]
    return tuple(told)


def memory_words(memory):
    """Of all ranks [1e6 bytes], as a sentence."""
    values = [value for value in map(number, memory if isinstance(memory, list) else [memory]) if value is not None]
    if not values:
        return ""
    least, most = (f"{value:.0f}" for value in (min(values), max(values)))
    return f" Peak memory per rank: {most if least == most else f'{least} to {most}'} MB."


def peak_and_rest(columns):
    """Of a vector over the steps: its largest size, the row it is reached in, its size at the end; None without numbers."""
    size = np.sqrt(sum(np.nan_to_num(values) ** 2 for values in columns))
    known = np.any([np.isfinite(values) for values in columns], axis=0)
    if not known.any():
        return None
    row = int(np.where(known, size, -1).argmax())
    return float(size[row]), row, float(size[np.flatnonzero(known)[-1]])


def peak_table(page, results, places):
    """Of the structure and of every observed place the largest displacement, when that was, and what is left at the end."""
    times = column(results.history, "time_s")
    moment = lambda row: f"{times[row]:.4g} s" if np.isfinite(times[row]) else f"load step {row + 1}"
    rows, moving = [], False
    whole = peak_and_rest([column(results.history, "largest_displacement_m")])
    told = [("the structure, its farthest node", whole, None)] if whole else []
    for name, values in places.items():
        of = lambda letter: [values[letter + axis] for axis in "xyz" if letter + axis in values]
        told.append((name, peak_and_rest(of("u")) if of("u") else None, peak_and_rest(of("v")) if of("v") else None))
    for name, way, speed in told:
        if not way:
            continue
        moving |= speed is not None
        rows.append([name, length_text(way[0]), moment(way[1]), length_text(way[2]),
                     f"{speed[0]:.3g} m/s" if speed else "", moment(speed[1]) if speed else ""])
    if not rows:
        return
    page.part("Peaks, and what is left")
    columns = ["place", "largest displacement", "when", "residual, at the end", "largest velocity", "when"]
    kept = len(columns) if moving else 4
    page.table(columns[:kept], [row[:kept] for row in rows], words=(0,))


STEP_COLUMNS = (("step", "step"), ("stage", "stage"), ("load factor", "load_factor"), ("selected", "selected_points"), ("open", "open_points"),
                ("stick", "stick_points"), ("slip", "slip_points"), ("selection rounds", "selection_rounds"), ("Newton", "newton_iterations"),
                ("linear solves", "linear_solves"), ("Krylov", "krylov_iterations"), ("complementarity residual", "complementarity_residual"),
                ("penetration [m]", "largest_penetration_m"), ("error estimate", "error_estimate"),
                ("displacement [m]", "largest_displacement_m"), ("seconds", "seconds"))
ENERGY_COLUMNS = (("step", "step"), ("stage", "stage"), ("elastic [J]", "elastic_J"), ("kinetic [J]", "kinetic_J"),
                  ("external work [J]", "external_work_J"), ("friction [J]", "friction_J"), ("fracture [J]", "fracture_J"),
                  ("damping [J]", "damping_J"), ("lost in jumps [J]", "jump_J"), ("imbalance [J]", "imbalance_J"))


def step_table(page, history, columns):
    rows, stride = shown_rows(history)
    digits = 4 if columns is ENERGY_COLUMNS else 3
    page.table([heading for heading, _ in columns],
               [[row.get(key, "") if key == "stage" else short(row.get(key), digits) for _, key in columns] for row in rows], words=(1,))
    if stride > 1:
        page.words(f"One row in {stride} of {len(history)}; all are in history.csv.")


def block_name(mesh, block):
    sets = [name for name, blocks in mesh.sets.items() if block in blocks]
    return f"{block} ({', '.join(sets)})" if sets else str(block)


def largest_of_joints(mesh, joints, values, when=None, how_many=10):
    """Joints with the largest value at one of their points: rows for a table, largest first.

    when  word for a point's step, where points have theirs at different ones
    """
    order, seen, rows = np.argsort(-values, kind="stable"), set(), []
    for point in order:
        if len(rows) == how_many or not values[point] > 0:
            break
        if joints.joint[point] not in seen:
            seen.add(joints.joint[point])
            rows.append([len(rows) + 1, block_name(mesh, joints.block_i[point]), block_name(mesh, joints.block_j[point]),
                         f"{1e3 * values[point]:.4g}", *([when(point)] if when else []), *(f"{c:.3f}" for c in joints.position[point])])
    return rows


def joint_tables(page, results):
    """Widest openings and longest slips: in time of all recorded steps, else of the last equilibrium."""
    mesh, joints, step, times = results.mesh, results.joints, results.equilibrium, results.times
    in_time = bool(np.isfinite(times).any())
    if in_time:
        largest, at = largest_over_time(results)
        moment = lambda k: f"{times[k]:.4g} s" if np.isfinite(times[k]) else f"load step {k + 1}"
        page.words(f"Each joint at its widest or longest over the {counted(len(times), 'recorded step')}, and when that was.")
    else:
        largest = {"gap": np.where(step.status == OPEN, step.gap, 0), "slip": np.where(step.selected, np.abs(step.slip), 0)}
    for title, unit, key in (("Ten most opened joints", "opening [mm]", "gap"), ("Ten largest slips", "slip [mm]", "slip")):
        rows = largest_of_joints(mesh, joints, largest[key], (lambda point, k=key: moment(at[k][point])) if in_time else None)
        page.part(title)
        if rows:
            page.table(["", "block", "block", unit, *(["when"] if in_time else []), "x [m]", "y [m]", "z [m]"][:len(rows[0])], rows, words=(1, 2))
        else:
            page.words("None.")


def hinge_table(page, mesh, hinges):
    page.table(["arch or column", "blocks", "opens at", "hinge at", "opening [mm]", "x [m]", "y [m]"],
               [[h.chain, " | ".join(block_name(mesh, b) for b in h.blocks), h.opens_at, h.turns_at, f"{1e3 * h.opening:.4g}",
                 f"{h.place[0]:.3f}", f"{h.place[1]:.3f}"] for h in hinges], words=(0, 1, 2, 3))


def thrust_table(page, thrusts):
    """thrusts: rows (name, arch or column, resultants)."""
    if not thrusts:
        return  # the caption of the picture says why
    page.part("Horizontal thrust of each arch")
    arches = [(name, chain, resultants) for name, chain, resultants in thrusts if chain.kind == "arch"]
    if not arches:
        page.words("No arch was found; a line of thrust is drawn for each column.")
        return
    page.table(["arch", "voussoir joints", "thrust at the crown", "largest joint resultant", "geometrical factor of safety"],
               [[name, len(resultants), force_text(horizontal_thrust(resultants)), force_text(max(r.normal for r in resultants)),
                 short(geometrical_factor(resultants)) if chain.alone else "none"] for name, chain, resultants in arches], words=(0,))
    page.words("Geometrical factor of safety: thickness over the least thickness, about the same middle line, that holds this line of thrust. Another line "
               "may fit a thinner ring, so it is a lower bound; 1 where the line touches an edge. An arch that other stones press on, as another ring "
               "or its backing, has none: they hold its line where it is, and it is not safe by itself.")


def unit_of_force(largest):
    """The unit that forces of a table are told in, and how many N it is."""
    return ("kN", 1e3) if largest >= 1e3 else ("N", 1.0)


def reaction_table(page, results):
    """Force of each support on the structure."""
    reactions = (results.result.get("statics") or {}).get("reactions")
    if not isinstance(reactions, dict) or not reactions:
        return
    page.part("Support reactions")
    largest = max((abs(number(r.get(key)) or 0) for r in reactions.values() for key in ("x_N", "y_N", "z_N")), default=0)
    unit, size = unit_of_force(largest)
    # Round-off of a large force is none of a small one.
    force = lambda value: "" if number(value) is None else short(0 if abs(number(value)) < 1e-9 * largest else number(value) / size, 4)
    place = lambda value: "" if number(value) is None else short(round(number(value), 3), 5)  # to a millimetre
    told = lambda r, keys: [force(r.get(key)) if key.endswith("_N") else place(r.get(key)) for key in keys]
    if any("z_N" in r for r in reactions.values()):
        page.table(["support", f"x [{unit}]", f"y [{unit}]", f"vertical [{unit}]", "through x [m]", "y [m]", "z [m]"],
                   [[name] + told(r, ("x_N", "y_N", "z_N", "through_x_m", "through_y_m", "through_z_m"))
                    for name, r in reactions.items()], words=(0,))
        return
    page.table(["support", f"horizontal, its thrust [{unit}]", f"vertical [{unit}]", "through x [m]", "y [m]"],
               [[name] + told(r, ("x_N", "y_N", "through_x_m", "through_y_m")) for name, r in reactions.items()], words=(0,))


# Those that a table of the plane, or of space, has not are left out.
MARGIN_COLUMNS = (("normal force [N]", "normal_force_N"), ("shear [N]", "shear_N"), ("twist [Nm]", "twist_Nm"), ("length [m]", "length_m"),
                  ("area [m2]", "area_m2"), ("eccentricity [m]", "eccentricity_m"), ("edge margin", "edge_margin"),
                  ("friction margin", "friction_margin"), ("x [m]", "x_m"), ("y [m]", "y_m"), ("z [m]", "z_m"))


def margin_tables(page, results, how_many=10):
    """The joints nearest to their edges and to sliding, in the last equilibrium."""
    columns = [(heading, key) for heading, key in MARGIN_COLUMNS if results.margins and key in results.margins[0]]
    for title, key in (("Joints nearest to opening at an edge", "edge_margin"), ("Joints nearest to sliding", "friction_margin")):
        rows = sorted((row for row in results.margins if number(row.get(key)) is not None), key=lambda row: number(row[key]))[:how_many]
        if rows:
            page.part(title)
            page.table(["block", "block"] + [heading for heading, _ in columns],
                       [[block_name(results.mesh, int(row["block_i"])), block_name(results.mesh, int(row["block_j"]))]
                        + [short(0 if abs(number(row.get(column)) or 0) < 1e-9 else row[column]) for _, column in columns] for row in rows],
                       words=(0, 1))
    if results.margins:
        in_space = "area_m2" in results.margins[0]
        page.words("Edge margin: distance of the pressure from the nearer edge over the "
                   + ("width of the joint across that edge; edges are those of the convex hull of the joint" if in_space else "length of the joint")
                   + ", 0.5 in the middle, 0 at the edge, where a hinge forms. Friction margin: share of the strength in shear"
                   + (" and twist" if in_space else "") + " that is left, 0 when the joint slides. A joint that bends is measured "
                   "as if it were straightened; of one with corners the side with the least is told. All joints are in joints.csv.")

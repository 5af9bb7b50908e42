"""The report of a run that asked rigid limit analysis alone: forces in balance, the limit and its mechanism."""
import chains
import tables
from draw_forces import draw_thrust
from geometry import force_text
from read_results import find, is_mechanism, number
from statics import chain_resultants


def asked_alone(results):
    return isinstance(results.result.get("rigid"), dict)


def add_thrust(page, results, edges, found, folder):
    """One picture for the loads of the scene, one for the limit."""
    standing = [step for step in results.stage_ends if not is_mechanism(step)]
    told = False
    for step in standing:
        at_limit = step.stage.endswith(": limit")
        path, largest = draw_thrust(results.mesh, results.joints, edges, step, found, folder,
                                    "thrust_at_the_limit" if at_limit else "thrust")
        line = "Red line: line of thrust, through the resultants of the joints of each arch or column. " if found else "" if told else f"{chains.NONE} "
        told = True
        dots = f"Dots: resultant of each joint, sized by its force, largest {force_text(largest)}."
        if at_limit:
            page.picture(path, f"Forces that balance the loads at the limit, factor {step.load_factor:.5g}. Where they touch an edge "
                         f"a joint turns, where they leave the cone of friction it slides. {line}{dots}")
        else:
            page.picture(path, "Forces that balance the loads of the scene with the resultants of all joints as near to the middle "
                         f"of their joints as can be. Others exist beside them; rigid stones do not tell which is real. {line}{dots}")
    tables.thrust_table(page, [(f"{chain.name}, factor {step.load_factor:.5g}", chain, chain_resultants(chain, results.joints, step))
                               for step in standing for chain in found])


def facts(results):
    tree, rigid = results.result, results.result["rigid"]
    collapse = tree.get("collapse") if isinstance(tree.get("collapse"), dict) else {}
    certified, estimate = number(collapse.get("certified_upper")), number(collapse.get("estimate_without_dilatancy"))
    seconds, _ = tables.seconds_of(results)
    rows = []
    if certified is not None:
        rows.append(("No equilibrium above", tables.short(certified, 6), "times the pattern of loads, by the static theorem"))
    found = number(rigid.get("forces_found_up_to"))
    if found is not None and certified is not None and found < certified * (1 - 1e-6):
        rows.append(("Forces are found up to", tables.short(found, 6), "times the pattern, where slip dilates"))
    if estimate is not None:
        rows.append(("Where slip does not dilate", tables.short(estimate, 6), "an estimate, no bound on either side"))
    if str(tree.get("outcome")) == "equilibrium" or certified is not None:
        factor = number(rigid.get("geometric_factor_of_safety"))
        what = ("a share of every joint, those between rings too, not the factor of one arch of that depth" if factor is None
                else f"a geometric factor of safety of {tables.short(factor, 4)} or more")
        if rigid.get("free_share_is_at_least"):
            what = "where the search for more ends" if factor is None else what
        rows.append(("Of every dry joint forces can leave free", ("at least " if rigid.get("free_share_is_at_least") else "")
                     + tables.margin_text(rigid.get("free_share_of_joints")),
                     f"counted from its edges, under the loads of the scene; {what}"))
    return rows + [("Computing time", "not given" if seconds is None else f"{seconds:.3g} s", tables.ranks_text(find(tree, "ranks"))),
                   ("Blocks / joints", f"{tables.count_text(find(tree, 'blocks'))} / {tables.count_text(find(tree, 'joints'))}", "")]


def add_ranges(page, results):
    """Between which ends the forces of supports can be."""
    ranges = results.result["rigid"].get("reactions")
    if not isinstance(ranges, dict) or not ranges:
        return
    page.section("Least and most thrust")
    page.words("Rigid stones leave open which of all forces in balance is the real one; those of every support lie between these ends. "
               "Where nothing bounds them, as between two supports that hold against each other, there is no end.")
    text = lambda value: "no end" if number(value) is None else force_text(number(value)) if abs(number(value)) > 0 else "0"
    space = any("least_z_N" in r for r in ranges.values() if isinstance(r, dict))
    ways = {"x": "along x", "y": "along y", "z": "upwards"} if space else {"x": "to the right", "y": "upwards"}
    page.table(["support", *(f"{end} {way}" for way in ways.values() for end in ("least", "most"))],
               [[name] + [text(r.get(f"{end}_{axis}_N")) for axis in ways for end in ("least", "most")]
                for name, r in sorted(ranges.items()) if isinstance(r, dict)])


def add_verdict(page, results):
    message = str(results.result.get("message") or "")
    if message:
        page.words(message[0].upper() + message[1:] + ".")

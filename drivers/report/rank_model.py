#!/usr/bin/python3
"""How the program will do on many ranks: a model made of counts, checked against counts, carried on to 10 000 ranks.

    rank_model.py DIR ... [--latency=2e-6] [--bandwidth=2e9] [--blocks-per-rank=1000] [--blocks=100000] [--memory=4]

Each DIR holds the systems.json of  scaling --systems=blocks  on another number of ranks (1, 2, 4, 8), or of
scaling --systems=space. The formulas stand in drivers/ranks.md. Latency [s] and bandwidth [bytes/s of a rank] are those of the network to be predicted, memory is
that of a rank [GB]; times of the processor are those measured in DIR on one rank. Writes DIR[0]/rank_model.csv.
"""
import csv
import json
import math
import sys
from dataclasses import dataclass
from pathlib import Path

PARTS = ("krylov", "block_motions", "transfer", "continuum")
RANKS = (1, 2, 4, 8, 16, 64, 256, 1024, 4096, 10000)
# Of one iteration of conjugate gradients with the symmetric preconditioner: products with H, solves with block
# motions, passages to the continuum and back, scalar products.
PRODUCTS, MOTIONS, TRANSFERS, SCALARS = 5, 2, 2, 3
HALO_OF_MOTIONS = 2      # exchanges of a solve with block motions: right side and solution
MOTIONS_ON_FIRST = 20000  # up to so many they go to the first rank and back (SharedSystemParameters)
# Of a cycle of levels of block motions: two products with them and a residual on the finest, and on all V_CYCLE.
FINEST_OF_MOTIONS = 5
LEAST_MOTIONS = 600      # a level of them moves to fewer ranks below so many per rank (BodyLevelsParameters)
COARSEST_MOTIONS = 300
SET_UP_EXCHANGES, SET_UP_SUMS = 36, 91  # of a level of motions that is built, as counted on 2 to 8 ranks
FIRST_EXCHANGES, FIRST_SUMS = 32, 45    # and once more
OF_MUELU = 3         # of the exchanges on the finest: the cycles that measure count them as its own
LANCZOS = 5              # cycles that measure it when it is built
V_CYCLE = 4          # exchanges on each level of the V-cycle: smoothers, residual, restriction, prolongation
MORE_SWEEPS = 4      # below the finest, where there are three sweeps for one, down (the first without an exchange) and up
LEAST_ROWS = 2000    # MueLu moves a level to fewer ranks below so many rows per rank
COARSEST_ROWS = 1000
NUMBER = 8           # bytes


@dataclass(frozen=True)
class Coarsening:
    """Rows for one of the next level, of walls."""
    first: float      # of the continuum: aggregates of nodes
    further: float    # aggregates of those
    group: float      # motions of blocks, or of groups, for one of a group of them


COARSENING = {2: Coarsening(6, 9.5, 8.5), 3: Coarsening(9.3, 7.3, 8.2)}


def border(ranks):
    """Length of all borders between square parts of a square of side 1."""
    return 2 * (math.sqrt(ranks) - 1)


def pairs(ranks):
    """Pairs of neighbours: a triangulation of the plane with the parts at the edge of the wall on its rim."""
    if ranks == 1:
        return 0
    return 3 * ranks - 3 - max(2, min(ranks, 4 * math.sqrt(ranks) - 4))


def levels(rows, ranks, coarsening):
    """Rows and ranks of each level, from the finest: in the plane aggregates of 9 nodes, 2 unknowns before and 3 after."""
    result = [(rows, ranks)]
    while result[-1][0] > COARSEST_ROWS:
        rows = rows / (coarsening.first if len(result) == 1 else coarsening.further)
        ranks = max(1, min(ranks, int(rows / LEAST_ROWS)))
        if rows <= COARSEST_ROWS:
            ranks = 1
        result.append((rows, ranks))
    return result


def motion_levels(rows, ranks, coarsening):
    """The same of block motions: groups of blocks, groups of those."""
    result = [(rows, ranks)]
    while result[-1][0] > COARSEST_MOTIONS:
        rows = rows / coarsening.group
        ranks = 1 if rows <= COARSEST_MOTIONS else max(1, min(ranks, int(rows / LEAST_MOTIONS)))
        result.append((rows, ranks))
    return result


def coarsening_of(r):
    return COARSENING[r.get("dimension", 2)]


def exchanges_of_motions(level):
    return FINEST_OF_MOTIONS if level == 0 else V_CYCLE


def exchanges_of(level):
    return V_CYCLE + (MORE_SWEEPS if level > 0 else 0)


class Widths:
    """Unknowns exchanged along a border as long as the wall, per root of all unknowns: fitted on few ranks, best two."""

    def __init__(self, rows):
        # A cycle of levels begins and ends with that of the right side and the solution, which is as wide as of factors.
        factored, with_levels = [r for r in rows if not has_levels(r)], [r for r in rows if has_levels(r)]
        self.motions = median((per_iteration(r, "block_motions", "total", "bytes") - to_first_and_back(r)[1])
                              / motions_halo(r, 1.0) for r in factored) if factored else self.all_of_motions(with_levels)
        self.groups = median((per_iteration(r, "block_motions", "total", "bytes") - motions_halo(r, self.motions)
                              - cycle_of_motions(r, 0)[1]) / (cycle_of_motions(r, 1)[1] - cycle_of_motions(r, 0)[1])
                             for r in with_levels) if with_levels else self.motions
        self.product = median(self.width(r, "krylov", PRODUCTS, r["unknowns"]) for r in rows)
        self.transfer = median(self.width(r, "transfer", TRANSFERS, r["unknowns"]) for r in rows)
        self.level = median((per_iteration(r, "continuum", "total", "bytes") - v_cycle(r, 0)[1])
                            / (v_cycle(r, 1)[1] - v_cycle(r, 0)[1]) for r in rows)

    @staticmethod
    def all_of_motions(rows):
        """Where none are factored: one width for what goes to neighbours before, in and after a cycle."""
        return median((per_iteration(r, "block_motions", "total", "bytes") - cycle_of_motions(r, 0)[1])
                      / (motions_halo(r, 1.0) + cycle_of_motions(r, 1)[1] - cycle_of_motions(r, 0)[1]) for r in rows)

    @staticmethod
    def width(r, part, times, unknowns):
        return per_iteration(r, part, "total", "bytes") / times / NUMBER / border(r["ranks"]) / math.sqrt(unknowns)


def median(values):
    values = sorted(values)
    return values[len(values) // 2]


def per_iteration(r, part, which, what):
    """What goes before the first iteration counts as another."""
    return r[f"{part}_{which}_{what}"] / (r["iterations"] + 1)


def continuum_rows(r):
    return float(r["level_rows"].split()[0]) if r["level_rows"] else 0.55 * r["unknowns"]


def has_levels(r):
    return bool(r["motion_level_rows"])


def on_first(coarse_unknowns):
    return coarse_unknowns <= MOTIONS_ON_FIRST


def to_first_and_back(r):
    """Messages and bytes of all ranks in one iteration, of block motions that the first rank factors."""
    if has_levels(r):
        return 0, 0
    return (MOTIONS * 2 * (r["ranks"] - 1), MOTIONS * 2 * NUMBER * r["coarse_unknowns"] * (1 - 1 / r["ranks"]))


def motions_halo(r, width):
    return MOTIONS * HALO_OF_MOTIONS * NUMBER * width * border(r["ranks"]) * math.sqrt(r["coarse_unknowns"])


def v_cycle(r, width):
    return sent_in_cycle(levels(continuum_rows(r), r["ranks"], coarsening_of(r)), exchanges_of, width)


def cycle_of_motions(r, width):
    """In one iteration, where levels stand for the solution."""
    if not has_levels(r):
        return 0, 0
    found = motion_levels(r["coarse_unknowns"], r["ranks"], coarsening_of(r))
    solved = sent_in_cycle(found, exchanges_of_motions, width)
    measured_by = sent_in_cycle(found, lambda level: OF_MUELU if level == 0 else V_CYCLE, width)
    return tuple(MOTIONS * a + LANCZOS / (r["iterations"] + 1) * b for a, b in zip(solved, measured_by))


def sent_in_cycle(found, exchanges, width):
    """Messages and bytes of all ranks in one V-cycle, with so many unknowns exchanged along the root of a level's rows."""
    messages = bytes_sent = 0
    for k, (rows, ranks) in enumerate(found):
        messages += exchanges(k) * 2 * pairs(ranks)
        bytes_sent += exchanges(k) * NUMBER * width * border(ranks) * math.sqrt(rows)
        if k + 1 < len(found) and found[k + 1][1] < ranks:
            messages += 2 * (ranks + found[k + 1][1] - 2)
            bytes_sent += 2 * NUMBER * found[k + 1][0] * (1 - found[k + 1][1] / ranks)
    return messages, bytes_sent


def predicted(r, widths):
    """Counts of one iteration, all ranks: the same names as measured ones."""
    n, ranks = r["unknowns"], r["ranks"]
    messages, bytes_sent = v_cycle(r, widths.level)
    return {
        "krylov messages": PRODUCTS * 2 * pairs(ranks),
        "krylov bytes": PRODUCTS * NUMBER * widths.product * border(ranks) * math.sqrt(n),
        "transfer messages": TRANSFERS * 2 * pairs(ranks),
        "transfer bytes": TRANSFERS * NUMBER * widths.transfer * border(ranks) * math.sqrt(n),
        "continuum messages": messages,
        "continuum bytes": bytes_sent,
        "block_motions messages": MOTIONS * HALO_OF_MOTIONS * 2 * pairs(ranks) + to_first_and_back(r)[0]
                                  + cycle_of_motions(r, 0)[0],
        "block_motions bytes": motions_halo(r, widths.motions) + to_first_and_back(r)[1]
                               + cycle_of_motions(r, widths.groups)[1],
        "collectives": SCALARS * ranks,
    }


def measured(r):
    found = {f"{part} {what}": per_iteration(r, part, "total", what)
             for part in ("krylov", "transfer", "continuum", "block_motions") for what in ("messages", "bytes")}
    found["collectives"] = sum(per_iteration(r, part, "total", "collectives") for part in PARTS)
    return found


def check(rows, widths):
    print("Counts of one iteration, all ranks: measured, predicted. Widths of borders are fitted on 2 ranks.\n")
    print("| courses | ranks | iterations | " + " | ".join(measured(rows[0])) + " |")
    print("|---" * (3 + len(measured(rows[0]))) + "|")
    for r in rows:
        if r["ranks"] == 1 or not r["level_rows"]:
            continue
        ours, model = measured(r), predicted(r, widths)
        cells = [f"{ours[name]:.4g}, {model[name]:.4g}" for name in ours]
        print(f"| {r['size']:g} | {r['ranks']} | {r['iterations']} | " + " | ".join(cells) + " |")
    print()


class Machine:
    """Seconds, of what was measured on one rank and of the network given."""

    def __init__(self, rows, options):
        self.latency, self.bandwidth = options["latency"], options["bandwidth"]
        alone = max((r for r in rows if r["ranks"] == 1), key=lambda r: r["unknowns"])
        self.alone = alone
        coarse = alone["motions_solve_s"] * MOTIONS
        self.iteration = alone["solve_s"] - alone["motions_factor_s"] - coarse * (alone["iterations"] + 1)
        self.iteration /= (alone["iterations"] + 1) * alone["unknowns"]
        # Of a plane graph in nested dissection: factors grow as n log n, their making as n^1.5.
        n = alone["coarse_unknowns"]
        self.factor = alone["motions_factor_s"] / n ** 1.5
        self.coarse_solve = alone["motions_solve_s"] / (n * math.log2(n))
        # Levels of block motions take time in proportion to them.
        self.build, self.cycle = alone["levels_build_s"] / n, alone["levels_cycle_s"] / n

    def exchange(self, neighbours, bytes_sent):
        return neighbours * self.latency + bytes_sent / self.bandwidth

    def sum(self, ranks, bytes_each):
        """A tree for short sums, a ring for long ones: nobody sends more than twice its bytes."""
        steps = math.ceil(math.log2(ranks)) if ranks > 1 else 0
        return 2 * steps * self.latency + (2 * bytes_each / self.bandwidth if ranks > 1 else 0)


def seconds(blocks, ranks, machine, widths, iterations):
    """One linear solve with new resistances: parts of it."""
    alone = machine.alone
    unknowns = blocks * alone["unknowns"] / alone["blocks"]
    coarse = blocks * alone["coarse_unknowns"] / alone["blocks"]
    k = 2 * pairs(ranks) / ranks
    inner = border(ranks) / ranks  # of one rank, mean; those inside have up to twice as much at few ranks

    def exchanges(times, width):
        return times * machine.exchange(k, NUMBER * width * inner * math.sqrt(unknowns))

    halo = exchanges(PRODUCTS, widths.product) + exchanges(TRANSFERS, widths.transfer)
    share = continuum_rows(alone) / alone["unknowns"]
    coarsening = coarsening_of(alone)
    multigrid, found = 0.0, levels(unknowns * share, ranks, coarsening)
    for j, (rows, on) in enumerate(found):
        if on > 1:
            multigrid += exchanges_of(j) * machine.exchange(2 * pairs(on) / on,
                                                            NUMBER * widths.level * border(on) / on * math.sqrt(rows))
        if j > 0:  # coarse levels are not divided as far; a row costs an eighth of one of H with its blocks
            multigrid += machine.iteration / 8 * max(0.0, rows / on - rows / ranks)
        if j + 1 < len(found) and found[j + 1][1] < on:
            from_each = on / found[j + 1][1]
            multigrid += 2 * machine.exchange(from_each, NUMBER * found[j + 1][0] / found[j + 1][1])
    motions = MOTIONS * HALO_OF_MOTIONS * machine.exchange(k, NUMBER * widths.motions * inner * math.sqrt(coarse))
    applied = iterations + 1
    sent, solved = block_motions(coarse, ranks, machine, widths, applied)
    return {
        "blocks and products": applied * machine.iteration * unknowns / ranks * 1.03,  # METIS: 3 % off balance
        "halo": applied * halo,
        "multigrid": applied * multigrid,
        "sums": applied * SCALARS * machine.sum(ranks, NUMBER),
        "messages of block motions": applied * motions + sent,
        "block motions": solved,
    }


def block_motions(coarse, ranks, machine, widths, applied):
    """Seconds of messages, and of processors, of a solve: direct on one rank and where they are few, by levels else."""
    if ranks == 1 or on_first(coarse):
        there_and_back = 2 * machine.exchange(ranks - 1, NUMBER * coarse * (1 - 1 / ranks)) if ranks > 1 else 0.0
        return (applied * MOTIONS * there_and_back,
                applied * MOTIONS * machine.coarse_solve * coarse * math.log2(coarse) + machine.factor * coarse ** 1.5)
    found = motion_levels(coarse, ranks, coarsening_of(machine.alone))
    sent, built, rows_done = 0.0, FIRST_SUMS * machine.sum(ranks, NUMBER), coarse / ranks
    for j, (rows, on) in enumerate(found):
        if on > 1:
            once = machine.exchange(2 * pairs(on) / on, NUMBER * widths.groups * border(on) / on * math.sqrt(rows))
            sent += exchanges_of_motions(j) * once
            built += (SET_UP_EXCHANGES + (FIRST_EXCHANGES if j == 0 else 0)) * once + SET_UP_SUMS * machine.sum(on, NUMBER)
        if j > 0:  # which are not divided as far
            rows_done += max(0.0, rows / on - rows / ranks)
        if j + 1 < len(found) and found[j + 1][1] < on:
            sent += 2 * machine.exchange(on / found[j + 1][1], NUMBER * found[j + 1][0] / found[j + 1][1])
    return (applied * MOTIONS * sent + LANCZOS * sent + built,
            applied * MOTIONS * machine.cycle * rows_done + machine.build * rows_done)


def replicated_bytes(rows):
    """Of block motions and one block, on the first rank: what does not become less with ranks where it factors them."""
    most = max((r for r in rows if r["level_rows"] and not has_levels(r)), key=lambda r: (r["ranks"], r["size"]))
    alone = next(r for r in rows if r["ranks"] == 1 and r["size"] == most["size"])
    ranks = most["ranks"]
    return (ranks * most["motions_bytes"] - alone["motions_bytes"]) / (ranks - 1) / most["blocks"]


def memory(blocks, ranks, alone, replicated):
    """GB of the first rank: its share of everything, and the factors of block motions whole or its share of them."""
    own = alone["peak_memory_MB"] * 1e6 / alone["blocks"] - replicated
    motions = blocks * alone["coarse_unknowns"] / alone["blocks"]
    return (own * blocks / ranks + replicated * blocks / (1 if on_first(motions) else ranks)) / 1e9


def tables(rows, widths, options):
    machine = Machine(rows, options)
    replicated = replicated_bytes(rows)
    iterations = machine.alone["iterations"]
    largest = max(r["size"] for r in rows if r["ranks"] > 1)
    on_many = max(r["iterations"] for r in rows if r["ranks"] > 1 and r["size"] == largest)
    print(f"On one rank here: {machine.iteration * 1e9:.0f} ns an unknown and iteration, W({machine.alone['size']:g}) "
          f"factors its block motions in {machine.alone['motions_factor_s']:.2g} s; {iterations} iterations, "
          f"on several ranks {on_many}, as W({largest:g}) at most.\n"
          f"Network: {machine.latency:g} s, {machine.bandwidth:g} bytes/s of a rank. "
          f"Memory of a rank: {options['memory']:g} GB; "
          f"{replicated / 1e3:.2g} kB of each block on the first rank, where it factors block motions.\n")
    table = []
    for kind in ("strong", "weak"):
        print(f"{kind} scaling: " + (f"{options['blocks']:g} blocks" if kind == "strong" else
                                     f"{options['blocks-per-rank']:g} blocks a rank"))
        print("| ranks | blocks | solve [s] | efficiency | without block motions | GB of a rank | largest part |\n"
              + "|---" * 7 + "|")
        first = None
        for ranks in RANKS:
            blocks = options["blocks"] if kind == "strong" else options["blocks-per-rank"] * ranks
            if blocks < ranks:
                continue
            parts = seconds(blocks, ranks, machine, widths, iterations if ranks == 1 else on_many)
            all_parts = sum(parts.values())
            others = all_parts - parts["block motions"] - parts["messages of block motions"]
            first = first or (all_parts, others)
            ideal = ranks if kind == "strong" else 1
            limit = max(parts, key=parts.get)
            gigabytes = memory(blocks, ranks, machine.alone, replicated)
            row = {"kind": kind, "ranks": ranks, "blocks": blocks, "seconds": all_parts,
                   "efficiency": first[0] / all_parts / ideal, "efficiency_without": first[1] / others / ideal,
                   "gigabytes": gigabytes, "fits": gigabytes <= options["memory"], **parts}
            table.append(row)
            print(f"| {ranks} | {blocks:g} | {all_parts:.3g} | {100 * row['efficiency']:.3g} % | "
                  f"{100 * row['efficiency_without']:.3g} % | {gigabytes:.3g}{'' if row['fits'] else ' (too much)'} | "
                  f"{limit}, {100 * parts[limit] / all_parts:.0f} % |")
        print()
    return table


def main(words):
    options = {"latency": 2e-6, "bandwidth": 2e9, "blocks-per-rank": 1000.0, "blocks": 1e5, "memory": 4.0}
    folders = []
    for word in words:
        name, _, value = word.removeprefix("--").partition("=")
        if word.startswith("--") and name in options:
            options[name] = float(value)
        elif word.startswith("--"):
            sys.exit(f"rank_model.py: '{word}' is no option.\n{__doc__}")
        else:
            folders.append(Path(word))
    if not folders:
        sys.exit(__doc__)
    rows = [r for folder in folders for r in json.loads((folder / "systems.json").read_text(encoding="utf-8"))
            if r["family"] in ("blocks", "space")]
    if len({r.get("dimension", 2) for r in rows}) > 1:
        sys.exit("rank_model.py: the folders hold walls of the plane and in space, which are not one family.\n"
                 "  Give folders of --systems=blocks, or of --systems=space.")
    two = [r for r in rows if r["ranks"] == 2 and r["level_rows"]]
    if not two or not any(r["ranks"] == 1 for r in rows):
        sys.exit("rank_model.py: the folders must hold runs on 1 and on 2 ranks, of walls of at least 16 courses.\n"
                 "  mpirun -n 2 scaling --systems=blocks --largest=64 --out=DIR")
    widths = Widths(two)
    check(sorted(rows, key=lambda r: (r["ranks"], r["size"])), widths)
    table = tables(rows, widths, options)
    with open(folders[0] / "rank_model.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, fieldnames=list(table[0]))
        writer.writeheader()
        writer.writerows(table)


if __name__ == "__main__":
    main(sys.argv[1:])

#!/usr/bin/python3
"""Draws the page of a sweep: make_sweep.py DIR

Reads sweep.csv, sweep.json and, where there is one, envelope.json in DIR; writes DIR/sweep.html and DIR/sweep.svg. The page
links to the reports of the runs, which lie below DIR/runs.
"""
import csv
import json
import sys
from pathlib import Path

import draw_sweep
from geometry import counted
from html_page import Page
from read_results import number

# Columns of sweep.csv as the page shows them: name, heading, factor, unit.
SHOWN = (("load_factor", "load factor", 1, ""), ("factor_stands", "factor that stands", 1, ""), ("factor_falls", "factor that falls", 1, ""),
         ("largest_displacement_m", "largest displacement", 1e3, "mm"), ("residual_displacement_m", "residual", 1e3, "mm"),
         ("peak_drift", "peak drift", 100, "%"), ("peak_opening_m", "widest opening", 1e3, "mm"), ("peak_slip_m", "longest slip", 1e3, "mm"),
         ("least_edge_margin", "edge margin", 100, "%"), ("least_friction_margin", "friction margin", 100, "%"), ("seconds", "seconds", 1, ""))
WORDS = {"equilibrium": "in equilibrium"}
KINDS = {"equilibrium": "good", "collapse": "good", "out_of_range": "warn", "not_converged": "warn"}


def heading(words, unit):
    return f"{words} [{unit}]" if unit else words


def text_of(row, column, factor):
    found = number(row.get(column))
    return "" if found is None else f"{factor * found:.4g}"


def in_words(column):
    """A column of sweep.csv with its unit, and the factor to it: "largest displacement [mm]", "thrust x [kN] of ground"."""
    name, of, whose = column.partition(" of ")
    stem, _, unit = name.rpartition("_")
    shown, factor = {"m": ("mm", 1e3), "N": ("kN", 1e-3)}.get(unit, ("", 1))
    return (f"{stem.replace('_', ' ')} [{shown}]" if shown else name.replace("_", " ")) + of + whose, factor


def further_columns(rows):
    """Of supports and observed places: name, heading, factor, unit."""
    for name in rows[0]:
        if "_N of " in name:
            yield name, name.replace("_N of ", " of ").replace("_", " "), 1e-3, "kN"
        elif name.startswith("peak_m of "):
            yield name, name.replace("peak_m of ", "peak of "), 1e3, "mm"


def the_same_in_all(rows, shown):
    """Columns that tell the same of every run, of which one sentence says more than a column does."""
    told = {column: {text_of(row, column, factor) for row in rows} for column, _, factor, _ in shown}
    return [column for column in shown if len(rows) > 1 and column[0] != "seconds" and len(told[column[0]]) == 1]


def add_table(page, rows, inputs, names):
    shown = [column for column in (*SHOWN, *further_columns(rows)) if any(number(row.get(column[0])) is not None for row in rows)]
    same = the_same_in_all(rows, shown)
    shown = [column for column in shown if column not in same]
    words = ["run", *(names[path] for path in inputs), "outcome", "stands"]
    page.section("All runs")
    page.words("Each row is a run. Its name leads to its report, where there is one; sweep.csv has all numbers."
               + (f" The same in all: {', '.join(f'{name} {text_of(rows[0], column, factor)} {unit}'.strip() for column, name, factor, unit in same)}."
                  if same else ""))
    page.table([*words, *(heading(name, unit) for _, name, _, unit in shown)],
               [[str(k), *(row[path] for path in inputs), row["outcome"].replace("_", " "), row["stands"],
                 *(text_of(row, column, factor) for column, _, factor, _ in shown)] for k, row in enumerate(rows, 1)],
               range(len(words)), [row.get("report") or None for row in rows])
    silent = [row for row in rows if row["outcome"] not in ("equilibrium", "collapse") and row["message"]]
    if silent:
        page.part("What runs said that came to no equilibrium and no collapse")
        page.table(["run", "outcome", "words"], [[row["run"], row["outcome"].replace("_", " "), row["message"]] for row in silent], range(3))


def add_envelope(page, folder, rows):
    path = folder / "envelope.json"
    if not path.exists():
        return
    found = json.loads(path.read_text(encoding="utf-8"))
    page.section("Envelope")
    page.words(f"Of {found['that_ended']} of {counted(found['runs'], 'run')}: those that came to their end.")
    for stands in found["stands"]:
        below = "no run below it stands" if stands["stands_up_to"] is None else f"all runs stand up to {stands['stands_up_to']:.6g}"
        page.words(f"{stands['input']}: {below}; one falls at {stands['falls_at']:.6g}.")
    page.table(["quantity", "", "value", "run"], list(dict.fromkeys(envelope_row(worst, rows) for worst in found["worst"])), (0, 1, 3))


def envelope_row(worst, rows):
    """Which run is worst in a quantity; of one that is the same in all that is said instead."""
    words, factor = in_words(worst["column"])
    values = {text_of(row, worst["column"], factor) for row in rows} - {""}
    same = len(values) == 1 and len(rows) > 1
    return words, "" if same else worst["which"], f"{factor * worst['value']:.4g}", "the same in all" if same else worst["run"]


def main(folder):
    question = json.loads((folder / "sweep.json").read_text(encoding="utf-8"))
    with open(folder / "sweep.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    inputs = question["inputs"]
    done = [row for row in rows if row["exit_code"] != ""]
    names = draw_sweep.names_of(list(inputs), question.get("units"))
    page = Page(f"{question.get('title') or Path(question['asked']['scene']).stem}: {', '.join(names[path] for path in draw_sweep.varied(inputs) or inputs)}")
    counts = {}
    for row in rows:
        counts[row["outcome"]] = counts.get(row["outcome"], 0) + 1
    kinds = {KINDS.get(outcome, "bad") for outcome in counts}
    page.head(", ".join(f"{number_of} {WORDS.get(word, word.replace('_', ' '))}" for word, number_of in counts.items()),
              next(kind for kind in ("bad", "warn", "good") if kind in kinds))
    if len(done) < len(rows):
        page.words(f"{len(rows) - len(done)} of {counted(len(rows), 'run')} {'has' if len(rows) - len(done) == 1 else 'have'} not been computed; the same command goes on.")
    fixed = [f"{names[path]} = {values[0]}" for path, values in inputs.items() if len(values) == 1]
    if fixed or question["asked"]["options"]:
        page.words(f"In all runs: {', '.join([*fixed, *question['asked']['options']])}.")
    path, caption = draw_sweep.draw_sweep(rows, inputs, question["zip"], folder, question.get("units"))
    if path:
        page.drawing(path, caption)
    else:
        page.words(caption)
    add_envelope(page, folder, rows)
    add_table(page, rows, list(inputs), names)
    page.write(folder / "sweep.html")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))

"""The table of a sweep: what a row tells of a run, and what is worst over all rows."""

import csv
import io
import math

import numpy

from . import program
from .program import write_atomically
from .result import Result

# Columns that every sweep has; those of supports and observed places come behind `least_friction_margin`.
COLUMNS = ["outcome", "stands", "exit_code", "load_factor", "factor_stands", "factor_falls", "largest_displacement_m",
           "residual_displacement_m", "peak_drift", "peak_opening_m", "peak_slip_m", "least_edge_margin",
           "least_friction_margin"]
LAST = ["error_estimate", "warnings", "seconds", "report", "message"]
# Where the worst is: the least or the largest of a column.
LEAST = ("factor_stands", "factor_falls", "least_edge_margin", "least_friction_margin")
LARGEST = ("largest_displacement_m", "residual_displacement_m", "peak_drift", "peak_opening_m", "peak_slip_m")
LONGEST_MESSAGE = 400  # letters


def stands(result):
    """Whether the structure bears what its stages ask for: yes, no, or nothing where that is not known."""
    if result.collapse and result.outcome in ("equilibrium", "collapse"):
        return "yes"  # the stages are borne, and then the pattern is raised
    return {"equilibrium": "yes", "collapse": "no", "out_of_range": "no"}.get(result.outcome, "")


def one_line(text):
    text = " ".join(text.split())
    return text if len(text) <= LONGEST_MESSAGE else text[:LONGEST_MESSAGE - 1] + "…"


def row_of(result, code, said, seconds):
    """What a run came to, as the columns of the table; of a run without a result its exit code and its last words."""
    refused = {program.WRONG_INPUT: "refused", program.NO_RESOURCE: "no_resource", program.STOPPED: "interrupted"}
    row = {"exit_code": code, "seconds": round(seconds, 2), "outcome": refused.get(code, "not_converged")}
    if code not in (*refused, program.DONE, program.NO_CONVERGENCE):
        row["outcome"] = "crashed"
    row["message"] = one_line(said)
    if not result.json:
        return row
    known = result.json
    statics = known.get("statics") or {}
    lower, upper = result.factor
    row.update(outcome=result.outcome, stands=stands(result), factor_stands=lower, factor_falls=upper,
               message=one_line(result.message), warnings=len(result.warnings),
               seconds=(known.get("seconds") or {}).get("total", row["seconds"]))
    row.update({key: statics.get(key) for key in ("least_edge_margin", "least_friction_margin")})
    for name, force in (statics.get("reactions") or {}).items():
        row.update({f"thrust_{axis}_N of {name}": force[f"{axis}_N"] for axis in "xyz" if f"{axis}_N" in force})
    for name, ranges in ((result.rigid or {}).get("reactions") or {}).items():
        row.update({f"{key} of {name}": value for key, value in ranges.items()})
    if not result.rigid:  # rigid stones do not move until they fall
        row.update({key: known.get(key) for key in ("load_factor", "largest_displacement_m", "residual_displacement_m",
                                                    "error_estimate")})
        peaks = result.peaks
        row.update(peak_drift=peaks["drift"], peak_opening_m=peaks["opening_m"], peak_slip_m=peaks["slip_m"])
        row.update({f"peak_m of {name}": value for name, value in peaks["places"].items()})
    return row


def read_row(folder, code, said, seconds):
    """The row of a run in a folder; of one whose files cannot be read what is known without them."""
    try:
        return row_of(Result(folder), code, said, seconds)
    except (OSError, ValueError, KeyError, TypeError) as problem:
        return {"exit_code": code, "seconds": round(seconds, 2), "outcome": "unreadable", "message": one_line(f"{problem}")}


def columns_of(paths, rows):
    """All columns, in their order."""
    known = {"run", *paths, *COLUMNS, *LAST}
    further = [name for row in rows for name in row if name not in known]
    return ["run", *paths, *COLUMNS, *dict.fromkeys(further), *LAST]


def cell(value):
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return ""
    return repr(value) if isinstance(value, float) else str(value)


def write_table(path, paths, rows):
    """sweep.csv, whole or not at all."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    columns = columns_of(paths, rows)
    writer.writerow(columns)
    writer.writerows([cell(row.get(name)) for name in columns] for row in rows)
    write_atomically(path, text.getvalue())


def numbers(rows, column):
    """Values of a column, not a number where a row has none."""
    found = []
    for row in rows:
        try:
            found.append(float(row.get(column)))
        except (TypeError, ValueError):
            found.append(math.nan)
    return numpy.array(found)


def worst_of(rows, column, least):
    """The row that is worst in a column, with its value; None where no row has one."""
    values = numbers(rows, column)
    if numpy.isnan(values).all():
        return None
    k = int(numpy.nanargmin(values) if least else numpy.nanargmax(values))
    return {"column": column, "which": "least" if least else "largest", "value": float(values[k]), "run": rows[k]["run"]}


def envelope(paths, rows):
    """Of every quantity its worst value and the run that has it; of every input that grows, up to where all stand.

    Only runs count that came to their end: what a run that was stopped has not reached is not known."""
    ended = [row for row in rows if row.get("exit_code") in (program.DONE, program.NO_CONVERGENCE)
             and row.get("outcome") != "not_converged"]
    further = [name for name in columns_of(paths, ended) if " of " in name and name not in paths]
    worst = [worst_of(ended, name, True) for name in LEAST] + [worst_of(ended, name, False) for name in LARGEST]
    for name in further:
        worst += [worst_of(ended, name, least) for least in ((True, False) if "_N of " in name else (False,))]
    return {"runs": len(rows), "that_ended": len(ended), "worst": [found for found in worst if found],
            "stands": [found for path in paths if (found := last_that_stands(path, ended))]}


def last_that_stands(path, rows):
    """Of an input the largest value up to which every run stands, and the least at which one does not."""
    values, told = numbers(rows, path), [row.get("stands") for row in rows]
    if numpy.isnan(values).any() or len(set(values)) < 2 or "no" not in told:
        return None
    falls = min(value for value, word in zip(values, told) if word == "no")
    below = [value for value, word in zip(values, told) if word == "yes" and value < falls]
    return {"input": path, "stands_up_to": max(below, default=None), "falls_at": float(falls)}

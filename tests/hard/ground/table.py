"""The table of stability figures, as CSV and as Markdown."""

import csv

HEADING = ("case", "ranks", "outcome", "steps", "linear solves", "Krylov iterations", "contact residual", "energy imbalance",
           "seconds", "compared with", "deviation", "allowed", "fault")


def row(verdict):
    run, result, worst = verdict.run, verdict.run.result, verdict.worst
    counts = [result.get(key, "") for key in ("steps", "linear_solves", "krylov_iterations")]
    outcome = verdict.outcome if verdict.passed else "FAILED"
    figures = ["", ""]
    if result:
        residual = result.get("complementarity_residual")
        figures = ["" if residual is None else f"{residual:.0e}", f"{run.imbalance():.0e}"]
    compared = [worst.what, f"{worst.deviation():.1e}", f"{worst[-1]:.0e}"] if worst else ["", "", ""]
    fault = "; ".join(verdict.faults)
    if verdict.case.fails:
        fault = f"known: {verdict.case.fails}" if fault else "listed as failing, but passes"
    return [verdict.case.title, verdict.case.ranks, outcome, *counts, *figures, f"{run.seconds:.1f}", *compared, fault]


def write(verdicts, path):
    """path.csv and path.md."""
    rows = [row(verdict) for verdict in verdicts]
    with open(path.with_suffix(".csv"), "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([HEADING, *rows])
    lines = ["| " + " | ".join(HEADING) + " |", "|" + "---|" * len(HEADING)]
    lines += ["| " + " | ".join(str(field).replace("|", "/") for field in fields) + " |" for fields in rows]
    path.with_suffix(".md").write_text("\n".join(lines) + "\n", encoding="utf-8")

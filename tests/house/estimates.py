"""What Markdown says of the error estimate is what drivers/studies/estimates.csv holds."""

import csv

import house

TABLE = "drivers/studies/estimates.csv"
FINE = 0.03  # thresholds of 3 % and less
PLACES = ("README.md", "src/method.md", "src/selection/README.md")


def words_of(rows):
    """Pieces of text that tell the range of the ratio, of all runs and of those with fine thresholds."""
    ratios = [float(row["ratio"]) for row in rows]
    fine = [float(row["ratio"]) for row in rows if float(row["threshold"]) <= FINE]
    return [f"{min(ratios):.2f}", f"{max(ratios):.1f}", f"{min(fine):.2f}", f"{max(fine):.1f}"]


def of_displacements(rows):
    """How many times the estimate the largest displacement is off at most, likewise."""
    share = [(float(row["displacement_error_percent"]) / (float(row["ratio"]) * float(row["error_percent"])), float(row["threshold"]))
             for row in rows]
    return [f"{max(s for s, _ in share):.1f} times the estimate", f"{max(s for s, t in share if t <= FINE):.1f} times"]


def main():
    lines = [line for line in house.read(TABLE).splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    problems = []
    for place in PLACES:
        text = " ".join(house.read(place).split())
        said = words_of(rows) + (of_displacements(rows) + [f"{len(rows)} runs"] if place != "src/method.md" else [])
        problems += [f"{place}: does not say {words}, as {TABLE} has it." for words in said if words not in text]
    house.finish("The error estimate is as it was measured", problems)


if __name__ == "__main__":
    main()

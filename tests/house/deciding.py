"""Every number that decides how a run is solved has a reason, and the reason holds.

    deciding.py                           checks drivers/studies/numbers.csv against the sources and the ablation
    deciding.py --prove PROGRAM MPIEXEC    runs the tests that guard numbers, with these changed: they must fail

A number is a member of a `*_parameters.hpp` or a constexpr of a source, in the rooms that solve and judge. Those that users
set are no part of it: xml/reference.xml explains them. Kinds:

| kind | the number |
|---|---|
| round-off | is what arithmetic loses, or far below all that matters |
| derived | follows from another one, as its text tells |
| bound | ends what would not end, or what a file may hold; no run that arrives meets it |
| told | decides what is worth telling, and nothing that is computed |
| magnitude | decides; made of base/order_of_magnitude.hpp, since it only keeps sizes apart and nothing finer is known of it |
| principle | decides; its reason is of physics, mathematics, cost or literature, and stands beside it |
| row | decides; with it times 3, or by 3, a count of ablation.csv changes by a tenth |
| study | decides; another table of drivers/studies has it |
| test | decides; the test named fails with the value `fails_with` |
| open | decides; neither a principle nor a measurement keeps it yet, so it is the next to be derived or left out |
"""

import csv
import importlib.machinery
import importlib.util
import pathlib
import re
import stat
import subprocess
import sys

import house

TABLE = "drivers/studies/numbers.csv"
ROOMS = ("nonlinear", "step", "time", "ties", "selection", "homogenisation", "linalg", "statics", "dynamics", "model", "run", "range")
ALSO = ("base/order_of_magnitude.hpp",)
# What users set.
USERS = {f"{name}_parameters.hpp" for name in ("newton", "selection", "preconditioner", "solver", "time", "load_factor", "load_step",
                                               "construction")}
DECIDE = ("magnitude", "principle", "row", "study", "test", "open")
KINDS = ("round-off", "derived", "bound", "told") + DECIDE
MOST, OPEN = 90, 0  # numbers that decide; of these, open ones
TENTH = 0.1
# Sections of `voussoir --print-internals` by the file of their struct.
SECTIONS = {"active_set": "active set", "contact_solver": "contact solver", "interior_path": "interior path", "patch": "patches",
            "pseudo_time": "pseudo-time", "step": "step", "time_step": "time step", "rest": "rest", "tie": "ties",
            "coarse_operator": "preconditioner"}
TYPE = r"(?:double|int|std::size_t|long long)"
MEMBER = re.compile(rf"^ *(?:static )?(?:constexpr )?{TYPE} (?=\w+(?:\[\])? *=)([^;]*);", re.MULTILINE)
CONSTANT = re.compile(rf"\bconstexpr {TYPE} (?=\w+(?:\[\])? *=)([^;]*);")
# No numbers: infinity, what is no number, the circle, and counts of a thing that is not counted otherwise.
NOTHING = re.compile(r"numeric_limits<double>::(infinity|quiet_NaN|max)\(\)|^3\.14159|::infinity$")


def declarators(text):
    """Pairs of name and value of `a = 1, b = {2, 3}`."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter in "({<") - (letter in ")}>")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    for part in parts:
        name, value = part.split("=", 1)
        yield name.strip().rstrip("[]"), " ".join(value.split())


def numbers_of(name, text):
    """Pairs of name and value that a file declares."""
    code = re.sub(r"//[^\n]*", "", text)
    for match in (MEMBER if name.endswith("_parameters.hpp") else CONSTANT).finditer(code):
        yield from ((n, value) for n, value in declarators(match.group(1)) if not NOTHING.search(value))


def in_sources():
    """(file below src, name) -> value as it is written."""
    found = {}
    for path in house.code_files(".hpp", ".cpp"):
        file = str(path.relative_to("src")) if path.parts[0] == "src" else ""
        if file in ALSO or (file and path.parts[1] in ROOMS and path.name not in USERS):
            found.update({(file, name): value for name, value in numbers_of(path.name, house.read(path))})
    return found


def setting_of(row):
    """The path of a number in `voussoir --print-internals`."""
    section = SECTIONS.get(pathlib.Path(row["file"]).name.removesuffix("_parameters.hpp"))
    return f"{section}/{row['name'].replace('_', ' ')}"


def rows():
    lines = [line for line in house.read(TABLE).splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines))


def moved_by():
    """The largest change of counts of every setting, over scenes and changes, in the middle of the kernels."""
    loader = importlib.machinery.SourceFileLoader("ablation", str(house.ROOT / "drivers/ablation"))
    ablation = importlib.util.module_from_spec(importlib.util.spec_from_loader("ablation", loader))
    loader.exec_module(ablation)
    most = {}
    for (setting, _, _), (by, *_) in ablation.changes_of(ablation.read(house.ROOT / "drivers/studies/ablation.csv")).items():
        most[setting] = max(by, most.get(setting, 0))
    return most


def problem_of_reason(row, moves):
    """What is wrong with what a row says keeps its number, or None."""
    name, kept_by = f"{row['file']}: {row['name']}", row["kept_by"]
    if row["kind"] not in KINDS:
        return f'{name}: there is no kind "{row["kind"]}".'
    if "order_of_magnitude" in row["value"] and row["kind"] == "derived":
        return f"{name}: an order of magnitude is chosen, so it is of the kind magnitude."
    if not kept_by:
        return f"{name}: says nothing of what keeps it."
    if row["kind"] == "row" and not moves.get(setting_of(row), 0) >= TENTH:
        return f"{name}: ablation.csv has no row in which {setting_of(row)} changes a count by a tenth."
    if row["kind"] == "study" and not (house.ROOT / "drivers/studies" / kept_by.split()[0]).exists():
        return f"{name}: there is no drivers/studies/{kept_by.split()[0]}."
    if row["kind"] == "test":
        file, _, case = kept_by.partition(" ")
        if not (house.ROOT / file).exists() or case.split(".")[-1] not in house.read(file):
            return f"{name}: there is no test {kept_by}."
    return None


def problems_of(sources, table, moves, most=MOST, most_open=OPEN):
    known = {(row["file"], row["name"]): row for row in table}
    problems = [f"src/{file}: {name} = {value} is not in {TABLE}." for (file, name), value in sources.items()
                if (file, name) not in known]
    for key, row in known.items():
        if key not in sources:
            problems.append(f"{TABLE}: src/{key[0]} has no {key[1]}.")
        elif sources[key] != row["value"]:
            problems.append(f"{TABLE}: {key[1]} of src/{key[0]} is {sources[key]} and not {row['value']}.")
        problems.append(problem_of_reason(row, moves))
    for what, kinds, bound in (("decide", DECIDE, most), ("are open", ("open",), most_open)):
        if (count := sum(row["kind"] in kinds for row in table)) > bound:
            problems.append(f"{TABLE}: {count} numbers {what}, at most {bound} may: one of them is to be derived or left out.")
    return [problem for problem in problems if problem]


def cases_that_fail(program, mpiexec, file, case, setting, value):
    """Names of the cases of a test that fail, or come to no end, when a setting of every run in it is another."""
    changed = pathlib.Path("changed").resolve()
    changed.write_text(f'#!/bin/sh\nexec "{program}" "$@" --set "internals/{setting}={value}"\n', encoding="utf-8")
    changed.chmod(changed.stat().st_mode | stat.S_IXUSR)
    text = house.read(file)
    which = [case] if "program.main()" in text and case else ["short"] if '"short"' in text else []
    done = subprocess.run([sys.executable, "-B", str(house.ROOT / file), str(changed), mpiexec, *which],
                          capture_output=True, text=True, check=False)
    failed = set(re.findall(r"^(?:FAIL|ERROR): (\w+)", done.stderr, re.MULTILINE))
    if done.returncode != 0 and not failed:
        sys.exit(f"{file} does not run:\n{done.stderr}")
    return failed


def prove(program, mpiexec):
    """Whether tests fail with the values that the table says they fail with."""
    problems = []
    for row in rows():
        if row["kind"] != "test" or not row["fails_with"]:
            continue
        file, _, case = row["kept_by"].partition(" ")
        change = f"{setting_of(row)} = {row['fails_with']}"
        failed = case.split(".")[-1] in cases_that_fail(program, mpiexec, file, case, setting_of(row), row["fails_with"])
        print(f"{change}: {case} {'fails' if failed else 'holds'}", flush=True)
        if not failed:
            problems.append(f"{file}: {case} holds with {change}.")
    house.finish("Tests fail without the numbers they guard", problems)


def main():
    if sys.argv[1:2] == ["--prove"]:
        prove(str(pathlib.Path(sys.argv[2]).resolve()), sys.argv[3])
    table = rows()
    counts = {kind: sum(row["kind"] == kind for row in table) for kind in KINDS}
    print(f"{sum(counts[k] for k in DECIDE)} numbers decide; " + ", ".join(f"{n} {kind}" for kind, n in counts.items()))
    house.finish("Numbers that decide have a reason that holds", problems_of(in_sources(), table, moved_by()))


if __name__ == "__main__":
    main()

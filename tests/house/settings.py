"""Settings named in Markdown exist, and a number given with one is its value.

    settings.py PROGRAM

A setting is named as `section > key`, a part of its path in `voussoir --print-internals` or `--print-parameters`. Its value
may stand before the name, "8 solves (`active set > patience`)", or behind it, "`newton > tolerance` (1e-8 by default)".
"""

import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import house

NAME = r"`([a-z][a-z0-9-]*(?:\s+[a-z0-9-]+)*(?:\s+>\s+[a-z][a-z0-9-]*(?:\s+[a-z0-9-]+)*)+)`"
WORDS = {word: k for k, word in enumerate("zero one two three four five six seven eight nine ten eleven twelve".split())}
NUMBER = r"(\d+(?: \d{3})+|10\^-?\d+|\d+(?:\.\d+)?(?:e-?\d+)?|" + "|".join(WORDS) + r")"
# Up to four words between a number and the setting in parentheses behind it.
BEFORE = re.compile(r"(?<![\w.^])" + NUMBER + r"(?: %)?(?:[ \n]+(?!" + NUMBER + r"\b)[^\s().`|]+){0,4}[ \n]+\(" + NAME + r"\)", re.IGNORECASE)
BEHIND = re.compile(NAME + r"[ \n]+\(" + NUMBER + r"\b(?! \()", re.IGNORECASE)
RESULTS = "result.json"  # whose keys are named in the same way, beside its name


def value_of(text):
    text = text.lower().replace(" ", "")
    if text in WORDS:
        return float(WORDS[text])
    return float(f"1e{text[3:]}") if text.startswith("10^") else float(text)


def settings_of(*documents):
    """Path of names from the outermost section -> values as text; alternatives of a section may share one."""
    found = {}

    def walk(node, path):
        for child in node:
            names = (*path, child.get("name"))
            if child.tag == "Parameter":
                found.setdefault(names, set()).add(child.get("value"))
            else:
                found.setdefault(names, set())
                walk(child, names)

    for document in documents:
        walk(ElementTree.fromstring(document), ())
    return found


def values_of(name, settings):
    """Values of all settings whose path ends in a name; None where there is no such path."""
    parts = tuple(" ".join(part.split()) for part in name.split(">"))
    ends = [values for path, values in settings.items() if path[-len(parts):] == parts]
    return set().union(*ends) if ends else None


def is_value(number, values):
    for value in values:
        try:
            if abs(float(value) - number) <= 1e-12 * abs(number):
                return True
        except ValueError:
            continue
    return False


def problems_of_names(path, text, settings):
    problems = []
    for match in re.finditer(NAME, text):
        around = text[max(0, match.start() - 100):match.end() + 100]
        if values_of(match.group(1), settings) is None and RESULTS not in around:
            name = " ".join(match.group(1).split())
            problems.append(f"{path}: no setting is called `{name}`.")
    given = [(m.group(1), m.group(m.lastindex)) for m in BEFORE.finditer(text)]
    given += [(m.group(2), m.group(1)) for m in BEHIND.finditer(text)]
    for number, name in given:
        values = values_of(name, settings)
        if values and not is_value(value_of(number), values):
            problems.append(f"{path}: gives {number} for `{name}`, which is {' or '.join(sorted(values))}.")
    return problems


def main():
    printed = [subprocess.run([sys.argv[1], f"--print-{kind}"], capture_output=True, text=True, check=True).stdout
               for kind in ("parameters", "internals")]
    settings = settings_of(*printed)
    problems = []
    for path in house.code_files(".md"):
        problems += problems_of_names(path, house.read(path), settings)
    house.finish("Settings named in Markdown exist and have the values given", problems)


if __name__ == "__main__":
    main()

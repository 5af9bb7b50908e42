"""Files stay short enough to hold one idea, lines short enough to be read side by side, and functions short and plain
enough to be read at once."""

import re

import house

LARGEST_FILE = 400  # lines; a file that grows past it holds two ideas
LARGEST_README = 120  # lines, for the README of a folder of src/
LONGEST_LINE = 120  # columns, as in .clang-format
LONGEST_FUNCTION = 60  # lines
MOST_BRANCHES = 15  # in a function


def problems_of(path, text):
    lines = text.splitlines()
    problems = []
    largest = LARGEST_README if path.name == "README.md" else LARGEST_FILE
    if len(lines) > largest:
        problems.append(f"{path}: {len(lines)} lines, at most {largest}.")
    if path.suffix in (".cpp", ".hpp"):
        problems += [f"{path}:{number}: {len(line)} columns, at most {LONGEST_LINE}."
                     for number, line in enumerate(lines, 1) if len(line) > LONGEST_LINE]
    return problems


def functions_of(text):
    """The first line of each function defined outside of classes, in the format of the house, with its lines."""
    lines = text.splitlines()
    number = 0
    while number < len(lines):
        start = number
        if not re.match(r"[A-Za-z]", lines[start]) or re.match(r"namespace|using|class|struct|enum", lines[start]):
            number += 1
            continue
        while number < len(lines) - 1 and not lines[number].rstrip().endswith(("{", ";", "}")):
            number += 1
        signature = " ".join(lines[start:number + 1])
        end = number
        if lines[number].rstrip().endswith("{") and "(" in signature:
            while end < len(lines) - 1 and not lines[end].startswith("}"):
                end += 1
            yield start + 1, signature, lines[start:end + 1]
        number = end + 1


def name_of(signature):
    found = re.search(r"([\w:<>~]+)\(", signature)
    return found.group(1).replace("<dim>", "") if found else signature


def branches_of(lines):
    code = "\n".join(line.split("//")[0] for line in lines)
    code = re.sub(r"VOUSSOIR_[A-Z]+\(.*?\);", "", code, flags=re.DOTALL)  # a contract is no way through the function
    return len(re.findall(r"\b(?:if|for|while|case)\b|\?|&&|\|\|", code))


def problems_of_functions(path, text):
    problems = []
    for number, signature, lines in functions_of(text):
        branches = branches_of(lines)
        if len(lines) > LONGEST_FUNCTION or branches > MOST_BRANCHES:
            problems.append(f"{path}:{number}: {name_of(signature)} has {len(lines)} lines and {branches} branches, at "
                            f"most {LONGEST_FUNCTION} and {MOST_BRANCHES}.")
    return problems


def main():
    files = house.code_files(".cpp", ".hpp", ".py", ".sh", ".cmake", "CMakeLists.txt") + house.scripts()
    files += [path for path in house.code_files("README.md") if path.parts[0] == "src" and len(path.parts) > 2]
    problems = [problem for path in files for problem in problems_of(path, house.read(path))]
    problems += [problem for path in house.code_files(".cpp")
                 if path.parts[0] == "src"
                 for problem in problems_of_functions(path, house.read(path))]
    house.finish("Files, lines and functions are short", problems)


if __name__ == "__main__":
    main()

"""Files stay short enough to hold one idea, and lines short enough to be read side by side."""

import house

LARGEST_FILE = 400  # lines; a file that grows past it holds two ideas
LARGEST_README = 120  # lines, for the README of a folder of src/
LONGEST_LINE = 120  # columns, as in .clang-format


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


def main():
    files = house.code_files(".cpp", ".hpp", ".py", ".sh", ".cmake", "CMakeLists.txt") + house.scripts()
    files += [path for path in house.code_files("README.md") if path.parts[0] == "src" and len(path.parts) > 2]
    problems = [problem for path in files for problem in problems_of(path, house.read(path))]
    house.finish("Files and lines are short", problems)


if __name__ == "__main__":
    main()

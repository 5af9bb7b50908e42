"""The nodes of a contact point are named behind its door alone: src/joints/point_operator.hpp says what a point does.

Joints find and keep them, and the unknowns ask which of two a tie makes one; whoever else named them would have to be
changed where a point has more than one node on a side.
"""

import re

import house

NAMES = re.compile(r"\b(?:node|nodes|shares)_[ij]\b")
NO_CODE = re.compile(r"//[^\n]*|\"(?:[^\"\\\n]|\\.)*\"")
BEHIND = ("src/joints/", "src/homogenisation/merged_space.")


def problems_of(path, text):
    if str(path).startswith(BEHIND):
        return []
    code = NO_CODE.sub(lambda found: " " * len(found.group(0)), text)
    return [f"{path}:{number}: {name} names nodes of a point; ask its PointOperator (src/joints/point_operator.hpp)."
            for number, line in enumerate(code.splitlines(), 1) for name in NAMES.findall(line)]


def main():
    files = [path for path in house.code_files(".hpp", ".cpp") if path.parts[0] in ("src", "drivers")]
    house.finish("Nodes of points are named behind their door",
                 [problem for path in files for problem in problems_of(path, house.read(path))])


if __name__ == "__main__":
    main()

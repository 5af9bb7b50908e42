"""C++ of ours is formatted as .clang-format says, by the version that Debian 12 has: others break lines elsewhere.

usage: format.py [--write]
--write formats the files instead.
"""

import re
import subprocess
import sys

import house

PROGRAM = "clang-format-14"
PLACE = re.compile(r"^(.+?):(\d+):\d+: (?:error|warning): code should be clang-formatted", re.MULTILINE)


def command(files, write=False):
    options = ["-i"] if write else ["--dry-run"]
    return [PROGRAM, f"--style=file:{house.ROOT}/.clang-format", *options, *map(str, files)]


def problems_of(said):
    """One line for each file that clang-format, in what it said, would format otherwise."""
    first = {}
    for path, line in PLACE.findall(said):
        first.setdefault(path, line)
    return [f"{path}:{line}: is not formatted; tests/house/format.py --write formats it." for path, line in first.items()]


def main():
    files = [path for path in house.code_files(".hpp", ".cpp") if path.parts[0] in ("src", "drivers", "tests")]
    done = subprocess.run(command(files, sys.argv[1:] == ["--write"]), cwd=house.ROOT, capture_output=True, text=True,
                          check=False)
    problems = problems_of(done.stderr)
    if done.returncode != 0 and not problems:
        problems = [done.stderr]
    house.finish(f"{len(files)} files are formatted", problems)


if __name__ == "__main__":
    main()

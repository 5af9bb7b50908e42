"""What the tests of the house share: the files of the repository and how a test reports."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^">]+)[">]', re.MULTILINE)


def code_files(*suffixes):
    """Files of ours with one of these endings, as paths below ROOT."""
    folders = ("src", "drivers", "python", "tests", "cmake", ".ci")
    files = [path for folder in folders for path in (ROOT / folder).rglob("*") if path.is_file()]
    files += [path for path in ROOT.iterdir() if path.is_file()]
    return sorted(path.relative_to(ROOT) for path in files
                  if "__pycache__" not in path.parts and path.name.endswith(suffixes))


def scripts():
    """Files without an ending that start with #!, such as drivers/run."""
    return [path for path in code_files("") if not path.suffix and (ROOT / path).read_bytes()[:2] == b"#!"]


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def includes(text):
    """Pairs (quote, name) of the #include lines of a C++ text; quote is < or \"."""
    return INCLUDE.findall(text)


def finish(fact, problems):
    """Prints every problem and leaves; the fact is what holds when there are none."""
    for problem in problems:
        print(problem)
    print(f"{fact}: {'yes' if not problems else f'no, {len(problems)} problem(s)'}")
    sys.exit(1 if problems else 0)

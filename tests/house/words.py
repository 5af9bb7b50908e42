"""Markdown and comments say what is, and the files they name exist.

History is git's: words that tell how things once were are refused where they can hardly mean anything else. A path that
begins at a folder of the repository, or at one of src/, must lead to a file, a folder or the stem of one.
"""

import pathlib
import re

import house

HISTORY = re.compile(r"\b(prototypes?|another machine|nowadays|formerly|previously|used at first|"
                     r"when (?:this|it) was written|used to be)\b", re.IGNORECASE)
COMMENT = re.compile(r"//.*|^\s*#.*|\"\"\".*", re.MULTILINE)
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
PATH = re.compile(r"(?<![\w./<>*-])((?:\.\./)*[A-Za-z_]\w*(?:/[\w.-]+)+)")
# Web addresses, longer pieces of code, and settings of a scene, which look like paths.
NO_PATHS = re.compile(r"https?://\S+|```.*?```|\"[^\"\n]*=[^\"\n]*\"|--set \S+", re.DOTALL)
CODE = re.compile(r"`([^`\n]*)`")
TOP = ("src", "drivers", "python", "tests", "xml", "meshes", "cmake")


def problems_of_words(path, text):
    read = text if path.suffix == ".md" else "\n".join(COMMENT.findall(text))
    return [f'{path}: "{word}" tells how things were; say what is, and why.' for word in HISTORY.findall(read)]


def exists(name, folders):
    """Whether a name is a path, or the stem of one, below one of some folders."""
    for folder in folders:
        place = pathlib.Path(house.ROOT / folder / name)
        if place.exists() or (place.parent.is_dir() and any(place.parent.glob(place.name + "*"))):
            return True
    return False


def problems_of_paths(path, text):
    modules = {folder.name for folder in (house.ROOT / "src").iterdir() if folder.is_dir()}
    problems = [f"{path}: link to {name}, which does not exist." for name in LINK.findall(text)
                if "://" not in name and not exists(name, [path.parent])]
    named = CODE.sub(lambda span: " " if "=" in span.group(1) else span.group(0), NO_PATHS.sub(" ", text))
    for name in PATH.findall(named):
        known = name.split("/")[0] in modules.union(TOP)
        if known and not exists(name.rstrip("."), ["", "src", path.parent]):
            problems.append(f"{path}: names {name}, which does not exist.")
    return problems


def problems_of_scenes(listing, scenes):
    """Every scene has its line in the list of scenes."""
    return [f"xml/README.md: does not list {name}." for name in scenes if f"`{name}`" not in listing]


def main():
    problems = []
    for path in house.code_files(".md", ".hpp", ".cpp", ".py", "CMakeLists.txt", ".cmake", ".sh") + house.scripts():
        if path.name not in ("words.py", "rules_can_fail.py"):
            problems += problems_of_words(path, house.read(path))
    markdown = house.code_files(".md") + [pathlib.Path("xml/README.md"), pathlib.Path("meshes/README.md")]
    for path in markdown:
        problems += problems_of_paths(path, house.read(path))
    problems += problems_of_scenes(house.read("xml/README.md"), sorted(path.name for path in (house.ROOT / "xml").glob("*.xml")))
    house.finish("Words say what is, and name what exists", problems)


if __name__ == "__main__":
    main()

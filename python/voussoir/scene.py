"""A scene: read, changed, written. Its keys are those of the program, and so is what is said of a wrong one.

    scene = voussoir.Scene.read("xml/arch.xml")
    scene["joints/dry/friction coefficient"] = 0.5
    scene["loads/wind"] = {"type": "acceleration", "ax": 0.5}
    scene.write("arch-in-wind.xml")
"""

import copy
import pathlib
import tempfile
import xml.etree.ElementTree as tree
from xml.sax.saxutils import quoteattr

from . import parameters, program
from .running import run, validate, value_text
from .sweep_inputs import plain_path

READERS = {"double": float, "int": int, "string": str, "bool": lambda text: text.strip().lower() in ("true", "yes", "1")}


class Typed(str):
    """A value of a type that only the solvers know, such as Array(double), kept as it is written."""

    kind = "string"


def pieces(path):
    return plain_path(path).split("/") if path else []


def read_list(element):
    values = {}
    for child in element:
        if child.tag == "ParameterList":
            values[child.get("name")] = read_list(child)
        elif child.tag == "Parameter":
            values[child.get("name")] = read_value(child.get("type"), child.get("value", ""))
    return values


def at(problem, path):
    """Whether words tell of exactly this path, not of something below it."""
    return problem.startswith(path) and problem[len(path):][:1] in ("", " ", "\n") and not problem[len(path):].startswith(" > ")


def read_value(kind, text):
    if kind in READERS:
        return READERS[kind](text)
    value = Typed(text)
    value.kind = kind
    return value


def plain(value):
    """Numbers of numpy as those of Python, members in turn."""
    if isinstance(value, dict):
        return {str(key): plain(inner) for key, inner in value.items()}
    value = value.item() if hasattr(value, "item") else value
    return str(value) if isinstance(value, pathlib.PurePath) else value


class Scene:
    def __init__(self, name="scene", values=None, file=None):
        """@param file  where it was read from: drawings and records are sought from there"""
        self.name, self.file = name, pathlib.Path(file).resolve() if file else None
        self._values = {}
        for key, value in (values or {}).items():
            self[key] = value

    @classmethod
    def read(cls, path):
        """The scene in a file, as it is written there; validate() says whether the program takes it."""
        path = program.find_scene(path)
        try:
            root = tree.parse(path).getroot()
            scene = cls(path.stem, file=path)
            scene._values = read_list(root)
            return scene
        except (tree.ParseError, ValueError) as problem:
            validate(path)  # says what is wrong, better than we could
            raise program.InputError(f"{path}: scene\n  cannot be read ({problem}).") from None

    def copy(self):
        return copy.deepcopy(self)

    # Access by paths, such as "joints/dry/friction coefficient".

    def _list(self, names, make=False):
        values = self._values
        for name in names:
            if not isinstance(values.get(name), dict):
                if not make or name in values:
                    return None
                values[name] = {}
            values = values[name]
        return values

    def __contains__(self, path):
        *names, last = pieces(path)
        return last in (self._list(names) or {})

    def __getitem__(self, path):
        """The value at a path; the default of the program where the scene leaves it out."""
        *names, last = pieces(path)
        found = (self._list(names) or {}).get(last)
        if found is not None:
            return copy.deepcopy(found)
        member = parameters.find([*names, last], self._values)
        if member is None or "default" not in member:
            words = "is not in this scene" if member else "is no key of a scene"
            raise KeyError(f"{'/'.join([*names, last])} {words}")
        default = member["default"]
        return float(default) if member["type"] == "double" else default

    def __setitem__(self, path, value):
        """Changes or adds a value, or with a dictionary a list; InputError with the program's words where it is wrong."""
        before, names = copy.deepcopy(self._values), pieces(path)
        try:
            self._set(names, plain(value))
            if not self._looks_right(names, self._at(names)):
                self._ask_program(names)
        except BaseException:
            self._values = before
            raise

    def __delitem__(self, path):
        *names, last = pieces(path)
        if last not in (self._list(names) or {}):
            raise KeyError(f"{path} is not in this scene")
        del self._list(names)[last]

    def _at(self, names):
        values = self._values
        for name in names:
            values = values[name]
        return values

    def _set(self, names, value):
        *outer, last = names
        into = self._list(outer, make=True)
        if into is None:
            raise program.InputError(f"{self.label}: scene > {' > '.join(names)}\n  lies below a single value.\n"
                                     "  A path goes from list to list to a key.")
        if isinstance(value, dict):
            into[last] = {}
            for key, inner in value.items():
                self._set([*names, key], inner)
            return
        member = parameters.find(names, self._values)
        number = isinstance(value, int) and not isinstance(value, bool)
        into[last] = float(value) if number and member and member.get("type") in ("double", "numbers") else value

    def _looks_right(self, names, value):
        member = parameters.find(names, self._values)
        if isinstance(value, dict):
            return member is not None and all(self._looks_right([*names, key], inner) for key, inner in value.items())
        return member is not None and "key" in member and parameters.admits(member, value)

    def _ask_program(self, names):
        """Lets the program say what is wrong on the way to a path or below it; silent where it finds nothing there."""
        ways = ["scene > " + " > ".join(names[:length]) for length in range(1, len(names) + 1)]
        try:
            self.validate()
        except program.InputError as refused:
            problems, start = [], f"{self.label}: "
            for line in str(refused).splitlines():
                if line.startswith(start) or not problems:
                    problems.append(line)
                else:
                    problems[-1] += "\n" + line
            here = [problem for problem in problems if any(at(problem.removeprefix(start), way) for way in ways)
                    or problem.removeprefix(start).startswith(ways[-1] + " > ")]
            if here:
                raise program.InputError("\n".join(here)) from None

    @property
    def label(self):
        """How messages call it."""
        return str(self.file) if self.file else f"{self.name}.xml"

    def keys(self, path=""):
        """Names that may stand in a list, for the choices that the scene has made; of a family those of its members."""
        names = pieces(path)
        member = parameters.find(names, self._values) if names else {"section": "", "members": parameters.members()}
        if member is None or "key" in member:
            raise KeyError(f"{path} is no list of a scene")
        holds = self._list(names) or {}
        if "family" in member:
            return list(holds)
        return list(dict.fromkeys(parameters.name_of(inner) for inner in member["members"]
                                  if parameters.present(inner, member["members"], holds)))

    def describe(self, path):
        """What a key means: unit, range, default, text, as xml/reference.xml has them."""
        member = parameters.find(pieces(path), self._values)
        if member is None:
            raise KeyError(f"{path} is no key of a scene")
        return parameters.in_words(member)

    def unit(self, path):
        """Of a number of the scene, "" where it has none."""
        unit = (parameters.find(pieces(path), self._values) or {}).get("unit", "")
        return "" if unit == "-" else unit

    # What becomes of it.

    def text(self, beside=None):
        """As XML. Files are named from the folder `beside`, absolutely where it is not that of the scene."""
        moved = self.file is not None and (beside is None or pathlib.Path(beside).resolve() != self.file.parent)
        lines = [f"<ParameterList name={quoteattr(self.name)}>", *self._lines(self._values, 1, moved), "</ParameterList>"]
        return "\n".join(lines) + "\n"

    def _lines(self, values, depth, moved):
        margin = "  " * depth
        for name, value in values.items():
            if isinstance(value, dict):
                yield f"{margin}<ParameterList name={quoteattr(name)}>"
                yield from self._lines(value, depth + 1, moved)
                yield f"{margin}</ParameterList>"
                continue
            if isinstance(value, Typed):
                kind = value.kind
            else:
                kind = {bool: "bool", int: "int", float: "double"}.get(type(value), "string")
                if moved and kind == "string" and (name == "file" or "record" in name):
                    value = self._absolute(value)
            yield f"{margin}<Parameter name={quoteattr(name)} type={quoteattr(kind)} value={quoteattr(value_text(value))}/>"

    def _absolute(self, name):
        """A file that the scene names, sought as the program seeks it."""
        home = self.file.parent
        places = [place / name for place in (home, home.parent, home.parent / "meshes") if name]
        return next((str(place.resolve()) for place in places if place.exists()), name)

    def write(self, path):
        path = pathlib.Path(path)
        program.write_atomically(path, self.text(path.parent))
        return path

    def validate(self):
        """What the program understood; InputError with its words where it refuses the scene."""
        with tempfile.TemporaryDirectory() as place:
            path = self.write(pathlib.Path(place) / f"{self.name}.xml")
            try:
                return program.answer(f"--xml={path}", "--validate").replace(str(path), self.label)
            except program.InputError as refused:
                raise program.InputError(str(refused).replace(str(path), self.label)) from None

    def run(self, **options):
        """As voussoir.run(scene, ...)."""
        return run(self, **options)

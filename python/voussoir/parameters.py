"""What a scene can hold, from the declarations of the program itself (`voussoir --print-parameters=json`)."""

import functools
import json
import math

from . import program


def members():
    """Declarations of the keys, sections and families of a scene; src/scene/json_printer.hpp says how they look."""
    return _members(str(program.find_program()), program.find_program().stat().st_mtime_ns)


@functools.lru_cache(maxsize=4)
def _members(*_):
    return json.loads(program.answer("--print-parameters=json"))["members"]


def name_of(member):
    return member.get("key") or member.get("section") or member.get("family")


def present(member, declared, values):
    """Whether a member exists for the choices that the values of its list have made, or that the program makes for them."""
    if "with" not in member:
        return True
    key, _, word = member["with"].partition(" = ")
    choice = values.get(key) or next((other.get("default") for other in declared if other.get("key") == key), None)
    return choice is None or choice == word


def among(declared, name, values):
    """The member of this name, None where there is none or where it belongs to another choice."""
    return next((member for member in declared if name_of(member) == name and present(member, declared, values)), None)


def list_in(values, name):
    """The list of this name among values, empty where there is none."""
    found = values.get(name)
    return found if isinstance(found, dict) else {}


def find(path, tree):
    """The declaration that a path of names leads to in a scene, whose values decide what exists.

    A member of a family is a section; a name in a sublist of numbers, or of a list passed on, has the declaration of what
    holds it. None where the path leads nowhere."""
    declared, values, member = members(), tree, None
    names = list(path)
    while names:
        name = names.pop(0)
        member = among(declared, name, values)
        if member is None:
            return None
        values = list_in(values, name)
        if "key" in member:
            deep = {"numbers": 1, "list": math.inf}.get(member["type"], 0)
            return member if len(names) <= deep else None
        declared = member["members"]
        if "family" in member and names:
            name = names.pop(0)
            values = list_in(values, name)
            member = {"section": name, "text": member["text"], "members": declared}
    return member


class Range:
    """The numbers that a range in words admits: ">= 0", "> -1 and < 0.5", ">= 2 and even", "finite or inf"."""

    def __init__(self, text):
        self.text = text
        self.infinite = text.endswith(" or inf")
        self.ends = [piece for piece in text.removesuffix(" or inf").split(" and ") if piece != "finite"]

    def __contains__(self, number):
        if math.isnan(number):
            return False
        if math.isinf(number):
            return self.infinite and number > 0
        return all(self.holds(end, number) for end in self.ends)

    @staticmethod
    def holds(end, number):
        if end == "even":
            return number % 2 == 0
        sign, _, bound = end.partition(" ")
        bound = float(bound)
        return {">=": number >= bound, ">": number > bound, "<=": number <= bound, "<": number < bound}[sign]


def admits(member, value):
    """Whether a declared key may have a value, as far as its own declaration tells."""
    kind = member["type"]
    if kind in ("numbers", "list"):
        kind = "double" if kind == "numbers" else None
    if kind is None:
        return True
    if isinstance(value, bool) or kind == "bool":
        return isinstance(value, bool) and kind == "bool"
    if kind == "string":
        return isinstance(value, str) and value in member.get("words", [value]) and (value != "" or not member.get("required"))
    if not isinstance(value, (int, float)) or (kind == "int" and not isinstance(value, int)):
        return False
    return value in Range(member["range"])


def in_words(member):
    """The documentation of a declaration, as xml/reference.xml has it."""
    if "key" not in member:
        return member["text"]
    unit = f"[{member['unit']}] " if "unit" in member else ""
    known = unit + member.get("range", "") + (f", usually {member['usually']}" if "usually" in member else "")
    known += " | ".join(member.get("words", []))
    default = "required" if member.get("required") else f"default {member['default']}" if "default" in member else ""
    return ": ".join(piece for piece in (", ".join(piece for piece in (known, default) if piece), member["text"]) if piece)

"""Scenes of the proving ground: nested dictionaries that become the XML of a scene."""

import copy
import xml.etree.ElementTree as ElementTree

from drawing import Drawing

GRAVITY = 9.81
STONE = {"Young modulus": 1e10, "Poisson ratio": 0.2, "density": 2000.0}
WEIGHT = {"type": "self weight"}
OWN_WEIGHT = {"own weight": {"loads": {"weight": 1.0}}}


def scene(mesh, *, friction=0.6, supports=("ground",), loads=None, stages=None, stone=None, **sections):
    """A scene of one stone and one friction coefficient; supports are sets of facets, or a dictionary of sections.

    mesh is a Drawing or the section of a generator; sections go into the scene as they are.
    """
    if not isinstance(supports, dict):
        supports = {name: {"on": name} for name in supports}
    return {
        "mesh": mesh,
        "materials": {"stone": {**STONE, **(stone or {})}},
        "joints": {"dry": {"friction coefficient": friction}},
        "supports": supports,
        "loads": {"weight": WEIGHT, **(loads or {})},
        "steps": {"expect collapse": True, "stages": stages or OWN_WEIGHT},
        "output": {"report": False},
        **{name.replace("_", " "): value for name, value in sections.items()},
    }


def changed(base, changes):
    """A copy of a scene in which values at paths such as materials/stone/density are others."""
    result = copy.deepcopy(base)
    for path, value in changes.items():
        *parents, last = path.split("/")
        section = result
        for name in parents:
            section = section.setdefault(name, {})
        section[last] = value
    return result


def wall(courses, **numbers):
    return {"type": "wall", "wall": {"courses": courses, "blocks per course": courses, **spaced(numbers)}}


def arch(voussoirs, **numbers):
    return {"type": "arch", "arch": {"voussoirs": voussoirs, **spaced(numbers)}}


def spaced(numbers):
    return {name.replace("_", " "): value for name, value in numbers.items()}


def pushed(mesh, ax=0.15 * GRAVITY, **more):
    """A structure under its weight, then under the same and an acceleration to the right."""
    return scene(mesh, loads={"push": {"type": "acceleration", "ax": ax}},
                 stages={"own weight": {"loads": {"weight": 1.0}}, "push": {"loads": {"push": 1.0}}}, **more)


def pushed_wall(courses, **more):
    return pushed(wall(courses), supports=("base",), **more)


def wall_weight(courses, density=2000.0):
    """Of wall(courses) as the generator makes it by default [N]."""
    return courses * courses * 0.5 * 0.25 * density * GRAVITY


def arch_weight(voussoirs, cells=2, density=2000.0, radius=5.0, thickness=1.0):
    """Of half a ring of voussoirs whose sides are chords between the nodes [N]."""
    import math
    pieces = voussoirs * cells
    area = pieces * 0.5 * math.sin(math.pi / pieces) * ((radius + thickness / 2)**2 - (radius - thickness / 2)**2)
    return area * density * GRAVITY


def write(content, folder):
    """Writes a scene and its drawing into a folder; the path of the scene."""
    content = dict(content)
    if isinstance(content["mesh"], Drawing):
        content["mesh"] = content["mesh"].section(folder)
    root = ElementTree.Element("ParameterList", name=folder.name)
    fill(root, content)
    ElementTree.indent(root)
    path = folder / "scene.xml"
    ElementTree.ElementTree(root).write(path)
    return path


TYPES = {bool: "bool", int: "int", float: "double", str: "string"}


def fill(element, content):
    for name, value in content.items():
        if isinstance(value, dict):
            fill(ElementTree.SubElement(element, "ParameterList", name=name), value)
            continue
        text = str(value).lower() if isinstance(value, bool) else repr(value) if isinstance(value, float) else str(value)
        ElementTree.SubElement(element, "Parameter", name=name, type=TYPES[type(value)], value=text)

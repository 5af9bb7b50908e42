"""Small structures of rectangular stones, drawn and posed from a few words, for tests of the whole program.

    geo(stones, size, supports)   the text of a .geo file in which neighbours share the curve between them
    scene(...)                    the text of a scene
"""

import html


def polygon(points):
    return [tuple(map(float, p)) for p in points]


def rectangle(x0, y0, x1, y1):
    return polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def on_segment(p, a, b):
    cross = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    along = (b[0] - a[0]) * (p[0] - a[0]) + (b[1] - a[1]) * (p[1] - a[1])
    square = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2
    return abs(cross) <= 1e-9 * square and 1e-9 * square < along < (1 - 1e-9) * square


def geo(stones, size, edges):
    """stones: {name: corners counter-clockwise}; edges: {name of a set: (stone, side) counted from its first corner}."""
    corners = [p for outline in stones.values() for p in outline]
    number, lines, text = {}, {}, []
    for p in corners:
        if p not in number:
            number[p] = len(number) + 1
            text.append(f"Point({number[p]}) = {{{p[0]!r}, {p[1]!r}, 0}};")
    sides = {}
    for surface, (name, outline) in enumerate(stones.items(), start=1):
        loop = []
        for side, a in enumerate(outline):
            b = outline[(side + 1) % len(outline)]
            between = {p for p in corners if on_segment(p, a, b)}
            chain = [a, *sorted(between, key=lambda p, a=a: (p[0] - a[0]) ** 2 + (p[1] - a[1]) ** 2), b]
            for p, q in zip(chain, chain[1:]):
                key = tuple(sorted((number[p], number[q])))
                if key not in lines:
                    lines[key] = len(lines) + 1
                    length = ((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2) ** 0.5
                    text.append(f"Line({lines[key]}) = {{{key[0]}, {key[1]}}};")
                    text.append(f"Transfinite Curve{{{lines[key]}}} = {max(1, round(length / size)) + 1};")
                loop.append(lines[key] if number[p] == key[0] else -lines[key])
                sides.setdefault((name, side), []).append(lines[key])
        text.append(f"Curve Loop({surface}) = {{{', '.join(map(str, loop))}}};")
        text.append(f"Plane Surface({surface}) = {{{surface}}};")
        text.append(f'Physical Surface("{name}") = {{{surface}}};')
    for name, where in edges.items():
        text.append(f'Physical Curve("{name}") = {{{", ".join(map(str, sides[where]))}}};')
    return "\n".join(text) + "\n"


def xml(name, value):
    if isinstance(value, dict):
        inside = "\n".join(xml(k, v) for k, v in value.items())
        return f'<ParameterList name="{html.escape(name)}">\n{inside}\n</ParameterList>'
    kind = {bool: "bool", int: "int", float: "double", str: "string"}[type(value)]
    text = str(value).lower() if kind == "bool" else html.escape(str(value))
    return f'<Parameter name="{html.escape(name)}" type="{kind}" value="{text}"/>'


def scene(file, supports, loads, stages, friction=0.6, joints=None, **sections):
    """file: of gmsh, or the section of another mesh; supports: names of sets of edges, or sections by name; loads and stages as in a scene, own weight named `weight` included."""
    tree = {
        "mesh": file if isinstance(file, dict) else {"type": "gmsh", "gmsh": {"file": file}},
        "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000.0}},
        "joints": {"dry": {"friction coefficient": friction}, **(joints or {})},
        "supports": supports if isinstance(supports, dict) else {name: {"on": name} for name in supports},
        "loads": {"weight": {"type": "self weight"}, **loads},
        "steps": {"stages": stages},
    }
    for name, section in sections.items():
        tree.setdefault(name.replace("_", " "), {}).update(section)
    return xml("stones", tree) + "\n"


OWN_WEIGHT = {"loads": {"weight": 1.0}}

"""Drawings of stones in the plane as files of each kind, for tests of the whole program.

    stones = bond(courses, count, length, height)      {name: corners}, counter-clockwise
    csv(stones), dxf(stones), svg(stones), geojson(stones)
"""

import json
import random


def box(x, y, length, height):
    return [(x, y), (x + length, y), (x + length, y + height), (x, y + height)]


def bond(courses, count, length, height, error=0.0, seed=0):
    """Running bond, blocks numbered as those of the generator; corners are moved by one to five fifths of `error`."""
    chance = random.Random(seed)
    stones = {}
    for course in range(courses):
        ends = [k * length for k in range(count + 1)] if course % 2 == 0 else \
            [0.0, *((k + 0.5) * length for k in range(count)), count * length]
        for k, (a, b) in enumerate(zip(ends, ends[1:])):
            corners = box(a, course * height, b - a, height)
            stones[f"{course}-{k}"] = [survey(p, error, chance) for p in corners]
    return stones


def survey(p, error, chance):
    if error == 0:
        return p
    return tuple(c + chance.choice((-1, 1)) * error * chance.uniform(0.2, 1.0) for c in p)


def csv(stones, sets=None, scale=1.0, up=1):
    rows = ["stone,x,y,set"]
    for name, corners in stones.items():
        rows += [f"{name},{scale * x!r},{up * scale * y!r},{(sets or {}).get(name, '')}" for x, y in corners]
    return "\n".join(rows) + "\n"


def dxf(stones, sets=None, scale=1.0, up=1, closed=True):
    text = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n0\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
    for name, corners in stones.items():
        text += f"0\nLWPOLYLINE\n5\nA1\n100\nAcDbEntity\n8\n{(sets or {}).get(name, '0')}\n100\nAcDbPolyline\n90\n{len(corners)}\n"
        text += f"70\n{1 if closed else 0}\n"
        text += "".join(f"10\n{scale * x!r}\n20\n{up * scale * y!r}\n" for x, y in corners)
    return text + "0\nENDSEC\n0\nEOF\n"


def dxf_of_blocks(blocks, inserts):
    """Blocks of CAD {name: (base, entities)} and what is inserted: groups of codes and values, such as insert()."""
    pairs = lambda *groups: "".join(f"{code}\n{value}\n" for code, value in groups)
    text = pairs((0, "SECTION"), (2, "BLOCKS"))
    for name, (base, entities) in blocks.items():
        text += pairs((0, "BLOCK"), (8, 0), (2, name), (70, 0), (10, base[0]), (20, base[1])) + "".join(pairs(*e) for e in entities)
        text += pairs((0, "ENDBLK"))
    text += pairs((0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")) + "".join(pairs(*e) for e in inserts)
    return text + pairs((0, "ENDSEC"), (0, "EOF"))


def outline(corners, layer="0"):
    """A closed polyline as groups."""
    return [(0, "LWPOLYLINE"), (8, layer), (90, len(corners)), (70, 1), *(group for x, y in corners for group in ((10, x), (20, y)))]


def insert(name, x, y, layer="0", **codes):
    """An INSERT as groups; further codes as c41=0.5."""
    return [(0, "INSERT"), (8, layer), (2, name), (10, x), (20, y), *((int(key[1:]), value) for key, value in codes.items())]


def svg(stones, sets=None, scale=1.0):
    """As drawn on a page: y runs down, half of the stones within a group that is moved."""
    text = ['<?xml version="1.0"?>', '<svg xmlns="http://www.w3.org/2000/svg" width="100mm">']
    for k, (name, corners) in enumerate(stones.items()):
        kind = f' class="{sets[name]}"' if sets and name in sets else ""
        points = [(scale * x, -scale * y) for x, y in corners]
        if k % 2:
            text.append(f'<polygon id="{name}"{kind} points="{" ".join(f"{x!r},{y!r}" for x, y in points)}"/>')
        else:
            path = "M" + " L".join(f"{x - 4!r} {y - 8!r}" for x, y in points) + " Z"
            text.append(f'<g transform="translate(4, 8)"><path id="{name}"{kind} d="{path}"/></g>')
    return "\n".join([*text, "</svg>"]) + "\n"


def geojson(stones, sets=None, scale=1.0):
    features = [{"type": "Feature", "properties": {"name": name, **({"set": sets[name]} if sets and name in sets else {})},
                 "geometry": {"type": "Polygon", "coordinates": [[[scale * x, scale * y] for x, y in [*corners, corners[0]]]]}}
                for name, corners in stones.items()]
    return json.dumps({"type": "FeatureCollection", "features": features})

"""Writes gateway.svg: a gateway of ashlar with a round arch, as a drawing of stones in centimetres.

usage: gateway.py FILE

Two piers of four courses carry a half circle of nine voussoirs, spandrels between arch and coping, and the coping. Every
stone is one path; its class is the set it belongs to. Extrados and spandrels are drawn with the same arcs.
"""

import math
import sys

INNER, OUTER = 120.0, 165.0   # [cm] radii of the arch
SPRINGING = 200.0             # [cm] height of its centre
HALF, TOP, COPING = 210.0, 375.0, 20.0  # [cm] half the width; height of the spandrels; depth of the coping
VOUSSOIRS, COURSE = 9, 50.0


def on(radius, degrees):
    return radius * math.cos(math.radians(degrees)), SPRINGING + radius * math.sin(math.radians(degrees))


def xy(p):
    return f"{p[0]:.4f},{-p[1]:.4f}"


def arc(radius, p, clockwise):
    """On the page, where y runs down."""
    return f"A{radius:g},{radius:g} 0 0 {1 if clockwise else 0} {xy(p)}"


def lines(*points):
    return "M" + " L".join(map(xy, points)) + " Z"


def piers():
    for side, sign in (("left", -1), ("right", 1)):
        for course in range(4):
            y = COURSE * course
            cuts = [INNER, HALF] if course % 2 else [INNER, INNER + (35 if course % 4 else 55), HALF]
            for k, (a, b) in enumerate(zip(cuts, cuts[1:])):
                yield f"{side} {course + 1}{'ab'[k] if len(cuts) > 2 else ''}", "pier", lines(
                    (sign * a, y), (sign * b, y), (sign * b, y + COURSE), (sign * a, y + COURSE))


def ring():
    step = 180 / VOUSSOIRS
    for k in range(VOUSSOIRS):
        a, b = k * step, (k + 1) * step
        yield f"voussoir {k + 1}", "ring", (f"M{xy(on(OUTER, a))} {arc(OUTER, on(OUTER, b), False)} L{xy(on(INNER, b))} "
                                           f"{arc(INNER, on(INNER, a), True)} Z")


def spandrels():
    for side, sign in (("left", -1), ("right", 1)):
        for k, (a, b) in enumerate(((0, 20), (20, 40), (40, 60), (60, 90))):
            (x0, y0), (x1, y1) = on(OUTER, a), on(OUTER, b)
            above = [(HALF, y1)] if b < 90 else [(HALF, TOP), (0.0, TOP)]
            way = [(x0, y0), (HALF, y0), *above, (x1, y1)]
            outline = "M" + " L".join(xy((sign * x, y)) for x, y in way)
            steps = [b - 20 * n for n in range(1, (b - a) // 20 + 1)] if b < 90 else [80, 60]
            back = " ".join(arc(OUTER, (sign * on(OUTER, t)[0], on(OUTER, t)[1]), sign > 0) for t in steps)
            yield f"spandrel {side} {k + 1}", "spandrel", f"{outline} {back} Z"


def coping():
    for k in range(5):
        a, b = -HALF + 84 * k, -HALF + 84 * (k + 1)
        yield f"coping {k + 1}", "coping", lines((a, TOP), (b, TOP), (b, TOP + COPING), (a, TOP + COPING))


def main():
    colours = {"pier": "#d9d0bd", "ring": "#c4b596", "spandrel": "#eae4d6", "coping": "#b8ab90"}
    text = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{-HALF - 10:g} {-TOP - COPING - 10:g} {2 * HALF + 20:g} '
            f'{TOP + COPING + 20:g}" width="660" height="630" stroke="black" stroke-width="0.7">']
    for name, kind, path in (*piers(), *ring(), *spandrels(), *coping()):
        text.append(f'<path id="{name}" class="{kind}" fill="{colours[kind]}" d="{path}"/>')
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write("\n".join([*text, "</svg>"]) + "\n")


if __name__ == "__main__":
    main()

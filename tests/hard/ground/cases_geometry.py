"""Corners, fans, slivers, slender stones, short joints beside long ones, far away and in other sizes."""

import math

from case import INPUT_ERROR, Near, case
from drawing import Drawing, grid
from scenes import GRAVITY, pushed, scene

GROUP = "geometry"
DENSITY = 2000.0


def weighed(area):
    return lambda run: [Near("weight carried", run.reaction(), area * DENSITY * GRAVITY, 1e-8)]


case(GROUP, "stack bond, four stones at a corner", lambda: pushed(grid(4, 4, 0.5, 0.25, 0.125), 0.05 * GRAVITY),
     quick=True, check=weighed(2.0))


def tee():
    """One stone on the joint of two others."""
    drawing = Drawing(0.125, cells="triangle")
    drawing.box(0.0, 0.0, 0.5, 0.25, bottom="ground")
    drawing.box(0.5, 0.0, 0.5, 0.25, bottom="ground")
    drawing.stone([(0.2, 0.25), (0.5, 0.25), (0.8, 0.25), (0.8, 0.5), (0.2, 0.5)])
    return drawing


def tee_with_points():
    """The same with the ends of the upper stone as points of the lower ones."""
    drawing = Drawing(0.125, cells="triangle")
    drawing.stone([(0.0, 0.0), (0.5, 0.0), (0.5, 0.25), (0.25, 0.25), (0.0, 0.25)])
    drawing.stone([(0.5, 0.0), (1.0, 0.0), (1.0, 0.25), (0.75, 0.25), (0.5, 0.25)])
    drawing.stone([(0.25, 0.25), (0.5, 0.25), (0.75, 0.25), (0.75, 0.5), (0.25, 0.5)])
    drawing.name("ground", (0.0, 0.0), (0.5, 0.0))
    drawing.name("ground", (0.5, 0.0), (1.0, 0.0))
    return drawing


case(GROUP, "three stones at a T", lambda: pushed(tee_with_points()), quick=True, check=weighed(0.375))
case(GROUP, "three stones at a T, drawn without its points", lambda: pushed(tee()), INPUT_ERROR, words="touch without matching nodes",
     quick=True)


def unequal_divisions():
    """A stone whose opposite sides have 4 and 5 cells, which gmsh refuses to divide regularly."""
    drawing = Drawing(0.25)
    for k in range(2):
        drawing.box(0.0, 0.5 * k, 1.0, 0.5)
        drawing.divide((0.0, 0.5 * k), (1.0, 0.5 * k), 4 + k)
    drawing.name("ground", (0.0, 0.0), (1.0, 0.0))
    return drawing


case(GROUP, "a drawing gmsh cannot mesh", lambda: scene(unequal_divisions()), INPUT_ERROR, words="gmsh could not mesh",
     quick=True)


def fan(wedges, angle, radius=1.0):
    """Wedges that meet in one node, from the right round to the left; the first and the last stand on the ground."""
    drawing = Drawing(radius / 4, cells="triangle")
    step = angle / wedges
    rim = [(radius * math.cos(k * step), radius * math.sin(k * step)) for k in range(wedges + 1)]
    if angle == 2 * math.pi:
        rim[-1] = rim[0]
    for a, b in zip(rim, rim[1:]):
        drawing.stone([(0.0, 0.0), a, b])
    return drawing, rim


def half_fan():
    drawing, rim = fan(12, math.pi)
    drawing.name("ground", (0.0, 0.0), rim[0])
    drawing.name("ground", rim[-1], (0.0, 0.0))
    return drawing


def rose():
    drawing, rim = fan(12, 2 * math.pi)
    for a, b in zip(rim, rim[1:]):
        drawing.name("ground", a, b)
    return drawing


def area_of_fan(angle):
    return 12 * 0.5 * math.sin(angle / 12)


case(GROUP, "12 wedges at one node, half a disc on the ground", lambda: pushed(half_fan(), 0.05 * GRAVITY), quick=True,
     check=weighed(area_of_fan(math.pi)))
case(GROUP, "12 wedges at one node, rim held", lambda: scene(rose()), check=weighed(area_of_fan(2 * math.pi)))


def sliver(degrees):
    """A stone cut by a slope of some degrees, its lower part a wedge; coarse along, so that its corner is one cell."""
    drawing = Drawing(0.5, cells="triangle")
    rise = math.tan(math.radians(degrees))
    drawing.box(0.0, -0.5, 1.0, 0.5, bottom="ground")
    drawing.stone([(0.0, 0.0), (1.0, 0.0), (1.0, rise)])
    drawing.stone([(0.0, 0.0), (1.0, rise), (1.0, 0.5), (0.0, 0.5)])
    for a, b in (((0.0, 0.0), (1.0, 0.0)), ((0.0, 0.0), (1.0, rise))):
        drawing.divide(a, b, 1)
    for a, b in (((0.0, -0.5), (1.0, -0.5)), ((1.0, 0.5), (0.0, 0.5))):
        drawing.divide(a, b, 1)
    return drawing


case(GROUP, "sliver of 1.01 degrees", lambda: scene(sliver(1.01)), quick=True, check=weighed(1.0))
case(GROUP, "sliver of 0.9 degrees", lambda: scene(sliver(0.9)), INPUT_ERROR, words="degree", quick=True)


def slabs(cells):
    drawing = Drawing(1.0)
    height = 0.01
    for k in range(4):
        x, y, top = 0.0, k * height, (k + 1) * height
        drawing.stone([(x, y), (10.0, y), (10.0, top), (x, top)])
        drawing.divide((x, y), (10.0, y), cells)
        drawing.divide((10.0, top), (x, top), cells)
    drawing.name("ground", (0.0, 0.0), (10.0, 0.0))
    return drawing


case(GROUP, "slabs of 10 m by 10 mm, cells of 1000 : 1", lambda: pushed(slabs(1), 0.05 * GRAVITY), check=weighed(0.4))
case(GROUP, "slabs of 10 m by 10 mm, cells of 10 : 1", lambda: pushed(slabs(100), 0.05 * GRAVITY), quick=True,
     check=weighed(0.4))


def columns_of_sheets():
    """Stones 1 m high and 1 mm wide, side by side: they stand, leaning on nothing."""
    drawing = Drawing(0.25)
    for k in range(4):
        a, b = k * 0.001, (k + 1) * 0.001
        drawing.stone([(a, 0.0), (b, 0.0), (b, 1.0), (a, 1.0)])
        drawing.name("ground", (a, 0.0), (b, 0.0))
    return drawing


case(GROUP, "sheets of 1 mm by 1 m, upright", lambda: scene(columns_of_sheets()), check=weighed(0.004))


def short_beside_long():
    """A chip of 1 mm between two columns of 5 m, two courses: beds of 1 mm beside beds of 5 m."""
    drawing = Drawing(0.5)
    across = [0.0, 5.0, 5.001, 10.001]
    for row in range(2):
        low, high = 0.25 * row, 0.25 * (row + 1)
        for left, right in zip(across, across[1:]):
            drawing.stone([(left, low), (right, low), (right, high), (left, high)])
            for side in (left, right):
                drawing.divide((side, low), (side, high), 2)
            if row == 0:
                drawing.name("ground", (left, low), (right, low))
    return drawing


case(GROUP, "beds of 1 mm beside beds of 5 m", lambda: pushed(short_beside_long(), 0.05 * GRAVITY), quick=True,
     check=weighed(10.001 * 0.5))


def small_wall(**how):
    return pushed(grid(3, 3, 0.5, 0.25, 0.125, **how), 0.05 * GRAVITY)


def same_as_at_the_origin(run):
    base = run.again(small_wall())
    # Corners 1e7 m away are rounded to 2e-9 m, 1e-8 of a cell.
    yield Near("largest displacement", run.result["largest_displacement_m"], base.result["largest_displacement_m"], 1e-6)
    yield Near("weight carried", run.reaction(), 9 * 0.125 * DENSITY * GRAVITY, 1e-6)


case(GROUP, "coordinates around 1e7 m", lambda: small_wall(offset=(1e7, -1e7)), quick=True, check=same_as_at_the_origin)
case(GROUP, "coordinates around 1e4 m", lambda: small_wall(offset=(1e4, -1e4)), check=same_as_at_the_origin)


def scaled(scale):
    def check(run):
        base = run.again(small_wall())
        yield Near("displacement over scale squared", run.result["largest_displacement_m"] / scale**2,
                   base.result["largest_displacement_m"], 1e-6)
        yield Near("linear solves", run.result["linear_solves"], base.result["linear_solves"], 0.25)
    return check


for scale, words in ((1e-3, "stones of 0.5 mm"), (1e3, "stones of 500 m"), (1e-6, "stones of 0.5 micrometres")):
    case(GROUP, words, lambda scale=scale: small_wall(scale=scale), quick=scale != 1e3, check=scaled(scale))

"""Units, numbers at the ends of what a computer holds, and structures as small or as tall as can be."""

from case import INPUT_ERROR, Near, case
from drawing import Drawing, grid
from scenes import GRAVITY, changed, pushed, scene

GROUP = "numbers"


def wall_in(length, force):
    """The same wall with lengths in units of `length` m and forces in units of `force` N; seconds stay."""
    mass = force / length  # the unit of mass in which force = mass x acceleration holds
    return changed(pushed(grid(3, 3, 0.5, 0.25, 0.125, scale=1 / length), 0.05 * GRAVITY / length), {
        "materials/stone/Young modulus": 1e10 / (force / length**2),
        "materials/stone/density": 2000 / (mass / length**3),
        "model/thickness": 1 / length,
        "loads/weight": {"type": "self weight", "gravity": GRAVITY / length},
    })


def same_in_units(length, force):
    def check(run):
        base = run.again(wall_in(1.0, 1.0))
        yield Near("displacement", run.result["largest_displacement_m"] * length, base.result["largest_displacement_m"], 1e-7)
        yield Near("weight carried", run.reaction() * force, 9 * 0.125 * 2000 * GRAVITY, 1e-8)
        yield Near("linear solves", run.result["linear_solves"], base.result["linear_solves"], 0.25)
    return check


for length, force, words, quick in ((1e-3, 1.0, "mm, N, t", True), (1.0, 1e6, "m, MN", False), (1e-6, 1e-6, "micrometre, micronewton", False),
                                    (1.0, 1e30, "forces in 1e30 N", True), (1.0, 1e-30, "forces in 1e-30 N", True),
                                    (1e9, 1.0, "lengths in 1e9 m", False)):
    case(GROUP, words, lambda length=length, force=force: wall_in(length, force), quick=quick,
         check=same_in_units(length, force))


def light(density):
    return scene(grid(2, 2, 0.5, 0.25, 0.125), stone={"density": density})


def weighs(density):
    return lambda run: [Near("weight carried", run.reaction(), 0.5 * density * GRAVITY, 1e-8)]


case(GROUP, "density 1e-120 kg/m3", lambda: light(1e-120), quick=True, check=weighs(1e-120))
case(GROUP, "density 1e120 kg/m3", lambda: changed(light(1e120), {"materials/stone/Young modulus": 1e130}), check=weighs(1e120))
case(GROUP, "density 1e-300 kg/m3", lambda: light(1e-300), INPUT_ERROR, words="no node with more than", quick=True)
case(GROUP, "density 1e-320 kg/m3, a denormal number", lambda: light(1e-320), INPUT_ERROR, words="no node with more than")
case(GROUP, "density 1e300 kg/m3", lambda: light(1e300), INPUT_ERROR, words="press a node with 1e.?130 N or more")
case(GROUP, "negative zeros",
     lambda: changed(pushed(grid(2, 2, 0.5, 0.25, 0.125), -0.0),
                     {"joints/dry/friction coefficient": -0.0, "joints/dry/cohesion": -0.0,
                      "joints/dry/initial gap": -0.0, "materials/stone/Poisson ratio": -0.0}), quick=True,
     check=lambda run: [Near("weight carried", run.reaction(), 0.5 * 2000 * GRAVITY, 1e-8)])


def unloaded(run):
    yield Near("largest displacement", run.result["largest_displacement_m"], 0.0, 0.0)
    yield Near("reaction", run.reaction(), 0.0, 0.0)


case(GROUP, "all loads zero", lambda: changed(pushed(grid(2, 2, 0.5, 0.25, 0.125), 0.0), {"loads/weight/gravity": 0.0}),
     quick=True, check=unloaded)
case(GROUP, "no loads at all", lambda: changed(scene(grid(2, 2, 0.5, 0.25, 0.125)),
                                               {"loads": {}, "steps/stages": {"nothing": {}}}), INPUT_ERROR,
     words="needs at least one load")


def one(cells):
    drawing = Drawing(1.0 / cells)
    drawing.box(0.0, 0.0, 1.0, 1.0, bottom="ground")
    return scene(drawing)


def one_cell():
    drawing = Drawing(1.0, cells="triangle")
    drawing.stone([(0.0, 0.0), (1.0, 0.0), (0.5, 1.0)])
    drawing.name("ground", (0.0, 0.0), (1.0, 0.0))
    return scene(drawing)


case(GROUP, "one stone", lambda: one(4), quick=True,
     check=lambda run: [Near("weight carried", run.reaction(), 2000 * GRAVITY, 1e-10)])
case(GROUP, "one stone of one cell", one_cell, quick=True,
     check=lambda run: [Near("weight carried", run.reaction(), 1000 * GRAVITY, 1e-10)])
case(GROUP, "Young's modulus that is no number", lambda: changed(one(1), {"materials/stone/Young modulus": float("nan")}),
     INPUT_ERROR, words="Young modulus", quick=True)
case(GROUP, "weight that is infinite", lambda: changed(one(1), {"loads/weight/gravity": float("inf")}), INPUT_ERROR,
     words="gravity", quick=True)


def column(stones):
    return scene(grid(1, stones, 1.0, 0.1, 1.0), stone={"Poisson ratio": 0.0})


def tall(stones):
    def check(run):
        height = 0.1 * stones
        yield Near("weight carried", run.reaction(), height * 2000 * GRAVITY, 1e-7)
        # Bars in a row are exact in their nodes: rho g H^2 / (2 E) at the top.
        top = -run.table("displacement")[:, 1].min()
        yield Near("shortening", top, 2000 * GRAVITY * height**2 / 2e10, 1e-6)
    return check


for stones in (100, 1000, 10_000):
    case(GROUP, f"{stones} stones in one column".replace("10000", "10 000"), lambda stones=stones: column(stones),
         quick=stones == 100, seconds=900, check=tall(stones))

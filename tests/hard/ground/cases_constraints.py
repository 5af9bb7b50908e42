"""Joints that touch, gape, overlap, wedge and let go; stones that nothing holds."""

import math

import numpy as np

from case import COLLAPSE, INPUT_ERROR, Most, Near, case
from drawing import Drawing, block_on_bed, grid
from scenes import GRAVITY, changed, scene

GROUP = "constraints"
DENSITY = 2000.0


def weighed(area):
    return lambda run: [Near("weight carried", run.reaction(), area * DENSITY * GRAVITY, 1e-8)]


def without_force(run):
    """Columns that do not widen touch their neighbours and press them with nothing."""
    normal = run.table("joints/normal")
    force = run.table("joint_normal_force_N")
    upright = abs(normal[:, 0]) > 0.5
    yield Most("force in touching joints over the largest", max(abs(force[upright])) / max(abs(force)), 1e-8)
    yield from weighed(2.0)(run)


case(GROUP, "joints that touch without force", lambda: scene(grid(4, 4, 0.5, 0.25, 0.125), stone={"Poisson ratio": 0.0}),
     quick=True, check=without_force)


def gaping(gap, stages=None):
    return changed(scene(block_on_bed(), stages=stages), {"joints/dry/initial gap": gap})


def falls_shut(gap):
    def way(run):
        return np.mean(run.table("displacement")[run.table("mesh/block_of_node") == 1, 1])

    def check(run):
        # Forces are found to 1e-8 of 2 kN, which press the stones by less than 1e-14 m.
        yield Near("way down", way(run) - way(run.again(gaping(0.0))), -gap, 1e-12 / gap + 1e-12)
        yield from weighed(0.75)(run)
    return check


case(GROUP, "initial gap of 1 micrometre closes", lambda: gaping(1e-6), quick=True, check=falls_shut(1e-6))
case(GROUP, "initial gap of 10 mm closes", lambda: gaping(1e-2), quick=True, check=falls_shut(1e-2))
case(GROUP, "initial gap below zero", lambda: gaping(-1e-6), INPUT_ERROR, words="initial gap = -1e-6 .m. must be >= 0",
     quick=True)


def overlapping(depth):
    drawing = Drawing(0.25, apart=True)
    drawing.box(0.0, 0.0, 1.0, 0.5, bottom="ground")
    drawing.box(0.0, 0.5 - depth, 1.0, 0.5)
    return scene(drawing)


case(GROUP, "stones drawn one by one", lambda: overlapping(0.0), quick=True, check=weighed(1.0))
case(GROUP, "stones overlap by 0.1 micrometre: rounded away", lambda: overlapping(1e-7), quick=True,
     check=lambda run: [Near("weight carried", run.reaction(), 2000 * GRAVITY, 1.01e-7)])
case(GROUP, "stones overlap by 1 mm", lambda: overlapping(1e-3), INPUT_ERROR, words="overlap|match|closer", quick=True)
case(GROUP, "stones overlap by 0.1 m", lambda: overlapping(0.1), INPUT_ERROR, words="overlap", quick=True)
case(GROUP, "stones 1 mm apart", lambda: overlapping(-1e-3), INPUT_ERROR, words="apart|match|closer|touch", quick=True)
case(GROUP, "stones 0.1 m apart: the upper one in the air", lambda: overlapping(-0.1), INPUT_ERROR,
     words="neither support nor joint", quick=True)


def ring(voussoirs=12, radius=1.0, thickness=0.25, pressure=1e6):
    """A closed ring under pressure from outside, one voussoir held at its foot."""
    drawing = Drawing(0.125)
    corners = []
    for k in range(voussoirs):
        angle = 2 * math.pi * (k + 0.5) / voussoirs - math.pi / 2
        corners.append([(r * math.cos(angle), r * math.sin(angle)) for r in (radius, radius + thickness)])
    for k in range(voussoirs):
        (a, b), (d, c) = corners[k - 1], corners[k]
        drawing.stone([a, b, c, d])
        drawing.divide(b, c, 4)
        drawing.divide(a, d, 4)
        drawing.name("outside", b, c)
        if k == 0:
            drawing.name("ground", b, c)
    return scene(drawing, loads={"water": {"type": "traction", "on": "outside", "pressure": pressure}},
                 stages={"pressure": {"loads": {"water": 1.0}}})


def hoop(run):
    # Forces of the joints are a polygon about the centre: pressure times the distance of the outer corners. The held
    # foot does not give way, which bends the ring: the mean of all joints is left.
    force, i, j = (run.table(name) for name in ("joint_normal_force_N", "joints/block_i", "joints/block_j"))
    forces = [force[(i == a) & (j == b)].sum() for a, b in sorted(set(zip(i, j)))]
    yield Near("hoop force, mean of 12 joints", sum(forces) / 12, 1e6 * 1.25, 0.02)


case(GROUP, "closed ring of 12 voussoirs under pressure", ring, quick=True, check=hoop)


def keystone(friction, squeeze):
    """A stone between two abutments that are pushed together by some length, then its weight comes on."""
    drawing = grid(3, 1, 0.5, 0.5, 0.125)
    drawing.curves.pop("ground")
    return scene(drawing, friction=friction, supports=("left", "right"),
                 loads={"squeeze": {"type": "settlement", "support": "right", "ux": -squeeze}},
                 stages={"squeeze": {"loads": {"squeeze": 1.0}}, "weight": {"loads": {"weight": 1.0}}})


def wedged(run):
    yield from weighed(0.75)(run)


# 10 GPa over 1.5 m: a micrometre is 3300 N of thrust, the keystone weighs 4905 N.
FALLS = r"1 of 3 blocks moves, surface 2 \(row 0, column 1\): down"
case(GROUP, "keystone squeezed by 10 micrometres, held by friction alone", lambda: keystone(0.6, 1e-5), quick=True,
     check=wedged)
case(GROUP, "keystone squeezed by 0.5 micrometres: it falls", lambda: keystone(0.6, 5e-7), COLLAPSE, words=FALLS, quick=True)
case(GROUP, "keystone not squeezed: it falls", lambda: keystone(0.6, 0.0), COLLAPSE, words=FALLS, quick=True)


def on_a_point():
    """A stone on its tip: its joint is a single node."""
    drawing = Drawing(0.25, cells="triangle")
    drawing.stone([(0.0, 0.0), (1.0, 0.0), (1.0, 0.5), (0.5, 0.5), (0.0, 0.5)])
    drawing.stone([(0.5, 0.5), (0.75, 1.0), (0.25, 1.0)])
    drawing.name("ground", (0.0, 0.0), (1.0, 0.0))
    return scene(drawing)


case(GROUP, "a stone held at one node", on_a_point, INPUT_ERROR, words="touches other blocks in single points only",
     quick=True)


def on_a_short_edge():
    """A stone on a foot of one cell's edge, 1 cm of 1 m: it stands, as long as nobody pushes."""
    drawing = Drawing(0.25, cells="triangle")
    drawing.stone([(0.0, 0.0), (1.0, 0.0), (1.0, 0.5), (0.505, 0.5), (0.495, 0.5), (0.0, 0.5)])
    drawing.stone([(0.495, 0.5), (0.505, 0.5), (1.0, 1.0), (0.0, 1.0)], corners=())
    drawing.name("ground", (0.0, 0.0), (1.0, 0.0))
    return scene(drawing)


case(GROUP, "a stone on a foot of 1 cm", on_a_short_edge, quick=True, check=weighed(0.5 + 0.505 * 0.5))


def sliding_foot():
    """Held upright only: nothing keeps it from sliding away when pushed."""
    return scene(grid(1, 1, 1.0, 0.5, 0.25), supports={"rollers": {"on": "ground", "components": "y"}},
                 loads={"push": {"type": "acceleration", "ax": 1.0}},
                 stages={"own weight": {"loads": {"weight": 1.0}}, "push": {"loads": {"push": 1.0}}})


case(GROUP, "a stone on rollers, pushed", sliding_foot, COLLAPSE, words="the block moves, .*: to the right", quick=True)


def air(stages):
    return scene(grid(1, 1, 1.0, 0.5, 0.25), supports={}, stages=stages,
                 observations={"stone": {"place": "mean"}})


FALL = {"fall": {"duration": 1.0, "time step": 0.01, "at once": True, "loads": {"weight": 1.0}}}


def falls(run):
    last = run.history()[-1]
    # The midpoint rule is exact for constant acceleration; 100 solves to 1e-10 each.
    yield Near("way", last["uy_m of stone"], -GRAVITY / 2, 1e-9)
    yield Near("velocity", last["vy_m_per_s of stone"], -GRAVITY, 1e-9)
    yield Near("kinetic energy", last["kinetic_J"], 0.5 * 1000 * GRAVITY**2, 1e-9)
    # Round-off of u.Ku: 1e-16 x 1e10 Pa x (5 m)^2 is 1e-5 J in each cell, the kinetic energy 5e4 J.
    yield Most("elastic energy over kinetic", abs(last["elastic_J"]) / last["kinetic_J"], 1e-8)


case(GROUP, "a stone in the air, statics", lambda: air({"own weight": {"loads": {"weight": 1.0}}}), INPUT_ERROR,
     words="support", quick=True)
case(GROUP, "a stone in the air, free fall", lambda: air(FALL), quick=True, check=falls)


def hanging(stages):
    """A stone under a held one: dry joints bear no tension."""
    drawing = grid(1, 2, 1.0, 0.5, 0.25)
    drawing.curves.pop("ground")
    return scene(drawing, supports=("top",), stages=stages, observations={"lower": {"blocks": "row 0", "place": "mean"}})


def lower_falls(run):
    yield Near("way of the lower stone", run.history()[-1]["uy_m of lower"], -GRAVITY / 2, 1e-9)


case(GROUP, "a part hangs from a dry joint: it falls", lambda: hanging({"own weight": {"loads": {"weight": 1.0}}}), COLLAPSE,
     words=r"surface 1 \(row 0, column 0\): down; joints that part: ", quick=True)
case(GROUP, "a part separates in time", lambda: hanging(FALL), quick=True, check=lower_falls)

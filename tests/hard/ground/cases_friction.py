"""Friction from none to much, at the threshold of sliding, and stick-slip."""

import math

from case import COLLAPSE, Most, Near, case
from drawing import block_on_bed, grid
from scenes import GRAVITY, arch, arch_weight, changed, pushed_wall, scene, wall, wall_weight

GROUP = "friction"


def incline(friction, slope, **more):
    return scene(block_on_bed(slope=slope, depth=0.25), friction=friction, **more)


def weighed(weight):
    return lambda run: [Near("weight carried", run.reaction(), weight, 1e-8)]


# Two stones of the drawing weigh 0.75 m2 x 2000 kg/m3 x g.
BLOCK = 0.75 * 2000 * GRAVITY

SLIDES = r"1 of 2 blocks moves, surface 2 \(block\): .*to the left; joints that slide: surface 1 \(bed\)"
TOPPLES = r"surface 2 \(block\): .*turning counter-clockwise; joints that open like hinges: surface 1 \(bed\)"

case(GROUP, "0, stones on a level bed", lambda: scene(grid(1, 4, 0.5, 0.25, 0.125), friction=0.0), quick=True,
     check=weighed(0.5 * 2000 * GRAVITY))
case(GROUP, "0, wall in running bond", lambda: scene(wall(4), supports=("base",), friction=0.0), quick=True,
     check=weighed(wall_weight(4)))
case(GROUP, "0, slope of 1e-6", lambda: incline(0.0, 1e-6), COLLAPSE, words=SLIDES, quick=True)
case(GROUP, "1e-6, slope of 0.5e-6", lambda: incline(1e-6, 0.5e-6), quick=True, check=weighed(BLOCK))
case(GROUP, "1e-6, slope of 2e-6", lambda: incline(1e-6, 2e-6), COLLAPSE, words=SLIDES, quick=True)
case(GROUP, "0.05, slope of 0.049", lambda: incline(0.05, 0.049), check=weighed(BLOCK))
case(GROUP, "0.05, slope of 0.051", lambda: incline(0.05, 0.051), COLLAPSE, words=SLIDES)
case(GROUP, "0.6, slope less than that by 1e-6", lambda: incline(0.6, 0.6 * (1 - 1e-6)), quick=True, check=weighed(BLOCK))
case(GROUP, "0.6, slope more than that by 1e-6", lambda: incline(0.6, 0.6 * (1 + 1e-6)), COLLAPSE, words=SLIDES)
case(GROUP, "100, slope of 1.9", lambda: incline(100.0, 1.9), quick=True, check=weighed(BLOCK))
case(GROUP, "100, slope of 2.1: it topples", lambda: incline(100.0, 2.1), COLLAPSE, words=TOPPLES, quick=True)


def thick_arch(friction):
    """Piers of one stone, so that the springings are joints too."""
    return scene(arch(27, radius=5.0, thickness=1.5, pier_height=0.5, pier_courses=1),
                 supports=("springing left", "springing right"), friction=friction)


def arch_27(run):
    yield Near("weight carried", run.reaction(), arch_weight(27, thickness=1.5) + 2 * 0.5 * 1.5 * 2000 * GRAVITY, 1e-8)


def falls_by_sliding(run):
    """Checks the motion itself, since more than one falls: forces times ways, and what joints do along it."""
    motion, x, cells = run.table("displacement"), run.table("mesh/coordinates"), run.table("mesh/cells")
    largest = abs(motion).max()
    weight, power = 0.0, 0.0
    for cell in cells:
        (ax, ay), (bx, by) = x[cell[2]] - x[cell[0]], x[cell[-1]] - x[cell[1]]
        area = abs(ax * by - ay * bx) / 2
        weight += area
        power -= area * motion[cell][:, 1].mean()
    gap, slip = run.table("joint_gap_m") / largest, abs(run.table("joint_slip_m")) / largest
    yield Most("points that slide", -float((slip > 0.01).sum()), -1)
    yield Most("closing of a joint, over the largest motion", float(-gap.min()), 1e-5)
    yield Most("opening of a joint that slides", float(gap[slip > 0.01].max()), 1e-3)
    yield Most("rise of all stones, over the largest motion", -power / weight / largest, -0.01)


# No semicircle stands at any thickness with less than 0.3092. Some stones of it fall, or all.
case(GROUP, "0.300, semicircular arch", lambda: thick_arch(0.300), COLLAPSE, words=r"\d+ of 29 blocks move, .* joints that slide:",
     check=falls_by_sliding)
case(GROUP, "0.3092 less 1 percent, semicircular arch", lambda: thick_arch(0.3061), COLLAPSE, check=falls_by_sliding)
case(GROUP, "0.320, semicircular arch", lambda: thick_arch(0.32), quick=True, check=arch_27)
case(GROUP, "1.5, semicircular arch", lambda: thick_arch(1.5), check=arch_27)
case(GROUP, "100, semicircular arch", lambda: thick_arch(100.0), check=arch_27)
case(GROUP, "100, wall pushed", lambda: pushed_wall(8, friction=100.0), check=weighed(wall_weight(8)))
case(GROUP, "0.05, wall pushed by 0.15 of its weight", lambda: pushed_wall(4, friction=0.05), COLLAPSE, quick=True)


def shaken(friction, times, cycles=2):
    """A block on a bed under a sine of acceleration whose peak passes friction: it sticks and slips every cycle.

    Damping takes its own vibrations (1 kHz), which would change its pressure and so its friction.
    """
    content = scene(block_on_bed(size=0.25), friction=friction,
                 loads={"shake": {"type": "acceleration", "ax": times * friction * GRAVITY,
                                  "time function": {"type": "sine", "frequency": 10.0}}},
                 stages={"own weight": {"loads": {"weight": 1.0}},
                         "shaking": {"duration": cycles / 10, "time step": 1e-3, "at once": True, "loads": {"shake": 1.0}}},
                 observations={"block": {"blocks": "block", "place": "mean"}})
    return changed(content, {"steps/time": {"stiffness damping": 1e-4}})


def slides_as_rigid(friction, times):
    """Compared with the motion of a rigid block under the same sine, integrated in much smaller steps."""
    def check(run):
        every, v, x, limit = 1000, 0.0, 0.0, friction * GRAVITY
        dt, way = 1e-3 / every, [0.0]
        for k in range((len(run.history()) - 1) * every):
            a = times * limit * math.sin(20 * math.pi * (k + 0.5) * dt)
            if v or abs(a) > limit:
                new = v + (a - math.copysign(limit, v or a)) * dt
                if v * new < 0:
                    new = 0.0
                x, v = x + (v + new) / 2 * dt, new
            if (k + 1) % every == 0:
                way.append(x)
        largest = max(map(abs, way))
        off = max(abs(row["ux_m of block"] - way[round(1e3 * row["time_s"])]) for row in run.in_time())
        yield Most("imbalance", run.imbalance(), 1e-8)
        # The block is elastic (under its weight sideways it shears by 1e-7 m) and a cycle takes 100 time steps.
        yield Most("off the way of a rigid block, over its largest", off / largest, 0.05)
    return check


case(GROUP, "stick-slip of a shaken block, 2 cycles", lambda: shaken(0.3, 1.5), quick=True, check=slides_as_rigid(0.3, 1.5))
case(GROUP, "stick-slip of a shaken block, 20 cycles", lambda: shaken(0.3, 1.5, 20), seconds=300,
     check=slides_as_rigid(0.3, 1.5))
case(GROUP, "stick-slip at the threshold: peak 1.001 times friction", lambda: shaken(0.3, 1.001), seconds=300,
     check=lambda run: [Most("imbalance", run.imbalance(), 1e-8)])

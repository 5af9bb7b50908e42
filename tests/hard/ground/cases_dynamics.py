"""Long steps, impact, several impacts at once, and rest for ever."""

from case import Most, Near, case
from drawing import block_on_bed, grid
from scenes import GRAVITY, changed, scene, wall

GROUP = "dynamics"
# Waves pass a cell of 0.125 m of stone in 0.125 / 2280 s.
PASSAGE = 0.125 / (1e10 / (2000 * 0.96))**0.5


def balanced(run):
    yield Most("imbalance", run.imbalance(), 1e-8)


def shaken_wall(courants, steps, friction=0.6):
    return scene(wall(4), supports=("base",), friction=friction,
                 loads={"shake": {"type": "acceleration", "ax": 0.5 * GRAVITY,
                                  "time function": {"type": "sine", "frequency": 5.0}}},
                 stages={"own weight": {"loads": {"weight": 1.0}},
                         "shaking": {"duration": steps * courants * PASSAGE, "time step": courants * PASSAGE,
                                     "at once": True, "loads": {"shake": 1.0}}})


case(GROUP, "wall shaken by 0.5 g, steps of 100 Courant times", lambda: shaken_wall(100, 40), quick=True, check=balanced)
case(GROUP, "wall shaken by 0.5 g, steps of 1000 Courant times", lambda: shaken_wall(1000, 40), check=balanced)
case(GROUP, "wall shaken by 0.5 g, steps of 1 Courant time", lambda: shaken_wall(1, 400), check=balanced)


def flying(drawing, velocity, duration, steps, *, gap, friction=0.0, blocks="block", **more):
    return changed(scene(drawing, friction=friction, initial_velocities={"flying": {"blocks": blocks, "vy": -velocity}},
                         stages={"flight": {"duration": duration, "time step": duration / steps, "at once": True,
                                            "loads": {"weight": 1.0}}},
                         observations={"block": {"blocks": blocks, "place": "mean"}}, **more),
                   {"joints/dry/initial gap": gap})


def bounces(run):
    yield Most("imbalance", run.imbalance(), 1e-8)
    last = run.history()[-1]
    yield Most("energy at the end over that at the start, less 1",
               (last["kinetic_J"] + last["elastic_J"]) / run.history()[0]["kinetic_J"] - 1, 0.01)
    yield Near("bounces back, 1 = yes", float(last["vy_m_per_s of block"] > 0), 1.0, 0.0)


case(GROUP, "impact at 100 m/s", lambda: flying(block_on_bed(size=0.125), 100.0, 1e-3, 200, gap=0.01), quick=True,
     check=bounces)
case(GROUP, "impact at 1e-6 m/s", lambda: changed(flying(block_on_bed(size=0.125), 1e-6, 2e-3, 400, gap=1e-10),
                                                  {"loads/weight/gravity": 0.0}), check=bounces)


def three_at_once():
    """Three columns, three stones that fly onto them at the same moment, side by side without friction."""
    return changed(flying(grid(3, 2, 0.5, 0.25, 0.125), 1.0, 1e-3, 200, gap=1e-4, blocks="row 1"),
                   {"loads/weight/gravity": 0.0, "materials/stone/Poisson ratio": 0.0})


def alike(run):
    yield from balanced(run)
    u, block = run.table("displacement")[:, 1], run.table("mesh/block_of_node")
    ways = [u[block == b].mean() for b in (3, 4, 5)]
    # The three are equal: their ways may differ by what solvers leave open in 200 steps.
    yield Near("ways of the three", max(ways) - min(ways), 0.0, 1e-6 * abs(ways[0]))


case(GROUP, "three impacts at once", three_at_once, quick=True, check=alike)
case(GROUP, "impacts in a stack of six, from below up",
     lambda: flying(grid(1, 6, 0.5, 0.25, 0.125), 1.0, 5e-3, 1000, gap=1e-3, blocks="all"), check=balanced)


def resting(steps, slope=0.5, friction=0.6):
    return scene(block_on_bed(slope=slope, size=0.5), friction=friction,
                 stages={"own weight": {"loads": {"weight": 1.0}}, "rest": {"duration": steps * 1e-3, "time step": 1e-3}},
                 observations={"block": {"blocks": "block", "place": "mean"}},
                 output={"report": False, "every": 10000, "checkpoint seconds": 0})


def stays(run):
    rows = run.history()
    elastic = abs(rows[0]["ux_m of block"])
    # The static start is solved to 1e-8 of its forces; the rest must not add to that step after step.
    off = max(abs(row["ux_m of block"] - rows[0]["ux_m of block"]) for row in rows)
    yield Most("creep over the elastic displacement", off / elastic, 1e-7)


case(GROUP, "rest on a slope of 0.5 with friction 0.6, 300 steps", lambda: resting(300), quick=True, check=stays)
case(GROUP, "rest on a slope of 0.5 with friction 0.6, 100 000 steps", lambda: resting(100_000), seconds=1800, check=stays)
case(GROUP, "rest on a slope of 0.599 with friction 0.6, 10 000 steps", lambda: resting(10_000, slope=0.599), seconds=600,
     check=stays)

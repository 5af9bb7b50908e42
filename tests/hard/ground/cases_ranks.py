"""More ranks than stones, ranks without stones, one large stone among many small ones."""

from case import Near, case
from drawing import grid
from scenes import GRAVITY, pushed, pushed_wall, scene

GROUP = "ranks"


def as_on_one(content, tolerance=1e-7):
    def check(run):
        base = run.again(content())
        yield Near("largest displacement", run.result["largest_displacement_m"], base.result["largest_displacement_m"],
                   tolerance)
        yield Near("reaction", run.reaction(), base.reaction(), 1e-8)
    return check


def two():
    return pushed(grid(1, 2, 1.0, 0.5, 0.25), 0.1 * GRAVITY)


def alone():
    return scene(grid(1, 1, 1.0, 0.5, 0.25))


def w4():
    return pushed_wall(4)


def giant(small):
    """A stone of 10 m on a bed of small ones, whose mesh is as fine as theirs below and as heavy as all of them."""
    drawing = grid(small, 2, 0.1, 0.1, 0.1)
    length = [k * 0.1 for k in range(small + 1)]
    bed = [(x, 2 * 0.1) for x in length]
    drawing.stone([*bed, (length[-1], 2.2), (0.0, 2.2)], corners=(0, small, small + 1, small + 2))
    drawing.divide((length[-1], 2.2), (0.0, 2.2), small)
    return scene(drawing)


case(GROUP, "one stone on 3 ranks", alone, ranks=3, check=as_on_one(alone))
case(GROUP, "two stones on 4 ranks", two, quick=True, ranks=4, check=as_on_one(two))
case(GROUP, "wall of 18 stones on 3 ranks", w4, ranks=3, check=as_on_one(w4))
case(GROUP, "one stone of 20 000 kg on 200 small ones, 2 ranks", lambda: giant(100), ranks=2,
     check=as_on_one(lambda: giant(100)))
case(GROUP, "one stone of 200 000 kg on 2000 small ones, 3 ranks", lambda: giant(1000), ranks=3, seconds=600,
     check=as_on_one(lambda: giant(1000)))

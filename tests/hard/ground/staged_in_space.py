"""Random small masonry in space and what happens to it in three stages: staged.py, with stones from a file."""

import numpy as np

import scenes
import solids
from staged import DENSITY, GRAVITY, Posed


def stones_of(stones, size):
    """The section of a mesh; the stones themselves are written beside the scene."""
    return {"type": "stones", "stones": {"file": "stones.obj", "element size": size}, "drawn": stones}


def held(*feet):
    """A support at the foot of each of these stones, of its name."""
    return {f"under {name}": {"on": "base", "blocks": name} for name in feet}


def wall(r):
    """A wall in bond on stones whose feet may settle; the cap lies on its middle."""
    count, courses, w, h, t = r.randint(2, 3), r.randint(1, 3), 0.5, 0.25, r.choice([0.25, 0.5])
    stones = {f"foot {k}": solids.box((k * w, 0, -h), (k * w + w, t, 0)) for k in range(count)}
    for c in range(courses):
        ends = [w * k for k in range(count + 1)]
        if c % 2 == 0:
            ends = [0.0, *(w * k + w / 2 for k in range(count)), w * count]
        for k, (a, b) in enumerate(zip(ends, ends[1:])):
            stones[f"stone {c} {k}"] = solids.box((a, 0, h * c), (b, t, h * c + h))
    stones["cap"] = solids.box((w / 2, 0, h * courses), (3 * w / 2, t, h * courses + h))
    return stones_of(stones, 0.25), held(*(f"foot {k}" for k in range(count)))


def stack(r):
    """Stones on each other, the lowest on the ground; the cap is as wide as they are."""
    width, depth, h, count = 1.0, r.choice([0.5, 0.75]), r.choice([0.3, 0.5]), r.randint(2, 3)
    stones = {f"stone {k}": solids.box((0, 0, k * h), (width, depth, k * h + h)) for k in range(count)}
    stones["cap"] = solids.box((0, 0, count * h), (width, depth, count * h + h))
    return stones_of(stones, r.choice([0.15, 0.25])), held("stone 0")


def portal(r):
    """A lintel on two jambs and a prop, which is the stone that comes or goes."""
    h, t = r.choice([0.5, 0.75]), 0.5
    stones = {"left": solids.box((0, 0, 0), (0.5, t, h)), "right": solids.box((1.5, 0, 0), (2, t, h)),
              "cap": solids.box((0.75, 0, 0), (1.25, t, h)), "lintel": solids.box((0, 0, h), (2, t, h + 0.5))}
    return stones_of(stones, 0.25), held("left", "right", "cap")


def corner(r):
    """Two walls that share their corner in turn; the cap lies on it."""
    t, length, h, courses = 0.25, 0.75, 0.25, r.randint(2, 3)
    stones = {}
    for c in range(courses):
        whole, short = ((0, 0), (length, t)), ((0, t), (t, length))
        if c % 2:
            whole, short = ((0, 0), (t, length)), ((t, 0), (length, t))
        for name, (low, high) in (("whole", whole), ("short", short)):
            stones[f"{name} {c}"] = solids.box((*low, c * h), (*high, c * h + h))
    stones["cap"] = solids.box((0, 0, courses * h), (t, t, courses * h + h))
    return stones_of(stones, 0.25), held("whole 0", "short 0")


class PosedInSpace(Posed):
    HOSTS = {"wall": wall, "stack": stack, "portal": portal, "corner": corner}

    def __init__(self, seed):
        super().__init__(seed)
        self.stones = self.scene["mesh"].pop("drawn")
        self.highest = max(p[2] for points, _ in self.stones.values() for p in points)

    def pose_loads(self):
        r = self.random
        small = lambda size: r.uniform(-size, size)  # noqa: E731
        return {"push": {"type": "acceleration", "ax": GRAVITY, "ay": small(5), "az": small(1)},
                "wind": {"type": "traction", "on": "top", "tx": small(1e3), "ty": small(1e3), "tz": -r.uniform(0, 5e3)},
                "sink": {"type": "settlement", "support": r.choice(list(self.supports)), "ux": small(2e-5), "uy": small(2e-5),
                         "uz": -r.uniform(0, 5e-5)}}

    def write(self, folder):
        (folder / "stones.obj").write_text(solids.obj(self.stones), encoding="utf-8")
        return scenes.write(self.scene, folder)

    def nodal_forces(self, place, cells, cap):
        """Of every load at factor one on the cap or on all else [N]: by name, [nodes, 3]. Cells are boxes."""
        m, top = np.zeros(len(place)), np.zeros(len(place))
        for cell in cells:
            x = place[cell]
            sides = x.max(axis=0) - x.min(axis=0)
            assert len(set(cell)) == 8
            m[cell] += DENSITY * np.prod(sides) / 8
            above = cell[x[:, 2] > self.highest - 1e-9]
            if len(above) == 4:
                top[above] += sides[0] * sides[1] / 4
        of = lambda load, u: [self.loads[load].get(u + c, 0.0) for c in "xyz"]  # noqa: E731
        forces = {"weight": m[:, None] * [0.0, 0.0, -GRAVITY], "push": m[:, None] * of("push", "a"),
                  "wind": top[:, None] * of("wind", "t")}
        if "pulse" in self.loads:
            forces["pulse"] = m[:, None] * of("pulse", "a")
        return forces

"""Random small masonry and what happens to it in three stages: load steps, time and construction.

Posed(seed) is a scene, and what is known of it without the program: factors of its loads, which stones are there.
"""

import math
import random

import numpy as np

import scenes
from drawing import Drawing, foundations_and_wall

DENSITY, GRAVITY = scenes.STONE["density"], scenes.GRAVITY


def held(*sets):
    """Supports, each the set of its name."""
    return {name: {"on": name} for name in sets}


def wall(r):
    """A wall in bond on stones whose feet may settle; the cap lies on its middle."""
    stones, courses = r.randint(2, 3), r.randint(1, 3)
    w, h = 0.5, 0.25
    drawing = foundations_and_wall(stones, courses, w, h, r.choice([0.125, 0.25]))
    top = [(k * (w / 2), courses * h) for k in range(2 * stones + 1)]
    cap(drawing, top[1:4], h)
    for a, b in [*zip(top[:1], top[1:2]), *zip(top[3:], top[4:])]:
        drawing.name("top", b, a)
    return drawing, held(*(f"foot {i}" for i in range(stones)))


def stack(r):
    """Stones on each other, the lowest on the ground; the cap is as wide as they are."""
    width, height, size = 1.0, r.choice([0.3, 0.5]), r.choice([0.125, 0.25])
    count = r.randint(2, 3)
    drawing = Drawing(size)
    for k in range(count):
        drawing.box(0.0, k * height, width, (k + 1) * height - k * height, sets=("stones",),
                    **({"bottom": "ground", "right": "side"} if k == 0 else {"right": "top"} if k == count - 1 else {}))
    cap(drawing, [(0.0, count * height), (width, count * height)], height)
    return drawing, held("ground")


def portal(r):
    """A lintel on two jambs and a prop, which is the stone that comes or goes."""
    height, size = r.choice([0.5, 0.75]), 0.25
    drawing = Drawing(size)
    for x, foot in ((0.0, "left"), (1.5, "right")):
        drawing.box(x, 0.0, 0.5, height, sets=("stones",), bottom=foot)
    drawing.box(0.75, 0.0, 0.5, height, sets=("cap",), bottom="foot of the prop")
    below = [(x, height) for x in (0.0, 0.5, 0.75, 1.25, 1.5, 2.0)]
    above = [(x, height + 0.5) for x in (2.0, 0.0)]
    drawing.stone(below + above, corners=(0, 5, 6, 7), sets=("stones",))
    drawing.name("top", *above)
    return drawing, held("left", "right", "foot of the prop")


def cap(drawing, below, height):
    """A stone on corners from left to right."""
    above = [(x, y + height) for x, y in (below[-1], below[0])]
    count = len(below)
    drawing.stone(below + above, corners=(0, count - 1, count, count + 1), sets=("cap",))


LAWS = ("dry", "softening", "mortar")
TASKS = ("load", "time")


def mass_of_nodes(place, cells):
    """Mass of the cells that belongs to every node [kg], 1 m thick."""
    m = np.zeros(len(place))
    for cell in cells:
        nodes = list(dict.fromkeys(cell))
        x = place[nodes]
        if len(nodes) == 3:
            area = abs(np.cross(x[1] - x[0], x[2] - x[0])) / 2
            m[nodes] += DENSITY * area / 3
            continue
        a = 1 / math.sqrt(3)
        for u, v in ((-a, -a), (a, -a), (a, a), (-a, a)):
            s = np.array([(1 - u) * (1 - v), (1 + u) * (1 - v), (1 + u) * (1 + v), (1 - u) * (1 + v)]) / 4
            du = np.array([-(1 - v), 1 - v, 1 + v, -(1 + v)]) / 4
            dv = np.array([-(1 - u), -(1 + u), 1 + u, 1 - u]) / 4
            m[nodes] += DENSITY * s * abs(np.linalg.det(np.array([du, dv]) @ x))
    return m


def lies_on(x, a, b, along):
    t = np.dot(x - a, along)
    return np.linalg.norm(x - a - t * along) < 1e-9 and -1e-9 < t < np.linalg.norm(b - a) + 1e-9


class Posed:
    """One scene, and what is known of it without the program."""

    HOSTS = {"wall": wall, "stack": stack, "portal": portal}

    def __init__(self, seed):
        r = self.random = random.Random(seed)
        self.host = list(self.HOSTS)[seed % len(self.HOSTS)]
        self.law = LAWS[seed // len(self.HOSTS) % len(LAWS)]
        mesh, self.supports = self.HOSTS[self.host](r)
        tasks = ["load", *(("load", "load") if self.law == "mortar" else (r.choice(TASKS), r.choice(TASKS)))]
        self.function = [(0.0, 0.0)]  # of the pulse: time [s], factor
        self.loads = self.pose_loads()
        self.stages = {name: self.stage(name, task) for name, task in zip(("one", "two", "three"), tasks)}
        self.pulses()
        self.construction = self.pose_construction()
        self.ranks = 2 if seed % 2 else 4
        self.scene = scenes.scene(
            mesh, friction=0.7, supports=self.supports, loads=self.loads,
            stages=self.stages, joints={"dry": self.pose_joints()},
            observations={name: {"place": "support", "support": name} for name in self.supports},
            output={"report": False, "checkpoint every": 1, "checkpoint seconds": 0.0})
        self.scene["steps"]["expect collapse"] = False
        self.scene["steps"]["time"] = r.choice([{}, {"mass damping": 5.0}, {"stiffness damping": 1e-4}])
        self.scene["selection"] = {"mode": r.choice(["adaptive", "all"])}
        if self.construction:
            self.scene["construction"] = {"cap": {"blocks": "cap", **self.construction}}

    def __str__(self):
        stages = ", ".join("time" if "duration" in s else "load steps" for s in self.stages.values())
        return f"{self.host}, {self.law}: {stages}" + "".join(f", cap {k} in {v}" for k, v in self.construction.items())

    def pose_joints(self):
        law = {"friction coefficient": 0.7}
        if self.law != "dry":
            law |= {"cohesion": 1e5, "tension strength": 5e4, "fracture energy": 10.0, "shear fracture energy": 50.0}
        if self.law == "mortar":
            law |= {"normal stiffness": 5e10, "tangential stiffness": 2e10}
        return law

    def pose_loads(self):
        r = self.random
        loads = {"push": {"type": "acceleration", "ax": GRAVITY, "ay": r.uniform(-1, 1)},
                 "wind": {"type": "traction", "on": "top", "tx": r.uniform(-1e3, 1e3), "ty": -r.uniform(0, 5e3)},
                 "sink": {"type": "settlement", "support": r.choice(list(self.supports)), "ux": r.uniform(-2e-5, 2e-5),
                          "uy": -r.uniform(0, 5e-5)}}
        return loads

    def stage(self, name, task):
        r = self.random
        factors = {} if name == "one" else {load: r.uniform(-0.08, 0.08) if load == "push" else r.uniform(0.2, 1.0)
                                            for load in self.loads if r.random() < 0.6}
        if name == "one":
            factors["weight"] = 1.0
        if task == "load":
            return {"increments": r.randint(1, 3), "loads": factors}
        steps, time_step = r.randint(5, 10), r.choice([1e-3, 2e-3, 5e-3])
        return {"duration": steps * time_step, "time step": time_step, "loads": factors}

    def pulses(self):
        """A push whose table has points between the steps, in the first stage that takes time."""
        lasting = [s for s in self.stages.values() if "duration" in s]
        if not lasting:
            return
        r, duration = self.random, lasting[0]["duration"]
        times = sorted(r.uniform(0, duration) for _ in range(3))
        self.function = [(times[0], 0.0), (times[1], r.uniform(0.2, 1.0)), (times[2], 0.0)]
        self.loads["pulse"] = {"type": "acceleration", "ax": 0.5,
                               "time function": {
            "type": "table", "times": ", ".join(repr(t) for t, _ in self.function),
            "values": ", ".join(repr(v) for _, v in self.function)}}
        lasting[0]["loads"]["pulse"] = 1.0

    def pose_construction(self):
        """The cap, or the prop, is there in some stages alone."""
        r = self.random
        choice = r.randrange(4)
        if choice == 0 or any("duration" in s for s in self.stages.values()):  # which do not know of absent stones
            return {}
        return {"appears" if choice % 2 else "disappears": r.choice(["two", "three"])}

    def present(self, stage):
        """Whether the cap is there."""
        order = list(self.stages)
        for key, is_there in (("appears", lambda a, b: a >= b), ("disappears", lambda a, b: a < b)):
            if key in self.construction and not is_there(order.index(stage), order.index(self.construction[key])):
                return False
        return True

    def factor(self, load, stage, share):
        """Of a load at a share of a stage, without its time function."""
        before = 0.0
        for name, s in self.stages.items():
            end = s["loads"].get(load, before)
            if name == stage:
                return before + share * (end - before)
            before = end
        raise KeyError(stage)

    def pulse(self, t):
        times, values = zip(*self.function)
        return float(np.interp(t, times, values))

    def write(self, folder):
        return scenes.write(self.scene, folder)

    def nodal_forces(self, place, cells, cap):
        """Of every load at factor one on the cap or on all else [N], 1 m thick: by name, [nodes, 2]."""
        m = mass_of_nodes(place, cells)[:, None]
        forces = {"weight": m * [0.0, -GRAVITY], "push": m * [self.loads["push"]["ax"], self.loads["push"]["ay"]]}
        if "pulse" in self.loads:
            forces["pulse"] = m * [self.loads["pulse"]["ax"], 0.0]
        if not cap:
            forces["wind"] = self.windward(place, cells)[:, None] * [self.loads["wind"]["tx"], self.loads["wind"]["ty"]]
        return forces

    def windward(self, place, cells):
        """Length of the loaded set that belongs to every node [m]: edges of one cell alone that lie in its curves."""
        drawing = self.scene["mesh"]
        ends = {number: pair for pair, number in drawing.sides.items()}
        length = np.zeros(len(place))
        for curve in drawing.curves["top"]:
            a, b = (np.array(p[:2]) for p in ends[curve])
            along = (b - a) / np.linalg.norm(b - a)
            for cell in cells:
                nodes = list(dict.fromkeys(cell))
                for p, q in zip(nodes, nodes[1:] + nodes[:1]):
                    if all(lies_on(place[n], a, b, along) for n in (p, q)):
                        length[[p, q]] += np.linalg.norm(place[p] - place[q]) / 2
        return length

"""Random structures in space with stones planted in them that nothing holds: none may stand.

A structure (a pier, a wall in bond, a tower of crossed beams, an arch, a table on four legs) is drawn by its stones in a
file, turned by any angle, in any unit, with any axis upwards and its stones in any order. Planted stones hang at a side
of it, slide or tip on its top by a push in any direction, or are a wedge between two posts that opens downwards; they
weigh a millionth to a tenth of the structure. They must fall in load steps, at the load factor that statics tells, when
the prop below them goes, and in time; what falls must be they. Limit analysis must enclose the same factor. Any 20 seeds
in a row are each structure with each way.

    planted_in_space.py PROGRAM MPIEXEC [--count N] [--first SEED] [--mode adaptive] [--hosts] [--keep FOLDER]

--hosts: the structures alone, which must stand under all they are given, or else a fall would say nothing.
A run that comes to no decision says so, which is no wrong answer; an equilibrium is.
"""

import math
import pathlib
import random
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "ground"), str(HERE.parent / "support")]
import program  # noqa: E402  (folders of their own)
import seeds  # noqa: E402
import solids  # noqa: E402
from stones import xml  # noqa: E402

GRAVITY, DENSITY, FRICTION = 9.81, 2000.0, 0.7
FACTOR_TOLERANCE = 0.05  # a step of a search, and joints whose edge is a cell wide
ENCLOSED = 3e-3  # pyramids are made finer until they differ from cones by a thousandth; one cell is round-off of places
DURATION, TIME_STEP = 0.1, 0.002  # [s]
LONGEST = 1500  # [s] of a run, for hangs
WAYS = {"hangs": ("load step", "construction", "time"), "slides": ("load step", "load factor", "time"),
        "tips": ("load step", "load factor"), "wedge": ("load step", "time")}


def volume(stone):
    """Of a closed surface."""
    points, faces = stone
    total = 0.0
    for face in faces:
        a = points[face[0]]
        for k in range(1, len(face) - 1):
            b, c = points[face[k]], points[face[k + 1]]
            total += sum(a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]) for i in range(3))
    return total / 6


class Face:
    """A plane face of a host: a place, two sides along it and the outward normal, right-handed."""

    def __init__(self, stone, at, u, v, size):
        self.stone, self.place, self.u, self.v, self.size = stone, at, u, v, size
        self.n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])

    def at(self, a, b, c):
        return tuple(self.place[k] + a * self.u[k] + b * self.v[k] + c * self.n[k] for k in range(3))

    def block(self, outline, low, high):
        """A stone over an outline in (u, v), counter-clockwise, between two heights."""
        n = len(outline)
        points = [self.at(a, b, c) for c in (low, high) for a, b in outline]
        sides = [(k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n)]
        return points, [tuple(range(n - 1, -1, -1)), tuple(range(n, 2 * n)), *sides]


X, Y, Z, BACK = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (-1.0, 0.0, 0.0)


def pier(r):
    a, b, h, courses = r.uniform(0.8, 1.2), r.uniform(0.8, 1.2), r.uniform(0.4, 0.6), r.randint(2, 5)
    stones = {f"drum {k}": solids.box((0, 0, k * h), (a, b, (k + 1) * h)) for k in range(courses)}
    top, low = f"drum {courses - 1}", f"drum {r.randrange(1, courses)}"
    z = (int(low.split()[1]) + 0.5) * h
    return stones, Face(top, (a / 2, b / 2, courses * h), X, Y, min(a, b)), Face(low, (a / 2, 0, z), X, Z, h)


def wall(r):
    n, courses, l, h, t = r.randint(2, 4), r.randint(2, 4), r.uniform(0.5, 0.8), r.uniform(0.25, 0.4), r.uniform(0.5, 0.7)
    stones = {}
    for c in range(courses):
        ends = [0.0, *(l * (k + (0.5 if c % 2 else 1.0)) for k in range(n)), n * l] if c % 2 else [l * k for k in range(n + 1)]
        for k, (a, b) in enumerate(zip(ends, ends[1:])):
            stones[f"stone {c} {k}"] = solids.box((a, 0, c * h), (b, t, (c + 1) * h))
    shift = 0.5 * l if (courses - 1) % 2 else 0.0
    top = f"stone {courses - 1} {1 if shift else 0}"
    z = courses * h
    return (stones, Face(top, (shift + l / 2, t / 2, z), X, Y, min(l, t)), Face("stone 1 1", (l, 0, 1.5 * h), X, Z, h))


def tower(r):
    w, h, levels = r.uniform(0.3, 0.4), r.uniform(0.25, 0.35), r.randint(2, 4)
    stones = {}
    for k in range(levels):
        for side in (0, 1):
            low, high = [0.0, 0.0, k * h], [3 * w, 3 * w, (k + 1) * h]
            low[k % 2], high[k % 2] = (0.0, w) if side == 0 else (2 * w, 3 * w)
            stones[f"beam {k} {side}"] = solids.box(low, high)
    k = levels - 1
    at = [1.5 * w, 1.5 * w, levels * h]
    at[k % 2] = 0.5 * w
    side = [1.5 * w, 0.0, (k + 0.5) * h]
    if k % 2 == 0:
        side = [0.5 * w, 0.0, (k + 0.5) * h]
    return stones, Face(f"beam {k} 0", tuple(at), X, Y, w), Face(f"beam {k} 0", tuple(side), X, Z, h if k % 2 else min(w, h))


def arch(r):
    radius, width, voussoirs = r.uniform(1.5, 2.5), r.uniform(0.6, 1.0), r.choice((5, 7, 9))
    thickness = radius * r.uniform(0.28, 0.34)
    stones = solids.arch(radius, thickness, width, voussoirs)
    crown = f"voussoir {voussoirs // 2}"
    half = math.pi / voussoirs / 2
    top = (radius + thickness / 2) * math.cos(half)
    size = min(width, 2 * (radius + thickness / 2) * math.sin(half))
    return (stones, Face(crown, (0, width / 2, top), X, Y, size),
            Face(crown, (0, 0, radius * math.cos(half)), X, Z, 0.4 * thickness))


def table(r):
    a, b, w, h, t = r.uniform(1.2, 1.8), r.uniform(1.2, 1.8), r.uniform(0.3, 0.4), r.uniform(0.4, 0.7), r.uniform(0.2, 0.3)
    stones = {f"leg {i} {j}": solids.box((i * (a - w), j * (b - w), 0), (w + i * (a - w), w + j * (b - w), h))
              for i in (0, 1) for j in (0, 1)}
    stones["slab"] = solids.box((0, 0, h), (a, b, h + t))
    return stones, Face("slab", (a / 2, b / 2, h + t), X, Y, min(a, b) / 2), Face("slab", (a / 2, 0, h + t / 2), X, Z, t)


HOSTS = [pier, wall, tower, arch, table]


class Planted:
    """One scene: a structure, what is planted in it, and what must come of it."""

    def __init__(self, seed):
        r = self.random = random.Random(seed)
        turn, kind = divmod(seed, len(HOSTS))
        self.way = list(WAYS)[turn % len(WAYS)]
        self.task = WAYS[self.way][(turn // len(WAYS) + kind) % len(WAYS[self.way])]
        self.kind = HOSTS[kind].__name__
        self.stones, self.top, self.side = HOSTS[kind](r)
        self.weight = sum(volume(s) for s in self.stones.values())
        self.count = 1 if self.way == "wedge" else r.randint(1, 3)
        self.share = 10**r.uniform(-6, -1)  # of the weight of the structure
        self.push, self.towards = r.uniform(0.04, 0.08), r.uniform(0, 2 * math.pi)  # [g], from the x of the stones
        self.friction = self.push * r.uniform(0.2, 0.85)  # of planted stones that slide
        self.turned, self.unit, self.up = r.uniform(0, 2 * math.pi), 10**r.uniform(-3, 1), r.choice("xyz")
        self.ranks = r.choice((1, 1, 2))
        self.loose, self.posts, self.prop = {}, {}, {}
        self.limit = None  # [g]
        {"hangs": self.hang, "wedge": self.wedge}.get(self.way, self.stand)()

    def __str__(self):
        return f"{self.count} x {self.way}, {self.task}, {self.kind}, weight {self.share:.1e}, {self.ranks} ranks"

    def hang(self):
        s, depth = 0.4 * self.side.size, self.random.uniform(0.3, 0.6) * self.side.size
        square = [(-s, -s), (s, -s), (s, s), (-s, s)]
        for k in range(self.count):
            self.loose[f"loose {k}"] = self.side.block(square, k * depth, (k + 1) * depth)
        if self.task == "construction":
            foot = [(-s, 0.0), (s, 0.0), (s, self.count * depth), (-s, self.count * depth)]
            x, y, z = self.side.place
            below = Face(self.side.stone, (x, y, 0.0), BACK, (0.0, -1.0, 0.0), s)
            self.prop["prop"] = below.block(foot, 0.0, z - s)

    def stand(self):
        """On the top, turned by any angle about the vertical axis."""
        across = 0.5 * self.top.size
        tips = self.way == "tips"
        a, b = (across * self.random.uniform(0.3, 0.6) for _ in "ab")
        angle = self.random.choice((0.0, self.random.uniform(0, 2 * math.pi)))
        c, s = math.cos(angle), math.sin(angle)
        outline = [(c * x - s * y, s * x + c * y) for x, y in ((-a, -b), (a, -b), (a, b), (-a, b))]
        along = (math.cos(self.towards - angle), math.sin(self.towards - angle))
        reach = min(side / abs(d) for side, d in zip((a, b), along) if abs(d) > 1e-12)  # from the middle to the edge
        height = 2 * reach / (self.push * self.random.uniform(0.4, 0.85)) if tips else self.random.uniform(0.5, 1.5) * reach
        for k in range(self.count):
            self.loose[f"loose {k}"] = self.top.block(outline, k * height / self.count, (k + 1) * height / self.count)
        self.limit = 2 * reach / height
        if not tips:
            self.limit = min(self.limit, self.friction)

    def wedge(self):
        w = 0.15 * self.top.size
        h, lean = 2 * w, 0.1 * w
        upright = Face(self.top.stone, self.top.at(0, -w, 0), X, Z, w)  # drawn from the front, backwards
        deep = (0.0, -2 * w)  # its normal points to the front
        for name, sign in (("post 0", 1), ("post 1", -1)):
            inner = [(-0.5 * w * sign, 0.0), ((-0.5 * w + lean) * sign, h)]
            points = [(-3 * w * sign, 0.0), inner[0], inner[1], (-3 * w * sign, h)][::sign]
            self.posts[name] = upright.block(points, *reversed(deep))
        half, grown = 0.5 * w - lean / 2, 0.5 * w - lean
        self.loose["loose 0"] = upright.block([(-half, h / 2), (half, h / 2), (grown, h), (-grown, h)], *reversed(deep))

    def drawn(self, stones):
        return solids.drawn(stones, self.random, turned=self.turned, unit=self.unit, up=self.up)

    def pushed(self):
        angle = self.turned + self.towards
        return {"type": "acceleration", "ax": GRAVITY * math.cos(angle), "ay": GRAVITY * math.sin(angle)}

    def scene(self, mode, alone):
        stone = {"Young modulus": 1e10, "Poisson ratio": 0.2}
        pushes = self.way in ("slides", "tips")
        held = {"push": self.push} if pushes else {}
        own = {"own weight": {"loads": {"weight": 1.0}}}
        stages = {**own, "push": {"loads": held}} if pushes and (alone or self.task == "load step") else own
        tree = {"mesh": {"type": "stones", "stones": {"file": "stones.obj", "unit": self.unit, "up": self.up}},
                "materials": {"stone": {**stone, "density": DENSITY}},
                "joints": {"dry": {"friction coefficient": FRICTION}},
                "supports": {"ground": {"on": "base"}},
                "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, "push": self.pushed()},
                "steps": {"expect collapse": True, "stages": stages}, "selection": {"mode": mode}, "output": {"report": False}}
        if alone:
            return tree
        density = self.share * DENSITY * self.weight / sum(volume(s) for s in self.loose.values())
        for name in self.loose:
            tree["materials"][name] = {**stone, "density": density, "blocks": name}
        if self.way == "slides":
            tree["joints"]["bed"] = {"friction coefficient": self.friction, "between": "loose 0", "and": self.top.stone}
        for name in self.posts:
            tree["joints"][name] = {"friction coefficient": 0.02, "between": name, "and": "loose 0"}
        if self.task == "load factor":
            tree["load factor"] = {"pattern": {"push": 1.0}, "largest factor": 2.0}
        elif self.task == "construction":
            tree["steps"]["stages"] = {"propped": {"loads": {"weight": 1.0}}, "free": {"loads": {"weight": 1.0}}}
            tree["construction"] = {"prop": {"blocks": "prop", "disappears": "free"}}
        elif self.task == "time":
            tree["steps"]["stages"] = {"falls": {"duration": DURATION, "time step": TIME_STEP, "at once": True,
                                                 "loads": {"weight": 1.0, **held}}}
            tree["observations"] = {"stone": {"place": "mean", "blocks": "loose 0"}}
        return tree

    undecided = False  # the program found neither an equilibrium nor a mechanism, and says so

    def way_in_time(self):
        """[m] that stones move as rigid bodies, half of it where they must turn or wedges start within cells."""
        return (self.push - self.friction if self.way == "slides" else 1.0) * GRAVITY * DURATION**2 / 2

    def verdict(self, run):
        """What is wrong with a result, or nothing."""
        result = run.result
        if self.task == "time":
            moved = math.hypot(*(run.history[-1][f"u{c}_m of stone"] for c in "xyz"))
            expected = self.way_in_time()
            return "" if moved > 0.5 * expected else f"moved {moved:.3g} m, not {expected:.3g}"
        if result["outcome"] == "not_converged":
            self.undecided = True
            return ""
        if result["outcome"] != "collapse":
            return f"{result['outcome']}: {result.get('message', '')}"
        if "loose" not in result.get("mechanism", {}).get("largest_mover_name", ""):
            return f"not said to fall: {result['message']}"
        if self.task == "load factor":
            lower, upper = result["collapse"]["lower"], result["collapse"]["upper"]
            left = 2e-8 / self.share  # what a step leaves out of balance: the tolerance of forces of the whole structure
            if lower > (1 + FACTOR_TOLERANCE) * self.limit + left or upper < (1 - FACTOR_TOLERANCE) * self.limit:
                return f"stands at {lower} and falls at {upper}, not at {self.limit}"
        return ""

    def verdict_of_limits(self, run):
        """Of limit analysis of the search for a factor."""
        result = run.result
        if result["outcome"] != "collapse":
            return f"limit analysis: {result['outcome']}"
        least, most = result["rigid"]["forces_found_up_to"], result["collapse"]["certified_upper"]
        right = least <= (1 + ENCLOSED) * self.limit and most >= (1 - ENCLOSED) * self.limit
        return "" if right and most - least < 2 * ENCLOSED * most else f"limit analysis: {least} to {most}, not {self.limit}"

    def verdict_alone(self, run):
        return "" if run.outcome == "equilibrium" else f"{run.outcome}: {run.said}"

    def run(self, folder, mode, alone):
        folder.mkdir(parents=True, exist_ok=True)
        stones = self.stones if alone else {**self.stones, **self.loose, **self.posts, **self.prop}
        (folder / "stones.obj").write_text(self.drawn(stones), encoding="utf-8")
        (folder / "scene.xml").write_text(xml("planted", self.scene(mode, alone)) + "\n", encoding="utf-8")
        try:
            return self.judge(folder, mode, alone)
        except subprocess.TimeoutExpired:
            return f"no end within {LONGEST} s"

    def judge(self, folder, mode, alone):
        run = program.run(folder / "scene.xml", folder / "out", ranks=self.ranks, seconds=LONGEST)
        if run.code not in (0, 3):
            return f"exit code {run.code}: {run.words[:900]}"
        fault = (self.verdict_alone if alone else self.verdict)(run)
        if fault or alone or self.task != "load factor":
            return fault
        return self.verdict_of_limits(program.run(folder / "scene.xml", folder / "limits", "--limit-analysis", seconds=LONGEST))


def run(planted, asked, folder):
    program.PROGRAM, program.MPIEXEC = asked.program, asked.mpiexec
    return planted.run(folder, asked.mode, asked.hosts)


def main():
    seeds.judge(__doc__, Planted, run, first=0, count=20, programs=("program", "mpiexec"))


if __name__ == "__main__":
    main()

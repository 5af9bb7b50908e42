"""Random walls, arches and stacks, loaded at random: what the static theorem says against what elastic stones do.

Asked of every structure:
- the certified limit is that of a linear programme of this test's own, from the corners as drawn;
- no elastic equilibrium is found above it, neither by the search nor by a load step just beyond it;
- what is called a collapse below it is one: in the mechanism stones move as wholes, none into another, and loads gain
  more along it than friction takes;
- and it has a point that slides or parts more aslant than friction that dilates would let it: hinges alone cannot do
  without the limit. (That is why large friction is not enough for the two to meet. A joint that opens bears no shear,
  however large friction is, and a stone that turns leaves its neighbour or its springing aslant.)
- where friction is large and no stone has another beside it the search narrows its bracket down;
- what no forces balance under its own weight is refused.

    certificates.py PROGRAM [--count N] [--first SEED] [--keep FOLDER]
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "ground"))

import scenes  # noqa: E402  (modules of the folder above)
from drawing import Drawing  # noqa: E402
from drawn_mechanism import drawn_mechanism  # noqa: E402
from rigid import RigidStones, centre_and_area  # noqa: E402

LARGEST = 20.0  # factor tried
ACCURACY = 0.01  # of a search
SAME = 1e-6  # of two programmes of the same structure, relative
BEYOND = 0.003  # above the limit, where no step may find an equilibrium
PARTS = 12  # of the length of a wall, on whose ends stones end
PATIENCE = 500  # linear solves of an attempt
ROUGH = 50.0  # friction that is as good as without end
NOTICEABLE = 0.05  # of the largest motion of a mechanism: stones that are seen to fall in time vibrate by 1 %
ASLANT = 1e-3  # the same of what a point moves beyond the dual of its friction cone; solves leave 1e-6


def rounded(point):
    return tuple(round(x, 9) for x in point)


class Random:
    """Stones of a structure as polygons, sides that are held, and sides that carry a load."""

    def __init__(self, seed):
        self.random = r = random.Random(seed)
        self.kind = r.choice(["wall", "arch", "stack"])
        self.rough = r.random() < 0.25
        self.friction = ROUGH if self.rough else r.uniform(0.0, 1.0)
        self.mode = r.choice(["all", "adaptive"])
        self.stones, self.held, self.loaded = [], [], []
        getattr(self, self.kind)()
        self.match_corners()
        self.density = [scenes.STONE["density"]] * len(self.stones)
        self.heavy = r.randrange(len(self.stones))
        self.density[self.heavy] *= 10**r.uniform(-1, 1)
        angle = r.uniform(-math.pi, math.pi)
        self.push = (scenes.GRAVITY * math.cos(angle), scenes.GRAVITY * math.sin(angle))
        self.pattern = {"push": 1.0}
        weight = sum(d * centre_and_area(s)[1] * scenes.GRAVITY for d, s in zip(self.density, self.stones))
        self.traction = (0.0, 0.0)
        if r.random() < 0.5:  # on the loaded side: some of the weight of all, downwards or at an angle
            angle = r.uniform(-1.4, 1.4)
            size = weight * r.uniform(0.1, 1.0) / math.dist(*self.loaded[0])
            self.traction = (size * math.sin(angle), -size * math.cos(angle))
            self.pattern = {"press": 1.0} if r.random() < 0.5 else {"press": 1.0, "push": r.uniform(-0.5, 0.5)}

    def __str__(self):
        return f"{self.kind} of {len(self.stones)}, friction {self.friction:.3f}, {self.mode}, {'+'.join(self.pattern)}"

    def wall(self):
        r = self.random
        length, rows = r.uniform(1.0, 3.0), r.randint(2, 5)
        y = 0.0
        for row in range(rows):
            height, count = r.uniform(0.2, 0.6), r.randint(1, 4)
            cuts = sorted(r.sample(range(1, PARTS), count - 1))  # sides of cells are not much shorter than others
            ends = [0.0] + [length * c / PARTS for c in cuts] + [length]
            for a, b in zip(ends, ends[1:]):
                self.box(a, b, y, y + height)
                if row == 0:
                    self.held.append(((a, y), (b, y)))
            y += height
        self.loaded.append(((ends[-1], y), (ends[-2], y)))

    def stack(self):
        r = self.random
        left, right, y, tilt = 0.0, r.uniform(0.6, 1.2), 0.0, 0.0
        self.held.append(((left, 0.0), (right, 0.0)))
        for _ in range(r.randint(2, 6)):
            rise = r.uniform(-0.1, 0.1)  # of the upper bed
            height = r.uniform(0.35, 0.7)
            low = [(x, y + tilt * x) for x in (left, right)]
            a = r.uniform(left - 0.15, left + 0.15)
            b = r.uniform(right - 0.15, right + 0.15)
            if b - a < 0.3:
                b = a + 0.3
            y += height
            high = [(x, y + rise * x) for x in (a, b)]
            self.stones.append([low[0], low[1], high[1], high[0]])
            # The next stands on a part of it.
            left, right = a + r.choice([0.0, 0.1, 0.2]) * (b - a), b - r.choice([0.0, 0.1, 0.2]) * (b - a)
            tilt = rise
        self.loaded.append((high[1], high[0]))

    def arch(self):
        r = self.random
        count, half, radius = r.randint(3, 11), math.radians(r.uniform(35, 90)), r.uniform(1.0, 4.0)
        thickness = radius * r.uniform(0.1, 0.3)

        def at(rho, k):
            angle = half * (2 * k / count - 1)
            return (rho * math.sin(angle), rho * math.cos(angle))

        for k in range(count):
            self.stones.append([at(radius, k), at(radius, k + 1), at(radius + thickness, k + 1),
                                at(radius + thickness, k)])
        self.held += [(at(radius, count), at(radius + thickness, count)), (at(radius + thickness, 0), at(radius, 0))]
        if r.random() < 0.5:  # springings that may open: they stand on the ground through stones of their own
            self.held.clear()
            for k, way in ((0, -1), (count, 1)):
                beyond = [at(rho, k + 0.5 * way) for rho in (radius, radius + thickness)]
                near = [at(rho, k) for rho in (radius, radius + thickness)]
                self.stones.append([near[0], near[1], beyond[1], beyond[0]])
                self.held.append((beyond[0], beyond[1]))
        k = r.randrange(count)
        self.loaded.append((at(radius + thickness, k + 1), at(radius + thickness, k)))

    def box(self, a, b, low, high):
        self.stones.append([(a, low), (b, low), (b, high), (a, high)])

    def match_corners(self):
        """Corners of stones that lie on sides of others become corners of these too."""
        self.stones = [[rounded(p) for p in s] if centre_and_area(s)[1] > 0 else [rounded(p) for p in s[::-1]]
                       for s in self.stones]
        corners = sorted({p for s in self.stones for p in s})

        def cut(a, b):
            length = math.dist(a, b)
            on = [(math.dist(a, p), p) for p in corners
                  if p not in (a, b) and math.dist(a, p) + math.dist(p, b) - length < 1e-8 * length]
            return [a] + [p for _, p in sorted(on)] + [b]

        self.stones = [[p for a, b in zip(s, s[1:] + s[:1]) for p in cut(a, b)[:-1]] for s in self.stones]
        for name in ("held", "loaded"):
            sides = [cut(rounded(a), rounded(b)) for a, b in getattr(self, name)]
            setattr(self, name, [side for way in sides for side in zip(way, way[1:])])

    def masses(self):
        return [density * centre_and_area(points)[1] for density, points in zip(self.density, self.stones)]

    def raised(self):
        """Forces of the pattern: stone, place, force."""
        share = self.pattern.get("push", 0.0)
        forces = [(k, centre_and_area(self.stones[k])[0], (share * m * self.push[0], share * m * self.push[1]))
                  for k, m in enumerate(self.masses()) if share]
        for a, b in self.loaded if "press" in self.pattern else ():
            stone = next(k for k, s in enumerate(self.stones) if {a, b} in ({*p} for p in zip(s, s[1:] + s[:1])))
            length = math.dist(a, b)
            forces.append((stone, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), tuple(length * t for t in self.traction)))
        return forces

    def limit(self):
        """Of the pattern, by the test's own programme; None where the weight cannot be borne."""
        rigid = RigidStones(self.stones, self.held, self.friction)
        fixed = [(k, rigid.middle[k], (0.0, -m * scenes.GRAVITY)) for k, m in enumerate(self.masses())]
        weight_borne = rigid.largest_factor([], fixed, LARGEST)  # what is pressed may stand where its weight alone does not
        if weight_borne is None or weight_borne < 1:
            return None
        return rigid.largest_factor(fixed, self.raised(), LARGEST)

    def scene(self, factor=None):
        """The search; or a load step at a factor, all of whose joints may open: ties that adaptive selection has left
        bear up to its tolerance."""
        drawing = Drawing(0.25, cells="triangle")
        for k, points in enumerate(self.stones):
            drawing.stone(points, corners=(), sets=("heavy" if k == self.heavy else "plain",))
        for name, sides in (("ground", self.held), ("top", self.loaded)):
            for a, b in sides:
                drawing.name(name, a, b)
        loads = {"push": {"type": "acceleration", "ax": self.push[0], "ay": self.push[1]}}
        if "press" in self.pattern:
            loads["press"] = {"type": "traction", "on": "top", "tx": self.traction[0], "ty": self.traction[1]}
        stages = {"own weight": {"loads": {"weight": 1.0}}}
        sought = {"load factor": {"pattern": self.pattern, "largest factor": LARGEST, "accuracy": ACCURACY}}
        if factor is not None:
            stages["beyond"] = {"loads": {name: factor * share for name, share in self.pattern.items()}}
            sought = {}
        result = scenes.scene(drawing, friction=self.friction, loads=loads, stages=stages,
                              selection={"mode": self.mode},
                              newton={"largest iterations": PATIENCE}, **sought)
        result["materials"]["heavy"] = {**scenes.STONE, "density": self.density[self.heavy], "blocks": "heavy"}
        return result


def run(program, folder, content):
    folder.mkdir(parents=True)
    path = scenes.write(content, folder)
    command = [program, f"--xml={path}", f"--out={folder / 'out'}", "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    results = folder / "out" / "result.json"
    if done.returncode not in (0, 3) or not results.exists():
        raise RuntimeError(f"exit code {done.returncode}: {done.stderr.strip()}")
    return json.loads(results.read_text())


def no_mechanism(folder, structure, factor, limit):
    """What the mechanism that a run has drawn lacks to prove a collapse at a factor below the limit; empty: nothing."""
    drawn = drawn_mechanism(folder / "out")
    if drawn is None:
        return "no mechanism is drawn"
    motion, gap, slip, shear, place, stone_of = drawn
    speeds = []
    for k, points in enumerate(structure.stones):
        x, y = (place[stone_of == k] - centre_and_area(points)[0]).T
        ones, none = numpy.ones_like(x), numpy.zeros_like(x)
        along = numpy.vstack([numpy.column_stack([ones, none, -y]), numpy.column_stack([none, ones, x])])
        moved = motion[stone_of == k].T.ravel()
        speeds.append(numpy.linalg.lstsq(along, moved, rcond=None)[0])
        if abs(along @ speeds[-1] - moved).max() > NOTICEABLE:
            return f"stone {k} deforms in the mechanism"

    def power(stone, place, force):
        across, up = (p - m for p, m in zip(place, centre_and_area(structure.stones[stone])[0]))
        x, y, turn = speeds[stone]
        return force[0] * (x - turn * up) + force[1] * (y + turn * across)

    weighs = [-m * scenes.GRAVITY * v[1] for m, v in zip(structure.masses(), speeds)]
    gains = sum(weighs) + factor * sum(power(*force) for force in structure.raised())
    if gains < abs(shear * slip).sum() - NOTICEABLE * numpy.abs(weighs).sum():
        return "loads do not gain enough along the mechanism"
    if gap.min() < -NOTICEABLE:
        return "stones move into each other in the mechanism"
    if factor < (1 - 1.5 * ACCURACY) * limit and (structure.friction * abs(slip) - gap).max() < ASLANT:
        return "a mechanism of hinges alone below the limit"
    return ""


def judged(program, folder, structure):
    """What is wrong, and what came out."""
    limit = structure.limit()
    result = run(program, folder / "search", structure.scene())
    if limit is None:
        stands = result["outcome"] not in ("collapse", "not_converged") or "collapse" in result
        return "stands" if stands else "", "falls under its weight"
    if "collapse" not in result:
        return f"no search: {result['outcome']}: {result.get('message', '')}", ""
    found = result["collapse"]
    certified, lower = found["certified_upper"], found["lower"]
    highest = max([lower] + [a["factor"] for a in found["attempts"] if a["outcome"] == "equilibrium"])
    told = f"stands at {lower:.5g}, certified {certified}, own {limit:.7g}, {result['outcome']}"
    if limit >= LARGEST * (1 - SAME):
        return ("a certificate where there is no limit" if certified is not None else ""), told
    if certified is None:
        return "no certificate", told
    if abs(certified - limit) > SAME * max(1.0, limit):
        return "another limit", told
    if highest > certified * (1 + SAME) + SAME:
        return "an equilibrium above the limit", told
    if found["upper"] < certified:
        lacking = no_mechanism(folder / "search", structure, found["upper"], limit)
        if lacking:
            return lacking, told
    if structure.rough and structure.kind != "wall" and lower < (1 - 1.5 * ACCURACY) * found["upper"] - SAME:
        return "the bracket is wide", told
    beyond = run(program, folder / "beyond", structure.scene(certified * (1 + BEYOND) + BEYOND / 10))
    if beyond["outcome"] not in ("collapse", "not_converged"):
        return f"an equilibrium beyond the limit: {beyond['outcome']}", told
    return "", told + ("" if beyond["outcome"] == "collapse" else ", undecided beyond")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=15)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="folder in which scenes and results stay")
    asked = parser.parse_args()
    wrong = 0
    with tempfile.TemporaryDirectory() as temporary:
        for seed in range(asked.first, asked.first + asked.count):
            structure = Random(seed)
            problem, told = judged(asked.program, (asked.keep or pathlib.Path(temporary)) / str(seed), structure)
            print(f"{seed}: {structure}: {told}{': WRONG, ' + problem if problem else ''}", flush=True)
            wrong += bool(problem)
    print(f"{wrong} of {asked.count} are wrong.")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()

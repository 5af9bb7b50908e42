"""Random structures of stones in space, pushed any way: what limit analysis says against what elastic stones do.

Walls in bond, corners of two walls, stacks with inclined beds, arches, vaults in bond, flat arches and tables are drawn
by their stones in a file, turned by any angle, in any unit, with any axis upwards and its stones in any order; one stone
is lighter or heavier. Asked of every structure:
- the bracket of limit analysis is narrow and meets that of a linear programme of this test's own, from stones as drawn;
- no elastic equilibrium is found above it, neither by the search nor by a load step just beyond it;
- what is called a collapse below it is one: in the mechanism stones move as wholes, none into another, and loads gain
  more along it than friction takes;
- what no forces balance under its own weight is refused.

    certificates_in_space.py PROGRAM MPIEXEC [--count N] [--first SEED] [--keep FOLDER]
"""

import argparse
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import time

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "ground"), str(HERE.parent / "support")]
import program  # noqa: E402  (folders of their own)
import solids  # noqa: E402
from drawn_mechanism import drawn_mechanism  # noqa: E402
from rigid_in_space import RigidStonesInSpace, centre_and_volume  # noqa: E402
from stones import xml  # noqa: E402

GRAVITY, DENSITY = 9.81, 2000.0
LARGEST = 20.0  # factor tried
ACCURACY = 0.01  # of a search
LINES = 48  # of the test's own pyramids: those around cones are 0.2 % wider than those within
NARROW = 3e-3  # between the two ends of the program's bracket, relative to it or to friction, of which it is the difference to a slope
SAME = 1e-6  # of two programmes, relative
BEYOND = 0.003  # above the limit, where no step may find an equilibrium
NOTICEABLE = 0.05  # of the largest motion of a mechanism
LONGEST = 900  # [s] of a run


def wall(r):
    """Joints of every other course lie at a quarter to three quarters of the stones below."""
    l, h, t = r.uniform(0.4, 0.8), r.uniform(0.2, 0.4), r.uniform(0.2, 0.6)
    stones, count, courses = {}, r.randint(2, 3), r.randint(2, 4)
    for c in range(courses):
        ends = [l * k for k in range(count + 1)]
        if c % 2:
            shift = l * r.uniform(0.25, 0.75)
            ends = [0.0, *(l * k + shift for k in range(count)), l * count]
        for k, (a, b) in enumerate(zip(ends, ends[1:])):
            stones[f"stone {c} {k}"] = solids.box((a, 0, c * h), (b, t, (c + 1) * h))
    return stones


def corner(r):
    """Two walls of one or two stones a course, whose corner belongs to one and the other in turn."""
    t, h, courses = r.uniform(0.2, 0.4), r.uniform(0.2, 0.4), r.randint(2, 4)
    lengths = [t * r.uniform(2, 4) for _ in "ab"]
    stones = {}
    for c in range(courses):
        for side, length in enumerate(lengths):
            begin = t if (c + side) % 2 else 0.0
            for k, (a, b) in enumerate([(begin, length)] if c % 2 else [(begin, 0.6 * length), (0.6 * length, length)]):
                low, high = [0.0, 0.0, c * h], [t, t, (c + 1) * h]
                low[side], high[side] = a, b
                stones[f"stone {c} {side} {k}"] = solids.box(low, high)
    return stones


def stack(r):
    """Four upright sides, and beds inclined to any side."""
    a, b, z, beds = r.uniform(0.5, 1.0), r.uniform(0.5, 1.0), 0.0, [(0.0, 0.0)]
    stones = {}
    for k in range(r.randint(2, 5)):
        beds.append((r.uniform(-0.2, 0.2), r.uniform(-0.2, 0.2)))
        levels = z, z + r.uniform(0.4, 0.7)
        points = [(x, y, level + u * x + v * y) for level, (u, v) in zip(levels, beds[-2:])
                  for y in (-b / 2, b / 2) for x in (-a / 2, a / 2)]
        stones[f"drum {k}"] = points, solids.box((0, 0, 0), (1, 1, 1))[1]
        z = levels[1]
    return stones


def arch(r):
    radius = r.uniform(1.0, 2.0)
    return solids.arch(radius, radius * r.uniform(0.1, 0.35), r.uniform(0.3, 1.0), r.randint(4, 9))


def vault(r):
    """An arch whose rings are two or three stones wide, in bond."""
    radius, width, voussoirs = r.uniform(1.0, 2.0), r.uniform(0.8, 1.6), r.randint(4, 7)
    thickness = radius * r.uniform(0.15, 0.35)
    stones = {}
    for k in range(voussoirs):
        ring = solids.arch(radius, thickness, width, voussoirs)[f"voussoir {k}"]
        cuts = [0.0, 0.5, 1.0] if k % 2 else [0.0, 0.25, 0.75, 1.0]
        for j, (low, high) in enumerate(zip(cuts, cuts[1:])):
            points = [(x, width * (low if y == 0 else high), z) for x, y, z in ring[0]]
            stones[f"voussoir {k} {j}"] = points, ring[1]
    return stones


def flat_arch(r):
    """Wedges between two piers, with joints that lean to a centre below."""
    n, span, h, t, depth = 2 * r.randint(1, 3) + 1, r.uniform(0.8, 1.6), r.uniform(0.3, 0.5), r.uniform(0.3, 0.6), 0.5
    centre, w = -span * r.uniform(0.6, 1.5), r.uniform(0.4, 0.8)
    low = [span * (k / n - 0.5) for k in range(n + 1)]
    high = [x * (h - centre) / -centre for x in low]
    out = max(high) + w
    stones = {f"wedge {k}": solids.prism([(low[k], 0), (low[k + 1], 0), (high[k + 1], h), (high[k], h)], 0.0, t)
              for k in range(n)}
    for side, (a, b) in (("left", (low[0], high[0])), ("right", (low[-1], high[-1]))):
        s = -1 if a < 0 else 1
        stones[f"skewback {side}"] = solids.prism([(s * out, 0), (a, 0), (b, h), (s * out, h)][::-s], 0.0, t)
        stones[f"pier {side}"] = solids.box((min(a, s * out), 0, -depth), (max(a, s * out), t, 0))
    return stones


def table(r):
    """A slab on three legs."""
    a, b, w, h, t = r.uniform(1.0, 1.5), r.uniform(0.8, 1.2), r.uniform(0.25, 0.35), r.uniform(0.4, 0.8), r.uniform(0.2, 0.3)
    at = [(0, 0), (a - w, 0), ((a - w) * r.uniform(0.2, 0.8), b - w)]
    stones = {f"leg {k}": solids.box((x, y, 0), (x + w, y + w, h)) for k, (x, y) in enumerate(at)}
    stones["slab"] = solids.box((0, 0, h), (a, b, h + t))
    return stones


KINDS = [wall, corner, stack, arch, vault, flat_arch, table]


class Pushed:
    """One structure and the way it is pushed."""

    def __init__(self, seed):
        r = self.random = random.Random(seed)
        kind = KINDS[seed % len(KINDS)]
        self.kind, self.stones = kind.__name__, kind(r)
        self.friction = r.choice([r.uniform(0.2, 1.0), 0.7, 2.0])
        self.mode, self.ranks = r.choice(["all", "adaptive"]), r.choice([1, 1, 2])
        self.heavy, self.times = r.choice(list(self.stones)), 10**r.uniform(-1, 1)
        angle, up = r.choice([r.uniform(0, 2 * math.pi), math.pi / 2 * r.randrange(4)]), r.choice([0.0, r.uniform(-1, 1)])
        self.push = numpy.array([math.cos(angle), math.sin(angle), up])  # [g], in the axes of the stones as drawn here
        self.turned, self.unit, self.up = r.uniform(0, 2 * math.pi), 10**r.uniform(-3, 1), r.choice("xyz")
        self.size = r.choice([0.3, 0.6])  # [m] of cells: the limit does not depend on it
        lowest = min(p[2] for points, _ in self.stones.values() for p in points)
        self.held = [name for name, (points, faces) in self.stones.items()
                     if any(all(points[k][2] < lowest + 1e-9 for k in face) for face in faces)]
        self.solid = {name: centre_and_volume(stone) for name, stone in self.stones.items()}

    def __str__(self):
        return (f"{self.kind} of {len(self.stones)}, friction {self.friction:.3f}, {self.mode}, "
                f"push {' '.join(f'{p:.2f}' for p in self.push)}, {self.ranks} ranks")

    def mass(self, name):
        return (self.times if name == self.heavy else 1.0) * DENSITY * self.solid[name][1]

    def forces(self, of):
        """Of an acceleration [g] on every stone."""
        return [(name, self.solid[name][0], self.mass(name) * GRAVITY * numpy.array(of)) for name in self.stones]

    def bracket(self):
        """Of the test's own programme; None where the weight cannot be borne."""
        rigid = RigidStonesInSpace(self.stones, self.held, self.friction)
        weight = self.forces((0.0, 0.0, -1.0))
        if rigid.largest_factor(weight, self.forces(self.push), 1e-9, LINES, False) is None:
            return None
        return [rigid.largest_factor(weight, self.forces(self.push), LARGEST, LINES, around) for around in (False, True)]

    def scene(self, factor=None):
        c, s = math.cos(self.turned), math.sin(self.turned)
        x, y, z = (GRAVITY * float(p) for p in self.push)
        stone = {"Young modulus": 1e10, "Poisson ratio": 0.2, "density": DENSITY}
        stages = {"own weight": {"loads": {"weight": 1.0}}}
        tree = {"mesh": {"type": "stones", "stones": {"file": "stones.obj", "unit": self.unit, "up": self.up,
                                                            "element size": self.size}},
                "materials": {"stone": stone, "heavy": {**stone, "density": self.times * DENSITY, "blocks": self.heavy}},
                "joints": {"dry": {"friction coefficient": self.friction}},
                "supports": {"ground": {"on": "base"}},
                "loads": {"weight": {"type": "self weight", "gravity": GRAVITY},
                          "push": {"type": "acceleration", "ax": c * x - s * y, "ay": s * x + c * y, "az": z}},
                "steps": {"expect collapse": True, "stages": stages},
                "selection": {"mode": self.mode}, "output": {"report": False}}
        if factor is None:
            tree["load factor"] = {"pattern": {"push": 1.0}, "largest factor": LARGEST, "accuracy": ACCURACY}
        else:
            stages["beyond"] = {"loads": {"push": factor}}
        return tree

    def run(self, folder, *options, factor=None):
        folder.mkdir(parents=True, exist_ok=True)
        # Every run has its stones in an order of its own.
        drawn = solids.drawn(self.stones, self.random, turned=self.turned, unit=self.unit, up=self.up)
        (folder / "stones.obj").write_text(drawn, encoding="utf-8")
        (folder / "scene.xml").write_text(xml("pushed", self.scene(factor)) + "\n", encoding="utf-8")
        run = program.run(folder / "scene.xml", folder / "out", *options, ranks=self.ranks, seconds=LONGEST)
        if run.code not in (0, 3) or not run.result:
            raise RuntimeError(f"exit code {run.code}: {run.words[:900]}")
        return run

    def no_mechanism(self, run, factor):
        """What the mechanism that a run has drawn lacks to prove a collapse at that factor; empty: nothing."""
        drawn = drawn_mechanism(run.folder)
        if drawn is None:
            return "no mechanism is drawn"
        motion, gap, slip, shear, place, stone_of = drawn
        c, s = math.cos(self.turned), math.sin(self.turned)
        turn = numpy.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        gains = weighs = 0.0
        middles = {name: turn @ self.solid[name][0] + solids.MOVED for name in self.stones}
        for k in range(stone_of.max() + 1):
            at, moved = place[stone_of == k], motion[stone_of == k]
            inside = (at.min(axis=0) + at.max(axis=0)) / 2
            name = min(middles, key=lambda n: numpy.linalg.norm(middles[n] - inside))
            middle = middles.pop(name)
            along = numpy.zeros((len(at), 3, 6))
            along[:, :, :3] = numpy.eye(3)
            for axis in range(3):
                along[:, :, 3 + axis] = numpy.cross(numpy.eye(3)[axis], at - middle)
            speed = numpy.linalg.lstsq(along.reshape(-1, 6), moved.ravel(), rcond=None)[0]
            if abs(along.reshape(-1, 6) @ speed - moved.ravel()).max() > NOTICEABLE:
                return f"{name} deforms in the mechanism"
            weight = self.mass(name) * GRAVITY * numpy.array([0.0, 0.0, -1.0])
            gains += (weight + self.mass(name) * GRAVITY * factor * (turn @ self.push)) @ speed[:3]
            weighs += abs(weight @ speed[:3])
        friction = abs((shear * slip).reshape(len(gap), -1).sum(axis=1)).sum()
        if gains < friction - NOTICEABLE * weighs:
            return f"loads gain {gains:.3g} along the mechanism, where friction takes {friction:.3g}"
        if gap.min() < -NOTICEABLE:
            return "stones move into each other in the mechanism"
        return ""

    def judged(self, folder):
        """What is wrong, and what came out."""
        own = self.bracket()
        limits = self.run(folder / "limits", "--limit-analysis")
        search = self.run(folder / "search")
        if own is None:
            stands = [r.outcome for r in (limits, search)
                      if r.outcome not in ("collapse", "not_converged") or "collapse" in r.result]
            return f"stands: {stands}" if stands else "", "falls under its weight"
        if "collapse" not in search.result:
            return f"no search: {search.outcome}: {search.result.get('message', '')}", f"own {own}"
        found = search.result["collapse"]
        certified, lower = found["certified_upper"], found["lower"]
        told = (f"stands at {lower:.5g}, falls at {found['upper']}, certified {certified}, own {own[0]:.6g} to {own[1]:.6g}, "
                f"{search.outcome}")
        if own[0] >= LARGEST * (1 - SAME):
            return ("a certificate where there is no limit" if certified is not None else ""), told
        if certified is None:
            return "no certificate" if own[1] < LARGEST else "", told
        if certified < own[0] * (1 - SAME) - SAME:
            return "a certificate below forces that balance", told
        least, most = limits.result["rigid"]["forces_found_up_to"], limits.result["collapse"]["certified_upper"]
        told += f", limit analysis {least:.6g} to {most:.6g}"
        if least > own[1] * (1 + SAME) + SAME or most < own[0] * (1 - SAME) - SAME:
            return "another limit", told
        if most - least > NARROW * max(most, self.friction):
            return "a wide bracket", told
        highest = max([lower] + [a["factor"] for a in found["attempts"] if a["outcome"] == "equilibrium"])
        if highest > own[1] * (1 + SAME) + SAME:
            return "an equilibrium above the limit", told
        if found["upper"] is not None and found["upper"] < own[0]:
            lacking = self.no_mechanism(search, found["upper"])
            if lacking:
                return lacking, told
        beyond = self.run(folder / "beyond", factor=float(own[1]) * (1 + BEYOND) + BEYOND / 10)
        if beyond.outcome not in ("collapse", "not_converged"):
            return f"an equilibrium beyond the limit: {beyond.outcome}", told
        return "", told + ("" if beyond.outcome == "collapse" else ", undecided beyond")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("mpiexec")
    parser.add_argument("--count", type=int, default=7)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--keep", type=pathlib.Path, help="folder in which scenes and results stay")
    asked = parser.parse_args()
    program.PROGRAM, program.MPIEXEC = asked.program, asked.mpiexec
    wrong = 0
    with tempfile.TemporaryDirectory() as temporary:
        for seed in range(asked.first, asked.first + asked.count):
            pushed, start = Pushed(seed), time.monotonic()
            try:
                problem, told = pushed.judged((asked.keep or pathlib.Path(temporary)) / str(seed))
            except (RuntimeError, subprocess.TimeoutExpired) as error:
                problem, told = str(error), ""
            print(f"{seed}: {pushed}: {told}{': WRONG, ' + problem if problem else ''} ({time.monotonic() - start:.0f} s)",
                  flush=True)
            wrong += bool(problem)
    print(f"{wrong} of {asked.count} are wrong.")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()

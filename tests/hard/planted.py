"""Random structures with a stone planted in them that nothing but the bond of its joint would hold: none may stand.

A structure is a pier of courses, a wall without bond or an arch; it stands. The planted stones hang, slide, tip or are
a wedge that opens downwards, alone or several together, and weigh a millionth to a tenth of the structure. They must
fall in load steps, at the load factor that theory tells, when the prop below them goes, and in time.

A run that comes to no decision says so, which is no wrong answer; an equilibrium is.

    planted.py PROGRAM [--count N] [--first SEED] [--mode adaptive]
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "ground"))

import scenes  # noqa: E402  (modules of the folder above)
from drawing import Drawing  # noqa: E402

GRAVITY = scenes.GRAVITY
# A step of a search is so much of a factor; a mesh of two cells lets a stone tip within a few percent of theory.
FACTOR_TOLERANCE = 0.05
DURATION, TIME_STEP = 0.2, 0.002  # [s]


class Structure:
    """What the planted stones hang from or stand on: a slab on courses, or a ring of voussoirs; and its drawing."""

    def __init__(self, random_numbers):
        r = self.random = random_numbers
        self.drawing = Drawing(r.choice([0.25, 0.5]), cells="triangle")
        self.kind = r.choice(["pier", "wall", "arch"])
        # [m] of a planted stone; three of them fit on the smallest keystone.
        self.size = r.uniform(0.05, 0.1 if self.kind == "arch" else 0.3)
        self.area = 0.0

    def draw(self, below, above):
        """Draws it with corners at places below an overhang and above; returns the heights of both faces.

        below, above are functions of the left end and the height of a face that give further corners there.
        """
        if self.kind == "arch":
            return self.ring(below, above)
        r = self.random
        columns, rows = (1, r.randint(1, 5)) if self.kind == "pier" else (r.randint(2, 5), r.randint(2, 5))
        width, height, thickness = r.uniform(0.8, 2.0), r.uniform(0.4, 1.0), r.uniform(0.4, 1.0)
        xs = [width * k for k in range(columns + 1)]
        ys = [height * k for k in range(rows + 1)]
        for i in range(columns):
            for j in range(rows):
                self.stone([(xs[i], ys[j]), (xs[i + 1], ys[j]), (xs[i + 1], ys[j + 1]), (xs[i], ys[j + 1])])
            self.name((xs[i], 0.0), (xs[i + 1], 0.0))
        left, low, high = xs[-1] + 0.1, ys[-1], ys[-1] + thickness
        end = left + 3 * self.size
        bottom = [(x, low) for x in xs] + below(left, low) + [(end, low)]
        top = above(xs[0] + 0.1, high)
        self.stone(bottom + [(end, high)] + top[::-1] + [(0.0, high)])
        return (left, low), (xs[0] + 0.1, high)

    def ring(self, below, above):
        r = self.random
        count, radius, thickness = 2 * r.randint(3, 6) + 1, r.uniform(2.0, 4.0), r.uniform(0.5, 0.8)

        def at(rho, k):
            angle = math.pi * (1 - k / count)
            return (rho * math.cos(angle), rho * math.sin(angle) + 0.5)

        crown = count // 2
        (west, low), (east, _) = at(radius, crown), at(radius, crown + 1)
        (high_west, high), (high_east, _) = at(radius + thickness, crown), at(radius + thickness, crown + 1)
        margin = (east - west) / 8
        for k in range(count):
            inner, outer = [at(radius, k), at(radius, k + 1)], [at(radius + thickness, k + 1), at(radius + thickness, k)]
            if k == crown:  # its chords are level, so that further corners are on its sides
                inner = [(west, low)] + below(west + margin, low) + [(east, low)]
                outer = [(high_east, high)] + above(west + margin, high)[::-1] + [(high_west, high)]
            self.stone(inner + outer)
        self.name(at(radius + thickness, 0), at(radius, 0))
        self.name(at(radius, count), at(radius + thickness, count))
        return (west + margin, low), (west + margin, high)

    def name(self, a, b):
        self.drawing.name("ground", *((round(x, 9), round(y, 9)) for x, y in (a, b)))

    def stone(self, points, sets=("host",)):
        rounded = [(round(x, 9), round(y, 9)) for x, y in points]
        area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(rounded, rounded[1:] + rounded[:1])) / 2
        if sets == ("host",):
            self.area += area
        self.drawing.stone(rounded, corners=(), sets=sets)
        return area


class Planted:
    """One scene: a structure, what is planted in it, and what must come of it."""

    def __init__(self, seed):
        r = self.random = random.Random(seed)
        self.host = Structure(r)
        self.way = r.choice(["hangs", "slides", "tips", "wedge"])
        self.task = r.choice(["load step", "load factor", "construction", "time"])
        if self.task == "construction":
            self.way = "hangs"
        if self.task == "load factor":
            self.way = r.choice(["slides", "tips"])
        if self.task == "time" and self.way == "tips":
            self.way = "slides"
        self.count = r.randint(1, 3)
        if self.way == "wedge":
            self.count = 1
        self.share = 10**r.uniform(-6, -1)  # of the weight of the structure
        self.push = r.uniform(0.1, 0.3)  # [g], well below what tips the structure
        self.friction = self.push * r.uniform(0.2, 0.85)  # of planted stones that slide
        self.areas = 0.0
        self.draw()

    def __str__(self):
        return f"{self.count} x {self.way}, {self.task}, {self.host.kind}, weight {self.share:.1e}"

    def draw(self):
        s, stone = self.host.size, self.host.stone
        height = s if self.way in ("hangs", "wedge") else s * self.random.uniform(0.5, 1.0)
        width = s
        if self.way == "tips":
            width = min(s, 0.6 * self.push * height * self.count)
        self.width = width
        ends = [0.0, width]
        if self.way == "wedge":
            ends = [0.0, width, 2 * width, 3 * width]

        def corners(left, y):
            return [(left + x, y) for x in ends]

        def none(_left, _y):
            return []

        on_top = self.way in ("slides", "tips", "wedge")
        (left, low), (left_above, high) = self.host.draw(none if on_top else corners, corners if on_top else none)
        if self.way == "hangs":
            for k in range(self.count):
                top, bottom = low - k * height, low - (k + 1) * height
                self.areas += stone([(left, bottom), (left + width, bottom), (left + width, top), (left, top)], ("loose",))
            if self.task == "construction":
                stone([(left, 0.0), (left + width, 0.0), (left + width, bottom), (left, bottom)], ("prop",))
                self.host.name((left, 0.0), (left + width, 0.0))
        elif self.way in ("slides", "tips"):
            for k in range(self.count):
                y = high + k * height
                self.areas += stone([(left_above, y), (left_above + width, y), (left_above + width, y + height),
                                     (left_above, y + height)], ("loose",))
        else:  # two posts with sides that lean apart downwards, and a stone between their upper halves
            a, y, lean = left_above, high, 0.1 * width
            for x, inner, sign in ((a, a + width, 1), (a + 3 * width, a + 2 * width, -1)):
                points = [(x, y), (inner, y), (inner + sign * lean / 2, y + height / 2), (inner + sign * lean, y + height),
                          (x, y + height)]
                stone(points if sign > 0 else points[::-1], ("posts",))
            self.areas += stone([(a + width + lean / 2, y + height / 2), (a + 2 * width - lean / 2, y + height / 2),
                                 (a + 2 * width - lean, y + height), (a + width + lean, y + height)], ("loose",))

    def scene(self, mode):
        slides = self.way == "slides"
        density = self.share * self.host.area / self.areas * scenes.STONE["density"]
        result = scenes.scene(self.host.drawing, friction=0.7, selection={"mode": mode})
        result["materials"]["loose"] = {**scenes.STONE, "density": density, "blocks": "loose"}
        result["joints"]["bed"] = {"friction coefficient": self.friction if slides else 0.7,
                                   "between": "host", "and": "loose"}
        if self.way == "wedge":
            result["materials"]["posts"] = {**scenes.STONE, "blocks": "posts"}
            result["joints"]["posts"] = {"friction coefficient": 0.05, "between": "posts", "and": "loose"}
        result["loads"]["push"] = {"type": "acceleration", "ax": GRAVITY}
        pushed = {"push": self.push} if self.way in ("slides", "tips") else {}
        if self.task == "load step":
            result["steps"]["stages"] = {"own weight": {"loads": {"weight": 1.0}}}
            if pushed:
                result["steps"]["stages"]["push"] = {"loads": pushed}
        elif self.task == "load factor":
            result["load factor"] = {"pattern": {"push": 1.0}, "largest factor": 2.0}
        elif self.task == "construction":
            result["steps"]["stages"] = {"propped": {"loads": {"weight": 1.0}}, "free": {"loads": {"weight": 1.0}}}
            result["construction"] = {"prop": {"blocks": "prop", "disappears": "free"}}
        else:
            result["steps"]["stages"] = {"falls": {"duration": DURATION, "time step": TIME_STEP, "at once": True,
                                                   "loads": {"weight": 1.0, **pushed}}}
            result["observations"] = {"stone": {"place": "mean", "blocks": "loose"}}
        return result

    undecided = False  # the program found neither an equilibrium nor a mechanism, and says so

    def verdict(self, result):
        """What is wrong with a result, or nothing."""
        if self.task == "time":
            acceleration = (self.push - self.friction if self.way == "slides" else 1.0) * GRAVITY
            expected = acceleration * DURATION**2 / 2
            moved = result["largest_displacement_m"]
            return "" if moved > 0.5 * expected else f"moved {moved:.3g} m, not {expected:.3g}"
        if result["outcome"] == "not_converged":
            self.undecided = True
            return ""
        if result["outcome"] != "collapse":
            return f"{result['outcome']}: {result.get('message', '')}"
        if self.task == "load factor":
            limit = self.friction if self.way == "slides" else min(0.7, self.width**2 / self.areas)
            upper = result["collapse"]["upper"]
            # What a step leaves out of balance: the program's tolerance of the forces of the whole structure.
            left = 2e-8 / self.share
            stands = result["collapse"]["lower"] > (1 + FACTOR_TOLERANCE) * limit + left
            return f"stands at {upper}, not {limit}" if stands else ""
        return ""

    def run(self, program, folder, mode):
        folder.mkdir()
        path = scenes.write(self.scene(mode), folder)
        command = [program, f"--xml={path}", f"--out={folder / 'out'}", "--quiet"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=600)
        results = folder / "out" / "result.json"
        if done.returncode not in (0, 3) or not results.exists():
            return f"exit code {done.returncode}: {done.stderr.strip()}"
        return self.verdict(json.loads(results.read_text()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=25)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--mode", default="adaptive")
    parser.add_argument("--keep", type=pathlib.Path, help="folder in which scenes and results stay")
    asked = parser.parse_args()
    wrong = undecided = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = asked.keep or pathlib.Path(temporary)
        for seed in range(asked.first, asked.first + asked.count):
            planted = Planted(seed)
            problem = planted.run(asked.program, folder / str(seed), asked.mode)
            print(f"{seed}: {planted}: {problem or ('undecided' if planted.undecided else 'falls')}", flush=True)
            wrong += bool(problem)
            undecided += planted.undecided
    print(f"{wrong} of {asked.count} stand or are wrong, {undecided} undecided.")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()

"""Random structures with a stone planted in them that nothing but the bond of its joint would hold: none may stand.

A structure (ground/hosts.py) is a pier of courses, a wall without bond or in running bond, an arch or a bridge. The
planted stones hang, slide, tip or are a wedge that opens downwards, alone or several together, and weigh a millionth to
a tenth of the structure. They must fall in load steps, at the load factor that theory tells, when the prop below them
goes, and in time; what falls must be they. Any 50 seeds in a row are each kind of structure once with each way and task;
25 are each of both.

The structure without them must stand under all they are given (--hosts), or else a fall would say nothing.

A run that comes to no decision says so, which is no wrong answer; an equilibrium is.

    planted.py PROGRAM [--count N] [--first SEED] [--mode adaptive] [--hosts]
"""

import csv
import json
import math
import pathlib
import random
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "ground"))

import hosts  # noqa: E402  (modules of the folder above)
import scenes  # noqa: E402
import seeds  # noqa: E402

GRAVITY = scenes.GRAVITY
# A step of a search is so much of a factor; a mesh of two cells lets a stone tip within a few percent of theory.
FACTOR_TOLERANCE = 0.05
DURATION, TIME_STEP = 0.2, 0.002  # [s]
SHAKEN = 0.1  # of the way of the stones: less than that a structure alone moves in time
NARROWEST = 0.03  # [m] of a stone that tips: cells below it, as high as a course, are no slivers (1 degree)
LONGEST = 600  # [s] of a run
WAYS = [(way, task) for way, tasks in {"hangs": ("load step", "construction", "time"),
                                       "slides": ("load step", "load factor", "time"),
                                       "tips": ("load step", "load factor"),
                                       "wedge": ("load step", "time")}.items() for task in tasks]


class Planted:
    """One scene: a structure, what is planted in it, and what must come of it."""

    def __init__(self, seed):
        r = self.random = random.Random(seed)
        turn, kind = divmod(seed, len(hosts.KINDS))
        self.kind = list(hosts.KINDS)[kind]
        self.way, self.task = WAYS[(turn + 2 * kind) % len(WAYS)]
        self.host = hosts.KINDS[self.kind](r, pushed=self.way in ("slides", "tips"))
        self.count = 1 if self.way == "wedge" else r.randint(1, 3)
        self.share = 10**r.uniform(-6, -1)  # of the weight of the structure
        self.push = r.uniform(*self.host.push)  # [g]
        self.friction = self.push * r.uniform(0.2, 0.85)  # of planted stones that slide
        self.areas = 0.0
        self.draw()

    def __str__(self):
        return f"{self.count} x {self.way}, {self.task}, {self.kind}, weight {self.share:.1e}"

    def draw(self):
        s, on_top = self.host.size, self.way != "hangs"
        self.height = s if self.way in ("hangs", "wedge") else s * self.random.uniform(0.5, 1.0)
        self.width = s
        if self.way == "tips":
            slope = 0.6 * self.push  # of its diagonal
            self.width = max(NARROWEST, min(s, slope * self.height * self.count))
            self.height = max(self.height, self.width / slope / self.count)
        ends = [0.0, self.width]
        if self.way == "wedge":
            ends += [2 * self.width, 3 * self.width]
        self.low, self.high = self.host.draw([] if on_top else ends, ends if on_top else [])
        if self.way == "wedge":
            self.posts()

    def plant(self):
        """Draws what is planted."""
        w, h = self.width, self.height
        if self.way == "wedge":
            lean = 0.1 * w
            self.loose([(w + lean / 2, h / 2), (2 * w - lean / 2, h / 2), (2 * w - lean, h), (w + lean, h)])
            return
        for k in range(self.count):
            self.loose([(0.0, k * h), (w, k * h), (w, (k + 1) * h), (0.0, (k + 1) * h)])
        if self.task == "construction":
            a, b = self.low.at(0.0, self.count * h), self.low.at(w, self.count * h)
            self.host.stone([(a[0], 0.0), (b[0], 0.0), b, a], ("prop",))
            self.host.ground((a[0], 0.0), (b[0], 0.0))

    def loose(self, points):
        """Draws a planted stone, its corners in terms of the face it is planted at."""
        hangs = self.way == "hangs"
        corners = [(self.low if hangs else self.high).at(u, v) for u, v in points]
        self.areas += self.host.stone(corners[::-1] if hangs else corners, ("loose",))

    def posts(self):
        """Draws two posts with sides that lean apart downwards; the wedge is between their upper halves."""
        w, h, lean = self.width, self.height, 0.1 * self.width
        for end, inner, sign in ((0.0, w, 1), (3 * w, 2 * w, -1)):
            points = [(end, 0.0), (inner, 0.0), (inner + sign * lean / 2, h / 2), (inner + sign * lean, h), (end, h)]
            self.host.stone([self.high.at(u, v) for u, v in points[::sign]], ("posts",))

    def scene(self, mode):
        """Of the structure with what is drawn up to now."""
        result = scenes.scene(self.host.drawing, friction=0.7, selection={"mode": mode})
        if self.way == "wedge":
            result["materials"]["posts"] = {**scenes.STONE, "blocks": "posts"}
        result["loads"]["push"] = {"type": "acceleration", "ax": GRAVITY}
        return result

    def stages(self, result, alone=False):
        """Load steps; the structure alone is pushed as far as it is with stones in any task."""
        pushed = {"push": self.push} if self.way in ("slides", "tips") else {}
        if self.task == "time":
            result["steps"]["stages"] = {"falls": {"duration": DURATION, "time step": TIME_STEP, "at once": True,
                                                   "loads": {"weight": 1.0, **pushed}}}
        elif pushed and (alone or self.task == "load step"):
            result["steps"]["stages"] = {**scenes.OWN_WEIGHT, "push": {"loads": pushed}}
        return result

    def planted(self, mode):
        self.plant()
        result = self.stages(self.scene(mode))
        density = self.share * self.host.area / self.areas * scenes.STONE["density"]
        result["materials"]["loose"] = {**scenes.STONE, "density": density, "blocks": "loose"}
        result["joints"]["bed"] = {"friction coefficient": self.friction if self.way == "slides" else 0.7,
                                   "between": "host", "and": "loose"}
        if self.way == "wedge":
            result["joints"]["posts"] = {"friction coefficient": 0.05, "between": "posts", "and": "loose"}
        if self.task == "load factor":
            result["load factor"] = {"pattern": {"push": 1.0}, "largest factor": 2.0}
        elif self.task == "construction":
            result["steps"]["stages"] = {"propped": {"loads": {"weight": 1.0}}, "free": {"loads": {"weight": 1.0}}}
            result["construction"] = {"prop": {"blocks": "prop", "disappears": "free"}}
        elif self.task == "time":
            result["observations"] = {"stone": {"place": "mean", "blocks": "loose"}}
        return result

    undecided = False  # the program found neither an equilibrium nor a mechanism, and says so

    def way_in_time(self):
        """[m] that the stones move, as rigid bodies."""
        return (self.push - self.friction if self.way == "slides" else 1.0) * GRAVITY * DURATION**2 / 2

    def verdict(self, result, history):
        """What is wrong with a result, or nothing."""
        if self.task == "time":
            expected = self.way_in_time()
            moved = math.hypot(*(float(history[-1][f"{u}_m of stone"]) for u in ("ux", "uy")))
            return "" if moved > 0.5 * expected else f"moved {moved:.3g} m, not {expected:.3g}"
        if result["outcome"] == "not_converged":
            self.undecided = True
            return ""
        if result["outcome"] != "collapse":
            return f"{result['outcome']}: {result.get('message', '')}"
        if "(loose)" not in result.get("mechanism", {}).get("largest_mover_name", ""):
            return f"not said to fall: {result['message']}"
        if self.task == "load factor":
            limit = self.friction if self.way == "slides" else min(0.7, self.width**2 / self.areas)
            lower, upper = result["collapse"]["lower"], result["collapse"]["upper"]
            # What a step leaves out of balance: the program's tolerance of the forces of the whole structure.
            left = 2e-8 / self.share
            if lower > (1 + FACTOR_TOLERANCE) * limit + left or upper < (1 - FACTOR_TOLERANCE) * limit:
                return f"stands at {lower} and falls at {upper}, not at {limit}"
        return ""

    def verdict_alone(self, result, _history):
        if self.task == "time":
            moved = result["largest_displacement_m"]
            return "" if moved < SHAKEN * self.way_in_time() else f"moved {moved:.3g} m"
        return "" if result["outcome"] == "equilibrium" else f"{result['outcome']}: {result.get('message', '')}"

    def run(self, program, folder, mode, alone):
        folder.mkdir(parents=True)
        scene = self.stages(self.scene(mode), alone=True) if alone else self.planted(mode)
        command = [program, f"--xml={scenes.write(scene, folder)}", f"--out={folder / 'out'}", "--quiet"]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=LONGEST)
        except subprocess.TimeoutExpired:
            return f"no end within {LONGEST} s"
        results = folder / "out" / "result.json"
        if done.returncode not in (0, 3) or not results.exists():
            return f"exit code {done.returncode}: {done.stderr.strip()}"
        with open(folder / "out" / "history.csv", newline="", encoding="utf-8") as file:
            history = list(csv.DictReader(file))
        return (self.verdict_alone if alone else self.verdict)(json.loads(results.read_text()), history)


def main():
    seeds.judge(__doc__, Planted, lambda planted, asked, folder: planted.run(asked.program, folder, asked.mode, asked.hosts),
                first=1, count=25)


if __name__ == "__main__":
    main()

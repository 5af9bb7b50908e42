"""A wall in space through load steps, time and load steps again, with loads that move and turn: restart, ranks, reactions.

usage: seams_in_space.py PROGRAM MPIEXEC

Set-up    A glued wall under its weight; a cart rolls over it while the ground shakes upwards; then the ground tilts.
Expected  A run that ends after any stage and goes on writes the history of one that did not, to the last bit. One, two and four
          ranks agree. At rest the ground bears the weight; in time it gives in all the impulse of weight, cart and shaking.
Tolerance Ranks and reactions 1e-6 of the largest value of a kind, a hundred times what the solver leaves of forces.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
from stones import xml  # noqa: E402

DENSITY, GRAVITY = 2000.0, 9.81
LENGTH, THICKNESS, HEIGHT, GROUND = 1.2, 0.2, 0.6, 0.2  # [m]
MASS = DENSITY * LENGTH * THICKNESS * (HEIGHT + GROUND)
AXLES = (300.0, 200.0)  # [N]
SPACING, SPEED, FIRST, STEP, DURATION = 0.3, 20.0, 0.7, 5e-4, 0.01  # both axles stand on the wall throughout
SHAKING = 2.0  # [m/s2]
RELATIVE = 1e-6

WEIGHT = {"weight": 1.0}
STAGES = {"own weight": {"loads": WEIGHT},
          "passing": {"duration": DURATION, "time step": STEP, "at once": True, "loads": {**WEIGHT, "cart": 1.0, "shaking": 1.0}},
          "tilted": {"loads": {**WEIGHT, "cart": 0.0, "shaking": 0.0, "tilt": 1.0}}}


def scene(stages):
    mesh = {"courses": 3, "blocks per course": 3, "block length": LENGTH / 3, "block height": HEIGHT / 3, "thickness": THICKNESS,
            "cells along": 2, "cells up": 1, "cells across": 2, "ground height": GROUND}
    loads = {"weight": {"type": "self weight", "gravity": GRAVITY},
             "cart": {"type": "moving train", "on": "top", "axle loads": ", ".join(map(str, AXLES)), "spacings": str(SPACING),
                      "position": FIRST, "speed": SPEED, "y": 0.1, "gauge": 0.11},
             "shaking": {"type": "ground motion", "az": SHAKING},
             "tilt": {"type": "settlement", "support": "ground", "rotation": 1e-4, "axis x": 1.0, "axis z": 0.0}}
    return xml("wall", {
        "mesh": {"type": "wall in space", "wall in space": mesh},
        "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": DENSITY}},
        "joints": {"glued": {"friction coefficient": 0.6, "cohesion": 1e6, "tension strength": 1e6}},
        "supports": {"ground": {"on": "ground"}}, "loads": loads, "selection": {"mode": "all"},
        "observations": {"ground": {"place": "support", "support": "ground"}, "top": {"place": "mean", "blocks": "course 2"}},
        "steps": {"stages": {name: STAGES[name] for name in stages}}}) + "\n"


class SeamsInSpace(program.SceneTest):
    def whole(self, ranks=1):
        run = self.run_scene(scene(STAGES), out=f"whole-{ranks}", ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run

    def test_it_goes_on_after_every_stage(self):
        whole = self.whole()
        names = list(STAGES)
        for k in range(1, len(names)):
            self.run_scene(scene(names[:k]), out="parts", *(["--overwrite"] if k == 1 else ["--restart"]))
        parts = self.run_scene(scene(names), "--restart", out="parts")
        self.assertEqual(parts.outcome, "equilibrium", parts.said)
        self.assertEqual(len(parts.history), len(whole.history))
        for ours, theirs in zip(whole.history, parts.history):
            self.assertEqual({k: repr(v) for k, v in ours.items() if k != "seconds"},
                             {k: repr(v) for k, v in theirs.items() if k != "seconds"})
        self.assertEqual(parts.warnings, whole.warnings)

    def test_ranks_agree_on_what_the_ground_bears(self):
        one = self.whole().history
        weight = MASS * GRAVITY
        for row in (one[0], one[-1]):
            self.assertLess(abs(row["fz_N of ground"] - weight), RELATIVE * weight)
            for c in "xy":
                self.assertLess(abs(row[f"f{c}_N of ground"]), RELATIVE * weight)
        # Of what moves only the course on top is observed, so the mean over the stage is held against a tenth of the cart.
        passing = [row for row in one if row["stage"] == "passing"]
        self.assertEqual(len(passing), round(DURATION / STEP))
        mean = sum(row["fz_N of ground"] for row in passing) / len(passing)
        self.assertLess(abs(mean - weight - sum(AXLES) - MASS * SHAKING), 0.1 * sum(AXLES))
        for ranks in (2, 4):
            other = self.whole(ranks).history
            self.assertEqual(len(other), len(one))
            for kind in ("u", "v", "f"):
                columns = [c for c in one[0] if " of " in c and c[0] == kind]
                size = max(abs(row[c]) for row in one for c in columns if row[c] == row[c])
                for ours, theirs in zip(one, other):
                    for c in columns:
                        if ours[c] == ours[c]:
                            self.assertLess(abs(ours[c] - theirs[c]), RELATIVE * size, f"{c} on {ranks} ranks")


if __name__ == "__main__":
    program.main()

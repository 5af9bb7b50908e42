"""External work is forces times ways, fracture is that of the law, and what is lost in a jump is told.

usage: force_times_way.py PROGRAM MPIEXEC

Set-up    Two stones with a joint that cracks between a plate and the ground: pulled apart on mortar of several stiffnesses and
          on none, sheared in one step, opened and sheared at once, peeled from one side, a soft bar that snaps; dry ones that
          are lowered, pressed and dragged; joints that stand open, and stones that appear and disappear. The plate, the
          ground and the stones are observed.
Expected  An independent sum over the rows of history.csv, mean force times way of supports and loads, is the external work
          less what the run says that joints made of it within steps, and that vanishes with the size of the steps. A joint
          that parts takes its energy times its area. What nobody took is told as lost in a jump, and the work of a plate
          never falls while it moves along its force. What does not touch has no strength.
Tolerance Sums: 1e-9 of the largest energy, ten times the tolerance of the solver. Fracture: 1e-9 of itself. What joints
          make of the work within steps: a hundredth of the work in 200 steps, where a step is a hundredth of the way.
"""

import itertools
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (folder of its own)
import stones  # noqa: E402

TENSION, COHESION, OPENING, SHEAR = 5e4, 1e5, 10.0, 50.0  # [Pa, Pa, J/m2, J/m2]
GLUE = {"friction coefficient": 0.6, "tension strength": TENSION, "cohesion": COHESION, "fracture energy": OPENING,
        "shear fracture energy": SHEAR}
STONE = {"Young modulus": 10e9, "Poisson ratio": 0.0, "density": 2000.0}
SUPPORTS = {"ground": {"on": "ground"}, "plate": {"on": "plate"}}
WAYS = {"up": {"type": "settlement", "support": "plate", "uy": 1.0},
        "along": {"type": "settlement", "support": "plate", "ux": 1.0}}
WEIGHT = 2 * 2000 * 9.81  # N, of two stones of 1 m x 1 m


def mortar(normal):
    return {**GLUE, "normal stiffness": normal, "tangential stiffness": 0.4 * normal}


def two_stones(size=0.5):
    return stones.geo({"below": stones.rectangle(0, 0, 1, 1), "above": stones.rectangle(0, 1, 1, 2)}, size,
                      {"ground": ("below", 0), "plate": ("above", 2)})


def moved(*moves, joint, stone=(), weight=0.0, loads=(), supports=(), **sections):
    """moves: (increments, up, along) [m] of the plate after each stage."""
    stages = {f"move {k}": {"increments": n, "loads": {"weight": weight, "up": up, "along": along}}
              for k, (n, up, along) in enumerate(moves, 1)}
    supports = {**SUPPORTS, **dict(supports)}
    observed = {f"{name} held": {"place": "support", "support": name} for name in supports}
    observed["stones"] = {"place": "mean", "blocks": "all"}
    tree = {"joints": {"dry": joint}, "materials": {"stone": {**STONE, **dict(stone)}},
            "observations": observed, "newton": {"tolerance": 1e-10}}
    return stones.scene("stones.geo", supports, {**WAYS, **dict(loads)}, stages, **{**tree, **sections})


def work_of(rows, supports=("ground", "plate"), weight=0.0):
    """Mean force times way, summed up to every row: of supports, and of a weight from the first stage on."""
    columns = [(f"f{c}_N of {name} held", f"u{c}_m of {name} held") for name in supports for c in "xy"]
    start = {key: 0.0 for pair in columns for key in pair}
    sums, sum_ = [], 0.0
    for last, row in zip([{**start, "load_factor": 0.0, "uy_m of stones": 0.0}, *rows], rows):
        sum_ += sum((last[f] + row[f]) / 2 * (row[u] - last[u]) for f, u in columns)
        first = row["stage"] == "move 1"
        mean = (last["load_factor"] + row["load_factor"]) / 2 if first else 1.0
        sum_ -= mean * weight * (row["uy_m of stones"] - last["uy_m of stones"])
        sums.append(sum_)
    return sums


class ForceTimesWay(program.SceneTest):
    def book(self, scene, name="out", drawing=None, supports=("ground", "plate"), weight=0.0, ranks=1):
        """Energies at the end [J] by their names, with every row's external work checked against forces times ways."""
        run = self.run_scene(scene, drawing=drawing or two_stones(), out=name, ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        rows = run.history
        energies = ("elastic_J", "kinetic_J", "friction_J", "fracture_J", "damping_J", "jump_J")
        most = max(max(abs(row[key]) for key in (*energies, "external_work_J")) for row in rows)
        for row, work in zip(rows, work_of(rows, supports, weight)):
            self.assertLess(abs(row["external_work_J"] - row["work_within_steps_J"] - work), 1e-9 * most)
            left = sum(row[key] for key in energies) - row["external_work_J"]
            self.assertLess(abs(row["imbalance_J"] - left), 1e-12 * most)
        for before, row in itertools.pairwise(rows):
            for key in ("friction_J", "fracture_J", "jump_J"):
                self.assertGreaterEqual(row[key], before[key])
        book = {key.removesuffix("_J"): value for key, value in run.result["energy"].items()}
        print(self._testMethodName, name, {key: float(f"{value:.8g}") for key, value in book.items() if value})
        book["rows"], book["sum"], book["said"] = rows, work_of(rows, supports, weight)[-1], run
        return book

    def whole(self, book, fracture):
        self.assertLess(abs(book["fracture"] - fracture), 1e-9 * fracture)

    def test_a_bed_that_parts_takes_its_energy_whatever_the_steps(self):
        for name, joint, stone, all_steps in (("mortar", mortar(2e9), {}, (4, 40, 200)),
                                              ("soft", mortar(1e9), {"Young modulus": 1e12}, (4, 100)),
                                              ("dry", GLUE, {}, (4, 100)),
                                              ("exponential", {**mortar(2e9), "softening": "exponential"}, {}, (4, 60))):
            for steps in all_steps:
                way = 6e-4 if name != "exponential" else 6e-3  # leaves 1e-12 of the strength
                with self.subTest(name, steps=steps):
                    book = self.book(moved((steps, way, 0), joint=joint, stone=stone), f"{name} {steps}")
                    self.whole(book, OPENING)
                    self.assertLess(abs(book["external_work"] / OPENING - 1), 1e-6 if steps == 4 else 1e-3)
                    self.assertLess(abs(book["imbalance"] + book["jump"]), 1e-3 * OPENING)
                    if steps >= 100:
                        self.assertLess(abs(book["sum"] / OPENING - 1), 1e-2)

    def test_shear_in_one_step_costs_what_it_does_in_many(self):
        press, slip = -4e-5, 2e-3
        for name, joint in (("dry", GLUE), ("mortar", mortar(2e10))):
            books = [self.book(moved((1, press, 0), (steps, press, slip), joint=joint), f"{name} {steps}")
                     for steps in (1, 40)]
            for book in books:
                self.whole(book, SHEAR)
                self.assertLess(abs(book["external_work"] / books[-1]["sum"] - 1), 1e-2)
                self.assertLess(abs(book["imbalance"]), 1e-3 * SHEAR)

    def test_a_bed_that_opens_and_slips_at_once(self):
        books = [self.book(moved((steps, 6e-4, 1.2e-3), joint=mortar(2e10)), f"{steps}") for steps in (4, 100)]
        for book in books[1:]:
            self.assertLess(abs(book["external_work"] / books[-1]["sum"] - 1), 1e-2)
            self.assertLess(abs(book["fracture"] / books[-1]["fracture"] - 1), 1e-2)
            self.assertLess(abs(book["imbalance"] + book["jump"]), 1e-2 * book["fracture"])

    def test_there_and_back_and_there(self):
        moves = [(5, up * 1e-5, 0) for up in (12, 3, 25, -2, 60)]
        for joint in (GLUE, mortar(2e9)):
            book = self.book(moved(*moves, joint=joint), "mortar" if len(joint) > len(GLUE) else "dry")
            self.whole(book, OPENING)

    def snap(self, steps, ranks=1):
        joint = {**GLUE, "tension strength": 1e5, "cohesion": 2e5, "fracture energy": 60.0, "shear fracture energy": 1e3}
        drawing = stones.geo({"below": stones.rectangle(0, 0, 0.5, 1), "above": stones.rectangle(0, 1, 0.5, 2)}, 0.25,
                             {"ground": ("below", 0), "plate": ("above", 2)})
        scene = moved((steps, 5e-3, 0), joint=joint, stone={"Young modulus": 1e8})
        return self.book(scene, f"{steps} on {ranks}", drawing, ranks=ranks)

    def test_a_bar_that_snaps_loses_in_a_jump_what_its_glue_did_not_take(self):
        # At 50 kN it has stored 50 J, of which the glue takes 60 J/m2 of 0.5 m2; a step is at most 50 kN times its way.
        for steps, ranks in ((40, 1), (60, 2)):
            book = self.snap(steps, ranks)
            step = 50e3 * 5e-3 / steps
            self.whole(book, 30.0)
            self.assertLess(abs(book["external_work"] - 50), step)
            self.assertLess(abs(book["jump"] - 20), step)
            self.assertLess(abs(book["imbalance"]), 1e-6)
            self.assertEqual(book["said"].warnings, ["lost_in_jump"])
            for before, row in itertools.pairwise(book["rows"]):
                self.assertGreater(row["external_work_J"], before["external_work_J"] - 1e-9)

    def test_two_leaves_that_peel(self):
        below, above = [(0, 0), (2, 0), (2, 0.2), (0, 0.2), (0, 0.1)], [(0, 0.2), (2, 0.2), (2, 0.4), (0, 0.4), (0, 0.3)]
        drawing = stones.geo({"below": stones.polygon(below), "above": stones.polygon(above)}, 0.1,
                             {"ground": ("below", 4), "plate": ("above", 3)})
        supports = {"ground": {"on": "ground", "components": "y"}, "plate": {"on": "plate", "components": "y"},
                    "end": {"on": "end"}}
        drawing += stones_end(drawing)
        books = [self.book(moved((steps, 2e-3, 0), joint={**GLUE, "tension strength": 2e5}, supports=supports,
                                 loads={"along": {"type": "settlement", "support": "end", "ux": 1.0}}), f"{steps}",
                           drawing, ("ground", "plate", "end")) for steps in (20, 100)]
        for book, within in zip(books, (0.08, 0.03)):
            self.assertLess(abs(book["external_work"] / book["sum"] - 1), within)
            self.assertLess(abs(book["imbalance"]), 2e-2 * book["external_work"])
        self.assertLess(abs(books[0]["external_work"] / books[1]["external_work"] - 1), 0.05)

    def test_weights_that_are_lowered_and_dragged(self):
        for name, moves in (("lowered", [(1, -2e-5, 0), (3, -5e-5, 0)]), ("dragged", [(1, -4e-5, 0), (8, -4e-5, 2e-3)])):
            book = self.book(moved(*moves, joint={"friction coefficient": 0.6}, weight=1.0), name, weight=WEIGHT)
            self.assertLess(abs(book["imbalance"]), 1e-6 * book["external_work"])

    def test_in_time_the_force_is_the_mean_of_the_step(self):
        for name, joint, way in (("glue", GLUE, (6e-4, 0)), ("dragged", {"friction coefficient": 0.6}, (-5e-5, 1e-3))):
            stages = {"rest": {"loads": {"weight": 1.0}},
                      "move": {"duration": 0.05, "time step": 1e-3, "loads": {"up": way[0], "along": way[1]}}}
            observed = {f"{support} held": {"place": "support", "support": support} for support in SUPPORTS}
            observed["stones"] = {"place": "mean", "blocks": "all"}
            run = self.run_scene(stones.scene("stones.geo", SUPPORTS, WAYS, stages, joints={"dry": joint},
                                              materials={"stone": STONE}, observations=observed),
                                 drawing=two_stones(), out=name)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            first, *rows = run.history
            work, last = first["external_work_J"] - first["work_within_steps_J"], first
            most = max(row["external_work_J"] for row in rows)
            for row in rows:
                work -= WEIGHT * (row["uy_m of stones"] - last["uy_m of stones"])
                work += sum(row[f"f{c}_N of {support} held"] * (row[u] - last[u]) for support in SUPPORTS for c in "xy"
                            for u in [f"u{c}_m of {support} held"])
                self.assertLess(abs(row["external_work_J"] - row["work_within_steps_J"] - work), 1e-9 * most)
                self.assertGreaterEqual(row["fracture_J"], last["fracture_J"])
                last = row
            print(name, run.result["energy"])
            self.assertLess(abs(last["work_within_steps_J"]), 1e-2 * most)

    def test_what_stands_open_has_no_strength(self):
        gap = 1e-4
        for name, joint in (("glue", GLUE), ("endless", {**GLUE, "cohesion": 1e9, "tension strength": 1e9}),
                            ("mortar", mortar(2e9))):
            book = self.book(moved((2, 3e-4, 0), (2, 0, 3e-4), joint={**joint, "initial gap": gap}), name)
            for key in ("fracture", "elastic", "external_work", "jump"):
                self.assertLess(abs(book[key]), 1e-9, key)
            self.assertIn("strength_over_gap", book["said"].warnings)
            # Closed by 0.03 mm and dragged it rubs, no more; pulled it lets go.
            moves = [(2, -gap - 3e-5, 0), (4, -gap - 3e-5, 2e-3), (2, 1e-4, 2e-3)]
            glued, dry = (self.book(moved(*moves, joint=one), f"{name} {which}") for which, one in
                          (("closing", {**joint, "initial gap": gap}),
                           ("dry", {key: value for key, value in {**joint, "initial gap": gap}.items()
                                    if key in ("friction coefficient", "initial gap") or "stiffness" in key})))
            self.assertEqual(glued["fracture"], 0)
            self.assertGreater(glued["friction"], 0)
            self.assertLess(abs(glued["friction"] - dry["friction"]), 1e-9 * dry["friction"])

    def test_stones_that_are_not_there_are_not_bonded(self):
        drawing = stones.geo({"below": stones.rectangle(0, 0, 1, 1), "above": stones.rectangle(0, 1, 1, 2)}, 0.5,
                             {"ground": ("below", 0), "plate": ("above", 2), "top": ("below", 2)})
        ever = {**GLUE, "cohesion": 1e12, "tension strength": 1e12}
        for name, joint in (("glue", GLUE), ("endless", ever)):
            stages = {"one": {"increments": 2, "loads": {"weight": 1.0}},
                      "both": {"increments": 2, "loads": {"weight": 1.0, "up": 0.0}},
                      "pulled": {"increments": 8, "loads": {"up": 6e-4}},
                      "without": {"increments": 2, "loads": {"up": 6e-4}}}
            if name == "endless":
                stages["pulled"]["loads"]["up"] = stages["without"]["loads"]["up"] = 0.0
            scene = stones.scene("stones.geo", SUPPORTS, WAYS, stages, joints={"dry": joint},
                                 materials={"stone": STONE}, newton={"tolerance": 1e-10},
                                 construction={"above": {"blocks": "above", "appears": "both", "disappears": "without"}},
                                 observations={"ground": {"place": "support", "support": "ground"}})
            run = self.run_scene(scene, drawing=drawing, out=name)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            fracture = {row["stage"]: row["fracture_J"] for row in run.history}
            print(name, fracture)
            self.assertEqual(fracture["both"], 0)
            self.assertLess(abs(fracture["pulled"] - (OPENING if name == "glue" else 0)), 1e-5 * OPENING)
            self.assertEqual(fracture["without"], fracture["pulled"])
            # Alone, and left alone, the lower stone hangs from nothing.
            for row in run.history[1:]:
                if row["stage"] in ("one", "without"):
                    self.assertLess(abs(row["fy_N of ground"] / (WEIGHT / 2) - 1), 1e-6)


def stones_end(drawing):
    """A set of the far ends of two leaves, for a drawing in which they are the second sides of both."""
    lines = [line for line in drawing.splitlines() if line.startswith("Curve Loop")]
    loops = [line.split("{")[1].split("}")[0].split(", ") for line in lines]
    return f'Physical Curve("end") = {{{", ".join(loop[1].lstrip("-") for loop in loops)}}};\n'


if __name__ == "__main__":
    program.main()

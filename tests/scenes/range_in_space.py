"""What a run in space says where stones slip, turn and meet beyond what the model can tell.

usage: range_in_space.py PROGRAM MPIEXEC

Set-up    Piers of 0.6 x 0.6 x 3 m on a ground that turns; stones that are thrown along a slab and slide to rest by friction:
          on a slab that goes on, over the edge of a table, into another stone.
Expected  A pier is told to have turned by the share of the angle at which it topples, half its width over the height of its
          mass centre, about an axis of its base or between two, whatever its number of stones, and the run ends from the
          whole on. Slips beyond a cell are told, with where the force has left the stone below the run ends, and stones that
          lie in each other are told.
Tolerance 3 % of the share: in the bed of an elastic stone friction bears what its widening asks for, which turns too.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import solids  # noqa: E402
from stones import xml  # noqa: E402

GRAVITY, MU = 9.81, 0.6
WIDTH, HEIGHT = 0.6, 3.0
TOPPLES = WIDTH / HEIGHT  # [rad]
OWN = {"loads": {"weight": 1.0}}


def scene(supports, loads=None, stages=None, **sections):
    tree = {"mesh": {"type": "stones", "stones": {"file": "stones.obj", "element size": 0.3}},
            "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"dry": {"friction coefficient": MU}}, "supports": supports,
            "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, **(loads or {})},
            "steps": {"stages": stages or {"own weight": OWN}}, **{k.replace("_", " "): v for k, v in sections.items()}}
    return xml("range", tree) + "\n"


class RangeInSpace(program.SceneTest):
    def run_stones(self, stones, text, **more):
        (self.folder / "stones.obj").write_text(solids.obj({n: solids.box(*box) for n, box in stones.items()}), encoding="utf-8")
        return self.run_scene(text, **more)

    def lean(self, stones, share, degrees, heat=0.0, **more):
        """A pier on a ground that has turned by a share of the angle at which it topples."""
        pier = {"ground": ((0, 0, -0.3), (WIDTH, WIDTH, 0))}
        step = HEIGHT / stones
        pier.update({f"stone {k}": ((0, 0, k * step), (WIDTH, WIDTH, (k + 1) * step)) for k in range(stones)})
        a = math.radians(degrees)
        turn = {"turn": {"type": "settlement", "support": "ground", "rotation": share * TOPPLES, "axis x": math.cos(a),
                         "axis y": math.sin(a), "axis z": 0.0}}
        warm = {"heat": 1.0} if heat else {}
        if heat:
            turn["heat"] = {"type": "temperature", "change": heat}
        return self.run_stones(pier, scene({"ground": {"on": "faces", "blocks": "ground"}}, turn,
                                           {"own weight": {"loads": {"weight": 1.0, **warm}},
                                            "turn": {"loads": {"weight": 1.0, "turn": 1.0, **warm}}}), **more)

    def told(self, run, what):
        found = [w for w in run.result.get("warnings", []) if w["what"] == what]
        self.assertTrue(found, run.said)
        return found[-1]["how_much"]

    def test_a_pier_that_leans_is_told_by_the_angle_at_which_it_topples(self):
        for stones, degrees, ranks in ((1, 0, 1), (3, 90, 1), (3, 0, 2), (1, 45, 1)):
            run = self.lean(stones, 0.4, degrees, out=f"{stones} {degrees} {ranks}", ranks=ranks)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            expected = 0.4 * max(abs(math.cos(math.radians(degrees))), abs(math.sin(math.radians(degrees))))
            self.assertLess(abs(self.told(run, "turn_beyond_first_order") - expected), 0.03 * expected, run.said)
        upright = self.lean(1, 0.05, 0, out="upright")
        self.assertNotIn("turn_beyond_first_order", upright.warnings)
        fallen = self.lean(1, 1.05, 0, out="fallen")
        self.assertEqual(fallen.outcome, "out_of_range", fallen.said)

    def test_what_heat_does_within_stones_turns_with_them(self):
        # The nodal forces of heat are far larger than the weight; about the centre of their stone they have no moment.
        # A warm stone slides outwards on its bed all around: friction there has arms of a quarter of the width, and
        # counts as what keeps its direction although it turns with the bed.
        friction = 0.4 * MU * (WIDTH / 4) / (HEIGHT / 2)
        for ranks in (1, 2):
            run = self.lean(2, 0.4, 0, heat=20.0, out=f"warm {ranks}", ranks=ranks)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            self.assertLess(abs(self.told(run, "turn_beyond_first_order") - 0.4), 0.03 * 0.4 + friction, run.said)

    def throw(self, stones, speed, seconds, step=0.005, **more):
        flight = {"sliding": {"duration": seconds, "time step": step, "loads": {"weight": 1.0}}}
        return self.run_stones(stones, scene({"ground": {"on": "faces", "blocks": "ground"}}, stages={"own weight": OWN, **flight},
                                             initial_velocities={"thrown": {"blocks": "thrown", "vx": speed}}), **more)

    def test_a_stone_that_slides_beyond_its_cells(self):
        slab = {"ground": ((-1, -0.5, -0.3), (2, 1, 0)), "thrown": ((0, 0, 0), (0.6, 0.6, 0.3))}
        for ranks in (1, 2):
            run = self.throw(slab, 2.5, 0.25, out=f"ranks {ranks}", ranks=ranks)
            self.assertNotEqual(run.outcome, "out_of_range", run.said)
            self.assertGreater(self.told(run, "slip_beyond_cell"), 0.3)
        short = self.throw(slab, 0.5, 0.1, out="short")
        self.assertEqual(short.warnings, [], short.said)

    def test_a_stone_that_slides_off_a_table(self):
        table = {"ground": ((-0.2, -0.2, -1), (0.8, 0.8, -0.7)), "table": ((0, 0, -0.7), (0.6, 0.6, 0)),
                 "thrown": ((0, 0, 0), (0.6, 0.6, 0.3))}
        run = self.throw(table, 4.0, 0.25)
        self.assertEqual(run.outcome, "out_of_range", run.said)
        self.assertLess(self.told(run, "slip_beyond_cell"), 0.45)  # it tips at 0.3 m, half a cell of 0.3 m before the end

    def test_a_stone_that_slides_off_a_table_that_is_held(self):
        table = {"ground": ((0, 0, -0.7), (0.6, 0.6, 0)), "thrown": ((0, 0, 0), (0.6, 0.6, 0.3))}
        run = self.throw(table, 4.0, 0.25)
        self.assertEqual(run.outcome, "out_of_range", run.said)
        self.assertLess(self.told(run, "slip_beyond_cell"), 0.45)

    def test_a_stone_that_slides_far_along_ground_that_is_held(self):
        # By more than its own length: the ground is held where nothing stands, and bears it wherever it is.
        ground = {"ground": ((0, -0.3, -0.6), (3, 0.9, 0)), "thrown": ((0, 0, 0), (0.6, 0.6, 0.3))}
        run = self.throw(ground, 7.5, 0.2, 0.02)
        self.assertNotEqual(run.outcome, "out_of_range", run.said)
        self.assertGreater(self.told(run, "slip_beyond_cell"), 1.2)

    def test_a_stone_that_slides_on_to_others(self):
        # Over two slabs onto a third, which its own rank does not know: told, and no reason to end.
        slabs = {f"slab {k}": ((0.6 * k, -0.3, -0.3), (0.6 * (k + 1), 0.9, 0)) for k in range(4)}
        stones = {"ground": ((0, -0.3, -0.6), (2.4, 0.9, -0.3)), **slabs, "thrown": ((0, 0, 0), (0.6, 0.6, 0.3))}
        for ranks in (1, 2):
            run = self.throw(stones, 7.5, 0.2, 0.02, out=f"ranks {ranks}", ranks=ranks)
            self.assertNotEqual(run.outcome, "out_of_range", run.said)
            self.assertGreater(self.told(run, "slip_beyond_cell"), 1.2)
            self.assertIn("where another stone is", run.words)

    def test_a_stone_that_only_a_tie_holds(self):
        # A column that opens when it is pushed, under a slab with an overhang, from which a small stone hangs dry: the one
        # round of release goes to the beds.
        courses, small = 5, 0.05
        stones = {f"stone {k}": ((0, 0, k), (1, 1, k + 1)) for k in range(courses)}
        stones.update({"slab": ((0, 0, courses), (1.3, 1, courses + 0.5)),
                       "hangs": ((1.2, 0.4, courses - small), (1.2 + small, 0.4 + small, courses))})
        push = {"push": {"type": "acceleration", "ax": 0.4}}
        text = scene({"ground": {"on": "base", "blocks": "stone 0"}}, push,
                     {"all": {"increments": 2, "loads": {"weight": 1.0, "push": 1.0}}},
                     selection={"largest rounds": 1, "largest share": 1.0})
        for ranks in (1, 2):
            run = self.run_stones(stones, text, out=f"ranks {ranks}", ranks=ranks)
            told, = (w for w in run.result["warnings"] if w["what"] == "held_by_ties")
            self.assertEqual(told["where"], f"block {courses + 1}")
            self.assertLess(abs(told["how_much"] - 1), 1e-2, told)

    def test_stones_that_meet(self):
        stones = {"ground": ((-1, -0.5, -0.3), (2, 1, 0)), "thrown": ((0, 0, 0), (0.6, 0.6, 0.3)),
                  "other": ((0.7, 0, 0), (1.3, 0.6, 0.3))}
        depths = [self.told(self.throw(stones, 2.0, 0.2, out=f"meet {ranks}", ranks=ranks), "stones_overlap")
                  for ranks in (1, 2, 5)]
        self.assertLess(0.05, depths[0])
        for depth in depths[1:]:
            self.assertLess(abs(depth - depths[0]), 1e-6)

    def test_a_gap_that_closes_is_no_overlap(self):
        for gap, way in (0.005, 0), (0.02, 0), (0.02, 0.03):
            stones = {"ground": ((-1, -1, -0.3), (1, 1, 0)), "stone": ((-0.2, -0.2, 0), (0.2, 0.2, 0.4))}
            pushed = {"down": {"type": "settlement", "support": "ground", "uz": way}}
            run = self.run_stones(stones, scene({"ground": {"on": "faces", "blocks": "ground"}}, pushed,
                                                {"own weight": {"loads": {"weight": 1.0, "down": 1.0}}},
                                                joints={"dry": {"friction coefficient": MU, "initial gap": gap}}))
            self.assertEqual(run.outcome, "equilibrium", run.said)
            self.assertLess(abs(run.history[-1]["largest_displacement_m"] - max(gap, way)), 0.5 * gap)
            self.assertNotIn("stones_overlap", run.warnings, run.said)


if __name__ == "__main__":
    program.main()

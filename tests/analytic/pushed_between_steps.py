"""A stone on a smooth bed takes the whole impulse of its loads, wherever these lie between the steps of time.

What a load does at the points of its table, at the rows of its record, where an axle comes on a stone: a step takes the
mean over itself, and an automatic one is short where a load varies fast. Velocities and ways are integrals of the
acceleration; a fixed step has the velocity to round-off, and its way to the length of a step.
"""

import pathlib
import sys

import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402
import stones  # noqa: E402

PUSH = 30.0  # m/s2
BED = stones.rectangle(0.0, -0.25, 2.0, 0.0)
BLOCK = stones.rectangle(0.0, 0.0, 2.0, 0.5)
DRAWING = stones.geo({"bed": BED, "block": BLOCK}, 0.5, {"ground": ("bed", 0), "top": ("block", 2)})
PULSE = ([0.0, 0.3, 0.301, 0.309, 0.31, 1.0], [0.0, 0.0, 1.0, 1.0, 0.0, 0.0])


def moved(times, values, by):
    return [t + by if 0 < t < 1 else t for t in times], values


def course(times, acceleration, end=1.0, pieces=200_001):
    """Velocity and way at the end of a course of accelerations: fine enough for 1e-5 of a pulse of milliseconds."""
    t = np.linspace(0.0, end, pieces)
    a = acceleration(t) if callable(acceleration) else np.interp(t, times, acceleration)
    v = np.concatenate([[0.0], np.cumsum((a[1:] + a[:-1]) / 2 * np.diff(t))])
    return float(v[-1]), float(np.sum((v[1:] + v[:-1]) / 2 * np.diff(t)))


def numbers(values):
    return ", ".join(map(repr, values))


def table(times, values):
    return {"type": "table", "times": numbers(times), "values": numbers(values)}


class PushedBetweenSteps(program.SceneTest):
    def scene(self, loads, stages, **sections):
        return stones.scene("stones.geo", ["ground"], loads, {"own weight": stones.OWN_WEIGHT, **stages}, friction=0.0,
                            observations={"m": {"place": "mean", "blocks": "block"}}, **sections)

    def go(self, function, name, stage=None, acceleration="acceleration", **key):
        load = {"type": acceleration, **(key or {"ax": PUSH})}
        if function:
            load["time function"] = function
        stages = {"go": {"duration": 1.0, "at once": True, "loads": {"push": 1.0}, **(stage or {})}}
        run = self.run_scene(self.scene({"push": load}, stages), drawing=DRAWING, out=name)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run, run.history[-1]["vx_m_per_s of m"], run.history[-1]["ux_m of m"]

    def check(self, found, expected, name, velocity=1e-4, way=1e-2):
        run, v, u = found
        self.assertLess(abs(v - expected[0]), velocity * abs(expected[0]), f"{name}: {v} m/s, {expected[0]} expected")
        self.assertLess(abs(u - expected[1]), way * abs(expected[1]), f"{name}: {u} m, {expected[1]} expected")
        self.assertLess(abs(run.result["energy"]["imbalance_J"]), 1e-6 * run.result["energy"]["external_work_J"], name)
        return run

    def test_a_pulse_is_taken_wherever_it_lies(self):
        for by in (0.003, 0.0061803):
            times, values = moved(*PULSE, by)
            run = self.check(self.go(table(times, values), f"pulse{by}"),
                             course(times, PUSH * np.array(values)), f"pulse {by}")
            self.assertEqual(run.warnings, [])

    def test_triangle_and_ramp(self):
        times, values = [0.0, 0.3, 0.32, 0.34, 1.0], [0.0, 0.0, 1.0, 0.0, 0.0]
        self.check(self.go(table(times, values), "triangle"), course(times, PUSH * np.array(values)), "triangle")
        ramp = {"type": "ramp", "start": 0.3017, "duration": 0.001}
        self.check(self.go(ramp, "ramp", ax=0.5), course([0.0, 0.3017, 0.3027, 1.0], [0.0, 0.0, 0.5, 0.5]), "ramp")

    def test_records_with_uneven_rows(self):
        times, values = moved(*PULSE, 0.0123)
        (self.folder / "rows.txt").write_text("".join(f"{t} {v}\n" for t, v in zip(times, values)))
        expected = course(times, PUSH * np.array(values))
        function = {"type": "record", "file": str(self.folder / "rows.txt")}
        self.check(self.go(function, "function"), expected, "record of a factor")
        self.check(self.go(None, "ground", acceleration="ground motion", **{"x record": function["file"], "scale": -PUSH}),
                   expected, "record of the ground")
        # A record that begins in the middle of its motion jumps there.
        (self.folder / "jump.txt").write_text("0.3071 1\n0.3161 1\n")
        self.check(self.go(None, "jump", acceleration="ground motion",
                           **{"x record": str(self.folder / "jump.txt"), "scale": -PUSH}),
                   course(None, lambda t: PUSH * ((t >= 0.3071) & (t <= 0.3161))), "record that jumps", velocity=1e-3)

    def test_a_given_step_has_the_impulse_and_says_that_it_is_long(self):
        expected = course(PULSE[0], PUSH * np.array(PULSE[1]))
        for step in (0.05, 0.013):
            run = self.check(self.go(table(*PULSE), f"step{step}", {"time step": step}), expected, f"step {step}", way=0.05)
            self.assertEqual(run.warnings, ["time_step_over_load"])
            self.assertEqual(len(run.history), 1 + round(np.ceil(1.0 / step)))
        self.assertEqual(self.check(self.go(table(*PULSE), "fine", {"time step": 0.001}), expected, "fine").warnings, [])

    def test_factors_that_grow_and_fall_with_their_stage(self):
        times, values = moved(*PULSE, 0.2)
        push = {"push": {"type": "acceleration", "ax": PUSH, "time function": table(times, values)}}
        stages = {"grows": {"duration": 0.505, "loads": {"push": 1.0}}, "falls": {"duration": 0.495, "loads": {"push": 0.0}}}
        factor = lambda t: np.where(t < 0.505, t / 0.505, (1.0 - t) / 0.495)
        expected = course(None, lambda t: PUSH * np.interp(t, times, values) * factor(t))
        for name, step in (("auto", {}), ("given", {"time step": 0.045})):
            run = self.run_scene(self.scene(push, {k: {**s, **step} for k, s in stages.items()}), drawing=DRAWING, out=name)
            last = run.history[-1]
            self.check((run, last["vx_m_per_s of m"], last["ux_m of m"]), expected, name, way=0.1 if step else 0.01)

    def test_a_load_at_once_acts_from_the_first_instant(self):
        for name, stage in (("auto", {}), ("given", {"time step": 0.05})):
            self.check(self.go(None, name, stage, ax=0.5), (0.5, 0.25), name, velocity=1e-5, way=1e-4)

    def test_an_axle_faster_than_its_cells(self):
        # Nothing holds the stone: it has the impulse of the time that the axle stands on it, 2 m at 100 m/s.
        tree = {
            "mesh": {"type": "gmsh", "gmsh": {"file": "stones.geo"}},
            "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"dry": {"friction coefficient": 0.0}},
            "loads": {"train": {"type": "moving train", "on": "top", "axle loads": "1e5, 5e4", "spacings": "1.0",
                                "position": -10.017, "speed": 100.0}},
            "observations": {"m": {"place": "mean", "blocks": "all"}},
        }
        impulse, mass = (1e5 + 5e4) * 0.02, 2000.0 * 2.0 * 0.75
        for name, stage in (("auto", {}), ("given", {"time step": 0.04})):
            tree["steps"] = {"stages": {"go": {"duration": 0.4, "at once": True, "loads": {"train": 1.0}, **stage}}}
            run = self.run_scene(stones.xml("train", tree), drawing=DRAWING, out=name)
            self.assertEqual(run.outcome, "equilibrium", run.said)
            self.assertAlmostEqual(run.history[-1]["vy_m_per_s of m"], -impulse / mass, delta=1e-6 * impulse / mass)
            self.assertEqual("time_step_over_load" in run.warnings, bool(stage))

    def test_supports_do_not_jump(self):
        loads = {"drop": {"type": "settlement", "support": "ground", "uy": -0.01}}
        stage = {"go": {"duration": 0.1, "at once": True, "loads": {"drop": 1.0}}}
        run = self.run_scene(self.scene(loads, stage), drawing=DRAWING, out="jump")
        self.assertEqual(run.code, 2, run.said)
        self.assertIn("would move a support in no time", run.words)
        loads["drop"]["time function"] = table([0.0, 0.1], [0.0, 1.0])
        stage["go"]["time step"] = 0.01
        self.assertEqual(self.run_scene(self.scene(loads, stage), drawing=DRAWING, out="table").code, 0)
        loads["drop"]["time function"] = {"type": "sine", "start": 0.05, "frequency": 2.0, "phase": 1.0}
        run = self.run_scene(self.scene(loads, stage), drawing=DRAWING, out="sine")
        self.assertEqual(run.code, 2, run.said)
        self.assertIn("time function jumps in stage 'go'", run.words.replace('"', "'"))


if __name__ == "__main__":
    program.main()

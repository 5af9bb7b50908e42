"""Calibration: of an arch under a load at its crown the modulus of its stone is found from a measured deflection.

usage: calibration.py PROGRAM MPIEXEC [names of tests]

Set-up    A semicircular arch of 25 voussoirs, 10 kN at its crown on top of its weight; five moduli by drivers/sweep, one command.
Expected  By hand: a frame of 50 straight bars with bending, axial force and shear (shear area 5/6 of the section), fixed at the
          springings, whose crown goes down by the deflection of the bonded arch to 5 %: bars are thick (depth over radius
          0.16), so that a straight bar is not exact. Deflections go as 1 / modulus, and the modulus that the curve gives for a
          measured deflection gives that deflection.
Tolerance 5 % as said; 1 / modulus 1e-4, since where joints open that depends on force over weight alone.
"""

import math
import pathlib
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import jobs  # noqa: E402  (a folder of its own)
import program  # noqa: E402

RADIUS, DEPTH, THICKNESS, VOUSSOIRS = 2.5, 0.4, 0.5, 25  # [m] of the middle line
LOAD, MODULUS, POISSON = 10e3, 5e9, 0.2
MODULI = [2e9, 3e9, 5e9, 8e9, 12e9]
MEASURED = 0.5e-3                                        # [m] that the crown went down under the load


def scene(mode):
    drawn = jobs.package().stones.Stones(snap=1e-6)
    at = lambda radius, k: (-round(radius * math.cos(math.pi * k / VOUSSOIRS), 9), round(radius * math.sin(math.pi * k / VOUSSOIRS), 9))
    inner, outer = RADIUS - DEPTH / 2, RADIUS + DEPTH / 2
    for k in range(VOUSSOIRS):
        drawn.polygon([at(inner, k), at(inner, k + 1), at(outer, k + 1), at(outer, k)], f"voussoir {k}", sets="ring")
    drawn.edges("left", lambda x, y: y < 1e-6 and x < 0)
    drawn.edges("right", lambda x, y: y < 1e-6 and x > 0)
    crown = at(outer, VOUSSOIRS / 2)[1] * math.cos(math.pi / VOUSSOIRS / 2)
    stage = "steps/stages/load/loads/jack"
    keys = {"model/thickness": THICKNESS, "model/plane": "stress",
            "materials/stone": {"Young modulus": MODULUS, "Poisson ratio": POISSON, "density": 2000.0},
            "joints/dry/friction coefficient": 0.6, "supports/left/on": "left", "supports/right/on": "right",
            "loads/weight/type": "self weight",
            "loads/jack": {"type": "traction", "on": "crown", "ty": -LOAD / THICKNESS / (2 * outer * math.sin(math.pi / VOUSSOIRS / 2))},
            "observations/crown": {"x": 0.0, "y": inner, "tolerance": 0.1},
            "steps/stages/own weight/loads/weight": 1.0, stage: 1.0, "selection/mode": mode}
    drawn.edges("crown", lambda x, y: y > crown - 0.02)
    return drawn, keys


def frame_by_hand():
    """[m] The way down of the crown of a frame of straight bars."""
    bars = 50
    angle = np.pi * np.arange(bars + 1) / bars
    x, y = -RADIUS * np.cos(angle), RADIUS * np.sin(angle)
    area, inertia = DEPTH * THICKNESS, THICKNESS * DEPTH**3 / 12
    shear = MODULUS / (2 + 2 * POISSON) * area * 5 / 6
    whole = np.zeros((3 * (bars + 1),) * 2)
    for k in range(bars):
        dx, dy = x[k + 1] - x[k], y[k + 1] - y[k]
        length = np.hypot(dx, dy)
        phi = 12 * MODULUS * inertia / (shear * length**2)
        a, b = MODULUS * area / length, MODULUS * inertia / (length**3 * (1 + phi))
        bar = np.array([[a, 0, 0, -a, 0, 0],
                        [0, 12 * b, 6 * b * length, 0, -12 * b, 6 * b * length],
                        [0, 6 * b * length, (4 + phi) * b * length**2, 0, -6 * b * length, (2 - phi) * b * length**2],
                        [-a, 0, 0, a, 0, 0],
                        [0, -12 * b, -6 * b * length, 0, 12 * b, -6 * b * length],
                        [0, 6 * b * length, (2 - phi) * b * length**2, 0, -6 * b * length, (4 + phi) * b * length**2]])
        turn = np.zeros((6, 6))
        for end in (0, 3):
            turn[end:end + 3, end:end + 3] = [[dx / length, dy / length, 0], [-dy / length, dx / length, 0], [0, 0, 1]]
        whole[3 * k:3 * k + 6, 3 * k:3 * k + 6] += turn.T @ bar @ turn
    free = np.arange(3, 3 * bars)
    force = np.zeros(3 * (bars + 1))
    force[3 * (bars // 2) + 1] = -LOAD
    moved = np.zeros_like(force)
    moved[free] = np.linalg.solve(whole[np.ix_(free, free)], force[free])
    return -moved[3 * (bars // 2) + 1]


def deflection(history):
    """[m] of the crown under the load alone."""
    down = [-float(row["uy_m of crown"]) for row in history]
    return down[-1] - down[0]


class Calibration(jobs.JobTest):
    def rows_of(self, folder):
        return program.Run(folder, type("Done", (), {"returncode": 0, "stdout": "", "stderr": ""})).history

    def test_the_bonded_arch_deflects_as_the_frame(self):
        result = self.run_job("bonded", *scene("bonded"), element_size=0.05)
        self.assertLess(abs(deflection(self.rows_of(result.folder)) / frame_by_hand() - 1), 0.05)

    def test_the_modulus_of_a_measured_deflection(self):
        path = self.write_job("dry", *scene("all"), element_size=0.1)
        done = self.sweep(path, "--set", f"materials/stone/Young modulus={','.join(f'{e:g}' for e in MODULI)}")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = {}
        for row in self.rows():
            found[float(row["materials/stone/Young modulus"])] = deflection(self.rows_of(self.folder / "sweep" / "runs" / row["run"]))
        self.assertEqual(sorted(found), MODULI)
        stiffness = [modulus * way for modulus, way in found.items()]
        self.assertLess(max(stiffness) / min(stiffness) - 1, 1e-4)
        fitted = float(np.interp(MEASURED, *zip(*sorted((way, 1 / modulus) for modulus, way in found.items()))))
        scene_of_fit = jobs.package().Scene.read(path)
        scene_of_fit["materials/stone/Young modulus"] = 1 / fitted
        result = scene_of_fit.run(out=self.folder / "fitted", ranks=1)
        self.assertLess(abs(deflection(self.rows_of(result.folder)) / MEASURED - 1), 1e-3)
        self.assertIn("“jack” (traction): 10 kN downwards", self.page(result))


if __name__ == "__main__":
    program.main()

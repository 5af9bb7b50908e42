"""What joints take that lose their strength.

usage: fracture_energy.py PROGRAM MPIEXEC

Set-up    Two stones between plates, joined by mortar of 0.05 MPa, 0.1 MPa, 10 and 50 J/m2, that are pulled apart, sheared under
          pressure, or both, in few load steps and in many, on 1, 2 and 4 ranks, in statics and in time.
Expected  The joint takes its energy times its area in each mode, whatever the steps; friction takes its force times the way
          beside it; and the energy book closes.
Tolerance 1e-8 of the energy where all strength is lost. Imbalance: 1e-8 in opening, where everything is exact, and in time;
          1e-8 in shear. A step in which a joint opens or closes and presses has the imbalance of the book.
"""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hard" / "ground"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "restart"))
from drawing import Drawing  # noqa: E402  (folders of their own)
import scenes  # noqa: E402
from runs import empty, run_scene  # noqa: E402

PROGRAM = MPIEXEC = None
OPENING, SHEAR, FRICTION, MODULUS = 10.0, 50.0, 0.6, 10e9  # [J/m2, J/m2, -, Pa]
MORTAR = {"cohesion": 1e5, "tension strength": 5e4, "fracture energy": OPENING, "shear fracture energy": SHEAR}


def run(name, moves, *settings, ranks=1, mortar=(), duration=None):
    """Energies of a run. moves: (up, along) [m] of the upper plate after each stage, from a start at rest."""
    drawing = Drawing(0.25)
    drawing.box(0, 0, 1, 1, bottom="ground")
    drawing.box(0, 1, 1, 1, top="plate")
    stages = {f"move {k}": {**({"duration": duration} if duration else {}),
                            "loads": {"weight": 0.0, "up": up, "along": along}} for k, (up, along) in enumerate(moves, 1)}
    scene = scenes.scene(
        drawing, stages=stages, supports={"ground": {"on": "ground"}, "plate": {"on": "plate"}},
        loads={key: {"type": "settlement", "support": "plate", axis: 1.0} for key, axis in (("up", "uy"), ("along", "ux"))},
        stone={"Poisson ratio": 0.0, "Young modulus": MODULUS}, newton={"tolerance": 1e-11})
    scene["joints"] = {"mortar": {"friction coefficient": FRICTION, **MORTAR, **dict(mortar)}}
    scene["steps"].pop("expect collapse")
    folder = empty(f"fracture_energy/{name}")
    (folder / "scene").mkdir(parents=True)
    result = run_scene(PROGRAM, MPIEXEC, folder / "run", scenes.write(scene, folder / "scene"), *settings, ranks=ranks)
    energy = {key.removesuffix("_J"): value for key, value in result["energy"].items()}
    print(name, {key: float(f"{value:.10g}") for key, value in energy.items() if value})
    return energy


class FractureEnergy(unittest.TestCase):
    def test_opening_takes_the_energy_of_the_joint_whatever_the_steps(self):
        ways = {"one": [(1e-3, 0)], "three": [(6e-5, 0), (2e-4, 0), (1e-3, 0)],
                "to_and_fro": [(1.5e-4, 0), (5e-5, 0), (-1e-5, 0), (2.2e-4, 0), (1e-4, 0), (1e-3, 0)]}
        for name, moves in ways.items():
            for shape in ("linear", "exponential"):
                moves = moves if shape == "linear" else [*moves, (1e-2, 0)]
                energy = run(f"opening_{name}_{shape}", moves, mortar={"softening": shape})
                self.assertLess(abs(energy["fracture"] - OPENING), 1e-8 * OPENING)
                if name != "to_and_fro":  # a step that closes, too, has an imbalance: half of what then presses
                    self.assertLess(abs(energy["imbalance"]), 1e-8 * OPENING)

    def test_of_an_opening_half_way_the_joint_gives_back_what_it_has_not_lost(self):
        there, back = run("half_way", [(1.5e-4, 0)]), run("half_way_back", [(1.5e-4, 0), (0, 0)])
        self.assertLess(there["fracture"], 0.9 * OPENING)
        self.assertLess(abs(back["fracture"] - there["fracture"]), 1e-8 * OPENING)
        self.assertLess(abs(back["elastic"]), 1e-8 * OPENING)
        self.assertLess(abs(back["external_work"] - there["fracture"]), 1e-8 * OPENING)

    def test_shear_takes_its_energy_beside_friction(self):
        for name, moves in (("one", [(-4e-5, 0), (-4e-5, 5e-3)]),
                            ("many", [(-4e-5, 0), *((-4e-5, k * 1e-3) for k in range(1, 6))]),
                            ("to_and_fro", [(-4e-5, 0), (-4e-5, 5e-4), (-4e-5, -1e-3), (-4e-5, 5e-3)])):
            energy = run(f"shear_{name}", moves)
            self.assertLess(abs(energy["fracture"] - SHEAR), 1e-8 * SHEAR)
            self.assertLess(abs(energy["imbalance"]), 1e-8 * SHEAR)
            least = FRICTION * 0.2e6 * 5e-3 * (1.5 if name == "to_and_fro" else 1)  # stones give way by some of it
            self.assertLess(abs(energy["friction"] / least - 1), 0.1)

    def test_a_joint_that_opens_and_slips_takes_an_energy_between(self):
        energy = run("both", [(2e-4, 4e-4), (1e-3, 2e-3)])
        self.assertGreater(energy["fracture"], OPENING)
        self.assertLess(energy["fracture"], SHEAR)

    def test_ranks_agree(self):
        one, *others = (run(f"ranks_{n}", [(1e-4, 0), (1.2e-4, 3e-4), (-4e-5, 2e-3)], ranks=n) for n in (1, 2, 4))
        for other in others:
            for key in ("fracture", "friction", "elastic"):
                self.assertLess(abs(other[key] - one[key]), 1e-8 * SHEAR)

    def test_time_takes_the_same(self):
        energy = run("in_time", [(1e-3, 0)], duration=0.2)
        self.assertLess(abs(energy["fracture"] - OPENING), 1e-3 * OPENING)
        self.assertLess(abs(energy["imbalance_in_time"]), 1e-6 * OPENING)


if __name__ == "__main__":
    PROGRAM, MPIEXEC = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])

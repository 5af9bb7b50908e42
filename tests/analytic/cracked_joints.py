"""What the tests of joints that soften share: runs, and what their contact points carry after every step."""

import csv
import pathlib
import sys

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hard" / "ground"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "restart"))
import scenes  # noqa: E402  (folders of their own)
from runs import empty, run_scene  # noqa: E402

XML = pathlib.Path(__file__).resolve().parents[2] / "xml"


class Programs:
    """The programs under test; set by the script that is run."""

    voussoir = mpiexec = None

    @classmethod
    def take(cls, arguments):
        cls.voussoir, cls.mpiexec = (str(pathlib.Path(argument).resolve()) for argument in arguments)


def run(name, scene, *settings, ranks=1):
    """Runs a scene, given as a path or as nested dictionaries; its result.json and its Steps."""
    folder = empty(name)
    if isinstance(scene, dict):
        (folder / "scene").mkdir(parents=True)
        scene = scenes.write(scene, folder / "scene")
    result = run_scene(Programs.voussoir, Programs.mpiexec, folder / "run", scene, *settings, ranks=ranks)
    return result, Steps(folder / "run")


class Steps:
    """Contact points of a run: position [m], normal, area [m2]; after each step, one row each, gap and slip [m], pressure and shear
    [Pa], damage [-]; the rows of history.csv."""

    def __init__(self, folder):
        with h5py.File(folder / "fields.h5") as file:
            self.coordinates = file["mesh/coordinates"][()]
            self.position, self.normal, self.area = (file["joints/" + key][()] for key in ("position", "normal", "area"))
            steps = [file["steps"][name] for name in sorted(file["steps"])]
            self.displacement = np.array([step["displacement"][()] for step in steps])
            self.gap, self.slip, normal, tangential, self.damage = (
                np.array([step["joint_" + key][()] for step in steps])
                for key in ("gap_m", "slip_m", "normal_force_N", "tangential_force_N", "damage"))
        with open(folder / "history.csv", encoding="utf-8", newline="") as file:
            self.history = list(csv.DictReader(file))
        self.pressure, self.shear = normal / self.area, tangential / self.area

    def work_of_support(self, name):
        """Mean force times way of an observed support, added up [J]."""
        work, before = 0.0, {}
        for row in self.history:
            for axis in "xy":
                force, way = (f"f{axis}_N of {name}", f"u{axis}_m of {name}")
                last = [float(before.get(key, 0)) for key in (force, way)]
                work += (last[0] + float(row[force])) / 2 * (float(row[way]) - last[1])
            before = row
        return work

    def work_of_means(self):
        """What the run says of loads and supports, without what it says that joints made of it within steps [J]."""
        return float(self.history[-1]["external_work_J"]) - float(self.history[-1]["work_within_steps_J"])

    def lost_beyond_states(self, law, strength=1.0):
        """Largest damage of a point beyond what the largest of its openings and its way from slip to slip, in the recorded
        steps, take by a law (the keys of a scene); its strength times a share, per point."""
        def give(key):
            return 1 / law[key] if key in law else 0.0

        opened = np.maximum.accumulate(np.maximum(self.gap + give("normal stiffness") * self.pressure, 0))
        slip = self.slip + give("tangential stiffness") * self.shear
        way = np.abs(np.diff(slip, axis=0, prepend=0)).cumsum(axis=0)
        kappa = strength * np.hypot(law["tension strength"] * opened / law["fracture energy"],
                                    law["cohesion"] * way / law["shear fracture energy"])
        lost = -np.expm1(-kappa) if law.get("softening") == "exponential" else np.minimum(kappa / 2, 1)
        return (self.damage - lost).max()

"""What the tests of restart share: a run with friction and cohesion in its history, and when two runs are equal.

The wall W(6) is pushed sideways in 16 load steps; its joints have cohesion, which those that open or slip lose.
"""

import csv
import json
import math
import os
import pathlib
import shutil
import subprocess

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = ROOT / "xml" / "wall.xml"
STEPS = 17
SETTINGS = ["mesh/wall/courses=6", "mesh/wall/blocks per course=6", "steps/stages/push/increments=16",
            "joints/dry/cohesion=2e3", "loads/sideways/ax=2.2", "output/checkpoint every=1"]
# Counts and results of result.json; the others are seconds, memory, factors, which a run that goes on makes anew, and how
# the run was started.
TIMED = {"seconds", "effects", "factorisations", "peak_memory_MB", "peak_memory_MB_per_rank", "scene", "ranks"}


class Program:
    def __init__(self, program, mpiexec):
        self.program, self.mpiexec = program, mpiexec

    def command(self, out, *options, ranks=1, settings=SETTINGS):
        launch = [self.mpiexec, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        command = [*launch, self.program, f"--xml={SCENE}", f"--out={out}", *options]
        for setting in settings:
            command += ["--set", setting]
        return command

    def run(self, out, *options, **how):
        return subprocess.run(self.command(out, *options, **how), capture_output=True, text=True, check=False)

    def start(self, out, *options, log=None, **how):
        """Starts a run in a group of processes of its own, so that no helper of MPI outlives a kill."""
        return subprocess.Popen(self.command(out, *options, **how), stdout=log or subprocess.DEVNULL,
                                stderr=subprocess.STDOUT, start_new_session=True)


def run_scene(program, mpiexec, out, scene, *settings, ranks=1):
    """Runs a scene into an empty folder, and expects it to succeed; its result.json."""
    launch = [mpiexec, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    command = [*launch, program, f"--xml={scene}", f"--out={out}", "--quiet"]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return json.loads((pathlib.Path(out) / "result.json").read_text())


def empty(folder):
    """A folder's path with nothing there, results of earlier tests and those kept beside included."""
    folder = pathlib.Path(folder).resolve()
    folder.parent.mkdir(parents=True, exist_ok=True)
    for old in folder.parent.glob(folder.name + "*"):
        if old.is_dir() and not old.is_symlink():
            shutil.rmtree(old)
        else:
            os.remove(old)
    return folder


def history(folder):
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        return [{key: value for key, value in row.items() if key != "seconds"} for row in csv.DictReader(file)]


def result(folder):
    content = json.loads((folder / "result.json").read_text())
    return {key: value for key, value in content.items() if key not in TIMED}


def tables(folder):
    """Every table of fields.h5 but those that name ranks, and the views for viewers."""
    found = {}

    def add(name, item):
        if isinstance(item, h5py.Dataset) and "rank_of" not in name and not name.endswith("_xyz"):
            found[name] = item[()]

    with h5py.File(folder / "fields.h5") as file:
        file.visititems(add)
    return found


def differences(folder, reference):
    """Names of all that is not equal to the last bit."""
    problems = []
    if history(folder) != history(reference):
        problems.append("history.csv")
    if result(folder) != result(reference):
        problems.append("result.json")
    mine, theirs = tables(folder), tables(reference)
    if set(mine) != set(theirs):
        problems.append(f"names of tables: {sorted(set(mine) ^ set(theirs))[:3]}")
    problems += [name for name in mine if name in theirs and not same(mine[name], theirs[name])]
    for name in ("fields.xdmf", "stones.xdmf", "joints.xdmf"):
        if (folder / name).read_text() != (reference / name).read_text():
            problems.append(name)
    return problems


def same(a, b):
    """To the last bit, numbers that are none included: those of stones that are not there."""
    return np.array_equal(a, b, equal_nan=a.dtype.kind == "f")


def largest_difference(folder, reference, table):
    """Of the last step, relative to its largest value."""
    mine, theirs = tables(folder), tables(reference)
    last = max(name.split("/")[1] for name in theirs if name.startswith("steps/"))
    a, b = mine[f"steps/{last}/{table}"], theirs[f"steps/{last}/{table}"]
    return float(np.abs(a - b).max() / max(np.abs(b).max(), math.ulp(0.0)))

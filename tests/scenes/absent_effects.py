"""Every scene of xml/ with each of its loads and initial velocities left out, and named but idle: the very same answer.

    absent_effects.py PROGRAM

What a scene does not name costs no byte, no call and no second. Idle is a factor of 0, or a velocity of 0. Stages with a
duration are cut to a few steps. What takes long is left out, the bridge and most of space: its loads are those of other scenes.
"""

import copy
import csv
import json
import pathlib
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path("absent-effects").resolve()
PROGRAM = None
TIME_STEPS = 4
LEFT_OUT = {"reference", "barrel-vault-spreading", "cross-vault", "dome", "facade-shaken", "wall-with-returns"}
DONE, NO_CONVERGENCE = 0, 3  # without its weight an arch may have no equilibrium; then neither has it when it is idle


def scenes():
    paths = sorted((ROOT / "xml").glob("*.xml"))
    return [p for p in paths if p.stem not in LEFT_OUT and not p.stem.startswith("clare-college-bridge")]


def sublist(tree, *names):
    for name in names:
        tree = next((t for t in tree.findall("ParameterList") if t.get("name") == name), None) if tree is not None else None
    return tree


def parameter(tree, name):
    return next((p for p in tree.findall("Parameter") if p.get("name") == name), None)


def read(path):
    """A scene whose stages take a few steps, without a search for a load factor, and whose files are found from elsewhere."""
    tree = ElementTree.parse(path).getroot()
    if (search := sublist(tree, "load factor")) is not None:
        tree.remove(search)
    for p in tree.iter("Parameter"):
        if p.get("value").endswith((".geo", ".msh", ".csv", ".svg")):
            places = [path.parent / p.get("value"), ROOT / p.get("value"), ROOT / "meshes" / p.get("value")]
            p.set("value", str(next(f for f in places if f.is_file())))
    for stage in sublist(tree, "steps", "stages"):
        duration, step = parameter(stage, "duration"), parameter(stage, "time step")
        if duration is not None:
            length = float(step.get("value")) if step is not None else float(duration.get("value")) / 1e4
            duration.set("value", repr(TIME_STEPS * length))
            if step is None:
                ElementTree.SubElement(stage, "Parameter", name="time step", type="double", value=repr(length))
    return tree


def without(tree, family, name):
    tree = copy.deepcopy(tree)
    members = sublist(tree, family)
    members.remove(sublist(members, name))
    for factors in (sublist(stage, "loads") for stage in sublist(tree, "steps", "stages")):
        if factors is not None and family == "loads" and parameter(factors, name) is not None:
            factors.remove(parameter(factors, name))
    return tree


def idle(tree, family, name):
    tree = copy.deepcopy(tree)
    if family == "loads":
        for factors in (sublist(stage, "loads") for stage in sublist(tree, "steps", "stages")):
            if factors is not None and parameter(factors, name) is not None:
                parameter(factors, name).set("value", "0")
    else:
        for key in parameter_names(sublist(tree, family, name)) & {"vx", "vy", "rotation"}:
            parameter(sublist(tree, family, name), key).set("value", "0")
    return tree


def parameter_names(tree):
    return {p.get("name") for p in tree.findall("Parameter")}


def word(tree, family, name):
    return parameter(sublist(tree, family, name), "type").get("value") if family == "loads" else family


def solve(tree, name):
    """History without seconds, and effects of result.json (None where there was no step to take)."""
    scene, out = FOLDER / f"{name}.xml", FOLDER / name
    FOLDER.mkdir(exist_ok=True)
    ElementTree.ElementTree(tree).write(scene)
    command = [PROGRAM, f"--xml={scene}", f"--out={out}", "--overwrite", "--quiet"]
    for setting in ("output/fields=false", "newton/largest iterations=100", "steps/largest halvings=0"):
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode in (DONE, NO_CONVERGENCE), done.stdout + done.stderr
    with open(out / "history.csv", newline="", encoding="utf-8") as file:
        rows = [{k: v for k, v in row.items() if k != "seconds"} for row in csv.DictReader(file)]
    return rows, json.loads((out / "result.json").read_text())["effects"]


class AbsentEffects(unittest.TestCase):
    def test_scenes_name_many_effects(self):
        named = {word(tree, "loads", load.get("name"))
                 for tree in map(read, scenes()) for load in (sublist(tree, "loads") or ())}
        self.assertGreaterEqual(len(named), 9, named)

    def test_what_is_absent_costs_nothing_and_what_is_idle_changes_nothing(self):
        for path in scenes():
            tree = read(path)
            for family in ("loads", "initial velocities"):
                members = [m.get("name") for m in (sublist(tree, family) if sublist(tree, family) is not None else ())]
                for name in members:
                    static = any(parameter(s, "duration") is None for s in sublist(tree, "steps", "stages"))
                    if family == "loads" and static and len(members) == 1:
                        continue  # a scene in load steps needs a load
                    with self.subTest(scene=path.stem, without=name):
                        self.check(tree, family, name)

    def check(self, tree, family, name):
        rows, effects = solve(without(tree, family, name), "without")
        idle_rows, _ = solve(idle(tree, family, name), "idle")
        self.assertEqual(rows, idle_rows)
        effect, others = word(tree, family, name), {word(tree, family, m.get("name")) for m in sublist(tree, family)
                                                    if m.get("name") != name}
        if effect not in others:
            self.assertFalse(effects[effect]["in_play"])
        for key, cost in effects.items():
            if not cost["in_play"]:
                self.assertEqual((cost["calls"], cost["seconds"], cost["bytes"]), (0, 0, 0), key)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()

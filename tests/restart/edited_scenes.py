"""A run is gone on with a scene that has been edited: what lies behind it must be as it was, what is to come may change.

    edited_scenes.py PROGRAM MPIEXEC
"""

import pathlib
import shutil
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
import stones
from stones import rectangle, xml

INPUT = 2
WALL = {f"s{k}": rectangle(0, 0.2 * k, 0.5, 0.2 * (k + 1)) for k in range(4)}
DRAWING = stones.geo(WALL, 0.1, {"ground": ("s0", 0), "top": ("s3", 2), "side": ("s3", 1)})
TOP = {"x": 0.5, "y": 0.8, "tolerance": 0.01}


def stage(loads, **more):
    return {"loads": loads, **more}


def tree():
    """Two load steps and half a second in time have passed at the end of the first four stages."""
    loads = {"weight": {"type": "self weight", "gravity": 9.81},
             "push": {"type": "acceleration", "ax": 0.5},
             "press": {"type": "traction", "on": "top", "pressure": 1e4},
             "wind": {"type": "traction", "on": "side", "tx": -200.0},
             "sway": {"type": "acceleration", "ax": 1.0,
                      "time function": {"type": "record", "file": "push.csv"}}}
    stages = {"own weight": stage({"weight": 1.0}), "push": stage({"push": 1.0}, increments=2),
              "shaken": stage({"sway": 1.0}, duration=0.02, **{"time step": 0.005}),
              "still": stage({"push": 0.5}, duration=0.01, **{"time step": 0.005})}
    return {"mesh": {"type": "gmsh", "gmsh": {"file": "stones.geo"}},
            "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"dry": {"friction coefficient": 0.6, "cohesion": 1e4, "tension strength": 1e4}},
            "supports": {"ground": {"on": "ground"}},
            "loads": loads,
            "initial velocities": {"kick": {"blocks": "s3", "vx": 0.001}},
            "steps": {"time": {"mass damping": 2.0, "stiffness damping": 1e-4}, "stages": stages},
            "observations": {"corner": dict(TOP)},
            "output": {"fields": False}}


def edited(*path_and_value, remove=False):
    """The scene with a further stage in which another load acts, and one value changed."""
    scene = tree()
    scene["steps"]["stages"]["later"] = stage({"press": 1.0}, increments=2)
    if path_and_value:
        *path, value = path_and_value
        place = scene
        for name in path[:-1]:
            place = place.setdefault(name, {})
        if remove:
            del place[path[-1]]
        else:
            place[path[-1]] = value
    return xml("edited", scene) + "\n"


class Edited(program.SceneTest):
    @classmethod
    def setUpClass(cls):
        cls.first = pathlib.Path("edited-first").resolve()
        shutil.rmtree(cls.first, ignore_errors=True)
        cls.first.mkdir()
        cls.scene(cls.first)
        test = cls()
        test.folder = cls.first
        run = test.run_scene(xml("first", tree()) + "\n", drawing=DRAWING)
        assert run.code == 0, run.said

    def runTest(self):
        pass

    @staticmethod
    def scene(folder, last="1"):
        (folder / "push.csv").write_text(f"0,0\n0.01,1\n0.02,{last}\n", encoding="utf-8")

    def go_on(self, *change, remove=False, out="out", record="1", drawing=DRAWING):
        shutil.copytree(self.first / "out", self.folder / out)
        self.scene(self.folder, record)
        before = (self.folder / out / "history.csv").read_bytes()
        run = self.run_scene(edited(*change, remove=remove), "--restart", drawing=drawing, out=out)
        run.untouched = (self.folder / out / "history.csv").read_bytes() == before
        return run

    def refused(self, words, *change, **how):
        self.number = getattr(self, "number", 0) + 1
        run = self.go_on(*change, out=f"out{self.number}", **how)
        self.assertEqual(run.code, INPUT, (change, run.said))
        for word in words:
            self.assertIn(word, run.words)
        self.assertTrue(run.untouched, change)

    def accepted(self, words, *change, **how):
        self.number = getattr(self, "number", 0) + 1
        run = self.go_on(*change, out=f"out{self.number}", **how)
        self.assertEqual(run.code, 0, (change, run.said))
        for word in words:
            self.assertIn(word, run.words)

    def test_loads_that_have_acted_are_as_they_were(self):
        self.refused(["scene > loads > weight > gravity = 29.43 [m/s2], was 9.81 [m/s2]"],
                     "loads", "weight", "gravity", 29.43)
        self.refused(["loads > push > type", "load \"push\" has acted"],
                     "loads", "push", {"type": "traction", "on": "side", "tx": 100.0})
        self.refused(["loads > sway > time function > scale"],
                     "loads", "sway", "time function", "scale", 2.0)

    def test_the_content_of_a_record_counts_and_not_its_place(self):
        self.refused(["loads > sway > time function > file", "a file with digest"], record="1.5")
        (self.folder / "deep").mkdir()
        shutil.copy(self.first / "push.csv", self.folder / "deep" / "same.csv")
        self.accepted(["stage 'later'"], "loads", "sway", "time function", "file", "deep/same.csv")

    def test_what_made_the_stages_that_have_passed_is_as_it_was(self):
        self.refused(["its joints differ", "joints > dry > cohesion = 20000 [Pa], was 10000 [Pa]"],
                     "joints", "dry", "cohesion", 2e4)
        self.refused(["steps > time > mass damping"], "steps", "time", "mass damping", 0.5)
        self.refused(["initial velocities > kick > vx"], "initial velocities", "kick", "vx", 0.002)
        self.refused(["stages > still > loads > push"], "steps", "stages", "still", "loads", "push", 0.7)
        self.refused(["stages > shaken > at once"], "steps", "stages", "shaken", "at once", True)

    def test_places_that_are_observed_are_as_they_were(self):
        self.refused(["observations > corner > y = 0.6 [m], was 0.8 [m]"], "observations", "corner", "y", 0.6)
        self.accepted(["observations > foot is new"], "observations", "foot", {"x": 0.0, "y": 0.0, "tolerance": 0.01})

    def test_what_is_to_come_may_change_and_it_is_said(self):
        self.accepted(["loads > press > pressure = 20000 [Pa], was 10000 [Pa]", "steps > stages > later is new"],
                      "loads", "press", "pressure", 2e4)
        self.accepted(["loads > wind is there no more"], "loads", "wind", None, remove=True)
        self.accepted(["newton > tolerance = 1e-9 [-], was 1e-8 [-]"], "newton", {"tolerance": 1e-9})

    def test_cells_and_sets_of_the_drawing_are_as_they_were(self):
        # The same nodes and stones, but other stones are in the set that is held.
        other = DRAWING.replace('Physical Curve("ground") = {', 'Physical Curve("ground") = {2, ')
        self.refused(["its sets of blocks or edges differ"], drawing=other)
        more = DRAWING + 'Physical Curve("new") = {2};\n'  # for a load to come
        self.accepted(["stage 'later'"], drawing=more)


class FollowedFarAway(program.SceneTest):
    """Places are sought where the structure was drawn, however far it has gone since."""

    def test_a_node_that_is_observed_stays_the_same_one(self):
        wall = {f"s{k}": rectangle(0, 0.2 * k, 0.4, 0.2 * (k + 1)) for k in range(3)}
        drawing = stones.geo(wall, 0.1, {"ground": ("s0", 0)})
        goes = {"go": {"type": "settlement", "support": "ground", "ux": 0.3, "uy": 0.1, "rotation": 0.1}}
        places = {"corner": {"x": 0.4, "y": 0.6, "tolerance": 0.01}, "mean": {"blocks": "s1", "place": "mean"},
                  "held": {"place": "support", "support": "ground"}}
        loads = {**goes, "statue": {"type": "point load", "x": 0.1, "y": 0.6, "fy": -100.0, "tolerance": 0.01}}
        two = {"own weight": stones.OWN_WEIGHT, "go": {"increments": 2, "loads": {"go": 1.0, "statue": 1.0}}}
        three = {**two, "back": {"increments": 2, "loads": {"go": 0.9, "statue": 2.0}}}
        how = {"model": {"rotations": "finite"}, "observations": places}
        scene = lambda stages: stones.scene("stones.geo", ["ground"], loads, stages, **how)
        self.assertEqual(self.run_scene(scene(two), drawing=drawing, out="parts").code, 0)
        part = self.run_scene(scene(three), "--restart", out="parts")
        whole = self.run_scene(scene(three), out="whole")
        self.assertEqual((part.code, whole.code), (0, 0), part.said)
        self.assertEqual(part.warnings, whole.warnings)
        for mine, theirs in zip(part.history, whole.history):
            for key in mine:
                if key != "seconds" and mine[key] == mine[key]:
                    self.assertEqual(mine[key], theirs[key], key)


if __name__ == "__main__":
    program.main()

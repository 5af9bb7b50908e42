"""Stones of different thickness: weight, stiffness, joints, loads and limits by hand.

    thickness.py PROGRAM MPIEXEC

Set-up    A stone on another, drawn as CSV, 1 m wide; the lower one is 0.5 m thick, the upper one 0.2 m, or the other way round.
Expected  Reactions are the weights; a pressure on the top strains each stone by its own area; mortar between bears on the
          thinner; a push tips both, or the upper one alone, about corners by the moments of their weights.
Tolerance 1e-8 where fields are linear and cells hold them, the tolerance of the solver; 1e-6 for limit analysis.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import drawings  # noqa: E402  (folders of their own)
import program  # noqa: E402
from stones import xml  # noqa: E402

DENSITY, GRAVITY, YOUNG = 2000.0, 9.81, 1e9
LOW, HIGH = 0.8, 1.2  # [m] heights


def scene(lower, upper, loads, stages, dry=None, thickness=None, **sections):
    stone = {"Young modulus": YOUNG, "Poisson ratio": 0.0, "density": DENSITY}
    tree = {"mesh": {"type": "stones", "stones": {"file": "two.csv", "element size": 0.25}},
            "model": {"thickness": thickness or lower},
            "materials": {"all": stone, "top": {**stone, "blocks": "upper", "thickness": upper}},
            "joints": {"dry": {"friction coefficient": 0.9, **(dry or {})}}, "supports": {"ground": {"on": "base"}},
            "loads": {"weight": {"type": "self weight"}, **loads}, "steps": {"stages": stages}}
    tree.update({name.replace("_", " "): section for name, section in sections.items()})
    return xml("two", tree) + "\n"


class Thickness(program.SceneTest):
    def setUp(self):
        super().setUp()
        stones = {"lower": drawings.box(0, 0, 1, LOW), "upper": drawings.box(0, LOW, 1, HIGH)}
        (self.folder / "two.csv").write_text(drawings.csv(stones), encoding="utf-8")

    def close(self, found, wanted, tolerance=1e-8):
        self.assertLess(abs(found / wanted - 1), tolerance)

    def solved(self, text, **where):
        run = self.run_scene(text, **where)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run

    def test_each_stone_has_the_weight_of_its_thickness(self):
        for lower, upper, ranks in ((0.5, 0.2, 1), (0.2, 0.5, 2)):
            run = self.solved(scene(lower, upper, {}, {"rest": {"loads": {"weight": 1.0}}}), out=f"weight {ranks}", ranks=ranks)
            self.close(run.result["statics"]["reactions"]["ground"]["y_N"], DENSITY * GRAVITY * (LOW * lower + HIGH * upper))

    def test_a_pressure_strains_each_stone_by_its_own_area(self):
        pressure = 1e5
        load = {"press": {"type": "traction", "on": "top", "ty": -pressure}}
        for lower, upper in ((0.5, 0.2), (0.2, 0.5)):
            run = self.solved(scene(lower, upper, load, {"pressed": {"loads": {"press": 1.0}}}), out=f"{lower}")
            self.close(run.result["statics"]["reactions"]["ground"]["y_N"], pressure * upper)
            self.close(run.result["largest_displacement_m"], pressure / YOUNG * (HIGH + LOW * upper / lower))
            self.close(run.result["energy"]["elastic_J"],
                       0.5 * pressure * upper * run.result["largest_displacement_m"])

    def test_mortar_between_two_bears_on_the_thinner(self):
        pressure, stiffness = 1e5, 1e9
        load = {"press": {"type": "traction", "on": "top", "ty": -pressure}}
        mortar = {"normal stiffness": stiffness, "tangential stiffness": stiffness}
        for lower, upper in ((0.5, 0.2), (0.2, 0.5)):
            run = self.solved(scene(lower, upper, load, {"pressed": {"loads": {"press": 1.0}}}, dry=mortar), out=f"{lower}")
            of_stones = pressure / YOUNG * (HIGH + LOW * upper / lower)
            self.close(run.result["largest_displacement_m"], of_stones + pressure * upper / (stiffness * min(lower, upper)), 1e-6)

    def test_a_push_tips_by_the_moments_of_the_weights(self):
        push = {"push": {"type": "acceleration", "ax": GRAVITY}}
        stones = {"ground": drawings.box(-1, -0.5, 3, 0.5), "lower": drawings.box(0, 0, 1, LOW), "upper": drawings.box(0, LOW, 1, HIGH)}
        (self.folder / "two.csv").write_text(drawings.csv(stones), encoding="utf-8")
        for lower, upper in ((0.5, 0.2), (0.2, 0.5)):
            run = self.run_scene(scene(lower, upper, push, {"rest": {"loads": {"weight": 1.0}}}, load_factor={"pattern": {"push": 1.0}}),
                                 "--limit-analysis", out=f"{lower}")
            low, high = LOW * lower, HIGH * upper
            both = 0.5 * (low + high) / (low * LOW / 2 + high * (LOW + HIGH / 2))
            self.close(run.result["collapse"]["certified_upper"], min(both, 1.0 / HIGH), 1e-6)

    def test_a_cohesion_holds_on_the_thinner(self):
        cohesion = 2e3
        pull = {"drag": {"type": "traction", "on": "top", "tx": 1e4}}
        for lower, upper in ((0.5, 0.4), (0.4, 0.5)):
            text = scene(lower, upper, pull, {"rest": {"loads": {"weight": 1.0}}}, dry={"friction coefficient": 0.1, "cohesion": cohesion},
                         load_factor={"pattern": {"drag": 1.0}})
            run = self.run_scene(text, "--limit-analysis", out=f"{lower}")
            slides = (cohesion * min(lower, upper) + 0.1 * DENSITY * GRAVITY * HIGH * upper) / (1e4 * upper)
            tips = 0.5 * DENSITY * GRAVITY * HIGH / (1e4 * HIGH)
            self.close(run.result["collapse"]["certified_upper"], min(slides, tips), 1e-6)

    def test_in_space_a_mesh_has_a_thickness(self):
        tree = scene(1.0, 0.2, {}, {"rest": {"loads": {"weight": 1.0}}}).replace("two.csv", "two.obj")
        (self.folder / "two.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no upper\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
                                             encoding="utf-8")
        run = self.run_scene(tree, "--validate")
        self.assertEqual(run.code, 2, run.said)
        self.assertIn("scene > materials > top > thickness = 0.2 [m] is of plane meshes", run.words)


if __name__ == "__main__":
    program.main()

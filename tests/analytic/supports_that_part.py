"""Where two supports move differently each stone goes with its own, and between what they hold nothing bears.

usage: supports_that_part.py PROGRAM MPIEXEC

Set-up    Two stones side by side, each held along its bottom by a support of its own, and glued by a joint that nothing parts. One
          of the supports moves by a millimetre. Nothing violates the law of the joint, so all of it stays bonded.
Expected  In the lowest point of the joint both sides are held, each where its support is: that is no point to tie. What the
          structure stores is that of all points resolved as contact, whichever support moves, on 1 and 2 ranks.
Tolerance 1e-6 of the energy, a hundred times the tolerance of the solver; to tie the point misplaces a node of one stone by the
          whole millimetre, which takes several per cent of the energy.

Set-up    The same two stones, in the plane and in space, with a joint that can lose its strength, on mortar or without.
          One support moves away as far as the joint bears, and back: in load steps, and slowly in time.
Expected  Where both sides of the joint are held nothing determines a force: it bears none, opens with the supports, and
          neither stores nor loses energy. All else stays linear, so what is stored is half the reaction times the way, the
          work of the support likewise, no joint loses any strength, and nothing is left when it is back. In time damping
          takes the rest, and the book closes.
Tolerance 1e-6 of the energy; in time 5e-2: the reaction of the last of 20 steps is that of its middle.
"""

import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import solids  # noqa: E402
import stones  # noqa: E402


class Parting(program.SceneTest):
    def energy(self, moved, still, out, *settings, ranks=1):
        outlines = {"a": stones.rectangle(0, 0, 1, 1), "b": stones.rectangle(1, 0, 2, 1)}
        drawing = stones.geo(outlines, 0.25, {"moved": (moved, 0), "still": (still, 0)})
        glue = {"dry": {"friction coefficient": 0.6, "cohesion": float("inf"), "tension strength": float("inf")}}
        scene = stones.scene("stones.geo", ["moved", "still"],
                             {"down": {"type": "settlement", "support": "moved", "uy": -1e-3}},
                             {"moved": {"loads": {"down": 1.0}}}, joints=glue)
        run = self.run_scene(scene, *settings, drawing=drawing, out=out, ranks=ranks)
        self.assertEqual(run.outcome, "equilibrium", run.said)
        return run.history[-1]["elastic_J"]

    def test_each_stone_goes_with_its_support(self):
        for moved, still in ("a", "b"), ("b", "a"):
            right = self.energy(moved, still, f"{moved}_all", "--set", "selection/mode=all")
            self.assertGreater(right, 0)
            for ranks in 1, 2:
                energy = self.energy(moved, still, f"{moved}{ranks}", ranks=ranks)
                self.assertLess(abs(energy - right), 1e-6 * right, (moved, ranks))


class Held(program.SceneTest):
    WAY, STRENGTH = 2e-6, 4e4  # [m, Pa]

    def there_and_back(self, *, space, mortar, time, increments=1, ranks=1):
        glue = {"dry": {"friction coefficient": 0.6, "cohesion": 1e6, "tension strength": self.STRENGTH,
                        "fracture energy": 10.0, "shear fracture energy": 50.0}}
        if mortar:
            glue["dry"].update({"normal stiffness": 5e10, "tangential stiffness": 2e10})
        way = {"duration": 2.0, "time step": 0.1} if time else {"increments": increments}
        stages = {name: {**way, "loads": {"away": factor}} for name, factor in (("there", 1.0), ("back", 0.0))}
        self.folder.mkdir(parents=True, exist_ok=True)
        (self.folder / "stones.obj").write_text(
            solids.obj({"a": solids.box((0, 0, 0), (1, 1, 1)), "b": solids.box((1, 0, 0), (2, 1, 1))}), encoding="utf-8")
        mesh = {"type": "stones", "stones": {"file": "stones.obj", "element size": 0.5}} if space else "stones.geo"
        supports = {name: {"on": "base", "blocks": block} if space else {"on": name}
                    for name, block in (("still", "a"), ("moved", "b"))}
        drawing = stones.geo({"a": stones.rectangle(0, 0, 1, 1), "b": stones.rectangle(1, 0, 2, 1)}, 0.5,
                             {"still": ("a", 0), "moved": ("b", 0)})
        scene = stones.scene(mesh, supports,
                             {"away": {"type": "settlement", "support": "moved", "ux": self.WAY}}, stages, joints=glue,
                             selection={"mode": "all"}, steps={"time": {"stiffness damping": 1e-2}} if time else {},
                             observations={"moved": {"place": "support", "support": "moved"}})
        run = self.run_scene(scene, drawing=drawing, ranks=ranks,
                             out="_".join(map(str, (space, mortar, time, increments, ranks))))
        self.assertEqual(run.code, 0, run.said)
        return run

    def check(self, run, there, small):
        end, back = run.history[there], run.history[-1]
        work = end["fx_N of moved"] * self.WAY / 2
        self.assertGreater(end["open_points"], 0)
        self.assertGreater(work, 0)
        self.assertLess(abs(end["elastic_J"] - work), small * work, run.said)
        self.assertLess(abs(end["external_work_J"] - work), small * work, run.said)
        for row in end, back:
            for lost in "friction_J", "fracture_J", "jump_J", "work_within_steps_J", "imbalance_J":
                self.assertLess(abs(row[lost]), small * work, (lost, run.said))
        for gone in "elastic_J", "external_work_J":
            self.assertLess(abs(back[gone]), small * work, (gone, run.said))

    def test_what_is_held_on_both_sides_neither_stores_nor_loses(self):
        for space, mortar in (False, False), (False, True), (True, False), (True, True):
            for increments, ranks in (1, 1), (3, 2):
                with self.subTest(space=space, mortar=mortar, increments=increments):
                    run = self.there_and_back(space=space, mortar=mortar, time=False, increments=increments, ranks=ranks)
                    self.assertEqual(run.outcome, "equilibrium", run.said)
                    self.check(run, increments - 1, 1e-6)

    def test_nor_in_time(self):
        for space in False, True:
            with self.subTest(space=space):
                self.check(self.there_and_back(space=space, mortar=False, time=True), 19, 5e-2)


if __name__ == "__main__":
    program.main()

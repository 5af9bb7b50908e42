"""Stones whose faces are held altogether: what lies between held nodes costs no solve.

usage: held_whole.py PROGRAM MPIEXEC

Set-up    Cubes of tetrahedra on slabs all of whose surface is held. A slab as thin as two cells has nodes inside that are
          alone between held ones.
Expected  Equilibrium in a few solves, no word of a library on stderr, and supports bear the weight of all stones.
Tolerance 1e-7 of the weight, ten times what the solver leaves of forces.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
import solids  # noqa: E402
from stones import xml  # noqa: E402

GRAVITY, DENSITY = 9.81, 2000.0
SLAB = ((-1, -1, -0.2), (2, 2, 0))
CUBE = ((0, 0, 0), (0.5, 0.5, 0.5))
FAR = [((4, -1, -0.2), (7, 2, 0)), ((5, 0, 0), (5.5, 0.5, 0.5))]  # the same once more


def volume(box):
    low, high = box
    return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2])


class HeldWhole(program.SceneTest):
    def stand(self, boxes, slabs, size, element="linear", ranks=1):
        (self.folder / "stones.obj").write_text(solids.obj({n: solids.box(*b) for n, b in boxes.items()}), encoding="utf-8")
        mesh = {"file": "stones.obj", "element size": size, "element": element, "cells": "tetrahedra"}
        text = xml("held", {
            "mesh": {"type": "stones", "stones": mesh},
            "materials": {"stone": {"Young modulus": 10e9, "Poisson ratio": 0.2, "density": DENSITY}},
            "joints": {"dry": {"friction coefficient": 0.6}},
            "supports": {name: {"on": "faces", "blocks": name} for name in slabs},
            "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}}, "selection": {"mode": "all"},
            "steps": {"stages": {"own weight": {"loads": {"weight": 1.0}}}}}) + "\n"
        run = self.run_scene(text, ranks=ranks, out=f"{len(boxes)} {size} {element} {ranks}")
        self.assertEqual((run.code, run.outcome), (0, "equilibrium"), run.said)
        self.assertNotIn("MueLu", run.said)
        self.assertLess(run.result["linear_solves"], 10)
        self.assertEqual(run.result["failed_linear_solves"], 0)
        weight = GRAVITY * DENSITY * sum(volume(b) for b in boxes.values())
        borne = sum(run.result["statics"]["reactions"][name]["z_N"] for name in slabs)
        self.assertLess(abs(borne - weight), 1e-7 * weight)

    def test_a_cube_stands_on_a_slab_that_is_held(self):
        for ranks in (1, 2):
            self.stand({"slab": SLAB, "cube": CUBE}, ["slab"], 0.12, ranks=ranks)
        self.stand({"slab": SLAB, "cube": CUBE}, ["slab"], 0.13)

    def test_so_do_several(self):
        boxes = {"slab": SLAB, "cube": CUBE, "far slab": FAR[0], "far cube": FAR[1]}
        for ranks in (1, 4):
            self.stand(boxes, ["slab", "far slab"], 0.12, ranks=ranks)


if __name__ == "__main__":
    program.main()

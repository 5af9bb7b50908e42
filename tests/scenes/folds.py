"""Joints that bend: folds that a drawing has, and curves that a mesh cuts into pieces.

usage: folds.py PROGRAM MPIEXEC

Set-up    A stone on a ridge that falls by a tenth to both sides, 11 degrees from side to side, pushed across it, friction
          0.2: in the plane, and as volumes of gmsh whose cells are kept. A stone in a round trough of 30 degrees, meshed
          with 3 and with 30 cells.
Expected  On the ridge rigid stones bear between 0.2923 and 0.2934 g (limits_in_space.py, which finds the same of a file of
          stones), whatever the cells: both sides hold at the ridge. One normal for both would give 0.1955 with one cell a
          side. Elastic stones stand below and fall above. In the trough 3 cells bear what 30 do: 10 degrees from cell to cell
          are no folds, and 0.2435 is borne, within what chords differ from the arc.
Tolerance The bracket that is named; 0.03 between 3 and 30 cells; ranks 1e-9.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402  (a folder of its own)
from stones import xml  # noqa: E402

GRAVITY = 9.81
RIDGE = """
DefineConstant[ cells = 1 ];
Point(1) = {-1, -1, 0}; Point(2) = {1, -1, 0}; Point(3) = {1, -0.1, 0}; Point(4) = {0, 0, 0}; Point(5) = {-1, -0.1, 0};
Point(6) = {1, 0.5, 0}; Point(7) = {-1, 0.5, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 1};
Line(6) = {3, 6}; Line(7) = {6, 7}; Line(8) = {7, 5};
Line Loop(1) = {1, 2, 3, 4, 5}; Line Loop(2) = {6, 7, 8, -4, -3};
Plane Surface(1) = {1}; Plane Surface(2) = {2};
Transfinite Line{3, 4} = cells + 1;
"""
FLAT = 'Physical Surface("below") = {1}; Physical Surface("above") = {2}; Physical Line("bed") = {1};\n'
DEEP = """
low[] = Extrude {0, 0, -1} { Surface{1}; Layers{1}; };
high[] = Extrude {0, 0, -1} { Surface{2}; Layers{1}; };
Physical Volume("below") = {low[1]}; Physical Volume("above") = {high[1]}; Physical Surface("bed") = {low[2]};
"""
TROUGH = """
DefineConstant[ cells = 3 ];
r = 2; a = 15 * Pi / 180;
Point(1) = {0, 0, 0}; Point(2) = {-r * Sin(a), -r * Cos(a), 0}; Point(3) = {r * Sin(a), -r * Cos(a), 0};
Point(4) = {-r * Sin(a), -r - 0.5, 0}; Point(5) = {r * Sin(a), -r - 0.5, 0};
Point(6) = {-r * Sin(a), -r + 0.5, 0}; Point(7) = {r * Sin(a), -r + 0.5, 0};
Circle(1) = {2, 1, 3};
Line(2) = {4, 5}; Line(3) = {5, 3}; Line(4) = {2, 4}; Line(5) = {3, 7}; Line(6) = {7, 6}; Line(7) = {6, 2};
Line Loop(1) = {2, 3, -1, 4}; Line Loop(2) = {1, 5, 6, 7};
Plane Surface(1) = {1}; Plane Surface(2) = {2};
Transfinite Line{1} = cells + 1;
Physical Surface("below") = {1}; Physical Surface("above") = {2}; Physical Line("bed") = {2};
"""


def scene(kind, cells, stages=None, across="ax", **mesh):
    tree = {"mesh": {"type": kind, kind: {"file": "drawing.geo", "geometry": {"cells": float(cells)}, **mesh}},
            "materials": {"stone": {"Young modulus": 20e9, "Poisson ratio": 0.2, "density": 2000.0}},
            "joints": {"dry": {"friction coefficient": 0.2}}, "supports": {"ground": {"on": "bed"}},
            "loads": {"weight": {"type": "self weight", "gravity": GRAVITY}, "push": {"type": "acceleration", across: GRAVITY}},
            "steps": {"stages": {"own weight": {"loads": {"weight": 1.0}}, **(stages or {})}}}
    if not stages:
        tree["load factor"] = {"pattern": {"push": 1.0}, "accuracy": 0.005}
    return xml("folds", tree) + "\n"


class Folds(program.SceneTest):
    def run_drawing(self, drawing, text, *options, **more):
        (self.folder / "drawing.geo").write_text(drawing, encoding="utf-8")
        return self.run_scene(text, *options, **more)

    def limits(self, run):
        self.assertEqual(run.outcome, "collapse", run.said)
        return run.result["rigid"]["forces_found_up_to"], run.result["collapse"]["certified_upper"]

    def on_the_ridge(self, run):
        borne, found = self.limits(run)
        self.assertLessEqual(found, 0.2934)
        self.assertGreaterEqual(borne, 0.2923)
        return found

    def test_both_sides_of_a_ridge_hold(self):
        found = [self.on_the_ridge(self.run_drawing(RIDGE + FLAT, scene("gmsh", cells), "--limit-analysis", out=f"{cells} {ranks}",
                                                    ranks=ranks))
                 for cells, ranks in ((1, 1), (4, 1), (4, 2))]
        for other in found:
            self.assertLess(abs(other - found[0]), 1e-9)

    def test_both_sides_of_a_ridge_of_volumes_hold(self):
        for cells in (1, 2):
            run = self.run_drawing(RIDGE + DEEP, scene("stones", cells, across="ay", up="y"), "--limit-analysis", out=str(cells))
            self.assertIn("2 volumes as the file has them meshed", run.words)
            self.on_the_ridge(run)

    def test_elastic_stones_stand_below_and_fall_above(self):
        for push, outcome in ((0.28, "equilibrium"), (0.30, "collapse")):
            text = scene("gmsh", 4, {"push": {"loads": {"weight": 1.0, "push": push}}})
            self.assertEqual(self.run_drawing(RIDGE + FLAT, text, out=str(push)).outcome, outcome)

    def test_curves_are_no_folds(self):
        coarse, fine = (self.limits(self.run_drawing(TROUGH, scene("gmsh", cells), "--limit-analysis", out=str(cells)))[1]
                        for cells in (3, 30))
        self.assertLess(abs(coarse / fine - 1), 0.03, (coarse, fine))


if __name__ == "__main__":
    program.main()

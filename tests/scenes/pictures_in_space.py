"""Which lines of a structure in space its pictures show: those that no face hides from the viewer.

usage: pictures_in_space.py

Set-up    A square over part of another one, seen from above; a point is hidden where it lies inside the square in front of it.
          Two cubes side by side, one of which moves behind the other, as far as it is drawn to have moved.
"""

import dataclasses
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "drivers" / "report"))
import draw_space  # noqa: E402  (a folder of its own)
import hidden_lines  # noqa: E402
from geometry import deformation_scale  # noqa: E402
from read_results import MECHANISM, Mesh, Results, Step  # noqa: E402

LOW = np.array([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], float)
HIGH = np.array([[2, 2, 1], [6, 2, 1], [6, 6, 3], [2, 6, 3]], float)  # a slope: nearer at its far end


class HiddenLines(unittest.TestCase):
    def test_a_point_behind_a_face_is_hidden(self):
        points = np.array([[1, 1, 0], [3, 3, 0], [3, 3, 1.4], [3, 3, 1.6], [5, 5, 2.4], [5, 5, 2.6], [6.1, 5, 0]])
        found = hidden_lines.seen(points, np.stack([LOW, HIGH]))
        self.assertEqual(found.tolist(), [True, False, False, True, False, True, True])

    def test_a_line_on_its_own_face_is_seen(self):
        middle = (HIGH + np.roll(HIGH, 1, 0)) / 2
        self.assertTrue(hidden_lines.seen(middle, np.stack([LOW, HIGH])).all())
        self.assertTrue(hidden_lines.seen(middle[:, [0, 2, 1]], np.stack([HIGH])[:, :, [0, 2, 1]]).all())  # from its edge

    def test_a_line_that_goes_behind_a_face_is_cut_there(self):
        nodes = np.concatenate([LOW, HIGH])
        edges = np.array([[1, 2], [0, 1]])  # of the lower square: one goes behind the other square half way
        pieces, *between = hidden_lines.cut(edges, len(nodes))
        places = hidden_lines.with_new_nodes(nodes, *between)
        self.assertEqual(len(pieces), 2 * hidden_lines.PIECES)
        np.testing.assert_allclose(places[pieces[:, 1]].sum(0) - places[pieces[:, 0]].sum(0), [4, 4, 0], atol=1e-12)
        seen = hidden_lines.seen(places[pieces].mean(1), np.stack([LOW, HIGH]))
        half = hidden_lines.PIECES // 2
        self.assertEqual(seen.tolist(), [True] * half + [False] * half + [True] * hidden_lines.PIECES)


CUBE = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)
ASIDE = 8 * draw_space.screen()[:, 0]  # [m]


def cubes(stage="push"):
    """A cube, and a larger one in front of where half of a step moves it to."""
    front = CUBE.mean(0) + ASIDE / 2 + 5 * draw_space.TOWARDS_VIEWER
    mesh = Mesh(np.concatenate([CUBE, 3 * (CUBE - CUBE.mean(0)) + front]), np.arange(16).reshape(2, 8), np.arange(2), 2, np.zeros(2, int), {},
                set(), np.zeros(16, int))
    none = np.zeros(0)
    moved = np.concatenate([np.tile(ASIDE, (8, 1)), np.zeros((8, 3))])
    return Results(pathlib.Path(), mesh=mesh, stage_ends=[Step(1, stage, 1.0, moved, none, none, none, none, none, none, none, none, None)])


class WhatIsSeenOfMotions(unittest.TestCase):
    def test_what_moves_behind_a_stone_is_hidden_there(self):
        flat, edges, edges_of, _ = draw_space.projected(cubes())
        step = flat.last
        moves = np.linalg.norm(step.displacement, axis=1) > 0
        self.assertEqual(edges_of(step, 0.0).tolist(), edges.tolist())
        # Three of the edges of a cube lie behind it.
        for scale, seen in ((0.0, 9), (0.5, 0), (1.0, 9)):
            self.assertEqual(moves[edges_of(step, scale)].all(1).sum(), seen * hidden_lines.PIECES)

    def test_what_has_moved_far_is_drawn_true_to_scale(self):
        results = cubes()
        whole = results.last.displacement
        for share, least, most in ((1e-4, 100, 1000), (0.1, 1, 1), (0.4, 1, 1), (100, 0, 0.1)):  # the last is out of sight
            step = dataclasses.replace(results.last, displacement=share * whole)
            self.assertTrue(least <= deformation_scale(results.mesh, step) <= most, share)
        mechanism = cubes("push" + MECHANISM)
        self.assertLess(deformation_scale(mechanism.mesh, mechanism.last), 0.1)


if __name__ == "__main__":
    unittest.main()

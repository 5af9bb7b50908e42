"""Which lines of a structure in space its pictures show: those that no face hides from the viewer.

usage: pictures_in_space.py

Set-up    A square over part of another one, seen from above; a point is hidden where it lies inside the square in front of it.
"""

import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "drivers" / "report"))
import hidden_lines  # noqa: E402  (a folder of its own)

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


if __name__ == "__main__":
    unittest.main()

"""A stone that tips away from its neighbour gets no help from friction, however large it is and whatever the theorem says.

    beside_a_neighbour.py PROGRAM

Stones of width b stand on each other beside one that is held, and are pushed away from it by a share of their weight.
They tip about their lowest corner at b / h, h the height of them all. Their sides move up along the neighbour and away
from it at once. Friction that dilates, as limit analysis has it, forbids that: it certifies twenty times as much and
more. Coulomb's does not: what parts bears nothing.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "ground"))

import scenes  # noqa: E402  (modules of the folder above)
from drawing import Drawing  # noqa: E402

PROGRAM = None
WIDTH, HEIGHT = 0.5, 0.83  # [m] of a stone
ACCURACY = 0.01  # of a search


def scene(stones, friction, first):
    drawing = Drawing(0.2)
    for k in range(stones):
        drawing.box(0.0, k * HEIGHT, WIDTH, HEIGHT)
        drawing.box(-0.5, k * HEIGHT, 0.5, HEIGHT, left="ground")
    drawing.box(0.0, -0.4, WIDTH, 0.4, bottom="ground")
    sought = {"pattern": {"push": 1.0}, "first factor": first, "largest factor": 10.0, "accuracy": ACCURACY}
    return scenes.scene(drawing, friction=friction, loads={"push": {"type": "acceleration", "ax": scenes.GRAVITY}},
                        load_factor=sought)


class BesideANeighbour(unittest.TestCase):
    def test_stones_tip_at_width_over_height_whatever_friction_and_way(self):
        for stones, friction, first in ((1, 50.0, 0.1), (1, 5.0, 0.02), (2, 50.0, 0.02), (2, 5.0, 0.1)):
            with self.subTest(stones=stones, friction=friction), tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                path = scenes.write(scene(stones, friction, first), folder)
                subprocess.run([PROGRAM, f"--xml={path}", f"--out={folder / 'out'}", "--quiet"], check=True)
                found = json.loads((folder / "out" / "result.json").read_text())["collapse"]
                tips = WIDTH / (stones * HEIGHT)
                print(f"{stones} stones, friction {friction}: {found['lower']:.5f} to {found['upper']:.5f}, tips at {tips}")
                self.assertIsNone(found["certified_upper"])
                self.assertLess(found["lower"], tips)
                self.assertGreater(found["upper"], tips)
                self.assertLessEqual(found["upper"] - found["lower"], ACCURACY * found["upper"])


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    unittest.main(argv=sys.argv[:1], verbosity=2)

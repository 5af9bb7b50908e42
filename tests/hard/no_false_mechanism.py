"""A load far below what the static theorem certifies, approached in small steps, is not called a collapse.

    no_false_mechanism.py PROGRAM

The stones of this arch leave a springing sideways and collide: iterates go far while their forces do not obey the
contact law, and such a motion proves nothing. What the solver does not find it must call not converged.
"""

import pathlib
import sys
import tempfile
import unittest

import certificates

PROGRAM = None
SEED = 47  # an arch of eight stones with friction 50, pushed sideways; bears 2.353 times the push at most


def in_steps(first, second):
    """The arch under its weight, then pushed in 4 increments to the first factor and in 8 to the second."""
    structure = certificates.Random(SEED)
    scene = structure.scene(second)
    stages = scene["steps"]["stages"]
    loads = stages.pop("beyond")["loads"]
    stages["first"] = {"increments": 4, "loads": {name: factor * first / second for name, factor in loads.items()}}
    stages["second"] = {"increments": 8, "loads": loads}
    return structure, scene


class NoFalseMechanism(unittest.TestCase):
    def test_half_of_what_can_be_borne_is_no_collapse_on_any_way_there(self):
        for first, second in ((0.8, 1.6), (0.4, 1.2), (0.6, 1.4)):
            with self.subTest(first=first, second=second), tempfile.TemporaryDirectory() as folder:
                structure, scene = in_steps(first, second)
                self.assertGreater(structure.limit(), second)
                result = certificates.run(PROGRAM, pathlib.Path(folder) / "run", scene)
                self.assertNotEqual(result["outcome"], "collapse", result.get("message"))


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    unittest.main(argv=sys.argv[:1], verbosity=2)

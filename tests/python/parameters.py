"""`voussoir --print-parameters=json` says what xml/reference.xml says, and the package judges values as the program does.

    parameters.py PROGRAM MPIEXEC
"""

import html
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402
import sweeps  # noqa: E402

voussoir = sweeps.package()
from voussoir import parameters  # noqa: E402

# xml/reference.xml is what the program prints (tests/house/reference.py); here the program is asked itself.
DEFAULT = re.compile(r"default (\S+?)(?=: )")


def keys_of(members, path=()):
    """Pairs of a path and a declaration."""
    for member in members:
        here = (*path, parameters.name_of(member))
        yield here, member
        yield from keys_of(member.get("members", []), (*here, "*") if "family" in member else here)


def as_text(words):
    """Without breaks of lines, marks of comments and the form of numbers."""
    words = " ".join(html.unescape(words).replace("--", "- -").split())
    return DEFAULT.sub(lambda found: f"default {as_number(found.group(1))}", words)


def as_number(word):
    try:
        return repr(float(word))
    except ValueError:
        return word.lower() if word in ("True", "False") else word


class Agrees(sweeps.SweepTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.reference = subprocess.run([program.PROGRAM, "--print-parameters"], capture_output=True, text=True, check=True).stdout
        cls.all = list(keys_of(parameters.members()))

    def test_every_key_has_its_words_in_the_reference(self):
        reference = as_text(re.sub(r"<!--|-->|<Parameter[^>]*>|</ParameterList>", " ", self.reference))
        self.assertGreater(len(self.all), 200)
        paths = [path for path, _ in self.all]
        for path, member in self.all:
            # What loads of several types have in common the reference tells once, with the default of one of them.
            words = as_text(parameters.in_words(member))
            if paths.count(path) == 1:
                self.assertTrue(words in reference, (path, words))
        for path in dict.fromkeys(paths):
            words = [DEFAULT.sub("default", as_text(parameters.in_words(member))) for other, member in self.all if other == path]
            self.assertTrue(any(told in DEFAULT.sub("default", reference) for told in words), (path, words))

    def test_every_key_of_the_reference_is_there(self):
        known = {path[-1] for path, _ in self.all}
        text = self.reference
        for name in {path[-1] for path, member in self.all if member.get("type") in ("numbers", "list")}:
            text = re.sub(rf'<ParameterList name="{name}">(\s|<Parameter [^>]*/>|<!--.*?-->)*</ParameterList>', "", text, flags=re.DOTALL)
        families = {name for path, member in self.all if "family" in member
                    for name in re.findall(rf'<ParameterList name="([^"]*)"', text)} - known
        for name in re.findall(r'<Parameter name="([^"]*)"', text):
            self.assertIn(name, known)
        self.assertIn("weight", families)  # names that a user gives are no keys

    def test_types_are_those_of_the_reference(self):
        types = {}
        for name, kind in re.findall(r'<Parameter name="([^"]*)" type="([^"]*)"', self.reference):
            types.setdefault(name, set()).add(kind)
        for path, member in self.all:
            if "key" in member and member["type"] not in ("numbers", "list") and path[-1] in types:
                self.assertIn(member["type"], types[path[-1]], path)

    def test_ranges_admit_what_the_program_admits(self):
        scene = self.write(sweeps.wall(factor=sweeps.FACTOR))
        ends = {"mesh/wall/cells along": (1, 2, 3, 4, 10001), "joints/dry/friction coefficient": (-1e-9, 0, 1e9, "inf"),
                "materials/stone/Poisson ratio": (-1, -0.99, 0.499, 0.5), "model/thickness": (0, 1e-3, "inf"),
                "mesh/wall/courses": (0, 1, 2.5), "selection/mode": ("all", "al")}
        read = voussoir.Scene.read(scene)
        for path, values in ends.items():
            member = parameters.find(path.split("/"), read._values)
            for value in values:
                number = float("inf") if value == "inf" else value
                done = subprocess.run([program.PROGRAM, f"--xml={scene}", "--validate", "--set", f"{path}={value}"],
                                      capture_output=True, text=True, check=False)
                words = done.stderr.split("\n  ")[0]
                if done.returncode == 2 and path.split("/")[-1] not in words:
                    continue  # another key does not go with this value
                self.assertEqual(parameters.admits(member, number), done.returncode == 0, (path, value, done.stderr))


class Words(unittest.TestCase):
    def test_ranges_are_read_as_they_are_written(self):
        for text, inside, outside in ((">= 0 or inf", (0, 3, float("inf")), (-1, float("nan"), -float("inf"))),
                                      ("> -1 and < 0.5", (0,), (-1, 0.5)), (">= 2 and <= 8 and even", (2, 8), (3, 10)),
                                      ("finite", (-1e300,), (float("inf"),))):
            for value in inside:
                self.assertIn(value, parameters.Range(text))
            for value in outside:
                self.assertNotIn(value, parameters.Range(text))


if __name__ == "__main__":
    program.main()

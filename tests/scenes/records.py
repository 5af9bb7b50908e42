"""A ground that shakes by records in any unit and layout moves the same; what is laid out otherwise is refused.

    records.py PROGRAM

Stones that nothing holds lie still while the ground moves: seen from the ground they go against the double integral of the
record, by as much as the acceleration that is linear between its points says.
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "restart"))
from runs import empty  # noqa: E402  (a folder of its own)

PROGRAM = None
INPUT = 2
STEP, ROWS = 0.01, 51
TIMES = [STEP * k for k in range(ROWS)]
VALUES = [2.0 * math.sin(9 * t) * math.exp(-t) + 0.3 for t in TIMES]  # [m/s2], ends moving

SCENE = """<ParameterList name="stone">
  <ParameterList name="mesh">
    <Parameter name="type" type="string" value="wall"/>
    <ParameterList name="wall">
      <Parameter name="courses" type="int" value="1"/> <Parameter name="blocks per course" type="int" value="2"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="materials"><ParameterList name="stone"/></ParameterList>
  <ParameterList name="joints"><ParameterList name="dry"/></ParameterList>
  <ParameterList name="loads">
    <ParameterList name="quake"><Parameter name="type" type="string" value="ground motion"/>KEYS</ParameterList>
  </ParameterList>
  <ParameterList name="steps"><ParameterList name="stages">
    <ParameterList name="shaking">
      <Parameter name="duration" type="double" value="0.5"/> <Parameter name="time step" type="double" value="0.01"/>
      <Parameter name="at once" type="bool" value="true"/>
      <ParameterList name="loads"><Parameter name="quake" type="double" value="1"/></ParameterList>
    </ParameterList>
  </ParameterList></ParameterList>
  <ParameterList name="observations">
    <ParameterList name="stone"> <Parameter name="place" type="string" value="mean"/> </ParameterList>
  </ParameterList>
  <ParameterList name="output"> <Parameter name="every" type="int" value="1000"/> </ParameterList>
</ParameterList>
"""


def rows(*columns, separator=","):
    return "".join(separator.join(f"{v:.9g}" for v in row) + "\n" for row in zip(*columns))


def lines_of(values, count):
    return "".join("".join(f"{v:16.7E}" for v in values[k:k + count]) + "\n" for k in range(0, len(values), count))


def peer(values, units="ACCELERATION TIME SERIES IN UNITS OF G"):
    return f"INVENTED\nSTATION 1, 090\n{units}\nNPTS= {len(values):5d}, DT= {STEP:.5f} SEC\n" + lines_of(values, 5)


def double_integral(values):
    velocity = displacement = 0
    for a, b in zip(values, values[1:]):
        displacement += STEP * velocity + STEP * STEP * (2 * a + b) / 6
        velocity += STEP * (a + b) / 2
    return displacement


class Records(unittest.TestCase):
    def run_with(self, text, direction="x", **keys):
        """The last row of the history and result.json; what the program says where it refuses."""
        folder = empty("records/run")
        folder.mkdir(parents=True)
        (folder / "record.txt").write_text(text)
        keys[f"{direction} record"] = "record.txt"
        xml = ""
        for key, value in keys.items():
            kind = {str: "string", int: "int", float: "double"}[type(value)]
            xml += f'<Parameter name="{key.replace("_", " ")}" type="{kind}" value="{value}"/>'
        (folder / "stone.xml").write_text(SCENE.replace("KEYS", xml))
        done = subprocess.run([PROGRAM, f"--xml={folder / 'stone.xml'}", f"--out={folder / 'out'}", "--quiet"],
                              capture_output=True, text=True, check=False)
        if done.returncode == INPUT:
            return done.stderr
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(folder / "out" / "history.csv", newline="", encoding="utf-8") as file:
            last = list(csv.DictReader(file))[-1]
        return last, json.loads((folder / "out" / "result.json").read_text())

    def check(self, text, direction="x", **keys):
        last, result = self.run_with(text, direction, **keys)
        # The midpoint rule integrates lines over whole intervals to second order: 1e-4 of the step here.
        self.assertLess(abs(float(last[f"u{direction}_m of stone"]) + double_integral(VALUES)), 2e-5)
        self.assertEqual([w["what"] for w in result["warnings"]], ["record_ends_moving"])
        self.assertIn("baseline = corrected", result["warnings"][0]["text"])

    def test_all_units_and_layouts_move_the_ground_alike(self):
        gal, in_g = [100 * v for v in VALUES], [v / 9.80665 for v in VALUES]
        numbers = range(ROWS)
        self.check(rows(TIMES, VALUES))
        self.check("# t [s], a [cm/s2]\n" + rows(TIMES, gal, separator=";"), unit="cm/s2")
        self.check(lines_of(gal, 8), "y", unit="gal", layout="values", record_time_step=STEP)
        self.check(rows([1000 * v for v in VALUES]), unit="mm/s2", layout="values", record_time_step=STEP)
        self.check(peer(in_g), unit="g", layout="peer at2")
        self.check(",time,north,east\n" + rows(numbers, TIMES, numbers, VALUES), time_column=2, x_column=4)

    def test_what_is_laid_out_otherwise_is_refused_with_the_keys_that_read_it(self):
        for text, words in ((rows(range(ROWS), TIMES, VALUES), ("line 1", "holds 3", "time column", "x column")),
                            (rows(TIMES, VALUES, VALUES, separator="\t"), ("line 1", "holds 3")),
                            (lines_of(VALUES, 5), ("line 1", "holds 5", "two numbers", "layout = values")),
                            (peer(VALUES), ("line 5", "layout = peer at2"))):
            said = self.run_with(text)
            for word in (*words, "scene > loads > quake > x record"):
                self.assertIn(word, said)
        self.assertIn("unit = g", self.run_with(peer(VALUES), layout="peer at2"))  # where the unit was forgotten
        self.assertIn("another motion", self.run_with(peer(VALUES, "VELOCITY TIME SERIES IN UNITS OF CM/S"), unit="g",
                                                      layout="peer at2"))
        for keys in ({"x_column": 2}, {"layout": "values"}, {"record_time_step": STEP}, {"time_column": 1},
                     {"layout": "peer at2", "header_lines": 4}, {"time_column": 2, "x_column": 2}):
            self.assertIn("scene > loads > quake", self.run_with(rows(TIMES, VALUES), **keys))

    def test_a_corrected_baseline_brings_the_ground_back(self):
        silent = [0.0] * 5
        values = silent + VALUES[:ROWS - 10] + silent
        last, result = self.run_with(rows([STEP * k for k in range(len(values))], values), baseline="corrected")
        self.assertLess(abs(float(last["ux_m of stone"])), 2e-5)
        self.assertLess(abs(float(last["vx_m_per_s of stone"])), 1e-9)
        self.assertEqual(result["warnings"], [])


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    unittest.main(argv=sys.argv[:1])

"""Small scenes for tests of sweeps and of the package, and the command that runs sweeps."""

import csv
import os
import pathlib
import subprocess
import sys

import program

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = [sys.executable, "-B", str(ROOT / "drivers" / "sweep")]
# A wall of 3 courses of 2 stones that is pushed sideways until it falls: no drawing, some ten milliseconds.
WALL = """<ParameterList name="wall">
  <ParameterList name="mesh"> <Parameter name="type" type="string" value="wall"/>
    <ParameterList name="wall"> <Parameter name="courses" type="int" value="3"/>
      <Parameter name="blocks per course" type="int" value="2"/> OPENINGS </ParameterList> </ParameterList>
  <ParameterList name="model"> <Parameter name="thickness" type="double" value="0.2"/> </ParameterList>
  <ParameterList name="materials"> <ParameterList name="stone">
    <Parameter name="Young modulus" type="double" value="10e9"/> <Parameter name="Poisson ratio" type="double" value="0.2"/>
    <Parameter name="density" type="double" value="2000"/> </ParameterList> </ParameterList>
  <ParameterList name="joints"> <ParameterList name="dry">
    <Parameter name="friction coefficient" type="double" value="0.5"/> </ParameterList> </ParameterList>
  <ParameterList name="supports"> <ParameterList name="ground"> <Parameter name="on" type="string" value="base"/>
    </ParameterList> </ParameterList>
  <ParameterList name="loads">
    <ParameterList name="weight"> <Parameter name="type" type="string" value="self weight"/> </ParameterList>
    <ParameterList name="push"> <Parameter name="type" type="string" value="acceleration"/>
      <Parameter name="ax" type="double" value="9.81"/> </ParameterList> </ParameterList>
  <ParameterList name="observations"> <ParameterList name="top"> <Parameter name="x" type="double" value="0"/>
    <Parameter name="y" type="double" value="0.75"/> </ParameterList> </ParameterList>
  <ParameterList name="steps"> STEPS <ParameterList name="stages">
    <ParameterList name="own weight"> <ParameterList name="loads"> <Parameter name="weight" type="double" value="1"/>
      LOADS </ParameterList> </ParameterList> TIME </ParameterList> </ParameterList>
  FACTOR
</ParameterList>
"""
FACTOR = """<ParameterList name="load factor"> <ParameterList name="pattern"> <Parameter name="push" type="double" value="1"/>
  </ParameterList> <Parameter name="accuracy" type="double" value="0.01"/> </ParameterList>"""
PUSHED = """<Parameter name="push" type="double" value="0.1"/>"""
EXPECTED = """<Parameter name="expect collapse" type="bool" value="true"/>"""
OPENING = """<ParameterList name="openings"> <ParameterList name="door">
  <Parameter name="x from" type="double" value="0.25"/> <Parameter name="x to" type="double" value="0.75"/>
  <Parameter name="y from" type="double" value="0"/> <Parameter name="y to" type="double" value="0.25"/>
  </ParameterList> </ParameterList>"""
# As many steps as there is time, some milliseconds each.
SHAKEN = """<ParameterList name="rest"> <Parameter name="duration" type="double" value="0.1"/>
  <Parameter name="time step" type="double" value="1e-3"/> </ParameterList>"""


def wall(openings="", steps="", loads="", time="", factor=""):
    return (WALL.replace("OPENINGS", openings).replace("STEPS", steps).replace("LOADS", loads).replace("TIME", time)
            .replace("FACTOR", factor))


def package():
    """The package of python/, which is to drive the program that is tested."""
    sys.path.insert(0, str(ROOT / "python"))
    import voussoir

    return voussoir


def environment(**more):
    return {**os.environ, **program.ENVIRONMENT, "VOUSSOIR_PROGRAM": str(pathlib.Path(program.PROGRAM).resolve()), **more}


class SweepTest(program.SceneTest):
    @classmethod
    def setUpClass(cls):
        os.environ["VOUSSOIR_PROGRAM"] = str(pathlib.Path(program.PROGRAM).resolve())

    def write(self, text, name="wall.xml"):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    def command(self, scene, *options, out="sweep"):
        return [*COMMAND, str(scene), "--out", str(self.folder / out), *options]

    def sweep(self, scene, *options, out="sweep", seconds=300, **more):
        return subprocess.run(self.command(scene, *options, out=out), capture_output=True, text=True, check=False, timeout=seconds,
                              env=environment(**more))

    def begin(self, scene, *options, out="sweep"):
        return subprocess.Popen(self.command(scene, *options, out=out), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                env=environment())

    def rows(self, out="sweep"):
        with open(self.folder / out / "sweep.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

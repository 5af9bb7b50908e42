"""A brittle joint with few cells along it that bends is warned of as it comes near to its strength, with by how much.

    coarse_joints.py PROGRAM MPIEXEC

Two halves of a beam, glued; one is held at its end, the other bends the joint by its weight or is pulled off.
"""

import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "restart"))
from runs import empty, run_scene  # noqa: E402  (a folder of its own)

PROGRAM = MPIEXEC = None
DEPTH, WEIGHT = 0.3, 2500 * 9.81 * 0.3  # [m], [N/m]
EDGE = 6 * (WEIGHT / 2) / DEPTH**2  # [Pa] at the joint, 1 m from the free end

SCENE = f"""<ParameterList name="glued">
  <ParameterList name="mesh">
    <Parameter name="type" type="string" value="gmsh"/>
    <ParameterList name="gmsh">
      <Parameter name="file" type="string" value="{HERE / 'geo' / 'glued-halves.geo'}"/>
      <Parameter name="cells" type="string" value="quadrilateral"/>
      <ParameterList name="geometry"> <Parameter name="cells" type="double" value="3"/> </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="materials">
    <ParameterList name="stone">
      <Parameter name="density" type="double" value="2500"/> <Parameter name="Poisson ratio" type="double" value="0"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="joints">
    <ParameterList name="glue">
      <Parameter name="tension strength" type="double" value="{EDGE / 0.7}"/>
      <Parameter name="cohesion" type="double" value="1e7"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="supports">
    <ParameterList name="end"> <Parameter name="on" type="string" value="held"/> </ParameterList>
  </ParameterList>
  <ParameterList name="loads">
    <ParameterList name="weight"> <Parameter name="type" type="string" value="self weight"/> </ParameterList>
    <ParameterList name="pull">
      <Parameter name="type" type="string" value="traction"/> <Parameter name="on" type="string" value="end"/>
      <Parameter name="tx" type="double" value="{EDGE}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="steps"><ParameterList name="stages"><ParameterList name="hanging"><ParameterList name="loads">
    <Parameter name="weight" type="double" value="1"/> <Parameter name="pull" type="double" value="0"/>
  </ParameterList></ParameterList></ParameterList></ParameterList>
  <ParameterList name="output"> <Parameter name="fields" type="bool" value="false"/> </ParameterList>
</ParameterList>
"""


class CoarseJoints(unittest.TestCase):
    def warnings(self, *settings, ranks=1):
        folder = empty("coarse_joints")
        folder.mkdir(parents=True)
        (folder / "glued.xml").write_text(SCENE)
        result = run_scene(PROGRAM, MPIEXEC, folder / "out", folder / "glued.xml", *settings, ranks=ranks)
        self.assertEqual(result["outcome"], "equilibrium")
        return result["warnings"]

    def test_bending_near_the_strength_is_overrated_by_two_thirds_of_a_cell(self):
        for cells, ranks in ((3, 1), (3, 2), (2, 1), (5, 1)):
            found = self.warnings(f"mesh/gmsh/geometry/cells={cells}", ranks=ranks)
            self.assertEqual([w["what"] for w in found], ["coarse_joint"])
            self.assertEqual(found[0]["where"], "scene > joints > glue")
            # Near the held end stress is a few percent off a line; points at less than half of the strength count as half.
            points = max(0.7 * (1 - 2 / (3 * cells)), 0.5)
            self.assertLess(abs(found[0]["how_much"] - (0.7 / points - 1)), 0.05)
            self.assertIn(f"has {cells} cells along it", found[0]["text"])

    def test_a_fine_joint_one_far_from_its_strength_and_one_that_is_pulled_are_not(self):
        self.assertEqual(self.warnings("mesh/gmsh/geometry/cells=6"), [])
        self.assertEqual(self.warnings(f"joints/glue/tension strength={EDGE / 0.4}"), [])
        self.assertEqual(self.warnings("steps/stages/hanging/loads/weight=0", "steps/stages/hanging/loads/pull=1"), [])
        self.assertEqual(self.warnings("joints/glue/tension strength=inf", "joints/glue/cohesion=inf"), [])

    def test_glue_that_some_ranks_do_not_see_is_judged_by_all_of_them(self):
        glue = ('<ParameterList name="glue"> <Parameter name="between" type="string" value="course 10"/>'
                '<Parameter name="and" type="string" value="course 11"/>'
                '<Parameter name="cohesion" type="double" value="1e6"/> </ParameterList>')
        xml = (HERE.parents[1] / "xml" / "wall.xml").read_text()
        end = xml.index("</ParameterList>", xml.index('<ParameterList name="dry">')) + len("</ParameterList>")
        folder = empty("coarse_joints")
        folder.mkdir(parents=True)
        (folder / "wall.xml").write_text(xml[:end] + glue + xml[end:])
        result = run_scene(PROGRAM, MPIEXEC, folder / "out", folder / "wall.xml", "mesh/wall/courses=12",
                           "mesh/wall/blocks per course=2", "steps/stages/push/loads/sideways=0.1", ranks=3)
        self.assertEqual(result["outcome"], "equilibrium")


if __name__ == "__main__":
    PROGRAM, MPIEXEC = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])

"""Scenes in Python: what is read is written, and a wrong key fails with the words of the program.

    scenes.py PROGRAM MPIEXEC
"""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program  # noqa: E402
import sweeps  # noqa: E402

voussoir = sweeps.package()
FRICTION = "joints/dry/friction coefficient"


class Scenes(sweeps.SweepTest):
    def words_of_program(self, scene, *options):
        done = subprocess.run([program.PROGRAM, f"--xml={scene}", "--validate", *options], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2, done.stdout)
        return done.stderr.strip()

    def test_what_is_read_is_written(self):
        for name in ("arch", "wall-shaken", "clare-college-bridge-history", "reference"):
            scene = voussoir.Scene.read(sweeps.ROOT / "xml" / f"{name}.xml")
            again = voussoir.Scene.read(scene.write(self.folder / f"{name}.xml"))
            self.assertEqual(again.text(self.folder), scene.text(self.folder), name)

    def test_a_scene_that_is_written_elsewhere_finds_its_drawing_and_its_record(self):
        for name in ("doorway", "wall-shaken"):
            scene = voussoir.Scene.read(sweeps.ROOT / "xml" / f"{name}.xml")
            said = voussoir.validate(scene.write(self.folder / f"{name}.xml"))
            self.assertIn("The scene is valid", said)

    def test_values_are_changed_added_and_taken_away(self):
        scene = voussoir.Scene.read(self.write(sweeps.wall()))
        self.assertEqual(scene[FRICTION], 0.5)
        scene[FRICTION] = 1
        self.assertEqual((scene[FRICTION], type(scene[FRICTION])), (1.0, float))
        scene["loads/wind"] = {"type": "traction", "on": "left", "tx": 500}
        scene["steps/stages/own weight/loads/wind"] = 1
        self.assertIn("loads/wind/tx", scene)
        self.assertEqual(scene["loads/wind/time function/type"], "constant")  # the default of the program
        self.assertIn("valid", scene.validate())
        del scene["loads/wind"]
        with self.assertRaises(voussoir.InputError) as refused:  # a stage names it
            scene.validate()
        self.assertIn("wind", str(refused.exception))
        self.assertIn("wall.xml: scene > ", str(refused.exception))

    def test_a_wrong_key_and_a_wrong_value_fail_with_the_words_of_the_program(self):
        file = self.write(sweeps.wall())
        text = file.read_text(encoding="utf-8")
        scene = voussoir.Scene.read(file)
        known = '<Parameter name="friction coefficient" type="double" value="0.5"/>'
        for path, value, written in (
                ("joints/dry/frictoin coefficient", 0.5, known + '<Parameter name="frictoin coefficient" type="double" value="0.5"/>'),
                (FRICTION, -0.5, known.replace('"0.5"', '"-0.5"')),
                (FRICTION, "much", known.replace('"0.5"', '"much"').replace("double", "string"))):
            wrong = self.write(text.replace(known, written), "wrong.xml")
            with self.assertRaises(voussoir.InputError) as refused:
                scene[path] = value
            self.assertEqual(str(refused.exception).replace("wall.xml", "wrong.xml"), self.words_of_program(wrong), path)
        self.assertEqual(scene[FRICTION], 0.5)  # as it was
        self.assertNotIn("joints/dry/frictoin coefficient", scene)

    def test_keys_of_another_choice_are_refused(self):
        scene = voussoir.Scene.read(self.write(sweeps.wall()))
        with self.assertRaises(voussoir.InputError) as refused:
            scene["mesh/arch/radius"] = 3
        self.assertIn("type = arch", str(refused.exception))

    def test_a_scene_is_made_from_nothing(self):
        scene = voussoir.Scene("made")
        scene["mesh"] = {"type": "wall", "wall": {"courses": 2, "blocks per course": 2}}
        scene["materials/stone"] = {"Young modulus": 1e10, "Poisson ratio": 0.2, "density": 2000}
        scene["joints/dry/friction coefficient"] = 0.6
        scene["supports/ground/on"] = "base"
        scene["loads/weight/type"] = "self weight"
        scene["steps/stages/own weight/loads/weight"] = 1
        self.assertEqual(scene.run(out=self.folder / "out").outcome, "equilibrium")
        with self.assertRaises(voussoir.InputError):
            scene["mesh/wall/rows"] = 3
        self.assertIn("courses", scene.keys("mesh/wall"))
        self.assertEqual(scene.keys("loads"), ["weight"])
        self.assertTrue(scene.describe("mesh/wall/courses").startswith("[-] >= 1 and <= 1e6, default 8: courses"))


if __name__ == "__main__":
    program.main()

"""The rules of the house refuse what they should: a test that cannot fail proves nothing."""

import pathlib
import unittest

import headers
import house
import layers
import sizes
import top_level


def include(path, name):
    return layers.problem_of(pathlib.Path(path), name)


class IncludesPointDown(unittest.TestCase):
    def test_a_module_may_include_itself_and_what_is_below(self):
        self.assertIsNone(include("src/mesh/mesh.hpp", "mesh/cell.hpp"))
        self.assertIsNone(include("src/joints/joint.hpp", "mesh/mesh.hpp"))
        self.assertIsNone(include("src/simulation/simulation.cpp", "output/history.hpp"))
        self.assertIsNone(include("drivers/voussoir.cpp", "scene/scene.hpp"))

    def test_a_module_may_not_include_what_is_above_or_beside(self):
        self.assertIn("points up", include("src/mesh/mesh.hpp", "joints/joint.hpp"))
        self.assertIn("points up", include("src/base/log.hpp", "mesh/mesh.hpp"))
        self.assertIn("points up", include("src/nonlinear/newton.cpp", "output/history.hpp"))
        self.assertIn("points up", include("src/mesh/mesh.cpp", "scene/scene.hpp"))

    def test_the_scene_sees_parameters_but_not_their_modules(self):
        self.assertIsNone(include("src/scene/scene.hpp", "mesh/mesh_parameters.hpp"))
        self.assertIn("points up", include("src/scene/scene.hpp", "mesh/mesh.hpp"))

    def test_parameters_are_plain_data(self):
        self.assertIsNone(include("src/mesh/mesh_parameters.hpp", "base/parameter_section.hpp"))
        self.assertIn("points up", include("src/joints/joint_parameters.hpp", "joints/joint.hpp"))

    def test_paths_start_at_src(self):
        self.assertIn("must start at src/", include("src/mesh/mesh.cpp", "mesh.hpp"))

    def test_a_library_has_one_owner_and_it_is_no_header(self):
        text = "#include <MueLu_Hierarchy.hpp>\n"
        one = (pathlib.Path("src/linalg/amg.cpp"), text)
        two = (pathlib.Path("src/linalg/other.cpp"), text)
        header = (pathlib.Path("src/linalg/amg.hpp"), text)
        self.assertEqual(layers.problems_of_libraries([one]), [])
        self.assertEqual(len(layers.problems_of_libraries([one, two])), 1)
        self.assertEqual(len(layers.problems_of_libraries([header])), 1)


class TheTopLevel(unittest.TestCase):
    def test_what_a_test_left_there_is_named(self):
        self.assertEqual(top_level.problems_of(["README.md", "src/mesh/mesh.hpp", ".gitignore"]), [])
        self.assertEqual(len(top_level.problems_of(["src/a.cpp", "copy-np1.h5", "fields-np1/fields.h5"])), 2)


class FilesAreShort(unittest.TestCase):
    def test_the_limit_itself_is_allowed(self):
        path = pathlib.Path("src/mesh/mesh.cpp")
        self.assertEqual(sizes.problems_of(path, "x\n" * 400), [])
        self.assertEqual(len(sizes.problems_of(path, "x\n" * 401)), 1)
        self.assertEqual(sizes.problems_of(path, "x" * 120), [])
        self.assertEqual(len(sizes.problems_of(path, "x" * 121)), 1)

    def test_files_are_found_at_all(self):
        self.assertIn(pathlib.Path("src/mesh/mesh.hpp"), house.code_files(".hpp"))
        self.assertIn(pathlib.Path("drivers/run"), house.scripts())


class HeadersCompileAlone(unittest.TestCase):
    def test_a_header_that_is_not_there_is_noticed(self):
        command = ["c++", "-fsyntax-only", "-x", "c++", "-"]
        self.assertIn("does not compile alone", headers.compile_alone("mesh/no_such_header.hpp", command))

    def test_a_change_below_a_header_is_a_change(self):
        self.assertIn("base/ids.hpp", headers.headers_below("mesh/mesh.hpp", {}))
        self.assertNotEqual(headers.digest("mesh/mesh.hpp", ["c++"]), headers.digest("mesh/mesh.hpp", ["c++", "-O2"]))


if __name__ == "__main__":
    unittest.main()

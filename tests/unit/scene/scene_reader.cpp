// What reading a scene gives: values, order, overrides, warnings, and names checked against a mesh.
#include "scene/scene_reader.hpp"

#include <cmath>

#include "support/repository.hpp"
#include "unit/scene/broken.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

bool holds(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

TEUCHOS_UNIT_TEST(SceneReader, TheWallIsTheReferenceWall) {
  const Scene wall = read_scene(path_of("wall"));
  TEST_EQUALITY_CONST(wall.name, "wall");
  TEST_ASSERT(wall.mesh.type == MeshType::wall);
  TEST_EQUALITY_CONST(wall.mesh.wall.courses, 8);
  TEST_EQUALITY_CONST(wall.mesh.wall.block_height, 0.25);
  TEST_EQUALITY_CONST(wall.materials.at(0).parameters.young_modulus, 10e9);
  TEST_EQUALITY_CONST(wall.materials.at(0).parameters.density, 2000.0);  // written without a point
  TEST_EQUALITY_CONST(wall.joints.at(0).parameters.friction_coefficient, 0.6);
  TEST_EQUALITY_CONST(wall.supports.at(0).parameters.on, "base");
  TEST_EQUALITY_CONST(load_as<AccelerationParameters>(wall.loads.at(1))->ax, 1.4715);
  TEST_EQUALITY_CONST(wall.stages.size(), 2u);
  TEST_EQUALITY_CONST(wall.stages.at(0).factors.at("weight"), 1.0);
  TEST_EQUALITY_CONST(wall.stages.at(1).factors.count("weight"), 0u);
  TEST_EQUALITY_CONST(wall.warnings.size(), 0u);
}

TEUCHOS_UNIT_TEST(SceneReader, MembersKeepTheOrderOfTheFile) {
  const std::string text =
      changed("wall", "<ParameterList name=\"stone\">",
              "<ParameterList name=\"zinc\"/><ParameterList name=\"brick\"/><ParameterList name=\"stone\">");
  const Scene scene = read_scene_from_text(text, path_of("wall"));
  TEST_EQUALITY_CONST(scene.materials.at(0).name, "zinc");
  TEST_EQUALITY_CONST(scene.materials.at(1).name, "brick");
  TEST_EQUALITY_CONST(scene.materials.at(2).name, "stone");
}

TEUCHOS_UNIT_TEST(SceneReader, InfinityIsAStrengthAndAByteOrderMarkIsNothing) {
  const Scene scene = read_scene_from_text("\xef\xbb\xbf" + changed("wall", "\"0.6\"", "\"inf\""), path_of("wall"));
  TEST_ASSERT(std::isinf(scene.joints.at(0).parameters.friction_coefficient));
}

TEUCHOS_UNIT_TEST(SceneReader, LettersMayBeEscapedAndALineMayEndWithinAValue) {
  const Scene scene = read_scene_from_text(
      changed("wall", "value=\"Running-bond wall", "value=\"l&#39;&#xe9;glise &amp; &lt;a&gt; &quot;b&quot;\nwall"),
      path_of("wall"));
  TEST_EQUALITY_CONST(scene.title, "l'\xc3\xa9glise & <a> \"b\" wall W(8) under 0.15 g");
}

TEUCHOS_UNIT_TEST(SceneReader, OverridesGoBeforeTheFileWhicheverWayTheyAreWritten) {
  const Scene scene =
      read_scene(path_of("wall"), {"selection/mode=bonded", "selection/mode=all", " mesh / wall/courses = 3",
                                   "scene > joints > dry > cohesion = inf", "newton/tolerance=1e-6", "output/report=no",
                                   "steps/stages/push/loads/weight=0.5", "title=a = b/c"});
  TEST_ASSERT(scene.selection.mode == SelectionMode::all);
  TEST_EQUALITY_CONST(scene.mesh.wall.courses, 3);
  TEST_ASSERT(std::isinf(scene.joints.at(0).parameters.cohesion));
  TEST_EQUALITY_CONST(scene.newton.tolerance, 1e-6);
  TEST_EQUALITY_CONST(scene.output.report, false);
  TEST_EQUALITY_CONST(scene.stages.at(1).factors.at("weight"), 0.5);
  TEST_EQUALITY_CONST(scene.title, "a = b/c");
}

TEUCHOS_UNIT_TEST(SceneReader, OverridesReachNumbersOfTheGeometryAndListsPassedOn) {
  const Scene scene = read_scene(path_of("reference"), {"mesh/gmsh/element size=0.06", "mesh/gmsh/geometry/pier_tilt=2",
                                                        "solver/Belos/Verbosity=33", "solver/MueLu/coarse/tol=0.5"});
  TEST_EQUALITY_CONST(scene.mesh.gmsh.element_size, 0.06);
  TEST_EQUALITY_CONST(scene.mesh.gmsh.geometry.at("pier_tilt"), 2.0);
  TEST_EQUALITY_CONST(scene.mesh.gmsh.geometry.at("deformed"), 0.0);
  TEST_EQUALITY_CONST(scene.solver.belos.get<int>("Verbosity"), 33);
  TEST_EQUALITY_CONST(scene.solver.muelu.sublist("coarse").get<double>("tol"), 0.5);
}

TEUCHOS_UNIT_TEST(SceneReader, OverridesThatAreWrongAreRefused) {
  const std::string text = scene_text(path_of("wall"));
  TEST_ASSERT(
      holds(said(text, "wall", {"joints/dri/cohesion=3"}), "--set joints/dri/cohesion=3\n  names no parameter"));
  TEST_ASSERT(holds(said(text, "wall", {"joints/dri/cohesion=3"}), "did you mean \"joints/dry/cohesion\"?"));
  TEST_ASSERT(holds(said(text, "wall", {"courses=3"}), "did you mean \"mesh/wall/courses\"?"));
  TEST_ASSERT(holds(said(text, "wall", {"selection/mode=al"}), "scene > selection > mode = \"al\""));
  TEST_ASSERT(
      holds(said(text, "wall", {"mesh/wall/courses=many"}), "scene > mesh > wall > courses = many (from --set)"));
  TEST_ASSERT(
      holds(said(text, "wall", {"newton/tolerance=2"}), "newton > tolerance = 2 (from --set) [-]\n  must be >= 1e-14"));
  TEST_ASSERT(holds(said(text, "wall", {"newton"}), "must be path=value"));
  TEST_ASSERT(holds(said(text, "wall", {"mesh/type=arch"}), "scene > mesh > wall is present"));
}

TEUCHOS_UNIT_TEST(SceneReader, TheFileOfTheMeshIsFoundInTheFoldersBesideTheScene) {
  const Scene scene = read_scene(path_of("reference"));
  TEST_EQUALITY_CONST(scene.mesh.gmsh.file, repository("/meshes/clare-college-bridge.geo"));
  const Scene other = read_scene(path_of("reference"), {"mesh/gmsh/file=meshes/clare-college-bridge.geo"});
  TEST_EQUALITY(other.mesh.gmsh.file, scene.mesh.gmsh.file);
}

TEUCHOS_UNIT_TEST(SceneReader, WhatIsNotUsedIsAWarning) {
  const std::string push = "<Parameter name=\"sideways\" type=\"double\" value=\"1.0\"/>";
  const Scene scene = read_scene_from_text(changed("wall", push, ""), path_of("wall"));
  TEST_EQUALITY_CONST(scene.remarks.size(), 2u);
  TEST_ASSERT(holds(scene.remarks.at(0).where + " " + scene.remarks.at(0).text, "stages > push names no load"));
  TEST_ASSERT(holds(scene.remarks.at(1).where + " " + scene.remarks.at(1).text, "loads > sideways never acts"));
}

TEUCHOS_UNIT_TEST(SceneReader, ALoadThatDoesNothingIsAWarning) {
  const Scene zero = read_scene(path_of("arch"), {"loads/spreading/ux=0"});
  TEST_EQUALITY_CONST(zero.remarks.size(), 1u);
  TEST_ASSERT(holds(zero.remarks.at(0).where + " " + zero.remarks.at(0).text, "loads > spreading is zero"));
  const Scene free = read_scene(path_of("arch"), {"supports/right/components=y"});
  TEST_EQUALITY_CONST(free.warnings.size(), 1u);
  TEST_ASSERT(holds(free.warnings.at(0).text, "has an ux that its support does not hold"));
}

TEUCHOS_UNIT_TEST(SceneReader, NamesOfSetsAreCheckedAgainstTheMesh) {
  Scene scene = read_scene(path_of("reference"));
  const std::vector<std::string> blocks{"ring west"};
  const std::vector<std::string> facets{"foundation abutment west", "foundation pier west", "foundation pier east",
                                        "foundation abutment east", "deck central",         "back west"};
  TEST_NOTHROW(check_names(scene, blocks, facets));
  scene.materials.at(0).parameters.blocks = "ring wets";
  scene.joints.at(0).parameters.and_ = "spandrel";
  scene.supports.at(0).parameters.on = "base";
  load_as<CrowdParameters>(scene.loads.at(5))->on = "deck";
  scene.observations = {{"crown", {}}};
  scene.observations.at(0).parameters.blocks = "crown";
  std::string message;
  try {
    check_names(scene, blocks, facets);
  } catch (const InputError& error) {
    message = error.what();
  }
  TEST_EQUALITY_CONST(problems_in(message, "reference"), 5);
  TEST_ASSERT(holds(message, "scene > observations > crown > blocks = \"crown\"\n  is no set of blocks of this mesh"));
  TEST_ASSERT(
      holds(message,
            "scene > materials > stone > blocks = \"ring wets\"\n  is no set of blocks of this mesh (did you mean "
            "\"ring west\"?).\n  Sets of blocks: all, ring west."));
  TEST_ASSERT(holds(message, "scene > joints > dry > and = \"spandrel\""));
  TEST_ASSERT(holds(message, "scene > supports > abutment west > on = \"base\"\n  is no set of facets"));
  TEST_ASSERT(holds(
      message,
      "scene > loads > crowd > on = \"deck\"\n  is no set of facets of this mesh (did you mean \"deck central\"?)"));
}

}  // namespace

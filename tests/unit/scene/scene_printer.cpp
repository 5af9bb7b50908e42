// A scene that is written reads back equal; the reference shows everything and is a scene itself.
#include "scene/scene_printer.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "unit/scene/broken.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

std::string written(const Scene& scene) {
  std::ostringstream os;
  write_scene(os, scene);
  return os.str();
}

TEUCHOS_UNIT_TEST(ScenePrinter, AWrittenSceneReadsBackEqualWhereverItLies) {
  for (const char* name : {"wall", "arch", "reference"}) {
    const std::string once = written(read_scene(path_of(name)));
    const std::string twice = written(read_scene_from_text(once, "/elsewhere/out/" + std::string(name) + ".xml"));
    TEST_EQUALITY(once, twice);
  }
}

TEUCHOS_UNIT_TEST(ScenePrinter, NumbersAndTextsComeBackToTheLastBit) {
  Scene scene = read_scene(path_of("reference"));
  scene.title = "<\"ashlar\" & 'rubble'> -- \xc3\xa9";
  scene.materials.at(0).parameters.young_modulus = 1e10 / 3;
  scene.materials.at(0).parameters.density = std::nextafter(2000.0, 3000.0);
  scene.joints.at(0).parameters.friction_coefficient = std::numeric_limits<double>::infinity();
  load_as<AccelerationParameters>(scene.loads.at(1))->ax = -std::numeric_limits<double>::denorm_min();
  scene.mesh.gmsh.geometry["deformed"] = 0.1;
  const Scene back = read_scene_from_text(written(scene), "/elsewhere/x.xml");
  TEST_EQUALITY(back.title, scene.title);
  TEST_EQUALITY(back.materials.at(0).parameters.young_modulus, scene.materials.at(0).parameters.young_modulus);
  TEST_EQUALITY(back.materials.at(0).parameters.density, scene.materials.at(0).parameters.density);
  TEST_EQUALITY(back.joints.at(0).parameters.friction_coefficient, scene.joints.at(0).parameters.friction_coefficient);
  TEST_EQUALITY(load_as<AccelerationParameters>(back.loads.at(1))->ax,
                load_as<AccelerationParameters>(scene.loads.at(1))->ax);
  TEST_EQUALITY(back.mesh.gmsh.geometry.at("deformed"), 0.1);
}

TEUCHOS_UNIT_TEST(ScenePrinter, ListsPassedOnKeepTheirTypes) {
  const std::string lists =
      "<ParameterList name=\"solver\"><ParameterList name=\"MueLu\"><Parameter name=\"max levels\" type=\"int\" "
      "value=\"4\"/>"
      "<Parameter name=\"threshold\" type=\"double\" value=\"1\"/><Parameter name=\"verbosity\" type=\"string\" "
      "value=\"5\"/>"
      "<Parameter name=\"symmetric\" type=\"bool\" value=\"true\"/><ParameterList name=\"smoother\">"
      "<Parameter name=\"weights\" type=\"Array(double)\" value=\"{0.5, "
      "0.25}\"/></ParameterList></ParameterList></ParameterList>";
  const Scene first = read_scene_from_text(
      changed("wall", "<ParameterList name=\"steps\">", lists + "<ParameterList name=\"steps\">"), path_of("wall"));
  const Scene second = read_scene_from_text(written(first), path_of("wall"));
  for (const Scene& scene : {first, second}) {
    const Teuchos::ParameterList& muelu = scene.solver.muelu;
    TEST_ASSERT(muelu.isType<int>("max levels"));
    TEST_ASSERT(muelu.isType<double>("threshold"));
    TEST_ASSERT(muelu.isType<std::string>("verbosity"));
    TEST_ASSERT(muelu.isType<bool>("symmetric"));
    TEST_EQUALITY_CONST(muelu.sublist("smoother").get<Teuchos::Array<double>>("weights")[1], 0.25);
  }
}

TEUCHOS_UNIT_TEST(ScenePrinter, OpeningsAreWritten) {
  const std::string wall = "<ParameterList name=\"wall\">\n      <Parameter name=\"courses\"";
  const std::string door =
      "<ParameterList name=\"wall\"><ParameterList name=\"openings\"><ParameterList name=\"door\">"
      "<Parameter name=\"x from\" type=\"double\" value=\"1.5\"/><Parameter name=\"x to\" type=\"double\" "
      "value=\"2.5\"/>"
      "<Parameter name=\"y to\" type=\"double\" value=\"1\"/></ParameterList></ParameterList><Parameter "
      "name=\"courses\"";
  const Scene scene = read_scene_from_text(changed("wall", wall, door), path_of("wall"));
  const Scene back = read_scene_from_text(written(scene), path_of("wall"));
  TEST_EQUALITY_CONST(back.mesh.wall.openings.at("door").x_from, 1.5);
  TEST_EQUALITY_CONST(back.mesh.wall.openings.at("door").y_to, 1.0);
}

TEUCHOS_UNIT_TEST(ScenePrinter, TheReferenceIsCurrentAndIsAScene) {
  std::ostringstream printed;
  print_reference(printed);
  TEST_EQUALITY(printed.str(), scene_text(path_of("reference")));
  TEST_EQUALITY_CONST(said(printed.str(), "reference"), "");
}

TEUCHOS_UNIT_TEST(ScenePrinter, TheReferenceNamesWhatEveryChoiceOffers) {
  std::ostringstream printed;
  print_reference(printed);
  for (const char* key : {"element size",  "courses", "x from",           "embrace",    "pier courses", "plane",
                          "Poisson ratio", "and",     "tension strength", "components", "gravity",      "ay",
                          "pressure",      "about y", "expect collapse",  "increments", "whole joints", "rigid blocks",
                          "MueLu",         "every"})
    TEST_INEQUALITY_CONST(printed.str().find("name=\"" + std::string(key) + "\""), std::string::npos);
}

TEUCHOS_UNIT_TEST(ScenePrinter, TheHeadOfARunShowsEveryMemberAndRemarks) {
  Scene scene = read_scene(path_of("arch"));
  scene.remarks.push_back({"remark", "scene > loads > moon", "", 0, "is full"});
  std::ostringstream os;
  print_scene(os, scene);
  for (const char* piece :
       {"31 voussoirs", "plane stress, thickness 1 m", "E 1e10 Pa", "mu 0.6", "\"springing right\": all held",
        "gravity 9.81 m/s2", "settlement of \"right\" by (0.005, 0) m", "1 increment to 1 x spreading", "adaptive",
        "warning: scene > loads > moon: is full."})
    TEST_INEQUALITY_CONST(os.str().find(piece), std::string::npos);
}

}  // namespace

// Values that are refused: each message names key, value, reason and a way out.
#include "unit/scene/broken.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

TEUCHOS_UNIT_TEST(BrokenScenes, TheUnchangedScenesAreAccepted) {
  for (const char* scene : {"wall", "arch", "reference"})
    TEST_EQUALITY_CONST(said(scene_text(path_of(scene)), scene), "");
}

TEUCHOS_UNIT_TEST(BrokenScenes, AMaterialThatCannotBeIsRefused) {
  refuse_each(
      {
          {"wall",
           "\"10e9\"",
           "\"0\"",
           {"scene > materials > stone > Young modulus = 0 [Pa]",
            "must be > 0 (a block without stiffness cannot carry)", "Sandstone has 5e9"}},
          {"wall", "\"10e9\"", "\"-1e9\"", {"Young modulus = -1e9 [Pa]", "must be > 0", "Sandstone"}},
          {"wall", "\"10e9\"", "\"nan\"", {"Young modulus = nan [Pa]", "must be > 0", "Sandstone"}},
          {"wall", "\"10e9\"", "\"inf\"", {"Young modulus = inf [Pa]", "must be > 0", "Sandstone"}},
          {"wall",
           "\"0.2\"",
           "\"0.5\"",
           {"Poisson ratio = 0.5 [-]", "must be > -1 and < 0.5", "incompressible", "Stone has 0.1 to 0.3."}},
          {"wall", "\"0.2\"", "\"-1\"", {"Poisson ratio = -1 [-]", "must be > -1", "Stone has"}},
          {"wall", "\"2000\"", "\"0\"", {"density = 0 [kg/m3]", "must be > 0", "weight and inertia", "1800 to 2700"}},
          {"wall",
           "\"thickness\" type=\"double\" value=\"1.0\"",
           "\"thickness\" type=\"double\" value=\"-0.2\"",
           {"scene > model > thickness = -0.2 [m]", "must be > 0", "depth of the stones"}},
          {"wall",
           "\"stress\"",
           "\"stres\"",
           {"scene > model > plane = \"stres\"", "one of stress, strain", "did you mean \"stress\"?"}},
      },
      out, success);
}

TEUCHOS_UNIT_TEST(BrokenScenes, AJointLawThatCannotBeIsRefused) {
  refuse_each(
      {
          {"wall",
           "\"0.6\"",
           "\"-0.3\"",
           {"wall.xml: scene > joints > dry > friction coefficient = -0.3 [-]\n  must be >= 0 or inf (a negative "
            "coefficient would create energy in sliding).\n  Give mu = tan(friction angle); dry stone is 0.5 to 0.8."}},
          {"wall", "\"0.6\"", "\"nan\"", {"friction coefficient = nan", "must be >= 0", "tan(friction angle)"}},
          {"wall", "\"0.6\"", "\"-inf\"", {"friction coefficient = -inf", "must be >= 0", "tan(friction angle)"}},
          {"wall",
           "\"0.6\"/>",
           "\"0.6\"/><Parameter name=\"cohesion\" type=\"double\" value=\"-1\"/>",
           {"cohesion = -1 [Pa]", "must be >= 0 or inf", "Dry joints have 0"}},
          {"wall",
           "\"0.6\"/>",
           "\"0.6\"/><Parameter name=\"tension strength\" type=\"double\" value=\"-1\"/>",
           {"tension strength = -1 [Pa]", "must be >= 0 or inf", "Dry joints have 0"}},
          {"wall",
           "\"0.6\"/>",
           "\"0.6\"/><Parameter name=\"normal stiffness\" type=\"double\" value=\"0\"/>",
           {"normal stiffness = 0 [Pa/m]", "must be > 0 or inf", "10 mm of lime mortar"}},
          {"wall",
           "\"0.6\"/>",
           "\"0.6\"/><Parameter name=\"tangential stiffness\" type=\"double\" value=\"1e15\"/>",
           {"tangential stiffness = 1e15 Pa/m", "must be <= 1e13 or inf", "a millimetre of stone", "Leave it out"}},
          {"rocking-column",
           "\"1.5\"/>",
           "\"1.5\"/><Parameter name=\"normal stiffness\" type=\"double\" value=\"1e11\"/>",
           {"scene > joints > dry > normal stiffness = 1e11 [Pa/m]", "stage \"rocking\", which has a duration",
            "Leave the stiffness or the duration out"}},
          {"wall-shaken",
           "<ParameterList name=\"model\">",
           "<ParameterList name=\"model\"><Parameter name=\"rotations\" type=\"string\" value=\"finite\"/>",
           {"scene > model > rotations = \"finite\"", "stage \"shaking\", which has a duration",
            "or leave the duration out"}},
          {"arch-seasons",
           "<ParameterList name=\"model\">",
           "<ParameterList name=\"model\"><Parameter name=\"rotations\" type=\"string\" value=\"finite\"/>",
           {"scene > model > rotations = \"finite\"", "heat presses along the axes of the drawing"}},
          {"spreading-arch",
           "\"ux\" type=\"double\" value=\"1\"/>",
           "\"rotation\" type=\"double\" value=\"1\"/></ParameterList><ParameterList name=\"tilting\">"
           "<Parameter name=\"type\" type=\"string\" value=\"settlement\"/>"
           "<Parameter name=\"support\" type=\"string\" value=\"right\"/>"
           "<Parameter name=\"rotation\" type=\"double\" value=\"0.5\"/>",
           {"scene > model > rotations = \"finite\"", "loads \"spreading\" and \"tilting\", which both turn support",
            "large turns do not add up"}},
          {"wall-mortar",
           "<ParameterList name=\"steps\">",
           "<ParameterList name=\"selection\"><Parameter name=\"mode\" type=\"string\" value=\"bonded\"/>"
           "</ParameterList><ParameterList name=\"steps\">",
           {"normal stiffness = 1e11 [Pa/m]", "a bond is rigid", "adaptive or all"}},
      },
      out, success);
}

TEUCHOS_UNIT_TEST(BrokenScenes, AMeshThatCannotBeIsRefused) {
  const std::string openings = "<ParameterList name=\"openings\"><ParameterList name=\"door\">";
  const auto door = [&](const char* x0, const char* x1, const char* y0, const char* y1) {
    const auto side = [](const char* name, const char* value) {
      return std::string("<Parameter name=\"") + name + "\" type=\"double\" value=\"" + value + "\"/>";
    };
    return "<ParameterList name=\"wall\">" + openings + side("x from", x0) + side("x to", x1) + side("y from", y0) +
           side("y to", y1) + "</ParameterList></ParameterList>";
  };
  const std::string wall = "<ParameterList name=\"wall\">\n      <Parameter name=\"courses\"";
  const std::string courses = "<Parameter name=\"courses\"";
  refuse_each(
      {
          {"wall",
           "\"4\"",
           "\"5\"",
           {"scene > mesh > wall > cells along = 5 [-]", "even (half blocks have half", "Give 2, 4, 6"}},
          {"wall", "\"8\"", "\"0\"", {"wall > courses = 0 [-]", "must be >= 1", "smallest bond"}},
          {"wall", "\"0.25\"", "\"0\"", {"block height = 0 [m]", "must be > 0", "Height of a course"}},
          {"wall",
           "\"quadrilateral\"",
           "\"quads\"",
           {"cells = \"quads\"", "one of triangle, quadrilateral, quadratic triangle",
            "P1 triangles, Q1 quadrilaterals"}},
          {"wall",
           wall,
           door("9", "10", "0", "1") + courses,
           {"wall > openings > door > x from = 9 to 10 [m]", "must meet the wall, which reaches from 0 to 4 m",
            "Move the opening"}},
          {"wall",
           wall,
           door("1", "2", "7", "8") + courses,
           {"door > y from = 7 to 8 [m]", "must meet the wall, which reaches from 0 to 2 m", "Move the opening"}},
          {"wall",
           wall,
           door("2", "1", "0", "1") + courses,
           {"door > x to = 1 [m]", "must be > x from = 2 (an opening needs an area)", "lower left corner"}},
          {"arch",
           "\"180\"",
           "\"360\"",
           {"arch > embrace = 360 [degree]", "must be > 0 and < 360", "A semicircle has 180."}},
          {"arch",
           "\"180\"",
           "\"0\"",
           {"arch > embrace = 0 [degree]", "must be > 0 and < 360", "A semicircle has 180."}},
          {"arch",
           "\"180\"/>",
           "\"150\"/><Parameter name=\"pier height\" type=\"double\" value=\"2\"/>",
           {"arch > pier height = 2 [m]", "needs an embrace of 180 degrees, not 150",
            "Give embrace 180 or pier height 0."}},
          {"arch",
           "\"1.0\"",
           "\"10\"",
           {"arch > thickness = 10 [m]", "must be < 2 x radius = 10", "0.05 to 0.3 radii"}},
          {"reference",
           "\"element size\" type=\"double\" value=\"0\"",
           "\"element size\" type=\"double\" value=\"-0.1\"",
           {"mesh > gmsh > element size = -0.1 [m]", "must be >= 0", "Give 0 for the size"}},
      },
      out, success);
}

TEUCHOS_UNIT_TEST(BrokenScenes, ALoadFactorThatCannotBeSoughtIsRefused) {
  const std::string end = "<ParameterList name=\"steps\">", start = "<ParameterList name=\"load factor\">";
  const auto raised = [&](const std::string& load, const std::string& more = "") {
    return start + more + "<ParameterList name=\"pattern\"><Parameter name=\"" + load +
           "\" type=\"double\" value=\"1\"/></ParameterList></ParameterList>" + end;
  };
  const auto number = [](const std::string& key, const std::string& value) {
    return "<Parameter name=\"" + key + "\" type=\"double\" value=\"" + value + "\"/>";
  };
  refuse_each(
      {
          {"oppenheim-arch",
           "\"sideways\" type=\"double\" value=\"1.0\"",
           "\"sidewards\" type=\"double\" value=\"1.0\"",
           {"load factor > pattern > sidewards = 1 [-]", "names no load of this scene (did you mean \"sideways\"?)",
            "Loads: weight, sideways."}},
          {"oppenheim-arch",
           "\"sideways\" type=\"double\" value=\"1.0\"",
           "\"sideways\" type=\"double\" value=\"0\"",
           {"load factor > pattern > sideways = 0", "must not be 0", "leave the load out"}},
          {"oppenheim-arch",
           "<ParameterList name=\"pattern\">",
           number("accuracy", "0") + "<ParameterList name=\"pattern\">",
           {"load factor > accuracy = 0 [-]", "must be >= 1e-5 and <= 0.5"}},
          {"oppenheim-arch",
           "<ParameterList name=\"pattern\">",
           number("first factor", "3") + number("largest factor", "2") + "<ParameterList name=\"pattern\">",
           {"load factor > largest factor = 2", "must be >= first factor = 3"}},
          {"wall-shaken",
           end,
           raised("weight"),
           {"load factor > pattern is given", "stage \"shaking\" has a duration", "Leave one of the two out."}},
          {"oppenheim-arch",
           "\"mode\" type=\"string\" value=\"all\"",
           "\"mode\" type=\"string\" value=\"bonded\"",
           {"load factor > pattern is given", "what is bonded does not collapse", "Give adaptive or all."}},
      },
      out, success);
}

TEUCHOS_UNIT_TEST(BrokenScenes, AnAccuracyThatCannotBeReachedIsRefused) {
  const std::string end = "<ParameterList name=\"steps\">";
  const auto with = [&](const std::string& section, const std::string& key, const std::string& type,
                        const std::string& value) {
    return "<ParameterList name=\"" + section + "\"><Parameter name=\"" + key + "\" type=\"" + type + "\" value=\"" +
           value + "\"/></ParameterList>" + end;
  };
  refuse_each(
      {
          {"wall",
           end,
           with("newton", "tolerance", "double", "0"),
           {"scene > newton > tolerance = 0 [-]", "must be >= 1e-14", "1e-8 is usual."}},
          {"wall",
           end,
           with("newton", "tolerance", "double", "1"),
           {"newton > tolerance = 1 [-]", "<= 0.01", "1e-8 is usual."}},
          {"wall",
           end,
           with("solver", "tolerance", "double", "1e-10"),  // who asks for a solution says how accurate it has to be
           {"solver > tolerance", "is not known here"}},
          {"wall",
           end,
           with("solver", "method", "string", "Cholesky"),
           {"solver > method = \"Cholesky\"", "one of CG", "symmetric positive definite"}},
          {"wall",
           end,
           with("selection", "bulk", "double", "0"),
           {"selection > bulk = 0 [-]", "must be > 0 and <= 1", "0.9 is usual"}},
          {"wall",
           end,
           with("selection", "error tolerance", "double", "1"),
           {"error tolerance = 1 [-]", ">= 0 and < 1", "0.01 is usual."}},
          {"wall",
           end,
           with("selection", "mode", "string", "adaptiv"),
           {"mode = \"adaptiv\"", "one of adaptive, all, bonded", "did you mean \"adaptive\"?"}},
          {"wall", end, with("output", "every", "int", "0"), {"output > every = 0 [-]", "must be >= 1", "load steps"}},
          {"wall",
           "<ParameterList name=\"own weight\">",
           "<ParameterList name=\"own weight\"><Parameter name=\"increments\" type=\"int\" value=\"0\"/>",
           {"stages > own weight > increments = 0 [-]", "must be >= 1", "load steps of this stage"}},
      },
      out, success);
}

}  // namespace

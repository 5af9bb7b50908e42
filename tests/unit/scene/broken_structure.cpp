// Scenes whose keys, types, names or choices are wrong, and files that are no scenes.
#include <filesystem>
#include <fstream>

#include "support/repository.hpp"
#include "unit/scene/broken.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

TEUCHOS_UNIT_TEST(BrokenScenes, AKeyThatIsNotKnownIsRefusedWithTheNearest) {
  refuse_each(
      {
          {"wall",
           "\"friction coefficient\"",
           "\"friction\"",
           {"scene > joints > dry > friction is not known here", "did you mean \"friction coefficient\"?",
            "knows: between, and, friction coefficient, cohesion, tension strength, fracture energy, "
            "shear fracture energy, softening, normal stiffness, tangential stiffness, initial gap."}},
          {"wall", "\"density\"", "\"dnesity\"", {"stone > dnesity", "did you mean \"density\"?"}},
          {"wall", "\"Young modulus\"", "\"young_modulus\"", {"young_modulus", "did you mean \"Young modulus\"?"}},
          {"wall",
           "<ParameterList name=\"model\">",
           "<ParameterList name=\"modle\">",
           {"scene > modle", "did you mean \"model\"?"}},
          {"wall",
           "\"gravity\"",
           "\"pressure\"",
           {"scene > loads > weight > pressure is present", "belongs to type = traction",
            "Remove it, or choose type = traction."}},
          {"wall",
           "<ParameterList name=\"mesh\">",
           "<ParameterList name=\"mesh\"><ParameterList name=\"arch\"/>",
           {"scene > mesh > arch is present", "belongs to type = arch", "Remove it, or choose"}},
      },
      out, success);
}

TEUCHOS_UNIT_TEST(BrokenScenes, AMissingKeyIsNamed) {
  refuse_each(
      {
          {"wall",
           "<Parameter name=\"type\" type=\"string\" value=\"wall\"/>",
           "",
           {"scene > mesh > type is missing", "where the blocks come from",
            "Give one of gmsh, wall, arch, wall in space"}},
          {"wall",
           "<Parameter name=\"on\" type=\"string\" value=\"base\"/>",
           "",
           {"scene > supports > ground > on is missing", "set of facets that is held", "base, top, left, right"}},
          {"wall",
           "value=\"base\"",
           "value=\"\"",
           {"supports > ground > on = \"\"", "must be a word, not empty", "Give a set of facets"}},
          {"arch",
           "<Parameter name=\"support\" type=\"string\" value=\"right\"/>",
           "",
           {"loads > spreading > support is missing", "Give a name from the section \"supports\"."}},
      },
      out, success);
}

TEUCHOS_UNIT_TEST(BrokenScenes, AValueOfAnotherTypeIsRefused) {
  refuse_each(
      {
          {"wall",
           "type=\"int\" value=\"8\"",
           "type=\"double\" value=\"8.5\"",
           {"wall > courses = 8.5 (double)", "must be of type int", "Write type=\"int\""}},
          {"wall",
           "type=\"int\" value=\"8\"",
           "type=\"int\" value=\"8.5\"",
           {"wall > courses = \"8.5\"", "must be a whole number", "Correct the value or the type."}},
          {"wall",
           "type=\"int\" value=\"8\"",
           "type=\"int\" value=\"99999999999\"",
           {"courses = \"99999999999\"", "at most ten digits"}},
          {"wall",
           "type=\"double\" value=\"10e9\"",
           "type=\"double\" value=\"10 GPa\"",
           {"Young modulus = \"10 GPa\"", "must be a number", "no unit"}},
          {"wall",
           "type=\"double\" value=\"10e9\"",
           "type=\"double\" value=\"1,5\"",
           {"Young modulus = \"1,5\"", "no comma"}},
          {"wall",
           "type=\"double\" value=\"10e9\"",
           "type=\"string\" value=\"10e9\"",
           {"Young modulus = \"10e9\" (string)", "must be of type double", "Write type=\"double\""}},
          {"wall",
           "type=\"double\" value=\"10e9\"",
           "type=\"number\" value=\"10e9\"",
           {"Young modulus = \"10e9\" of type \"number\"", "double, int, bool, string"}},
          {"wall",
           "<ParameterList name=\"own weight\">",
           "<Parameter name=\"own weights\" type=\"int\" value=\"1\"/><ParameterList name=\"own weight\">",
           {"stages > own weights = 1 (int)", "must be a ParameterList, not a Parameter"}},
          {"wall",
           "<Parameter name=\"ax\" type=\"double\" value=\"1.4715\"/>",
           "<Parameter name=\"ax\" value=\"1.4715\"/>",
           {"sideways > ax has no attribute type", "needs name, type and value", "Add type="}},
      },
      out, success);
}

TEUCHOS_UNIT_TEST(BrokenScenes, WhatTeuchosWouldMergeOrDropIsRefused) {
  refuse_each(
      {
          {"wall",
           "<Parameter name=\"plane\"",
           "<Parameter name=\"thickness\" type=\"double\" value=\"2\"/><Parameter name=\"plane\"",
           {"scene > model > thickness is there twice, in line 17 and line 18", "which one should count?",
            "Remove or rename one."}},
          {"wall",
           "<ParameterList name=\"steps\">",
           "<ParameterList name=\"steps\"><ParameterList name=\"stages\"/>",
           {"scene > steps > stages is there twice"}},
          {"wall",
           "<ParameterList name=\"materials\">",
           "<Paramter name=\"a\"/><ParameterList name=\"materials\">",
           {"scene holds an element <Paramter>", "did you mean \"Parameter\"?"}},
          {"wall",
           "<ParameterList name=\"materials\">",
           "stone of 1640 <ParameterList name=\"materials\">",
           {"scene holds the text \"stone of 1640\"", "no meaning", "<!-- comments -->"}},
          {"wall",
           "<ParameterList name=\"dry\">",
           "<ParameterList name=\"dry\"><ParameterList/>",
           {"dry holds a ParameterList without a name"}},
          {"wall",
           "value=\"Running",
           "value=\"\xe9 Running",
           {"scene > title", "not UTF-8", "write letters as they are"}},
          {"wall", "value=\"Running", "value=\"&#xd800; Running", {"scene > title", "not UTF-8"}},
          {"wall",
           "<Parameter name=\"plane\"",
           "<Parameter name=\"a\" name=\"plane\"",
           {"gives \"name\" twice", "Remove one."}},
      },
      out, success);
}

TEUCHOS_UNIT_TEST(BrokenScenes, NamesThatLeadNowhereAreRefusedWithThoseThereAre) {
  refuse_each(
      {
          {"wall",
           "<Parameter name=\"weight\" type",
           "<Parameter name=\"wieght\" type",
           {"stages > own weight > loads > wieght = 1 [-]", "names no load of this scene (did you mean \"weight\"?)",
            "Loads: weight, sideways."}},
          {"arch",
           "value=\"right\"",
           "value=\"rigth\"",
           {"loads > spreading > support = \"rigth\"", "is no support of this scene (did you mean \"right\"?)",
            "Supports: left, right."}},
          {"wall",
           "value=\"self weight\"",
           "value=\"selfweight\"",
           {"loads > weight > type = \"selfweight\"", "did you mean \"self weight\"?",
            "acceleration, traction, settlement"}},
          {"reference",
           "clare-college-bridge.geo",
           "clare.geo",
           {"mesh > gmsh > file = \"clare.geo\"", "cannot be found. Sought: ", "/xml/clare.geo", "/meshes/clare.geo",
            "give its path"}},
          {"reference",
           "clare-college-bridge.geo",
           "../README.md",
           {"file = \"../README.md\"", "must end in .geo", "Export the mesh"}},
      },
      out, success);
}

/// The wall without a list; the scenes of xml/ indent a list and its end alike.
std::string wall_without(const std::string& list, const std::string& indent) {
  std::string text = scene_text(path_of("wall"));
  const std::string end = '\n' + indent + "</ParameterList>";
  const auto from = text.find('\n' + indent + "<ParameterList name=\"" + list + "\">");
  return text.erase(from, text.find(end, from) + end.size() - from);
}

TEUCHOS_UNIT_TEST(BrokenScenes, ASectionWithoutMembersIsRefused) {
  for (const std::string list : {"materials", "joints", "supports", "loads", "stages"}) {
    const bool stages = list == "stages";
    const std::string message = said(wall_without(list, stages ? "    " : "  "), "wall");
    TEST_EQUALITY_CONST(problems_in(message, "wall"), 1);
    for (const std::string& piece :
         {"scene > " + (stages ? "steps > stages" : list) + " has no members",
          std::string("a scene needs at least one"), std::string("Add <ParameterList name=")})
      TEST_INEQUALITY_CONST(message.find(piece), std::string::npos);
  }
}

TEUCHOS_UNIT_TEST(BrokenScenes, TextsThatAreNoScenesAreRefused) {
  std::string deep = "<ParameterList>";
  for (int i = 0; i < 40; ++i) deep += "<ParameterList name=\"a\">";
  const std::vector<std::pair<std::string, std::string>> table{
      {"", "the file is empty"},
      {" \n", "the file is empty"},
      {"hello", "cannot be read as XML"},
      {"<ParameterList/>\nhello", "text stands outside of its list: \"hello\""},
      {"<!-- nothing -->", "it holds no element"},
      {"<ParameterList>\n", "the file ends before all its lists are closed"},
      {"<ParameterList>\n<Parameter>\n</ParameterList>", "the Parameter of line 2 is not ended by />"},
      {"<ParameterList>\n</ParameterList>\n</ParameterList>", "</ParameterList> in line 3 does not end the element"},
      {"<ParameterList>\n<Parameter name=a/></ParameterList>", "error in line 2: Error parsing element attribute"},
      {"<ParameterList>\n<!-- a </ParameterList>", "error in line 2: Error parsing comment"},
      {"<ParameterList/>\n<ParameterList/>", "more than one root element, the second in line 2"},
      {"<ParameterList name=\"&entity;\"/>", "holds \"&entity;\" in line 1\n  where an & does not begin a letter"},
      {"<ParameterList name=\"a & b\"/>", "Write &amp; for &"},
      {"<ParameterList name=\"a&#0;b\"/>", "where an & does not begin a letter"},
      {"<Scene/>", "scene is an element <Scene>\n  but must be a <ParameterList>"},
      {"<!DOCTYPE a [<!ENTITY b \"c\">]><ParameterList/>", "holds a DOCTYPE in line 1"},
      {"<!DOCTYPE a [<!ENTITY b \"c\">", "holds a DOCTYPE in line 1"},
      {"<ParameterList>\n<!ENTITY b \"c\"></ParameterList>", "holds an ENTITY in line 2"},
      {"<ParameterList>\n<!ELEMENT b></ParameterList>", "holds a declaration <!...> in line 2"},
      {"<ParameterList>\n<![CDATA[a]]></ParameterList>", "holds CDATA in line 2"},
      {"<ParameterList>\n<![CDATA[a</ParameterList>", "holds CDATA in line 2"},
      {deep, "nests lists deeper than 32 in line 1"},
      {std::string("<ParameterList/>\0", 17), "holds a zero byte"},
      {std::string((16u << 20) + 1, ' '), "larger than 16 MB"},
  };
  for (const auto& [text, piece] : table) {
    const std::string message = said(text, "none");
    if (message.find(piece) == std::string::npos || message.find("none.xml: scene") == std::string::npos) {
      out << "missing: " << piece << "\nin:      " << message << "\n";
      success = false;
    }
  }
}

TEUCHOS_UNIT_TEST(BrokenScenes, FilesThatAreNoScenesAreRefused) {
  const auto said_of_file = [](const std::string& file) -> std::string {
    try {
      read_scene(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  TEST_INEQUALITY_CONST(said_of_file("no/such.xml").find("no/such.xml: scene\n  cannot be found."), std::string::npos);
  TEST_INEQUALITY_CONST(said_of_file(repository("/xml")).find("is a folder"), std::string::npos);
  std::ofstream("empty.xml").close();
  TEST_INEQUALITY_CONST(said_of_file("empty.xml").find("the file is empty"), std::string::npos);
}

TEUCHOS_UNIT_TEST(BrokenScenes, AllProblemsAreReportedAtOnceButNoMoreThanAScreenFull) {
  std::string text = changed("wall", "\"0.6\"", "\"-1\"");
  text.replace(text.find("\"10e9\""), 6, "\"0\"");
  TEST_EQUALITY_CONST(problems_in(said(text, "wall"), "wall"), 2);

  std::string many = "<ParameterList>";
  for (int i = 0; i < 2000; ++i) many += "<Parameter name=\"key " + std::to_string(i) + "\" type=\"int\" value=\"1\"/>";
  const std::string message = said(many + "</ParameterList>", "wall");
  TEST_EQUALITY_CONST(problems_in(message, "wall"), 20);
  TEST_INEQUALITY_CONST(message.find("more of this input"), std::string::npos);
}

}  // namespace

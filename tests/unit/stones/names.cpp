// Every stone has a name of its own: that of its object, group, solid or file, whichever tells it from others.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "stones/stone_files.hpp"
#include "stones/stone_names.hpp"
#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

using Names = std::vector<std::string>;

Names names_of(const std::vector<StoneSurface>& stones) {
  Names names;
  for (const auto& stone : stones) names.push_back(stone.name);
  return names;
}

/// Faces of a tetrahedron over four points that follow each other, and a statement before each of them.
std::string tetrahedron_of(int first, const Names& before) {
  const std::array<std::array<int, 3>, 4> faces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  std::string text;
  for (std::size_t k = 0; k < 4; ++k) {
    if (k < before.size()) text += before[k] + "\n";
    text += "f";
    for (const int point : faces[k]) text += " " + std::to_string(first + point);
    text += "\n";
  }
  return text;
}

const std::string two_tetrahedra = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\n";

TEUCHOS_UNIT_TEST(ObjNames, AnObjectIsTheStoneAndALayerIsNot) {
  const auto stones = read_obj(
      "l.obj", two_tetrahedra + tetrahedron_of(1, {"o A\ng Layer_01"}) + tetrahedron_of(5, {"o B\ng Layer_01"}));
  TEST_ASSERT(names_of(stones) == (Names{"A", "B"}));
}

TEUCHOS_UNIT_TEST(ObjNames, GroupsForTheSidesOfAnObjectAreOneStone) {
  const auto stones =
      read_obj("s.obj", two_tetrahedra + tetrahedron_of(1, {"o A", "g top", "g sides"}) + tetrahedron_of(5, {"o B"}));
  TEST_ASSERT(names_of(stones) == (Names{"A", "B"}));
  TEST_EQUALITY(stones[0].faces.size(), 4u);
  TEST_EQUALITY(stones[0].points.size(), 4u);
  TEST_EQUALITY(stones[0].origin, "s.obj, line 10");
}

TEUCHOS_UNIT_TEST(ObjNames, FaultsAreToldOfGroupsInAnOnlyObjectAndOfObjectsElse) {
  const auto without_last = [](std::string faces) { return faces.erase(faces.rfind("f ")); };
  const std::string open = without_last(tetrahedron_of(1, {"g west"})) + without_last(tetrahedron_of(5, {"g east"}));
  TEST_ASSERT(names_of(read_obj("g.obj", two_tetrahedra + "o wall\n" + open)) == (Names{"west", "east"}));
  const std::string sides = without_last(tetrahedron_of(1, {"g top", "g sides"}));
  TEST_ASSERT(names_of(read_obj("g.obj", two_tetrahedra + "o A\n" + sides + tetrahedron_of(5, {"o B"}))) ==
              (Names{"A", "B"}));
  const std::string whole = tetrahedron_of(1, {"g top", "g sides"});
  TEST_ASSERT(names_of(read_obj("g.obj", two_tetrahedra + "o A\n" + whole)) == (Names{"A"}));
}

TEUCHOS_UNIT_TEST(ObjNames, ClosedGroupsAreStonesWithoutObjectsAndInOne) {
  for (const std::string object : {"", "o wall\n"}) {
    const auto stones =
        read_obj("g.obj", two_tetrahedra + object + tetrahedron_of(1, {"g west"}) + tetrahedron_of(5, {"g east"}));
    TEST_ASSERT(names_of(stones) == (Names{"west", "east"}));
  }
  const auto twice =
      read_obj("g.obj", two_tetrahedra + "o wall\n" + tetrahedron_of(1, {"g west"}) + tetrahedron_of(5, {"g east"}) +
                            "o tower\n" + tetrahedron_of(1, {"g west"}) + tetrahedron_of(5, {"g top"}));
  TEST_ASSERT(names_of(twice) == (Names{"wall west", "east", "tower west", "top"}));
}

StoneSurface stone_called(const std::string& name) {
  auto stone = box(name, {0, 0, 0}, {1, 1, 1});
  stone.origin = "the file";
  return stone;
}

TEUCHOS_UNIT_TEST(StoneNames, OneThatSeveralFilesGiveIsThatOfTheFile) {
  Warnings warnings;
  const auto stones = with_names_that_differ({{"stone_1", {stone_called("OpenSCAD_Model")}},
                                              {"stone_2", {stone_called("OpenSCAD_Model")}},
                                              {"pier", {stone_called("OpenSCAD_Model"), stone_called("cap")}}},
                                             warnings);
  TEST_ASSERT(names_of(stones) == (Names{"stone_1", "stone_2", "pier OpenSCAD_Model", "cap"}));
  TEST_ASSERT(warnings.empty());
}

TEUCHOS_UNIT_TEST(StoneNames, ThoseThatRepeatInAFileAreNumberedAndTold) {
  Warnings warnings;
  const auto stones = with_names_that_differ(
      {{"wall", {stone_called("x"), stone_called("x 1"), stone_called("x"), stone_called("y")}}}, warnings);
  TEST_ASSERT(names_of(stones) == (Names{"x 2", "x 1", "x 3", "y"}));
  TEST_EQUALITY(warnings.size(), 1u);
  TEST_EQUALITY(warnings[0].what, "names_repeated");
  TEST_FLOATING_EQUALITY(warnings[0].how_much, 2.0, 1e-15);
  TEST_ASSERT(holds(warnings[0].text, "2 stones have the names of others and are numbered, first \"x\", of 2 stones"));
}

TEUCHOS_UNIT_TEST(StoneNames, AreTextThatEveryProgramCanShow) {
  Warnings warnings;
  const auto stones = with_names_that_differ({{"wall",
                                               {stone_called("Schlu\xdfstein"),
                                                stone_called("a\x1b\x07"
                                                             "b"),
                                                stone_called("\x01")}}},
                                             warnings);
  TEST_ASSERT(names_of(stones) == (Names{"Schlußstein", "ab", "wall"}));
}

TEUCHOS_UNIT_TEST(StoneFolders, FilesThatAreNotReadAreTold) {
  const std::string folder = "folder of stones";
  std::filesystem::create_directories(folder + "/below/deep");
  const auto write = [&](const std::string& name) {
    std::ofstream(folder + "/" + name) << two_tetrahedra << tetrahedron_of(1, {"o Cube"});
  };
  for (const std::string name : {"a.obj", "b.obj", "below/c.OBJ", "below/deep/d.obj", ".hidden.obj"}) write(name);
  std::ofstream(folder + "/._a.stl") << std::string{'\0', '\5', '\x16', '\7', 'M', 'a', 'c'};
  std::ofstream(folder + "/below/notes.txt") << "0";
  Warnings warnings;
  TEST_ASSERT(names_of(read_stones(folder, 1, warnings)) == (Names{"a", "b"}));
  TEST_EQUALITY(warnings.size(), 1u);
  TEST_EQUALITY(warnings[0].what, "files_not_read");
  TEST_FLOATING_EQUALITY(warnings[0].how_much, 4.0, 1e-15);
  TEST_ASSERT(holds(warnings[0].text, "2 files of stones in folders below it (below/c.OBJ, below/deep/d.obj)"));
  TEST_ASSERT(holds(warnings[0].text, "2 files of stones with a dot before the name (._a.stl, .hidden.obj)"));
  std::filesystem::create_directories("folder of folders/below");
  std::filesystem::copy_file(folder + "/a.obj", "folder of folders/below/a.obj",
                             std::filesystem::copy_options::overwrite_existing);
  TEST_ASSERT(holds(input_error([&] { read_stones("folder of folders", 1); }), "1 file of stones in folders below it"));
}

}  // namespace

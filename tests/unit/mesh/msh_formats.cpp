// Finished meshes whose format lists no surfaces: what would become one block by a number alone is refused, what may be
// missing is said.
#include <sstream>

#include "mesh/mesh_check.hpp"
#include "unit/mesh/gmsh_files.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// A cell, or an edge, and the physical group and the entity its line names.
struct Line {
  std::vector<int> nodes;
  int group, entity;
};

/// Two unit squares of two triangles one upon the other, nodes 1 2 / 3 4 / 5 6 from below; node 7 and 8 are copies of
/// 3, 4, and 9 to 11 are the corners of a triangle that touches node 6 alone.
GmshParameters format_2(const std::string& name, const std::vector<Line>& lines) {
  std::ostringstream text;
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n1 3 \"ground\"\n1 4 \"top\"\n2 1 \"bed\"\n2 2 "
          "\"stone\"\n$EndPhysicalNames\n$Nodes\n10\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n5 0 2 0\n6 1 2 0\n7 0 1 "
          "0\n8 1 1 0\n9 2 2 0\n10 2 3 0\n$EndNodes\n$Elements\n"
       << lines.size() << "\n";
  for (std::size_t k = 0; k < lines.size(); ++k) {
    text << k + 1 << (lines[k].nodes.size() == 2 ? " 1" : " 2") << " 2 " << lines[k].group << " " << lines[k].entity;
    for (const int node : lines[k].nodes) text << " " << node;
    text << "\n";
  }
  return written(name, text.str() + "$EndElements\n");
}

std::vector<Line> squares(int group_below, int entity_below, int group_above, int entity_above, int shift = 0) {
  return {{{1, 2}, 3, 1},
          {{5, 6}, 4, 2},
          {{1, 2, 4}, group_below, entity_below},
          {{1, 4, 3}, group_below, entity_below},
          {{3 + shift, 4 + shift, 6}, group_above, entity_above},
          {{3 + shift, 6, 5}, group_above, entity_above}};
}

std::string fault(const GmshParameters& p) {
  return input_error([&] { read(p); });
}

TEUCHOS_UNIT_TEST(MshFormats, StonesWithSurfacesOfTheirOwnAreRead) {
  const auto source = read(format_2("own.msh", squares(1, 1, 2, 2)));
  check_source(*source, out, success);
  TEST_EQUALITY(source->block(1).name, "surface 2 (stone)");
  TEST_ASSERT(graph_of(*source).shared_vertices == (std::vector<int>{2, 2}));
}

TEUCHOS_UNIT_TEST(MshFormats, StonesOfTwoGroupsThatNameOneSurfaceAreRefused) {
  const std::string said = refusal(format_2("one.msh", squares(1, 7, 2, 7)));
  TEST_ASSERT(
      holds(said, "one.msh\n  gives surface 7 to the physical groups bed, stone, and not each of its cells to all"));
  TEST_ASSERT(holds(said, "Give every stone and every named line an elementary number of its own"));
}

TEUCHOS_UNIT_TEST(MshFormats, LinesOfTwoGroupsThatNameOneCurveAreRefused) {
  auto lines = squares(1, 1, 2, 2);
  lines[1].entity = 1;  // ground and top would both hold both lines
  TEST_ASSERT(holds(refusal(format_2("curve.msh", lines)), "gives curve 1 to the physical groups ground, top"));
}

TEUCHOS_UNIT_TEST(MshFormats, ACellOnceForEachGroupOfItsSurfaceIsOneCell) {
  auto lines = squares(1, 1, 1, 2);  // as gmsh writes surface 2 in the groups bed and stone
  lines.push_back({{3, 4, 6}, 2, 2});
  lines.push_back({{3, 6, 5}, 2, 2});
  const auto source = read(format_2("twice.msh", lines));
  check_source(*source, out, success);
  TEST_EQUALITY(source->block(1).cells.size(), 2u);
  TEST_EQUALITY(source->block(1).name, "surface 2 (bed, stone)");
  lines.pop_back();  // one cell in one group, the other in two
  TEST_ASSERT(
      holds(refusal(format_2("once_and_twice.msh", lines)), "gives surface 2 to the physical groups bed, stone"));
}

TEUCHOS_UNIT_TEST(MshFormats, FormatFourMayPutASurfaceIntoTwoGroups) {
  const auto source = read(geo("two_stones.geo"));
  TEST_EQUALITY(source->block(1).name, "surface 17 (west, both)");
  TEST_ASSERT(source->warnings().empty());
}

TEUCHOS_UNIT_TEST(MshFormats, PiecesJoinedByANumberAloneAreRefused) {
  // Nodes of their own along the bed; a triangle that touches in a node.
  const std::string apart = fault(format_2("apart.msh", squares(1, 7, 1, 7, 4)));
  TEST_ASSERT(holds(apart, "surface 7 (bed) is in pieces"));
  TEST_ASSERT(holds(apart, "elementary number (the second tag of cells)"));
  auto lines = squares(1, 1, 2, 2);
  lines.push_back({{6, 9, 10}, 2, 2});
  TEST_ASSERT(holds(fault(format_2("corner.msh", lines)), "surface 2 (stone) is in pieces"));
}

TEUCHOS_UNIT_TEST(MshFormats, WhatWasNotSavedCannotBeMissedAndThatIsSaid) {
  const auto groups = read(format_2("groups.msh", squares(1, 1, 2, 2)))->warnings();
  TEST_EQUALITY_CONST(groups.size(), 1u);  // on every rank
  TEST_EQUALITY(groups[0].what, "surfaces_not_listed");
  TEST_EQUALITY(groups[0].how_much, 2.0);
  TEST_ASSERT(holds(groups[0].text, "groups.msh is in a format that lists no surfaces"));
  // A surface in no group shows that all of them were saved; without any group gmsh saves all.
  TEST_ASSERT(read(format_2("all.msh", squares(1, 1, 0, 2)))->warnings().empty());
  TEST_ASSERT(read(format_2("none.msh", squares(0, 1, 0, 2)))->warnings().empty());
}

}  // namespace

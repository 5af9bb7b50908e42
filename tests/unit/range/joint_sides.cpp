// Supports and loads on a curve between two stones.
//
// Set-up    Two squares of 1 m side by side; the curve between them is the set "seam", the outside of the right one
//           "end". The left square is of the set "stones left", both are of "stones".
#include "range/plane/joint_sides.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "base/error.hpp"
#include "mesh/block_list.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

Block<2> square(BlockId id, double left, const std::vector<VertexId>& vertices) {
  Block<2> block;
  block.id = id;
  block.name = id == 0 ? "the left stone" : "the right stone";
  block.position = {{left, 0}, {left + 1, 0}, {left + 1, 1}, {left, 1}};
  block.vertex = vertices;
  Cell cell;
  cell.count = 4;
  for (int i = 0; i < 4; ++i) cell.node[static_cast<std::size_t>(i)] = i;
  block.cells = {cell};
  return block;
}

TaggedFacet facet(int a, int b, int set) {
  TaggedFacet f;
  f.node = {a, b};
  f.count = 2;
  f.set = set;
  return f;
}

std::unique_ptr<BlockSource<2>> two_squares() {
  BlockList<2> list;
  list.blocks = {square(0, 0, {0, 1, 2, 3}), square(1, 1, {1, 4, 5, 2})};
  list.block_sets = {"stones left", "stones"};
  list.facet_sets = {"seam", "end"};
  list.blocks[0].sets = {0, 1};
  list.blocks[1].sets = {1};
  list.blocks[0].facets = {facet(1, 2, 0)};
  list.blocks[1].facets = {facet(3, 0, 0), facet(1, 2, 1)};
  return make_source(std::move(list));
}

Scene empty_scene() {
  Scene scene;
  scene.file = "scene.xml";
  scene.mesh.type = MeshType::gmsh;
  return scene;
}

Scene held(const std::string& on, const std::string& blocks = "") {
  Scene scene = empty_scene();
  add_support(scene, on, "xy");
  scene.supports.back().parameters.blocks = blocks;
  return scene;
}

TEUCHOS_UNIT_TEST(JointSides, ASupportOnBothSidesOfAJointIsToldWithItsLength) {
  const auto source = two_squares();
  const auto said = warnings_of_sides(held("seam"), *source);
  TEST_EQUALITY(said.size(), 1);
  TEST_EQUALITY(said.front().what, "support_on_both_sides");
  TEST_FLOATING_EQUALITY(said.front().how_much, 1.0, 1e-15);
  TEST_ASSERT(said.front().text.find("the joint between the left stone and the right stone") != std::string::npos);
  TEST_ASSERT(said.front().text.find("blocks = \"stones left\"") != std::string::npos);
}

TEUCHOS_UNIT_TEST(JointSides, NothingIsToldOfASideThatIsNamedNorOfTheOutside) {
  const auto source = two_squares();
  for (const auto& scene : {held("seam", "all"), held("seam", "stones left"), held("end")})
    TEST_ASSERT(warnings_of_sides(scene, *source).empty());
}

TEUCHOS_UNIT_TEST(JointSides, APressureOnBothSidesIsToldAndATractionRefused) {
  const auto source = two_squares();
  Scene scene = empty_scene();
  add_pressure(scene, "seam", 1000);
  const auto said = warnings_of_sides(scene, *source);
  TEST_EQUALITY(said.size(), 1);
  TEST_EQUALITY(said.front().what, "pressure_on_both_sides");
  check_sides(scene, *source);
  auto& traction = std::get<TractionParameters>(scene.loads.back().kind);
  traction.pressure = 0;
  traction.tx = 1000;
  TEST_THROW(check_sides(scene, *source), InputError);
  traction.blocks = "stones left";
  check_sides(scene, *source);
  TEST_ASSERT(warnings_of_sides(scene, *source).empty());
}

TEUCHOS_UNIT_TEST(JointSides, ASideWithoutFacetsIsRefused) {
  const auto source = two_squares();
  TEST_THROW(check_sides(held("end", "stones left"), *source), InputError);
  check_sides(held("end", "stones"), *source);
}

}  // namespace

// Supports and loads on a curve between two stones.
//
// Set-up    Two squares of 1 m side by side; the curve between them is the set "seam", the outside of the right one
//           "end". The left square is of the set "stones left", both are of "stones". In space two cubes likewise, the
//           face between them cut into two triangles, each of which starts at another corner on either side.
#include "range/joint_sides.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>

#include "base/error.hpp"
#include "linalg/reduce.hpp"
#include "mesh/block_list.hpp"
#include "mesh/facet_set.hpp"
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

template <int dim>
Warnings said_of(const Scene& scene, const BlockSource<dim>& source) {
  return warnings_of_sides(scene, source, *Tpetra::getDefaultComm());
}

TEUCHOS_UNIT_TEST(JointSides, ASupportOnBothSidesOfAJointIsToldWithItsLength) {
  const auto source = two_squares();
  const auto said = said_of(held("seam"), *source);
  TEST_EQUALITY(said.size(), 1);
  TEST_EQUALITY(said.front().what, "support_on_both_sides");
  TEST_FLOATING_EQUALITY(said.front().how_much, 1.0, 1e-15);
  TEST_ASSERT(said.front().text.find("the joint between the left stone and the right stone") != std::string::npos);
  TEST_ASSERT(said.front().text.find("blocks = \"stones left\"") != std::string::npos);
}

// A third stone stands to the right: its set has one side of one joint, that of the stone between one side of both.
TEUCHOS_UNIT_TEST(JointSides, ASetOfOneSideIsOneOfAllJoints) {
  BlockList<2> list;
  list.blocks = {square(0, 0, {0, 1, 2, 3}), square(1, 1, {1, 4, 5, 2}), square(2, 2, {4, 6, 7, 5})};
  list.block_sets = {"outer left", "between", "outer right", "all three"};
  list.facet_sets = {"seam"};
  for (int b = 0; b < 3; ++b) list.blocks[b].sets = {b, 3};
  list.blocks[0].facets = {facet(1, 2, 0)};
  list.blocks[1].facets = {facet(3, 0, 0), facet(1, 2, 0)};
  list.blocks[2].facets = {facet(3, 0, 0)};
  const auto source = make_source(std::move(list));
  const auto said = said_of(held("seam"), *source);
  TEST_EQUALITY(said.size(), 1);
  TEST_FLOATING_EQUALITY(said.front().how_much, 2.0, 1e-15);
  TEST_ASSERT(said.front().text.find("say which side is meant: blocks = \"between\", or") != std::string::npos);
  TEST_ASSERT(said.front().text.find("the joints between the left stone and the right stone, between the right stone "
                                     "and the right stone") != std::string::npos);
}

TEUCHOS_UNIT_TEST(JointSides, NothingIsToldOfASideThatIsNamedNorOfTheOutside) {
  const auto source = two_squares();
  for (const auto& scene : {held("seam", "all"), held("seam", "stones left"), held("end")})
    TEST_ASSERT(said_of(scene, *source).empty());
}

TEUCHOS_UNIT_TEST(JointSides, APressureOnBothSidesIsToldAndATractionRefused) {
  const auto source = two_squares();
  Scene scene = empty_scene();
  add_pressure(scene, "seam", 1000);
  const auto said = said_of(scene, *source);
  TEST_EQUALITY(said.size(), 1);
  TEST_EQUALITY(said.front().what, "pressure_on_both_sides");
  check_sides(scene, *source, *Tpetra::getDefaultComm());
  auto& traction = std::get<TractionParameters>(scene.loads.back().kind);
  traction.pressure = 0;
  traction.tx = 1000;
  TEST_THROW(check_sides(scene, *source, *Tpetra::getDefaultComm()), InputError);
  traction.blocks = "stones left";
  check_sides(scene, *source, *Tpetra::getDefaultComm());
  TEST_ASSERT(said_of(scene, *source).empty());
}

Block<3> cube(BlockId id, double left, const std::vector<VertexId>& vertices) {
  Block<3> block;
  block.id = id;
  block.name = id == 0 ? "the left stone" : "the right stone";
  for (int k = 0; k < 8; ++k)
    block.position.push_back({left + (k % 4 == 1 || k % 4 == 2 ? 1.0 : 0.0), k % 4 > 1 ? 1.0 : 0.0, k > 3 ? 1.0 : 0.0});
  block.vertex = vertices;
  Cell cell;
  cell.count = 8;
  for (int i = 0; i < 8; ++i) cell.node[static_cast<std::size_t>(i)] = i;
  block.cells = {cell};
  return block;
}

TaggedFacet triangle(int a, int b, int c, int set) {
  TaggedFacet f;
  f.node = {a, b, c, c};
  f.count = 3;
  f.set = set;
  return f;
}

std::unique_ptr<BlockSource<3>> two_cubes() {
  BlockList<3> list;
  list.blocks = {cube(0, 0, {0, 1, 2, 3, 4, 5, 6, 7}), cube(1, 1, {1, 8, 9, 2, 5, 10, 11, 6})};
  list.block_sets = {"stones left", "stones"};
  list.facet_sets = {"seam", "faces"};
  list.blocks[0].sets = {0, 1};
  list.blocks[1].sets = {1};
  for (const int set : {0, 1})
    for (auto* block : {&list.blocks[0], &list.blocks[1]}) {
      const bool left = block->id == 0;
      block->facets.push_back(left ? triangle(1, 2, 6, set) : triangle(7, 3, 0, set));
      block->facets.push_back(left ? triangle(1, 6, 5, set) : triangle(0, 4, 7, set));
    }
  return make_source(std::move(list));
}

TEUCHOS_UNIT_TEST(JointSides, InSpaceAreThoseOfASurface) {
  const auto source = two_cubes();
  const auto both = two_sided_facets(*source, facet_set(*source, {"seam"}), *Tpetra::getDefaultComm());
  TEST_EQUALITY(total_over_ranks(*Tpetra::getDefaultComm(), static_cast<int>(both.size())), 2);
  for (const auto& facet : both) TEST_FLOATING_EQUALITY(facet.size(), 0.5, 1e-15);
  auto said = said_of(held("seam"), *source);
  TEST_EQUALITY(said.size(), 1);
  TEST_EQUALITY(said.front().what, "support_on_both_sides");
  TEST_FLOATING_EQUALITY(said.front().how_much, 1.0, 1e-15);
  TEST_ASSERT(said.front().text.find("blocks = \"stones left\"") != std::string::npos);
  TEST_ASSERT(said_of(held("seam", "stones left"), *source).empty());
  TEST_EQUALITY(said_of(held("faces"), *source).size(), 1);
  TEST_ASSERT(said_of(held("faces", "stones"), *source).empty());  // stones that are held whole
  Scene scene = empty_scene();
  add_pressure(scene, "seam", 1000);
  said = said_of(scene, *source);
  TEST_EQUALITY(said.size(), 1);
  TEST_EQUALITY(said.front().what, "pressure_on_both_sides");
  std::get<TractionParameters>(scene.loads.back().kind).tz = 1000;
  TEST_THROW(check_sides(scene, *source, *Tpetra::getDefaultComm()), InputError);
}

TEUCHOS_UNIT_TEST(JointSides, InSpaceAreReachedByALoadThatActsThere) {
  const auto source = two_cubes();
  Scene scene = empty_scene();
  const auto said = [&](auto load) {
    load.on = "seam";
    LoadParameters named;
    named.name = "load";
    named.kind = load;
    scene.loads = {named};
    return said_of(scene, *source).size();
  };
  WaterPressureParameters water;
  water.level = 0.5;
  TEST_EQUALITY(said(water), 1);
  water.level = -0.5;
  TEST_EQUALITY(said(water), 0);
  CrowdParameters crowd;  // nobody stands on an upright face
  crowd.x_from = -9, crowd.x_to = 9;
  said(crowd);
  check_sides(scene, *source, *Tpetra::getDefaultComm());
}

TEUCHOS_UNIT_TEST(JointSides, ASideWithoutFacetsIsRefused) {
  const auto source = two_squares();
  TEST_THROW(check_sides(held("end", "stones left"), *source, *Tpetra::getDefaultComm()), InputError);
  check_sides(held("end", "stones"), *source, *Tpetra::getDefaultComm());
}

}  // namespace

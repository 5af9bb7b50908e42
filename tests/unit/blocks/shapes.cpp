// Which blocks share a stiffness, and that it is theirs.
#include "blocks/shapes.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <set>

#include "unit/blocks/lattice_block.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

const Material stone{10e9, 0.2, 2000};
const ModelParameters model{Plane::stress, 0.4};

Block<2> moved(Block<2> block, double x, double y, double scale = 1) {
  for (auto& p : block.position) p = {scale * p[0] + x, scale * p[1] + y};
  return block;
}

TEUCHOS_UNIT_TEST(StiffnessOfShapes, BlocksThatDifferByTheirPlaceHaveOneMatrix) {
  StiffnessOfShapes shapes(model);
  const auto block = block_of_cells(0, rectangle(0, 0, 2, 1), 0.25);
  const auto k = shapes.of(block, stone).stiffness;
  TEST_ASSERT(shapes.of(block_of_cells(1, rectangle(240, 70, 2, 1), 0.25), stone).stiffness == k);
  TEST_ASSERT(shapes.of(moved(block, 8.0, 2.0), {10e9, 0.2, 500}).stiffness == k);  // density is not stiffness
}

TEUCHOS_UNIT_TEST(StiffnessOfShapes, BlocksThatDifferOtherwiseDoNot) {
  StiffnessOfShapes shapes(model);
  const auto block = block_of_cells(0, rectangle(0, 0, 2, 1));
  const auto k = shapes.of(block, stone).stiffness;
  TEST_ASSERT(shapes.of(block, {11e9, 0.2, 2000}).stiffness != k);
  TEST_ASSERT(shapes.of(block, {10e9, 0.1, 2000}).stiffness != k);
  TEST_ASSERT(shapes.of(block_of_cells(0, rectangle(0, 0, 1, 2)), stone).stiffness != k);
  TEST_ASSERT(shapes.of(moved(block, 0, 0, 2.0), stone).stiffness != k);
  auto skew = block;
  skew.position.back()[0] += 1e-15;
  TEST_ASSERT(shapes.of(skew, stone).stiffness != k);
  auto turned = block;  // the same cell from another corner: rows are in the order of nodes, sums in that of cells
  std::rotate(turned.cells[0].node.begin(), turned.cells[0].node.begin() + 1, turned.cells[0].node.begin() + 4);
  TEST_ASSERT(shapes.of(turned, stone).stiffness != k);
}

TEUCHOS_UNIT_TEST(StiffnessOfShapes, TheMatrixIsThatOfTheBlock) {
  StiffnessOfShapes shapes(model);
  // Differences of places are rounded once more or less.
  const auto block = moved(block_of_cells(0, rectangle(0, 0, 2, 1), 0.3), 1.0 / 3, 0.7, 1.1);
  const auto k = shapes.of(block, stone).stiffness,
             expected = std::make_shared<const LocalCsr>(block_stiffness(block, stone, model.plane, model.thickness));
  TEST_ASSERT(k->start == expected->start && k->column == expected->column);
  for (std::size_t e = 0; e < k->value.size(); ++e)
    TEST_COMPARE(std::abs(k->value[e] - expected->value[e]), <=, 1e-14 * expected->value[0]);
}

TEUCHOS_UNIT_TEST(StiffnessOfShapes, AWallInRunningBondHasFewOfThem) {
  WallParameters p;
  p.courses = p.blocks_per_course = 100;
  p.block_length = 0.3;
  p.block_height = 0.1;
  const auto source = make_wall(p);
  StiffnessOfShapes shapes(model);
  std::set<std::shared_ptr<const LocalCsr>> found;
  for (BlockId b = 0; b < source->block_count(); ++b) found.insert(shapes.of(source->block(b), stone).stiffness);
  // Whole and half stones, of which the round-off of places makes more: some of widths times some of heights.
  out << found.size() << " shapes of " << source->block_count() << " blocks";
  TEST_COMPARE(found.size(), <=, static_cast<std::size_t>(source->block_count()) / 10);
}

}  // namespace

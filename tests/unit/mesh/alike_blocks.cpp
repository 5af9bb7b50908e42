// Blocks that are translates of each other become equal to the last bit; others stay as they are.
#include "mesh/alike_blocks.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <numeric>

#include "mesh/kept_blocks.hpp"
#include "mesh/translates.hpp"

namespace {

using namespace voussoir;

/// Two tetrahedra on one face, of no round coordinates.
const std::vector<Vector<3>> places{
    {0.1, 0.2, 0.3}, {1.1, 0.2, 0.31}, {0.1, 1.7, 0.3}, {0.4, 0.5, 1.9}, {0.3, 0.6, -0.7}};
const std::vector<std::array<int, 4>> cells{{0, 1, 2, 3}, {0, 2, 1, 4}};

/// The body at another place, with its nodes and cells in another order: node k there is node `order[k]` here.
Block<3> body(BlockId id, const Vector<3>& by, const std::vector<int>& order = {0, 1, 2, 3, 4}, double scale = 1) {
  Block<3> block;
  block.id = id;
  std::vector<int> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    number[order[k]] = static_cast<int>(k);
    block.position.push_back(scale * places[order[k]] + by);
    block.vertex.push_back(100 * id + order[k]);
  }
  for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell)
    block.cells.push_back({{number[(*cell)[0]], number[(*cell)[1]], number[(*cell)[2]], number[(*cell)[3]]}, 4});
  block.facets = {{{number[0], number[1], number[3], number[3]}, 3, 0}};
  block.folds = {std::min(number[1], number[4]), std::max(number[1], number[4])};
  return block;
}

bool equal_around_first(const Block<3>& a, const Block<3>& b) {
  for (std::size_t k = 0; k < a.position.size(); ++k)
    if (a.position[k] - a.position[0] != b.position[k] - b.position[0]) return false;
  return std::equal(a.cells.begin(), a.cells.end(), b.cells.begin(), b.cells.end(),
                    [](const Cell& x, const Cell& y) { return x.node == y.node && x.count == y.count; });
}

TEUCHOS_UNIT_TEST(AlikeBlocks, ThatDifferByPlaceOrderAndRoundOffAreEqualToTheLastBit) {
  const std::vector<Vector<3>> by{{0, 0, 0}, {1.0 / 3, 0, 7.1}, {1e3 / 7, 0.1, -0.7}, {0.1, 0.2, 0.3}};
  std::vector<Block<3>> blocks{body(0, by[0]), body(1, by[1]), body(2, by[2], {4, 2, 0, 1, 3}),
                               body(3, by[3], {3, 1, 4, 0, 2})};
  TEST_ASSERT(!equal_around_first(blocks[0], blocks[1]));  // else this proves nothing
  TEST_EQUALITY(make_alike_equal(blocks, 200), 1);
  for (const auto& block : blocks) {
    TEST_ASSERT(equal_around_first(blocks[0], block));
    for (std::size_t k = 0; k < places.size(); ++k) {
      const int node = static_cast<int>(block.vertex[k] - 100 * block.id);  // as drawn
      TEST_EQUALITY(node, static_cast<int>(k));
      // Rounding to 2^-50 of 256 m, twice.
      TEST_COMPARE(norm(block.position[k] - places[node] - by[block.id]), <=, 1e-12);
    }
    TEST_ASSERT((block.facets[0].node == std::array<int, 4>{0, 1, 3, 3}));
    TEST_ASSERT((block.folds == std::vector<int>{1, 4}));
  }
}

TEUCHOS_UNIT_TEST(AlikeBlocks, ThatDifferOtherwiseStayAsTheyAre) {
  auto other_cells = body(2, {5, 0, 0});
  other_cells.cells.pop_back();
  auto moved = body(3, {9, 0, 0});
  moved.position[3][1] += 1e-9;
  const std::vector<Block<3>> drawn{body(0, {0, 0, 0}), body(1, {3, 0, 0}, {0, 1, 2, 3, 4}, 1.0001), other_cells,
                                    moved};
  auto blocks = drawn;
  TEST_EQUALITY(make_alike_equal(blocks, 10), 4);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    TEST_ASSERT(blocks[b].position == drawn[b].position);
    TEST_ASSERT(blocks[b].vertex == drawn[b].vertex);
  }
}

TEUCHOS_UNIT_TEST(KeptBlocks, HaveEqualCellsOnce) {
  auto far = body(1, {50, 0, 0});
  far.curved = {{0, 1}, {1, 3}};
  auto other = body(2, {0, 50, 0}, {4, 2, 0, 1, 3});
  KeptBlocks<3> kept;
  for (const auto& block : {body(0, {0, 0, 0}), far, other}) kept.add(block);
  TEST_EQUALITY(kept.meshes(), 2u);
  TEST_ASSERT(kept.has(2) && !kept.has(3));
  for (const auto& block : {body(0, {0, 0, 0}), far, other}) {
    const auto back = kept[block.id];
    TEST_ASSERT(back.id == block.id && back.position == block.position && back.vertex == block.vertex);
    TEST_ASSERT(back.curved == block.curved && back.folds == block.folds && back.sets == block.sets);
    TEST_ASSERT(std::equal(back.cells.begin(), back.cells.end(), block.cells.begin(), block.cells.end(),
                           [](const Cell& x, const Cell& y) { return x.node == y.node && x.count == y.count; }));
    TEST_EQUALITY(back.facets.size(), 1u);
    TEST_ASSERT(back.facets[0].node == block.facets[0].node);
    TEST_ASSERT(kept.vertices(block.id) == block.vertex);
  }
  TEST_THROW(kept[3], std::logic_error);
}

// Places that lie beside each other but for round-off along some axis are in one order whatever that round-off is.
TEUCHOS_UNIT_TEST(Translates, KnowALatticeWhoseCoordinatesAreRoundedOtherwise) {
  std::vector<Vector<3>> lattice, shaken;
  std::vector<int> pairs;
  for (int i = 0; i < 27; ++i) {
    lattice.push_back({0.1 * (i % 3), 0.1 * (i / 3 % 3), 0.1 * (i / 9)});
    const double noise = 1e-16 * ((i * 7) % 5 - 2);
    shaken.push_back(lattice.back() + Vector<3>{0.3 + noise, -noise, 0.7 + 2 * noise});
    if (i > 0) pairs.insert(pairs.end(), {i, i - 1});
  }
  Translates shapes(DrawnNumbers(1).within());
  TEST_ASSERT(shapes.add(lattice, 2, pairs).is_first);
  const auto match = shapes.add(shaken, 2, pairs);
  TEST_ASSERT(!match.is_first);
  for (int i = 0; i < 27; ++i) TEST_EQUALITY(match.order[i], i);
  std::reverse(pairs.begin(), pairs.end());
  TEST_ASSERT(!shapes.add(shaken, 2, pairs).is_first);
  pairs[0] = 13;
  TEST_ASSERT(shapes.add(shaken, 2, pairs).is_first);
}

}  // namespace

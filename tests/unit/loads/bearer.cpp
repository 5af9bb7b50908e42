// Loads that are placed at a point where stones meet say which stone bears them, and take another by its set.
#include <Teuchos_UnitTestHarness.hpp>
#include <array>
#include <memory>

#include "mesh/block_list.hpp"
#include "mesh/partition.hpp"
#include "unit/loads/load_cases.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Stones of 0.5 m x 0.25 m: joints of courses 0 and 2 at x = 0.5, 1, 1.5 m, of courses 1 and 3 at 0.25, 0.75, ...
PointLoadParameters at(double x, double y) {
  PointLoadParameters p;
  p.x = x;
  p.y = y;
  p.fy = -500;
  return p;
}

bool says(const Warnings& warnings, const std::string& part) {
  return warnings.size() == 1 && warnings[0].text.find(part) != std::string::npos;
}

TEUCHOS_UNIT_TEST(PointLoad, OnAJointSaysWhichStoneBearsIt) {
  const LoadCase wall;
  const auto warnings = wall.made(at(0.75, 1.0))->warnings();
  TEST_EQUALITY_CONST(warnings.size(), 1u);
  TEST_EQUALITY(warnings[0].what, "load_on_several_stones");
  TEST_EQUALITY(warnings[0].where, "scene > loads > tested");
  TEST_EQUALITY(warnings[0].how_much, 2.0);
  TEST_ASSERT(says(warnings,
                   "2 stones, block 14 (course 3, stone 1), block 15 (course 3, stone 2); block 14 (course 3, "
                   "stone 1) bears the load"));
  TEST_ASSERT(wall.made(at(0.5, 1.0))->warnings().empty());  // the middle of a stone
}

TEUCHOS_UNIT_TEST(PointLoad, IsBornByAStoneOfTheSetThatIsNamed) {
  const LoadCase wall;
  auto p = at(1.0, 0.75);  // two stones of course 2 below one of course 3
  TEST_ASSERT(says(wall.made(p)->warnings(), "on 3 stones"));
  TEST_ASSERT(says(wall.made(p)->warnings(), "such as \"course 3\""));
  p.blocks = "course 3";
  const auto load = wall.made(p);
  TEST_ASSERT(load->warnings().empty());
  BlockForces force(wall.s());
  std::vector<double> prescribed(force.of_nodes.size(), 0.0);
  load->add({{0, 1}}, force, prescribed);
  double borne = 0;
  for (int i = 0; i < wall.s().owned_nodes(); ++i) {
    const BlockId stone = wall.s().blocks()[wall.s().block_of_node()[i]].mesh.id;
    if (stone >= 13) borne += force.of_nodes[2 * i + 1];  // blocks 13 to 17
  }
  TEST_EQUALITY(sum_over_ranks(*everyone(), borne), -500.0);
  p.blocks = "course 2";
  TEST_ASSERT(says(wall.made(p)->warnings(), "on 2 stones"));
}

// Copies of a vertex of stones from a file may lie apart by round-off, which says nothing of who bears the load.
TEUCHOS_UNIT_TEST(PointLoad, IsBornByTheFirstOfStonesThatDifferByRoundOff) {
  BlockList<2> list;
  for (int b = 0; b < 2; ++b) {
    Block<2> block;
    block.id = b;
    block.name = "block " + std::to_string(b);
    block.position = {{1.0 * b, 0}, {1.0 + b, 0}, {1.0 + b, 1}, {1.0 * b, 1}};
    block.vertex = {2 * b, 2 * b + 2, 2 * b + 3, 2 * b + 1};
    block.cells = {{{0, 1, 2, 3}, 4}};
    list.blocks.push_back(block);
  }
  list.blocks[1].position[3][1] += 4e-16;  // nearer to the point above
  const LoadCase two(make_source(list));
  BlockForces force(two.s());
  std::vector<double> prescribed(force.of_nodes.size(), 0.0);
  auto p = at(1.0, 1.1);
  p.tolerance = 0.2;
  two.made(p)->add({{0, 1}}, force, prescribed);
  double borne = 0;
  for (int i = 0; i < two.s().owned_nodes(); ++i)
    if (two.s().blocks()[two.s().block_of_node()[i]].mesh.id == 0) borne += force.of_nodes[2 * i + 1];
  TEST_EQUALITY(sum_over_ranks(*everyone(), borne), -500.0);
}

TEUCHOS_UNIT_TEST(MovingTrain, ThatStandsOnAJointSaysWhichStoneBearsIt) {
  const LoadCase wall;
  MovingTrainParameters p;
  p.on = "top";
  p.axle_load = {1e3, 1e3};
  p.behind = {0, 0.3};
  p.position = 1.05;  // the second axle stands at 0.75 m
  TEST_ASSERT(says(wall.made(p)->warnings(), "the deck below axle 2 at x = 0.75 m is on 2 stones"));
  p.position = 1.0;
  TEST_ASSERT(wall.made(p)->warnings().empty());
  p.position = 1.05;
  p.speed = 10;  // passes joints in no time
  TEST_ASSERT(wall.made(p)->warnings().empty());
}

/// Two stones of 1.2 x 0.4 x 0.3 m side by side along x, a cube each, their tops a set; their joint is at y = 0.4 m.
struct SideBySide {
  std::unique_ptr<BlockSource<3>> source;
  Structure<3> structure;

  SideBySide()
      : source(make_source(blocks())),
        structure(
            *source, share_out(*source, *everyone()), {},
            [](const Block<3>&) {
              return Material{1e9, 0.2, density};
            },
            everyone()) {}
  static BlockList<3> blocks() {
    BlockList<3> list;
    list.facet_sets = {"top"};
    for (int b = 0; b < 2; ++b) {
      Block<3> block;
      block.id = b;
      block.name = b == 0 ? "south" : "north";
      for (int k = 0; k < 8; ++k) {
        const std::array<int, 3> at{k % 4 == 1 || k % 4 == 2, b + (k % 4 > 1), k / 4};
        block.position.push_back({1.2 * at[0], 0.4 * at[1], 0.3 * at[2]});
        block.vertex.push_back(at[0] + 2 * at[1] + 6 * at[2]);
      }
      block.cells = {{{0, 1, 2, 3, 4, 5, 6, 7}, 8}};
      block.facets = {{{4, 5, 6, 7}, 4, 0}};
      list.blocks.push_back(block);
    }
    return list;
  }
  Warnings warnings(const MovingTrainParameters& p) const {
    LoadParameters load;
    load.kind = p;
    return make_load(load, LoadSite<3>{structure, *source, {}, "scene > loads > tested"})->warnings();
  }
};

// Wheels along the joint of two stones stand on both all along, so that it matters in motion too; places are rounded.
TEUCHOS_UNIT_TEST(MovingTrain, AlongAJointSaysWhichStoneBearsItsWheels) {
  const SideBySide deck;
  MovingTrainParameters p;
  p.on = "top";
  p.axle_load = {1e3};
  p.behind = {0};
  p.position = 0.5;
  for (const double y : {0.4, 0.1 + 0.3 + 1e-16, 0.4 - 1e-10, 0.4 + 1e-10})
    for (const double speed : {0.0, 10.0}) {
      p.y = y;
      p.speed = speed;
      TEST_ASSERT(says(deck.warnings(p), "is on 2 stones, south, north; north bears the load"));
    }
  for (const double y : {0.0, 0.39, 0.41, 0.8}) {
    p.y = y;
    TEST_ASSERT(deck.warnings(p).empty());
  }
  p.gauge = 0.2;  // of two lines of wheels the second is along the joint
  p.y = 0.3;
  TEST_ASSERT(says(deck.warnings(p), "is on 2 stones"));
}

TEUCHOS_UNIT_TEST(Traction, ActsOnTheStonesOfTheSetThatIsNamed) {
  const LoadCase wall;
  TractionParameters p;
  p.on = "left";
  p.tx = 1000;
  TEST_FLOATING_EQUALITY(wall.resultant(p).x, 1000 * 1.0 * thickness, 1e-13);
  p.blocks = "course 1";
  const auto r = wall.resultant(p);
  TEST_FLOATING_EQUALITY(r.x, 1000 * 0.25 * thickness, 1e-13);
  TEST_FLOATING_EQUALITY(r.moment, -r.x * 0.375, 1e-13);  // the middle of course 1
}

}  // namespace

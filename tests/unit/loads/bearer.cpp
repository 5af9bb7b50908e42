// Loads that are placed at a point where stones meet say which stone bears them, and take another by its set.
#include <Teuchos_UnitTestHarness.hpp>

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

// What a dry run says of the cost, counted by hand.
//
// Set-up    One stone of 4 x 2 cells, two of 2 x 2 on it: 15 + 9 + 9 nodes, 3 joints of 3 points.
#include "results/prediction.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>
#include <sstream>

#include "mesh/block_source.hpp"
#include "support/tied_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

std::string said_of(const Scene& scene) {
  const auto comm = Tpetra::getDefaultComm();
  const auto source = make_block_source<2>(scene.mesh, *comm);
  std::ostringstream say;
  predict(scene, *source, comm, say);
  return say.str();
}

TEUCHOS_UNIT_TEST(Prediction, CountsBlocksNodesPointsAndSteps) {
  Scene scene = tied_wall();
  set_increments(scene, 4);  // of the second stage; the first is one step
  const auto said = said_of(scene);
  const auto says = [&](const std::string& words) { return said.find(words) != std::string::npos; };
  TEST_ASSERT(says("3 blocks, 3 joints, 33 nodes, 66 unknowns, 9 candidate contact points"));
  TEST_ASSERT(says("5 load steps of about 3 linear solves each"));  // bonded
  TEST_ASSERT(says("expected: 15 linear solves,"));
}

TEUCHOS_UNIT_TEST(Prediction, CountsTimeStepsOfAGivenLengthAndTheSearchForALoadFactor) {
  Scene scene = tied_wall();
  scene.selection.mode = SelectionMode::all;
  scene.load_factor.pattern = {{"sideways", 1.0}};
  scene.stages.resize(1);
  StageParameters shaken;
  shaken.name = "shaken";
  shaken.duration = 1;
  shaken.time_step = 0.1;  // ten of them, though 1 / 0.1 is a little off in binary
  scene.stages.push_back(shaken);
  auto said = said_of(scene);
  const auto says = [&](const std::string& words) { return said.find(words) != std::string::npos; };
  TEST_ASSERT(says("15 load steps of about 45 linear solves each"));  // one, and 14 attempts
  TEST_ASSERT(says("10 time steps of about 3 linear solves each"));
  TEST_ASSERT(says("expected: 705 linear solves,"));
  scene.stages.back().time_step = 0;
  said = said_of(scene);
  TEST_ASSERT(says("expected: 675 linear solves without those"));
}

}  // namespace

// Stages with a duration on the way through the stages.
// Shares are sums of twenty steps: 1e-12 is far above their rounding.
#include "dynamics/load_steps.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace {

using namespace voussoir;

StageParameters stage(const std::string& name, int increments, std::map<std::string, double> factors) {
  StageParameters s;
  s.name = name;
  s.increments = increments;
  s.factors = std::move(factors);
  return s;
}

TEUCHOS_UNIT_TEST(LoadSteps, CountTimeInStagesWithADurationAlone) {
  std::vector<StageParameters> stages{stage("weight", 1, {{"weight", 1.0}}), stage("shaking", 1, {{"push", 1.0}}),
                                      stage("after", 1, {{"push", 0.0}})};
  stages[1].duration = 2;
  stages[2].duration = 1;
  stages[2].at_once = true;
  LoadSteps steps(stages, {});
  TEST_ASSERT(!steps.dynamic());
  steps.accept();
  TEST_EQUALITY(steps.time(), 0.0);
  TEST_ASSERT(steps.dynamic());
  steps.set_time_step(0.1);
  TEST_FLOATING_EQUALITY(steps.target(), 0.05, 1e-12);
  TEST_FLOATING_EQUALITY(steps.factors(steps.target() / 2).at("push"), 0.025, 1e-12);
  int taken = 0;
  for (; steps.stage() == "shaking" && taken < 100; ++taken) steps.accept();
  TEST_EQUALITY(taken, 20);
  TEST_ASSERT(steps.stage_reached());
  TEST_FLOATING_EQUALITY(steps.time(), 2.0, 1e-12);
  TEST_EQUALITY(steps.last_factors().at("push"), 1.0);
  TEST_EQUALITY(steps.factors(0.5).at("push"), 0.0);  // at once
  while (!steps.finished()) steps.accept();
  TEST_FLOATING_EQUALITY(steps.time(), 3.0, 1e-12);
}

TEUCHOS_UNIT_TEST(LoadSteps, KnowWhetherAnyOrAllStagesTakeTime) {
  std::vector<StageParameters> stages{stage("weight", 1, {}), stage("shaking", 1, {})};
  TEST_ASSERT(!any_time(stages) && !only_time(stages));
  stages[1].duration = 1;
  TEST_ASSERT(any_time(stages) && !only_time(stages));
  stages[0].duration = 1;
  TEST_ASSERT(only_time(stages));
  TEST_ASSERT(!only_time({}));
}

}  // namespace

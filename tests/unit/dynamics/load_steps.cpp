// The way through the stages. Shares are sums of a few halves and quarters, exact in binary; others to 1e-12, a few
// hundred roundings of 1e-16 with room.
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

TEUCHOS_UNIT_TEST(LoadSteps, GoToTheFactorsOfAStageInEqualIncrements) {
  const std::vector<StageParameters> stages{stage("weight", 1, {{"weight", 1.0}}), stage("crowd", 4, {{"crowd", 2.0}})};
  LoadSteps steps(stages, {});
  TEST_EQUALITY(steps.factors().at("weight"), 1.0);
  steps.accept();
  TEST_EQUALITY(steps.stage(), "crowd");
  for (int k = 1; k <= 4; ++k) {
    TEST_EQUALITY(steps.target(), 0.25 * k);
    TEST_EQUALITY(steps.factors().at("crowd"), 0.5 * k);
    TEST_EQUALITY(steps.factors().at("weight"), 1.0);  // not named: keeps its factor
    steps.accept();
  }
  TEST_ASSERT(steps.finished());
  TEST_EQUALITY(steps.progress(), 1.0);
}

TEUCHOS_UNIT_TEST(LoadSteps, StartAStageFromWhereTheLastOneLeftALoad) {
  const std::vector<StageParameters> stages{stage("on", 1, {{"crowd", 2.0}}), stage("off", 2, {{"crowd", 1.0}})};
  LoadSteps steps(stages, {});
  steps.accept();
  TEST_EQUALITY(steps.factors().at("crowd"), 1.5);
}

TEUCHOS_UNIT_TEST(LoadSteps, HalveAStepAndTryTheLargerOneAgainAfterTwo) {
  const std::vector<StageParameters> stages{stage("crowd", 1, {{"crowd", 1.0}})};
  LoadSteps steps(stages, {});
  TEST_ASSERT(steps.halve());
  TEST_ASSERT(steps.halve());
  TEST_EQUALITY(steps.target(), 0.25);
  steps.accept();
  steps.accept();
  TEST_EQUALITY(steps.reached(), 0.5);
  TEST_EQUALITY(steps.halvings(), 1);
  TEST_EQUALITY(steps.target(), 1.0);
  TEST_EQUALITY(steps.progress(), 0.5);
}

TEUCHOS_UNIT_TEST(LoadSteps, StopHalvingAtTheLargestNumber) {
  const std::vector<StageParameters> stages{stage("crowd", 1, {{"crowd", 1.0}})};
  LoadStepParameters parameters;
  parameters.largest_halvings = 1;
  LoadSteps steps(stages, parameters);
  TEST_ASSERT(steps.halve());
  TEST_ASSERT(!steps.halve());
  TEST_EQUALITY(steps.target(), 0.5);
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

// How numbers of steps become those of a run.
#include "base/step_numbers.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <limits>

namespace {

using namespace voussoir;

StepNumbers step_with(double all) {
  StepNumbers n;
  each_number([&](const char*, const std::string&, OverSteps,
                  auto& value) { value = static_cast<std::decay_t<decltype(value)>>(all); },
              n);
  return n;
}

TEUCHOS_UNIT_TEST(StepNumbers, GoOverStepsEachInItsWay) {
  auto run = step_with(5);
  run.add_step(step_with(3));
  each_number(
      [&](const char*, const std::string&, OverSteps over, const auto& value) {
        TEST_EQUALITY(value, over == OverSteps::last ? 3 : over == OverSteps::sum ? 8 : 5);
      },
      run);
  StepNumbers unknown;
  unknown.error_estimate = std::numeric_limits<double>::quiet_NaN();
  run.add_step(unknown);
  TEST_EQUALITY_CONST(run.error_estimate, 5.0);  // a step without an estimate takes none away
}

TEUCHOS_UNIT_TEST(StepNumbers, AnAttemptThatDoesNotStandLeavesItsWork) {
  auto run = step_with(5);
  run.add_work(step_with(7));
  each_number([&](const char*, const std::string&, OverSteps over,
                  const auto& value) { TEST_EQUALITY(value, over == OverSteps::sum ? 12 : 5); },
              run);
}

TEUCHOS_UNIT_TEST(StepNumbers, NamesInFilesAreDifferent) {
  std::string all = ",";
  each_number([&](const char*, const std::string& name, OverSteps) {
    TEST_EQUALITY(all.find(',' + name + ','), std::string::npos);
    all += name + ',';
  });
}

}  // namespace

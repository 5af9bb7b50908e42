// The way through stages, and that it can be left and taken up again anywhere.
#include "dynamics/load_steps.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <any>

#include "dynamics/energy_book.hpp"

namespace {

using namespace voussoir;

/// An archive in memory: saves on its first use, restores when it is turned round.
struct Memory {
  std::map<std::string, std::any> values;
  bool restoring = false;
  template <class T>
  void value(const std::string& name, T& v) {
    if (restoring)
      v = std::any_cast<T>(values.at(name));
    else
      values[name] = v;
  }
  template <class T>
  void within(const std::string& name, T& v, double, double) {
    value(name, v);
  }
};

std::vector<StageParameters> stages() {
  StageParameters weight, push, unload;
  weight.name = "weight";
  weight.factors = {{"weight", 1.0}};
  push.name = "push";
  push.increments = 3;
  push.factors = {{"push", 0.7}};
  unload.name = "unload";
  unload.increments = 2;
  unload.factors = {{"push", 0.0}};
  return {weight, push, unload};
}

TEUCHOS_UNIT_TEST(LoadSteps, ReachEveryStageExactlyAndKeepEarlierLoads) {
  const auto all = stages();
  LoadSteps steps(all, {});
  std::vector<double> push;
  while (!steps.finished()) {
    const auto factors = steps.factors();
    push.push_back(factors.count("push") ? factors.at("push") : 0.0);
    TEST_EQUALITY_CONST(factors.at("weight"), 1.0);
    steps.accept();
  }
  TEST_EQUALITY_CONST(push.size(), 6u);
  TEST_EQUALITY_CONST(push[0], 0.0);
  TEST_FLOATING_EQUALITY(push[1], 0.7 / 3, 1e-15);
  TEST_EQUALITY_CONST(push[3], 0.7);  // the end of a stage is no sum of increments
  TEST_EQUALITY_CONST(push[5], 0.0);
  TEST_EQUALITY_CONST(steps.progress(), 1.0);
}

TEUCHOS_UNIT_TEST(LoadSteps, HalveAsOftenAsAllowedAndGrowAgainAfterTwoStepsThatWork) {
  const auto all = stages();
  LoadStepParameters parameters;
  parameters.largest_halvings = 2;
  LoadSteps steps(all, parameters);
  steps.accept();
  TEST_ASSERT(steps.halve());
  TEST_ASSERT(steps.halve());
  TEST_ASSERT(!steps.halve());
  TEST_FLOATING_EQUALITY(steps.target(), 1.0 / 12, 1e-15);
  steps.accept();
  steps.accept();
  TEST_EQUALITY_CONST(steps.halvings(), 1);
}

TEUCHOS_UNIT_TEST(LoadSteps, GoOnFromAnywhereAsIfTheyHadNeverStopped) {
  const auto all = stages();
  // Left after every number of steps, with a halving in the second stage, which leaves an odd share behind.
  for (int left = 0; left < 7; ++left) {
    LoadSteps one(all, {});
    for (int k = 0; k < left && !one.finished(); ++k) {
      if (k == 2) one.halve();
      one.accept();
    }
    Memory memory;
    one.keep(memory);
    memory.restoring = true;
    LoadSteps other(all, {});
    other.keep(memory);
    while (!one.finished()) {
      TEST_EQUALITY(other.stage(), one.stage());
      TEST_EQUALITY(other.target(), one.target());
      TEST_ASSERT(other.factors() == one.factors());
      TEST_EQUALITY(other.halvings(), one.halvings());
      TEST_EQUALITY(other.progress(), one.progress());
      one.accept();
      other.accept();
    }
    TEST_ASSERT(other.finished());
  }
}

// A scene may change its tolerances before a restart.
TEUCHOS_UNIT_TEST(LoadSteps, HalvedMoreOftenThanIsAllowedNowAreHalvedNoMore) {
  const auto all = stages();
  LoadStepParameters patient, impatient;
  patient.largest_halvings = 4;
  impatient.largest_halvings = 2;
  LoadSteps steps(all, patient), restarted(all, impatient);
  for (int k = 0; k < 3; ++k) TEST_ASSERT(steps.halve());
  Memory memory;
  steps.keep(memory);
  memory.restoring = true;
  restarted.keep(memory);
  TEST_ASSERT(!restarted.halve());
  TEST_EQUALITY_CONST(restarted.halvings(), 3);
}

TEUCHOS_UNIT_TEST(EnergyBook, IsKeptWhole) {
  EnergyBook book, back;
  book.advance({1.0, 2.0, 4.5, 0.25, 0.125, 0.0, 0.0, 0.0, 0.5}, true);
  book.advance({1.5, 2.5, 0.5, 0.25, 0.125, 0.0, 0.125, 0.0, 0.5}, true);
  book.remove(0.125);
  Memory memory;
  book.keep(memory);
  memory.restoring = true;
  back.keep(memory);
  TEST_EQUALITY_CONST(back.sums().elastic, 1.5);
  TEST_EQUALITY_CONST(back.sums().kinetic, 2.5);
  TEST_EQUALITY_CONST(back.sums().external_work, 5.0);
  TEST_EQUALITY_CONST(back.sums().friction, 0.5);
  TEST_EQUALITY_CONST(back.sums().fracture, 0.25);
  TEST_EQUALITY_CONST(back.sums().jump, 0.125);
  TEST_EQUALITY_CONST(back.sums().removed, 0.125);
  TEST_EQUALITY_CONST(back.imbalance(), 0.0);  // a part counts no second time
}

TEUCHOS_UNIT_TEST(EnergyBook, WhatBlocksStoreWithinIsWorkOfLoads) {
  EnergyBook book, back;
  book.advance({1.0, 0.0, 1.0}, false, 0.5);
  TEST_EQUALITY_CONST(book.sums().elastic, 1.5);
  TEST_EQUALITY_CONST(book.sums().external_work, 1.5);
  Memory memory;
  book.keep(memory);
  memory.restoring = true;
  back.keep(memory);
  back.remove(0.0, 0.125);  // leaves with a stone, and is no work
  back.advance({2.0, 0.0, 1.0}, false, 0.25);
  TEST_EQUALITY_CONST(back.sums().elastic, 2.25);
  TEST_EQUALITY_CONST(back.sums().external_work, 2.375);
  TEST_EQUALITY_CONST(back.imbalance(), 0.0);
}

TEUCHOS_UNIT_TEST(EnergyBook, LoadStepsRemoveWhatMoves) {
  EnergyBook book;
  book.advance({1.0, 2.0, 3.0, 0.0, 0.0, 0.0}, true);
  book.advance({1.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  TEST_EQUALITY_CONST(book.sums().removed, 2.0);
  TEST_EQUALITY_CONST(book.imbalance(), 0.0);
}

}  // namespace

// What loads and supports do in a step lies between their forces at its ends, whatever laws of joints say.
#include "results/load_step_book.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "results/step_warnings.hpp"

namespace {

using namespace voussoir;

// A plate that moves by 2 mm while its force falls from 3 to 1 kN: 4 J of the mean, 2 J at least, 6 J at most.
const WorkOfForces falling{4.0, 0.0, -4.0};

EnergyOfStep with(const WorkOfForces& forces, double beyond_mean, double overshoot = 0, bool jumped = false) {
  EnergyOfStep energy;
  add_work(forces, beyond_mean, overshoot, jumped, energy);
  TEUCHOS_ASSERT(energy.external_work == forces.of_mean + energy.work_within_steps);
  return energy;
}

TEUCHOS_UNIT_TEST(WorkOfForces, FollowsTheLawWhereForcesAllowIt) {
  for (const double beyond : {-2.0, -1.5, 0.0, 1.5, 2.0}) {
    TEST_EQUALITY(with(falling, beyond).external_work, 4 + beyond);
    TEST_EQUALITY(with(falling, beyond).jump, 0);
  }
}

TEUCHOS_UNIT_TEST(WorkOfForces, IsThatOfTheirMeanInAJumpWhoseLossIsTold) {
  const auto energy = with(falling, -5.0);
  TEST_EQUALITY(energy.external_work, 4);
  TEST_EQUALITY(energy.jump, 5);
  // Where forces had a peak within the step, laws on a straight way may be off by as much: what they lack is imbalance.
  TEST_EQUALITY(with(falling, -2.5, 1.0).external_work, 4);
  TEST_EQUALITY(with(falling, -2.5, 1.0).jump, 0);
  TEST_EQUALITY(with(falling, -3.5, 1.0).jump, 3.5);
  // As where the solver has seen one.
  TEST_EQUALITY(with(falling, -0.5, 0, true).external_work, 4);
  TEST_EQUALITY(with(falling, -0.5, 0, true).jump, 0.5);
  TEST_EQUALITY(with(falling, 0.5, 0, true).external_work, 4.5);
}

TEUCHOS_UNIT_TEST(WorkOfForces, IsNoMoreThanForcesAndWhatJointsBoreBeyondThem) {
  TEST_EQUALITY(with(falling, 9.0).external_work, 6);
  TEST_EQUALITY(with(falling, 9.0, 1.5).external_work, 7.5);
  TEST_EQUALITY(with(falling, 1.0, 1.5).external_work, 5);
}

TEUCHOS_UNIT_TEST(WorkOfForces, OfConstantOnesDoesNotDependOnJoints) {
  const WorkOfForces weight{4.0, 0.0, 0.0};
  for (const double beyond : {-3.0, 3.0}) TEST_EQUALITY(with(weight, beyond).external_work, 4);
  TEST_EQUALITY(with({4.0, 2.0, -2.0}, 9.0).external_work, 6);
}

TEUCHOS_UNIT_TEST(LostInJump, IsToldWhereItIsSeenInTheEnergies) {
  Energies book;
  book.external_work = 50;
  TEST_EQUALITY(lost_in_jump(20, book, "pull").size(), 1);
  TEST_EQUALITY(lost_in_jump(20, book, "pull")[0].how_much, 20);
  TEST_ASSERT(lost_in_jump(0.4, book, "pull").empty());
  TEST_ASSERT(lost_in_jump(0, {}, "pull").empty());
  book.external_work = -8e-14;  // round-off, where stones turn with what holds them
  TEST_ASSERT(lost_in_jump(0, book, "turn").empty());
}

TEUCHOS_UNIT_TEST(ForcesUndetermined, AreToldWhereTheyDifferByMoreThanTheToleranceOfTheScene) {
  TEST_ASSERT(forces_undetermined(0, 1e-6, {-1, -1}, "push").empty());
  TEST_ASSERT(forces_undetermined(1e-6, 1e-6, {3, 4}, "push").empty());
  const auto told = forces_undetermined(0.05, 1e-6, {3, 4}, "push");
  TEST_EQUALITY(told.size(), 1);
  TEST_EQUALITY(told[0].what, "forces_undetermined");
  TEST_EQUALITY(told[0].where, "joint 3 - 4");
  TEST_EQUALITY(told[0].how_much, 0.05);
}

}  // namespace

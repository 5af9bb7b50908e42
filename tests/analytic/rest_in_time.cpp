// Points that have rested are bonded again: what that costs in accuracy, and what it saves.
//
// Set-up    xml/wall-shaken.xml, shaken by half a sine of 0.1 s instead of a record: stones slide and open, then rest.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "motion.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

std::vector<std::string> pulse(double acceleration, double duration, double time_step, const std::string& mode) {
  const auto text = [](double value) { return std::to_string(value); };
  return {"loads/earthquake/x record=",
          "loads/earthquake/scale=1",
          "loads/earthquake/ax=" + text(acceleration),
          "loads/earthquake/time function/type=pulse",
          "loads/earthquake/time function/duration=0.1",
          "steps/time/mass damping=4",
          "steps/stages/shaking/duration=" + text(duration),
          "steps/stages/shaking/time step=" + text(time_step),
          "selection/mode=" + mode};
}

double elastic_energy(const Structure<2>& s, const std::vector<double>& u) {
  std::vector<double> ku;
  s.apply_stiffness(u, ku);
  double energy = 0;
  for (int i = 0; i < 2 * s.owned_nodes(); ++i) energy += u[i] * ku[i] / 2;
  return energy;
}

long long selected(const Motion& wall) {
  const auto& s = wall.state().selected;
  return std::count(s.begin(), s.end(), 1);
}

// What is promised is 2 % of the energy norm over the whole history.
TEUCHOS_UNIT_TEST(RestInTime, StaysCloseToAllPoints) {
  std::vector<std::vector<double>> all;
  double largest = 0;
  {
    Motion wall("wall-shaken", pulse(4.0, 0.17, 1e-3, "all"));
    TEST_ASSERT(wall.run([&] {
      all.push_back(wall.state().displacement);
      largest = std::max(largest, wall.report.elastic);
    }));
  }
  Motion wall("wall-shaken", pulse(4.0, 0.17, 1e-3, "adaptive"));
  double worst = 0;
  std::size_t step = 0;
  long long most = 0;
  TEST_ASSERT(wall.run([&] {
    auto difference = wall.state().displacement;
    for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= all[step][i];
    worst = std::max(worst, std::sqrt(elastic_energy(wall.model().structure(), difference) / largest));
    most = std::max(most, selected(wall));
    ++step;
  }));
  out << "largest difference " << worst << "\n";
  TEST_COMPARE(worst, <, 0.02);
  TEST_COMPARE(wall.book().friction(), >, 0);
  // The pulse needs most points, the rest after it does not.
  TEST_COMPARE(most, >, wall.model().points().size() / 2);
  TEST_COMPARE(selected(wall), <, wall.model().points().size() / 3);
  // As without bonding (wall_in_time.cpp): ties of increments do no work.
  TEST_COMPARE(wall.largest_imbalance, <, 1e-9 * wall.largest_energy);
  TEST_COMPARE(wall.least_friction, >, -1e-9 * wall.largest_energy);
}

/// What steps after a time cost.
struct Cost {
  int steps = 0, solves = 0, estimates = 0;
  long long krylov = 0;
  void add(const StepReport& report) {
    ++steps;
    solves += report.newton.newton_iterations;
    estimates += report.estimate_solves;
    krylov += report.newton.krylov_iterations;
  }
};

// A wall that has rested costs one linear solve per step, as if it were bonded, and nothing moves any more.
TEUCHOS_UNIT_TEST(RestInTime, CostsWhatABondedStepCosts) {
  constexpr double rested = 1.3;  // [s]
  auto settings = pulse(2.0, 1.5, 5e-3, "adaptive");
  settings.push_back("steps/time/mass damping=40");  // vibrations fall to 1e-11 of their energy
  Motion wall("wall-shaken", settings);
  double friction = 0;
  std::vector<double> place;
  long long most = 0, last = 0;
  Cost cost;
  TEST_ASSERT(wall.run([&] {
    most = std::max(most, selected(wall));
    if (wall.time < rested) {
      friction = wall.book().friction();
      place = wall.state().displacement;
      return;
    }
    last = std::max(last, selected(wall));
    cost.add(wall.report.step);
  }));
  settings.push_back("selection/mode=bonded");
  Motion bonded("wall-shaken", settings);
  Cost least;
  TEST_ASSERT(bonded.run([&] {
    if (bonded.time >= rested) least.add(bonded.report.step);
  }));
  out << cost.steps << " steps: " << cost.solves << " solves, " << cost.krylov << " Krylov iterations; bonded "
      << least.solves << ", " << least.krylov << "\n";
  TEST_COMPARE(most, >, 100);
  TEST_EQUALITY(last, 0);
  TEST_EQUALITY(cost.solves, least.solves);
  TEST_EQUALITY(cost.estimates, 0);
  TEST_COMPARE(static_cast<double>(cost.krylov), <=, 1.05 * static_cast<double>(least.krylov));
  TEST_EQUALITY(wall.book().friction(), friction);
  double moved = 0, size = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    moved = std::max(moved, std::abs(wall.state().displacement[i] - place[i]));
    size = std::max(size, std::abs(place[i]));
  }
  out << "moved by " << moved / size << " of the displacement\n";
  TEST_COMPARE(moved, <, 1e-4 * size);
}

// A structure that stands when time begins stands on: nothing is released that own weight has not released, no stone
// moves, and from the first step on a step is one linear solve. W(16), 2132 points, of which own weight selects 318.
TEUCHOS_UNIT_TEST(RestInTime, WhatStandsWhenTimeBeginsCostsABondedStepAtOnce) {
  const std::vector<std::string> settings = {"mesh/wall/courses=16", "mesh/wall/blocks per course=16",
                                             "loads/earthquake/scale=0", "steps/stages/shaking/duration=0.1",
                                             "steps/stages/shaking/time step=5e-3"};
  Motion wall("wall-shaken", settings);
  std::vector<double> place;
  Cost cost;
  double fastest = 0;
  TEST_ASSERT(wall.run([&] {
    if (place.empty()) place = wall.state().displacement;
    cost.add(wall.report.step);
    fastest = std::max(fastest, wall.report.kinetic);
    TEST_EQUALITY(selected(wall), 0);
  }));
  out << cost.steps << " steps: " << cost.solves << " solves, " << cost.estimates
      << " of estimates, kinetic energy up to " << fastest << " of " << wall.report.elastic << " J\n";
  TEST_COMPARE(cost.solves, <=, cost.steps);
  TEST_COMPARE(cost.estimates, <=, 1);
  // The load step is solved to 1e-8 of the largest force, and moves what that leaves.
  TEST_COMPARE(fastest, <, 1e-12 * wall.report.elastic);
}

}  // namespace

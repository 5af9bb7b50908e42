// The path of a slider, of whose push friction bears 30 N: where it begins, how its barrier falls, where it ends, and
// where near its end another way may take over.
#include "nonlinear/interior_path.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "linalg/local_view.hpp"
#include "unit/nonlinear/slider.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double friction = 0.3, at_rest = (push - friction * weight) / spring;  // [m]
constexpr double tolerance = 1e-9, near = 1e-3;

/// The mean of w y, as the bound on resistances tells it: that is 10 start / root of it.
double barrier_of(double augmentation) {
  const InteriorPathParameters numbers;
  return std::pow(numbers.resistance * numbers.start * weight / augmentation, 2);
}

struct Walk {
  PathEnd end;
  double slip;  ///< [m]
  PointField lambda;
  int solves;
};

Walk follow(const std::function<bool(TpetraVector&, PointField&)>& shortcut) {
  Patch problem = slider_on_the_ground(friction);
  TpetraVector x(problem.map());
  PointField lambda(2, 0.0);
  NewtonReport report;
  InteriorPath path(problem, {});
  path.shortcut = shortcut;
  const auto end = path.trace(x, lambda, tolerance, 100, nullptr, report);
  return {end, local_view(x)[0], lambda, report.newton_iterations};
}

TEUCHOS_UNIT_TEST(InteriorPath, OffersAShortcutWhereASolutionIsNearAndAgainWhereItIsNearer) {
  std::vector<double> off;  // [m] of the slips offered
  PointField forces;
  const auto walk = follow([&](TpetraVector& x, PointField& lambda) {
    off.push_back(std::abs(local_view(x)[0] - at_rest));
    forces = lambda;
    return false;
  });
  TEST_COMPARE(off.size(), >, 1);
  TEST_COMPARE(static_cast<int>(off.size()), <, walk.solves);
  TEST_COMPARE(off.front(), <=, near * weight / spring);
  for (std::size_t i = 1; i < off.size(); ++i) TEST_COMPARE(off[i], <, off[i - 1]);
  TEST_COMPARE(std::abs(forces[1]), <=, friction * forces[0] * (1 + 1e-12));
  TEST_ASSERT(walk.end == PathEnd::arrived);
  TEST_FLOATING_EQUALITY(walk.slip, at_rest, 1e-6);
}

TEUCHOS_UNIT_TEST(InteriorPath, GoesOnAsIfNothingHadBeenOfferedWhereAShortcutLeadsNowhere) {
  const auto alone = follow({});
  const auto offered = follow([](TpetraVector&, PointField& lambda) {
    lambda.assign(2, -1.0);  // what it leaves of the forces is its own affair
    return false;
  });
  TEST_EQUALITY(offered.solves, alone.solves);
  TEST_EQUALITY(offered.slip, alone.slip);
  TEST_COMPARE_ARRAYS(offered.lambda, alone.lambda);
}

TEUCHOS_UNIT_TEST(InteriorPath, EndsWhereAShortcutArrives) {
  const auto alone = follow({});
  const auto walk = follow([](TpetraVector& x, PointField& lambda) {
    local_view_to_write(x)[0] = at_rest;
    lambda = {weight, friction * weight};
    return true;
  });
  TEST_ASSERT(walk.end == PathEnd::arrived);
  TEST_EQUALITY(walk.slip, at_rest);
  TEST_EQUALITY(walk.lambda[1], friction * weight);
  TEST_COMPARE(walk.solves, <, alone.solves);
}

// From rest without forces the path begins a tenth of the largest force, 10 N, from the bounds: of an opening w = 10 N,
// of slips 0.3 x 10 N, and y = 10 N over the stiffness of the stones.
TEUCHOS_UNIT_TEST(InteriorPath, ItsBarrierBeginsAtTheDistanceFromTheBoundsAndFalls) {
  Patch problem = slider_on_the_ground(friction);
  TpetraVector x(problem.map());
  PointField lambda(2, 0.0);
  NewtonReport report;
  InteriorPath path(problem, {});
  std::vector<double> resistance;  // bounds on it, relative to the stiffness of the stones
  path.watch = [&](const NewtonProgress& p) {
    resistance.push_back(p.augmentation);
    return GoOn::yes;
  };
  TEST_ASSERT(path.trace(x, lambda, tolerance, 100, nullptr, report) == PathEnd::arrived);
  TEST_FLOATING_EQUALITY(barrier_of(resistance.front()), (10.0 * 10 + 3 * 10 + 3 * 10) / 3, 1e-12);
  TEST_EQUALITY(resistance.back(), InteriorPathParameters().largest_resistance);  // at a barrier of 0.01 N2 or less
}

TEUCHOS_UNIT_TEST(InteriorPath, EndsWithForcesOfTheLaw) {
  const auto walk = follow({});
  TEST_ASSERT(walk.end == PathEnd::arrived);
  TEST_FLOATING_EQUALITY(walk.lambda[0], weight, 1e-6);
  TEST_FLOATING_EQUALITY(std::abs(walk.lambda[1]), friction * weight, 1e-6);
  TEST_FLOATING_EQUALITY(walk.slip, at_rest, 1e-6);
}

// A node is pushed off a plane that leans by 60 degrees, with a coefficient of friction of 1: its spring holds it where
// it has left the plane. Friction that follows the pressure all along a step leads into a fold, where the path ends.
TEUCHOS_UNIT_TEST(InteriorPath, PassesAFoldWhereFrictionFollowsThePressureByLess) {
  const double off_the_plane = weight / spring, half = 0.5, root = std::sqrt(3.0) / 2;
  for (const bool folds : {true, false}) {
    auto parts = parts_of_slider(1);
    parts.points[0].axis = {{{root, half}, {-half, root}}};
    parts.imbalance = {-weight, 0};
    parts.stiffness = {{0, 0, spring}, {1, 1, 1e-3}};
    Patch problem(parts);
    TpetraVector x(problem.map());
    PointField lambda(2, 0.0);
    NewtonReport report;
    MethodParameters methods;
    methods.path.folds = folds;
    InteriorPath path(problem, methods);
    const auto end = path.trace(x, lambda, tolerance, 100, nullptr, report);
    TEST_ASSERT(end == (folds ? PathEnd::arrived : PathEnd::stuck));
    if (!folds) continue;
    TEST_FLOATING_EQUALITY(local_view(x)[0], off_the_plane, 1e-6);
    TEST_COMPARE(std::abs(lambda[0]) + std::abs(lambda[1]), <=, 2 * tolerance * weight);
  }
}

// Without its spring nothing bears the 20 N that friction leaves of the push.
TEUCHOS_UNIT_TEST(InteriorPath, WhatRunsAwayIsPutBack) {
  auto parts = parts_of_slider(friction);
  parts.stiffness = {{0, 0, 1e-9}, {1, 1, 1e-6}};
  parts.proximal_weight = {1e-9, 1e-6};
  Patch problem(parts);
  TpetraVector x(problem.map());
  PointField lambda{1, 0};
  NewtonReport report;
  InteriorPath path(problem, {});
  TEST_ASSERT(path.trace(x, lambda, tolerance, 100, nullptr, report) == PathEnd::ran_away);
  TEST_EQUALITY(local_view(x)[0], 0.0);
  TEST_COMPARE_ARRAYS(lambda, (PointField{1, 0}));
}

TEUCHOS_UNIT_TEST(InteriorPath, HaltsAtTheLargestNumberOfStepsWithForcesOfTheLaw) {
  Patch problem = slider_on_the_ground(friction);
  TpetraVector x(problem.map());
  PointField lambda(2, 0.0);
  NewtonReport report;
  InteriorPath path(problem, {});
  TEST_ASSERT(path.trace(x, lambda, tolerance, 2, nullptr, report) == PathEnd::stuck);
  TEST_EQUALITY(report.newton_iterations, 2);
  TEST_COMPARE(std::abs(lambda[1]), <=, friction * std::max(0.0, lambda[0]) * (1 + 1e-12));
}

}  // namespace

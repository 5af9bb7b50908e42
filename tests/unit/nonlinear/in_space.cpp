// Friction has a direction in space: where a block slides to, when it starts, and a block that spins.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <tuple>

#include "nonlinear/contact_solver.hpp"
#include "unit/nonlinear/block_in_space.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double mu = 0.4, limit = mu * BlockInSpace::weight;  // [N] of a corner
const double full_turn = 4 * std::acos(0.0);

struct Rest {
  NewtonReport report;
  std::vector<double> moved;  ///< [m] x, y, z of the corners
  PointField force;           ///< [N] normal, along x, along y
};

enum class Way { all, active_sets, path, pseudo_time };

Rest solve(const std::array<BlockInSpace::Place, 4>& push, Way way) {
  BlockInSpace block(mu, push);
  TpetraVector x(block.map());
  PointField lambda(12, 0.0);
  for (int a = 0; a < 4; ++a) lambda[3 * a] = BlockInSpace::weight;
  MethodParameters methods;
  if (way != Way::all) {
    methods.solver.active_sets = way == Way::active_sets;
    methods.path.used = way == Way::path;
    methods.solver.shortcut = false;
    methods.pseudo_time.used = way == Way::pseudo_time;
  }
  FastWay fast;
  Rest rest;
  Damage no_damage;
  rest.report = ContactSolver(block, {}, methods, fast).solve({x, lambda, no_damage}, {1e-11});
  rest.moved.assign(local_view(x), local_view(x) + 12);
  rest.force = lambda;
  return rest;
}

std::array<BlockInSpace::Place, 4> along(double angle, double size) {
  std::array<BlockInSpace::Place, 4> push;
  push.fill({size * std::cos(angle), size * std::sin(angle)});
  return push;
}

TEUCHOS_UNIT_TEST(InSpace, ABlockSlidesAlongThePushWhereverThatPoints) {
  for (const auto way : {Way::all, Way::active_sets, Way::path, Way::pseudo_time})
    for (int k = 0; k < 16; ++k) {
      const double angle = 0.1 + k * full_turn / 16, push = 1.7 * limit, slip = (push - limit) / BlockInSpace::holding;
      const auto rest = solve(along(angle, push), way);
      TEST_ASSERT(rest.report.outcome == NewtonOutcome::converged);
      for (int a = 0; a < 4; ++a) {
        TEST_FLOATING_EQUALITY(rest.moved[3 * a], slip * std::cos(angle), 1e-7);
        TEST_FLOATING_EQUALITY(rest.moved[3 * a + 1], slip * std::sin(angle), 1e-7);
        TEST_FLOATING_EQUALITY(rest.force[3 * a + 1], -limit * std::cos(angle), 1e-7);
        TEST_FLOATING_EQUALITY(rest.force[3 * a + 2], -limit * std::sin(angle), 1e-7);
      }
    }
}

// Each component alone is far below the limit.
TEUCHOS_UNIT_TEST(InSpace, SlipBeginsWhereTheResultantReachesTheLimit) {
  const auto below = solve(along(full_turn / 8, 0.999 * limit), Way::all);
  const auto beyond = solve(along(full_turn / 8, 1.001 * limit), Way::all);
  for (const auto* rest : {&below, &beyond}) TEST_ASSERT(rest->report.outcome == NewtonOutcome::converged);
  for (int a = 0; a < 4; ++a) {
    TEST_COMPARE(std::hypot(below.moved[3 * a], below.moved[3 * a + 1]), <=, 1e-9 * limit / BlockInSpace::holding);
    TEST_FLOATING_EQUALITY(std::hypot(beyond.moved[3 * a], beyond.moved[3 * a + 1]),
                           0.001 * limit / BlockInSpace::holding, 1e-5);
  }
}

// A couple of four forces: corners slide in four directions, and all of their friction resists.
TEUCHOS_UNIT_TEST(InSpace, ABlockSpinsAgainstTheFrictionOfItsCorners) {
  std::array<BlockInSpace::Place, 4> couple;
  constexpr double push = 1.5 * limit;
  for (int a = 0; a < 4; ++a) {
    const auto p = BlockInSpace::corner(a);
    couple[a] = {-push * p[1] / BlockInSpace::radius, push * p[0] / BlockInSpace::radius};
  }
  const auto rest = solve(couple, Way::all);
  TEST_ASSERT(rest.report.outcome == NewtonOutcome::converged);
  for (int a = 0; a < 4; ++a) {
    const auto p = BlockInSpace::corner(a);
    const double along = (-p[1] * rest.moved[3 * a] + p[0] * rest.moved[3 * a + 1]) / BlockInSpace::radius;
    TEST_FLOATING_EQUALITY(along, (push - limit) / BlockInSpace::holding, 1e-7);
    TEST_FLOATING_EQUALITY(rest.force[3 * a], BlockInSpace::weight, 1e-7);
    TEST_FLOATING_EQUALITY(std::hypot(rest.force[3 * a + 1], rest.force[3 * a + 2]), limit, 1e-9);
  }
}

// Pushed along x, then along y as well: the direction of slip turns from one solve to the next.
TEUCHOS_UNIT_TEST(InSpace, CornersThatAreBeyondTheirLimitBearNoMoreThanIt) {
  std::array<BlockInSpace::Place, 4> push;
  for (int a = 0; a < 4; ++a) push[a] = {3 * limit * std::cos(1.3 * a), 2 * limit * std::sin(0.7 * a + 0.2)};
  const auto rest = solve(push, Way::all);
  TEST_ASSERT(rest.report.outcome == NewtonOutcome::converged);
  for (int a = 0; a < 4; ++a) {
    const double* q = &rest.force[3 * a + 1];
    const double* u = &rest.moved[3 * a];
    const double size = std::hypot(q[0], q[1]), slip = std::hypot(u[0], u[1]);
    TEST_COMPARE(size, <=, limit * (1 + 1e-9));
    if (slip < 1e-6) continue;
    TEST_FLOATING_EQUALITY(size, limit, 1e-9);
    TEST_FLOATING_EQUALITY(q[0] * u[0] + q[1] * u[1], -size * slip, 1e-9);  // against the slip
  }
}

}  // namespace

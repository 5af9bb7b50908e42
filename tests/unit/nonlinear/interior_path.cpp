// Near the end of the path another way may take over: a slider, of whose push friction bears 30 N.
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
  const auto end = path.follow(x, lambda, tolerance, 100, nullptr, report);
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

}  // namespace

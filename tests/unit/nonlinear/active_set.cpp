// What active sets do with a solve that makes things worse: a slider that flies, of whose push friction bears 30 N.
#include "nonlinear/active_set.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>

#include "linalg/local_view.hpp"
#include "unit/nonlinear/slider.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double friction = 0.3, at_rest = (push - friction * weight) / spring;  // [m]

/// Flies by a metre with every solve, less far where damping helps.
class Flying : public Patch {
 public:
  explicit Flying(bool helps) : Patch(parts_of_slider(friction)), helps_(helps) {}
  int solve(const std::vector<PointStiffness>& resistance, double, const Teuchos::RCP<TpetraVector>&,
            const Teuchos::RCP<TpetraVector>& d, const SolveRequest&) override {
    const double damping = resistance[0].tangential / stone;
    largest_damping = std::max(largest_damping, damping);
    d->putScalar(0);
    local_view_to_write(*d)[0] = helps_ && damping > 0 ? 1e-3 / damping : 1;
    return 1;
  }
  double largest_damping = 0;  ///< relative to the local stiffness

 private:
  bool helps_;
};

double damping_of(bool helps) {
  Flying problem(helps);
  TpetraVector x(problem.map());
  local_view_to_write(x)[0] = at_rest - 1e-3;  // a newton from rest
  PointField lambda = {weight, friction * weight};
  NewtonReport report;
  ActiveSet active(problem, ActiveSetUse::at_rest, ActiveSet::usual_patience);
  active.solve(x, lambda, 1e-9, 30, nullptr, report);
  return problem.largest_damping;
}

TEUCHOS_UNIT_TEST(ActiveSet, DampsStonesThatFlyAsLongAsThatHelps) { TEST_COMPARE(damping_of(true), >=, 0.1); }

TEUCHOS_UNIT_TEST(ActiveSet, DampsNoMoreWhereThatDoesNotHelp) {
  const double damping = damping_of(false);
  TEST_COMPARE(damping, >, 0);
  TEST_COMPARE(damping, <=, 0.01 * (1 + 1e-12));
}

}  // namespace

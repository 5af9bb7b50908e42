// The law at one point: projections and bounds in all their corners, derivatives by automatic differentiation.
#include "joints/contact_law.hpp"

#include <Sacado.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <limits>
#include <random>

namespace {

using namespace voussoir;

using Dual = Sacado::Fad::SFad<double, 3>;
constexpr double infinite = std::numeric_limits<double>::infinity();

const PointLaw dry{0.6, 0, 0};
const PointLaw mortar{0.6, 50, 20};
const PointLaw glued{infinite, infinite, infinite};
const PointLaw rough{infinite, 50, 20};
const PointLaw smooth{0, 0, 0};

/// Admissible by the definition itself: N >= -tension and |q| <= cohesion + mu N.
bool admissible(const PointLaw& law, const std::array<double, 2>& f) {
  if (f[0] < -law.tension) return false;
  return std::abs(f[1]) <= friction_bound(law, f[0]);
}

TEUCHOS_UNIT_TEST(FrictionBound, IsCohesionPlusFrictionTimesPressureAndNeverNegative) {
  TEST_EQUALITY(friction_bound(dry, 100.0), 60.0);
  TEST_EQUALITY(friction_bound(dry, 0.0), 0.0);
  TEST_EQUALITY(friction_bound(dry, -100.0), 0.0);
  TEST_EQUALITY(friction_bound(mortar, 100.0), 110.0);
  TEST_EQUALITY(friction_bound(mortar, -20.0), 50.0 - 12.0);  // tension takes from the shear strength
  TEST_EQUALITY(friction_bound(mortar, -1000.0), 0.0);
  TEST_EQUALITY(friction_bound(smooth, 1e9), 0.0);
}

TEUCHOS_UNIT_TEST(FrictionBound, InfiniteStrengthIsABoundAndNeverNotANumber) {
  for (const double normal : {-10.0, 0.0, 10.0}) TEST_EQUALITY(friction_bound(glued, normal), infinite);
  TEST_EQUALITY(friction_bound(rough, 10.0), infinite);
  TEST_EQUALITY(friction_bound(rough, 0.0), 50.0);    // infinite friction without pressure is cohesion alone
  TEST_EQUALITY(friction_bound(rough, -10.0), 50.0);
}

TEUCHOS_UNIT_TEST(ProjectNormal, CutsTensionAtTheStrengthAndKeepsTheRest) {
  TEST_EQUALITY(project_normal(dry, 7.0), 7.0);
  TEST_EQUALITY(project_normal(dry, -7.0), 0.0);
  TEST_EQUALITY(project_normal(mortar, -7.0), -7.0);
  TEST_EQUALITY(project_normal(mortar, -21.0), -20.0);
  TEST_EQUALITY(project_normal(glued, -1e300), -1e300);
}

TEUCHOS_UNIT_TEST(ProjectTangential, KeepsTheDirectionAndCutsTheSize) {
  const std::array<double, 2> q{3, 4};
  TEST_ASSERT(project_tangential(q, 5.0) == q);
  TEST_ASSERT(project_tangential(q, infinite) == q);
  const auto cut = project_tangential(q, 1.0);
  TEST_FLOATING_EQUALITY(cut[0], 0.6, 1e-15);
  TEST_FLOATING_EQUALITY(cut[1], 0.8, 1e-15);
  const std::array<double, 2> none{0, 0};
  TEST_ASSERT(project_tangential(q, 0.0) == none);
  TEST_ASSERT(project_tangential(none, 0.0) == none);
  const std::array<double, 1> plane{-3};
  TEST_EQUALITY(project_tangential(plane, 2.0)[0], -2.0);
}

TEUCHOS_UNIT_TEST(ContactLaw, DerivativesAreThoseOfTheFormulaOnBothSidesOfEveryKink) {
  const auto derivative = [](double at, auto f) { return f(Dual(3, 0, at)).fastAccessDx(0); };
  for (const auto& law : {dry, mortar}) {
    const auto bound = [&law](const Dual& n) { return friction_bound(law, n); };
    TEST_EQUALITY(derivative(10.0, bound), law.friction);
    TEST_EQUALITY(derivative(-10.0, bound), law.cohesion > 0 ? law.friction : 0.0);
    TEST_EQUALITY(derivative(-1000.0, bound), 0.0);
    const auto normal = [&law](const Dual& n) { return project_normal(law, n); };
    TEST_EQUALITY(derivative(-law.tension + 1, normal), 1.0);
    TEST_EQUALITY(derivative(-law.tension - 1, normal), 0.0);
  }
  TEST_EQUALITY(derivative(-10.0, [](const Dual& n) { return friction_bound(rough, n); }), 0.0);

  // On the cone d(b q / |q|) = b / |q| (I - t t^T), t = q / |q| = (0.6, 0.8); inside it is the identity.
  const std::array<Dual, 2> q{Dual(3, 0, 3.0), Dual(3, 1, 4.0)};
  const auto slipping = project_tangential(q, 2.0), sticking = project_tangential(q, 6.0);
  const double t[2] = {0.6, 0.8};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      TEST_COMPARE(std::abs(slipping[i].fastAccessDx(j) - 0.4 * ((i == j) - t[i] * t[j])), <=, 1e-15);
      TEST_EQUALITY(sticking[i].fastAccessDx(j), i == j ? 1.0 : 0.0);
    }
}

TEUCHOS_UNIT_TEST(Violation, IsZeroForAdmissibleForcesAndForNoOthers) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> force(-100, 100);
  for (const auto& law : {dry, mortar, glued, rough, smooth}) {
    int inside = 0;
    for (int k = 0; k < 1000; ++k) {
      const std::array<double, 2> f{force(random), force(random)};
      inside += admissible(law, f);
      TEST_EQUALITY(violation(law, f) == 0, admissible(law, f));
    }
    out << inside << " of 1000 inside\n";
  }
}

TEUCHOS_UNIT_TEST(Violation, IsTheDistanceToTheForceTheLawProjectsTo) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> force(-100, 100);
  for (const auto& law : {dry, mortar, rough, smooth})
    for (int k = 0; k < 200; ++k) {
      const std::array<double, 3> f{force(random), force(random), force(random)};
      const double normal = project_normal(law, f[0]);
      const auto q = project_tangential(std::array<double, 2>{f[1], f[2]}, friction_bound(law, normal));
      const std::array<double, 3> projected{normal, q[0], q[1]};
      // Forces of 100 N: 1e-12 is a hundred times their round-off.
      TEST_COMPARE(std::abs(violation(law, f) - norm(f - projected)), <=, 1e-12);
      TEST_COMPARE(violation(law, projected), <=, 1e-12);
    }
}

TEUCHOS_UNIT_TEST(Violation, IsTheNearestDistanceWhereOnlyOneConditionFails) {
  TEST_EQUALITY(violation(dry, std::array<double, 2>{-3, 0}), 3.0);        // pulled
  TEST_EQUALITY(violation(dry, std::array<double, 2>{-3, 4}), 5.0);        // the tip of the cone is nearest
  TEST_EQUALITY(violation(mortar, std::array<double, 2>{-23, 0}), 3.0);
  TEST_EQUALITY(violation(smooth, std::array<double, 2>{10, -4}), 4.0);
  // Sheared: measured at constant pressure, longer than the distance to the cone by sqrt(1 + mu^2).
  TEST_FLOATING_EQUALITY(violation(dry, std::array<double, 2>{10, 8}), 2.0, 1e-15);
}

TEUCHOS_UNIT_TEST(PointLaws, HoldWhatSomePointHasAndNothingElse) {
  PointLaws laws(1000);
  TEST_EQUALITY(laws.bytes(), std::size_t{0});
  laws.set(3, smooth);
  TEST_EQUALITY(laws.bytes(), std::size_t{0});
  laws.set(7, dry);
  TEST_EQUALITY(laws.bytes(), 1000 * sizeof(double));
  laws.set(8, mortar);
  TEST_EQUALITY(laws.bytes(), 3 * 1000 * sizeof(double));
  TEST_EQUALITY(laws[7].friction, dry.friction);
  TEST_EQUALITY(laws[7].cohesion, 0.0);
  TEST_EQUALITY(laws[8].tension, mortar.tension);
  laws.lose_bond(8);
  TEST_EQUALITY(laws[8].friction, mortar.friction);
  TEST_EQUALITY(laws[8].cohesion + laws[8].tension, 0.0);
}

}  // namespace

// The law at one point: projections and bounds in all their corners, derivatives by automatic differentiation.
#include "joints/contact_law.hpp"

#include <Sacado.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
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
  TEST_EQUALITY(friction_bound(rough, 0.0), 50.0);  // infinite friction without pressure is cohesion alone
  TEST_EQUALITY(friction_bound(rough, -10.0), 50.0);
}

TEUCHOS_UNIT_TEST(ProjectNormal, CutsTensionAtTheStrengthAndKeepsTheRest) {
  TEST_EQUALITY(project_normal(dry, 7.0), 7.0);
  TEST_EQUALITY(project_normal(dry, -7.0), 0.0);
  TEST_EQUALITY(project_normal(mortar, -7.0), -7.0);
  TEST_EQUALITY(project_normal(mortar, -21.0), -20.0);
  TEST_EQUALITY(project_normal(glued, -1e300), -1e300);
}

// What a cut leaves of a shear is its bound but for the last bits of products: the status must not hang on them.
TEUCHOS_UNIT_TEST(Judge, AForceThatWasCutToItsBoundSlipsHoweverItIsRounded) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0.1, 1.0);
  for (const auto& law : {dry, mortar})
    for (int trial = 0; trial < 1000; ++trial) {
      const double pressure = 1e5 * any(random);
      const auto cut = nearest_lawful(law, std::array<double, 2>{pressure, 1e6 * any(random)});
      for (const double last_bits : {-1e-15, 0.0, 1e-15}) {
        const double bound = friction_bound(law, cut[0] * (1 + last_bits));
        TEST_ASSERT(judge(law, cut[0], cut[1], bound) == ContactStatus::slip);
        TEST_ASSERT(judge(law, cut[0], (1 - 1e-9) * cut[1], bound) == ContactStatus::stick);
      }
    }
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
  TEST_EQUALITY(violation(dry, std::array<double, 2>{-3, 0}), 3.0);  // pulled
  TEST_EQUALITY(violation(dry, std::array<double, 2>{-3, 4}), 5.0);  // the tip of the cone is nearest
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
  laws.set(8, {mortar.friction, 0, 0});
  TEST_EQUALITY(laws[8].friction, mortar.friction);
  TEST_EQUALITY(laws[8].cohesion + laws[8].tension, 0.0);
}

TEUCHOS_UNIT_TEST(Judge, TellsOpenStickAndSlipAtAllTheirEdges) {
  const auto of = [](const PointLaw& law, double normal, double shear) {
    return judge(law, normal, shear, friction_bound(law, normal));
  };
  for (const auto& law : {dry, mortar, glued, rough, smooth}) {
    TEST_ASSERT(of(law, -std::numeric_limits<double>::max(), 0) ==
                (std::isinf(law.tension) ? ContactStatus::stick : ContactStatus::open));
    TEST_ASSERT(of(law, 0, 0) != ContactStatus::open);  // stones that touch
  }
  TEST_ASSERT(of(dry, 0, 0) == ContactStatus::stick);
  TEST_ASSERT(of(smooth, 10, 0) == ContactStatus::slip);
  TEST_ASSERT(of(dry, -1e-300, 0) == ContactStatus::open);
  TEST_ASSERT(of(mortar, -20, 30) == ContactStatus::stick);
  TEST_ASSERT(of(mortar, -20.001, 30) == ContactStatus::open);
  TEST_ASSERT(of(dry, 10, 5.999) == ContactStatus::stick);
  TEST_ASSERT(of(dry, 10, 6) == ContactStatus::slip);
  TEST_ASSERT(judge(dry, 10, 7, 8) == ContactStatus::stick);  // under the pressure of another force
  TEST_ASSERT(of(dry, std::nan(""), 0) == ContactStatus::open);
}

// A sliding point in space: its force, differentiated by automatic differentiation, is what the stiffness says.
TEUCHOS_UNIT_TEST(PointStiffness, IsTheDerivativeOfAForceThatSlides) {
  std::mt19937 chance(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int k = 0; k < 100; ++k) {
    const PointLaw law{0.3 + 0.3 * number(chance), 0.5, 0};
    const double p = 2 + number(chance), normal = 7, tangential = 3;
    const std::array<double, 2> q{4 * number(chance), 5 + number(chance)};
    const std::array<Dual, 3> motion{Dual(3, 0, 0.0), Dual(3, 1, 0.0), Dual(3, 2, 0.0)};
    const Dual pressed = p - normal * motion[0];
    const std::array<Dual, 2> trial{q[0] - tangential * motion[1], q[1] - tangential * motion[2]};
    const Dual size = sqrt(trial[0] * trial[0] + trial[1] * trial[1]), bound = friction_bound(law, pressed);
    const double shear = std::hypot(q[0], q[1]), s[] = {q[0] / shear, q[1] / shear};
    PointStiffness d;
    d.normal = normal;
    d.slide(s, 2, law.friction * normal, tangential * friction_bound(law, p) / shear);
    for (int c = 0; c < 3; ++c) {
      const double step[] = {c == 0 ? 1.0 : 0.0, c == 1 ? 1.0 : 0.0, c == 2 ? 1.0 : 0.0};
      double change[] = {0, 0, 0};
      d.yield(step, 3, change);
      TEST_FLOATING_EQUALITY(change[0], pressed.fastAccessDx(c), 1e-13);
      for (int t = 0; t < 2; ++t)
        TEST_COMPARE(std::abs(change[t + 1] - Dual(bound * trial[t] / size).fastAccessDx(c)), <=, 1e-13 * normal);
    }
  }
}

// The force of a law A changes by -A times what stones move, which is the whole motion and what mortar C gives way.
TEUCHOS_UNIT_TEST(PointStiffness, GivesWayWhereSomeTangentDoes) {
  PointStiffness sticks(3, 2), slides(3, 0), turns;
  const double along[] = {0.6, 0.8};
  turns.slide(along, 2, 0, 5);
  for (const int tangents : {1, 2}) {
    TEST_ASSERT(!sticks.gives_way(tangents));
    TEST_ASSERT(slides.gives_way(tangents));
  }
  TEST_ASSERT(turns.gives_way(2));
  turns.slide(along, 2, 0, 5, 1);
  TEST_ASSERT(!turns.gives_way(2));
}

TEUCHOS_UNIT_TEST(PointStiffness, WithMortarInSeriesIsThatOfWhatStonesMove) {
  std::mt19937 chance(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const int components : {2, 3})
    for (int k = 0; k < 50; ++k) {
      const double turn = 3 * number(chance), s[] = {components == 2 ? 1.0 : std::cos(turn), std::sin(turn)};
      PointStiffness law;
      law.normal = -2 + number(chance);
      law.slide(s, components - 1, number(chance), 3 + number(chance), -1 + number(chance), number(chance));
      const PointCompliance bed{0.1, 0.2};
      const double motion[] = {number(chance), number(chance), number(chance)};
      double change[] = {0, 0, 0}, by_law[] = {0, 0, 0}, of_stones[3];
      in_series(law, bed, components).yield(motion, components, change);
      for (int c = 0; c < components; ++c) of_stones[c] = motion[c] + bed.along(c) * change[c];
      law.yield(of_stones, components, by_law);
      for (int c = 0; c < components; ++c) TEST_COMPARE(std::abs(by_law[c] - change[c]), <=, 1e-13);
    }
}

}  // namespace

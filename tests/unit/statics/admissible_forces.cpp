// The vertex and the generators of a contact point against its law, and what they can absorb of a motion.
#include "statics/admissible_forces.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <random>

namespace {

using namespace voussoir;

constexpr double endless = std::numeric_limits<double>::infinity();

bool law_admits(const PointLaw& law, const Vector<2>& f) {
  if (f[0] < -law.tension) return false;
  if (!std::isfinite(law.friction) && f[0] > 0) return true;
  return std::abs(f[1]) <= law.cohesion + (law.friction > 0 && f[0] != 0 ? law.friction * f[0] : 0);
}

/// Forces the generators reach, at random; amounts without an end end at 10 N.
Vector<2> reached(const AdmissibleForces<2>& set, std::mt19937& random) {
  auto f = set.apex;
  for (const auto& g : set.generators) {
    std::uniform_real_distribution<double> amount(std::max(g.lower, -10.0), std::min(g.upper, 10.0));
    f = f + amount(random) * g.direction;
  }
  return f;
}

/// The largest -force . motion over forces admitted by the law, by trial; forces without an end are left out.
double absorbed_by_trial(const PointLaw& law, const Vector<2>& motion) {
  double most = -endless;
  const double largest = 20;  // [N] beyond every vertex of the laws tried
  const double least = std::max(-law.tension, law.friction > 0 ? -law.cohesion / law.friction : -endless);
  for (const double n : {least, largest})
    for (const double sign : {-1.0, 1.0})
      most = std::max(most, -dot(Vector<2>{n, sign * (law.cohesion + law.friction * n)}, motion));
  return most;
}

const PointLaw finite_laws[] = {{0.6, 0, 0}, {0.6, 3, 0}, {0.6, 3, 2}, {0.5, 1, 7}, {0, 0, 0}, {0, 2, 1}, {1, 0, 4}};

TEUCHOS_UNIT_TEST(AdmissibleForces, GeneratorsReachNothingThatTheLawForbids) {
  std::mt19937 random(1);
  for (const auto& law : finite_laws) {
    PointLaw a_little_more{law.friction, law.cohesion + 1e-12, law.tension + 1e-12};
    const auto set = admissible_forces<2>(law);
    for (int k = 0; k < 1000; ++k) TEST_ASSERT(law_admits(a_little_more, reached(set, random)));
  }
}

TEUCHOS_UNIT_TEST(AdmissibleForces, WhatIsAbsorbedAtMostIsTheSupportOfTheLaw) {
  // Support functions of two convex sets agree in every direction where the sets are the same.
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(0, 6.283185307179586);
  for (const auto& law : finite_laws) {
    const auto set = admissible_forces<2>(law);
    int held = 0, pressed = 0;
    for (int k = 0; k < 1000; ++k) {
      const double a = angle(random);
      const Vector<2> motion{std::cos(a), std::sin(a)};
      const auto most = absorbed_at_most(set, motion);
      const double dilates = motion[0] - law.friction * std::abs(motion[1]);  // compatible where this is not negative
      if (dilates >= 0) {
        ++held;
        TEST_EQUALITY(most.against, 0);
        TEST_FLOATING_EQUALITY(1 + most.power, 1 + absorbed_by_trial(law, motion), 1e-12);
      } else {
        ++pressed;
        TEST_FLOATING_EQUALITY(most.against, -dilates / std::hypot(1, law.friction), 1e-12);
      }
    }
    TEST_ASSERT(held > 100 && pressed > 100);
  }
}

TEUCHOS_UNIT_TEST(AdmissibleForces, StrengthWithoutEndAbsorbsAnyMotion) {
  const Vector<2> opens{1, 0}, slips{0, 1}, presses{-1, 0};
  for (const double friction : {100.0, endless}) {
    const auto rough = admissible_forces<2>({friction, 0, 0});
    TEST_EQUALITY(absorbed_at_most(rough, slips).against, 1);
    TEST_EQUALITY(absorbed_at_most(rough, opens).against, 0);
    TEST_EQUALITY(absorbed_at_most(rough, presses).against, 1);
  }
  const auto bonded = admissible_forces<2>({0.6, endless, endless});
  for (const auto& motion : {opens, slips, presses}) TEST_EQUALITY(absorbed_at_most(bonded, motion).against, 1);
  const auto no_tension = admissible_forces<2>({0.6, endless, 0});
  TEST_EQUALITY(absorbed_at_most(no_tension, opens).against, 0);
  TEST_EQUALITY(absorbed_at_most(no_tension, slips).against, 1);
  const auto glued_and_smooth = admissible_forces<2>({0, 2, endless});
  TEST_EQUALITY(absorbed_at_most(glued_and_smooth, opens).against, 1);
  TEST_EQUALITY(absorbed_at_most(glued_and_smooth, slips).against, 0);
  TEST_EQUALITY(absorbed_at_most(glued_and_smooth, slips).power, 2);
}

TEUCHOS_UNIT_TEST(AdmissibleForces, FrictionWithoutEndHoldsEvenWhereCohesionIsFinite) {
  const auto set = admissible_forces<2>({endless, 3, 2});
  TEST_EQUALITY(absorbed_at_most(set, {0, 1}).against, 1);
  TEST_EQUALITY(absorbed_at_most(set, {1, 0}).power, 2);
}

}  // namespace

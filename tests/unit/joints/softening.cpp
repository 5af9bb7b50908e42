// Strength falls with opening and slip, and takes the energy it is given.
#include "joints/softening.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <vector>

namespace {

using namespace voussoir;

constexpr double infinite = std::numeric_limits<double>::infinity();
const PointLaw mortar{0.6, 1e5, 5e4};       // [-, N, N]
constexpr double opening = 10, shear = 50;  // [J]

Softening softening(bool exponential) { return {mortar.tension / opening, mortar.cohesion / shear, exponential}; }

TEUCHOS_UNIT_TEST(Softening, PullsAsItsFormulaSays) {
  const double end = 2 * opening / mortar.tension;  // [m] of linear softening
  for (const double share : {0.0, 0.1, 0.5, 0.99, 1.0, 1.5}) {
    const auto linear = weaken(mortar, softening(false), {}, share * end, 0);
    TEST_FLOATING_EQUALITY(linear.pull + 1, 1 + std::max(0.0, 5e4 * (1 - share)), 1e-13);
    TEST_FLOATING_EQUALITY(linear.law.cohesion + 1, 1 + std::max(0.0, 1e5 * (1 - share)), 1e-13);
    const auto exponential = weaken(mortar, softening(true), {}, share * end, 0);
    TEST_FLOATING_EQUALITY(exponential.pull, 5e4 * std::exp(-2 * share), 1e-14);
  }
  // Whole as long as it neither opens nor slips.
  TEST_EQUALITY(weaken(mortar, softening(false), {}, -1e-3, 0).pull, 5e4);
}

TEUCHOS_UNIT_TEST(Softening, PullsBackInProportionAndGoesOnWhereItLeftOff) {
  for (const bool exponential : {false, true}) {
    const auto s = softening(exponential);
    const double most = 1e-4;
    const double there = weaken(mortar, s, {}, most, 0).pull;
    for (const double share : {0.0, 0.25, 1.0}) {
      const auto back = weaken(mortar, s, {most, 0}, share * most, 0);
      TEST_FLOATING_EQUALITY(back.pull + 1, share * there + 1, 1e-14);
    }
    TEST_FLOATING_EQUALITY(weaken(mortar, s, {most, 0}, 2 * most, 0).pull, weaken(mortar, s, {}, 2 * most, 0).pull,
                           1e-14);
    TEST_EQUALITY(weaken(mortar, s, {most, 0}, -1e-6, 0).law.tension, 0);  // pressed it bears no tension
  }
}

TEUCHOS_UNIT_TEST(Softening, SlopesAreThoseOfTheFormula) {
  const double h = 1e-10;
  for (const bool exponential : {false, true})
    for (const JointWear before : {JointWear{0, 0}, JointWear{1e-4, 0}, JointWear{0, 3e-4}, JointWear{1e-4, 3e-4}})
      for (const double gap : {5e-5, 1.5e-4})
        for (const double slip : {1e-5, 2e-4}) {
          const auto s = softening(exponential);
          const auto at = [&](double g, double q) { return weaken(mortar, s, before, g, q); };
          const auto now = at(gap, slip);
          const auto close = [&](double slope, double more, double less) {
            TEST_COMPARE(std::abs(slope - (more - less) / (2 * h)), <=, 1e-5 * (std::abs(slope) + 1e6));
          };
          close(now.pull_per_opening, at(gap + h, slip).pull, at(gap - h, slip).pull);
          close(now.pull_per_slip, at(gap, slip + h).pull, at(gap, slip - h).pull);
          close(now.cohesion_per_gap, at(gap + h, slip).law.cohesion, at(gap - h, slip).law.cohesion);
          close(now.cohesion_per_slip, at(gap, slip + h).law.cohesion, at(gap, slip - h).law.cohesion);
        }
}

TEUCHOS_UNIT_TEST(Softening, InfiniteStrengthStaysUntilAllIsLost) {
  const PointLaw glued{0.6, 1e5, infinite};
  const Softening s{0, glued.cohesion / shear, false};
  const double end = 2 * shear / glued.cohesion;
  TEST_EQUALITY(weaken(glued, s, {}, 0, 0.5 * end).pull, infinite);
  TEST_EQUALITY(weaken(glued, s, {}, 0, 0.5 * end).pull_per_opening, 0);
  TEST_EQUALITY(weaken(glued, s, {}, 0, 1.01 * end).pull, 0);
}

TEUCHOS_UNIT_TEST(Softening, StiffnessThatFallsIsNoSpring) {
  PointStiffness slides;
  const double along[] = {0.6, 0.8};
  slides.slide(along, 2, 5.0, 3.0, -2.0);
  TEST_ASSERT(slides.softens() && slides.couples() && !slides.springs().softens());
  // -2 along s, 3 across it.
  const auto force = [&](double x, double y) {
    double f[] = {0, 0, 0};
    const double motion[] = {0, x, y};
    slides.yield(motion, 3, f);
    return std::array<double, 2>{f[1], f[2]};
  };
  TEST_FLOATING_EQUALITY(force(0.6, 0.8)[0], 2 * 0.6, 1e-14);
  TEST_FLOATING_EQUALITY(force(-0.8, 0.6)[1], -3 * 0.6, 1e-14);
  PointStiffness across;
  across.slide(along, 2, 5.0, 3.0);
  TEST_ASSERT(!across.softens() && across.springs().tangential == across.tangential);
  PointStiffness opens(-4.0, 7.0);
  TEST_ASSERT(opens.softens() && opens.springs().normal == 0 && opens.springs().along(0, 0) == 7.0);
  // What damps a point that softens does so beside it, however little that is.
  opens.hold(0.5, 9.0);
  TEST_EQUALITY(opens.normal, -3.5);
  TEST_EQUALITY(opens.along(0, 0), 9.0);
}

}  // namespace

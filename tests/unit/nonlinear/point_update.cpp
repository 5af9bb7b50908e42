// Loops of the contact law over points: trial forces, projection, and the derivative of one after the other.
#include "nonlinear/point_update.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>

#include "unit/linalg/systems.hpp"
#include "unit/nonlinear/points_alone.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr int many = 200;  // by chance: open, sticking and slipping points are all among them

/// Points with laws of every kind.
Points points_by_chance(int components) {
  Points p(components, many);
  for (int k = 0; k < many; ++k) p.law_.set(k, {1.5 + noise(k), k % 3 == 0 ? 0.2 : 0.0, k % 5 == 0 ? 0.3 : 0.0});
  for (int i = 0; i < components * many; ++i) p.origin_[i] = i % components == 0 ? 0.0 : 0.1 * noise(5000 + i);
  return p;
}

PointField field_by_chance(const Points& p, int seed) {
  PointField f(std::size_t(p.components()) * p.points());
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = noise(seed + static_cast<int>(i));
  return f;
}

double tangential(const PointField& f, int k, int components) {
  double sum = 0;
  for (int c = 1; c < components; ++c) sum += f[k * components + c] * f[k * components + c];
  return std::sqrt(sum);
}

struct Projected {
  PointField trial, forces;
  std::vector<double> bound;
  Projected(const Points& p, const PointField& lambda, const PointField& gap, double augmentation) {
    trial_forces(p, lambda, gap, augmentation, trial);
    const CurrentLaws laws(p);
    friction_bounds(p, laws, lambda, bound);
    project(p, laws, trial, bound, forces);
  }
};

TEUCHOS_UNIT_TEST(TrialForces, FallWithTheGapAndWithTheSlipSinceTheStepBegan) {
  Points p(2, 1);
  p.origin_ = {0.0, 0.125};
  PointField trial;
  trial_forces(p, {3.0, 1.0}, {0.5, 0.25}, 2.0, trial);
  // Binary fractions: exact.
  TEST_EQUALITY_CONST(trial[0], 3.0 - 2.0 * 0.5);
  TEST_EQUALITY_CONST(trial[1], 1.0 - 2.0 * 0.125);
}

TEUCHOS_UNIT_TEST(Projection, IsAdmissible) {
  for (const int n : {2, 3}) {
    const auto p = points_by_chance(n);
    const Projected at(p, field_by_chance(p, 1), field_by_chance(p, 1001), 1.0);
    int open = 0, slipping = 0, sticking = 0;
    for (int k = 0; k < many; ++k) {
      TEST_COMPARE(at.forces[n * k], >=, -p.law_[k].tension);
      const double q = tangential(at.forces, k, n);
      TEST_COMPARE(q, <=, at.bound[k] * (1 + 1e-15));  // scaled to the bound: one rounding
      open += at.forces[n * k] == -p.law_[k].tension;
      (q < at.bound[k] * (1 - 1e-12) ? sticking : slipping) += 1;
    }
    TEST_COMPARE(std::min({open, slipping, sticking}), >, 10);  // all kinds were seen
  }
}

TEUCHOS_UNIT_TEST(Projection, LeavesAdmissibleForcesAloneAndIsItsOwnSquare) {
  for (const int n : {2, 3}) {
    const auto p = points_by_chance(n);
    const Projected at(p, field_by_chance(p, 1), field_by_chance(p, 1001), 1.0);
    PointField again;
    project(p, CurrentLaws(p), at.forces, at.bound, again);
    for (std::size_t i = 0; i < again.size(); ++i)
      TEST_COMPARE(std::abs(again[i] - at.forces[i]), <=, 1e-15);  // forces of size 1, one rounding
  }
}

TEUCHOS_UNIT_TEST(Projection, IsNearerThanAnyOtherAdmissibleForce) {
  for (const int n : {2, 3}) {
    const auto p = points_by_chance(n);
    const Projected at(p, field_by_chance(p, 1), field_by_chance(p, 1001), 1.0);
    for (int other = 0; other < 20; ++other) {
      PointField candidate;
      project(p, CurrentLaws(p), field_by_chance(p, 9000 + 1000 * other), at.bound, candidate);
      // The set is convex: seen from the projection, no admissible force lies on the side of the trial force.
      for (int k = 0; k < many; ++k) {
        double angle = 0;
        for (int c = 0; c < n; ++c) {
          const int i = n * k + c;
          angle += (at.trial[i] - at.forces[i]) * (candidate[i] - at.forces[i]);
        }
        TEST_COMPARE(angle, <=, 1e-14);  // products of size 1
      }
    }
  }
}

TEUCHOS_UNIT_TEST(Projection, FrictionPointsAgainstTheSlip) {
  const auto p = points_by_chance(3);
  const auto gap = field_by_chance(p, 1001);
  const Projected at(p, PointField(3 * many, 0.0), gap, 1.0);
  for (int k = 0; k < many; ++k) {
    double power = 0;
    for (int c = 1; c < 3; ++c) power += at.forces[3 * k + c] * (gap[3 * k + c] - p.origin_[3 * k + c]);
    TEST_COMPARE(power, <=, 0.0);
  }
}

TEUCHOS_UNIT_TEST(Resistances, AreTheSlopesOfTheProjectedForces) {
  const auto p = points_by_chance(2);
  const auto lambda = field_by_chance(p, 1);
  auto gap = field_by_chance(p, 1001);
  constexpr double augmentation = 3.0, h = 1e-7;
  const Projected at(p, lambda, gap, augmentation);
  std::vector<PointStiffness> slope;
  resistances(p, CurrentLaws(p), at.trial, at.bound, augmentation, slope);
  for (double& g : gap) g += h;
  PointField moved, after;
  trial_forces(p, lambda, gap, augmentation, moved);
  project(p, CurrentLaws(p), moved, at.bound, after);
  for (int k = 0; k < many; ++k) {
    // A kink of the law within h would spoil the quotient; among 200 points by chance none is that near.
    TEST_COMPARE(std::abs(at.trial[2 * k] + p.law_[k].tension), >, 10 * h);
    TEST_COMPARE(std::abs(std::abs(at.trial[2 * k + 1]) - at.bound[k]), >, 10 * h);
    // Forces of size 1 lose nine digits of sixteen in a quotient over 1e-7.
    TEST_COMPARE(std::abs((at.forces[2 * k] - after[2 * k]) / h - slope[k].normal), <=, 1e-7);
    TEST_COMPARE(std::abs((at.forces[2 * k + 1] - after[2 * k + 1]) / h - slope[k].along(0, 0)), <=, 1e-7);
  }
}

TEUCHOS_UNIT_TEST(PointUpdate, PassesOverPointsThatAreNotSelected) {
  auto p = points_by_chance(2);
  p.selected_[4] = 0;
  const auto lambda = field_by_chance(p, 1);
  PointField trial(lambda.size(), 77.0), forces = trial;
  std::vector<double> bound(many, 77.0);
  std::vector<PointStiffness> slope;
  trial_forces(p, lambda, field_by_chance(p, 1001), 1.0, trial);
  friction_bounds(p, CurrentLaws(p), lambda, bound);
  project(p, CurrentLaws(p), trial, bound, forces);
  resistances(p, CurrentLaws(p), trial, bound, 1.0, slope);
  for (const double untouched : {trial[8], trial[9], forces[8], forces[9], bound[4]})
    TEST_EQUALITY_CONST(untouched, 77.0);
  TEST_EQUALITY_CONST(slope[4].normal, 0.0);
  TEST_EQUALITY_CONST(slope[4].along(0, 0), 0.0);
}

}  // namespace

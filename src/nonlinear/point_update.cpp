#include "nonlinear/point_update.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.hpp"

namespace voussoir {

double tangential_size(const PointField& f, int point, int components) {
  double sum = 0;
  for (int c = 1; c < components; ++c) sum += f[point * components + c] * f[point * components + c];
  return std::sqrt(sum);
}

void trial_forces(const NonlinearProblem& problem, const PointField& lambda, const PointField& gap, double augmentation,
                  PointField& trial) {
  const int n = problem.components();
  trial.resize(lambda.size());
  for (int k = 0; k < problem.points(); ++k) {
    if (!problem.selected()[k]) continue;
    for (int c = 0; c < n; ++c) {
      const double motion = motion_of(problem, k, c, gap, lambda);
      trial[k * n + c] = lambda[k * n + c] - stiffness_of(problem, k, c, augmentation) * motion;
    }
  }
}

void CurrentLaws::update(const PointField& lambda, const PointField& gap) {
  const auto* const softening = problem_.softening();
  if (!softening) return;
  VOUSSOIR_EXPECT(strength_.damage && strength_.damage->size() == softening->size() && "damage: per point");
  const int n = problem_.components();
  number_.assign(problem_.points(), -1);
  weakened_.clear();
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k] || !softening->softens(k)) continue;
    double slip = 0;
    for (int c = 1; c < n; ++c) {
      const double s = motion_of(problem_, k, c, gap, lambda);
      slip += s * s;
    }
    number_[k] = static_cast<int>(weakened_.size());
    weakened_.push_back(law_at((*softening)[k], (*strength_.damage)[k], strength_.is,
                               motion_of(problem_, k, 0, gap, lambda), std::sqrt(slip)));
  }
}

void split_forces(const NonlinearProblem& problem, const CurrentLaws& laws, const PointStatuses& are,
                  PointField& lambda) {
  if (!problem.shares_forces()) return;
  const int tangents = problem.components() - 1;
  std::vector<PointFreedom> freedom(problem.points());
  for (int k = 0; k < problem.points(); ++k) {
    if (!problem.selected()[k]) continue;
    const double* const along = &are.sliding[std::size_t(k) * tangents];
    auto& f = freedom[k];
    f.law = laws[k];
    f.normal = are.closed[k];
    f.tangential =
        std::all_of(along, along + tangents, [](double d) { return d == 0; }) && are.resistance[k].resists_slip();
    for (int t = 0; t < tangents && f.normal && std::isfinite(f.law.friction); ++t)
      f.slope[t] = f.law.friction * along[t];
  }
  problem.split_shared_forces(freedom, SharedFriction::follows, lambda);
}

void split_forces(const NonlinearProblem& problem, const CurrentLaws& laws, const PointField& gap, double left,
                  PointField& lambda) {
  if (!problem.shares_forces()) return;
  const int tangents = problem.components() - 1;
  std::vector<PointFreedom> freedom(problem.points());
  for (int k = 0; k < problem.points(); ++k) {
    if (!problem.selected()[k]) continue;
    auto& f = freedom[k];
    f.law = laws[k];
    const auto pushed = [&](int c) { return stiffness_of(problem, k, c, 1.0) * motion_of(problem, k, c, gap, lambda); };
    f.normal = pushed(0) <= left;
    std::array<double, 2> shear{};
    for (int t = 0; t < tangents; ++t) shear[t] = pushed(t + 1);
    const double size = std::hypot(shear[0], shear[1]);
    f.tangential = size <= left;
    for (int t = 0; t < tangents && size > 0 && f.normal && std::isfinite(f.law.friction); ++t)
      f.slope[t] = -f.law.friction * shear[t] / size;
  }
  problem.split_shared_forces(freedom, SharedFriction::held_where_it_hides, lambda);
}

WornPoints wear(const NonlinearProblem& problem, Strength strength, const PointField& lambda, const PointField& gap) {
  const auto* const softening = problem.softening();
  VOUSSOIR_EXPECT(softening && strength.damage && strength.damage->size() == softening->size() && "damage: per point");
  const int n = problem.components();
  WornPoints all{*strength.damage};
  for (int k = 0; k < problem.points(); ++k) {
    if (!problem.selected()[k]) continue;
    double slip = 0, shear = 0;
    for (int c = 1; c < n; ++c) {
      const double s = motion_of(problem, k, c, gap, lambda);
      const double trial = lambda[k * n + c] - stiffness_of(problem, k, c, 1.0) * s;
      slip += s * s;
      shear += trial * trial;
    }
    const auto worn = wear((*softening)[k], all.damage[k], strength.is,
                           {motion_of(problem, k, 0, gap, lambda), std::sqrt(slip), lambda[k * n], std::sqrt(shear),
                            stiffness_of(problem, k, 0, 1.0)});
    all.damage[k] = worn.damage;
    all.by_far |= worn.by_far;
  }
  return all;
}

void friction_bounds(const NonlinearProblem& problem, const CurrentLaws& laws, const PointField& forces,
                     std::vector<double>& bound) {
  bound.resize(problem.points());
  for (int k = 0; k < problem.points(); ++k)
    if (problem.selected()[k]) {
      const auto law = laws[k];
      bound[k] = friction_bound(law, project_normal(law, forces[k * problem.components()]));
    }
}

void project(const NonlinearProblem& problem, const CurrentLaws& laws, const PointField& trial,
             const std::vector<double>& bound, PointField& forces) {
  const int n = problem.components();
  forces.resize(trial.size());
  for (int k = 0; k < problem.points(); ++k) {
    if (!problem.selected()[k]) continue;
    forces[k * n] = project_normal(laws[k], trial[k * n]);
    const double size = tangential_size(trial, k, n);
    const double factor = size > bound[k] ? bound[k] / size : 1.0;
    for (int c = 1; c < n; ++c) forces[k * n + c] = factor * trial[k * n + c];
  }
}

void resistances(const NonlinearProblem& problem, const CurrentLaws& laws, const PointField& trial,
                 const std::vector<double>& bound, double augmentation, std::vector<PointStiffness>& resistance) {
  const int n = problem.components();
  resistance.assign(problem.points(), {});
  for (int k = 0; k < problem.points(); ++k) {
    if (!problem.selected()[k]) continue;
    const double shear = tangential_size(trial, k, n);
    if (judge(laws[k], trial[k * n], shear, bound[k]) != ContactStatus::open)
      resistance[k].normal = stiffness_of(problem, k, 0, augmentation);
    // A bound that is held stays where the pressure goes.
    if (below_bound(shear, bound[k])) resistance[k].hold(0, stiffness_of(problem, k, 1, augmentation));
  }
}

}  // namespace voussoir

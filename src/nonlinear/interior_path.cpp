#include "nonlinear/interior_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/check.hpp"
#include "linalg/reduce.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/saved_position.hpp"

namespace voussoir {

InteriorPath::InteriorPath(NonlinearProblem& problem, const MethodParameters& methods)
    : problem_(problem), numbers_(methods.path), run_away_(methods.pseudo_time.run_away), laws_(problem) {
  VOUSSOIR_EXPECT(problem.components() == 2);
  for (auto* v : {&linear_, &gradient_, &direction_, &work_}) *v = Teuchos::rcp(new TpetraVector(problem.map()));
}

double InteriorPath::bound(int point, double normal) const {
  auto law = laws_[point];
  law.friction = std::min(law.friction, numbers_.locking_friction);
  return friction_bound(law, normal);
}

/// Starts the path at a distance [N] from the bounds, around some forces and gaps.
void InteriorPath::enter(const PointField& lambda, const PointField& gap, double shift) {
  path_.assign(problem_.points(), {});
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const auto law = laws_[k];
    auto& p = path_[k];
    p.opens = std::isfinite(law.tension);
    p.slips = std::isfinite(law.cohesion);
    const double distance = shift / problem_.local_stiffness()[k];
    const double slip = motion_of(problem_, k, 1, gap, lambda);
    const double limit = bound(k, lambda[2 * k]), q = std::clamp(lambda[2 * k + 1], -limit, limit);
    const double shifted = p.opens ? bound(k, std::max(lambda[2 * k], -law.tension) + shift) : limit;
    p.w = {std::max(lambda[2 * k] + laws_.pull(k), 0.0) + shift, std::max(shifted - q, numbers_.start * shift),
           std::max(shifted + q, numbers_.start * shift)};
    p.y = {std::max(motion_of(problem_, k, 0, gap, lambda), 0.0) + distance, std::max(-slip, 0.0) + distance,
           std::max(slip, 0.0) + distance};
  }
}

/// Change of the friction bound with the pressure [-].
double InteriorPath::friction(int point, double normal) const {
  const double limit = bound(point, normal);
  return limit > 0 && std::isfinite(limit) ? std::min(laws_[point].friction, numbers_.locking_friction) : 0.0;
}

/// Stiffness of each point on the path [N/m]. Where only a prediction is made, friction stays as it is.
void InteriorPath::resistances(const PointField& lambda, bool predicting) {
  resistance_.assign(problem_.points(), {});
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    auto& p = path_[k];
    const double floor[] = {1 / stiffness_of(problem_, k, 0, augmentation_),
                            1 / stiffness_of(problem_, k, 1, augmentation_)};
    p.normal = 1 / ((p.opens ? p.y[0] / p.w[0] : 0) + floor[0]);
    const auto* const weakened = laws_.softened(k);
    p.pulls_back = weakened && p.opens ? std::max(0.0, weakened->pull_per_opening) : 0.0;
    const double normal = p.normal * p.share_of_opening();
    const double tangential = 1 / ((p.slips ? p.y[1] / p.w[1] + p.y[2] / p.w[2] : 0) + floor[1]);
    if (!predicting && p.slips) {
      p.friction = follows_ * friction(k, lambda[2 * k]);
      p.drag = p.friction * (p.y[2] / p.w[2] - p.y[1] / p.w[1]);
    }
    resistance_[k] = {normal, tangential, -tangential * p.drag * normal};
  }
}

/// Moves supports and loads with the resistances that the path gives the points of the old state.
void InteriorPath::predict(TpetraVector& x, PointField& lambda, const PointField& known_gap, NewtonReport& report) {
  laws_.follow(lambda, known_gap);
  enter(lambda, known_gap, numbers_.start * scale_);
  resistances(lambda, true);
  problem_.evaluate(x, *gradient_, gap_);
  force_ = lambda;
  const auto yield = [&](const PointField& gap, const PointField* from) {
    for (int k = 0; k < problem_.points(); ++k) {
      if (!problem_.selected()[k]) continue;
      force_[2 * k] -= resistance_[k].normal * (gap[2 * k] - (from ? (*from)[2 * k] : 0));
      force_[2 * k + 1] -= resistance_[k].along(0, 0) * (gap[2 * k + 1] - (from ? (*from)[2 * k + 1] : 0));
    }
  };
  yield(gap_, &known_gap);
  problem_.subtract_contact_forces(force_, *gradient_);
  solve(report);
  x.update(1.0, *direction_, 1.0);
  problem_.evaluate_direction(*direction_, *work_, gap_direction_);
  yield(gap_direction_, nullptr);
  lambda = force_;
}

/// direction = -(K + resistance + proximal)^-1 gradient, 0 where a library refused the system.
LinearSolveResult InteriorPath::solve(NewtonReport& report) {
  gradient_->scale(-1.0);
  direction_->putScalar(0);
  auto solved = problem_.solve(resistance_, numbers_.proximal, gradient_, direction_, {numbers_.solve_accuracy});
  report.count(solved);
  return solved;
}

/// Points that pull back do so as far as they are open. What a point keeps from its bound stays, so its force follows.
void InteriorPath::pull_back(const TpetraVector& x, PointField& lambda) {
  if (!problem_.softening()) return;
  problem_.evaluate(x, *linear_, gap_);
  laws_.follow(lambda, gap_);
  for (int k = 0; k < problem_.points(); ++k)
    if (laws_.softened(k) && path_[k].opens) lambda[2 * k] = path_[k].w[0] - laws_.pull(k);
}

/// Residuals of x with the forces of the path, relative to the scale; leaves K x - f in linear_ and the gaps.
Imbalance InteriorPath::measure(const TpetraVector& x, const PointField& lambda) {
  problem_.evaluate(x, *linear_, gap_);
  return residuals(lambda);
}

/// Residuals of forces at the place measured last, relative to the scale.
Imbalance InteriorPath::residuals(const PointField& lambda) {
  Tpetra::deep_copy(*gradient_, *linear_);
  const auto [equilibrium, contact] = imbalance(problem_, laws_, lambda, gap_, *gradient_);
  return {equilibrium / scale_, contact / scale_};
}

/// Residual of the state measured last once its forces have left the path, relative to the scale: what many open points
/// give up together can be more than a rough tolerance.
double InteriorPath::after_leaving(PointField lambda) {
  leave(lambda);
  const auto [equilibrium, contact] = residuals(lambda);
  return size_of(problem_, equilibrium * scale_, contact * scale_, scale_);
}

/// False when it leads nowhere.
bool InteriorPath::take_shortcut(TpetraVector& x, PointField& lambda) {
  PointField forces = lambda;
  leave(forces);
  if (shortcut(x, forces)) {
    lambda = forces;
    return true;
  }
  measure(x, lambda);
  return false;
}

/// Mean of w y over all bounds, as a force squared [N2]: scaled by the local stiffness of its point.
double InteriorPath::barrier() const {
  std::array<double, 2> mine{};
  for (int k = 0; k < problem_.owned_points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const auto& p = path_[k];
    for (int j = 0; j < 3; ++j) {
      if (!(j == 0 ? p.opens : p.slips)) continue;
      mine[0] += p.w[j] * p.y[j] * problem_.local_stiffness()[k];
      mine[1] += 1;
    }
  }
  const auto all = total_of_each(*problem_.map()->getComm(), mine);
  return all[1] > 0 ? all[0] / all[1] : 0;
}

/// Right-hand sides of all points for a barrier [N2]; force_ = lambda + what the points would add at rest.
void InteriorPath::aim(const PointField& lambda, double target) {
  force_ = lambda;
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    auto& p = path_[k];
    const double nu = target / problem_.local_stiffness()[k];
    const double limit = bound(k, lambda[2 * k]), q = lambda[2 * k + 1];
    p.residual = {0, limit - q - p.w[1], limit + q - p.w[2]};
    p.gain[0] = (p.opens ? nu / p.w[0] : 0) - motion_of(problem_, k, 0, gap_, lambda);
    p.gain[1] = -motion_of(problem_, k, 1, gap_, lambda);
    if (p.slips) p.gain[1] += (nu - p.y[2] * p.residual[2]) / p.w[2] - (nu - p.y[1] * p.residual[1]) / p.w[1];
    const double more = p.normal * p.gain[0];
    force_[2 * k] += more;
    force_[2 * k + 1] += resistance_[k].along(0, 0) * (p.gain[1] - p.drag * more);
    for (int j = 0; j < 3; ++j) p.dy[j] = nu / p.w[j] - p.y[j];
  }
}

/// Directions of all slacks from that of the gaps; the step after which the first slack would vanish, at most
/// so far that a full step keeps its distance from it.
double InteriorPath::step_length() {
  double mine = 1 / numbers_.to_boundary;
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    auto& p = path_[k];
    const double dp = p.normal * (p.gain[0] - p.share_of_opening() * gap_direction_[2 * k]);
    const double dq = resistance_[k].along(0, 0) * (p.gain[1] - p.drag * dp - gap_direction_[2 * k + 1]);
    const double more = p.friction * dp;
    force_[2 * k] = dp;
    force_[2 * k + 1] = dq;
    p.dw = {dp + p.pulls_back * gap_direction_[2 * k], p.residual[1] + more - dq, p.residual[2] + more + dq};
    for (int j = 0; j < 3; ++j) {
      if (!(j == 0 ? p.opens : p.slips)) continue;
      p.dy[j] -= p.y[j] / p.w[j] * p.dw[j];
      if (p.dw[j] < 0) mine = std::min(mine, -p.w[j] / p.dw[j]);
      if (p.dy[j] < 0) mine = std::min(mine, -p.y[j] / p.dy[j]);
    }
  }
  return least_over_ranks(*problem_.map()->getComm(), mine);
}

/// From the interior to admissible forces: open points lose theirs, slipping ones stay within their bound.
void InteriorPath::leave(PointField& lambda) const {
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const auto law = laws_[k];
    const double trial = lambda[2 * k] - stiffness_of(problem_, k, 0, 1.0) * motion_of(problem_, k, 0, gap_, lambda);
    const bool closed = judge(law, trial, 0, 0) != ContactStatus::open;
    lambda[2 * k] = closed ? std::max(lambda[2 * k], -law.tension) : -law.tension;
    const double limit = friction_bound(law, lambda[2 * k]);
    lambda[2 * k + 1] = std::clamp(lambda[2 * k + 1], -limit, limit);
  }
}

/// Enters the path and takes the forces along.
void InteriorPath::set_out(PointField& lambda, double shift) {
  enter(lambda, gap_, shift);
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const double limit = bound(k, lambda[2 * k]);
    lambda[2 * k + 1] = std::clamp(lambda[2 * k + 1], -limit, limit);
    if (path_[k].opens) lambda[2 * k] = path_[k].w[0] - laws_.pull(k);
  }
}

/// Whether steps lead no further: they gain too little while equilibrium is near, or are next to none.
bool InteriorPath::stuck(const Progress& progress, double equilibrium, double contact) const {
  if (progress.halts >= numbers_.patience) return true;
  const int steps = static_cast<int>(progress.sizes.size());
  return steps > progress.changed + numbers_.patience && equilibrium < numbers_.balanced * contact &&
         std::max(equilibrium, contact) > numbers_.gained * progress.sizes[steps - numbers_.patience];
}

/// One step. The bound on what a point resists with rises as the barrier falls: far from a solution a large one lets
/// forces grow where stones share a vertex, near it a small one lets them creep. It goes towards a barrier that falls
/// by as much as the last step was long, but not below what the contact residual allows. Where the path folds, which
/// shows in short steps although equilibrium is near, friction follows the pressure by a half, and where it folds
/// again, not at all.
/// @param equilibrium, contact  relative to the scale
LinearSolveResult InteriorPath::step(TpetraVector& x, PointField& lambda, double equilibrium, double contact,
                                     Progress& progress, NewtonReport& report) {
  const double distance = barrier();
  augmentation_ = std::clamp(numbers_.resistance * numbers_.start * scale_ / std::sqrt(distance), numbers_.resistance,
                             numbers_.largest_resistance);
  resistances(lambda, false);
  const double share = std::clamp(std::pow(1 - progress.step, 2), numbers_.least_share, numbers_.largest_share);
  aim(lambda, std::max(share * distance, numbers_.waiting * std::pow(contact * scale_, 2)));
  Tpetra::deep_copy(*gradient_, *linear_);
  problem_.subtract_contact_forces(force_, *gradient_);
  const auto solved = solve(report);
  if (solved.nothing) return solved;
  problem_.evaluate_direction(*direction_, *work_, gap_direction_);
  const double boundary = step_length();
  progress.step = std::min(boundary, 1.0);
  if (numbers_.folds && progress.step < numbers_.folded && equilibrium < numbers_.balanced * contact && follows_ > 0) {
    follows_ = follows_ == 1 ? 0.5 : 0;
    progress.changed = static_cast<int>(progress.sizes.size()) - 1;
  }
  progress.halts = progress.step < numbers_.halting ? progress.halts + 1 : 0;
  const double length = numbers_.to_boundary * boundary;
  x.update(length, *direction_, 1.0);
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    auto& p = path_[k];
    for (int c = 0; c < 2; ++c) lambda[2 * k + c] += length * force_[2 * k + c];
    for (int j = 0; j < 3; ++j) {
      p.w[j] += length * p.dw[j];
      p.y[j] += length * p.dy[j];
    }
  }
  tell(report, equilibrium, contact, solved.iterations, length);
  return solved;
}

PathEnd InteriorPath::follow(TpetraVector& x, PointField& lambda, double tolerance, int largest_iterations,
                             const PointField* known_gap, NewtonReport& report) {
  const SavedPosition before(problem_, x);
  const PointField lambda_before = lambda;
  scale_ = force_scale(problem_, lambda);
  augmentation_ = numbers_.resistance;
  if (known_gap) predict(x, lambda, *known_gap, report);
  problem_.evaluate(x, *linear_, gap_);
  if (!known_gap) laws_.follow(lambda, gap_);
  set_out(lambda, numbers_.start * std::max(scale_, force_scale(problem_, lambda)));
  follows_ = 1;
  double offered = numbers_.near;
  Progress progress;
  for (;;) {
    problem_.carry(x, tolerance * scale_);
    pull_back(x, lambda);
    const auto [equilibrium, contact] = measure(x, lambda);
    const double size = size_of(problem_, equilibrium * scale_, contact * scale_, scale_);
    if (size <= tolerance && after_leaving(lambda) <= tolerance) {
      leave(lambda);
      return PathEnd::arrived;
    }
    if (stuck(progress, equilibrium, contact) || static_cast<int>(progress.sizes.size()) >= largest_iterations) break;
    if (shortcut && size <= offered) {
      offered = numbers_.nearer * size;
      if (take_shortcut(x, lambda)) return PathEnd::arrived;
      if (report.stopped) return PathEnd::stopped;
    }
    progress.sizes.push_back(size);
    if (before.distance(x) > run_away_ * problem_.length_scale()) {
      before.restore(x);
      lambda = lambda_before;
      return PathEnd::ran_away;
    }
    if (step(x, lambda, equilibrium, contact, progress, report).nothing) break;
    if (report.stopped) return PathEnd::stopped;
  }
  leave(lambda);
  return PathEnd::stuck;
}

void InteriorPath::tell(NewtonReport& report, double equilibrium, double contact, int krylov, double step) const {
  std::array<long long, 2> mine{};
  for (int k = 0; k < problem_.owned_points(); ++k) {
    const auto& p = path_[k];
    const double stiffness = problem_.local_stiffness()[k];
    if (!problem_.selected()[k] || p.w[0] < stiffness * p.y[0]) continue;
    ++mine[0];
    mine[1] += p.w[1] < stiffness * p.y[1] || p.w[2] < stiffness * p.y[2];
  }
  const auto all = total_of_each(*problem_.map()->getComm(), mine);  // all ranks, listening or not
  report.tell(watch, {report.newton_iterations, equilibrium * scale_, contact * scale_, all[0], all[1], krylov, step,
                      augmentation_});
}

}  // namespace voussoir

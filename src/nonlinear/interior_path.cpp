#include "nonlinear/interior_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "linalg/reduce.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/saved_position.hpp"

namespace voussoir {

InteriorPath::InteriorPath(NonlinearProblem& problem, const MethodParameters& methods, Strength strength)
    : problem_(problem),
      numbers_(methods.path),
      run_away_(methods.pseudo_time.run_away),
      components_(problem.components()),
      laws_(problem, strength) {
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
    const double distance = shift / problem_.local_stiffness()[k], normal = lambda[first_of(k)];
    const double limit = bound(k, normal);
    const double shifted = p.opens ? bound(k, std::max(normal, -law.tension) + shift) : limit;
    std::array<double, 2> q{lambda[first_of(k) + 1], lambda[first_of(k + 1) - 1]};
    hold_within(limit, q.data(), components_ - 1);
    p.w = std::max(normal + laws_.pull(k), 0.0) + shift;
    p.y = std::max(motion_of(problem_, k, 0, gap, lambda), 0.0) + distance;
    p.disc.enter(components_ - 1, q.data(), slip(k, gap, lambda).data(), {shifted, numbers_.start * shift, distance});
  }
}

/// Slip of a point per tangent [m].
std::array<double, 2> InteriorPath::slip(int point, const PointField& gap, const PointField& lambda) const {
  std::array<double, 2> s{};
  for (int t = 0; t + 1 < components_; ++t) s[t] = motion_of(problem_, point, t + 1, gap, lambda);
  return s;
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
    p.normal = 1 / ((p.opens ? p.y / p.w : 0) + floor[0]);
    const auto* const weakened = laws_.softened(k);
    p.pulls_back = weakened && p.opens ? std::max(0.0, weakened->pull_per_opening) : 0.0;
    const double normal = p.normal * p.share_of_opening();
    p.disc.scale(floor[1]);
    p.friction = predicting || !p.slips ? 0 : follows_ * friction(k, lambda[first_of(k)]);
    p.drag = p.disc.drag(p.friction);
    auto& r = resistance_[k];
    r.normal = normal;
    r.tangential = p.disc.resistance();
    const auto drawn = p.disc.friction(p.drag);
    for (int t = 0; t < 2; ++t) r.coupling[t] = -drawn[t] * normal;
  }
}

/// Moves supports and loads with the resistances that the path gives the points of the old state.
void InteriorPath::predict(TpetraVector& x, PointField& lambda, const PointField& known_gap, NewtonReport& report) {
  laws_.update(lambda, known_gap);
  enter(lambda, known_gap, numbers_.start * scale_);
  resistances(lambda, true);
  problem_.evaluate(x, *gradient_, gap_);
  force_ = lambda;
  const auto yield = [&](const PointField& motion) {
    for (int k = 0; k < problem_.points(); ++k)
      if (problem_.selected()[k]) resistance_[k].yield(&motion[first_of(k)], components_, &force_[first_of(k)]);
  };
  auto moved = gap_;
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] -= known_gap[i];
  yield(moved);
  problem_.subtract_contact_forces(force_, *gradient_);
  solve(report);
  x.update(1.0, *direction_, 1.0);
  problem_.evaluate_direction(*direction_, *work_, gap_direction_);
  yield(gap_direction_);
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
  laws_.update(lambda, gap_);
  for (int k = 0; k < problem_.points(); ++k)
    if (laws_.softened(k) && path_[k].opens) lambda[first_of(k)] = path_[k].w - laws_.pull(k);
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
double InteriorPath::after_projection(PointField lambda) {
  project_to_admissible(lambda);
  const auto [equilibrium, contact] = residuals(lambda);
  return size_of(problem_, equilibrium * scale_, contact * scale_, scale_);
}

/// False when it leads nowhere.
bool InteriorPath::take_shortcut(TpetraVector& x, PointField& lambda) {
  PointField forces = lambda;
  project_to_admissible(forces);
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
    if (p.opens) mine[0] += p.w * p.y * problem_.local_stiffness()[k];
    for (double product : p.disc.products()) mine[0] += product * problem_.local_stiffness()[k];
    mine[1] += (p.opens ? 1 : 0) + (p.slips ? 2 : 0);
  }
  const auto all = total_of_each(*problem_.map()->getComm(), mine);
  return all[1] > 0 ? all[0] / all[1] : 0;
}

/// Right-hand sides of all points for a barrier [N2]; force_ = lambda + what the points would add at rest.
void InteriorPath::set_right_hand_side(const PointField& lambda, double target) {
  force_ = lambda;
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    auto& p = path_[k];
    const double nu = target / problem_.local_stiffness()[k];
    const auto at = first_of(k);
    const auto moved = slip(k, gap_, lambda);
    p.gain = (p.opens ? nu / p.w : 0) - motion_of(problem_, k, 0, gap_, lambda);
    p.wanted = p.disc.right_hand_side(&lambda[at + 1], moved.data(), bound(k, lambda[at]), nu);
    const double more = p.normal * p.gain;
    force_[at] += more;
    const auto q = p.disc.friction(p.wanted - more * p.drag);
    for (int t = 0; t + 1 < components_; ++t) force_[at + t + 1] += q[t];
    p.dy = nu / p.w - p.y;
  }
}

/// Directions of all slacks from that of the gaps; the step after which the first slack would vanish, at most
/// so far that a full step keeps its distance from it.
double InteriorPath::step_length() {
  double mine = 1 / numbers_.to_boundary;
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    auto& p = path_[k];
    const auto at = first_of(k);
    const auto* const motion = &gap_direction_[at];
    const double dp = p.normal * (p.gain - p.share_of_opening() * motion[0]);
    const auto dq = p.disc.friction(p.wanted - dp * p.drag - p.disc.parts(motion + 1));
    force_[at] = dp;
    for (int t = 0; t + 1 < components_; ++t) force_[at + t + 1] = dq[t];
    p.dw = dp + p.pulls_back * motion[0];
    if (p.opens) {
      p.dy -= p.y / p.w * p.dw;
      if (p.dw < 0) mine = std::min(mine, -p.w / p.dw);
      if (p.dy < 0) mine = std::min(mine, -p.y / p.dy);
    }
    p.disc.direct(dq.data(), p.friction * dp);
    mine = std::min(mine, p.disc.way_out());
  }
  return least_over_ranks(*problem_.map()->getComm(), mine);
}

/// From the interior to admissible forces: open points lose theirs, slipping ones stay within their bound.
void InteriorPath::project_to_admissible(PointField& lambda) const {
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const auto law = laws_[k];
    double* const force = &lambda[first_of(k)];
    const double trial = force[0] - stiffness_of(problem_, k, 0, 1.0) * motion_of(problem_, k, 0, gap_, lambda);
    const bool closed = judge(law, trial, 0, 0) != ContactStatus::open;
    force[0] = closed ? std::max(force[0], -law.tension) : -law.tension;
    hold_within(friction_bound(law, force[0]), force + 1, components_ - 1);
  }
}

/// Enters the path and takes the forces along.
void InteriorPath::set_out(PointField& lambda, double shift) {
  enter(lambda, gap_, shift);
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    hold_within(bound(k, lambda[first_of(k)]), &lambda[first_of(k) + 1], components_ - 1);
    if (path_[k].opens) lambda[first_of(k)] = path_[k].w - laws_.pull(k);
  }
}

/// Whether stones are in balance with the forces of the path, compared with how far these are from the law.
bool InteriorPath::is_near(const Imbalance& off) const { return off.equilibrium < numbers_.balanced * off.contact; }

/// Whether the last steps have brought neither the state nor, as long as that is far, equilibrium nearer by a tenth. A
/// step takes its own length off the imbalance, so that steps next to none are among them.
bool InteriorPath::gains_too_little(const Progress& progress) const {
  const int last = static_cast<int>(progress.residuals.size()) - 1;
  if (last <= progress.changed + numbers_.patience) return false;
  const auto &now = progress.residuals[last], &then = progress.residuals[last - numbers_.patience];
  return std::max(now.equilibrium, now.contact) > numbers_.gained * std::max(then.equilibrium, then.contact) &&
         (is_near(now) || now.equilibrium > numbers_.gained * then.equilibrium);
}

/// Beyond a fold friction follows the pressure by a half, beyond the next not at all. False where it does so already.
bool InteriorPath::follow_less(Progress& progress) {
  if (!numbers_.folds || follows_ == 0) return false;
  follows_ = follows_ == 1 ? 0.5 : 0;
  progress.changed = static_cast<int>(progress.residuals.size()) - 1;
  return true;
}

/// One step. The bound on what a point resists with rises as the barrier falls: far from a solution a large one lets
/// forces grow where stones share a vertex, near it a small one lets them creep. It goes towards a barrier that falls
/// by as much as the last step was long, but not below what the contact residual allows. Near equilibrium a short step
/// tells of a fold.
LinearSolveResult InteriorPath::step(TpetraVector& x, PointField& lambda, Progress& progress, NewtonReport& report) {
  const auto off = progress.residuals.back();
  const double distance = barrier();
  augmentation_ = std::clamp(numbers_.resistance * numbers_.start * scale_ / std::sqrt(distance), numbers_.resistance,
                             numbers_.largest_resistance);
  resistances(lambda, false);
  const double share = std::clamp(std::pow(1 - progress.step, 2), numbers_.least_share, numbers_.largest_share);
  set_right_hand_side(lambda, std::max(share * distance, numbers_.waiting * std::pow(off.contact * scale_, 2)));
  Tpetra::deep_copy(*gradient_, *linear_);
  problem_.subtract_contact_forces(force_, *gradient_);
  const auto solved = solve(report);
  if (solved.nothing) return solved;
  problem_.evaluate_direction(*direction_, *work_, gap_direction_);
  const double boundary = step_length();
  progress.step = std::min(boundary, 1.0);
  if (progress.step < numbers_.folded && is_near(off)) follow_less(progress);
  const double length = numbers_.to_boundary * boundary;
  x.update(length, *direction_, 1.0);
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    auto& p = path_[k];
    for (auto i = first_of(k); i < first_of(k + 1); ++i) lambda[i] += length * force_[i];
    p.w += length * p.dw;
    p.y += length * p.dy;
    p.disc.advance(length);
  }
  report_progress(report, off.equilibrium, off.contact, solved.iterations, length);
  return solved;
}

PathEnd InteriorPath::trace(TpetraVector& x, PointField& lambda, double tolerance, int largest_iterations,
                            const PointField* known_gap, NewtonReport& report) {
  const SavedPosition before(problem_, x);
  const PointField lambda_before = lambda;
  scale_ = force_scale(problem_, lambda);
  augmentation_ = numbers_.resistance;
  if (known_gap) predict(x, lambda, *known_gap, report);
  problem_.evaluate(x, *linear_, gap_);
  if (!known_gap) laws_.update(lambda, gap_);
  set_out(lambda, numbers_.start * std::max(scale_, force_scale(problem_, lambda)));
  follows_ = 1;
  double offered = numbers_.near;
  Progress progress;
  for (;;) {
    problem_.carry(x, tolerance * scale_);
    pull_back(x, lambda);
    const auto [equilibrium, contact] = progress.residuals.emplace_back(measure(x, lambda));
    const double size = size_of(problem_, equilibrium * scale_, contact * scale_, scale_);
    if (size <= tolerance && after_projection(lambda) <= tolerance) {
      project_to_admissible(lambda);
      return PathEnd::arrived;
    }
    if (static_cast<int>(progress.residuals.size()) > largest_iterations) break;
    if (gains_too_little(progress) && !follow_less(progress)) break;
    if (shortcut && size <= offered) {
      offered = numbers_.nearer * size;
      if (take_shortcut(x, lambda)) return PathEnd::arrived;
      if (report.stopped) return PathEnd::stopped;
    }
    if (before.distance(x) > run_away_ * problem_.length_scale()) {
      before.restore(x);
      lambda = lambda_before;
      return PathEnd::ran_away;
    }
    if (step(x, lambda, progress, report).nothing) break;
    if (report.stopped) return PathEnd::stopped;
  }
  project_to_admissible(lambda);
  return PathEnd::stuck;
}

void InteriorPath::report_progress(NewtonReport& report, double equilibrium, double contact, int krylov,
                                   double step) const {
  std::array<long long, 2> mine{};
  for (int k = 0; k < problem_.owned_points(); ++k) {
    const auto& p = path_[k];
    const double stiffness = problem_.local_stiffness()[k];
    if (!problem_.selected()[k] || p.w < stiffness * p.y) continue;
    ++mine[0];
    mine[1] += p.disc.slips(stiffness);
  }
  const auto all = total_of_each(*problem_.map()->getComm(), mine);  // all ranks, listening or not
  report.show(watch, {report.newton_iterations, equilibrium * scale_, contact * scale_, all[0], all[1], krylov, step,
                      augmentation_});
}

}  // namespace voussoir

#include "nonlinear/active_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "linalg/reduce.hpp"
#include "nonlinear/creeping_forces.hpp"
#include "nonlinear/driven_share.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/stuck_stones.hpp"

namespace voussoir {
namespace {

// [-] of a linear solve where stones share the forces by which strength is judged: what Krylov's method leaves depends
// on ranks, and on it which of two cracks is first.
constexpr double where_cracks_compete = 1e-8;

/// Resistance of points that give way in the first solve, relative to their local stiffness.
double first_damping(ActiveSetUse use, const ActiveSetParameters& numbers) {
  return use == ActiveSetUse::in_patch ? numbers.damping / numbers.lost : 0;
}

}  // namespace

ActiveSet::ActiveSet(NonlinearProblem& problem, ActiveSetUse use, const MethodParameters& methods, int patience,
                     Strength strength)
    : problem_(problem),
      methods_(methods),
      numbers_(methods_.active_set),
      patches_(methods_.patches),
      use_(use),
      components_(problem.components()),
      augmentation_(in_time() ? numbers_.augmentation_in_time : numbers_.augmentation_at_rest()),
      proximal_(in_time() ? 0 : 1),
      patience_(patience),
      laws_(problem, strength),
      sliding_(std::size_t(problem.points()) * (components_ - 1)),
      across_(problem.points()) {
  for (auto* v : {&linear_, &gradient_, &direction_}) *v = Teuchos::rcp(new TpetraVector(problem.map()));
}

/// Statuses that forces and gaps ask for. Where they are those of the last solve, which at rest has left no stone out
/// of balance, closed points resist more, until a status changes.
/// @param in_balance  no stone is out of balance by more than the tolerance
void ActiveSet::choose(const PointField& lambda, const PointField& gap, bool in_balance) {
  laws_.update(lambda, gap);
  resistance_.resize(problem_.points());
  const auto closed = std::exchange(closed_, std::vector<char>(problem_.points(), 0));
  const auto sliding = std::exchange(sliding_, PointField(sliding_.size(), 0.0));
  const auto set = [&] {
    std::fill(resistance_.begin(), resistance_.end(), PointStiffness());
    for (int k = 0; k < problem_.points(); ++k)
      if (problem_.selected()[k]) set_status(k, lambda, gap, sliding);
  };
  set();
  settled_ = same_statuses(closed, sliding);
  if (in_time() || (settled_ && !in_balance)) return;
  const double wanted = settled_ ? numbers_.augmentation_once_settled() : numbers_.augmentation_at_rest();
  if (std::exchange(augmentation_, wanted) != wanted) set();
}

/// Whether all points of all ranks have the statuses that they had. Collective.
bool ActiveSet::same_statuses(const std::vector<char>& closed, const PointField& sliding) const {
  bool differ = closed != closed_;
  for (int k = 0; k < problem_.points() && !differ; ++k) differ = turned(k, sliding);
  return !any_of_ranks(*problem_.map()->getComm(), differ);
}

/// Residuals of x with the forces that the law admits; leaves K x - f in linear_, the gaps and those forces.
double ActiveSet::measure(const TpetraVector& x, const PointField& lambda, NewtonReport& report) {
  problem_.evaluate(x, *linear_, gap_);
  std::vector<double> bound;
  const CurrentLaws laws(problem_, laws_.strength(), lambda, gap_);
  friction_bounds(problem_, laws, lambda, bound);
  admissible_ = lambda;  // what tied points bear stays
  project(problem_, laws, lambda, bound, admissible_);
  Tpetra::deep_copy(*gradient_, *linear_);
  const auto [equilibrium, contact] = imbalance(problem_, laws, admissible_, gap_, *gradient_);
  scale_ = force_scale(problem_, admissible_);
  report.residual = equilibrium / scale_;
  report.complementarity = contact / scale_;
  return size_of(problem_, equilibrium, contact, scale_);
}

/// Share of the step from lambda to force_ along which the imbalance drives it.
double ActiveSet::driven_length(const PointField& lambda) const {
  PointField force(lambda.size()), gap(gap_.size()), lawful;
  const double start = linear_->dot(*direction_), change = gradient_->dot(*direction_);
  const auto work = [&](double t) {  // [J]
    for (std::size_t i = 0; i < force.size(); ++i) {
      force[i] = lambda[i] + t * (force_[i] - lambda[i]);
      gap[i] = gap_[i] + t * gap_direction_[i];
    }
    lawful_forces(problem_, CurrentLaws(problem_, laws_.strength(), force, gap), force, gap, lawful);
    const auto owned = lawful.begin() + components_ * problem_.owned_points();
    const double of_forces = std::inner_product(lawful.begin(), owned, gap_direction_.begin(), 0.0);
    return total_over_ranks(*problem_.map()->getComm(), of_forces) - start - t * change;
  };
  return driven_share(work, numbers_.gained);
}

/// Falls with every step that is taken in full. Where a patch had to cut one it rises, half as fast.
double ActiveSet::damping_after(double damping) const {
  if (!in_patch() || length_ == 1) return damping / numbers_.lost;
  return std::min(numbers_.damping, damping * std::sqrt(numbers_.lost));
}

/// Of the next linear solve, relative to its right side. Where statuses stay it may be the last one: then it leaves no
/// more than the resistances of closed points do. At rest such solves are rare; there right sides of stones that flew
/// are larger than any force, and what a solve leaves of them must not push the others.
double ActiveSet::accuracy_of_next(const Search& search, const NewtonReport& report) const {
  if (!in_time()) {
    const double wanted =
        problem_.shares_forces() ? std::min(numbers_.accuracy, where_cracks_compete) : numbers_.accuracy;
    return wanted * std::min(1.0, search.largest_force / gradient_->normInf());
  }
  if (!settled_) return numbers_.accuracy;
  const double left = std::max(search.tolerance, report.complementarity / augmentation_) * scale_;
  return std::clamp(left / (2 * gradient_->norm2()), numbers_.finest_accuracy, numbers_.accuracy);
}

/// One linear solve with the statuses chosen. What damping resists is no force: nothing of it is left once points rest.
/// Where a library refused the system nothing moves.
/// @param damping  of points that give way, relative to their local stiffness
/// @param most     Krylov iterations
LinearSolveResult ActiveSet::step(TpetraVector& x, PointField& lambda, double damping, double relative_tolerance,
                                  int most) {
  auto damped = resistance_;
  for (int k = 0; damping > 0 && k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    damped[k].hold(stiffness_of(problem_, k, 0, damping), stiffness_of(problem_, k, 1, damping));
  }
  direction_->putScalar(0);
  const auto solved = problem_.solve(damped, proximal_, gradient_, direction_, {relative_tolerance, most});
  if (solved.nothing) return solved;
  problem_.evaluate_direction(*direction_, *gradient_, gap_direction_);
  force_ = target_;
  // Around a patch all holds still: which point gives way there says little of the whole.
  if (!in_patch()) change_before_ = std::exchange(change_, PointField(lambda.size()));
  for (int k = 0; k < problem_.points(); ++k)
    if (problem_.selected()[k])
      resistance_[k].yield(&gap_direction_[k * components_], components_, &force_[k * components_]);
  for (std::size_t i = 0; i < change_.size(); ++i) change_[i] = force_[i] - lambda[i];
  length_ = use_ == ActiveSetUse::at_rest ? 1.0 : driven_length(lambda);
  x.update(length_, *direction_, 1.0);
  for (std::size_t i = 0; i < lambda.size(); ++i)
    lambda[i] = length_ == 1 ? force_[i] : lambda[i] + length_ * (force_[i] - lambda[i]);
  split_forces(problem_, laws_, {closed_, sliding_, resistance_}, lambda);
  return solved;
}

/// Brings the stones that keep residuals up to rest alone. A correction that raises residuals is taken back.
/// @param start  where the last linear solve began
void ActiveSet::correct_locally(TpetraVector& x, PointField& lambda, const TpetraVector& start, Search& search,
                                NewtonReport& report) {
  const double expected =
      std::isinf(search.best) ? search.tolerance : std::max(search.tolerance, patches_.trigger * search.best);
  if (!patches_.used || use_ != ActiveSetUse::at_rest || !search.local || search.size <= expected) return;
  if (problem_.softening()) return;  // a patch holds strength as it is
  auto* const source = problem_.patches();
  if (!source) return;
  const double known = std::min({search.size, search.best, 1.0}), size_before = search.size;
  const TpetraVector x_before(x, Teuchos::Copy);
  const PointField lambda_before = std::exchange(lambda, admissible_);
  const int solves = bring_to_rest(*source, *problem_.map()->getComm(), x, lambda,
                                   {std::max(search.tolerance, patches_.block_threshold * known) * scale_,
                                    std::max(patches_.trigger * search.tolerance, patches_.aim * known), scale_,
                                    numbers_.lost * known * scale_, resistance_, start},
                                   methods_);
  if (solves == 0) {
    lambda = lambda_before;
    return;
  }
  report.local_solves += solves;
  search.size = measure(x, lambda, report);
  report_progress(report, 0, solves);
  search.local = search.size <= numbers_.lost * size_before;
  if (search.local) return;
  Tpetra::deep_copy(x, x_before);
  lambda = lambda_before;
  search.size = measure(x, lambda, report);
}

/// The residual grew as it does when a stone flies. In a patch none does: there steps are cut.
bool ActiveSet::lost_a_stone(const Search& search) const {
  return numbers_.damping > 0 && use_ == ActiveSetUse::at_rest &&
         search.size > numbers_.lost * std::min(search.known, search.best);
}

/// What a linear solve has led to: an end, or none yet.
std::optional<ActiveSetEnd> ActiveSet::judge_solve(TpetraVector& x, PointField& lambda, const TpetraVector& start,
                                                   int krylov, Search& search, NewtonReport& report) {
  search.size = measure(x, lambda, report);
  report_progress(report, krylov);
  if (!report.stopped) correct_locally(x, lambda, start, search, report);
  if (report.stopped) return ActiveSetEnd::stopped;
  if (search.size <= search.tolerance) {
    lambda = admissible_;
    report.outcome = NewtonOutcome::converged;
    return ActiveSetEnd::arrived;
  }
  const bool gained = std::isfinite(search.best) && search.size <= numbers_.gained * search.best;
  if (!in_time() && krylov >= many_krylov() && !gained) return ActiveSetEnd::loose_stones;
  return {};
}

/// A linear solve with the statuses chosen, made again with more and more damping as long as it loses a stone and
/// damping helps.
std::optional<ActiveSetEnd> ActiveSet::solve_once(TpetraVector& x, PointField& lambda, Search& search,
                                                  NewtonReport& report) {
  const TpetraVector start(x, Teuchos::Copy), linear(*linear_, Teuchos::Copy);
  for (double undamped = std::numeric_limits<double>::infinity();;) {
    Tpetra::deep_copy(*gradient_, linear);
    problem_.subtract_contact_forces(target_, *gradient_);
    gradient_->scale(-1.0);
    const auto solved =
        step(x, lambda, search.damping, accuracy_of_next(search, report), in_time() ? 0 : many_krylov());
    report.count(solved);
    ++search.solves;
    search.size = std::numeric_limits<double>::infinity();
    if (solved.nothing) return ActiveSetEnd::refused;
    const auto end = judge_solve(x, lambda, start, solved.iterations, search, report);
    if (end || !lost_a_stone(search) || search.solves >= search.largest_solves) return end;
    if (search.size > numbers_.gained * std::exchange(undamped, search.size)) return {};
    search.damping = std::max(numbers_.lost * search.damping, numbers_.damping);
    Tpetra::deep_copy(x, start);
  }
}

ActiveSetEnd ActiveSet::solve(TpetraVector& x, PointField& lambda, double tolerance, int largest_solves,
                              const PointField* known_gap, NewtonReport& report) {
  Search search;
  search.tolerance = tolerance;
  search.largest_solves = largest_solves;
  search.largest_force = force_scale(problem_, lambda);
  search.damping = first_damping(use_, numbers_);
  const double start = measure(x, lambda, report);
  // Supports that have moved are no measure: what they leave at the start says little of what follows.
  if (!known_gap) search.known = start;
  Nearest nearest;
  // A patch that is at rest goes on only as long as that gains soon.
  const std::array<int, 2> patience{patience_, numbers_.patience};
  const double at_rest = tolerance / patches_.block_threshold;
  while (search.solves < largest_solves && search.solves < search.last_gain + patience[nearest.size <= at_rest]) {
    if (problem_.carry(x, tolerance * scale_)) measure(x, lambda, report);
    const PointField chosen = known_gap && search.solves == 0 ? *known_gap : gap_;
    const bool in_balance = size_of(problem_, report.residual * scale_, 0, scale_) <= tolerance;
    choose(lambda, chosen, in_balance);
    if (settled_ &&
        go_to_the_bound(problem_, laws_, {closed_, sliding_, change_before_, change_}, numbers_.alike, lambda))
      choose(lambda, chosen, in_balance);
    set_right_hand_side(lambda, chosen);
    const auto end = solve_once(x, lambda, search, report);
    if (end == ActiveSetEnd::refused && nearest.position) break;
    if (end) return *end;
    if (in_patch() && search.size < nearest.size)
      nearest = {search.size, std::make_unique<SavedPosition>(problem_, x), admissible_};
    search.damping = damping_after(search.damping);
    if (!(search.size <= numbers_.gained * search.best)) continue;
    search.best = search.size;
    search.last_gain = search.solves;
    search.local = true;
  }
  if (nearest.position) {
    nearest.position->restore(x);
    lambda = nearest.lambda;
    measure(x, lambda, report);
  }
  return ActiveSetEnd::circled;
}

void ActiveSet::report_progress(NewtonReport& report, int krylov, int local_solves) const {
  std::array<long long, 2> mine{};
  for (int k = 0; k < problem_.owned_points(); ++k) {
    if (!problem_.selected()[k]) continue;
    mine[0] += closed_[k];
    mine[1] += slides(k);
  }
  const auto all = total_of_each(*problem_.map()->getComm(), mine);  // all ranks, listening or not
  report.show(watch, {report.newton_iterations, report.residual * scale_, report.complementarity * scale_, all[0],
                      all[1], krylov, length_, augmentation_, local_solves});
}

}  // namespace voussoir

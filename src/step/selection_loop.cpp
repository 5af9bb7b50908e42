#include "step/selection_loop.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.hpp"
#include "joints/tractions.hpp"
#include "linalg/reduce.hpp"
#include "model/joint_strength.hpp"
#include "model/mortar.hpp"
#include "model/phase.hpp"
#include "step/release.hpp"

namespace voussoir {
namespace {

/// A root of decreases relative to the energy that will be there.
double beside_what_follows(double root) { return root / std::hypot(1, root); }

/// The stones of the joint that a point is on. Collective.
std::array<int, 2> stones_of_point(const ContactPoints& points, const Teuchos::Comm<int>& comm, PointId id) {
  std::array<int, 2> mine{-1, -1};
  for (int k = 0; k < points.owned(); ++k) {
    if (points.points()[k].id != id) continue;
    const auto& joint = points.joints()[points.points()[k].joint];
    mine[0] = joint.block_i;
    mine[1] = joint.block_j;
  }
  return largest_of_each(comm, mine);
}

bool is_too_large(double root, double allowed, double times) { return beside_what_follows(root) > times * allowed; }

/// Joints of a step, as worn as at its start. A time step looks at its middle: there the mean of a force is met that
/// falls along it.
std::optional<SofteningPoints> softening_points(const Model& model, const ContactState& before, bool in_time) {
  if (!model.weakens()) return {};
  return std::make_optional<SofteningPoints>(model.law(), model.softening(), before.opened, before.slipped,
                                             in_time ? gaps_to_middle(model) : std::vector<double>());
}

/// Error of ties that may stay [-]: what many steps add up to must stay within what a scene asks for.
double allowed_error(const ModelSettings& settings, bool in_time) {
  const double share = in_time || settings.any_time ? settings.internals.step.share_of_a_time_step : 1.0;
  return share * settings.selection.error_tolerance;
}

}  // namespace

std::vector<double> borne_by_joints(const BlockSystem& structure, const std::vector<double>& displacement,
                                    const std::vector<double>& load) {
  VOUSSOIR_EXPECT(load.size() == displacement.size() && "load: of node copies");
  std::vector<double> r;
  structure.internal_forces(displacement, r);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] -= load[i];
  return r;
}

ContactProblem::Parts SelectionTools::parts() {
  const auto& how = model_.settings();
  return {model_.structure(),      model_.points(),       model_.continuum(), model_.held(), model_.local_stiffness(),
          model_.initial_gap(),    how.preconditioner,    how.internals,      solver_,       model_.compliance(),
          model_.softest_mortar(), how.newton.has_inertia};
}

ContactProblem& SelectionTools::problem(const std::vector<char>& selected, const ContactProblem::Asked& asked) {
  const bool other = !problem_ || arrangement_ != model_.arrangement() || problem_->selection() != selected;
  // A selection that changed on one rank changed for all.
  if (!any_of_ranks(*model_.structure().comm(), other)) {
    problem_->begin(asked);
    return *problem_;
  }
  problem_.reset();  // its room first
  arrangement_ = model_.arrangement();
  problem_ = std::make_unique<ContactProblem>(parts(), selected, asked);
  return *problem_;
}

SelectionLoop::SelectionLoop(SelectionTools& tools, ContactState& state, const StepInput& input, Progress& progress)
    : tools_(tools),
      model_(tools.model()),
      selection_(model_.settings().selection),
      numbers_(model_.settings().internals.step),
      input_(input),
      progress_(progress),
      law_(laws_left(model_, state)),
      tolerance_(model_.settings().newton.tolerance),
      allowed_(allowed_error(model_.settings(), in_time())),
      before_(state),
      selected_before_(count_selected(model_, state)),
      known_gap_(model_.gaps(state.displacement)),
      softening_(softening_points(model_, before_, in_time())),
      damage_(damage_at_start()),
      state_(state),
      displacement_(state.displacement),
      lambda_(state.lambda) {
  next_.wanted = looks_first() ? std::max(tolerance_, numbers_.first_look) : tolerance_;
}

Damage SelectionLoop::damage_at_start() const { return softening_ ? softening_->at_start() : Damage(); }

/// Damage of the start of the step, in load steps of what the rounds before have come to: the solver gives that back
/// once it has arrived.
Damage SelectionLoop::damage_before_round() const { return in_time() ? damage_at_start() : damage_; }

/// What joints have gone through up to where the solution is.
void SelectionLoop::keep_damage(const ContactProblem& problem) {
  if (!softening_) return;
  damage_ = wear(problem, fall(damage_), state_.lambda, model_.gaps(state_.displacement)).damage;
  for (std::size_t k = 0; k < state_.opened.size(); ++k) {
    state_.opened[k] = damage_[k].opened;
    state_.slipped[k] = before_.slipped[k] + damage_[k].way;
  }
}

/// A scene that asks for all points has them from its first step on, but for a bonded look at that: also in a run that
/// goes on from one that asked for less, and in time where only what moved first was let go.
void SelectionLoop::begin_with_all() {
  if (selection_.mode != SelectionMode::all || all_selected() || (selected_before_ == 0 && !in_time())) return;
  release_all(model_, law_, state_);
}

StepReport SelectionLoop::run() {
  begin_with_all();
  for (;; ++report_.selection_rounds) {
    if (!look()) {
      if (!resolve_all()) return report_;
      continue;
    }
    Phase phase("selection");
    find_violations();
    estimate();
    if (too_rough() || release()) continue;
    if (finish()) return report_;
  }
}

// ---------------------------------------------------------------------------------------------------------- look

/// Whether the first solution is one to look at only: points may be released, so a rough one tells as much.
bool SelectionLoop::looks_first() const {
  if (in_time() || selection_.mode == SelectionMode::bonded || selected_before_ == model_.points().total())
    return false;
  return selected_before_ == 0 || selection_.mode == SelectionMode::adaptive;
}

/// Equilibrium with the points selected now; false where there is none.
bool SelectionLoop::look() {
  if (!find_equilibrium(next_.from_before && selected_before_ > 0 ? &known_gap_ : nullptr)) return false;
  const bool rough = next_.wanted > tolerance_;
  // Where points are selected already a rough state is looked at no further, unless far more have to let go.
  if (rough && report_.selection_rounds == 0 && selected_before_ > 0) {
    Phase phase("selection");
    const auto violations = tied_violations(model_, law_, state_, ties_seen_.cluster);
    const double root = root_of(predicted_decrease(violations, model_.local_stiffness()));
    next_.suffices = !is_too_large(root, allowed_, numbers_.too_large);
  }
  if (rough && next_.suffices) {
    next_.wanted = tolerance_;
    if (!find_equilibrium(nullptr)) return false;
  }
  next_.from_before = false;
  displacement_ = state_.displacement;
  lambda_ = state_.lambda;
  return true;
}

NewtonParameters SelectionLoop::way_of_solving() const {
  auto how = model_.settings().newton;
  how.time_follows = !how.has_inertia && model_.settings().any_time;
  if (!all_selected() && selection_.mode == SelectionMode::adaptive)
    how.largest_iterations = std::min(how.largest_iterations, numbers_.solves_with_ties);
  return how;
}

/// Moves the state to where the selected points obey their law, as accurately as wanted; false when there is no way.
/// @param known_gap  [m] of the state, where that is an equilibrium under other loads; else null
bool SelectionLoop::find_equilibrium(const PointField* known_gap) {
  const int dim = model_.components();
  auto& problem = tools_.problem(
      state_.selected, {law_, state_.slip_origin, input_.load, input_.prescribed, softening(), &before_.lambda});
  ContactSolver newton(problem, way_of_solving(), model_.settings().internals.methods, state_.fast_way);
  newton.watch = [this](const NewtonProgress& solve) { return progress_.solved(solve); };
  const bool looks = next_.wanted > tolerance_ && !in_time() && strength_ == StrengthIs::held;
  strength_ = looks ? StrengthIs::held : StrengthIs::falling;
  damage_ = damage_before_round();
  const auto x = problem.unknowns(state_.displacement);
  {
    Phase phase("contact");
    const auto solved = newton.solve({*x, state_.lambda, damage_}, {next_.wanted, strength_, known_gap});
    report_.newton.add(solved);
    keep_if_hard(problem, *x, solved);
  }
  report_.cost.add(problem.cost());
  problem.displacement(*x, state_.displacement);
  report_.largest_clusters = problem.map()->getGlobalNumElements() / dim;
  if (!report_.converged()) {
    problem.space().scatter(newton.mechanism(), mechanism_);
    return false;
  }
  if (!looks) keep_damage(problem);
  const auto stones_at = [&](PointId id) { return stones_of_point(model_.points(), *model_.structure().comm(), id); };
  if (report_.newton.unstable > 0) report_.unstable_joint = stones_at(report_.newton.unstable_at);
  if (report_.newton.alike > 0) report_.alike_joint = stones_at(report_.newton.alike_at);
  if (report_.newton.undetermined > 0) report_.undetermined_joint = stones_at(report_.newton.undetermined_at);
  ties_seen_.cluster = problem.space().cluster();
  recover_ties();
  return true;
}

/// A problem that was hard is kept where it is solved or given up: not as a rough solution, nor where it was stopped.
void SelectionLoop::keep_if_hard(ContactProblem& problem, const TpetraVector& x, const NewtonReport& solved) {
  if (!progress_.keep) return;
  if (std::exchange(hardness_.selected, selected()) != hardness_.selected) hardness_ = {hardness_.selected};
  hardness_.hard = hardness_.hard || solved.hard;
  hardness_.solves += solved.newton_iterations;
  const bool rough = solved.outcome == NewtonOutcome::converged && next_.wanted > tolerance_;
  if (!hardness_.hard || rough || solved.outcome == NewtonOutcome::stopped) return;
  progress_.keep({problem, x, state_.lambda, solved, hardness_.solves});
  hardness_ = {};
}

/// The forces of tied points. In time ties hold what has moved where it is: their forces go on from what they were.
void SelectionLoop::recover_ties() {
  const int dim = model_.components();
  Phase phase("selection");
  const auto& s = model_.structure();
  ties_seen_.borne = borne_by_joints(s, state_.displacement, input_.load);
  if (in_time())
    recover_tied_forces(model_.points(), ties_seen_.cluster, model_.held(), ties_seen_.borne, state_.lambda,
                        before_.lambda, open_points(model_));
  else
    recover_tied_forces(model_.points(), ties_seen_.cluster, model_.held(), ties_seen_.borne, state_.lambda);
  model_.points().exchange().update(state_.lambda, dim);
}

/// Joints that were held together may be what left no way: all are resolved before giving up, which is false. A
/// mechanism in which tied points move alike is one without ties too.
bool SelectionLoop::resolve_all() {
  const bool ends = report_.newton.outcome == NewtonOutcome::collapse || report_.newton.stopped;
  if (ends || all_selected() || selection_.mode != SelectionMode::adaptive) return false;
  state_.displacement = displacement_;
  state_.lambda = lambda_;
  state_.fast_way = before_.fast_way;
  damage_ = damage_at_start();
  release_all(model_, law_, state_);
  next_.wanted = tolerance_;
  next_.from_before = report_.selection_rounds == 0;
  progress_.looked(report_.selection_rounds, selected(), 0.0);
  return true;
}

// ------------------------------------------------------------------------------------------------------ estimate

/// What errors are relative to [J]; of a time step displacements do not tell it.
double SelectionLoop::energy() const {
  if (in_time()) return input_.in_time->energy;
  const auto& s = model_.structure();
  return s.elastic_energy(s.deformation(state_.displacement));
}

/// Root of decreases, relative to the energy.
double SelectionLoop::root_of(const std::vector<double>& decrease) const {
  return root_of_decreases(decrease, energy(), numbers_.largest_error, *model_.structure().comm());
}

bool SelectionLoop::may_release() const {
  return selection_.mode == SelectionMode::adaptive && report_.selection_rounds < selection_.largest_rounds;
}

/// Whether the scene asks for all points, and a bonded look was only to find where to begin.
bool SelectionLoop::releases_rest() const {
  return selection_.mode == SelectionMode::all && selected_before_ == 0 && report_.selection_rounds == 0;
}

void SelectionLoop::find_violations() {
  ties_seen_.violations = tied_violations(model_, law_, state_, ties_seen_.cluster);
  ties_seen_.decrease = predicted_decrease(ties_seen_.violations, model_.local_stiffness());
  ties_seen_.root = in_time() || may_release() ? root_of(ties_seen_.decrease) : 0.0;
  const bool all_bonded = report_.selection_rounds == 0 && selected_before_ == 0;
  const double times = all_bonded ? numbers_.too_large_bonded : numbers_.too_large;
  ties_seen_.large = !in_time() && (releases_rest() || is_too_large(ties_seen_.root, allowed_, times));
}

/// Error of the ties. Where the decreases alone tell that it is too large, no system is solved to know it; nor, as time
/// steps are many, where they tell that it is small.
void SelectionLoop::estimate() {
  auto& known = state_.rest.error;
  known.follow(ties_seen_.root);
  const double bound = known.bound(numbers_.error_by_indicator, model_.settings().internals.rest);
  const bool small = in_time() && (bound <= allowed_ || selection_.mode != SelectionMode::adaptive);
  report_.error_estimate = ties_seen_.large ? beside_what_follows(ties_seen_.root) : bound;
  if (!ties_seen_.large && !small) solve_for_error();
  const double told = ties_seen_.large ? std::numeric_limits<double>::quiet_NaN() : report_.error_estimate;
  progress_.looked(report_.selection_rounds, selected(), told);
}

void SelectionLoop::solve_for_error() {
  if (!in_time() && ties_seen_.violations.largest > 0) tools_.forget_problem();  // two would take twice the room
  const Damage damage = damage_before_round();
  const auto error = tie_error(tools_.parts(), {law_, state_.slip_origin, input_.load, input_.prescribed, softening()},
                               state_, ties_seen_.cluster, ties_seen_.violations, fall(damage));
  report_.estimate_solves += error.linear_solves;
  report_.newton.krylov_iterations += error.krylov_iterations;
  report_.newton.failed_solves += !error.known;
  report_.cost.add(error.cost);
  report_.error_estimate = relative_error(model_.structure(), state_.displacement, error,
                                          in_time() ? input_.in_time->energy : 0.0, numbers_.largest_error);
  // What a solve leaves out may be the error: then the decreases tell, of which it is no more than a multiple.
  if (!error.known)
    report_.error_estimate =
        std::max(report_.error_estimate, numbers_.error_by_indicator * root_of(ties_seen_.decrease));
  if (in_time()) state_.rest.error.learn(report_.error_estimate);
}

/// Whether the solution is too rough to go by; then the next round wants a better one. Where forces differ by orders of
/// magnitude, as from the foot to the top of a tall wall, a rough round may be far from any solution where they are
/// small. Releasing points lowers the error: one that grows is not believed.
bool SelectionLoop::too_rough() {
  const bool grown = ties_seen_.large ? ties_seen_.root > next_.root : report_.error_estimate > next_.estimate;
  if (grown && next_.wanted > tolerance_) {
    next_.wanted = std::max(tolerance_, numbers_.share_of_violation * next_.wanted);
    return true;
  }
  next_.root = ties_seen_.root;
  next_.estimate = ties_seen_.large ? unknown : report_.error_estimate;
  return false;
}

// ------------------------------------------------------------------------------------------------------- release

/// Whether points were released, which takes another round.
bool SelectionLoop::release() {
  const bool first_look = report_.selection_rounds == 0;
  if ((releases_rest() && release_all(model_, law_, state_)) || (first_look && release_mortar(model_, law_, state_))) {
    next_.wanted = tolerance_;
    return true;
  }
  const bool too_large = ties_seen_.large || report_.error_estimate > allowed_;
  return too_large && may_release() && release_what_matters();
}

/// The points that hold most of the error, or all where that is most of them.
bool SelectionLoop::release_what_matters() {
  const auto released = voussoir::release(model_, law_, ties_seen_.cluster, ties_seen_.decrease, state_);
  if (released > 0) {
    state_.rest.error = {};
    const double worth = numbers_.share_of_violation * ties_seen_.violations.largest;
    next_.wanted = std::max(tolerance_, std::min(worth, numbers_.coarsest_tolerance));
  }
  next_.suffices = released > 0 && numbers_.error_of_remainder() * root_of_rest() <= allowed_;
  // The next round tends to release as many again: better all at once than a round that is thrown away.
  const auto most = selection_.largest_share * static_cast<double>(model_.points().total());
  if (static_cast<double>(selected() + released) <= most || !release_all(model_, law_, state_)) return released > 0;
  next_.wanted = tolerance_;
  return true;
}

/// Root of the decreases that points not selected yet would bring.
double SelectionLoop::root_of_rest() const {
  auto decrease = ties_seen_.decrease;
  for (std::size_t k = 0; k < decrease.size(); ++k)
    if (state_.selected[k]) decrease[k] = 0;
  return root_of(decrease);
}

// -------------------------------------------------------------------------------------------------------- finish

long long SelectionLoop::selected() const { return count_selected(model_, state_); }

/// The error asks for no more points. Whether that is all; else another round is to be accurate, or to let stones go.
bool SelectionLoop::finish() {
  if (ties_seen_.large) solve_for_error();
  const bool accurate = next_.wanted <= tolerance_;
  next_.wanted = tolerance_;
  return accurate && release_loose() == 0;
}

/// Releases the stones that nothing but ties balances, where that is allowed; returns how many points that selects.
long long SelectionLoop::release_loose() {
  report_.tied_share = 0;
  report_.tied_block = -1;
  if (selection_.mode == SelectionMode::bonded || all_selected()) return 0;
  const auto& own = in_time() ? input_.in_time->own_load : input_.load;
  const auto balance = tools_.ties().judge(law_, state_, ties_seen_.cluster, ties_seen_.borne, own,
                                           ties_seen_.violations.largest_normal);
  if (!balance.any) return 0;
  const auto released = may_release() ? release_blocks(model_, law_, balance.loose, state_) : 0;
  if (released > 0) return released;
  report_.tied_share = balance.largest;
  report_.tied_block = balance.where;
  return 0;
}

}  // namespace voussoir

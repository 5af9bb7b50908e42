#include "simulation/adaptive_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/load_steps.hpp"
#include "joints/tractions.hpp"
#include "linalg/local_view.hpp"
#include "linalg/reduce.hpp"
#include "simulation/error_estimate.hpp"
#include "simulation/phase.hpp"
#include "simulation/release.hpp"

namespace voussoir {
namespace {

/// A root of decreases relative to the energy that will be there.
double beside_what_follows(double root) { return root / std::hypot(1, root); }

bool is_too_large(double root, double allowed, double times) { return beside_what_follows(root) > times * allowed; }

template <int dim>
Vector<dim> force_at(const PointField& lambda, int k) {
  Vector<dim> f;
  std::copy_n(lambda.begin() + dim * k, dim, f.begin());
  return f;
}

}  // namespace

template <int dim>
AdaptiveStep<dim>::AdaptiveStep(const Model<dim>& model) : model_(model), solver_(model.scene().solver), ties_(model) {}

template <int dim>
ContactState AdaptiveStep<dim>::initial_state() const {
  ContactState state;
  const int points = model_.points().size();
  state.displacement.assign(static_cast<std::size_t>(dim) * model_.structure().nodes(), 0.0);
  state.lambda.assign(static_cast<std::size_t>(dim) * points, 0.0);
  if (model_.rubs()) state.slip_origin = state.lambda;
  state.selected.assign(points, 0);
  // Open joints cannot begin bonded.
  const auto& gap = model_.initial_gap();
  for (std::size_t k = 0; k < gap.size(); ++k)
    state.selected[k] = gap[k] > 0 || model_.scene().selection.mode == SelectionMode::all;
  state.broken.assign(points, 0);
  return state;
}

template <int dim>
std::vector<double> AdaptiveStep<dim>::borne_by_joints(const ContactState& state,
                                                       const std::vector<double>& load) const {
  std::vector<double> r;
  model_.structure().internal_forces(state.displacement, r);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] -= load[i];
  return r;
}

template <int dim>
std::vector<double> AdaptiveStep<dim>::residual(const ContactState& state, const std::vector<double>& load) const {
  auto r = borne_by_joints(state, load);
  add_contact_forces(model_.points(), {}, state.lambda, -1.0, r);
  return r;
}

template <int dim>
PointLaws AdaptiveStep<dim>::current_law(const ContactState& state) const {
  auto law = model_.law();
  for (std::size_t k = 0; k < law.size(); ++k)
    if (state.broken[k]) law.lose_bond(k);
  return law;
}

/// What errors are relative to [J].
template <int dim>
double AdaptiveStep<dim>::energy_of(const ContactState& state) const {
  if (in_time) return known_energy;
  const auto& s = model_.structure();
  return s.elastic_energy(s.deformation(state.displacement));
}

/// Root of decreases, relative to the energy.
template <int dim>
double AdaptiveStep<dim>::root_of(const std::vector<double>& decrease, const ContactState& state) const {
  return root_of_decreases(decrease, energy_of(state), model_.scene().internals.step.largest_error,
                           *model_.structure().comm());
}

/// The same of the points that are not selected.
template <int dim>
double AdaptiveStep<dim>::root_of_rest(std::vector<double> decrease, const ContactState& state) const {
  for (std::size_t k = 0; k < decrease.size(); ++k)
    if (state.selected[k]) decrease[k] = 0;
  return root_of(decrease, state);
}

/// The same of the points that violate their law.
template <int dim>
double AdaptiveStep<dim>::root_of_violations(const ContactState& state, const std::vector<int>& cluster) const {
  Phase phase("selection");
  const auto violations = tied_violations(model_, law_, state, cluster);
  return root_of(predicted_decrease(violations, model_.local_stiffness()), state);
}

/// Whether points may be released, so that a rough state tells as much as an accurate one.
template <int dim>
bool AdaptiveStep<dim>::looks_first(long long selected) const {
  const auto mode = model_.scene().selection.mode;
  if (in_time || mode == SelectionMode::bonded || selected == model_.points().total()) return false;
  return selected == 0 || mode == SelectionMode::adaptive;
}

/// Equilibrium with the points selected now, and the forces of the others; false when there is none.
template <int dim>
bool AdaptiveStep<dim>::solve_round(const typename ContactProblem<dim>::Parts& parts, ContactState& state,
                                    const std::vector<double>& load, const std::vector<double>& prescribed,
                                    double tolerance, const PointField* known_gap, const PointField& force_before,
                                    std::vector<int>& cluster, StepReport& report) {
  ContactProblem<dim> problem(parts, state, law_, load, prescribed);
  auto how = model_.scene().newton;
  how.time_follows = !how.has_inertia && any_time(model_.scene().stages);
  const bool all = count_selected(model_, state) == model_.points().total();
  if (!all && model_.scene().selection.mode == SelectionMode::adaptive)
    how.largest_iterations = std::min(how.largest_iterations, model_.scene().internals.step.solves_with_ties);
  ContactSolver newton(problem, how, model_.scene().internals.methods, state.fast_way);
  newton.narrate = narrate;
  const auto x = problem.unknowns(state.displacement);
  {
    Phase phase("contact");
    report.newton.add(newton.solve(*x, state.lambda, tolerance, known_gap));
  }
  report.cost.add(problem.cost());
  problem.displacement(*x, state.displacement);
  report.largest_clusters = problem.map()->getGlobalNumElements() / dim;
  if (report.newton.outcome != NewtonOutcome::converged) {
    problem.space().scatter(newton.mechanism(), mechanism_);
    return false;
  }
  Phase phase("selection");
  cluster = problem.space().cluster();
  borne_ = borne_by_joints(state, load);
  if (in_time)
    recover_tied_forces(model_.structure(), model_.points(), cluster, model_.held(), borne_, state.lambda, force_before,
                        open_points(model_));
  else
    recover_tied_forces(model_.structure(), model_.points(), cluster, model_.held(), borne_, state.lambda);
  model_.points().exchange().update(state.lambda, dim);
  return true;
}

/// Releases the stones that nothing but ties balances, where that is allowed; returns how many points that selects.
template <int dim>
long long AdaptiveStep<dim>::release_loose(ContactState& state, const std::vector<double>& load,
                                           const std::vector<int>& cluster, double largest_normal, StepReport& report,
                                           bool may_release) {
  report.tied_share = 0;
  report.tied_block = -1;
  if (model_.scene().selection.mode == SelectionMode::bonded) return 0;
  if (count_selected(model_, state) == model_.points().total()) return 0;
  const auto& own = own_load ? *own_load : load;
  const auto balance = ties_.judge(law_, state, cluster, borne_, own, largest_normal);
  if (!balance.any) return 0;
  const auto released = may_release ? release_blocks(model_, law_, balance.loose, state) : 0;
  if (released > 0) return released;
  report.tied_share = balance.largest;
  report.tied_block = balance.where;
  return 0;
}

template <int dim>
StepReport AdaptiveStep<dim>::solve_unbroken(ContactState& state, const std::vector<double>& load,
                                             const std::vector<double>& prescribed) {
  const auto& scene = model_.scene();
  const typename ContactProblem<dim>::Parts parts{
      model_.structure(),      model_.points(),         model_.continuum(), model_.held(), model_.local_stiffness(),
      model_.initial_gap(),    scene.preconditioner,    scene.internals,    solver_,       model_.compliance(),
      model_.softest_mortar(), scene.newton.has_inertia};
  StepReport report;
  law_ = current_law(state);
  const auto& selection = scene.selection;
  const auto& numbers = scene.internals.step;
  const double tolerance = scene.newton.tolerance;
  const double allowed =
      (in_time || any_time(scene.stages) ? numbers.share_of_a_time_step : 1.0) * selection.error_tolerance;
  double wanted = tolerance;
  const long long selected_before = count_selected(model_, state);
  if (looks_first(selected_before)) wanted = std::max(tolerance, numbers.first_look);
  const ContactState before = state;
  ContactState solved_last;  // of this step, with fewer points selected: nearer than what was before
  solved_last.displacement = before.displacement;
  solved_last.lambda = before.lambda;
  bool from_before = true, suffices = false;
  const PointField known_gap = gaps(state.displacement);
  double estimate_before = std::numeric_limits<double>::infinity(), root_before = estimate_before;
  for (;; ++report.selection_rounds) {
    std::vector<int> cluster;
    const auto* const left = from_before && selected_before > 0 ? &known_gap : nullptr;
    bool solved = solve_round(parts, state, load, prescribed, wanted, left, before.lambda, cluster, report);
    // Where points are selected already a rough state is looked at no further, unless far more have to let go.
    if (solved && report.selection_rounds == 0 && selected_before > 0 && wanted > tolerance)
      suffices = !is_too_large(root_of_violations(state, cluster), allowed, numbers.too_large);
    if (solved && suffices && wanted > tolerance) {
      wanted = tolerance;
      solved = solve_round(parts, state, load, prescribed, wanted, nullptr, before.lambda, cluster, report);
    }
    if (!solved) {
      // Joints that were held together may be what left no way: resolve them all before giving up.
      // A mechanism in which tied points move alike is one without ties too.
      const bool falls = report.newton.outcome == NewtonOutcome::collapse;
      const bool no_ties = count_selected(model_, state) == model_.points().total();
      if (falls || no_ties || selection.mode != SelectionMode::adaptive) return report;
      state.displacement = solved_last.displacement;
      state.lambda = solved_last.lambda;
      state.fast_way = before.fast_way;
      release_all(model_, law_, state);
      wanted = tolerance;
      from_before = report.selection_rounds == 0;
      if (narrate_round) narrate_round(report.selection_rounds, count_selected(model_, state), 0.0);
      continue;
    }
    from_before = false;
    solved_last.displacement = state.displacement;
    solved_last.lambda = state.lambda;
    Phase phase("selection");
    const auto violations = tied_violations(model_, law_, state, cluster);
    const auto decrease = predicted_decrease(violations, model_.local_stiffness());
    const bool first_look = report.selection_rounds == 0;
    const bool release_rest = selection.mode == SelectionMode::all && selected_before == 0 && first_look;
    // Where the decreases alone tell that the error is too large, no system is solved to know it; nor, as time steps
    // are many, where they tell that it is small.
    const bool may_release =
        selection.mode == SelectionMode::adaptive && report.selection_rounds < selection.largest_rounds;
    const double root = in_time || may_release ? root_of(decrease, state) : 0.0;
    auto& known = state.rest.error;
    known.follow(root);
    report.error_estimate = known.bound(numbers.error_by_indicator, scene.internals.rest);
    const bool small = in_time && (report.error_estimate <= allowed || selection.mode != SelectionMode::adaptive);
    const double times = first_look && selected_before == 0 ? numbers.too_large_bonded : numbers.too_large;
    const bool large = !in_time && (release_rest || is_too_large(root, allowed, times));
    const auto estimate = [&] {
      const auto error = tie_error<dim>(parts, law_, state, cluster, violations, load, prescribed);
      report.estimate_solves += error.linear_solves;
      report.newton.krylov_iterations += error.krylov_iterations;
      report.newton.failed_solves += !error.known;
      report.cost.add(error.cost);
      report.error_estimate =
          relative_error(model_.structure(), state.displacement, error, known_energy, numbers.largest_error);
      // What a solve leaves out may be the error: then the decreases tell, of which it is no more than a multiple.
      if (!error.known)
        report.error_estimate = std::max(report.error_estimate, numbers.error_by_indicator * root_of(decrease, state));
      if (in_time) known.learn(report.error_estimate);
    };
    if (large)
      report.error_estimate = beside_what_follows(root);
    else if (!small)
      estimate();
    if (narrate_round) {
      const double told = large ? std::numeric_limits<double>::quiet_NaN() : report.error_estimate;
      narrate_round(report.selection_rounds, count_selected(model_, state), told);
    }
    // Where forces differ by orders of magnitude, as from the foot to the top of a tall wall, a rough round may be far
    // from any solution where they are small. Releasing points lowers the error: one that grows is not believed.
    const bool grown = large ? root > root_before : report.error_estimate > estimate_before;
    if (grown && wanted > tolerance) {
      wanted = std::max(tolerance, numbers.share_of_violation * wanted);
      continue;
    }
    root_before = root;
    estimate_before = large ? std::numeric_limits<double>::infinity() : report.error_estimate;
    bool more = false;
    if ((release_rest && release_all(model_, law_, state)) || (first_look && release_mortar(model_, law_, state))) {
      more = true;
      wanted = tolerance;
    } else if ((large || report.error_estimate > allowed) && may_release) {
      const auto released = release(model_, law_, cluster, decrease, state);
      more = released > 0;
      if (more) known = {};
      if (more)
        wanted = std::clamp(numbers.share_of_violation * violations.largest, tolerance, numbers.coarsest_tolerance);
      suffices = more && numbers.error_of_remainder * root_of_rest(decrease, state) <= allowed;
      const auto most = selection.largest_share * static_cast<double>(model_.points().total());
      // The next round tends to release as many again: better all at once than a round that is thrown away.
      if (static_cast<double>(count_selected(model_, state) + released) > most && release_all(model_, law_, state)) {
        more = true;
        wanted = tolerance;
      }
    }
    if (!more) {
      if (large) estimate();
      if (wanted <= tolerance &&
          release_loose(state, load, cluster, violations.largest_normal, report, may_release) == 0)
        return report;
      wanted = tolerance;
    }
  }
}

/// Takes cohesion and tension strength from points that opened or slipped; false when none did.
template <int dim>
bool AdaptiveStep<dim>::break_points(ContactState& state) const {
  const auto gap = stone_gaps(state);
  long long broken = 0;
  for (int k = 0; k < model_.points().size(); ++k) {
    if (!state.selected[k] || state.broken[k] || (law_[k].cohesion == 0 && law_[k].tension == 0)) continue;
    const auto f = force_at<dim>(state.lambda, k);
    const double sigma = model_.local_stiffness()[k];
    double slip = 0;
    for (int c = 1; c < dim; ++c) {
      const double origin = state.slip_origin.empty() ? 0.0 : state.slip_origin[dim * k + c];
      slip += std::abs(gap[dim * k + c] - origin);
    }
    double q = 0;
    for (int c = 1; c < dim; ++c) q += f[c] * f[c];
    q = std::sqrt(q);
    const bool opened = f[0] - sigma * gap[dim * k] <= -law_[k].tension;
    const bool slipped = q + sigma * slip > friction_bound(law_[k], f[0]);
    if (!opened && !slipped) continue;
    state.broken[k] = 1;
    broken += k < model_.points().owned();
  }
  return total_over_ranks(*model_.structure().comm(), broken) > 0;
}

template <int dim>
StepReport AdaptiveStep<dim>::solve(ContactState& state, const std::vector<double>& load,
                                    const std::vector<double>& prescribed) {
  auto report = solve_unbroken(state, load, prescribed);
  while (report.newton.outcome == NewtonOutcome::converged && model_.brittle() && break_points(state)) {
    const auto again = solve_unbroken(state, load, prescribed);
    report.add(again);
  }
  if (report.newton.outcome != NewtonOutcome::converged) return report;
  if (state.slip_origin.empty()) return report;
  const auto gap = stone_gaps(state);
  for (int k = 0; k < model_.points().size(); ++k)
    for (int c = 1; c < dim; ++c) state.slip_origin[dim * k + c] = gap[dim * k + c];
  return report;
}

template class AdaptiveStep<2>;

}  // namespace voussoir

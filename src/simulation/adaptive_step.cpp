#include "simulation/adaptive_step.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>

#include "joints/tractions.hpp"
#include "linalg/local_view.hpp"
#include "selection/marking.hpp"
#include "simulation/phase.hpp"

namespace voussoir {
namespace {

// A round whose points will be released is not worth more accuracy than a tenth of what is wrong with them,
// nor less than a percent of the forces.
constexpr double share_of_violation = 0.1, coarsest_tolerance = 1e-2;
// Violations below this multiple of the solver's tolerance are its noise.
constexpr double noise = 10;

template <class T>
T total(const Teuchos::Comm<int>& comm, T mine) {
  T all(0);
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all;
}

template <class T>
T largest(const Teuchos::Comm<int>& comm, T mine) {
  T all(0);
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(all));
  return all;
}

template <int dim>
Vector<dim> force_at(const PointField& lambda, int k) {
  Vector<dim> f;
  std::copy_n(lambda.begin() + dim * k, dim, f.begin());
  return f;
}

}  // namespace

template <int dim>
AdaptiveStep<dim>::AdaptiveStep(const Model<dim>& model) : model_(model), solver_(model.scene().solver) {}

template <int dim>
ContactState AdaptiveStep<dim>::initial_state() const {
  ContactState state;
  const int points = model_.points().size();
  state.displacement.assign(static_cast<std::size_t>(dim) * model_.structure().nodes(), 0.0);
  state.lambda.assign(static_cast<std::size_t>(dim) * points, 0.0);
  state.slip_origin = state.lambda;
  state.selected.assign(points, 0);
  // Open joints cannot begin bonded.
  const auto& gap = model_.initial_gap();
  for (std::size_t k = 0; k < gap.size(); ++k)
    state.selected[k] = gap[k] > 0 || model_.scene().selection.mode == SelectionMode::all;
  state.broken.assign(points, 0);
  return state;
}

template <int dim>
std::vector<double> AdaptiveStep<dim>::residual(const ContactState& state, const std::vector<double>& load) const {
  std::vector<double> r;
  model_.structure().apply_stiffness(state.displacement, r);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] -= load[i];
  add_contact_forces(model_.points(), {}, state.lambda, -1.0, r);
  return r;
}

template <int dim>
double AdaptiveStep<dim>::elastic_energy(const std::vector<double>& u) const {
  std::vector<double> ku;
  model_.structure().apply_stiffness(u, ku);
  double energy = 0;
  for (int i = 0; i < dim * model_.structure().owned_nodes(); ++i) energy += u[i] * ku[i] / 2;
  return total(*model_.structure().comm(), energy);
}

template <int dim>
std::vector<PointLaw> AdaptiveStep<dim>::current_law(const ContactState& state) const {
  auto law = model_.law();
  for (std::size_t k = 0; k < law.size(); ++k)
    if (state.broken[k]) law[k].cohesion = law[k].tension = 0;
  return law;
}

template <int dim>
long long AdaptiveStep<dim>::count_selected(const ContactState& state) const {
  const auto owned = state.selected.begin() + model_.points().owned();
  return total(*model_.structure().comm(), static_cast<long long>(std::count(state.selected.begin(), owned, 1)));
}

/// Predicted energy decrease of each tied point, and the relative error its sum stands for.
template <int dim>
double AdaptiveStep<dim>::estimate(const ContactState& state, const std::vector<int>& cluster,
                                   std::vector<double>& eta) const {
  const auto& points = model_.points();
  eta.assign(points.owned(), 0.0);
  double largest_force = 0;
  for (int k = 0; k < points.owned(); ++k) largest_force = std::max(largest_force, std::abs(state.lambda[dim * k]));
  const auto& comm = *model_.structure().comm();
  largest_force = largest(comm, largest_force);
  double sum = 0;
  for (int k = 0; k < points.owned(); ++k) {
    const auto& p = points.points()[k];
    if (cluster[p.node_i] != cluster[p.node_j]) continue;
    const double r = violation(law_[k], force_at<dim>(state.lambda, k));
    if (r <= noise * model_.scene().newton.tolerance * largest_force) continue;
    eta[k] = r * r / (2 * model_.local_stiffness()[k]);
    sum += eta[k];
  }
  const double energy = std::max(elastic_energy(state.displacement), known_energy);
  sum = total(comm, sum);
  return energy > 0 ? std::sqrt(sum / energy) : 0.0;
}

template <int dim>
double AdaptiveStep<dim>::largest_violation(const ContactState& state, const std::vector<double>& eta) const {
  double worst = 0, force = 0;
  for (std::size_t k = 0; k < eta.size(); ++k) {
    worst = std::max(worst, std::sqrt(2 * eta[k] * model_.local_stiffness()[k]));
    force = std::max(force, std::abs(state.lambda[dim * k]));
  }
  const auto& comm = *model_.structure().comm();
  force = largest(comm, force);
  return force > 0 ? largest(comm, worst) / force : 0.0;
}

/// Selects the marked points, or their whole joints; false when nothing new was selected.
template <int dim>
bool AdaptiveStep<dim>::release(ContactState& state, const std::vector<int>& cluster,
                                const std::vector<double>& eta) const {
  const auto& points = model_.points();
  const auto& parameters = model_.scene().selection;
  const double share = parameters.error_tolerance > 0 ? parameters.bulk : 1.0;
  auto marked = mark_bulk(eta, share, *model_.structure().comm());
  std::vector<double> flag(points.size(), 0.0);
  for (int k = 0; k < points.owned(); ++k) flag[k] = marked[k];
  points.exchange().update(flag, 1);
  // A marked point that is selected already is tied by others at its vertex: they must go.
  std::vector<char> vertex(model_.structure().nodes(), 0), joint(points.joints().size(), 0);
  for (int k = 0; k < points.size(); ++k) {
    if (flag[k] == 0) continue;
    joint[points.points()[k].joint] = 1;
    if (state.selected[k]) vertex[cluster[points.points()[k].node_i]] = 1;
  }
  long long released = 0;
  for (int k = 0; k < points.owned(); ++k) {
    const auto& p = points.points()[k];
    const bool tied = cluster[p.node_i] == cluster[p.node_j];
    const bool chosen = flag[k] != 0 || (parameters.whole_joints && joint[p.joint]) ||
                        (tied && vertex[cluster[p.node_i]]);
    if (!chosen || state.selected[k]) continue;
    state.selected[k] = 1;
    ++released;
  }
  std::vector<double> selected(state.selected.begin(), state.selected.end());
  points.exchange().update(selected, 1);
  points.exchange().update(state.lambda, dim);
  for (int k = 0; k < points.size(); ++k) {
    if (selected[k] != 0 && !state.selected[k]) state.selected[k] = 1;
    if (!state.selected[k]) continue;
    // Start from the nearest admissible force.
    const double normal = project_normal(law_[k], state.lambda[dim * k]);
    Vector<dim - 1> q;
    std::copy_n(state.lambda.begin() + dim * k + 1, dim - 1, q.begin());
    q = project_tangential(q, friction_bound(law_[k], normal));
    state.lambda[dim * k] = normal;
    std::copy_n(q.begin(), dim - 1, state.lambda.begin() + dim * k + 1);
  }
  return total(*model_.structure().comm(), released) > 0;
}

/// Selects every point; false when all were selected already.
template <int dim>
bool AdaptiveStep<dim>::select_all(ContactState& state) const {
  const bool more = count_selected(state) < model_.points().total();
  std::fill(state.selected.begin(), state.selected.end(), 1);
  return more;
}

template <int dim>
StepReport AdaptiveStep<dim>::solve_unbroken(ContactState& state, const std::vector<double>& load,
                                             const std::vector<double>& prescribed) {
  const auto& scene = model_.scene();
  const typename ContactProblem<dim>::Parts parts{model_.structure(),       model_.points(), model_.continuum(),
                                                  model_.held(),            model_.local_stiffness(),
                                                  model_.initial_gap(),     scene.preconditioner, solver_};
  StepReport report;
  law_ = current_law(state);
  const bool everything = scene.selection.mode == SelectionMode::all;
  double tolerance = scene.newton.tolerance, wanted = tolerance;
  const long long selected_before = count_selected(state);
  // With nothing selected yet, a first look needs no more than the violations it is to show.
  if (selected_before == 0 && scene.selection.mode != SelectionMode::bonded) wanted = 1e-4;
  const ContactState before = state;
  bool from_before = true;
  const PointField known_gap = gaps(state.displacement);
  for (;; ++report.selection_rounds) {
    ContactProblem<dim> problem(parts, state, law_, load, prescribed);
    ContactSolver newton(problem, scene.newton, state.fast_way);
    newton.narrate = narrate;
    const auto x = problem.unknowns(state.displacement);
    NewtonReport solved;
    {
      Phase phase("contact");
      const bool moving = from_before && selected_before > 0;
      solved = newton.solve(*x, state.lambda, wanted, moving ? &known_gap : nullptr);
    }
    report.newton.add(solved);
    problem.space().scatter(*x, state.displacement);
    report.largest_clusters = problem.map()->getGlobalNumElements() / dim;
    if (solved.outcome != NewtonOutcome::converged) {
      if (scene.selection.mode == SelectionMode::adaptive && select_all(state)) {
        // Joints that were held together may be what left no way: resolve them all before giving up.
        state.displacement = before.displacement;
        state.lambda = before.lambda;
        wanted = tolerance;
        from_before = true;
        if (narrate_round) narrate_round(report.selection_rounds, count_selected(state), 0.0);
        continue;
      }
      problem.space().scatter(newton.mechanism(), mechanism_);
      return report;
    }
    from_before = false;
    Phase phase("selection");
    std::vector<double> r, eta;
    model_.structure().apply_stiffness(state.displacement, r);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] -= load[i];
    const auto& cluster = problem.space().cluster();
    recover_tied_forces(model_.structure(), model_.points(), cluster, model_.held(), r, state.lambda);
    model_.points().exchange().update(state.lambda, dim);
    report.error_estimate = estimate(state, cluster, eta);
    const auto selected = count_selected(state);
    if (narrate_round) narrate_round(report.selection_rounds, selected, report.error_estimate);
    bool more = false;
    double violated = largest_violation(state, eta);
    if (everything && selected_before == 0 && report.selection_rounds == 0) {
      std::fill(state.selected.begin(), state.selected.end(), 1);
      release(state, cluster, std::vector<double>(model_.points().owned(), 0.0));
      more = true;
      wanted = tolerance;
    } else if (scene.selection.mode == SelectionMode::adaptive &&
               report.error_estimate > scene.selection.error_tolerance &&
               report.selection_rounds < scene.selection.largest_rounds) {
      more = release(state, cluster, eta);
      const double share = static_cast<double>(count_selected(state)) / static_cast<double>(model_.points().total());
      if (share > scene.selection.largest_share && select_all(state)) {
        release(state, cluster, std::vector<double>(model_.points().owned(), 0.0));  // admissible forces for all
        more = true;
        violated = 0;
      }
      if (more) wanted = std::clamp(share_of_violation * violated, tolerance, coarsest_tolerance);
    }
    if (!more) {
      if (wanted <= tolerance) return report;
      wanted = tolerance;
    }
  }
}

/// Takes cohesion and tension strength from points that opened or slipped; false when none did.
template <int dim>
bool AdaptiveStep<dim>::break_points(ContactState& state) const {
  const auto gap = gaps(state.displacement);
  long long broken = 0;
  for (int k = 0; k < model_.points().size(); ++k) {
    if (!state.selected[k] || state.broken[k] || (law_[k].cohesion == 0 && law_[k].tension == 0)) continue;
    const auto f = force_at<dim>(state.lambda, k);
    const double sigma = model_.local_stiffness()[k];
    double slip = 0;
    for (int c = 1; c < dim; ++c) slip += std::abs(gap[dim * k + c] - state.slip_origin[dim * k + c]);
    double q = 0;
    for (int c = 1; c < dim; ++c) q += f[c] * f[c];
    q = std::sqrt(q);
    const bool opened = f[0] - sigma * gap[dim * k] <= -law_[k].tension;
    const bool slipped = q + sigma * slip > friction_bound(law_[k], f[0]);
    if (!opened && !slipped) continue;
    state.broken[k] = 1;
    broken += k < model_.points().owned();
  }
  return total(*model_.structure().comm(), broken) > 0;
}

template <int dim>
StepReport AdaptiveStep<dim>::solve(ContactState& state, const std::vector<double>& load,
                                    const std::vector<double>& prescribed) {
  auto report = solve_unbroken(state, load, prescribed);
  while (report.newton.outcome == NewtonOutcome::converged && model_.brittle() && break_points(state)) {
    const auto again = solve_unbroken(state, load, prescribed);
    report.newton.add(again.newton);
    report.selection_rounds += again.selection_rounds;
    report.error_estimate = again.error_estimate;
  }
  if (report.newton.outcome != NewtonOutcome::converged) return report;
  const auto gap = gaps(state.displacement);
  for (int k = 0; k < model_.points().size(); ++k)
    for (int c = 1; c < dim; ++c) state.slip_origin[dim * k + c] = gap[dim * k + c];
  return report;
}

template class AdaptiveStep<2>;

}  // namespace voussoir

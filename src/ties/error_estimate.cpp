#include "ties/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/check.hpp"
#include "base/components.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "nonlinear/point_update.hpp"

namespace voussoir {
namespace {

/// Releases every point at the vertex of a violating one: each of them ties its nodes.
void release_violating(const ContactPoints& points, const std::vector<int>& cluster, const TiedViolations& violations,
                       std::vector<char>& selected) {
  std::vector<double> violates(points.size(), 0.0);
  for (int k = 0; k < points.owned(); ++k) violates[k] = violations.force[k] > 0;
  points.exchange().update(violates, 1);
  std::vector<char> vertex(cluster.size(), 0);
  for (int k = 0; k < points.size(); ++k)
    if (violates[k] > 0) vertex[cluster_of_tied(points.points()[k], cluster)] = 1;
  std::vector<double> released(selected.begin(), selected.end());
  for (int k = 0; k < points.owned(); ++k) {
    const auto& p = points.points()[k];
    if (is_tied(p, cluster) && vertex[cluster_of_tied(p, cluster)]) released[k] = 1;
  }
  points.exchange().update(released, 1);
  for (int k = 0; k < points.size(); ++k) selected[k] = released[k] > 0;
}

/// By how much a tied point violates its law [N]; one that is open is to bear nothing.
template <int dim>
double off_its_law(const PointLaw& law, const double* lambda, bool is_open) {
  Vector<dim> f;
  std::copy_n(lambda, dim, f.begin());
  return is_open ? norm(f) : violation(law, f);
}

}  // namespace

double largest_normal_force(const Model& model, const PointField& lambda) {
  const int dim = model.components();
  VOUSSOIR_EXPECT(is_of_points(model, lambda) && "lambda: of points");
  double mine = 0;
  for (int k = 0; k < model.points().owned(); ++k) mine = std::max(mine, std::abs(lambda[dim * k]));
  return largest_over_ranks(*model.structure().comm(), mine);
}

TiedViolations tied_violations(const Model& model, const PointLaws& law, const ContactState& state,
                               const std::vector<int>& cluster) {
  const int dim = model.components();
  VOUSSOIR_EXPECT(is_per_point(model, law) && "laws: per point");
  VOUSSOIR_EXPECT(cluster.size() == static_cast<std::size_t>(model.structure().nodes()) && "cluster: per node copy");
  const auto& points = model.points();
  const auto& comm = *model.structure().comm();
  const auto& numbers = model.settings().internals.step;
  const double tolerance = numbers.noise * model.settings().newton.tolerance;
  TiedViolations v;
  v.force.assign(points.owned(), 0.0);
  double worst = 0;
  const double force = v.largest_normal = largest_normal_force(model, state.lambda);
  v.noise = std::max(tolerance, numbers.least_noise) * force;
  const auto open = open_points(model);
  for (int k = 0; k < points.owned(); ++k) {
    if (!is_tied(points.points()[k], cluster)) continue;
    // An open point that is tied bears nothing.
    const bool is_open = !open.empty() && open[k];
    const double r = with_components(
        dim, [&](auto n) { return off_its_law<n>(law[k], &state.lambda[static_cast<std::size_t>(n) * k], is_open); });
    if (r <= tolerance * force) continue;
    v.force[k] = r;
    worst = std::max(worst, r);
  }
  worst = largest_over_ranks(comm, worst);
  v.largest = force > 0 ? worst / force : 0.0;
  return v;
}

std::vector<double> predicted_decrease(const TiedViolations& violations, const std::vector<double>& local_stiffness) {
  VOUSSOIR_EXPECT(local_stiffness.size() >= violations.force.size() && "local stiffness: of every owned point");
  std::vector<double> eta;
  for (std::size_t k = 0; k < violations.force.size(); ++k)
    eta.push_back(violations.force[k] * violations.force[k] / (2 * local_stiffness[k]));
  return eta;
}

double root_of_decreases(const std::vector<double>& predicted_decrease, double energy, double largest,
                         const Teuchos::Comm<int>& comm) {
  VOUSSOIR_EXPECT(largest > 0 && "largest error: more than none");
  const double sum = total_over_ranks(comm, std::accumulate(predicted_decrease.begin(), predicted_decrease.end(), 0.0));
  return sum == 0 ? 0.0 : sum < energy ? std::sqrt(sum / energy) : largest;
}

std::vector<char> open_points(const Model& model) {
  std::vector<char> open;
  for (const double gap : model.initial_gap()) open.push_back(gap > 0);
  return open;
}

TieError tie_error(const ContactProblem::Parts& parts, const ContactProblem::Asked& asked, const ContactState& state,
                   const std::vector<int>& cluster, const TiedViolations& violations, Strength strength) {
  if (violations.largest == 0) return {};
  auto released = state.selected;
  release_violating(parts.points, cluster, violations, released);
  ContactProblem problem(parts, released, asked);
  const auto x = problem.unknowns(state.displacement);
  const auto b = Teuchos::rcp(new TpetraVector(problem.map()));
  const auto e = Teuchos::rcp(new TpetraVector(problem.map()));
  PointField gap, trial, forces;
  std::vector<double> bound;
  std::vector<PointStiffness> resistance;
  problem.evaluate(*x, *b, gap);
  trial_forces(problem, state.lambda, gap, 1.0, trial);
  const CurrentLaws laws(problem, strength, state.lambda, gap);
  friction_bounds(problem, laws, trial, bound);
  project(problem, laws, trial, bound, forces);
  const int dim = problem.components();
  for (std::size_t i = 0; i < trial.size(); i += dim) trial[i] += violations.noise;
  for (double& limit : bound) limit += violations.noise;
  resistances(problem, laws, trial, bound, 1.0, resistance);
  problem.subtract_contact_forces(forces, *b);
  b->scale(-1);
  TieError error;
  const auto solved = problem.solve(resistance, 1.0, b, e, {parts.internals.step.first_look});
  error.krylov_iterations = solved.iterations;
  error.known = solved.converged;
  error.linear_solves = 1;
  error.cost = problem.cost();
  problem.space().scatter(*e, error.change);
  return error;
}

double relative_error(const BlockSystem& structure, const std::vector<double>& displacement, const TieError& error,
                      double known_energy, double largest) {
  VOUSSOIR_EXPECT(largest > 0 && "largest error: more than none");
  VOUSSOIR_EXPECT(!std::isnan(known_energy) && "known energy: a number");
  VOUSSOIR_EXPECT((error.change.empty() || error.change.size() == displacement.size()) &&
                  "change: of node copies, or none");
  if (error.linear_solves == 0) return 0.0;  // a rank without stones has no change either way
  auto without = structure.deformation(displacement);
  for (std::size_t i = 0; i < without.size(); ++i) without[i] += error.change[i];
  const double changed = structure.elastic_energy(error.change);
  const double energy = std::max(structure.elastic_energy(without), known_energy);
  return std::sqrt(changed) < largest * std::sqrt(energy) ? std::sqrt(changed / energy) : largest;
}

}  // namespace voussoir

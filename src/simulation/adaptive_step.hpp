// One load step: solve with the points selected so far, look at what the tied points carry, release those that
// matter, repeat until the error estimate of what stays bonded is small enough.
#pragma once

#include <functional>

#include "nonlinear/contact_solver.hpp"
#include "simulation/contact_problem.hpp"
#include "simulation/model.hpp"
#include "simulation/tie_balance.hpp"

namespace voussoir {

struct StepReport {
  NewtonReport newton;
  int selection_rounds = 0;
  int estimate_solves = 0;    ///< linear solves for error estimates, besides those of newton
  double error_estimate = 0;  ///< [-] relative, energy norm
  double tied_share = 0;  ///< [-] largest share of a loose stone's load that ties bear, where it could not be released
  int tied_block = -1;    ///< that stone; -1 where no stone is left loose
  long long largest_clusters = 0;  ///< nodes that were unknowns in the last round
  SystemCost cost;

  /// Goes on with another solution of the same step, which stands.
  void add(const StepReport& again) {
    newton.add(again.newton);
    selection_rounds += again.selection_rounds;
    estimate_solves += again.estimate_solves;
    error_estimate = again.error_estimate;
    tied_share = again.tied_share;
    tied_block = again.tied_block;
    largest_clusters = again.largest_clusters;
    cost.add(again.cost);
  }
};

template <int dim>
class AdaptiveStep {
 public:
  explicit AdaptiveStep(const Model<dim>&);

  std::function<void(const NewtonProgress&)> narrate;
  /// The estimate is no number where none was needed to go on.
  std::function<void(int round, long long selected, double error_estimate)> narrate_round;
  /// Energy of the structure that the estimate may refer to [J], where displacement does not tell: in time steps.
  double known_energy = 0;
  /// In time steps: ties hold what has moved where it is, so their forces go on from what they were.
  bool in_time = false;
  /// [N] Loads on the stones, where those given to solve() hold inertia too; else null.
  const std::vector<double>* own_load = nullptr;

  /// State before the first load step: nothing has moved; everything or nothing is selected, as the scene asks.
  ContactState initial_state() const;

  /// Carries the state through one load step. On anything but convergence the state is meaningless but for
  /// displacement() of a collapse; keep a copy.
  StepReport solve(ContactState&, const std::vector<double>& load, const std::vector<double>& prescribed);

  /// Nodal residual K u - f - B^T lambda of each block alone [N]: reactions at held nodes, else zero to tolerance.
  std::vector<double> residual(const ContactState&, const std::vector<double>& load) const;
  /// Motion of a collapse on node copies, largest component 1.
  const std::vector<double>& mechanism() const { return mechanism_; }
  /// Gap and slip of every point [m].
  PointField gaps(const std::vector<double>& displacement) const { return model_.gaps(displacement); }
  /// Of the stones, without the mortar between them.
  PointField stone_gaps(const ContactState& s) const { return model_.gaps(s.displacement, s.lambda); }

 private:
  /// K u - f of each block alone [N]: what joints and supports bear.
  std::vector<double> borne_by_joints(const ContactState&, const std::vector<double>& load) const;
  double energy_of(const ContactState&) const;
  double root_of(const std::vector<double>& decrease, const ContactState&) const;
  double root_of_violations(const ContactState&, const std::vector<int>& cluster) const;
  bool looks_first(long long selected) const;
  double root_of_rest(std::vector<double> decrease, const ContactState&) const;
  long long release_loose(ContactState&, const std::vector<double>& load, const std::vector<int>& cluster,
                          double largest_normal, StepReport&, bool may_release);
  StepReport solve_unbroken(ContactState&, const std::vector<double>& load, const std::vector<double>& prescribed);
  bool solve_round(const typename ContactProblem<dim>::Parts&, ContactState&, const std::vector<double>& load,
                   const std::vector<double>& prescribed, double tolerance, const PointField* known_gap,
                   const PointField& force_before, std::vector<int>& cluster, StepReport&);
  bool break_points(ContactState&) const;
  PointLaws current_law(const ContactState&) const;

  const Model<dim>& model_;
  LinearSolver solver_;
  PointLaws law_;
  TieCriterion ties_;
  std::vector<double> borne_;  ///< [N] by joints and supports, as the last round left it
  std::vector<double> mechanism_;
};

extern template class AdaptiveStep<2>;

}  // namespace voussoir

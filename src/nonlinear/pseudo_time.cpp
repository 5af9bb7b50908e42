#include "nonlinear/pseudo_time.hpp"

#include <algorithm>
#include <limits>

#include "linalg/local_view.hpp"
#include "nonlinear/active_set.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/rigid_mechanism.hpp"

namespace voussoir {
namespace {

/// A problem whose nodes move against a drag from where they were.
class Dragged : public NonlinearProblem {
 public:
  /// @param drag  relative to the proximal weights
  Dragged(NonlinearProblem& problem, const TpetraVector& from, double drag)
      : problem_(problem), from_(from), drag_(drag) {}

  Teuchos::RCP<const TpetraMap> map() const override { return problem_.map(); }
  int components() const override { return problem_.components(); }
  int points() const override { return problem_.points(); }
  int owned_points() const override { return problem_.owned_points(); }
  const std::vector<char>& selected() const override { return problem_.selected(); }
  const PointLaws& law() const override { return problem_.law(); }
  const SofteningPoints* softening() const override { return problem_.softening(); }
  const std::vector<double>& local_stiffness() const override { return problem_.local_stiffness(); }
  const std::vector<PointCompliance>& compliance() const override { return problem_.compliance(); }
  const PointField& slip_origin() const override { return problem_.slip_origin(); }
  void evaluate(const TpetraVector& x, TpetraVector& r, PointField& gap) override {
    problem_.evaluate(x, r, gap);
    TpetraVector moved(x, Teuchos::Copy);
    moved.update(-1.0, from_, 1.0);
    add_drag(moved, r);
  }
  void evaluate_direction(const TpetraVector& d, TpetraVector& y, PointField& gap) override {
    problem_.evaluate_direction(d, y, gap);
    add_drag(d, y);
  }
  void subtract_contact_forces(const PointField& lambda, TpetraVector& r) override {
    problem_.subtract_contact_forces(lambda, r);
  }
  const std::vector<double>& proximal_weight() const override { return problem_.proximal_weight(); }
  LinearSolveResult solve(const std::vector<PointStiffness>& stiffness, double proximal_scale,
                          const Teuchos::RCP<TpetraVector>& b, const Teuchos::RCP<TpetraVector>& d,
                          const SolveRequest& request) override {
    return problem_.solve(stiffness, proximal_scale + drag_, b, d, request);
  }
  double round_off() const override { return problem_.round_off(); }
  double force_scale() const override { return problem_.force_scale(); }
  double length_scale() const override { return problem_.length_scale(); }

 private:
  void add_drag(const TpetraVector& motion, TpetraVector& r) const {
    const auto& weight = problem_.proximal_weight();
    const double* d = local_view(motion);
    double* value = local_view_to_write(r);
    for (std::size_t i = 0; i < weight.size(); ++i) value[i] += drag_ * weight[i] * d[i];
  }

  NonlinearProblem& problem_;
  const TpetraVector& from_;
  const double drag_;
};

}  // namespace

PseudoTime::PseudoTime(NonlinearProblem& problem, const NewtonParameters& parameters, const MethodParameters& methods,
                       Strength strength)
    : problem_(problem),
      parameters_(parameters),
      methods_(methods),
      strength_(strength),
      mechanism_(Teuchos::rcp(new TpetraVector(problem.map()))),
      imbalance_(Teuchos::rcp(new TpetraVector(problem.map()))) {}

/// Residuals of the structure itself, without drag; leaves the imbalance and the gaps.
double PseudoTime::measure(const TpetraVector& x, const PointField& lambda, NewtonReport& report) {
  scale_ = force_scale(problem_, lambda);
  return judge_state(problem_, strength_, x, lambda, *imbalance_, gap_, report);
}

/// Does the last motion, along which the imbalance has stayed, go on for ever? Far along it forces and imbalance must
/// be as they are here: nothing stiffens, opens or closes. The test does not wait until round-off (Young's modulus x
/// motion) hides the imbalance.
bool PseudoTime::leads_nowhere(const TpetraVector& x, const TpetraVector& from, const PointField& lambda) {
  const auto& numbers = methods_.pseudo_time;
  mechanism_->update(1.0, x, -1.0, from, 0.0);
  const double size = mechanism_->normInf(), far = numbers.run_away * problem_.length_scale();
  if (!(size > 0)) return false;
  mechanism_->scale(1 / size);
  if (size >= far) return true;
  const double allowance = numbers.unchanged * imbalance_->normInf();
  if (!parameters_.has_inertia && is_rigid_mechanism(problem_, CurrentLaws(problem_, strength_, lambda, gap_),
                                                     *mechanism_, lambda, gap_, far, allowance))
    return true;
  TpetraVector end(x, Teuchos::Copy), there(problem_.map());
  PointField gap;
  end.update(far, *mechanism_, 1.0);
  problem_.evaluate(end, there, gap);
  problem_.subtract_contact_forces(lambda, there);
  there.update(-1.0, *imbalance_, 1.0);
  return there.normInf() <= allowance &&
         contact_residual(problem_, CurrentLaws(problem_, strength_, lambda, gap), lambda, gap) <= allowance;
}

void PseudoTime::integrate(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap,
                           int largest_solves, NewtonReport& report) {
  const auto& numbers = methods_.pseudo_time;
  const int last = report.newton_iterations + largest_solves;
  double drag = numbers.drag, size = measure(x, lambda, report);
  for (bool refused = false; size > tolerance;) {
    if (report.newton_iterations >= last) return report.fail("the largest number of linear solves was reached");
    if (problem_.carry(x, tolerance * scale_)) measure(x, lambda, report);
    const TpetraVector from(x, Teuchos::Copy);
    const PointField forces = lambda;
    Dragged dragged(problem_, from, drag);
    ActiveSet active(dragged, ActiveSetUse::in_time, methods_, methods_.active_set.patience, strength_);
    active.watch = watch;
    const auto end = active.solve(x, lambda, std::max(tolerance, numbers.accuracy * std::min(size, 1.0)),
                                  last - report.newton_iterations, known_gap, report);
    if (report.stopped) return;
    if (end != ActiveSetEnd::arrived) {
      Tpetra::deep_copy(x, from);
      lambda = forces;
      drag *= numbers.factor;
      if (end == ActiveSetEnd::refused && std::exchange(refused, true)) {
        report.no_way_on = true;
        return report.fail("a linear system has no solution");
      }
      continue;
    }
    known_gap = nullptr;
    refused = false;
    ++report.outer_iterations;
    drag /= numbers.factor;
    const double before = std::exchange(size, measure(x, lambda, report));
    // Stones in flight collide: where forces do not obey the contact law, a motion proves nothing, however far it went.
    // Nor does one along which the imbalance falls, as when supports have moved.
    const bool stays = size > std::max(tolerance, numbers.unchanged * before);
    if (stays && report.complementarity < numbers.believable && leads_nowhere(x, from, lambda)) {
      report.outcome = NewtonOutcome::collapse;
      report.reason = "the structure moves without end: no equilibrium exists under this load";
      return;
    }
  }
  report.outcome = NewtonOutcome::converged;
}

}  // namespace voussoir

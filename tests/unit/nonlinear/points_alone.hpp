// Contact points for tests of what loops over them.
#pragma once

#include <stdexcept>

#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir::test {

/// Points alone, without a structure between them.
class Points : public NonlinearProblem {
 public:
  Points(int components, int points) : components_(components), selected_(points, 1), law_(points, PointLaw{0.5}) {
    for (int k = 0; k < points; ++k) stiffness_.push_back(1 + 0.25 * (k % 5));
    origin_.assign(std::size_t(components) * points, 0.0);
  }
  int components() const override { return components_; }
  int points() const override { return int(selected_.size()); }
  int owned_points() const override { return points(); }
  const std::vector<char>& selected() const override { return selected_; }
  const PointLaws& law() const override { return law_; }
  const std::vector<double>& local_stiffness() const override { return stiffness_; }
  const PointField& slip_origin() const override { return origin_; }
  Teuchos::RCP<const TpetraMap> map() const override { return {}; }
  void evaluate(const TpetraVector&, TpetraVector&, PointField&) override { absent(); }
  void evaluate_direction(const TpetraVector&, TpetraVector&, PointField&) override { absent(); }
  void subtract_contact_forces(const PointField&, TpetraVector&) override { absent(); }
  const std::vector<double>& proximal_weight() const override { return stiffness_; }
  LinearSolveResult solve(const std::vector<PointStiffness>&, double, const Teuchos::RCP<TpetraVector>&,
                          const Teuchos::RCP<TpetraVector>&, const SolveRequest&) override {
    absent();
    return {};
  }
  double force_scale() const override { return 1; }
  double length_scale() const override { return 1; }

  int components_;
  std::vector<char> selected_;
  PointLaws law_;
  std::vector<double> stiffness_;
  PointField origin_;

 private:
  static void absent() { throw std::logic_error("points alone have no structure"); }
};

}  // namespace voussoir::test

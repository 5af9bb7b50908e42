// Masonry in space whose every point is selected, on one rank: its own weight, and pushes by shares of it.
#pragma once

#include <memory>
#include <optional>

#include "joints/tractions.hpp"
#include "model/contact_problem.hpp"
#include "nonlinear/contact_solver.hpp"
#include "support/stones_in_space.hpp"

#include <Tpetra_Core.hpp>

namespace voussoir::test {

class MasonryInSpace {
 public:
  static constexpr double young = 20e9, density = 2000, gravity = 9.81;  // [Pa], [kg/m3], [m/s2]

  MasonryInSpace(StonesInSpace stones, double friction, Internals internals = {})
      : ground_(stones.ground),
        internals_(std::move(internals)),
        source_(make_source(std::move(stones.list))),
        structure_(
            *source_, share_out(*source_, *Tpetra::getDefaultComm()), nearly_rigid(),
            [](const Block<3>&) {
              return Material{young, 0.2, density};
            },
            Tpetra::getDefaultComm()),
        points_(*source_, structure_),
        held_(marks_of_ground()),
        local_stiffness_(stiffness_of_points()),
        law_(points_.size(), {friction, 0, 0}),
        solver_(SolverParameters()),
        continuum_(structure_, points_, held_, Teuchos::ParameterList(), internals_.preconditioner),
        displacement_(held_.size()),
        prescribed_(held_.size()),
        lambda_(3 * points_.size()),
        origin_(lambda_.size()) {}

  /// Told of every linear solve; may be empty.
  SolveWatch watch;
  NewtonParameters newton;

  /// The next load step: own weight and a push by a share of it. The first begins as what is bonded. A step that does
  /// not come to rest leaves the state as it was.
  NewtonReport step(const Vector<3>& push) {
    const auto load = forces(push);
    if (first_) begin_bonded(load);
    ContactProblem problem(parts(), std::vector<char>(points_.size(), 1), {law_, origin_, load, prescribed_});
    PointField gap;
    relative_motions(points_, displacement_, gap);
    const auto x = problem.unknowns(displacement_);
    auto lambda = lambda_;
    ContactSolver solver(problem, newton, internals_.methods, fast_);
    solver.watch = watch;
    Damage no_damage;
    const auto report =
        solver.solve({*x, lambda, no_damage}, {newton.tolerance, StrengthIs::falling, first_ ? nullptr : &gap});
    first_ = false;
    if (report.outcome != NewtonOutcome::converged) return report;
    problem.displacement(*x, displacement_);
    lambda_ = lambda;
    relative_motions(points_, displacement_, origin_);
    for (std::size_t at = 0; at < origin_.size(); at += 3) origin_[at] = 0;
    return report;
  }

  /// What ground bears less than all stones weigh and are pushed by, relative to their weight.
  double out_of_balance(const Vector<3>& push) const {
    Vector<3> sum{};
    for (int k = 0; k < points_.size(); ++k)
      for (int a = 0; a < 3; ++a) {
        const auto& p = points_.points()[k];
        const bool i = on_ground(p.shares_i.first()), j = on_ground(p.shares_j.first());
        sum = sum + (lambda_[3 * k + a] * (int(i) - int(j))) * p.axis[a];
      }
    const auto load = forces(push);
    double weight = 0;
    for (std::size_t i = 0; i < load.size(); ++i) {
      sum[i % 3] += load[i];
      weight += i % 3 == 2 ? -load[i] : 0;
    }
    return norm(sum) / weight;
  }
  /// Friction of a point beyond its bound, at most, relative to the largest force.
  double beyond_friction() const {
    double most = 0, largest = 0;
    for (int k = 0; k < points_.size(); ++k) {
      const double q = std::hypot(lambda_[3 * k + 1], lambda_[3 * k + 2]);
      most = std::max(most, q - friction_bound(law_[k], lambda_[3 * k]));
      largest = std::max(largest, lambda_[3 * k]);
    }
    return most / largest;
  }
  /// [N] of a point.
  double largest_force() const { return *std::max_element(lambda_.begin(), lambda_.end()); }
  const std::vector<double>& displacement() const { return displacement_; }
  const PointField& lambda() const { return lambda_; }
  const ContactPoints& points() const { return points_; }
  const Structure<3>& structure() const { return structure_; }

 private:
  bool on_ground(int node) const { return ground_[structure_.blocks()[structure_.block_of_node()[node]].id]; }
  std::vector<char> marks_of_ground() const {
    std::vector<char> held;
    for (int i = 0; i < structure_.nodes(); ++i) held.insert(held.end(), 3, on_ground(i));
    return held;
  }
  /// Plain cells bend by shearing alone, so stones of one cell are nearest to the rigid ones whose limits are known.
  static ModelParameters nearly_rigid() {
    ModelParameters model;
    model.hexahedra = Hexahedra::plain;
    return model;
  }
  /// Of the cells on either side, in series: Young's modulus times their size.
  std::vector<double> stiffness_of_points() const {
    const auto volume = structure_.nodal_volumes();
    std::vector<double> size;
    for (const auto& block : structure_.blocks()) {
      double whole = 0;
      for (int i = 0; i < block.nodes; ++i) whole += volume[block.first_local + i];
      size.push_back(std::cbrt(whole / double(block.mesh.cells.size())));
    }
    std::vector<double> stiffness;
    for (const auto& p : points_.points()) {
      const double i = size[structure_.block_of_node()[p.shares_i.first()]],
                   j = size[structure_.block_of_node()[p.shares_j.first()]];
      stiffness.push_back(2 * young * i * j / (i + j));
    }
    return stiffness;
  }
  std::vector<double> forces(const Vector<3>& push) const {
    const auto volume = structure_.nodal_volumes();
    std::vector<double> f(3 * volume.size(), 0.0);
    for (std::size_t i = 0; i < f.size(); ++i)
      if (!on_ground(int(i / 3))) f[i] = density * gravity * volume[i / 3] * (push[i % 3] - (i % 3 == 2 ? 1 : 0));
    return f;
  }
  ContactProblem::Parts parts() {
    return {structure_, points_, continuum_, held_, local_stiffness_, none_, preconditioner_, internals_, solver_};
  }
  /// The bonded structure, its tied forces cut to what the law admits.
  void begin_bonded(const std::vector<double>& load) {
    ContactProblem bonded(parts(), std::vector<char>(points_.size(), 0), {law_, origin_, load, prescribed_});
    const auto x = bonded.unknowns(displacement_);
    FastWay fast;
    PointField nothing(lambda_.size());
    Damage no_damage;
    ContactSolver(bonded, newton, internals_.methods, fast).solve({*x, nothing, no_damage}, {newton.tolerance});
    bonded.displacement(*x, displacement_);
    std::vector<double> left;
    structure_.internal_forces(displacement_, left);
    for (std::size_t i = 0; i < left.size(); ++i) left[i] -= load[i];
    recover_tied_forces(points_, bonded.space().cluster(), held_, left, lambda_);
    for (int k = 0; k < points_.size(); ++k) {
      const auto lawful = nearest_lawful<3>(law_[k], {lambda_[3 * k], lambda_[3 * k + 1], lambda_[3 * k + 2]});
      std::copy(lawful.begin(), lawful.end(), lambda_.begin() + 3 * k);
    }
  }

  const std::vector<char> ground_;
  const Internals internals_;
  const PreconditionerParameters preconditioner_;
  const std::vector<double> none_;
  std::unique_ptr<BlockSource<3>> source_;
  const Structure<3> structure_;
  const ContactPoints points_;
  const Held held_;
  const std::vector<double> local_stiffness_;
  const PointLaws law_;
  LinearSolver solver_;
  const Continuum continuum_;
  FastWay fast_;
  std::vector<double> displacement_;
  const std::vector<double> prescribed_;
  PointField lambda_, origin_;
  bool first_ = true;
};

}  // namespace voussoir::test

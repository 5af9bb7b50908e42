#include "time/velocity_projection.hpp"

#include <Teuchos_OrdinalTraits.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "base/finite.hpp"
#include "homogenisation/block_solves.hpp"
#include "joints/tractions.hpp"
#include "linalg/local_view.hpp"
#include "linalg/reduce.hpp"
#include "linalg/solver_failure.hpp"
#include "model/handed_over.hpp"

namespace voussoir {
namespace {

Teuchos::RCP<const TpetraMap> map_of_points(const ContactPoints& points,
                                            const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const auto unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new TpetraMap(unknown, static_cast<std::size_t>(points.components()) * points.owned(), 0, comm));
}

}  // namespace

PointField relative_velocities(const ContactPoints& points, const std::vector<double>& velocity) {
  PointField speed;
  relative_motions(points, velocity, speed);
  return speed;
}

/// B M^-1 B^T on the points that are held, nothing on the others.
class VelocityProjection::Impulses : public TpetraOperator {
 public:
  Impulses(const Model& model, const BlockSystem& mass)
      : points_(model.points()),
        map_(map_of_points(model.points(), mass.comm())),
        all_selected_(points_.size(), 1),
        space_(mass, points_, all_selected_, model.held()),
        blocks_(mass, space_, std::vector<char>(mass.local_blocks(), 1)),
        impulse_(space_.map()),
        change_(space_.map()) {
    SystemMatrix matrix(mass, points_, all_selected_, space_);
    matrix.update(std::vector<PointStiffness>(points_.size()), {});
    all_or_none(*mass.comm(), [&] { blocks_.update(matrix.local()); });
  }

  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return map_; }
  Teuchos::RCP<const TpetraMap> getRangeMap() const override { return map_; }

  void hold(std::vector<char> held) { held_ = std::move(held); }

  /// Of all points of this rank.
  const PointField& at_points(const TpetraVector& lambda) const {
    const int dim = points_.components();
    field_.assign(static_cast<std::size_t>(dim) * points_.size(), 0.0);
    std::copy_n(local_view(lambda), dim * points_.owned(), field_.begin());
    points_.exchange().update(field_, dim);
    return field_;
  }

  /// -B^T lambda on node copies [N s].
  const std::vector<double>& of_points(const TpetraVector& lambda) const {
    const int dim = points_.components();
    at_points(lambda);
    nodal_.assign(static_cast<std::size_t>(dim) * space_.cluster().size(), 0.0);
    add_contact_forces(points_, {}, field_, -1.0, nodal_);
    return nodal_;
  }

  /// -M^-1 B^T lambda on node copies [m/s].
  const std::vector<double>& change(const TpetraVector& lambda) const {
    space_.sum(of_points(lambda), impulse_);
    change_.putScalar(0);
    blocks_.add(impulse_, change_, 1.0);
    space_.scatter(change_, nodal_);
    return nodal_;
  }

  void relative(const std::vector<double>& velocity, TpetraVector& speed, double factor) const {
    const int dim = points_.components();
    const auto all = relative_velocities(points_, velocity);
    double* value = local_view_to_write(speed);
    for (int i = 0; i < dim * points_.owned(); ++i) value[i] = held_[i] ? factor * all[i] : 0.0;
  }

  void apply(const TpetraMultiVector& x, TpetraMultiVector& y, Teuchos::ETransp, [[maybe_unused]] double alpha,
             [[maybe_unused]] double beta) const override {
    for (std::size_t j = 0; j < x.getNumVectors(); ++j)
      relative(change(*x.getVector(j)), *y.getVectorNonConst(j), -1.0);
  }

 private:
  const ContactPoints& points_;
  Teuchos::RCP<const TpetraMap> map_;
  std::vector<char> all_selected_, held_;
  MergedSpace space_;
  BlockSolves blocks_;
  mutable TpetraVector impulse_, change_;
  mutable std::vector<double> field_, nodal_;
};

/// The mass that resists an impulse at a point, of its nodes alone.
class VelocityProjection::ByMass : public Preconditioner {
 public:
  ByMass(const Model& model, const BlockSystem& mass) {
    const int dim = model.components();
    resisting_.assign(static_cast<std::size_t>(dim) * model.points().size(), 0.0);
    std::vector<double> along_x(static_cast<std::size_t>(dim) * mass.nodes(), 0.0), weight;
    for (std::size_t i = 0; i < along_x.size(); i += dim) along_x[i] = 1;
    mass.apply_stiffness(along_x, weight);
    const auto mass_at = [&](int node, int c) {
      return model.held()[dim * node + c] ? std::numeric_limits<double>::infinity() : weight[dim * node];
    };
    for (int k = 0; k < model.points().size(); ++k)
      for (int a = 0; a < dim; ++a) {
        const double inverse = model.points().at(k).mobility(a, model.held(), mass_at);
        if (inverse > 0) resisting_[dim * k + a] = 1 / inverse;
      }
  }
  double operator[](int component) const { return resisting_[component]; }
  void apply(const TpetraVector& r, TpetraVector& z) const override {
    const double* right = local_view(r);
    double* value = local_view_to_write(z);
    const auto count = static_cast<int>(r.getLocalLength());
    for (int i = 0; i < count; ++i) value[i] = resisting_[i] * right[i];
  }

 private:
  std::vector<double> resisting_;
};

VelocityProjection::VelocityProjection(const Model& model, const BlockSystem& mass)
    : model_(model), mass_(mass), solver_(model.settings().solver), by_mass_(std::make_shared<ByMass>(model, mass)) {}

VelocityProjection::~VelocityProjection() = default;

double VelocityProjection::mass(int point, int axis) const {
  const int dim = model_.components();
  VOUSSOIR_EXPECT(point >= 0 && point < model_.points().size() && axis >= 0 && axis < dim && "a component of a point");
  return (*by_mass_)[dim * point + axis];
}

VelocityProjection::Impulses& VelocityProjection::impulses() {
  if (impulses_.is_null()) impulses_ = Teuchos::rcp(new Impulses(model_, mass_));
  return *impulses_;
}

/// v -= M^-1 B^T lambda. Returns M dv + B^T lambda.
std::vector<double> VelocityProjection::add(std::vector<double>& velocity, const TpetraVector& lambda) {
  const auto& change = impulses().change(lambda);
  for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] += change[i];
  std::vector<double> of_supports;
  mass_.apply_stiffness(change, of_supports);
  const auto& of_points = impulses().of_points(lambda);
  for (std::size_t i = 0; i < of_supports.size(); ++i) of_supports[i] -= of_points[i];
  return of_supports;
}

JumpImpulses VelocityProjection::apply(std::vector<double>& velocity, const std::vector<char>& held) {
  const int dim = model_.components();
  VOUSSOIR_EXPECT(is_of_nodes(model_, velocity) && all_finite(velocity) && "velocity: of node copies, finite");
  VOUSSOIR_EXPECT(held.size() == static_cast<std::size_t>(dim) * model_.points().size() && "held: of points");
  impulses().hold(held);
  const auto map = impulses_->getDomainMap();
  const auto speed = Teuchos::rcp(new TpetraVector(map)), lambda = Teuchos::rcp(new TpetraVector(map));
  impulses_->relative(velocity, *speed, 1.0);
  double fastest = 0;
  for (double v : velocity) fastest = std::max(fastest, std::abs(v));
  const double size = speed->norm2();
  const auto& numbers = model_.settings().internals.time_step;
  const double known = numbers.velocity_round_off * largest_over_ranks(*map->getComm(), fastest) *
                       std::sqrt(static_cast<double>(map->getGlobalNumElements()));
  if (size <= known) return {};
  const double tolerance = std::max(numbers.velocity_accuracy, known / size);
  const auto solved = solver_.solve(impulses_, by_mass_, speed, lambda, tolerance);
  if (!solved.converged) throw SolverFailure("the impulses between stones are not found: " + solved.failure);
  JumpImpulses jump{add(velocity, *lambda), impulses_->at_points(*lambda)};
  for (double& p : jump.at_points) p = -p;
  return jump;
}

std::vector<double> VelocityProjection::push(std::vector<double>& velocity, const PointField& impulses_at_points) {
  VOUSSOIR_EXPECT(is_of_nodes(model_, velocity) && "velocity: of node copies");
  VOUSSOIR_EXPECT(is_of_points(model_, impulses_at_points) && "impulses: of points");
  TpetraVector lambda(impulses().getDomainMap());
  double* value = local_view_to_write(lambda);
  for (int i = 0; i < static_cast<int>(lambda.getLocalLength()); ++i) value[i] = -impulses_at_points[i];
  return add(velocity, lambda);
}

}  // namespace voussoir

#include "simulation/velocity_update.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/midpoint_rule.hpp"
#include "homogenisation/block_solves.hpp"
#include "joints/tractions.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

// Stiffness with which projections hold points, relative to the mass of their nodes: one solve leaves a hundredth of
// the relative velocity, and conjugate gradients on single blocks still take a few iterations.
constexpr double holding = 100;
constexpr int largest_repeats = 20;
// Relative velocities are brought down to this share of what counts as resting.
constexpr double share_of_rest = 0.1;
constexpr double solve_tolerance = 1e-10;

template <int dim>
PointField relative(const ContactPoints<dim>& points, const std::vector<double>& v) {
  PointField speed(static_cast<std::size_t>(dim) * points.size());
  for (int k = 0; k < points.size(); ++k) {
    const auto motion = relative_motion(points.points()[k], v);
    std::copy(motion.begin(), motion.end(), speed.begin() + static_cast<long>(dim) * k);
  }
  return speed;
}

/// Points that rest on each other, and these with those that stick: 1 for every component that is held. Forces at a
/// vertex of three blocks are not unique, so a point without one rests there as well when it touches and does not part.
/// @param speed  relative velocities [m/s]
template <int dim>
std::pair<std::vector<PointStiffness>, std::vector<PointStiffness>> contacts(const Model<dim>& model,
                                                                             const ContactState& state,
                                                                             const PointField& speed, double resting) {
  const auto& points = model.points().points();
  const auto gap = model.gaps(state.displacement);
  const double none = no_force * largest_force(model, state), round_off = closed_gap * model.structure().size();
  const auto loaded = [&](std::size_t k) {
    const bool glued = !state.broken[k] && model.law()[k].tension > 0;
    return state.selected[k] && (state.lambda[dim * k] > none || glued);
  };
  std::vector<char> carries(state.velocity.size() / dim, 0);  // per node
  for (std::size_t k = 0; k < points.size(); ++k)
    if (loaded(k)) carries[points[k].node_i] = carries[points[k].node_j] = 1;
  std::vector<PointStiffness> closed(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool between = state.selected[k] && carries[points[k].node_i] && carries[points[k].node_j];
    const bool rests = std::abs(gap[dim * k]) < round_off && std::abs(speed[dim * k]) <= resting;
    closed[k].normal = loaded(k) || (between && rests);
  }
  auto sticking = closed;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!loaded(k)) continue;
    auto law = model.law()[k];
    if (state.broken[k]) law.cohesion = law.tension = 0;
    double q = 0;
    for (int c = 1; c < dim; ++c) q += state.lambda[dim * k + c] * state.lambda[dim * k + c];
    sticking[k].tangential = std::sqrt(q) < (1 - no_force) * friction_bound(law, state.lambda[dim * k]);
  }
  return {closed, sticking};
}

/// Exact solves on every block, bonded or not.
template <int dim>
class AllBlocks : public Preconditioner {
 public:
  AllBlocks(const Structure<dim>& s, const MergedSpace<dim>& space)
      : solves_(s, space, std::vector<int>(s.owner_of_block().size(), 1)) {}
  void update(const LocalCsr& matrix) { solves_.update(matrix); }
  void apply(const TpetraVector& r, TpetraVector& z) const override {
    z.putScalar(0);
    solves_.add(r, z, 1.0);
  }

 private:
  BlockSolves<dim> solves_;
};

}  // namespace

/// Systems with the selection of a step: M, and S of the time step.
template <int dim>
struct VelocityUpdate<dim>::Systems {
  Systems(const Model<dim>& at_rest, const Structure<dim>& mass_structure, const Model<dim>& step_model,
          const ContactState& s, LinearSolver& solver)
      : step(step_model),
        state(s),
        zero(s.displacement.size(), 0.0),
        space(mass_structure, at_rest.points(), state.selected, at_rest.held()),
        mass(mass_structure, at_rest.points(), state.selected, space),
        blocks(std::make_shared<AllBlocks<dim>>(mass_structure, space)),
        way({step_model.structure(), at_rest.points(), step_model.continuum(), at_rest.held(),
             at_rest.local_stiffness(), no_gap, at_rest.scene().preconditioner, solver},
            state, at_rest.law(), zero, zero) {
    std::vector<double> along_x(zero.size(), 0.0), weight;
    for (std::size_t i = 0; i < zero.size(); i += dim) along_x[i] = 1;
    mass_structure.apply_stiffness(along_x, weight);
    for (const auto& p : at_rest.points().points()) {
      const double i = weight[dim * p.node_i], j = weight[dim * p.node_j];
      hold.push_back(holding * 2 * i * j / (i + j));
    }
  }

  const Model<dim>& step;
  ContactState state;
  std::vector<double> zero, no_gap, hold;
  MergedSpace<dim> space;
  SystemMatrix<dim> mass;
  std::shared_ptr<AllBlocks<dim>> blocks;
  ContactProblem<dim> way;
};

template <int dim>
double largest_force(const Model<dim>& model, const ContactState& state) {
  double mine = 0;
  for (int k = 0; k < model.points().owned(); ++k)
    if (state.selected[k]) mine = std::max(mine, state.lambda[dim * k]);
  return largest_over_ranks(*model.structure().comm(), mine);
}

template <int dim>
VelocityUpdate<dim>::VelocityUpdate(const Model<dim>& at_rest, const Structure<dim>& mass)
    : at_rest_(at_rest), mass_(mass), solver_(at_rest.scene().solver) {}

template <int dim>
VelocityUpdate<dim>::~VelocityUpdate() = default;

template <int dim>
void VelocityUpdate<dim>::forget() {
  systems_.reset();
}

template <int dim>
double VelocityUpdate<dim>::product(const std::vector<double>& v, const std::vector<double>& w) const {
  std::vector<double> mw;
  mass_.apply_stiffness(w, mw);
  double mine = 0, all = 0;
  for (int i = 0; i < dim * mass_.owned_nodes(); ++i) mine += v[i] * mw[i];
  Teuchos::reduceAll(*mass_.comm(), Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all;
}

/// Largest relative velocity at points that are held.
template <int dim>
double VelocityUpdate<dim>::fastest(const PointField& speed, const std::vector<PointStiffness>& held) const {
  double mine = 0;
  for (int k = 0; k < at_rest_.points().owned(); ++k) {
    if (held[k].normal > 0) mine = std::max(mine, std::abs(speed[dim * k]));
    if (held[k].tangential > 0)
      for (int c = 1; c < dim; ++c) mine = std::max(mine, std::abs(speed[dim * k + c]));
  }
  return largest_over_ranks(*mass_.comm(), mine);
}

/// The nearest velocity, in the norm of the kinetic energy, without relative velocities where points are held.
template <int dim>
void VelocityUpdate<dim>::project(std::vector<double>& velocity, const std::vector<PointStiffness>& held,
                                  double resting) {
  auto& s = *systems_;
  const auto b = Teuchos::rcp(new TpetraVector(s.space.map())), d = Teuchos::rcp(new TpetraVector(s.space.map()));
  std::vector<double> change;
  for (int repeat = 0; repeat < largest_repeats; ++repeat) {
    auto impulse = relative(at_rest_.points(), velocity);
    if (fastest(impulse, held) <= share_of_rest * resting) return;
    if (repeat == 0) {
      s.mass.update(held, {});
      s.blocks->update(s.mass.local());
    }
    for (std::size_t k = 0; k < held.size(); ++k) {
      impulse[dim * k] *= held[k].normal;
      for (int c = 1; c < dim; ++c) impulse[dim * k + c] *= held[k].tangential;
    }
    change.assign(velocity.size(), 0.0);
    add_contact_forces(at_rest_.points(), s.space.cluster(), impulse, -1.0, change);
    s.space.sum(change, *b);
    d->putScalar(0);
    solver_.solve(s.mass.matrix(), s.blocks, b, d, solve_tolerance);
    s.space.scatter(*d, change);
    for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] += change[i];
  }
}

/// How the normal impulses of points that are not at rest spread within a time step.
template <int dim>
std::vector<double> VelocityUpdate<dim>::spread(const PointField& lambda, const PointField& speed,
                                                const std::vector<PointStiffness>& closed, double resting) {
  auto& problem = systems_->way;
  const auto b = Teuchos::rcp(new TpetraVector(problem.map())), d = Teuchos::rcp(new TpetraVector(problem.map()));
  PointField impulse(lambda.size(), 0.0);
  const bool any = fastest(speed, closed) > resting;
  for (std::size_t k = 0; k < closed.size(); ++k)
    if (closed[k].normal > 0 && (!any || std::abs(speed[dim * k]) > resting)) impulse[dim * k] = -lambda[dim * k];
  problem.subtract_contact_forces(impulse, *b);
  problem.solve(std::vector<PointStiffness>(closed.size()), 0.0, b, d, solve_tolerance);
  std::vector<double> way;
  problem.space().scatter(*d, way);
  return way;
}

template <int dim>
double VelocityUpdate<dim>::apply(const Model<dim>& step, ContactState& state, double lost, double resting) {
  const auto& points = at_rest_.points();
  const auto speed = relative(points, state.velocity);
  auto [closed, sticking] = contacts(at_rest_, state, speed, resting);
  auto sliding = sticking;  // only what friction holds
  for (auto& held : sliding) held.normal = 0;
  const bool impact = fastest(speed, closed) > resting || lost > 0;
  if (!impact && fastest(speed, sliding) <= resting) return 0;

  // A selection that changed on one rank changed for all.
  if (largest_over_ranks(*mass_.comm(), !systems_ || systems_->state.selected != state.selected) > 0)
    systems_ = std::make_unique<Systems>(at_rest_, mass_, step, state, solver_);
  for (int k = 0; k < points.size(); ++k) {
    closed[k].normal *= systems_->hold[k];
    sticking[k].normal *= systems_->hold[k];
    sticking[k].tangential *= systems_->hold[k];
  }
  auto& v = state.velocity;
  if (impact) {
    const double before = kinetic_energy(v);
    project(v, closed, resting);
    const double wanted = lost + before - kinetic_energy(v);
    auto way = spread(state.lambda, speed, closed, resting);
    const double whole = kinetic_energy(way);
    const double at_joint = fastest(relative(points, way), closed);
    auto behind = way;
    project(behind, closed, 1e-6 * at_joint);
    // Where closed points hold everything there is no way behind them: then they rebound.
    constexpr double nothing = 1e-12;
    if (kinetic_energy(behind) > nothing * whole) way = behind;
    const double square = kinetic_energy(way);
    if (square > 0) {
      const double change = least_change(square, product(v, way), wanted);
      for (std::size_t i = 0; i < v.size(); ++i) v[i] += change * way[i];
    }
  }
  if (fastest(relative(points, v), sliding) <= resting) return 0;
  const double before = kinetic_energy(v);
  project(v, sticking, resting);
  return before - kinetic_energy(v);
}

template double largest_force<2>(const Model<2>&, const ContactState&);
template class VelocityUpdate<2>;

}  // namespace voussoir

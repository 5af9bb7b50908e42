#include "simulation/contact_problem.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>

#include "blocks/assembly.hpp"
#include "blocks/rigid_motion.hpp"
#include "joints/tractions.hpp"
#include "linalg/local_view.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {
namespace {

// The proximal term is the stiffness of a foundation that lets the whole structure move by its size under a strain
// of this amount: 1e-4 of E V / L^2 is far below the stiffness of any arch that stands, and bounds free motions.
constexpr double proximal_strain = 1e-4;

}  // namespace

template <int dim>
ContactProblem<dim>::ContactProblem(const Parts& parts, const ContactState& state, const PointLaws& law,
                                    const std::vector<double>& load, const std::vector<double>& prescribed)
    : parts_(parts), state_(state), law_(law), load_(load), prescribed_(prescribed) {
  const auto& s = parts.structure;
  space_ = std::make_unique<MergedSpace<dim>>(s, parts.points, state.selected, parts.held);
  matrix_ = std::make_unique<SystemMatrix<dim>>(s, parts.points, state.selected, *space_);
  coarse_ = std::make_shared<CoarseOperator<dim>>(s, parts.points, state.selected, *space_, parts.continuum,
                                                  parts.preconditioner);
  set_proximal_weights();
  set_movable();
  double mine = 0;
  for (int i = 0; i < dim * s.owned_nodes(); ++i) mine = std::max(mine, std::abs(load[i]));
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_MAX, mine, Teuchos::outArg(force_scale_));
}

template <int dim>
void ContactProblem<dim>::set_proximal_weights() {
  const auto& s = parts_.structure;
  proximal_weight_.assign(static_cast<std::size_t>(dim) * space_->owned_clusters(), 0.0);
  const int mine = std::find(state_.selected.begin(), state_.selected.end(), 1) != state_.selected.end();
  int any = 0;
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_MAX, mine, Teuchos::outArg(any));
  if (!any) return;  // the bonded continuum cannot run away
  const double factor = proximal_strain / (s.size() * s.size());
  const double mortar = parts_.softest_mortar * s.size();
  for (const auto& b : s.blocks()) {
    const auto volume = nodal_volumes(b.mesh, s.model().thickness);
    const double stone = b.material.young_modulus, modulus = std::isinf(mortar) ? stone : stone / (1 + stone / mortar);
    for (std::size_t i = 0; i < volume.size(); ++i) {
      const int k = space_->cluster()[b.first_local + i];
      if (k < space_->owned_clusters())
        for (int c = 0; c < dim; ++c) proximal_weight_[dim * k + c] += factor * modulus * volume[i];
    }
  }
}

template <int dim>
void ContactProblem<dim>::set_movable() {
  movable_ = state_.selected;
  const auto held = [&](int node, int c) { return space_->held()[dim * space_->cluster()[node] + c]; };
  for (int k = 0; k < parts_.points.size(); ++k) {
    const auto& p = parts_.points.points()[k];
    bool moves = false;
    for (int c = 0; c < dim; ++c) moves |= p.axis[0][c] != 0 && !(held(p.node_i, c) && held(p.node_j, c));
    // Open by the size of the structure: a side of it is not built yet. A gap as long would dwarf all others.
    const bool far = !parts_.initial_gap.empty() && parts_.initial_gap[k] >= parts_.structure.size();
    if (!moves || far) movable_[k] = 0;
  }
}

template <int dim>
Teuchos::RCP<TpetraVector> ContactProblem<dim>::unknowns(const std::vector<double>& displacement) const {
  auto u = displacement;
  for (std::size_t i = 0; i < u.size(); ++i)
    if (parts_.held[i]) u[i] = prescribed_[i];
  auto x = Teuchos::rcp(new TpetraVector(space_->map()));
  space_->average(u, *x);
  return x;
}

template <int dim>
void ContactProblem<dim>::gaps(PointField& gap, bool initial) const {
  relative_motions(parts_.points, copies_, gap);
  if (!initial) return;
  for (std::size_t k = 0; k < parts_.initial_gap.size(); ++k) gap[k * dim] += parts_.initial_gap[k];
}

template <int dim>
void ContactProblem<dim>::evaluate(const TpetraVector& x, TpetraVector& r, PointField& gap) {
  space_->scatter(x, copies_);
  parts_.structure.internal_forces(copies_, forces_);
  internal_scale_ = 0;
  for (double f : forces_) internal_scale_ = std::max(internal_scale_, std::abs(f));
  for (std::size_t i = 0; i < forces_.size(); ++i) forces_[i] -= load_[i];
  space_->sum(forces_, r);
  gaps(gap, true);
}

template <int dim>
void ContactProblem<dim>::evaluate_direction(const TpetraVector& d, TpetraVector& y, PointField& gap) {
  space_->scatter(d, copies_);
  parts_.structure.apply_stiffness(copies_, forces_);
  space_->sum(forces_, y);
  gaps(gap, false);
}

template <int dim>
double ContactProblem<dim>::rigid_gaps(const TpetraVector& d, PointField& gap) {
  const auto& s = parts_.structure;
  space_->scatter(d, copies_);
  double off = 0;
  for (std::size_t b = 0; b < s.blocks().size(); ++b) {
    const auto& block = s.blocks()[b];
    const RigidMotion rigid = rigid_motion(s.position(), block, copies_);
    const int end = block.first_local + static_cast<int>(block.mesh.position.size());
    for (int i = block.first_local; i < end; ++i) {
      const auto u = rigid.at(s.position()[i]);
      for (int c = 0; c < dim; ++c) {
        off = std::max(off, std::abs(copies_[dim * i + c] - u[c]));
        copies_[dim * i + c] = u[c];
      }
    }
  }
  gaps(gap, false);
  return largest_over_ranks(*s.comm(), off);
}

template <int dim>
void ContactProblem<dim>::subtract_contact_forces(const PointField& lambda, TpetraVector& r) {
  forces_.assign(static_cast<std::size_t>(dim) * parts_.structure.nodes(), 0.0);
  add_contact_forces(parts_.points, space_->cluster(), lambda, 1.0, forces_);
  double* value = local_view_to_write(r);
  const auto& cluster = space_->cluster();
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const int unknown = dim * cluster[i / dim] + static_cast<int>(i % dim);
    if (unknown < dim * space_->owned_clusters() && !space_->held()[unknown]) value[unknown] -= forces_[i];
  }
}

template <int dim>
int ContactProblem<dim>::solve(const std::vector<PointStiffness>& stiffness, double proximal_scale,
                               const Teuchos::RCP<TpetraVector>& b, const Teuchos::RCP<TpetraVector>& d,
                               double relative_tolerance, int largest_krylov) {
  std::vector<double> proximal(proximal_weight_.size());
  for (std::size_t i = 0; i < proximal.size(); ++i) proximal[i] = proximal_scale * proximal_weight_[i];
  const TrafficScope sent_for(TrafficOf::set_up);
  matrix_->update(stiffness, proximal);
  coarse_->update(*matrix_, stiffness, proximal);
  const auto symmetry = matrix_->couple(stiffness) ? Symmetry::none : Symmetry::symmetric;
  coarse_->set_symmetry(symmetry);
  return parts_.solver.solve(matrix_->matrix(), coarse_, b, d, relative_tolerance, symmetry, largest_krylov)
      .iterations;
}

template class ContactProblem<2>;

}  // namespace voussoir

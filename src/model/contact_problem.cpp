#include "model/contact_problem.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/check.hpp"
#include "joints/tractions.hpp"
#include "linalg/local_view.hpp"
#include "linalg/reduce.hpp"
#include "linalg/solver_failure.hpp"
#include "linalg/traffic.hpp"
#include "model/patch_cutter.hpp"

namespace voussoir {
namespace {

/// Of absolute values.
double largest_row_sum(const LocalCsr& matrix) {
  double largest = 0;
  for (int i = 0; i < matrix.rows(); ++i) {
    double sum = 0;
    for (int k = matrix.start[i]; k < matrix.start[i + 1]; ++k) sum += std::abs(matrix.value[k]);
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace

ContactProblem::ContactProblem(const Parts& parts, const std::vector<char>& selected, const Asked& asked)
    : parts_(parts), dim_(parts.structure.components()), selection_(selected) {
  const auto points = static_cast<std::size_t>(parts.points.size());
  VOUSSOIR_EXPECT(selected.size() == points && "selected: per point");
  VOUSSOIR_EXPECT(parts.local_stiffness.size() == points && "local stiffness: per point");
  VOUSSOIR_EXPECT((parts.initial_gap.empty() || parts.initial_gap.size() == points) &&
                  "initial gap: per point, or none");
  VOUSSOIR_EXPECT((parts.compliance.empty() || parts.compliance.size() == points) && "compliance: per point, or none");
  VOUSSOIR_EXPECT(parts.held.size() == static_cast<std::size_t>(dim_) * parts.structure.nodes() &&
                  "held: of node copies");
  space_ = std::make_unique<MergedSpace>(parts.structure, parts.points, selection_, parts.held);
  matrix_ = std::make_unique<SystemMatrix>(parts.structure, parts.points, selection_, *space_);
  for (int b = 0; b < parts.structure.local_blocks(); ++b)
    row_sum_.push_back(largest_row_sum(*parts.structure.nodes_of(b).stiffness));
  has_own_axes_ = any_of_ranks(*parts.structure.comm(), !parts.held.frames().empty());
  make_preconditioner();
  begin(asked);
}

void ContactProblem::make_preconditioner() {
  coarse_.reset();  // its room first
  coarse_ = std::make_shared<CoarseOperator>(parts_.structure, parts_.points, selection_, *space_, parts_.continuum,
                                             parts_.preconditioner, parts_.internals.preconditioner);
}

void ContactProblem::begin(const Asked& asked) {
  VOUSSOIR_EXPECT(asked.law.size() == selection_.size() && "laws: per point");
  VOUSSOIR_EXPECT((asked.slip_origin.empty() || asked.slip_origin.size() == dim_ * selection_.size()) &&
                  "slips: of points, or none");
  VOUSSOIR_EXPECT(asked.load.size() == parts_.held.size() && "load: of node copies");
  VOUSSOIR_EXPECT(asked.prescribed.size() == parts_.held.size() && "prescribed displacement: of node copies");
  if (!coarse_->begin_step()) make_preconditioner();
  asked_.emplace(asked);
  if (asked.softening) coarse_->factor_on_first_rank();  // round-off decides which of two cracks runs
  carried_ = Teuchos::null;
  rigid_.clear();
  rigid_gap_.clear();
  deformed_.clear();
  internal_scale_ = 0;
  absolute_terms_ = 0;
  patches_.reset();
  set_proximal_weights();
  set_movable();
  find_shared_forces();
  set_scales();
}

/// Where strength is judged by forces that nothing else tells apart. Mortar that is a spring tells them.
void ContactProblem::find_shared_forces() {
  shared_forces_.reset();
  shares_ = asked_->softening;
  if (!shares_) return;
  auto counts = movable_;
  for (std::size_t k = 0; k < parts_.compliance.size(); ++k)
    if (parts_.compliance[k].normal > 0 && parts_.compliance[k].tangential > 0) counts[k] = 0;
  shared_forces_ =
      std::make_unique<SharedForces>(parts_.structure, parts_.points, space_->cluster(), space_->held(), counts);
  shares_ = any_of_ranks(*parts_.structure.comm(), shared_forces_->any());
}

void ContactProblem::split_shared_forces(const std::vector<PointFreedom>& freedom, SharedFriction friction,
                                         PointField& lambda) const {
  if (!shares_) return;
  shared_forces_->split(freedom, friction, lambda);
  parts_.points.exchange().update(lambda, dim_);
}

/// Share of the forces borne at the start of a step below which those of its end are not told apart: they come of the
/// former by subtraction, which leaves round-off of these, and a tolerance of 1e-8 of this share is ten thousand times
/// that. Likewise of the force with which supports that move would push a stone that gives way at one point alone:
/// where nothing loads a structure and its joints part, no other force is left to measure by.
constexpr double remembered = 1e-4;

/// The largest load, the stiffest point, and what is remembered of the largest force that a point bore.
void ContactProblem::set_scales() {
  const auto& s = parts_.structure;
  std::array<double, 4> largest{};
  for (int i = 0; i < dim_ * s.owned_nodes(); ++i) {
    largest[0] = std::max(largest[0], std::abs(asked_->load[i]));
    largest[3] = std::max(largest[3], std::abs(asked_->prescribed[i]));
  }
  for (double k : parts_.local_stiffness) largest[1] = std::max(largest[1], k);
  for (std::size_t i = 0; asked_->borne && i < asked_->borne->size(); i += dim_)
    largest[2] = std::max(largest[2], std::abs((*asked_->borne)[i]));
  const auto all = largest_of_each(*s.comm(), largest);
  force_scale_ = all[0];
  stiffest_ = all[1];
  borne_ = remembered * (force_scale_ > 0 ? all[2] : std::max(all[2], stiffest_ * all[3]));
}

/// Young's modulus [Pa] beyond which stones are next to rigid under these loads. Collective.
/// @param volume  of this rank's own blocks [m3]
double ContactProblem::stiffest_that_counts(double volume) const {
  const auto& s = parts_.structure;
  std::array<double, 2> mine{0, volume};
  for (int i = 0; i < dim_ * s.owned_nodes(); ++i) mine[0] += std::abs(asked_->load[i]);
  const auto all = total_of_each(*s.comm(), mine);
  return all[0] > 0 ? parts_.internals.step.next_to_rigid * all[0] * s.size() / all[1]
                    : std::numeric_limits<double>::infinity();
}

void ContactProblem::set_proximal_weights() {
  const auto& s = parts_.structure;
  proximal_weight_.assign(static_cast<std::size_t>(dim_) * space_->owned_clusters(), 0.0);
  const auto volume = s.nodal_volumes();
  const double stiffest = stiffest_that_counts(std::accumulate(volume.begin(), volume.begin() + s.owned_nodes(), 0.0));
  const double factor = parts_.internals.step.proximal_strain / (s.size() * s.size());
  const double mortar = parts_.softest_mortar * s.size();
  for (std::size_t i = 0; i < volume.size(); ++i) {
    const int k = space_->cluster()[i];
    if (k >= space_->owned_clusters()) continue;
    const double stone = std::min(s.nodes_of(s.block_of_node()[i]).material.young_modulus, stiffest);
    const double modulus = std::isinf(mortar) ? stone : stone / (1 + stone / mortar);
    for (int c = 0; c < dim_; ++c) proximal_weight_[dim_ * k + c] += factor * modulus * volume[i];
  }
}

void ContactProblem::set_movable() {
  movable_ = selection_;
  for (int k = 0; k < parts_.points.size(); ++k) {
    const auto& p = parts_.points.points()[k];
    const bool moves = parts_.points.at(k).may_part(space_->held(), [&](int node) { return space_->cluster()[node]; });
    // Open by the size of the structure: a side of it is not built yet. A gap as long would dwarf all others.
    const bool far = !parts_.initial_gap.empty() && parts_.initial_gap[k] >= parts_.structure.size();
    if (space_->tied(p) || !moves || far) movable_[k] = 0;
  }
}

Teuchos::RCP<TpetraVector> ContactProblem::unknowns(const std::vector<double>& displacement) const {
  auto u = displacement;
  const auto own = parts_.held.held_part(u, dim_), given = parts_.held.held_part(asked_->prescribed, dim_);
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = (u[i] - own[i]) + given[i];
  auto x = Teuchos::rcp(new TpetraVector(space_->map()));
  space_->average(u, *x);
  return x;
}

void ContactProblem::displacement(const TpetraVector& x, std::vector<double>& u) const {
  space_->scatter(x, u);
  for (std::size_t i = 0; i < rigid_.size(); ++i) u[i] = rigid_[i] + (deformed_[i] + u[i]);
}

void ContactProblem::gaps(PointField& gap, bool initial) const {
  relative_motions(parts_.points, copies_, gap);
  if (!initial) return;
  for (std::size_t i = 0; i < rigid_gap_.size(); ++i) gap[i] += rigid_gap_[i];
  for (std::size_t k = 0; k < parts_.initial_gap.size(); ++k) gap[k * dim_] += parts_.initial_gap[k];
}

void ContactProblem::evaluate(const TpetraVector& x, TpetraVector& r, PointField& gap) {
  space_->scatter(x, copies_);
  for (std::size_t i = 0; i < deformed_.size(); ++i) copies_[i] += deformed_[i];
  if (deformed_.empty())
    parts_.structure.internal_forces(copies_, forces_);
  else
    parts_.structure.apply_stiffness(copies_, forces_);
  if (parts_.inertia || !deformed_.empty()) set_absolute_terms(parts_.inertia ? copies_ : deformed_);
  internal_scale_ = 0;
  for (double f : forces_) internal_scale_ = std::max(internal_scale_, std::abs(f));
  for (std::size_t i = 0; i < forces_.size(); ++i) forces_[i] -= asked_->load[i];
  space_->sum(forces_, r);
  gaps(gap, true);
}

void ContactProblem::set_absolute_terms(const std::vector<double>& displacement) {
  absolute_terms_ = 0;
  for (int b = 0; b < parts_.structure.local_blocks(); ++b) {
    const auto& nodes = parts_.structure.nodes_of(b);
    double largest = 0;
    for (int i = dim_ * nodes.first_local; i < dim_ * (nodes.first_local + nodes.nodes); ++i)
      largest = std::max(largest, std::abs(displacement[i]));
    absolute_terms_ = std::max(absolute_terms_, row_sum_[b] * largest);
  }
}

double ContactProblem::round_off() const {
  return std::numeric_limits<double>::epsilon() * largest_over_ranks(*parts_.structure.comm(), absolute_terms_);
}

void ContactProblem::evaluate_direction(const TpetraVector& d, TpetraVector& y, PointField& gap) {
  space_->scatter(d, copies_);
  parts_.structure.apply_stiffness(copies_, forces_);
  space_->sum(forces_, y);
  gaps(gap, false);
}

double ContactProblem::rigid_gaps(const TpetraVector& d, PointField& gap) {
  std::vector<double> rest;
  space_->scatter(d, rest);
  parts_.structure.split_rigid_motions(rest, copies_);
  double off = 0;
  for (double u : rest) off = std::max(off, std::abs(u));
  gaps(gap, false);
  return largest_over_ranks(*parts_.structure.comm(), off);
}

bool ContactProblem::carry(TpetraVector& x, double tolerance) {
  if (parts_.inertia || !parts_.internals.step.carry) return false;
  const double round_off = std::numeric_limits<double>::epsilon() * stiffest_ * x.normInf();
  if (!(round_off > parts_.internals.step.share_of_round_off * tolerance)) return false;
  std::vector<double> moved;
  space_->scatter(x, moved);
  if (carried_.is_null()) {
    carried_ = Teuchos::rcp(new TpetraVector(space_->map()));
    // Where finite rotations have followed stones to is no deformation.
    rigid_.assign(moved.size(), 0.0);
    deformed_ = parts_.structure.deformation(rigid_);
    for (std::size_t i = 0; i < moved.size(); ++i) rigid_[i] -= deformed_[i];
  }
  for (std::size_t i = 0; i < moved.size(); ++i) deformed_[i] += moved[i];
  parts_.structure.split_rigid_motions(deformed_, moved);
  for (std::size_t i = 0; i < moved.size(); ++i) rigid_[i] += moved[i];
  relative_motions(parts_.points, rigid_, rigid_gap_);
  carried_->update(1.0, x, 1.0);
  x.putScalar(0);
  return true;
}

void ContactProblem::subtract_contact_forces(const PointField& lambda, TpetraVector& r) {
  forces_.assign(static_cast<std::size_t>(dim_) * parts_.structure.nodes(), 0.0);
  add_contact_forces(parts_.points, space_->cluster(), lambda, 1.0, forces_);
  space_->turn_to_unknowns(forces_);
  double* value = local_view_to_write(r);
  const auto& cluster = space_->cluster();
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const int unknown = dim_ * cluster[i / dim_] + static_cast<int>(i % dim_);
    if (unknown < dim_ * space_->owned_clusters() && !space_->held()[unknown]) value[unknown] -= forces_[i];
  }
}

/// Matrix and preconditioner. A SolverFailure is one of all ranks.
Symmetry ContactProblem::set_up(const std::vector<PointStiffness>& stiffness, double proximal_scale) {
  std::vector<double> proximal(proximal_weight_.size());
  for (std::size_t i = 0; i < proximal.size(); ++i) proximal[i] = proximal_scale * proximal_weight_[i];
  matrix_->update(stiffness, proximal);
  coarse_->update(*matrix_, stiffness, proximal);
  const auto symmetry = matrix_->couple(stiffness) ? Symmetry::none : Symmetry::symmetric;
  coarse_->couple(*matrix_, symmetry);
  return symmetry;
}

LinearSolveResult ContactProblem::solve(const std::vector<PointStiffness>& stiffness, double proximal_scale,
                                        const Teuchos::RCP<TpetraVector>& b, const Teuchos::RCP<TpetraVector>& d,
                                        const SolveRequest& request) {
  const TrafficScope sent_for(TrafficOf::set_up);
  auto symmetry = Symmetry::none;
  try {
    symmetry = set_up(stiffness, proximal_scale);
  } catch (const SolverFailure& failure) {
    return not_solved(failure.what());
  }
  const auto krylov = [&](int most) {
    return parts_.solver.solve(matrix_->matrix(), coarse_, b, d, request.tolerance, symmetry, most);
  };
  const int most = request.largest_krylov, too_many = parts_.internals.preconditioner.krylov_to_factor;
  const bool otherwise = coarse_->may_factor_whole() && (most == 0 || most > too_many);
  auto result = krylov(otherwise ? too_many : most);
  if (!otherwise || result.converged) return result;
  const auto go_on = [&](int iterations) {
    const int before = result.iterations;
    result = krylov(iterations);
    result.iterations += before;
  };
  const int worth = coarse_->iterations_of_factoring();
  const bool pays = most == 0 ? coarse_->may_factor_whole() : worth < most;
  if (pays && worth > too_many) go_on(worth - too_many);
  if (result.converged) return result;
  if (pays) coarse_->factor_whole();  // where that does not go its parts go on
  go_on(most);
  return result;
}

PatchSource* ContactProblem::patches() {
  if (has_own_axes_) return nullptr;  // entries of patches go along the axes of the drawing
  if (!patches_)
    patches_ = std::make_unique<PatchCutter>(
        PatchCutter::Parts{parts_.structure, parts_.points, *space_, proximal_weight_, *this});
  return patches_.get();
}

}  // namespace voussoir

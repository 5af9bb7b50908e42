#include "homogenisation/coarse_operator.hpp"

#include <malloc.h>

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include "linalg/parcels.hpp"
#include "linalg/reduce.hpp"
#include "linalg/shared_system.hpp"
#include "linalg/solver_failure.hpp"

namespace voussoir {
namespace {

/// 1 for each local block with a selected point. Collective.
std::vector<char> active_blocks(const BlockSystem& s, const ContactPoints& points, const std::vector<char>& selected) {
  Post<BlockId> post(*s.comm());
  for (int k = 0, joint = -1; k < points.owned(); ++k) {
    if (!selected[k] || points.points()[k].joint == joint) continue;
    joint = points.points()[k].joint;
    for (const int b : {points.joints()[joint].local_i, points.joints()[joint].local_j})
      post.add(s.owner_of(b), s.nodes_of(b).id);
  }
  std::vector<double> of_node(s.nodes(), 0.0);
  for (const BlockId b : std::move(post).send_all()) {
    const auto& block = s.nodes_of(s.local_block(b));
    std::fill_n(of_node.begin() + block.first_local, block.nodes, 1.0);
  }
  s.node_exchange().update(of_node, 1);
  std::vector<char> active;
  for (int b = 0; b < s.local_blocks(); ++b) active.push_back(of_node[s.nodes_of(b).first_local] > 0);
  return active;
}

}  // namespace

CoarseOperator::CoarseOperator(const BlockSystem& s, const ContactPoints& points, const std::vector<char>& selected,
                               const MergedSpace& space, const Continuum& continuum,
                               const PreconditionerParameters& parameters, const CoarseOperatorParameters& numbers)
    : numbers_(numbers),
      structure_(s),
      space_(space),
      factored_up_to_(parameters.factored_up_to),
      selected_(selected),
      residual_(space.map()),
      product_(space.map()),
      inner_(space.map()),
      inner_residual_(space.map()) {
  bool directly = false;
  const bool homogenised = parameters.homogenised && continuum.preconditioner();
  if (parameters.released_region && homogenised) {
    auto region = std::make_unique<ReleasedRegion>(s, points, selected, space, numbers_);
    directly = region->pays();
    if (directly && region->size() > 0) region_ = std::move(region);
  }
  const auto active = directly ? std::vector<char>() : active_blocks(s, points, selected);
  const bool any = any_of_ranks(*s.comm(), std::find(active.begin(), active.end(), 1) != active.end());
  if (homogenised) continuum_ = std::make_unique<ContinuumCorrection>(continuum, space);
  if (parameters.block_local && any) blocks_ = std::make_unique<BlockSolves>(s, space, active);
  if (!parameters.rigid_blocks || !any) return;
  SharedSystemParameters shared;
  shared.most_on_first = numbers_.motions_on_first;
  motions_ = std::make_unique<BlockMotions>(s, points, selected, space, active, shared);
}

void CoarseOperator::update(const SystemMatrix& h, const std::vector<PointStiffness>& stiffness,
                            const std::vector<double>& proximal) {
  h_ = h.matrix();
  cost_.matrix_bytes = h.bytes();
  if (!parted()) return;
  const bool stays = !changed(stiffness, proximal);
  begins_ = false;
  if (stays) {
    ++cost_.reused;
    return;
  }
  ++cost_.factorised;
  factored_ = false;
  stale_ = true;
  all_or_none(*structure_.comm(), [&] {
    if (motions_) {
      const auto by = motions_->update(stiffness, proximal);
      cost_.levels += by == SolvedBy::levels;
      cost_.levels_refused += by == SolvedBy::factors_for_levels;
    }
    if (blocks_) blocks_->update(h.local());
  });
  factored_stiffness_ = stiffness;
  factored_proximal_ = proximal;
  factored_ = true;
}

void CoarseOperator::factor_on_first_rank() {
  factors_are_ = FactorsAre::on_first_rank;
  if (motions_) motions_->factor_on_first_rank();
}

std::vector<MultigridLevel> CoarseOperator::motion_levels() const {
  return motions_ ? motions_->levels() : std::vector<MultigridLevel>();
}

bool CoarseOperator::begin_step() {
  cost_ = {};
  begins_ = true;
  return !whole_ && !whole_fails_;
}

void CoarseOperator::couple(const SystemMatrix& h, Symmetry symmetry) {
  symmetry_ = symmetry;
  if (!stale_) return;
  if (region_ && !region_->update(h)) {
    // Whole factors leave out the rows that say nothing.
    if (!may_factor_whole() || !factor_whole())
      throw SolverFailure("UMFPACK found the matrix around what has parted singular");
  } else if (whole_) {
    if (!whole_->factor(*h_)) throw std::bad_alloc();
    ++cost_.whole;
  }
  stale_ = false;
}

/// Whether a selection has parted anything that is factored anew with its statuses.
bool CoarseOperator::parted() const { return motions_ || blocks_ || region_ || whole_; }

bool CoarseOperator::may_factor_whole() const {
  return !whole_ && !whole_fails_ && parted() &&
         space_.map()->getGlobalNumElements() <= static_cast<Tpetra::global_size_t>(factored_up_to_);
}

/// Whether H can be factored whole, as its order tells.
bool CoarseOperator::order_whole() {
  if (ordered_) return true;
  bool fits = false;
  try {
    auto whole = std::make_unique<DistributedLu>(space_.map(), factors_are_);
    const auto expected = whole->expected(*h_);
    fits = expected.bytes <= numbers_.bytes_of_factors * factored_up_to_;
    if (fits) ordered_ = std::move(whole);
  } catch (const SolverFailure&) {  // the parts are another way
  }
  whole_fails_ = !fits;
  return fits;
}

int CoarseOperator::iterations_of_factoring() {
  if (!order_whole()) return std::numeric_limits<int>::max();
  const double iteration = numbers_.work_per_entry * static_cast<double>(h_->getGlobalNumEntries());
  const double iterations = ordered_->expected(*h_).operations / iteration;
  return static_cast<int>(std::clamp(iterations, double(numbers_.krylov_to_factor), 1e6));
}

bool CoarseOperator::factor_whole() {
  bool factored = false;
  try {
    factored = order_whole() && ordered_->factor(*h_);
  } catch (const SolverFailure&) {  // the parts are another way
  }
  if (!factored) {
    whole_fails_ = true;
    ordered_.reset();
    return false;
  }
  cost_ = cost();
  ++cost_.whole;
  whole_ = std::move(ordered_);
  motions_.reset();
  blocks_.reset();
  region_.reset();
  continuum_.reset();
  malloc_trim(0);
  return true;
}

bool CoarseOperator::differ(double a, double b) const {
  return begins_ ? a != b : std::abs(a - b) > numbers_.same * std::min(std::abs(a), std::abs(b));
}

bool CoarseOperator::changed(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal) const {
  const int tangents = space_.components() - 1;
  bool here = !factored_;
  for (std::size_t k = 0; k < stiffness.size() && !here; ++k) {
    if (!selected_[k]) continue;
    const auto& before = factored_stiffness_[k];
    here = differ(stiffness[k].normal, before.normal);
    for (int t = 0; t < tangents; ++t)
      here = here || differ(stiffness[k].along(t, t), before.along(t, t)) ||
             ((region_ || whole_) &&
              (differ(stiffness[k].coupling[t], before.coupling[t]) || differ(stiffness[k].pull[t], before.pull[t])));
  }
  for (std::size_t i = 0; i < proximal.size() && !here; ++i) here = differ(proximal[i], factored_proximal_[i]);
  return any_of_ranks(*h_->getComm(), here);
}

SystemCost CoarseOperator::cost() const {
  auto cost = cost_;
  if (blocks_) cost.block_bytes = blocks_->bytes();
  if (motions_) cost.motion_bytes = motions_->bytes();
  if (region_) cost.block_bytes = region_->bytes();
  if (whole_) cost.whole_bytes = whole_->bytes();
  return cost;
}

/// left = r - H z
void CoarseOperator::leave(const TpetraVector& r, const TpetraVector& z, TpetraVector& left) const {
  h_->apply(z, left);
  left.update(1.0, r, -1.0);
}

void CoarseOperator::apply_inner(const TpetraVector& r, TpetraVector& z) const {
  z.putScalar(0);
  if (blocks_) blocks_->add(r, z, numbers_.block_weight);
  if (!continuum_) return;
  if (!blocks_) {
    continuum_->add(r, z);
    return;
  }
  leave(r, z, inner_residual_);
  continuum_->add(inner_residual_, z);
  leave(r, z, inner_residual_);
  blocks_->add(inner_residual_, z, numbers_.block_weight);
}

void CoarseOperator::apply_around_region(const TpetraVector& r, TpetraVector& z) const {
  z.putScalar(0);
  if (symmetry_ == Symmetry::symmetric) {
    region_->add(r, z);
    leave(r, z, residual_);
    continuum_->add(residual_, z);
  } else {
    continuum_->add(r, z);
  }
  leave(r, z, residual_);
  region_->add(residual_, z);
}

void CoarseOperator::apply(const TpetraVector& r, TpetraVector& z) const {
  if (whole_) {
    whole_->apply(r, z);
    return;
  }
  if (region_) {
    apply_around_region(r, z);
    return;
  }
  if (!motions_) {
    if (blocks_ || continuum_)
      apply_inner(r, z);
    else
      Tpetra::deep_copy(z, r);
    return;
  }
  if (symmetry_ == Symmetry::none && (blocks_ || continuum_)) {
    apply_inner(r, z);
    leave(r, z, residual_);
    motions_->add(residual_, z);
    return;
  }
  z.putScalar(0);
  motions_->add(r, z);
  leave(r, z, residual_);
  if (!blocks_ && !continuum_) {
    z.update(1.0, r, 1.0);
    return;
  }
  apply_inner(residual_, inner_);
  z.update(1.0, inner_, 1.0);
  h_->apply(inner_, product_);
  product_.scale(-1.0);
  motions_->add(product_, z);
}

}  // namespace voussoir

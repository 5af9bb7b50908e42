#include "homogenisation/continuum.hpp"

#include <algorithm>
#include <limits>

#include "base/check.hpp"
#include "homogenisation/lone_nodes.hpp"
#include "homogenisation/system_matrix.hpp"
#include "linalg/direct_preconditioner.hpp"
#include "linalg/local_view.hpp"
#include "linalg/reduce.hpp"
#include "linalg/solver_failure.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {
namespace {

/// Rigid motions at owned clusters, 3 columns in the plane and 6 in space. Lengths are scaled, so that columns are
/// alike. None is 0 at a group of nodes, which multigrid refuses. So turns are about a point beyond the structure along
/// every axis: about its middle, one would not move a node there, which can be a group of its own at the border of a
/// rank. Nor are motions 0 where a component is held, as it is of all nodes in a slice of a wall in plane strain. What
/// multigrid moves held unknowns by is left out (ContinuumCorrection), and in the matrix these stand alone.
Teuchos::RCP<TpetraMultiVector> rigid_motions(const BlockSystem& s, const MergedSpace& space) {
  const int dim = s.components(), turns = dim * (dim - 1) / 2;
  auto modes = Teuchos::rcp(new TpetraMultiVector(space.map(), dim + turns));
  auto view = modes->getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (int k = 0; k < space.owned_clusters(); ++k) {
    auto x = s.place(space.representative()[k]) - s.centre();
    for (int c = 0; c < dim; ++c) x[c] += 0.5 * s.size();
    double value[3][6] = {};
    for (int c = 0; c < dim; ++c) value[c][c] = 1;
    for (int a = 0, m = dim; a < dim; ++a)
      for (int b = a + 1; b < dim; ++b, ++m) {
        value[a][m] = -x[b] / s.size();
        value[b][m] = x[a] / s.size();
      }
    for (int m = 0; m < dim + turns; ++m) {
      const auto own = space.held().to_own(k, Vector<3>{value[0][m], value[1][m], value[2][m]});
      for (int c = 0; c < dim; ++c) view(dim * k + c, m) = own[c];
    }
  }
  return modes;
}

/// Of the stiffest stone to the softest. Collective.
double contrast(const BlockSystem& s) {
  double stiffest = 0, softest = std::numeric_limits<double>::infinity();
  for (int b = 0; b < s.local_blocks(); ++b) {
    stiffest = std::max(stiffest, s.nodes_of(b).material.young_modulus);
    softest = std::min(softest, s.nodes_of(b).material.young_modulus);
  }
  return largest_over_ranks(*s.comm(), stiffest) * largest_over_ranks(*s.comm(), 1 / softest);
}

}  // namespace

Continuum::Continuum(const BlockSystem& s, const ContactPoints& points, const Held& held,
                     const Teuchos::ParameterList& muelu, const CoarseOperatorParameters& numbers,
                     const std::vector<double>& local_stiffness) {
  auto free = points.untieable();
  bool springs = !free.empty();
  free.resize(points.size(), 0);
  for (int k = 0; k < points.size() && !held.frames().empty(); ++k)
    if (points.at(k).any([&](int node) { return held.has_frame(node); })) free[k] = springs = true;
  space_ = std::make_unique<MergedSpace>(s, points, free, held);
  // What is too small for multigrid is factored as it is; else edges that are condensed are left out: dense rows of
  // whole stones are no graph to coarsen.
  const auto unknowns = space_->map()->getGlobalNumElements();
  const bool small = unknowns < static_cast<Tpetra::global_size_t>(numbers.smallest_multigrid);
  SystemMatrix system(s, points, free, *space_, small ? &NodesOfBlock::stiffness : &NodesOfBlock::sparse);
  if (springs) {
    VOUSSOIR_EXPECT(local_stiffness.size() == free.size());
    std::vector<PointStiffness> stiffness;
    for (const double k : local_stiffness) stiffness.emplace_back(k, k);
    system.update(stiffness, {});
  }
  matrix_ = system.matrix();

  // A scene that has wishes for multigrid gets one.
  const bool uneven = muelu.numParams() == 0 && contrast(s) > numbers.even;
  if (small || (uneven && unknowns < static_cast<Tpetra::global_size_t>(numbers.largest_factor))) {
    preconditioner_ = std::make_shared<DirectPreconditioner>(*matrix_);
    return;
  }
  try {
    make_multigrid(s, muelu);
  } catch (const SolverFailure&) {  // a factorisation is another way, and so is to go without
    preconditioner_.reset();
    if (unknowns < static_cast<Tpetra::global_size_t>(numbers.largest_factor))
      preconditioner_ = std::make_shared<DirectPreconditioner>(*matrix_);
  }
}

void Continuum::make_multigrid(const BlockSystem& s, const Teuchos::ParameterList& muelu) {
  const int dim = s.components();
  std::vector<GlobalOrdinal> nodes;
  const auto dofs = space_->map()->getNodeElementList();
  for (int k = 0; k < space_->owned_clusters(); ++k) nodes.push_back(dofs[dim * k] / dim);
  auto coordinates = Teuchos::rcp(new TpetraMultiVector(map_of(nodes, s.comm()), dim));
  TpetraVector places(space_->map());
  {
    auto view = coordinates->getLocalViewHost(Tpetra::Access::OverwriteAll);
    double* place = local_view_to_write(places);
    for (int k = 0; k < space_->owned_clusters(); ++k)
      for (int c = 0; c < dim; ++c)
        view(k, c) = place[dim * k + c] = s.place(space_->representative()[k])[c] - s.centre()[c];
  }
  const LoneNodes lone(*matrix_, *space_, places);
  if (lone.others()) {
    const auto rest = lone.any() ? lone.left_out_of(*matrix_) : matrix_;
    multigrid_ = std::make_shared<AmgPreconditioner>(rest, coordinates, rigid_motions(s, *space_), dim, muelu);
  }
  preconditioner_ = lone.any() ? lone.beside(multigrid_) : multigrid_;
}

std::vector<MultigridLevel> Continuum::levels() const {
  return multigrid_ ? multigrid_->levels() : std::vector<MultigridLevel>{};
}

ContinuumCorrection::ContinuumCorrection(const Continuum& continuum, const MergedSpace& selection)
    : continuum_(continuum),
      ghosted_(Teuchos::rcp(new TpetraVector(continuum.space().column_map()))),
      coarse_r_(Teuchos::rcp(new TpetraVector(continuum.space().map()))),
      coarse_z_(Teuchos::rcp(new TpetraVector(continuum.space().map()))) {
  const auto& full = continuum.space();
  const int dim = full.components();
  for (int k = 0; k < selection.owned_clusters(); ++k)
    for (int c = 0; c < dim; ++c) {
      const int unknown = dim * full.cluster()[selection.representative()[k]] + c;
      const bool held = selection.held()[dim * k + c] || full.held()[unknown];
      from_.push_back(held ? -1 : unknown);
    }
}

void ContinuumCorrection::add(const TpetraVector& r, TpetraVector& z) const {
  const TrafficScope sent_for(TrafficOf::transfer);
  ghosted_->putScalar(0);
  {
    const double* fine = local_view(r);
    double* coarse = local_view_to_write(*ghosted_);
    for (std::size_t k = 0; k < from_.size(); ++k)
      if (from_[k] >= 0) coarse[from_[k]] += fine[k];
  }
  coarse_r_->putScalar(0);
  coarse_r_->doExport(*ghosted_, continuum_.space().import(), Tpetra::ADD);
  continuum_.preconditioner()->apply(*coarse_r_, *coarse_z_);
  ghosted_->doImport(*coarse_z_, continuum_.space().import(), Tpetra::INSERT);
  const double* coarse = local_view(*ghosted_);
  double* fine = local_view_to_write(z);
  for (std::size_t k = 0; k < from_.size(); ++k)
    if (from_[k] >= 0) fine[k] += coarse[from_[k]];
}

}  // namespace voussoir

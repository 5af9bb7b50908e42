// Nodes between held ones, which multigrid must not be given: its aggregates of them cannot move like rigid bodies.
//
// A node all of whose neighbours are held, but for some on one line through it, is held from all other sides. Rigid
// motions of such nodes are not independent: a single one does not turn, those on a line do not turn about it. Levels
// of multigrid would have columns of zeros for them, and prolongators of least energy would be asked for what no motion
// fulfils. They need no levels either: no more than two of them share a cell, so the matrices of nodes alone, without
// what is between them and others, are their preconditioner, with eigenvalues up to 2 and away from 0.
#pragma once

#include <memory>
#include <vector>

#include "base/dense.hpp"
#include "homogenisation/merged_space.hpp"
#include "linalg/preconditioner.hpp"

namespace voussoir {

class LoneNodes {
 public:
  /// @param a       of a space, with its column map, by nodes. Held unknowns stand alone in it
  /// @param places  of nodes, an unknown each [m]
  /// Collective.
  LoneNodes(const TpetraMatrix& a, const MergedSpace&, const TpetraVector& places);

  /// Of all ranks.
  bool any() const { return any_; }
  /// Whether there are other nodes with something free, on any rank.
  bool others() const { return others_; }
  /// The matrix without what is between lone nodes and others, and between unknowns of a lone node. Collective.
  Teuchos::RCP<TpetraMatrix> left_out_of(const TpetraMatrix& a) const;
  /// A preconditioner of the others, or none, and lone nodes each for itself.
  std::shared_ptr<const Preconditioner> beside(std::shared_ptr<const Preconditioner> of_others) const;

 private:
  std::vector<char> lone_;  ///< per cluster
  int dim_, owned_;
  bool any_ = false, others_ = false;
  std::vector<int> node_;          ///< owned lone ones
  std::vector<Matrix<3>> matrix_;  ///< of each, zero beyond the components
};

}  // namespace voussoir

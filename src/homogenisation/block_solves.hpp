// Exact solves on single blocks, each with its share of the contact stiffness around it.
#pragma once

#include <memory>

#include "homogenisation/system_matrix.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace voussoir {

class BlockSolves {
 public:
  /// @param active  per local block: 1 if a point of it is selected
  BlockSolves(const BlockSystem&, const MergedSpace&, const std::vector<char>& active);

  /// Factors the blocks' parts of H.
  void update(const OwnedRows& h);
  /// z += factor * sum over blocks of E_b W (H_bb)^-1 W E_b^T r, the weights W sharing unknowns of several blocks.
  /// Not a number on a rank whose blocks cannot be solved.
  void add(const TpetraVector& r, TpetraVector& z, double factor) const;
  long long bytes() const;

 private:
  std::vector<int> unknown_;  ///< owned unknown of each row of the block-diagonal matrix
  std::vector<int> block_start_;
  std::vector<double> weight_;  ///< per row: 1 / sqrt(number of blocks with this unknown)
  std::unique_ptr<SparseCholesky> factor_;
  mutable std::vector<double> work_;
};

}  // namespace voussoir

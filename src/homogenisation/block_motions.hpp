// The rigid-block operator: what is left of a structure when its stones only move as wholes.
//
// Coarse unknowns are, for every block with a selected point, its rigid motions (3 in 2D, 6 in 3D). Where nodes are
// tied the motion is the mean of the blocks'. To save memory Z is kept as one lever arm per node copy, Z^T H Z, which
// is symmetric, as its upper half, and what a point adds to it is computed at every update. Every rank holds and
// factors the whole coarse matrix.
#pragma once

#include <memory>

#include "homogenisation/system_matrix.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace voussoir {

class BlockMotions {
 public:
  /// @param active  per block of the whole structure: 1 if a point of it is selected
  BlockMotions(const BlockSystem&, const ContactPoints&, const std::vector<char>& selected, const MergedSpace&,
               const std::vector<int>& active);
  ~BlockMotions();

  /// Assembles Z^T H Z for new statuses and factors it. Collective.
  void update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal);
  /// z += Z (Z^T H Z)^-1 Z^T r. Collective.
  void add(const TpetraVector& r, TpetraVector& z) const;
  int size() const;
  long long bytes() const;

 private:
  struct Kernel;
  template <int dim>
  class Motions;
  std::unique_ptr<Kernel> kernel_;  ///< of the plane or of space
};

}  // namespace voussoir

// The rigid-block operator: what is left of a structure when its stones only move as wholes.
//
// Coarse unknowns are, for every block with a selected point, its rigid motions (3 in 2D, 6 in 3D). Where nodes are
// tied the motion is the mean of the blocks'. To save memory Z is kept as one lever arm per node copy, this rank's part
// of Z^T H Z, which is symmetric, as its upper half, and what a point adds to it is computed at every update. A rank
// knows the motions of its own blocks and of those around; parts are added up and factored by linalg/shared_system.
#pragma once

#include <memory>
#include <vector>

#include "homogenisation/system_matrix.hpp"

namespace voussoir {

struct MultigridLevel;
struct SharedSystemParameters;
enum class SolvedBy : int;

class BlockMotions {
 public:
  /// @param active  per local block: 1 if a point of it is selected. Collective
  BlockMotions(const BlockSystem&, const ContactPoints&, const std::vector<char>& selected, const MergedSpace&,
               const std::vector<char>& active);
  BlockMotions(const BlockSystem&, const ContactPoints&, const std::vector<char>& selected, const MergedSpace&,
               const std::vector<char>& active, const SharedSystemParameters&);
  ~BlockMotions();

  /// However many motions there are. Before the first update.
  void factor_on_first_rank();
  /// Assembles Z^T H Z for new statuses and factors it, or builds levels of it. Collective.
  SolvedBy update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal);
  /// z += Z (Z^T H Z)^-1 Z^T r, or with a cycle of levels in place of the inverse. Collective.
  void add(const TpetraVector& r, TpetraVector& z) const;
  /// Of all ranks.
  long long size() const;
  /// Of groups of blocks, from the finest to the coarsest; none where Z^T H Z is factored. Collective.
  std::vector<MultigridLevel> levels() const;
  long long bytes() const;

 private:
  struct Kernel;
  template <int dim>
  class Motions;
  std::unique_ptr<Kernel> kernel_;  ///< of the plane or of space
};

}  // namespace voussoir

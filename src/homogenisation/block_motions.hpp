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

template <int dim>
class BlockMotions {
 public:
  /// @param active  per block of the whole structure: 1 if a point of it is selected
  BlockMotions(const Structure<dim>&, const ContactPoints&, const std::vector<char>& selected, const MergedSpace<dim>&,
               const std::vector<int>& active);

  /// Assembles Z^T H Z for new statuses and factors it. Collective.
  void update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal);
  /// z += Z (Z^T H Z)^-1 Z^T r. Collective.
  void add(const TpetraVector& r, TpetraVector& z) const;
  int size() const { return modes * blocks_; }
  long long bytes() const;

 private:
  static constexpr int modes = dim + dim * (dim - 1) / 2;  ///< of a block: translations and turns
  using Modes = std::array<double, modes>;
  /// A node copy that moves with its block.
  struct Copy {
    int block;        ///< among those that are active
    Vector<dim> arm;  ///< [-] from the first node of the block, by the length of its first diagonal
  };
  /// What the motions of one block contribute to some combination of unknowns.
  struct Term {
    int block;
    Modes value;
  };
  using Row = std::vector<Term>;  ///< ascending by block

  static Modes motion(const Vector<dim>& arm, const Vector<dim>& direction);
  static Vector<dim> displacement(const Vector<dim>& arm, const Modes&);
  std::vector<int> copies_met(const std::vector<char>& selected) const;
  void find_copies(const std::vector<int>& number, const std::vector<int>& met);
  void set_pattern(const std::vector<char>& selected);
  void add_elastic_energy();
  void add_motion(int cluster, Vector<dim> direction, double factor, Row&) const;
  std::size_t place(int block, int other) const;
  void add_to(int block, int other, const Modes& left, const double* right);
  void add_product(const Row&, double factor);

  const Structure<dim>& structure_;
  const ContactPoints& points_;
  const MergedSpace<dim>& space_;
  int blocks_ = 0;               ///< that are active
  std::vector<int> copy_start_;  ///< per cluster, those of other ranks too where an owned block touches them
  std::vector<Copy> copies_;
  std::vector<int> couplings_;   ///< owned selected points that couple clusters
  LocalCsr matrix_;              ///< upper half of Z^T H Z, the same pattern on every rank; values while it is factored
  std::vector<double> elastic_;  ///< this rank's part of Z^T K Z, in the pattern of the matrix
  std::unique_ptr<SparseCholesky> factor_;
};

extern template class BlockMotions<2>;
extern template class BlockMotions<3>;

}  // namespace voussoir

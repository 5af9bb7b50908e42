// The rigid-block operator: what is left of a structure when its stones only move as wholes.
//
// Coarse unknowns are, for every block with a selected point, its rigid motions (3 in 2D, 6 in 3D). Where nodes are
// tied the motion is the mean of the blocks'.
// Every rank holds and factors the whole coarse matrix.
#pragma once

#include <cstdint>
#include <memory>

#include "homogenisation/system_matrix.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace voussoir {

template <int dim>
class BlockMotions {
 public:
  /// @param active  per block of the whole structure: 1 if a point of it is selected
  BlockMotions(const Structure<dim>&, const ContactPoints<dim>&, const std::vector<char>& selected,
               const MergedSpace<dim>&, const std::vector<int>& active);

  /// Assembles Z^T H Z for new statuses and factors it. Collective.
  void update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal);
  /// z += Z (Z^T H Z)^-1 Z^T r. Collective.
  void add(const TpetraVector& r, TpetraVector& z) const;
  int size() const { return size_; }
  long long bytes() const;

 private:
  static constexpr int modes = dim * (dim + 1) / 2;
  /// One column's value of Z in some combination of unknowns.
  struct Entry {
    int column;
    double value;
  };
  using Row = std::vector<Entry>;
  using Place = std::uint32_t;  ///< in the matrix; there are some forty per unknown

  Row row_of(int node, int component) const;
  Row jump_row(const ContactPoint<dim>&, int axis) const;
  void set_pattern(const std::vector<Row>& couplings);
  std::vector<Place> places(const Row&) const;
  void add_elastic_energy();

  const Structure<dim>& structure_;
  const ContactPoints<dim>& points_;
  const MergedSpace<dim>& space_;
  std::vector<int> first_column_;         ///< per block of the structure, -1 when not active
  std::vector<std::vector<int>> copies_;  ///< node copies of each cluster at an owned vertex
  std::vector<std::size_t> z_start_;
  Row z_;                                 ///< Z at owned unknowns, compressed rows
  std::vector<int> jump_point_;           ///< owned selected points that couple clusters
  std::vector<Row> jump_;                 ///< dim rows for each of them
  std::vector<Place> jump_place_, z_place_;  ///< of their products in the matrix, one row after the other
  LocalCsr matrix_;                       ///< dense blocks of modes x modes, the same pattern on every rank
  std::vector<double> elastic_;           ///< this rank's part of Z^T K Z, in the pattern of the matrix
  int size_ = 0;
  std::unique_ptr<SparseCholesky> factor_;
};

extern template class BlockMotions<2>;

}  // namespace voussoir

// The block-level system of one selection.
//
//   H = R^T K R + sum over closed points  sigma_N n n^T + sum over sticking points  sigma_T t t^T + proximal diagonal
//
// K never changes; every rank builds the complete rows it owns from its blocks and halo, so neither assembly nor
// a change of status communicates. Held unknowns are unit rows scaled like the rest.
// Rows are there once, in arrays that Tpetra uses too. What points and the proximal term add to stands in the blocks
// of a node and itself, whose stiffness is remembered, and in those of two nodes of a point. These have none where the
// nodes are of two blocks; what they have of one block, that a point with weights reaches twice, is remembered too.
#pragma once

#include <array>
#include <vector>

#include "homogenisation/merged_space.hpp"
#include "joints/contact_law.hpp"

namespace voussoir {

/// Rows of a matrix that a rank owns; columns of the column map, ascending.
struct OwnedRows {
  const std::size_t* start;
  const int* column;
  const double* value;
};

class SystemMatrix {
 public:
  using Matrix = std::shared_ptr<const LocalCsr>;
  /// @param of_block  the matrix of each block that H is made of
  SystemMatrix(const BlockSystem&, const ContactPoints&, const std::vector<char>& selected, const MergedSpace&,
               Matrix NodesOfBlock::*of_block = &NodesOfBlock::stiffness);

  /// Sets H from statuses and the proximal diagonal [N/m per owned unknown].
  /// @param stiffness  per local contact point; only selected points count
  void update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal);

  /// Adds the couplings, after what the preconditioner is made of was read: friction that follows the pressure makes
  /// rows of H unsymmetric. Returns whether any point of any rank is coupled.
  bool couple(const std::vector<PointStiffness>& stiffness);

  const Teuchos::RCP<TpetraMatrix>& matrix() const { return matrix_; }
  OwnedRows local() const { return {start_.data(), column_.data(), value_.data()}; }
  /// Of this rank: the rows, and the stiffness at nodes.
  long long bytes() const;

 private:
  using Csr = TpetraMatrix::local_matrix_device_type;
  using NodeBlock = std::array<double, 9>;

  void set_pattern();
  void add_stiffness();
  void remember_stiffness_of_points();
  template <class F>
  void each_place_of_points(const F&);
  void forget_points();
  template <class Value>
  void add_along_own(int node, int other, const Value&);
  template <int dim, class Weight>
  void add_between(int k, const Weight&);
  template <int dim>
  void add_points(const std::vector<PointStiffness>&);
  template <int dim>
  void add_couplings(int k, const PointStiffness&);
  bool couples(int k) const;
  std::size_t offset(int node, int other) const;
  double& entry(int node, std::size_t offset, int i, int j) { return value_(start_(dim_ * node + i) + offset + j); }

  const int dim_;
  const BlockSystem& structure_;
  const ContactPoints& points_;
  const std::vector<char>& selected_;
  const MergedSpace& space_;
  Matrix NodesOfBlock::*of_block_;
  Csr::row_map_type::non_const_type start_;
  Csr::index_type::non_const_type column_;
  Csr::values_type::non_const_type value_;
  std::vector<int> diagonal_;               ///< per owned node: where its own columns begin in its rows
  std::vector<double> diagonal_stiffness_;  ///< [components, squared] per owned node
  /// Stiffness between two nodes that a point couples as well.
  struct Remembered {
    int node;
    std::size_t offset;
    NodeBlock stiffness;
  };
  std::vector<Remembered> remembered_;
  Teuchos::RCP<TpetraMatrix> matrix_;
};

}  // namespace voussoir

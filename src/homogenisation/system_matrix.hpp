// The block-level system of one selection.
//
//   H = R^T K R + sum over closed points  sigma_N n n^T + sum over sticking points  sigma_T t t^T + proximal diagonal
//
// K never changes; every rank builds the complete rows it owns from its blocks and halo, so neither assembly nor
// a change of status communicates. Held unknowns are unit rows scaled like the rest.
#pragma once

#include <vector>

#include "homogenisation/merged_space.hpp"
#include "joints/contact_law.hpp"

namespace voussoir {

template <int dim>
class SystemMatrix {
 public:
  SystemMatrix(const Structure<dim>&, const ContactPoints<dim>&, const std::vector<char>& selected,
               const MergedSpace<dim>&);

  /// Sets H from statuses and the proximal diagonal [N/m per owned unknown].
  /// @param stiffness  per local contact point; only selected points count
  void update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal);

  /// Adds the couplings, after what the preconditioner is made of was read: friction that follows the pressure makes
  /// rows of H unsymmetric. Returns whether any point of any rank is coupled.
  bool couple(const std::vector<PointStiffness>& stiffness);

  const Teuchos::RCP<TpetraMatrix>& matrix() const { return matrix_; }
  /// Rows this rank owns, columns of the column map.
  const LocalCsr& local() const { return local_; }
  /// Of this rank: the rows twice, here and in Tpetra, and their stiffness.
  long long bytes() const {
    return 2 * local_.bytes() +
           static_cast<long long>(stiffness_values_.size() * sizeof(double) + diagonal_.size() * sizeof(std::size_t));
  }

 private:
  template <class Weight>
  void add_between(int k, const Weight&);
  void add_point(int k, const PointStiffness&);
  void copy_values();
  double& entry(int row, int column);

  const Structure<dim>& structure_;
  const ContactPoints<dim>& points_;
  const std::vector<char>& selected_;
  const MergedSpace<dim>& space_;
  LocalCsr local_;
  std::vector<double> stiffness_values_;
  std::vector<std::size_t> diagonal_;
  Teuchos::RCP<TpetraMatrix> matrix_;
};

extern template class SystemMatrix<2>;

}  // namespace voussoir

// Systems of a few unknowns, dense. The work is Eigen's, which the source alone includes.
#pragma once

#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// Square, row by row.
template <int n>
using Matrix = std::array<Vector<n>, static_cast<std::size_t>(n)>;

/// The x of A x = b for a symmetric positive definite A. Where nothing resists (A is zero along it) x is zero.
Vector<3> solve_positive(const Matrix<3>& a, const Vector<3>& b);
Vector<6> solve_positive(const Matrix<6>& a, const Vector<6>& b);

/// The same for as many unknowns as b has, A row by row and without a direction in which nothing resists: x takes the
/// place of b, and A is used up. Throws std::logic_error where A is not positive definite.
void solve_positive(std::vector<double>& a, std::vector<double>& b);

/// The X of M X = A, with pivots chosen by size; not a number where M is singular.
Matrix<3> solve_general(const Matrix<3>& m, const Matrix<3>& a);

double determinant(const Matrix<3>&);

/// The x with the least |sum x_i column_i - b|; where columns depend on each other to round-off those that the others
/// stand for count for nothing. At least one column, each as long as b.
std::vector<double> least_squares(const std::vector<std::vector<double>>& columns, const std::vector<double>& b);

/// Eigenvalues of a symmetric matrix, ascending, with their eigenvectors of length one, a row each.
struct Eigenvectors {
  Vector<4> value;
  Matrix<4> vector;
};
Eigenvectors eigenvectors(const Matrix<4>&);

}  // namespace voussoir

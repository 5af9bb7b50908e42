#include "base/dense.hpp"

#include <Eigen/Dense>

#include "base/check.hpp"

namespace voussoir {
namespace {

// [-] What is left of a column beside others on which it depends is its round-off, a few hundred times less than this.
constexpr double depends = 1e-13;

template <int n>
using Rows = Eigen::Matrix<double, n, n, Eigen::RowMajor>;

Eigen::Map<const Rows<3>> view(const Matrix<3>& a) { return Eigen::Map<const Rows<3>>(a[0].data()); }
Eigen::Map<Rows<3>> view(Matrix<3>& a) { return Eigen::Map<Rows<3>>(a[0].data()); }

template <int n>
Vector<n> solved(const Matrix<n>& a, const Vector<n>& b) {
  using Column = Eigen::Matrix<double, n, 1>;
  Vector<n> x;
  Eigen::Map<Column>(x.data()) = Eigen::LDLT<Eigen::Matrix<double, n, n>>(Eigen::Map<const Rows<n>>(a[0].data()))
                                     .solve(Eigen::Map<const Column>(b.data()));
  return x;
}

}  // namespace

Vector<3> solve_positive(const Matrix<3>& a, const Vector<3>& b) { return solved<3>(a, b); }
Vector<6> solve_positive(const Matrix<6>& a, const Vector<6>& b) { return solved<6>(a, b); }

void solve_positive(std::vector<double>& a, std::vector<double>& b) {
  const auto n = static_cast<Eigen::Index>(b.size());
  VOUSSOIR_EXPECT(a.size() == b.size() * b.size());
  Eigen::Map<Eigen::MatrixXd> matrix(a.data(), n, n);  // symmetric, so rows may be columns
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factors(matrix);
  VOUSSOIR_EXPECT(factors.info() == Eigen::Success);
  Eigen::Map<Eigen::VectorXd> x(b.data(), n);
  factors.solveInPlace(x);
}

Matrix<3> solve_general(const Matrix<3>& m, const Matrix<3>& a) {
  Matrix<3> x;
  view(x) = Eigen::PartialPivLU<Eigen::Matrix3d>(view(m)).solve(view(a));
  return x;
}

double determinant(const Matrix<3>& a) { return view(a).determinant(); }

std::vector<double> least_squares(const std::vector<std::vector<double>>& columns, const std::vector<double>& b) {
  const auto rows = static_cast<Eigen::Index>(b.size());
  Eigen::MatrixXd a(rows, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    VOUSSOIR_EXPECT(columns[j].size() == b.size());
    a.col(static_cast<Eigen::Index>(j)) = Eigen::Map<const Eigen::VectorXd>(columns[j].data(), rows);
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(a.rows(), a.cols());
  factors.setThreshold(depends);
  std::vector<double> x(columns.size());
  Eigen::Map<Eigen::VectorXd>(x.data(), a.cols()) =
      factors.compute(a).solve(Eigen::Map<const Eigen::VectorXd>(b.data(), rows));
  return x;
}

Eigenvectors eigenvectors(const Matrix<4>& a) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(Eigen::Map<const Rows<4>>(a[0].data()));
  Eigenvectors found;
  Eigen::Map<Eigen::Vector4d>(found.value.data()) = solver.eigenvalues();
  Eigen::Map<Rows<4>>(found.vector[0].data()) = solver.eigenvectors().transpose();
  return found;
}

}  // namespace voussoir

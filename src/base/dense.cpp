#include "base/dense.hpp"

#include <Eigen/Dense>

#include "base/check.hpp"

namespace voussoir {
namespace {

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

Eigenvectors eigenvectors(const Matrix<4>& a) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(Eigen::Map<const Rows<4>>(a[0].data()));
  Eigenvectors found;
  Eigen::Map<Eigen::Vector4d>(found.value.data()) = solver.eigenvalues();
  Eigen::Map<Rows<4>>(found.vector[0].data()) = solver.eigenvectors().transpose();
  return found;
}

}  // namespace voussoir

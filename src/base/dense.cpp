#include "base/dense.hpp"

#include <Eigen/Dense>

#include "base/check.hpp"

namespace voussoir {
namespace {

using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Eigen::Map<const Rows> view(const Matrix<3>& a) { return Eigen::Map<const Rows>(a[0].data()); }
Eigen::Map<Rows> view(Matrix<3>& a) { return Eigen::Map<Rows>(a[0].data()); }

}  // namespace

Vector<3> solve_positive(const Matrix<3>& a, const Vector<3>& b) {
  Vector<3> x;
  Eigen::Map<Eigen::Vector3d>(x.data()) =
      Eigen::LDLT<Eigen::Matrix3d>(view(a)).solve(Eigen::Map<const Eigen::Vector3d>(b.data()));
  return x;
}

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

}  // namespace voussoir

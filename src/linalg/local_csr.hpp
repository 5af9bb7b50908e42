// A sparse matrix of one rank in compressed rows: stiffness of blocks, small factors.
#pragma once

#include <algorithm>
#include <vector>

namespace voussoir {

struct LocalCsr {
  std::vector<int> start{0};  ///< [rows + 1]
  std::vector<int> column;    ///< ascending in each row
  std::vector<double> value;

  long long bytes() const {
    return static_cast<long long>((start.size() + column.size()) * sizeof(int) + value.size() * sizeof(double));
  }
  int rows() const { return static_cast<int>(start.size()) - 1; }

  /// The entry of a row in a column that its pattern has.
  double& at(int row, int in_column) {
    const auto first = column.begin() + start[row], last = column.begin() + start[row + 1];
    return value[std::lower_bound(first, last, in_column) - column.begin()];
  }

  /// y = A x
  void multiply(const double* x, double* y) const {
    for (int i = 0; i < rows(); ++i) {
      double sum = 0;
      for (int k = start[i]; k < start[i + 1]; ++k) sum += value[k] * x[column[k]];
      y[i] = sum;
    }
  }
};

}  // namespace voussoir

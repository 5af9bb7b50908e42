#include "linalg/sparse_cholesky.hpp"

#include <omp.h>
#include <suitesparse/cholmod.h>

#include <algorithm>
#include <new>
#include <utility>

#include "base/check.hpp"
#include "linalg/solver_failure.hpp"

namespace voussoir {

struct SparseCholesky::Data {
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  int size = 0;

  Data() {
    cholmod_start(&common);
    common.print = 0;
    common.final_ll = 1;
  }
  ~Data() {
    if (factor) cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
};

namespace {

/// While it lives OpenMP starts no threads. CHOLMOD asks for four in every factorisation, whatever OMP_NUM_THREADS
/// says. A rank has one core, where four threads take a fifth longer than one.
class OneThread {
 public:
  OneThread() { omp_set_max_active_levels(0); }
  ~OneThread() { omp_set_max_active_levels(levels_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  const int levels_ = omp_get_max_active_levels();
};

/// The upper triangle by rows is what CHOLMOD takes for the lower triangle by columns.
cholmod_sparse lower_triangle(const LocalCsr& a) {
  cholmod_sparse lower{};
  lower.nrow = lower.ncol = static_cast<std::size_t>(a.rows());
  lower.nzmax = a.column.size();
  lower.p = const_cast<int*>(a.start.data());  // CHOLMOD asks for pointers to what it does not change
  lower.i = const_cast<int*>(a.column.data());
  lower.x = const_cast<double*>(a.value.data());
  lower.stype = -1;
  lower.itype = CHOLMOD_INT;
  lower.xtype = CHOLMOD_REAL;
  lower.dtype = CHOLMOD_DOUBLE;
  lower.sorted = lower.packed = 1;
  return lower;
}

}  // namespace

SparseCholesky::SparseCholesky(const LocalCsr& a) : data_(std::make_unique<Data>()) {
  data_->size = a.rows();
  refactor(a);
}

void SparseCholesky::refactor(const LocalCsr& a) {
  auto& d = *data_;
  VOUSSOIR_EXPECT(a.rows() == d.size);
  if (d.size == 0) return;
  const OneThread alone;
  auto lower = lower_triangle(a);
  if (!d.factor) d.factor = cholmod_analyze(&lower, &d.common);
  // Where METIS had too little memory the status says that the order is invalid.
  if (!d.factor && d.common.status == CHOLMOD_TOO_LARGE)
    throw solver_failure("CHOLMOD", "order a matrix that is too large", d.common.status);
  if (!d.factor) throw std::bad_alloc();
  cholmod_factorize(&lower, d.factor, &d.common);
  if (d.common.status == CHOLMOD_NOT_POSDEF) {
    auto raised = a.value;
    double largest = 0;
    for (int i = 0; i < d.size; ++i) largest = std::max(largest, a.value[a.start[i]]);
    // 1e-10: above the round-off of a factorisation (1e-16 times growth), far below any stiffness that matters.
    for (int i = 0; i < d.size; ++i) raised[a.start[i]] += 1e-10 * (largest > 0 ? largest : 1.0);
    lower.x = raised.data();
    cholmod_factorize(&lower, d.factor, &d.common);
  }
  cholmod_free_work(&d.common);
  if (d.common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  if (d.common.status == CHOLMOD_NOT_POSDEF)
    throw solver_failure("CHOLMOD", "factor a matrix that is not positive definite", d.common.status);
  if (d.common.status != CHOLMOD_OK) throw solver_failure("CHOLMOD", "factor a matrix", d.common.status);
  // A number off the diagonal that is none passes CHOLMOD by where blocks are small; it makes the pivot of its row
  // none, which the ratio of the pivots shows: 0.
  if (cholmod_rcond(d.factor, &d.common) <= 0)
    throw solver_failure("CHOLMOD", "factor a matrix with entries that are not finite", d.common.status);
}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

int SparseCholesky::size() const { return data_->size; }

long long SparseCholesky::bytes() const { return static_cast<long long>(data_->common.memory_inuse); }

void SparseCholesky::solve(const double* b, double* x, int columns) const {
  auto& d = *data_;
  const std::size_t numbers = static_cast<std::size_t>(d.size) * columns;
  if (numbers == 0) return;
  cholmod_dense* right = cholmod_allocate_dense(d.size, columns, d.size, CHOLMOD_REAL, &d.common);
  if (!right) throw std::bad_alloc();
  std::copy(b, b + numbers, static_cast<double*>(right->x));
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, d.factor, right, &d.common);
  if (!solution) {
    const int status = d.common.status;
    cholmod_free_dense(&right, &d.common);
    if (status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    throw solver_failure("CHOLMOD", "solve with its factors", status);
  }
  std::copy(static_cast<double*>(solution->x), static_cast<double*>(solution->x) + numbers, x);
  cholmod_free_dense(&solution, &d.common);
  cholmod_free_dense(&right, &d.common);
}

}  // namespace voussoir

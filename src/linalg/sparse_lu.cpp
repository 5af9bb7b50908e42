#include "linalg/sparse_lu.hpp"

#include <suitesparse/umfpack.h>

#include <new>
#include <vector>

#include "base/check.hpp"
#include "linalg/solver_failure.hpp"

namespace voussoir {

struct SparseLu::Data {
  void* order = nullptr;
  void* factor = nullptr;
  int rows = 0;
  double units = 0;  ///< of memory
  int unit = 0;      ///< bytes of each

  Data() = default;
  ~Data() {
    umfpack_di_free_numeric(&factor);
    umfpack_di_free_symbolic(&order);
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
};

namespace {

// A pivot off the diagonal is taken where that on it is smaller than this share of its column. Stones that hardly
// anything holds have such columns, and each pivot off the diagonal fills the factors. UMFPACK's own 1e-3 more than
// doubles the time of the patches of large walls, in as many steps; below 1e-6 little is left to gain.
constexpr double smallest_pivot = 1e-6;

/// False where the matrix is singular.
bool regular(int status, const char* what) {
  if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
  if (status != UMFPACK_OK && status != UMFPACK_WARNING_singular_matrix) throw solver_failure("UMFPACK", what, status);
  return status == UMFPACK_OK;
}

/// Values for the pattern of a matrix in which pivots stay on the diagonal.
std::vector<double> with_strong_diagonal(const LocalCsr& a) {
  std::vector<double> value(a.column.size(), -1.0);
  for (int i = 0; i < a.rows(); ++i)
    for (int e = a.start[i]; e < a.start[i + 1]; ++e)
      if (a.column[e] == i) value[e] = a.start[i + 1] - a.start[i];
  return value;
}

}  // namespace

SparseLu::SparseLu() : data_(std::make_unique<Data>()) {}
SparseLu::~SparseLu() = default;

// UMFPACK reads columns: rows of A are the columns of its transpose.
bool SparseLu::factor(const LocalCsr& a) {
  auto& d = *data_;
  if (!d.order) {
    d.rows = a.rows();
    // By the pattern alone, so that factors are the same whichever values came first: as if the diagonal were strong.
    const auto pattern = with_strong_diagonal(a);
    regular(umfpack_di_symbolic(d.rows, d.rows, a.start.data(), a.column.data(), pattern.data(), &d.order, nullptr,
                                nullptr),
            "order a matrix");
  }
  VOUSSOIR_EXPECT(a.rows() == d.rows);
  umfpack_di_free_numeric(&d.factor);
  double info[UMFPACK_INFO], control[UMFPACK_CONTROL];
  umfpack_di_defaults(control);
  control[UMFPACK_SYM_PIVOT_TOLERANCE] = smallest_pivot;
  const int status =
      umfpack_di_numeric(a.start.data(), a.column.data(), a.value.data(), d.order, &d.factor, control, info);
  const bool solvable = regular(status, "factor a matrix");
  d.units = info[UMFPACK_NUMERIC_SIZE] + info[UMFPACK_SYMBOLIC_SIZE];
  d.unit = static_cast<int>(info[UMFPACK_SIZE_OF_UNIT]);
  return solvable;
}

long long SparseLu::bytes() const { return static_cast<long long>(data_->units) * data_->unit; }

bool SparseLu::solve(const LocalCsr& a, const double* b, double* x) const {
  VOUSSOIR_EXPECT(data_->factor != nullptr);
  // Refinement, which UMFPACK does by default, is half of the time of a solution, and changes no solve of a patch.
  double control[UMFPACK_CONTROL];
  umfpack_di_defaults(control);
  control[UMFPACK_IRSTEP] = 0;
  return regular(umfpack_di_solve(UMFPACK_At, a.start.data(), a.column.data(), a.value.data(), x, b, data_->factor,
                                  control, nullptr),
                 "solve with its factors");
}

}  // namespace voussoir

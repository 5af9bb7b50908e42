#include "linalg/blas_memory.hpp"

#include <Teuchos_LAPACK.hpp>
#include <cstddef>
#include <new>

namespace voussoir {
namespace {

// OpenBLAS's buffer of 128 MB and its pages around it.
constexpr std::size_t buffer_bytes = std::size_t{144} << 20;

}  // namespace

void reserve_blas_memory() {
  ::operator delete(::operator new(buffer_bytes));  // a new-expression might be optimised away
  double one = 1;
  int info = 0;
  Teuchos::LAPACK<int, double>().POTRF('L', 1, &one, 1, &info);
}

}  // namespace voussoir

// Memory that the BLAS needs, taken before anything is computed.
//
// OpenBLAS before 0.3.30 asks for its one buffer (128 MB of addresses) at the first factorisation and, where that is
// not to be had, asks again for ever (github.com/OpenMathLib/OpenBLAS/issues/5289).
#pragma once

namespace voussoir {

/// Has the BLAS take its buffer, which it keeps.
/// @throws std::bad_alloc where there is no room for it
void reserve_blas_memory();

}  // namespace voussoir

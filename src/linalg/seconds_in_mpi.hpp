// How long this rank is inside MPI, where a program links those who count (traffic.hpp).
#pragma once

namespace voussoir {

/// Seconds of the processor since it began, waiting for others among them; nothing where the program does not count.
double seconds_in_mpi();
/// For those who count.
void add_seconds_in_mpi(double seconds);

}  // namespace voussoir

#include "base/before_mpi.hpp"

#include <cstdlib>
#include <string>

namespace voussoir {

namespace {

/// Whether no more than one rank was started. mpirun tells each rank how many there are; batch systems start ranks
/// without it, and tell each its number.
bool is_single_rank() {
  if (const char* ranks = std::getenv("OMPI_COMM_WORLD_SIZE")) return std::string(ranks) == "1";
  return !std::getenv("PMIX_RANK") && !std::getenv("PMI_RANK");
}

}  // namespace

void before_mpi() {
  ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  ::setenv("OMPI_MCA_sharedfp", "individual", 0);
  if (is_single_rank()) ::setenv("OMPI_MCA_mpi_yield_when_idle", "0", 1);
}

}  // namespace voussoir

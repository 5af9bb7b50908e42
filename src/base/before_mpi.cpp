#include "base/before_mpi.hpp"

#include <cstdlib>
#include <string>

namespace voussoir {

namespace {

/// mpirun tells each rank how many there are; batch systems start ranks without it, and tell each its number.
bool is_without_mpirun() {
  return !std::getenv("OMPI_COMM_WORLD_SIZE") && !std::getenv("PMIX_RANK") && !std::getenv("PMI_RANK");
}

bool is_single_rank() {
  const char* ranks = std::getenv("OMPI_COMM_WORLD_SIZE");
  return ranks ? std::string(ranks) == "1" : is_without_mpirun();
}

/// mpirun also tells each rank how many of them are on its machine.
bool is_on_one_machine() {
  const char* ranks = std::getenv("OMPI_COMM_WORLD_SIZE");
  const char* here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  return ranks ? here && std::string(here) == ranks : is_without_mpirun();
}

}  // namespace

void before_mpi() {
  ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  ::setenv("OMPI_MCA_sharedfp", "individual", 0);
  if (is_without_mpirun()) ::setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  if (is_on_one_machine()) ::setenv("OMPI_MCA_pml", "ob1", 0);
  if (is_single_rank()) ::setenv("OMPI_MCA_mpi_yield_when_idle", "0", 1);
}

}  // namespace voussoir

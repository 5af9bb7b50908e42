// The communicator that MPI and libraries on it take.
#pragma once

#include <Teuchos_DefaultMpiComm.hpp>

namespace voussoir {

inline MPI_Comm mpi_handle(const Teuchos::Comm<int>& comm) {
  const auto* mpi = dynamic_cast<const Teuchos::MpiComm<int>*>(&comm);
  return mpi ? (*mpi->getRawMpiComm())() : MPI_COMM_SELF;
}

}  // namespace voussoir

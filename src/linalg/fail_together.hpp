// The end of a rank that fails alone.
#pragma once

#include <Teuchos_Comm.hpp>
#include <exception>
#include <iostream>

#include "base/error.hpp"
#include "linalg/mpi_handle.hpp"

namespace voussoir {

/// Says that memory is short. With several ranks all of them end here, since the others wait for this one.
inline void end_out_of_memory(const Teuchos::Comm<int>& comm) {
  std::cerr << out_of_memory_message << "\n" << std::flush;
  if (comm.getSize() > 1) MPI_Abort(mpi_handle(comm), exit_resource);
}

/// Of a rank that has caught what nobody foresaw, thrown by a library or by a mistake of this program. Others may wait
/// for this rank, so all of them end.
inline void end_failed(const Teuchos::Comm<int>& comm, const std::string& what) {
  std::cerr << "The program, or a library that it uses, has failed and says:\n" + what +
                   "\n  Please report it with the scene. What was recorded is kept, and a state that was saved can be "
                   "gone on "
                   "with (--restart).\n"
            << std::flush;
  if (comm.getSize() > 1) MPI_Abort(mpi_handle(comm), exit_failed);
}

/// Within catch (...): the exit code after an exception that is none of ours.
inline int end_unforeseen(const Teuchos::Comm<int>& comm) {
  try {
    throw;
  } catch (const std::exception& error) {
    if (is_out_of_memory(error)) {
      end_out_of_memory(comm);
      return exit_resource;
    }
    end_failed(comm, error.what());
  } catch (...) {  // libraries throw numbers and strings too
    end_failed(comm, "(nothing: what was thrown has no words)");
  }
  return exit_failed;
}

/// Does work while things are held that all ranks let go together, such as open files. What all ranks throw alike
/// passes through. An exception of this rank alone must not: what is let go on its way out would wait for the others,
/// which wait for this rank elsewhere. So with several ranks the program ends where it is caught.
template <class Work>
auto fail_together(const Teuchos::Comm<int>& comm, const Work& work) {
  try {
    return work();
  } catch (const InputError&) {
    throw;
  } catch (const ConvergenceError&) {
    throw;
  } catch (const ResourceError&) {
    throw;
  } catch (...) {
    if (comm.getSize() == 1) throw;
    end_unforeseen(comm);
    throw;
  }
}

}  // namespace voussoir

// A library that makes one rank fail in one exchange: loaded before a program (LD_PRELOAD) it stands in the place of
// MPI's calls, counts those of rank FAILING_RANK, and throws in the place of number FAILING_CALL. With number 0 it
// throws nowhere, and says at the end how many there were.
//
// Calls of libraries written in C or Fortran, of HDF5 and MUMPS among them, pass: what is thrown must not go through
// them. So do looks for messages (MPI_Iprobe), of which there are more the longer one waits.
#include <dlfcn.h>
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace {

long number_of(const char* name) {
  const char* value = std::getenv(name);
  return value ? std::atol(value) : -1;
}

/// Whether that address belongs to the program itself or to Trilinos.
bool is_ours(void* caller) {
  Dl_info info;
  if (dladdr(caller, &info) == 0 || !info.dli_fname) return false;
  return std::strstr(info.dli_fname, "libtrilinos") || !std::strstr(info.dli_fname, ".so");
}

void count(const char* call, void* caller) {
  static const long rank_that_fails = number_of("FAILING_RANK"), call_that_fails = number_of("FAILING_CALL");
  struct Counted {
    long calls = 0;
    ~Counted() {
      if (calls > 0 && call_that_fails == 0) std::fprintf(stderr, "counted %ld calls\n", calls);
    }
  };
  static Counted counted;
  int rank = 0, over = 0;
  MPI_Finalized(&over);
  if (over || !is_ours(caller)) return;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != rank_that_fails || ++counted.calls != call_that_fails) return;
  std::fprintf(stderr, "planted in %s\n", call);
  throw std::runtime_error("a planted failure in " + std::string(call));
}

}  // namespace

// As mpi.h declares them, with names for what is handed on.
#define COUNTED(call, parameters, arguments)   \
  int call parameters {                        \
    count(#call, __builtin_return_address(0)); \
    return P##call arguments;                  \
  }

extern "C" {
COUNTED(MPI_Allreduce, (const void* a, void* b, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c), (a, b, n, t, o, c))
COUNTED(MPI_Reduce, (const void* a, void* b, int n, MPI_Datatype t, MPI_Op o, int r, MPI_Comm c), (a, b, n, t, o, r, c))
COUNTED(MPI_Scan, (const void* a, void* b, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c), (a, b, n, t, o, c))
COUNTED(MPI_Bcast, (void* a, int n, MPI_Datatype t, int r, MPI_Comm c), (a, n, t, r, c))
COUNTED(MPI_Barrier, (MPI_Comm c), (c))
COUNTED(MPI_Ibarrier, (MPI_Comm c, MPI_Request* q), (c, q))
COUNTED(MPI_Alltoall, (const void* a, int n, MPI_Datatype t, void* b, int m, MPI_Datatype u, MPI_Comm c),
        (a, n, t, b, m, u, c))
COUNTED(MPI_Alltoallv,
        (const void* a, const int* n, const int* d, MPI_Datatype t, void* b, const int* m, const int* e, MPI_Datatype u,
         MPI_Comm c),
        (a, n, d, t, b, m, e, u, c))
COUNTED(MPI_Allgather, (const void* a, int n, MPI_Datatype t, void* b, int m, MPI_Datatype u, MPI_Comm c),
        (a, n, t, b, m, u, c))
COUNTED(MPI_Allgatherv,
        (const void* a, int n, MPI_Datatype t, void* b, const int* m, const int* d, MPI_Datatype u, MPI_Comm c),
        (a, n, t, b, m, d, u, c))
COUNTED(MPI_Gather, (const void* a, int n, MPI_Datatype t, void* b, int m, MPI_Datatype u, int r, MPI_Comm c),
        (a, n, t, b, m, u, r, c))
COUNTED(MPI_Gatherv,
        (const void* a, int n, MPI_Datatype t, void* b, const int* m, const int* d, MPI_Datatype u, int r, MPI_Comm c),
        (a, n, t, b, m, d, u, r, c))
COUNTED(MPI_Send, (const void* a, int n, MPI_Datatype t, int r, int g, MPI_Comm c), (a, n, t, r, g, c))
COUNTED(MPI_Recv, (void* a, int n, MPI_Datatype t, int r, int g, MPI_Comm c, MPI_Status* s), (a, n, t, r, g, c, s))
COUNTED(MPI_Isend, (const void* a, int n, MPI_Datatype t, int r, int g, MPI_Comm c, MPI_Request* q),
        (a, n, t, r, g, c, q))
COUNTED(MPI_Issend, (const void* a, int n, MPI_Datatype t, int r, int g, MPI_Comm c, MPI_Request* q),
        (a, n, t, r, g, c, q))
COUNTED(MPI_Irecv, (void* a, int n, MPI_Datatype t, int r, int g, MPI_Comm c, MPI_Request* q), (a, n, t, r, g, c, q))
COUNTED(MPI_Waitall, (int n, MPI_Request* q, MPI_Status* s), (n, q, s))
}

// Stands between MPI's callers and MPI, counts what this rank sends, and how long it is inside. MPI's profiling
// interface allows it: every function has a second name that begins with P. Those that Trilinos, HDF5 and this program
// send and wait with are here; MUMPS goes by Fortran past them.
#include <mpi.h>

#include <ctime>

#include "linalg/seconds_in_mpi.hpp"
#include "linalg/traffic.hpp"

namespace {

using voussoir::add_seconds_in_mpi;
using voussoir::count_traffic;
using voussoir::note_size;
using voussoir::traffic_of_now;

[[maybe_unused]] const bool announced = (count_traffic(), true);

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One call: adds what it took of the processor.
class Inside {
 public:
  Inside() : start_(processor_seconds()) {}
  ~Inside() { add_seconds_in_mpi(processor_seconds() - start_); }
  Inside(const Inside&) = delete;

 private:
  double start_;
};

long long bytes_of(long long count, MPI_Datatype type) {
  int size = 0;
  PMPI_Type_size(type, &size);
  return count * size;
}

[[nodiscard]] Inside message(int count, MPI_Datatype type, int to) {
  if (to == MPI_PROC_NULL) return {};
  auto& traffic = traffic_of_now();
  const long long bytes = bytes_of(count, type);
  ++traffic.messages;
  traffic.bytes += bytes;
  note_size(bytes);
  return {};
}

/// @param type  of what is counted; MPI_BYTE where nothing is
[[nodiscard]] Inside collective(MPI_Comm comm, long long count = 0, MPI_Datatype type = MPI_BYTE) {
  int ranks = 1;
  PMPI_Comm_size(comm, &ranks);
  if (ranks == 1) return {};
  auto& traffic = traffic_of_now();
  const long long bytes = bytes_of(count, type);
  ++traffic.collectives;
  traffic.collective_bytes += bytes;
  note_size(bytes);
  return {};
}

long long sum_of(const int* counts, MPI_Comm comm) {
  int ranks = 1;
  PMPI_Comm_size(comm, &ranks);
  long long sum = 0;
  for (int rank = 0; rank < ranks; ++rank) sum += counts[rank];
  return sum;
}

bool in_place(const void* send) { return send == MPI_IN_PLACE; }

}  // namespace

extern "C" {

int MPI_Send(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c) {
  const auto inside = message(n, t, to);
  return PMPI_Send(b, n, t, to, tag, c);
}
int MPI_Ssend(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c) {
  const auto inside = message(n, t, to);
  return PMPI_Ssend(b, n, t, to, tag, c);
}
int MPI_Rsend(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c) {
  const auto inside = message(n, t, to);
  return PMPI_Rsend(b, n, t, to, tag, c);
}
int MPI_Bsend(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c) {
  const auto inside = message(n, t, to);
  return PMPI_Bsend(b, n, t, to, tag, c);
}
int MPI_Isend(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request* r) {
  const auto inside = message(n, t, to);
  return PMPI_Isend(b, n, t, to, tag, c, r);
}
int MPI_Issend(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request* r) {
  const auto inside = message(n, t, to);
  return PMPI_Issend(b, n, t, to, tag, c, r);
}
int MPI_Irsend(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request* r) {
  const auto inside = message(n, t, to);
  return PMPI_Irsend(b, n, t, to, tag, c, r);
}
int MPI_Sendrecv(const void* b, int n, MPI_Datatype t, int to, int tag, void* rb, int rn, MPI_Datatype rt, int from,
                 int rtag, MPI_Comm c, MPI_Status* s) {
  const auto inside = message(n, t, to);
  return PMPI_Sendrecv(b, n, t, to, tag, rb, rn, rt, from, rtag, c, s);
}

int MPI_Recv(void* b, int n, MPI_Datatype t, int from, int tag, MPI_Comm c, MPI_Status* s) {
  const Inside inside;
  return PMPI_Recv(b, n, t, from, tag, c, s);
}
int MPI_Probe(int from, int tag, MPI_Comm c, MPI_Status* s) {
  const Inside inside;
  return PMPI_Probe(from, tag, c, s);
}
int MPI_Iprobe(int from, int tag, MPI_Comm c, int* there, MPI_Status* s) {
  const Inside inside;
  return PMPI_Iprobe(from, tag, c, there, s);
}
int MPI_Wait(MPI_Request* q, MPI_Status* s) {
  const Inside inside;
  return PMPI_Wait(q, s);
}
int MPI_Waitall(int n, MPI_Request* q, MPI_Status* s) {
  const Inside inside;
  return PMPI_Waitall(n, q, s);
}
int MPI_Waitany(int n, MPI_Request* q, int* which, MPI_Status* s) {
  const Inside inside;
  return PMPI_Waitany(n, q, which, s);
}
int MPI_Waitsome(int n, MPI_Request* q, int* done, int* which, MPI_Status* s) {
  const Inside inside;
  return PMPI_Waitsome(n, q, done, which, s);
}
int MPI_Test(MPI_Request* q, int* done, MPI_Status* s) {
  const Inside inside;
  return PMPI_Test(q, done, s);
}
int MPI_Testall(int n, MPI_Request* q, int* done, MPI_Status* s) {
  const Inside inside;
  return PMPI_Testall(n, q, done, s);
}

int MPI_Barrier(MPI_Comm c) {
  const auto inside = collective(c);
  return PMPI_Barrier(c);
}
int MPI_Ibarrier(MPI_Comm c, MPI_Request* q) {
  const auto inside = collective(c);
  return PMPI_Ibarrier(c, q);
}
int MPI_Bcast(void* b, int n, MPI_Datatype t, int root, MPI_Comm c) {
  const auto inside = collective(c, n, t);
  return PMPI_Bcast(b, n, t, root, c);
}
int MPI_Allreduce(const void* b, void* r, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c) {
  const auto inside = collective(c, n, t);
  return PMPI_Allreduce(b, r, n, t, op, c);
}
int MPI_Iallreduce(const void* b, void* r, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c, MPI_Request* q) {
  const auto inside = collective(c, n, t);
  return PMPI_Iallreduce(b, r, n, t, op, c, q);
}
int MPI_Reduce(const void* b, void* r, int n, MPI_Datatype t, MPI_Op op, int root, MPI_Comm c) {
  const auto inside = collective(c, n, t);
  return PMPI_Reduce(b, r, n, t, op, root, c);
}
int MPI_Scan(const void* b, void* r, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c) {
  const auto inside = collective(c, n, t);
  return PMPI_Scan(b, r, n, t, op, c);
}
int MPI_Exscan(const void* b, void* r, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c) {
  const auto inside = collective(c, n, t);
  return PMPI_Exscan(b, r, n, t, op, c);
}
int MPI_Reduce_scatter(const void* b, void* r, const int* n, MPI_Datatype t, MPI_Op op, MPI_Comm c) {
  const auto inside = collective(c, sum_of(n, c), t);
  return PMPI_Reduce_scatter(b, r, n, t, op, c);
}
int MPI_Reduce_scatter_block(const void* b, void* r, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c) {
  const auto inside = collective(c, n, t);
  return PMPI_Reduce_scatter_block(b, r, n, t, op, c);
}
int MPI_Gather(const void* b, int n, MPI_Datatype t, void* r, int rn, MPI_Datatype rt, int root, MPI_Comm c) {
  const auto inside = collective(c, in_place(b) ? rn : n, in_place(b) ? rt : t);
  return PMPI_Gather(b, n, t, r, rn, rt, root, c);
}
int MPI_Gatherv(const void* b, int n, MPI_Datatype t, void* r, const int* rn, const int* d, MPI_Datatype rt, int root,
                MPI_Comm c) {
  const auto inside = collective(c, in_place(b) ? 0 : n, in_place(b) ? MPI_BYTE : t);
  return PMPI_Gatherv(b, n, t, r, rn, d, rt, root, c);
}
int MPI_Scatter(const void* b, int n, MPI_Datatype t, void* r, int rn, MPI_Datatype rt, int root, MPI_Comm c) {
  const auto inside = collective(c, in_place(r) ? n : rn, in_place(r) ? t : rt);
  return PMPI_Scatter(b, n, t, r, rn, rt, root, c);
}
int MPI_Scatterv(const void* b, const int* n, const int* d, MPI_Datatype t, void* r, int rn, MPI_Datatype rt, int root,
                 MPI_Comm c) {
  const auto inside = collective(c, in_place(r) ? 0 : rn, in_place(r) ? MPI_BYTE : rt);
  return PMPI_Scatterv(b, n, d, t, r, rn, rt, root, c);
}
int MPI_Allgather(const void* b, int n, MPI_Datatype t, void* r, int rn, MPI_Datatype rt, MPI_Comm c) {
  const auto inside = collective(c, in_place(b) ? rn : n, in_place(b) ? rt : t);
  return PMPI_Allgather(b, n, t, r, rn, rt, c);
}
int MPI_Allgatherv(const void* b, int n, MPI_Datatype t, void* r, const int* rn, const int* d, MPI_Datatype rt,
                   MPI_Comm c) {
  const auto inside = collective(c, in_place(b) ? 0 : n, in_place(b) ? MPI_BYTE : t);
  return PMPI_Allgatherv(b, n, t, r, rn, d, rt, c);
}
int MPI_Alltoall(const void* b, int n, MPI_Datatype t, void* r, int rn, MPI_Datatype rt, MPI_Comm c) {
  int ranks = 1;
  PMPI_Comm_size(c, &ranks);
  const auto inside = collective(c, static_cast<long long>(in_place(b) ? rn : n) * ranks, in_place(b) ? rt : t);
  return PMPI_Alltoall(b, n, t, r, rn, rt, c);
}
int MPI_Alltoallv(const void* b, const int* n, const int* d, MPI_Datatype t, void* r, const int* rn, const int* rd,
                  MPI_Datatype rt, MPI_Comm c) {
  const auto inside = collective(c, in_place(b) ? sum_of(rn, c) : sum_of(n, c), in_place(b) ? rt : t);
  return PMPI_Alltoallv(b, n, d, t, r, rn, rd, rt, c);
}
}

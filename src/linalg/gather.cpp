#include "linalg/gather.hpp"

#include "base/check.hpp"
#include "linalg/mpi_handle.hpp"

namespace voussoir {
namespace {

Gathered gathered;  // MPI is called from one thread

}  // namespace

const Gathered& gathered_so_far() { return gathered; }

namespace gathering {

void count(long long bytes, WhyWhole why) {
  ++gathered.lists;
  if (bytes <= gathered.largest) return;
  gathered.largest = bytes;
  gathered.because = why.because;
}

std::vector<long long> of_each_rank(long long mine, const Teuchos::Comm<int>& comm) {
  std::vector<long long> all(comm.getSize());
  Teuchos::gatherAll(comm, 1, &mine, comm.getSize(), all.data());
  return all;
}

void bring_together(const char* mine, const std::vector<long long>& sizes, char* all, const Teuchos::Comm<int>& comm,
                    long long most) {
  const auto ranks = static_cast<int>(sizes.size());
  const long long portion = most / ranks;  // of a rank in a call
  VOUSSOIR_EXPECT(portion > 0);
  const long long largest = *std::max_element(sizes.begin(), sizes.end()), here = sizes[comm.getRank()];
  std::vector<long long> first(ranks + 1, 0);
  std::partial_sum(sizes.begin(), sizes.end(), first.begin() + 1);
  const bool at_once = first.back() <= most;
  std::vector<int> length(ranks), place(ranks);
  std::vector<char> piece;
  for (long long from = 0; from < largest; from += at_once ? largest : portion) {
    const auto left = [&](int rank) {
      const long long behind = std::max(0LL, sizes[rank] - from);
      return static_cast<int>(at_once ? behind : std::min(portion, behind));
    };
    int end = 0;
    for (int rank = 0; rank < ranks; ++rank) {
      length[rank] = left(rank);
      place[rank] = end;
      end += length[rank];
    }
    piece.resize(at_once ? 0 : end);
    char* to = at_once ? all : piece.data();
    MPI_Allgatherv(mine + std::min(from, here), length[comm.getRank()], MPI_BYTE, to, length.data(), place.data(),
                   MPI_BYTE, mpi_handle(comm));
    for (int rank = 0; rank < ranks && !at_once; ++rank)
      std::copy_n(piece.begin() + place[rank], length[rank], all + first[rank] + from);
  }
}

}  // namespace gathering
}  // namespace voussoir

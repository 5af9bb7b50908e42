#include "linalg/parcels.hpp"

#include <map>

#include "linalg/mpi_handle.hpp"

namespace voussoir {
namespace {

/// Of messages of one exchange. A rank may begin the next one while others still wait for the end of this, so two in
/// turn have tags of their own; of a third nobody can be before all have ended the first.
int next_tag() {
  constexpr int first = 30030;  // Tpetra's are between 26000 and 26100
  static int exchanges = 0;
  return first + exchanges++ % 2;
}

/// Takes in what has arrived. Returns whether there was anything.
bool take_in(std::map<int, std::vector<char>>& in, int tag, MPI_Comm comm) {
  int arrived = 0, bytes = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, tag, comm, &arrived, &status);
  if (!arrived) return false;
  MPI_Get_count(&status, MPI_BYTE, &bytes);
  auto& items = in[status.MPI_SOURCE];  // pieces come in the order in which they were sent
  const auto before = items.size();
  items.resize(before + static_cast<std::size_t>(bytes));
  MPI_Recv(items.data() + before, bytes, MPI_BYTE, status.MPI_SOURCE, tag, comm, MPI_STATUS_IGNORE);
  return true;
}

}  // namespace

std::vector<Parcel<char>> exchange_bytes(std::vector<Parcel<char>> out, const Teuchos::Comm<int>& comm,
                                         long long most) {
  VOUSSOIR_EXPECT(most > 0 && most <= most_of_a_call);
  const MPI_Comm handle = mpi_handle(comm);
  const int tag = next_tag();
  std::map<int, std::vector<char>> in;
  std::vector<MPI_Request> sent;
  for (auto& parcel : out) {
    const auto size = static_cast<long long>(parcel.items.size());
    if (parcel.rank == comm.getRank()) {
      if (size > 0) in[parcel.rank] = std::move(parcel.items);
      continue;
    }
    for (long long from = 0; from < size; from += most) {
      sent.emplace_back();
      MPI_Issend(parcel.items.data() + from, static_cast<int>(std::min(most, size - from)), MPI_BYTE, parcel.rank, tag,
                 handle, &sent.back());
    }
  }
  MPI_Request all_confirmed = MPI_REQUEST_NULL;
  for (int confirmed = 0, ended = 0; !ended;) {
    while (take_in(in, tag, handle)) {
    }
    if (confirmed) {
      MPI_Test(&all_confirmed, &ended, MPI_STATUS_IGNORE);
      continue;
    }
    MPI_Testall(static_cast<int>(sent.size()), sent.data(), &confirmed, MPI_STATUSES_IGNORE);
    if (confirmed) MPI_Ibarrier(handle, &all_confirmed);
  }
  std::vector<Parcel<char>> came;
  for (auto& [rank, items] : in) came.push_back({rank, std::move(items)});
  return came;
}

}  // namespace voussoir

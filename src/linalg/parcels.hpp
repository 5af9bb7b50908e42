// What ranks send to single others, who do not know beforehand that it comes: nobody hears of what is not for him.
//
// Messages that are confirmed, and a barrier that begins when all of one's own have been (T. Hoefler, C. Siebert,
// A. Lumsdaine, Scalable communication protocols for dynamic sparse data exchange, PPoPP 2010): no list of ranks.
#pragma once

#include <Teuchos_Comm.hpp>
#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "linalg/gather.hpp"

namespace voussoir {

/// What goes to a rank, or came from it.
template <class T>
struct Parcel {
  int rank;
  std::vector<T> items;
};

/// Parcels of bytes; one rank may be sent one at most, itself among them. Collective.
/// @param most  bytes of a message
std::vector<Parcel<char>> exchange_bytes(std::vector<Parcel<char>> out, const Teuchos::Comm<int>&,
                                         long long most = most_of_a_call);

/// Sends parcels of plain data, of which empty ones are left out. Returns what came, ascending by sender. Collective.
template <class T>
std::vector<Parcel<T>> exchange_parcels(std::vector<Parcel<T>> out, const Teuchos::Comm<int>& comm,
                                        long long most = most_of_a_call) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (comm.getSize() == 1) {
    out.erase(std::remove_if(out.begin(), out.end(), [](const auto& parcel) { return parcel.items.empty(); }),
              out.end());
    return out;
  }
  std::vector<Parcel<char>> bytes;
  for (auto& parcel : out) {
    const auto size = parcel.items.size() * sizeof(T);
    bytes.push_back({parcel.rank, std::vector<char>(size)});
    if (size > 0) std::memcpy(bytes.back().items.data(), parcel.items.data(), size);
    parcel.items = std::vector<T>();
  }
  std::vector<Parcel<T>> in;
  for (auto& parcel : exchange_bytes(std::move(bytes), comm, most)) {
    VOUSSOIR_ENSURE(parcel.items.size() % sizeof(T) == 0);
    in.push_back({parcel.rank, std::vector<T>(parcel.items.size() / sizeof(T))});
    std::memcpy(in.back().items.data(), parcel.items.data(), parcel.items.size());
    parcel.items = std::vector<char>();
  }
  return in;
}

/// Items by the rank they go to, in the order in which they were given.
template <class T>
class Post {
 public:
  explicit Post(const Teuchos::Comm<int>& comm) : comm_(comm), parcel_of_(comm.getSize(), -1) {}
  void add(int rank, const T& item) {
    if (parcel_of_[rank] < 0) {
      parcel_of_[rank] = static_cast<int>(parcels_.size());
      parcels_.push_back({rank, {}});
    }
    parcels_[parcel_of_[rank]].items.push_back(item);
  }
  /// Sends all of them. Returns what came, sender by sender in ascending order. Collective.
  std::vector<Parcel<T>> send() && { return exchange_parcels(std::move(parcels_), comm_); }
  /// The same as one list.
  std::vector<T> send_all() && {
    std::vector<T> all;
    for (const auto& parcel : std::move(*this).send()) all.insert(all.end(), parcel.items.begin(), parcel.items.end());
    return all;
  }

 private:
  const Teuchos::Comm<int>& comm_;
  std::vector<int> parcel_of_;
  std::vector<Parcel<T>> parcels_;
};

/// The items of all ranks, rank by rank, on the first; none on the others. Collective.
template <class T>
std::vector<T> gather_on_first(const std::vector<T>& mine, const Teuchos::Comm<int>& comm) {
  std::vector<T> all;
  for (const auto& parcel : exchange_parcels<T>({{0, mine}}, comm))
    all.insert(all.end(), parcel.items.begin(), parcel.items.end());
  return all;
}

}  // namespace voussoir

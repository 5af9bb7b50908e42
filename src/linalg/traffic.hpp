// What this rank sends to others, by what it is sent for: counts, where a program links those who count.
//
// Counting stands in traffic_mpi.cpp, between MPI's callers and MPI; the library does without. A program that links
// voussoir_traffic counts every message and every collective operation, those inside Trilinos among them.
#pragma once

#include <array>

#include <Teuchos_Comm.hpp>

namespace voussoir {

/// What is going on while messages are sent.
enum class TrafficOf {
  else_where,     ///< outside of linear solves
  set_up,         ///< a linear system and its preconditioner
  krylov,         ///< the Krylov method itself: products with the matrix, and scalar products
  block_motions,  ///< the sum of the coarse right-hand side, or of that of a released region
  transfer,       ///< from the selection to the continuum and back
  continuum       ///< one V-cycle
};
constexpr int traffic_kinds = 6;

struct Traffic {
  long long messages = 0;          ///< from rank to rank
  long long bytes = 0;             ///< in them
  long long collectives = 0;       ///< sums, broadcasts, barriers, ...
  long long collective_bytes = 0;  ///< that this rank gives to them (of a broadcast: that it gives or gets)
};
Traffic operator-(Traffic, const Traffic&);
Traffic operator+(Traffic, const Traffic&);
/// Mean of so many, rounded; nothing of none.
Traffic operator/(const Traffic&, long long);

using TrafficByKind = std::array<Traffic, traffic_kinds>;

/// Of this rank, since it began.
const TrafficByKind& traffic_so_far();
TrafficByKind traffic_since(const TrafficByKind& before);
/// Bytes of the largest message or collective of each kind that this rank has sent since all sizes were forgotten.
const std::array<long long, traffic_kinds>& largest_sent();
void forget_largest_sent();
/// 1 where the program counts; without, all counts are zero.
bool traffic_is_counted();

/// Sum over ranks, and the largest of each number. Collective.
Traffic total_traffic(const Traffic& mine, const Teuchos::Comm<int>&);
Traffic largest_traffic(const Traffic& mine, const Teuchos::Comm<int>&);
/// What Krylov iterations send, and linear solves with their set-up; of the rank that sends most. Collective.
Traffic traffic_of_krylov(const TrafficByKind& mine, const Teuchos::Comm<int>&);
Traffic traffic_of_solves(const TrafficByKind& mine, const Teuchos::Comm<int>&);

/// What is sent during its life is sent for this.
class TrafficScope {
 public:
  explicit TrafficScope(TrafficOf);
  ~TrafficScope();
  TrafficScope(const TrafficScope&) = delete;

 private:
  TrafficOf before_;
};

/// For those who count: what is sent next, and how large it is.
Traffic& traffic_of_now();
void note_size(long long bytes);
void count_traffic();

}  // namespace voussoir

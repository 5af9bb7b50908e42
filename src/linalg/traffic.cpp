#include "linalg/traffic.hpp"

#include <algorithm>
#include <array>

#include "linalg/reduce.hpp"
#include "linalg/seconds_in_mpi.hpp"

namespace voussoir {
namespace {

// MPI is called from one thread.
TrafficByKind counts;
std::array<long long, traffic_kinds> largest{};  // bytes
TrafficOf now = TrafficOf::else_where;
bool is_counted = false;
double inside_mpi = 0;  // s of the processor

Traffic over_ranks(const Traffic& mine, const Teuchos::Comm<int>& comm, Teuchos::EReductionType how) {
  const std::array<long long, 4> here{mine.messages, mine.bytes, mine.collectives, mine.collective_bytes};
  const auto all = each_over_ranks(comm, how, here);
  return {all[0], all[1], all[2], all[3]};
}

}  // namespace

Traffic operator-(Traffic a, const Traffic& b) {
  return {a.messages - b.messages, a.bytes - b.bytes, a.collectives - b.collectives,
          a.collective_bytes - b.collective_bytes};
}

Traffic operator+(Traffic a, const Traffic& b) { return a - (Traffic() - b); }

Traffic operator/(const Traffic& a, long long n) {
  if (n == 0) return {};
  const auto mean = [n](long long count) { return (count + n / 2) / n; };
  return {mean(a.messages), mean(a.bytes), mean(a.collectives), mean(a.collective_bytes)};
}

const TrafficByKind& traffic_so_far() { return counts; }

TrafficByKind traffic_since(const TrafficByKind& before) {
  auto since = counts;
  for (int k = 0; k < traffic_kinds; ++k) since[k] = since[k] - before[k];
  return since;
}

const std::array<long long, traffic_kinds>& largest_sent() { return largest; }

void forget_largest_sent() { largest = {}; }

bool traffic_is_counted() { return is_counted; }

Traffic total_traffic(const Traffic& mine, const Teuchos::Comm<int>& comm) {
  return over_ranks(mine, comm, Teuchos::REDUCE_SUM);
}

Traffic largest_traffic(const Traffic& mine, const Teuchos::Comm<int>& comm) {
  return over_ranks(mine, comm, Teuchos::REDUCE_MAX);
}

namespace {

Traffic largest_sum(const TrafficByKind& mine, TrafficOf first, const Teuchos::Comm<int>& comm) {
  Traffic sum;
  for (int k = static_cast<int>(first); k < traffic_kinds; ++k) sum = sum + mine[k];
  return largest_traffic(sum, comm);
}

}  // namespace

Traffic traffic_of_krylov(const TrafficByKind& mine, const Teuchos::Comm<int>& comm) {
  return largest_sum(mine, TrafficOf::krylov, comm);
}

Traffic traffic_of_solves(const TrafficByKind& mine, const Teuchos::Comm<int>& comm) {
  return largest_sum(mine, TrafficOf::set_up, comm);
}

TrafficScope::TrafficScope(TrafficOf what) : before_(now) { now = what; }

TrafficScope::~TrafficScope() { now = before_; }

double seconds_in_mpi() { return inside_mpi; }

void add_seconds_in_mpi(double seconds) { inside_mpi += seconds; }

Traffic& traffic_of_now() { return counts[static_cast<int>(now)]; }

void note_size(long long bytes) {
  auto& size = largest[static_cast<int>(now)];
  size = std::max(size, bytes);
}

void count_traffic() { is_counted = true; }

}  // namespace voussoir

#include "output/even_rows.hpp"

#include <algorithm>
#include <functional>

#include "base/check.hpp"

namespace voussoir {
namespace {

template <class T>
MPI_Datatype mpi_type();
template <>
MPI_Datatype mpi_type<double>() {
  return MPI_DOUBLE;
}
template <>
MPI_Datatype mpi_type<int>() {
  return MPI_INT;
}
template <>
MPI_Datatype mpi_type<long long>() {
  return MPI_LONG_LONG;
}

/// A whole row as one MPI type, so that counts are rows and stay far below the limit of int.
template <class T>
class RowType {
 public:
  explicit RowType(int columns) {
    MPI_Type_contiguous(columns, mpi_type<T>(), &type);
    MPI_Type_commit(&type);
  }
  RowType(const RowType&) = delete;
  RowType& operator=(const RowType&) = delete;
  ~RowType() { MPI_Type_free(&type); }
  MPI_Datatype type = MPI_DATATYPE_NULL;
};

bool on_all_ranks(bool here, MPI_Comm comm) {
  int all = here ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, comm);
  return all == 1;
}

std::vector<int> starts(const std::vector<int>& count) {
  std::vector<int> start(count.size(), 0);
  for (std::size_t r = 1; r < count.size(); ++r) start[r] = start[r - 1] + count[r - 1];
  return start;
}

}  // namespace

EvenRows::EvenRows(const std::vector<long long>& ids, long long rows, MPI_Comm comm) : comm_(comm) {
  const bool ascending = std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end();
  const bool in_range = ids.empty() || (ids.front() >= 0 && ids.back() < rows);
  VOUSSOIR_CHECK(on_all_ranks(ascending && in_range, comm));

  int ranks = 1, rank = 0;
  MPI_Comm_size(comm, &ranks);
  MPI_Comm_rank(comm, &rank);
  const auto bound = [rows, ranks](int r) { return rows / ranks * r + rows % ranks * r / ranks; };
  first_ = bound(rank);
  last_ = bound(rank + 1);

  mine_count_.resize(ranks);
  auto position = ids.begin();
  for (int r = 0; r < ranks; ++r) {
    const auto end = std::lower_bound(position, ids.end(), bound(r + 1));
    mine_count_[r] = static_cast<int>(end - position);
    position = end;
  }
  named_count_.resize(ranks);
  MPI_Alltoall(mine_count_.data(), 1, MPI_INT, named_count_.data(), 1, MPI_INT, comm);
  mine_start_ = starts(mine_count_);
  named_start_ = starts(named_count_);
  named_.resize(named_start_.back() + named_count_.back());
  MPI_Alltoallv(ids.data(), mine_count_.data(), mine_start_.data(), MPI_LONG_LONG, named_.data(), named_count_.data(),
                named_start_.data(), MPI_LONG_LONG, comm);
}

bool EvenRows::every_row_has_one_owner() const {
  std::vector<int> owners(count(), 0);
  for (const long long id : named_) ++owners[id - first_];
  return on_all_ranks(std::all_of(owners.begin(), owners.end(), [](int n) { return n == 1; }), comm_);
}

template <class T>
std::vector<T> EvenRows::gather(const std::vector<T>& values, int columns) const {
  const auto mine = static_cast<std::size_t>(mine_start_.back() + mine_count_.back());
  VOUSSOIR_CHECK(on_all_ranks(values.size() == mine * columns, comm_));
  const RowType<T> row(columns);
  std::vector<T> received(named_.size() * columns);
  MPI_Alltoallv(values.data(), mine_count_.data(), mine_start_.data(), row.type, received.data(), named_count_.data(),
                named_start_.data(), row.type, comm_);
  std::vector<T> even(static_cast<std::size_t>(count()) * columns);
  for (std::size_t k = 0; k < named_.size(); ++k)
    std::copy_n(&received[k * columns], columns, &even[(named_[k] - first_) * columns]);
  return even;
}

template <class T>
std::vector<T> EvenRows::scatter(const std::vector<T>& even_values, int columns) const {
  VOUSSOIR_CHECK(on_all_ranks(even_values.size() == static_cast<std::size_t>(count()) * columns, comm_));
  const RowType<T> row(columns);
  std::vector<T> sent(named_.size() * columns);
  for (std::size_t k = 0; k < named_.size(); ++k)
    std::copy_n(&even_values[(named_[k] - first_) * columns], columns, &sent[k * columns]);
  std::vector<T> mine(static_cast<std::size_t>(mine_start_.back() + mine_count_.back()) * columns);
  MPI_Alltoallv(sent.data(), named_count_.data(), named_start_.data(), row.type, mine.data(), mine_count_.data(),
                mine_start_.data(), row.type, comm_);
  return mine;
}

long long sum_before(long long mine, MPI_Comm comm) {
  long long up_to_here = 0;
  MPI_Scan(&mine, &up_to_here, 1, MPI_LONG_LONG, MPI_SUM, comm);
  return up_to_here - mine;
}

std::vector<long long> numbered_without_gaps(const std::vector<long long>& ids, long long rows, MPI_Comm comm,
                                             long long& count) {
  const EvenRows even(ids, rows, comm);
  const auto named = even.gather(std::vector<int>(ids.size(), 1), 1);
  std::vector<long long> number(named.size());
  long long next = sum_before(std::count(named.begin(), named.end(), 1), comm);
  for (std::size_t k = 0; k < named.size(); ++k) {
    number[k] = next;
    next += named[k];
  }
  int ranks = 1;
  MPI_Comm_size(comm, &ranks);
  count = next;
  MPI_Bcast(&count, 1, MPI_LONG_LONG, ranks - 1, comm);
  return even.scatter(number, 1);
}

template std::vector<double> EvenRows::gather(const std::vector<double>&, int) const;
template std::vector<int> EvenRows::gather(const std::vector<int>&, int) const;
template std::vector<long long> EvenRows::gather(const std::vector<long long>&, int) const;
template std::vector<double> EvenRows::scatter(const std::vector<double>&, int) const;
template std::vector<int> EvenRows::scatter(const std::vector<int>&, int) const;
template std::vector<long long> EvenRows::scatter(const std::vector<long long>&, int) const;

}  // namespace voussoir

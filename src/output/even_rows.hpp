// Moves the rows of a table between the ranks that own them and an even split into contiguous ranges.
//
// Files like contiguous ranges: one collective write per table, whatever the numbering. A rank of HDF5 that
// selects its own scattered rows instead pays quadratically (4.5 s for 10 000 ranges, HDF5 1.10.8).
#pragma once

#include <vector>

#include <mpi.h>

namespace voussoir {

/// Rank r of the even split holds rows [r n / ranks, (r + 1) n / ranks) of the n rows.
class EvenRows {
 public:
  /// @param ids   rows of this rank, strictly ascending, 0 <= id < rows; may be empty. Collective.
  EvenRows(const std::vector<long long>& ids, long long rows, MPI_Comm comm);

  long long first() const { return first_; }
  long long count() const { return last_ - first_; }
  /// Whether every row is named by exactly one rank; the same answer on all ranks. Collective.
  bool every_row_has_one_owner() const;

  /// Values of the owners (row-major) in the even split. Collective; T is double, int or long long.
  template <class T>
  std::vector<T> gather(const std::vector<T>& values, int columns) const;
  /// The way back: several ranks may ask for the same row. Collective.
  template <class T>
  std::vector<T> scatter(const std::vector<T>& even_values, int columns) const;

 private:
  MPI_Comm comm_;
  long long first_ = 0;
  long long last_ = 0;
  std::vector<int> mine_count_, mine_start_;    ///< per rank: rows of mine that lie in its range
  std::vector<int> named_count_, named_start_;  ///< per rank: rows of my range that it owns
  std::vector<long long> named_;                ///< these rows, by rank
};

/// Numbers 0, 1, 2, ... of those rows that some rank names, in their order and without gaps. Collective.
/// @param ids   rows of this rank, as above; every row has one owner at most
/// @param count  how many there are on all ranks
/// @return of the rows of this rank, ascending
std::vector<long long> numbered_without_gaps(const std::vector<long long>& ids, long long rows, MPI_Comm comm,
                                             long long& count);

/// Sum of the numbers of the ranks before this one. Collective.
long long sum_before(long long mine, MPI_Comm comm);

}  // namespace voussoir

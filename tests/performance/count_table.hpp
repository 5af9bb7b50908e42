// What scenes cost in counts, kept as a table: solve_counts.csv.
//
// A count depends on the processor where a sum that it rounds decides: a stone at the edge of its law takes a solve
// more or less. So the table keeps the least and the most over the kernels of OpenBLAS, which round as seven kinds of
// processors do (tests/support/kernels.py). count_ranges.py measures it.
#pragma once

#include <map>
#include <ostream>
#include <string>

namespace voussoir::test {

struct Counts {
  long long solves = 0;   ///< linear solves of the whole structure
  long long krylov = 0;   ///< Krylov iterations of these
  long long whole = 0;    ///< systems that were factored whole
  long long patches = 0;  ///< linear solves of patches

  void add(const Counts& more);
  /// As the table has them where all processors count alike: "6,41,0,0".
  std::string text() const;
};

/// What processors count. One that jumps from one to the next is written "~least-most".
struct Range {
  long long least = 0, most = 0;
  bool jumps = false;

  /// "6", "6-8" or "~12-197".
  std::string text() const;
};

struct CountRanges {
  Range solves, krylov, whole, patches;

  std::string text() const;
};

/// A count is off that lies beyond the range by more than a tenth of its bound, and by more than one: processors differ
/// that nobody has asked. Of one that jumps only twice the most is too much.
enum class Change { none, more, fewer };
Change change_of(const Range& kept, long long counted);
/// More where any count is more; fewer where none is more and one is fewer.
Change change_of(const CountRanges& kept, const Counts& counted);

/// Rows of a text with the head "scene,solves,krylov,whole,patches"; lines that start with # are remarks. Throws
/// std::runtime_error for any other.
std::map<std::string, CountRanges> read_counts(const std::string& csv);

/// Compares with the row of that scene in the table and prints both. False when a count is more, and when one is fewer
/// or the row is missing: what is gained is to be kept, by measuring the table anew.
bool as_in_table(const std::string& scene, const Counts&, std::ostream& out);

}  // namespace voussoir::test

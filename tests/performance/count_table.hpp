// What scenes cost in counts that do not depend on the machine, kept as a table: solve_counts.csv.
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
  /// As in the table: "6,41,0,0".
  std::string text() const;
};

/// A count that is off by more than a tenth of what is kept, and by more than one: where a point stands on the edge of
/// its law, the rounding of a processor takes a solve more or less to settle its status.
enum class Change { none, more, fewer };
Change change_of(long long kept, long long counted);
/// More where any count is more; fewer where none is more and one is fewer.
Change change_of(const Counts& kept, const Counts& counted);

/// Rows of a text with the head "scene,solves,krylov,whole,patches"; throws std::runtime_error for any other.
std::map<std::string, Counts> read_counts(const std::string& csv);

/// Compares with the row of that scene in the table and prints both. False when a count is more, and when one is fewer
/// or the row is missing: then the line to be put into the table is printed, so that what is gained is kept.
bool as_in_table(const std::string& scene, const Counts&, std::ostream& out);

}  // namespace voussoir::test

// What a run cannot vouch for, said where the result stands: in the run, in result.json and at the top of the report.
#pragma once

#include <string>
#include <vector>

namespace voussoir {

/// Something that makes a result less than it looks. A user reads `text`, a program `what`.
struct Warning {
  std::string what;     ///< kind in snake case, one of those in src/output/README.md: "stones_overlap"
  std::string where;    ///< block, joint, support, load or file by name or number: "joint 3 - 7"
  std::string when;     ///< stage and load factor or time at which it was worst; empty for the input
  double how_much = 0;  ///< as the kind measures it, in its unit
  std::string text;     ///< one sentence with values, reason and what to do, without a full stop
};

using Warnings = std::vector<Warning>;

/// Adds a warning; of the same kind at the same place the larger one stays. Returns whether it is new there.
inline bool add_warning(Warnings& all, const Warning& more) {
  for (auto& known : all) {
    if (known.what != more.what || known.where != more.where) continue;
    if (more.how_much > known.how_much) known = more;
    return false;
  }
  all.push_back(more);
  return true;
}

}  // namespace voussoir

// What a run cannot vouch for, said where the result stands: in the run, in result.json and at the top of the report.
#pragma once

#include <algorithm>
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

/// As it is said wherever it is said: "WARNING: where, when: text."
inline std::string in_words(const Warning& w) {
  return "WARNING: " + w.where + (w.when.empty() ? "" : ", " + w.when) + ": " + w.text + ".";
}

using Warnings = std::vector<Warning>;

/// Of one kind no more places are kept: who reads of five need not read of hundreds.
inline constexpr int most_of_a_kind = 5;

/// Adds a warning; of the same kind at the same place the larger one stays, and of a kind the largest ones. Returns
/// whether a reader ought to be told: it is new at its place, and there are not enough of its kind.
inline bool add_warning(Warnings& all, const Warning& more) {
  for (auto& known : all) {
    if (known.what != more.what || known.where != more.where) continue;
    if (more.how_much > known.how_much) known = more;
    return false;
  }
  const auto of_kind = [&](const Warning& w) { return w.what == more.what; };
  if (std::count_if(all.begin(), all.end(), of_kind) < most_of_a_kind) {
    // What the input leaves open stands first, whenever it is told: after a restart it is told anew.
    const auto of_a_step = [](const Warning& w) { return !w.when.empty(); };
    all.insert(more.when.empty() ? std::find_if(all.begin(), all.end(), of_a_step) : all.end(), more);
    return true;
  }
  Warning* least = nullptr;
  for (auto& known : all)
    if (of_kind(known) && (!least || known.how_much < least->how_much)) least = &known;
  if (more.how_much > least->how_much) *least = more;
  return false;
}

}  // namespace voussoir

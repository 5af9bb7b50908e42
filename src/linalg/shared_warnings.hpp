// Warnings that one rank has, told to all.
#pragma once

#include <string>
#include <vector>

#include "base/warning.hpp"
#include "linalg/agree.hpp"

namespace voussoir {

/// Gives every rank the warnings of the first. Collective.
inline void broadcast_warnings(const Teuchos::Comm<int>& comm, Warnings& warnings) {
  std::vector<std::string> words;
  std::vector<double> amounts;
  for (const Warning& w : warnings) {
    words.insert(words.end(), {w.what, w.where, w.when, w.text});
    amounts.push_back(w.how_much);
  }
  broadcast_strings(comm, words);
  broadcast_values(comm, amounts);
  warnings.clear();
  for (std::size_t k = 0; k < amounts.size(); ++k)
    warnings.push_back({words[4 * k], words[4 * k + 1], words[4 * k + 2], amounts[k], words[4 * k + 3]});
}

/// The warnings that the first rank finds, on every rank. What it throws all throw. Collective.
template <class Find>
Warnings warnings_of_first_rank(const Teuchos::Comm<int>& comm, const Find& find) {
  Warnings found;
  on_first_rank(comm, [&] { found = find(); });
  broadcast_warnings(comm, found);
  return found;
}

}  // namespace voussoir

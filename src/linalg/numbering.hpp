// Numbers that do not depend on ranks for what each of many things has several of: nodes, points or cells of a block.
#pragma once

#include <Teuchos_Comm.hpp>
#include <vector>

namespace voussoir {

struct FirstNumbers {
  std::vector<long long> first;  ///< of the things that were asked for, in their order
  long long total = 0;           ///< of all things
};

/// Things have numbers; what they have is numbered thing by thing in their order. Each rank tells what its own things
/// have and asks for the first numbers of these and others. No rank hears of more: each keeps the counts of an equal
/// share of the things, by their numbers. Collective.
/// @param things  own ones first; each is one rank's own
/// @param counts  of the own ones
/// @param in_all  how many things there are: numbers are 0 .. in_all - 1
FirstNumbers first_numbers(const std::vector<long long>& things, const std::vector<long long>& counts, long long in_all,
                           const Teuchos::Comm<int>&);

}  // namespace voussoir

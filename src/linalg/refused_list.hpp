// Lists that a user hands on to Belos and MueLu, tried before anything is computed: what a library refuses is wrong
// input, and is known where the scene is checked, whether or not the scene comes to need it.
#pragma once

#include <optional>
#include <string>

#include "linalg/solver_parameters.hpp"

namespace voussoir {

struct RefusedList {
  std::string key;      ///< below "solver"
  std::string library;  ///< that does not take it
  std::string why;      ///< in its words
};

/// The first list that a library refuses, on a small system of this rank alone; none where there is no list, at no
/// cost. What a library prints is not shown. Local, and the same on every rank.
/// @param dim  2 or 3
std::optional<RefusedList> refused_list(const SolverParameters&, int dim);

}  // namespace voussoir

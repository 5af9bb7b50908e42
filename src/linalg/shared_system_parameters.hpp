// Numbers of systems of which every rank knows a part.
#pragma once

#include "linalg/body_levels_parameters.hpp"

namespace voussoir {

struct SharedSystemParameters {
  /// unknowns up to which the first of several ranks factors them for all: below, levels cost more to build than what
  /// two ranks save by them (body_levels.md), and MUMPS sends more than that
  long long most_on_first = 20000;
  bool levels_on_one_rank = false;  ///< which a study times; one rank factors else
  BodyLevelsParameters levels;
};

}  // namespace voussoir

// When points in time steps are bonded again, and how far the error of a selection is trusted (rest.hpp).
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct RestParameters {
  double longest_wait = 16;  ///< times the patience that a point which never stays bonded waits at most
  double trusted_after = 8;  ///< times the steps it had to rest after which a bonded point is trusted as at first
  double growth = 2;         ///< growth of the indicator beyond which a computed error says nothing of it
  double margin = 1.5;       ///< times the computed ratio that the error may be at most
  double distrust = 2;       ///< times the way of the indicator that is added to it
  int octaves = 60;          ///< below the largest decrease in which the cut of bulk marking lies
  int bisections = 40;       ///< of these to find the cut
  void declare(ParameterSection&);
};

}  // namespace voussoir

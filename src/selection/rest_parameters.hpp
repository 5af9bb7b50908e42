// When points in time steps are bonded again, and how far the error of a selection is trusted (rest.hpp).
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct RestParameters {
  /// times the patience that a point which never stays bonded waits at most, and times the steps it had to rest after
  /// which a bonded point is trusted as at first
  double longest_wait = 16;
  double growth =
      2;  ///< of the indicator beyond which a computed error says nothing of it; times its way that is added
  double margin = 1.5;  ///< times the computed ratio that the error may be at most
  /// below the largest decrease in which the cut of bulk marking lies: 2^-60 is round-off
  static constexpr int octaves = 60;
  /// to find it: 60 2^-40 octaves is round-off
  static constexpr int bisections = 40;
  void declare(ParameterSection&);
};

}  // namespace voussoir

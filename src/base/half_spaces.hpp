// The shortest vector within half spaces.
#pragma once

#include <vector>

namespace voussoir {

/// slope . y >= least.
struct HalfSpace {
  std::vector<double> slope;  ///< of length one, as many components as y
  double least = 0;
};

/// The shortest y that lies in every one of some half spaces: Lawson and Hanson's least distance programming, by
/// non-negative least squares (Solving Least Squares Problems, 1974, chapter 23). Exact but for round-off however
/// nearly parallel the half spaces are, after finitely many small systems.
/// @param size  components of y
/// @return empty where no y of a size that doubles tell from `least` lies in all of them
std::vector<double> shortest_within(const std::vector<HalfSpace>&, std::size_t size);

}  // namespace voussoir

// Which tolerance a drawing fits together at.
#pragma once

#include "drawings/snapped.hpp"

namespace voussoir {

/// What the choice rests on. Sizes are square roots of areas.
struct SnapDefaults {
  /// Of the median size: tolerances that are tried begin here, above the rounding of coordinates in files.
  double least = 1e-6;
  /// Of the extent of the drawing: and not below this, where coordinates have no digits left.
  double round_off = 1e-12;
  /// Of the least mean width of a stone: they end here, before stones close up.
  double most = 0.25;
  /// Of the median size: stones that are nearer and do not touch were probably meant to.
  double small_gap = 0.05;
  /// Of a tolerance that is given: the same, where that is less.
  double reach = 10;
};

/// How a drawing fits together at one tolerance.
struct SnapCount {
  double snap = 0;  ///< [m]
  std::size_t joints = 0, faults = 0;
  int dropped = 0;  ///< corners that became one with another of the same stone
};

/// [m] from the first corner to the farthest.
double extent_of(const std::vector<OutlinedStone>&);

/// [m] the median of the square roots of areas.
double median_size(const std::vector<OutlinedStone>&);

/// [m] up to which distance stones that do not touch are a fault, at a tolerance that was given or one that is tried.
double reach_of(const std::vector<OutlinedStone>&, double snap, bool given);

/// Tolerances in steps of a third to two thirds: round ones, in metres.
std::vector<SnapCount> count_snaps(const std::vector<OutlinedStone>&);

/// The tolerance in the middle of the longest row without faults and with equal counts, where one joins at all; without
/// any such row the one with the fewest faults.
double snap_on_plateau(const std::vector<SnapCount>&);

}  // namespace voussoir

// Stones that slide on all they touch.
//
// A stone that lies on two others which part slides on both. What their friction leaves of its balance may be next to
// nothing, and no linear system tells how far it goes: with all that holds it sliding, it is free. But it moves along
// its beds, which changes no force, and the first of its points that comes back to where it began to slide holds it
// again. So it goes there at once. Stones that hold each other go together; a stone that stops at a loose one goes on
// with it, as long as the two are out of balance.
#pragma once

#include <array>
#include <vector>

#include "nonlinear/patch_parameters.hpp"
#include "nonlinear/patch_parts.hpp"

namespace voussoir {

/// What is known of the points of a patch.
struct PointStatuses {
  const std::vector<PointStiffness>& resistance;  ///< of the last linear solve
  const std::vector<double>& sliding;  ///< direction of friction, 0 where a point sticks or is open
  std::vector<std::array<double, 2>> motion;  ///< [m] gap, and slip from its origin
};

class LooseStones {
 public:
  explicit LooseStones(const PatchParts&, const PatchParameters& = {});

  /// Moves stones that nothing holds and that are out of balance.
  /// @param points        those of the parts
  /// @param imbalance     [N] of each unknown: what is to be overcome
  /// @param least         [N] stones out of balance by less stay
  /// @param displacement  [m] of each unknown
  /// @return  points where a stone has come to a stop
  std::vector<int> move_on(const std::vector<PatchPoint>& points, PointStatuses, const double* imbalance, double least,
                           double* displacement) const;

 private:
  int stone_at(const PatchPoint&, int side) const;

  double parallel_;                        ///< [-] beds are, and stones come nearer, up to and beyond this
  std::vector<char> component_;            ///< of each unknown
  std::vector<int> stone_;                 ///< of each unknown; 0 where it is held
  int stones_ = 1;                         ///< with the number 0 of all that is held
  std::vector<std::array<int, 2>> sides_;  ///< stones of each point
};

}  // namespace voussoir

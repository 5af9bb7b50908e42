// Which contact points have rested and may be bonded again, with hysteresis.
//
// A point rests while it is calm and stays near one place: k |g - g_0|^2 / 2 below an energy, g its gap and slip [m],
// k the stiffness it sees [N/m]. After so many steps of rest it is bonded: its two nodes move alike from there on, so
// its gap and slip stay what they are. A point that is released again soon must rest twice as long the next time.
#pragma once

#include <vector>

namespace voussoir {

/// What is remembered of each point; part of the state of a run.
struct Rest {
  std::vector<double> place;   ///< [m, points x components] gap and slip it rests at
  std::vector<double> steps;   ///< steps of rest, or since it was bonded
  std::vector<double> needed;  ///< steps of rest before it is bonded
  std::vector<double> bonded;  ///< 1 where it was bonded again
  /// Error of this selection by the root of its predicted decreases, when it was last computed; 0 = not known.
  double error_by_decreases = 0;
};

/// Counts a step; deselects the points that have rested long enough. Ghosts do what their owners do.
/// @param gap        gap and slip after the step [m, points x components]
/// @param stiffness  per point [N/m]
/// @param calm       per point: 1 where its two sides hardly move against each other, so that a tie stops nothing
/// @param energy     motion of a point that counts as none [J]
/// @param patience   steps of rest before a point is bonded for the first time, > 0
/// @return whether a point of this rank was deselected
bool bond_what_rests(Rest&, std::vector<char>& selected, const std::vector<double>& gap,
                     const std::vector<double>& stiffness, const std::vector<char>& calm, double energy, int patience);

}  // namespace voussoir

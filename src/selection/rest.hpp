// Which contact points have rested and may be bonded again, with hysteresis.
//
// A point rests while it is calm and stays near one place: k |g - g_0|^2 / 2 below an energy, g its gap and slip [m],
// k the stiffness it sees [N/m]. After so many steps of rest it is bonded: its two nodes move alike from there on, so
// its gap and slip stay what they are. A point that is released again soon must rest twice as long the next time.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "selection/rest_parameters.hpp"

namespace voussoir {

/// A bound of the error of a selection between two computations of it. The root of the predicted decreases is cheap to
/// know, and so is the ratio error / root of the last computation. The more the root has changed since then, to and
/// fro, the less that ratio is trusted; once the root has doubled it is discarded.
struct KnownError {
  double ratio = 0;       ///< 0 = not known
  double root_known = 0;  ///< [-] relative to the energy, when the error was computed
  double root = 0;        ///< [-] now
  double travelled = 0;   ///< [-] by the root since then

  void follow(double new_root) {
    travelled += std::abs(new_root - root);
    root = new_root;
  }
  /// The error was computed at the root there is now.
  void learn(double error) {
    ratio = root > 0 ? error / root : 0.0;
    root_known = root;
    travelled = 0;
  }
  /// Bound of the error now [-].
  /// @param unknown  error by root where it was not computed
  double bound(double unknown, const RestParameters& numbers = {}) const {
    if (ratio == 0 || root > numbers.growth * root_known) return unknown * root;
    return ratio * std::min(numbers.margin * root, root + numbers.growth * travelled);
  }
};

/// What is remembered of each point; part of the state of a run.
struct Rest {
  std::vector<double> place;   ///< [m, points x components] gap and slip it rests at
  std::vector<double> steps;   ///< steps of rest, or since it was bonded
  std::vector<double> needed;  ///< steps of rest before it is bonded
  std::vector<double> bonded;  ///< 1 where it was bonded again
  KnownError error;            ///< of this selection
};

/// Points that have been at their places for as many steps as they need to.
/// @param gap  [m, points x components]
Rest rested(const std::vector<double>& gap, int points, int patience);

/// Counts a step; deselects the points that have rested long enough. Ghosts do what their owners do.
/// @param gap        gap and slip after the step [m, points x components]
/// @param stiffness  per point [N/m]
/// @param calm       per point: 1 where its two sides hardly move against each other, so that a tie stops nothing
/// @param energy     motion of a point that counts as none [J]
/// @param patience   steps of rest before a point is bonded for the first time, > 0
/// @return whether a point of this rank was deselected
bool bond_what_rests(Rest&, std::vector<char>& selected, const std::vector<double>& gap,
                     const std::vector<double>& stiffness, const std::vector<char>& calm, double energy, int patience,
                     const RestParameters& = {});

}  // namespace voussoir

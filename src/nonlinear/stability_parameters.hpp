// How closely a state with joints that soften is looked at (stability.hpp).
#pragma once

#include "base/order_of_magnitude.hpp"
#include "nonlinear/active_set_parameters.hpp"

namespace voussoir {

struct StabilityParameters {
  /// Resistance of closed points, relative to their local stiffness: a thousandth of what the stones beside a point
  /// give way is far below what decides, and systems stay as well conditioned as those of time steps.
  static constexpr double augmentation = ActiveSetParameters{}.augmentation_in_time;
  /// [-] excess of softening over stiffness, relative to their sum, up to which a state is neutral: what the resistance
  /// of closed points leaves unsaid, tenfold.
  static constexpr double neutral = 1 / (order_of_magnitude * order_of_magnitude);
  /// [-] error of the largest share of softening, which lies between 0 and 1, where it is told from one half; and where
  /// the motion that belongs to it is wanted, whose error is the root of it.
  static constexpr double share_error = neutral, motion_error = share_error / order_of_magnitude;
  /// Linear solves, each of which adds a motion to those that are compared. Where one crack softens 3 to 10 tell; the
  /// largest of many that are nearly alike is told by no fewer than there are cracks.
  static constexpr int most_motions = 60;
  /// [-] of these solves: motions, and with them the branch that is taken, do not depend on what one leaves.
  static constexpr double solve_accuracy = ActiveSetParameters::finest_accuracy;
  /// Share of the largest motion from which on a point counts where the direction of one that has two is chosen:
  /// motions of equal cracks are equal but for round-off.
  static constexpr double leads = 0.5;
  /// Linear solves after which no further branch is left, relative to those that found the state: looking for a better
  /// one may not be dearer than finding one was, however many cracks run side by side. But those of one look at least
  /// (most_motions).
  static constexpr double solves_of_step = 1;
  /// [-] way back, relative to the way down the branch, within which a state is the one that was left.
  static constexpr double back_again = 0.05;
};

}  // namespace voussoir

// How what load steps leave undecided is let go in time (settling_in_time.hpp): lengths of steps, rest and fall.
#pragma once

#include "base/order_of_magnitude.hpp"
#include "run/load_factor_analysis_parameters.hpp"

namespace voussoir {

struct SettlingParameters {
  /// The slowest vibration of a compact body takes four passages of a wave. Slender structures vibrate more slowly,
  /// which more time resolves all the better.
  static constexpr int passages_in_period = 4;
  /// A passage a step at first: vibrations are not to be seen, but to be damped.
  static constexpr int steps_in_period = passages_in_period;
  /// Steps of one length; the next ones are twice as long. The first of them bring the loads, over four periods.
  static constexpr int steps_of_a_length = 4 * steps_in_period;
  /// By the end of which what loads out of balance by 3e-6 of their size set in motion has fallen far.
  static constexpr int lengths = 10;
  /// A mechanism has gone so many times as far as loads deform a compact body: the loads bend none so much.
  static constexpr double far = order_of_magnitude * order_of_magnitude * order_of_magnitude;
  /// And its kinetic energy has grown by so much in each of the last two lengths: falling freely it grows fourfold,
  /// vibrating it stays, and this lies between them as a factor.
  static constexpr double growth = 2;
  static constexpr int lengths_of_growth = 2;
  /// Near rest kinetic energy is so small a share of the elastic one, the square of a tenth: what is left moves stones
  /// by a tenth of what loads do. The midpoint rule lets stiff vibrations ring on below such a level when time steps
  /// are long; the load step that is to show the equilibrium has none.
  static constexpr double near_rest = 1 / (order_of_magnitude * order_of_magnitude);
  /// Asked again when it is calmer by this: an order of magnitude.
  static constexpr double calmer = 1 / order_of_magnitude;
  /// A load step from a place of rest that is an equilibrium is as any that stands, which rarely takes more.
  static constexpr int solves_to_confirm = LoadFactorAnalysisParameters::solves_of_dearest;
};

}  // namespace voussoir

// Numbers of pseudo-time (pseudo_time.hpp), and of collapses, which it tells.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

#include "base/order_of_magnitude.hpp"
#include "nonlinear/active_set_parameters.hpp"

namespace voussoir {

class ParameterSection;

struct PseudoTimeParameters {
  bool used = true;       ///< pseudo-time follows where the path ends early, and tells collapses
  double run_away = 0.2;  ///< share of the structure that is no elastic displacement of masonry, on the path too
  /// drag of the first step, relative to the proximal weights of the problem: as much as these resist
  static constexpr double drag = 1;
  /// by which the drag falls after a step that arrives, and rises after one that does not: a step of ten times the
  /// length is another problem; less would take more steps
  static constexpr double factor = order_of_magnitude;
  /// of a step, relative to the residual that it begins with: as much as the drag falls by
  static constexpr double accuracy = 1 / factor;
  /// share of the imbalance that a motion without end may change: no more than what active sets call no gain
  static constexpr double unchanged = ActiveSetParameters{}.gained;
  /// contact residual, of the largest force, at which a motion without end is believed: stones in flight collide
  static constexpr double believable = 1 / (order_of_magnitude * order_of_magnitude);
  void declare(ParameterSection&);
};

}  // namespace voussoir

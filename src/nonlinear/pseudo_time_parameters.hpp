// Numbers of pseudo-time (pseudo_time.hpp), and of collapses, which it tells.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct PseudoTimeParameters {
  bool used = true;          ///< pseudo-time follows where the path ends early, and tells collapses
  double drag = 1;           ///< of the first step, relative to the proximal weights of the problem
  double factor = 10;        ///< by which the drag falls after a step that arrives, and rises after one that does not
  double accuracy = 0.1;     ///< of a step, relative to the residual that it begins with
  double run_away = 0.2;     ///< share of the structure that is no elastic displacement of masonry, on the path too
  double unchanged = 0.5;    ///< share of the imbalance that a motion without end may change
  double believable = 0.01;  ///< contact residual, of the largest force, at which a motion without end is believed
  void declare(ParameterSection&);
};

}  // namespace voussoir

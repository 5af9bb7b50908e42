// A stage of loading: load steps in equal increments, or a stretch of time.
#pragma once

#include <map>
#include <string>

namespace voussoir {

class ParameterSection;

/// Loads that a stage does not name keep the factor they had; before the first stage all are 0.
struct StageParameters {
  std::string name;
  int increments = 1;                     ///< equal load steps of a stage without duration
  std::map<std::string, double> factors;  ///< sublist "loads": load name -> factor at the end of the stage
  double duration = 0;                    ///< [s] 0 = load steps without mass
  double time_step = 0;                   ///< [s] of a stage with duration; 0 = automatic
  bool at_once = false;                   ///< with duration: factors jump to their values instead of going linearly
  bool dynamic() const { return duration > 0; }
  void declare(ParameterSection&);
};

struct LoadStepParameters {
  static constexpr int most_halvings = 30;
  int largest_halvings = 4;      ///< how often a load step that does not converge is halved
  bool expect_collapse = false;  ///< true: a collapse found is the aim of the scene, exit code 0
  double at_most = 0;            ///< [s] of the clock that a run may take; 0: as long as it takes
  void declare(ParameterSection&);
};

}  // namespace voussoir

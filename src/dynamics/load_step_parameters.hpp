// A stage of loading, reached in equal increments.
#pragma once

#include <map>
#include <string>

namespace voussoir {

class ParameterSection;

/// Loads that a stage does not name keep the factor they had; before the first stage all are 0.
struct StageParameters {
  std::string name;
  int increments = 1;                     ///< equal load steps of this stage
  std::map<std::string, double> factors;  ///< sublist "loads": load name -> factor at the end of the stage
  void declare(ParameterSection&);
};

struct LoadStepParameters {
  int largest_halvings = 4;        ///< how often a load step that does not converge is halved
  bool expect_collapse = false;    ///< true: a collapse found is the aim of the scene, exit code 0
  void declare(ParameterSection&);
};

}  // namespace voussoir

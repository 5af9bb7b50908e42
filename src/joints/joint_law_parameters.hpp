// The law of a family of joints: dry Coulomb friction, or brittle cohesive.
#pragma once

#include <string>

namespace voussoir {

class ParameterSection;

struct JointLawParameters {
  std::string between = "all";        ///< a set of blocks
  std::string and_ = "all";           ///< the other set; key "and". Later families override earlier ones
  double friction_coefficient = 0.6;  ///< [-] may be inf
  double cohesion = 0.0;              ///< [Pa] shear strength without compression, lost once opened or slipped; inf too
  double tension_strength = 0.0;      ///< [Pa] lost likewise; may be inf
  double initial_gap = 0.0;           ///< [m] opening at the start of joints that are drawn closed
  void declare(ParameterSection&);
};

}  // namespace voussoir

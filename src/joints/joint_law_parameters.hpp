// The law of a family of joints: dry Coulomb friction, or cohesive.
#pragma once

#include <limits>
#include <string>

namespace voussoir {

class ParameterSection;

/// How strength falls with opening and slip.
enum class SofteningShape { linear, exponential };

struct JointLawParameters {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double stiffest = 1e13;  ///< [Pa/m] of mortar
  std::string between = "all";              ///< a set of blocks
  std::string and_ = "all";                 ///< the other set; key "and". Later families override earlier ones
  double friction_coefficient = 0.6;        ///< [-] may be inf
  double cohesion = 0.0;          ///< [Pa] shear strength without compression, lost as it opens or slips; inf too
  double tension_strength = 0.0;  ///< [Pa] lost likewise; may be inf
  /// [J/m2] that part the joint in opening and in shear; 0: its strength is lost at once
  double fracture_energy = 0.0, shear_fracture_energy = 0.0;
  SofteningShape softening = SofteningShape::linear;
  /// [Pa/m] of mortar: Young's and shear modulus by its thickness; inf: none
  double normal_stiffness = infinity, tangential_stiffness = infinity;
  double initial_gap = 0.0;  ///< [m] opening at the start of joints that are drawn closed
  bool has_mortar() const { return normal_stiffness < infinity || tangential_stiffness < infinity; }
  void declare(ParameterSection&);
};

}  // namespace voussoir

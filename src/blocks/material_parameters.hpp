// Linear elastic material of a set of blocks, and the plane assumption.
#pragma once

#include <string>

namespace voussoir {

class ParameterSection;

enum class Plane { stress, strain };

/// Small: equilibrium of the stones as drawn. Finite: of the stones where they have moved and turned to.
enum class Rotations { small, finite };

/// Consistent: integrals of products of shape functions. Lumped: each node has the mass of its share of the volume.
enum class Mass { consistent, lumped };

/// Incompatible: cells in space have modes of their own in which they bend. Plain: they bend only by shearing.
enum class Hexahedra { incompatible, plain };

struct ModelParameters {
  Plane plane = Plane::stress;
  double thickness = 1.0;  ///< [m] out of plane
  Hexahedra hexahedra = Hexahedra::incompatible;
  Rotations rotations = Rotations::small;
  void declare(ParameterSection&);
};

struct MaterialParameters {
  std::string blocks = "all";   ///< a set of blocks; later materials of the scene override earlier ones
  double young_modulus = 20e9;  ///< [Pa]
  double poisson_ratio = 0.2;   ///< [-]
  double density = 2200.0;      ///< [kg/m3]
  double thickness = 0;         ///< [m] out of plane; 0 = that of the model
  void declare(ParameterSection&);
};

}  // namespace voussoir

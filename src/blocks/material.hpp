// Linear elasticity of a stone.
#pragma once

#include <array>

#include "blocks/material_parameters.hpp"

namespace voussoir {

/// What an element needs to know of its stone.
struct Material {
  double young_modulus = 0;  ///< [Pa]
  double poisson_ratio = 0;  ///< [-]
  double density = 0;        ///< [kg/m3]
  double thickness = 0;      ///< [m] out of plane; 0 = that of the model
};

/// [m] out of plane.
inline double thickness_of(const Material& m, const ModelParameters& model) {
  return m.thickness > 0 ? m.thickness : model.thickness;
}

/// Elasticity matrix in Voigt notation (xx, yy, xy with engineering shear) [Pa].
inline std::array<std::array<double, 3>, 3> plane_elasticity(const Material& m, Plane plane) {
  double e = m.young_modulus, nu = m.poisson_ratio;
  if (plane == Plane::strain) {  // plane strain is plane stress of another material
    e /= 1 - nu * nu;
    nu /= 1 - nu;
  }
  const double c = e / (1 - nu * nu);
  return {{{c, c * nu, 0}, {c * nu, c, 0}, {0, 0, c * (1 - nu) / 2}}};
}

}  // namespace voussoir

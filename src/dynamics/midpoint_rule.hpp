// Implicit midpoint rule for M a + C v + K u = f + B^T lambda, C = alpha M + beta K (Rayleigh).
//
// The unknown of a step is w = u_mid - u_n, half the displacement of the step:
//
//   S w = f_mid - K u_n + (2/dt) M v_n + B^T lambda,     S = (4/dt^2 + 2 alpha/dt) M + (1 + 2 beta/dt) K
//   u_n+1 = u_n + 2 w,     v_n+1 = (4/dt) w - v_n
//
// Theory   J. C. Simo, N. Tarnow, K. K. Wong, Comput. Methods Appl. Mech. Eng. 100 (1992) 63-116 (midpoint, energy);
//          T. A. Laursen, G. R. Love, Int. J. Numer. Methods Eng. 53 (2002) 245-274 (velocity update after impact).
#pragma once

#include <cmath>

#include "base/check.hpp"

namespace voussoir {

struct MidpointRule {
  double time_step = 0;          ///< [s]
  double mass_damping = 0;       ///< [1/s] alpha
  double stiffness_damping = 0;  ///< [s] beta

  /// Factors of M [1/s2] and K [-] in S.
  double mass_factor() const { return (4 / time_step + 2 * mass_damping) / time_step; }
  double stiffness_factor() const { return 1 + 2 * stiffness_damping / time_step; }
  double displacement_at_end(double u, double w) const { return u + 2 * w; }
  double velocity_at_end(double v, double w) const { return 4 * w / time_step - v; }
  double midpoint_velocity(double w) const { return 2 * w / time_step; }
};

/// The least change x along a direction that raises an energy by `wanted`: square x^2 + slope x = wanted. [J]
/// Where nothing raises it that much, the x that raises it most (or lowers it least).
/// @param square  1/2 d.M d of the direction, > 0
/// @param slope   v.M d
inline double least_change(double square, double slope, double wanted) {
  VOUSSOIR_EXPECT(square > 0 && "a direction that moves mass");
  const double discriminant = slope * slope + 4 * square * wanted;
  if (!(discriminant > 0)) return -slope / (2 * square);
  const double root = std::sqrt(discriminant);
  return 2 * wanted / (slope >= 0 ? slope + root : slope - root);
}

}  // namespace voussoir

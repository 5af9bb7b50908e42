// How a joint loses its strength: tension strength T and cohesion C [N] of a point fall with one measure of damage D.
//
//   kappa = | (T g / G_I, C s / G_II) |        g [m] the largest opening there has been, s [m] the way slipped
//   D = min(1, kappa / 2)                      linear softening
//   D = 1 - exp(-kappa)                        exponential softening
//
// G_I and G_II [J] part the point in opening and in shear: each mode alone takes exactly its energy. What is left is
// (1 - D) (T, C), and friction acts beside it: a joint that is pressed bears (1 - D) C + mu p, and keeps mu p. Until
// its strength is reached a point is rigid. A point that has opened pulls back in proportion to its opening, up to the
// largest there has been, and closes at zero force; what has slipped stays where it is.
//
// Theory   F. Snozzi, J.-F. Molinari, Int. J. Numer. Methods Eng. 93 (2013) 510-526 (rigid until it cracks, two
//          energies, unloading to the origin, friction); P. B. Lourenco, J. G. Rots, J. Eng. Mech. 123 (1997) 660-668
//          (masonry joints: friction beside softening cohesion, damage of both modes together).
#pragma once

#include <algorithm>
#include <cmath>

#include "joints/contact_law.hpp"

namespace voussoir {

/// How fast one point loses its strength.
struct Softening {
  double per_opening = 0;    ///< [1/m] T / G_I
  double per_slip = 0;       ///< [1/m] C / G_II
  bool exponential = false;  ///< else linear
  /// As fast as stones can follow: in that mode the point breaks off where an equilibrium overloads it.
  bool brittle_opening = false, brittle_slip = false;

  /// Whether there is a way to lose it.
  bool any() const { return per_opening > 0 || per_slip > 0; }
  double kappa(double opened, double slipped) const { return std::hypot(per_opening * opened, per_slip * slipped); }
  bool brittle() const { return brittle_opening || brittle_slip; }
  /// D, from 0 where all strength is there to 1 where none is left.
  double damage(double kappa) const { return exponential ? -std::expm1(-kappa) : std::min(1.0, kappa / 2); }
  /// kappa at which nothing is left, of exponential softening less than round-off.
  double whole_kappa() const { return exponential ? 40.0 : 2.0; }
  /// dD / d kappa.
  double growth(double kappa) const { return exponential ? std::exp(-kappa) : kappa < 2 ? 0.5 : 0.0; }
};

/// What a point has gone through [m].
struct JointWear {
  double opened = 0;   ///< largest opening
  double slipped = 0;  ///< length of the way slipped
};

/// Strength [N] that is left. An infinite one stays until all is lost.
inline double strength_left(double strength, double damage) { return damage < 1 ? strength * (1 - damage) : 0.0; }

/// The law of a point at some opening and slip, and how it changes with them.
struct WeakenedLaw {
  PointLaw law;                  ///< with the strength that is left there
  double pull = 0;               ///< [N] force with which an open point pulls; below 0 where it would be pressed
  double pull_per_opening = 0;   ///< [N/m] its change: negative where the point softens, positive where it pulls back
  double pull_per_slip = 0;      ///< [N/m] likewise, per length of way
  double cohesion_per_gap = 0;   ///< [N/m] change of the cohesion, not positive
  double cohesion_per_slip = 0;  ///< [N/m] likewise, per length of way
};

/// @param whole   law without damage
/// @param before  wear at the start of the step
/// @param gap     [m] opening; below 0 where stones are pressed
/// @param slip    [m] way slipped since the start of the step
WeakenedLaw weaken(const PointLaw& whole, const Softening&, const JointWear& before, double gap, double slip);

}  // namespace voussoir

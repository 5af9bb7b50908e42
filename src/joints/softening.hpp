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
#include <utility>
#include <vector>

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

/// Softening of many points during one step, as the nonlinear solver sees it. Points wear with every state that it
/// comes to on its way (wear_by), and their strength may be held as it is meanwhile.
class SofteningPoints {
 public:
  /// References must outlive it.
  /// @param whole       laws without damage
  /// @param opened      [m] of the wear at the start of the step, per point
  /// @param slipped     [m] likewise
  /// @param gap_before  [m] per point, what is added to a gap before it is looked at; may be empty
  SofteningPoints(const PointLaws& whole, const std::vector<Softening>& softening, std::vector<double> opened,
                  const std::vector<double>& slipped, std::vector<double> gap_before = {})
      : whole_(whole),
        softening_(softening),
        opened_before_(std::move(opened)),
        opened_(opened_before_),
        slipped_(slipped),
        way_(slipped_.size(), 0.0),
        reached_(way_),
        gap_before_(std::move(gap_before)) {}

  /// Whether a point is one that can lose its strength, or has.
  bool softens(std::size_t k) const { return softening_[k].any(); }
  /// @param slip  [m] since the start of the step
  WeakenedLaw at(std::size_t k, double gap, double slip) const;
  /// From now on, strength stays as it is wherever points open or slip to; or falls again.
  void hold(bool held) { held_ = held; }
  /// A point has come to this gap and slip [m]. Nothing is undone, and what the solver leaves of closed points is none.
  /// While strength is held a point that has opened or slipped, and is brittle in that, breaks off.
  /// @param normal  [N] its force
  /// @param shear   [N] size of its tangential force less stiffness times slip
  /// @return whether it has broken off by more than all that it had to lose
  bool wear_by(std::size_t k, double gap, double slip, double normal, double shear, double stiffness);
  /// What points have gone through since the start of the step, to come back to; and as if that were nothing, but for
  /// what has broken off.
  struct Since {
    std::vector<double> opened, way, reached;  ///< [m] per point
  };
  Since since_start() const { return {opened_, way_, reached_}; }
  void come_back(Since);
  void start_again();
  /// Largest damage of a point that has these behind it beyond what it has now, brittle ones left out.
  double lost_beyond(const Since&) const;
  /// [m] largest opening, and way slipped since the start of the step.
  double opened(std::size_t k) const { return opened_[k]; }
  double way(std::size_t k) const { return way_[k]; }

 private:
  void break_off(std::size_t k);
  double seen(std::size_t k, double gap) const { return gap + (gap_before_.empty() ? 0.0 : gap_before_[k]); }

  const PointLaws& whole_;
  const std::vector<Softening>& softening_;
  const std::vector<double> opened_before_;
  std::vector<double> opened_;
  const std::vector<double>& slipped_;
  std::vector<double> way_, reached_;  ///< [m] since the start of the step: slipped, and opened however little
  const std::vector<double> gap_before_;
  bool held_ = false;
};

}  // namespace voussoir

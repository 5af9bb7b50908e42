// Damage of joints that soften within one step: a value that goes into a solve and comes out of it, as displacements
// and forces do, and pure functions of it at one point.
//
//   law_at     the law of a point at some gap and slip. Where strength falls, damage is that of where the point is, or
//              what it has already where that is more. Where strength is held, damage stays as it is wherever the point
//              opens or slips to: it pulls back within its largest opening and is rigid beyond, with what is left
//   wear       the damage of a point that has come to some gap and slip with some force: nothing is undone
//   give_back  the damage of the start of the step, but for what has broken off
//
// In which order a solve uses them: nonlinear/contact_solver.hpp. Theory: method.md, section 6, "Strength that falls".
#pragma once

#include <utility>
#include <vector>

#include "joints/softening.hpp"

namespace voussoir {

/// What a point has gone through [m].
struct PointDamage {
  double opened = 0;   ///< largest opening that counts: within it the point pulls back
  double reached = 0;  ///< largest opening since the start of the step, however little
  double way = 0;      ///< slipped since the start of the step
};

/// Of all points; empty where no joint softens.
using Damage = std::vector<PointDamage>;

enum class StrengthIs { falling, held };

/// With what strength a structure is solved: the damage that points have, and whether it grows with where they are.
struct Strength {
  const Damage* damage = nullptr;  ///< null where no joint softens
  StrengthIs is = StrengthIs::falling;
};

/// Strength that falls from some damage on, and strength that is held at it. The damage must outlive them.
inline Strength fall(const Damage& damage) { return {&damage, StrengthIs::falling}; }
inline Strength hold(const Damage& damage) { return {&damage, StrengthIs::held}; }
Strength fall(const Damage&&) = delete;
Strength hold(const Damage&&) = delete;

/// One point in one step.
struct SofteningPoint {
  PointLaw whole;  ///< without damage
  Softening rate;
  JointWear before;       ///< at the start of the step
  double gap_before = 0;  ///< [m] what is added to a gap before it is looked at
};

/// Where a point has come to, and what it bears there.
struct PointLoading {
  double gap = 0, slip = 0;  ///< [m] slip: size, since the start of the step
  double normal = 0;         ///< [N]
  double shear = 0;          ///< [N] size of the tangential force less stiffness times slip
  double stiffness = 0;      ///< [N/m] of the stones as the point sees them
};

/// @param slip  [m] since the start of the step
WeakenedLaw law_at(const SofteningPoint&, const PointDamage&, StrengthIs, double gap, double slip);

struct WornPoint {
  PointDamage damage;
  bool by_far = false;  ///< it has broken off, overloaded by more than all that it had to lose
};
/// What the solver leaves of closed points is no opening. A point that opens or slips while strength is held, and is
/// brittle in that, breaks off.
WornPoint wear(const SofteningPoint&, const PointDamage&, StrengthIs, const PointLoading&);

PointDamage give_back(const SofteningPoint&, const PointDamage&);

/// Share of its strength that a point has lost [-].
double lost(const SofteningPoint&, const PointDamage&);

/// Energy [J] that the law of a point has taken, or holds, beyond that of the point when it was closed with the wear of
/// the start of the step: where it has come to some gap [m] and normal force [N] with some damage (crack_work.hpp).
double energy_taken(const SofteningPoint&, const PointDamage&, double gap, double normal);

/// The points of one step. What it is made of must outlive it.
class SofteningPoints {
 public:
  /// @param whole       laws without damage
  /// @param opened      [m] of the wear at the start of the step, per point
  /// @param slipped     [m] likewise
  /// @param gap_before  [m] per point, or empty where it is 0
  SofteningPoints(const PointLaws& whole, const std::vector<Softening>& rate, const std::vector<double>& opened,
                  const std::vector<double>& slipped, std::vector<double> gap_before = {})
      : whole_(whole), rate_(rate), opened_(opened), slipped_(slipped), gap_before_(std::move(gap_before)) {}

  std::size_t size() const { return rate_.size(); }
  /// Whether a point is one that can lose its strength, or has.
  bool softens(std::size_t k) const { return rate_[k].any(); }
  SofteningPoint operator[](std::size_t k) const {
    return {whole_[k], rate_[k], {opened_[k], slipped_[k]}, gap_before_.empty() ? 0.0 : gap_before_[k]};
  }
  /// Damage of the start of the step.
  Damage at_start() const;

 private:
  const PointLaws& whole_;
  const std::vector<Softening>& rate_;
  const std::vector<double>& opened_;
  const std::vector<double>& slipped_;
  const std::vector<double> gap_before_;
};

/// Of each point.
Damage give_back(const SofteningPoints&, const Damage&);

/// Most of its strength that a point has lost by one damage beyond what it has by another, brittle points left out [-].
double lost_beyond(const SofteningPoints&, const Damage& worn, const Damage& now);

}  // namespace voussoir

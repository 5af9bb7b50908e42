#include "joints/softening.hpp"

namespace voussoir {

WeakenedLaw weaken(const PointLaw& whole, const Softening& softening, const JointWear& before, double gap,
                   double slip) {
  const JointWear wear{std::max(before.opened, gap), before.slipped + std::abs(slip)};
  const double kappa = softening.kappa(wear.opened, wear.slipped), damage = softening.damage(kappa);
  const double growth = softening.growth(kappa);
  const auto slope = [&](double strength, double rate, double way) {  // of what is left of it
    if (!std::isfinite(strength) || growth == 0) return 0.0;
    return -strength * growth * rate * (kappa > 0 ? rate * way / kappa : 1.0);
  };
  WeakenedLaw now;
  now.law = {whole.friction, strength_left(whole.cohesion, damage), strength_left(whole.tension, damage)};
  now.pull = now.law.tension;
  now.cohesion_per_slip = slope(whole.cohesion, softening.per_slip, wear.slipped);
  now.pull_per_slip = slope(whole.tension, softening.per_slip, wear.slipped);
  const bool opens = gap >= before.opened;
  if (opens) now.cohesion_per_gap = slope(whole.cohesion, softening.per_opening, wear.opened);
  if (opens || before.opened == 0) {
    now.pull_per_opening = slope(whole.tension, softening.per_opening, wear.opened);
    return now;
  }
  if (!std::isfinite(now.pull)) return now;
  now.pull_per_opening = now.pull / before.opened;
  now.pull = now.pull_per_opening * gap;
  now.pull_per_slip *= gap / before.opened;
  now.law.tension = std::max(0.0, now.pull);
  return now;
}

}  // namespace voussoir

#include "joints/softening.hpp"

#include <limits>

namespace voussoir {
namespace {

constexpr double all_lost = 40;  // kappa beyond which exponential softening has left less than round-off

}  // namespace

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

WeakenedLaw SofteningPoints::at(std::size_t k, double gap, double slip) const {
  const JointWear before{opened_[k], slipped_[k]};
  const double worn = std::max(before.opened, reached_[k]), here = seen(k, gap);
  // One that pulls back does so within the largest opening that counts; the others are rigid with what is left to them.
  const bool back = before.opened > 0 && here < before.opened, stays = !back && (held_ || here < worn);
  auto now = weaken(whole_[k], softening_[k], before, stays ? worn : here,
                    held_ ? way_[k] : std::max(way_[k], std::abs(slip)));
  if (held_ || std::abs(slip) < way_[k]) now.cohesion_per_slip = now.pull_per_slip = 0;
  if (stays) now.pull_per_opening = now.cohesion_per_gap = 0;
  return now;
}

bool SofteningPoints::wear_by(std::size_t k, double gap, double slip, double normal, double shear, double stiffness) {
  if (!softens(k)) return false;
  const auto now = at(k, gap, slip);
  const auto& law = now.law;
  const bool opens = normal - stiffness * gap < -law.tension, slips = !below_bound(shear, friction_bound(law, normal));
  const auto& rate = softening_[k];
  const bool loses = law.tension > 0 || law.cohesion > 0;
  if (held_ && loses && ((opens && rate.brittle_opening) || (slips && rate.brittle_slip))) {
    break_off(k);
    return rate.damage(rate.kappa(opens ? seen(k, gap) : 0.0, slips ? slip : 0.0)) == 1;
  }
  // Within a step any opening weakens, or a state that is held would come again for ever. Of one within what the stones
  // beside it stretch by no more is kept: it closes rigidly, as what has not opened.
  if (opens) reached_[k] = std::max(reached_[k], seen(k, gap));
  if (opens && now.pull <= stiffness * seen(k, gap)) opened_[k] = std::max(opened_[k], seen(k, gap));
  if (slips) way_[k] = std::max(way_[k], std::abs(slip));
  return false;
}

/// It opens, or slips, as far as it takes to lose all.
void SofteningPoints::break_off(std::size_t k) {
  const auto& rate = softening_[k];
  const double kappa = rate.exponential ? all_lost : 2 * (1 + 4 * std::numeric_limits<double>::epsilon());
  if (rate.per_opening > 0)
    reached_[k] = opened_[k] = std::max(opened_[k], kappa / rate.per_opening);
  else
    way_[k] = std::max(way_[k], kappa / rate.per_slip);
}

void SofteningPoints::come_back(Since since) {
  opened_ = std::move(since.opened);
  way_ = std::move(since.way);
  reached_ = std::move(since.reached);
}

double SofteningPoints::lost_beyond(const Since& other) const {
  double most = 0;
  for (std::size_t k = 0; k < softening_.size(); ++k) {
    const auto& rate = softening_[k];
    const auto damage = [&](double opened, double way) { return rate.damage(rate.kappa(opened, slipped_[k] + way)); };
    if (!rate.brittle()) most = std::max(most, damage(other.opened[k], other.way[k]) - damage(opened_[k], way_[k]));
  }
  return most;
}

void SofteningPoints::start_again() {
  for (std::size_t k = 0; k < softening_.size(); ++k) {
    const auto& rate = softening_[k];
    if (rate.brittle() && rate.damage(rate.kappa(opened_[k], slipped_[k] + way_[k])) == 1) continue;
    opened_[k] = opened_before_[k];
    way_[k] = reached_[k] = 0;
  }
}

}  // namespace voussoir

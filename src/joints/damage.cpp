#include "joints/damage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "joints/crack_work.hpp"

namespace voussoir {
namespace {

/// It opens, or slips, as far as it takes to lose all.
PointDamage broken_off(const Softening& rate, PointDamage damage) {
  const double kappa = rate.whole_kappa() * (1 + 4 * std::numeric_limits<double>::epsilon());
  if (rate.per_opening > 0)
    damage.reached = damage.opened = std::max(damage.opened, kappa / rate.per_opening);
  else
    damage.way = std::max(damage.way, kappa / rate.per_slip);
  return damage;
}

}  // namespace

WeakenedLaw law_at(const SofteningPoint& point, const PointDamage& damage, StrengthIs strength, double gap,
                   double slip) {
  const bool held = strength == StrengthIs::held;
  const JointWear before{damage.opened, point.before.slipped};
  const double worn = std::max(damage.opened, damage.reached), here = gap + point.gap_before;
  // One that pulls back does so within the largest opening that counts; the others are rigid with what is left to them.
  const bool back = before.opened > 0 && here < before.opened, stays = !back && (held || here < worn);
  auto now = weaken(point.whole, point.rate, before, stays ? worn : here,
                    held ? damage.way : std::max(damage.way, std::abs(slip)));
  if (held || std::abs(slip) < damage.way) now.cohesion_per_slip = now.pull_per_slip = 0;
  if (stays) now.pull_per_opening = now.cohesion_per_gap = 0;
  return now;
}

WornPoint wear(const SofteningPoint& point, const PointDamage& damage, StrengthIs strength, const PointLoading& at) {
  const auto& rate = point.rate;
  if (!rate.any()) return {damage};
  const auto now = law_at(point, damage, strength, at.gap, at.slip);
  const auto& law = now.law;
  const bool opens = at.normal - at.stiffness * at.gap < -law.tension;
  const bool slips = !below_bound(at.shear, friction_bound(law, at.normal));
  const bool loses = law.tension > 0 || law.cohesion > 0;
  const double here = at.gap + point.gap_before;
  if (strength == StrengthIs::held && loses && ((opens && rate.brittle_opening) || (slips && rate.brittle_slip)))
    return {broken_off(rate, damage), rate.damage(rate.kappa(opens ? here : 0.0, slips ? at.slip : 0.0)) == 1};
  auto worn = damage;
  // Within a step any opening weakens, or a state that is held would come again for ever. Of one within what the stones
  // beside it stretch by no more is kept: it closes rigidly, as what has not opened.
  if (opens) worn.reached = std::max(worn.reached, here);
  if (opens && now.pull <= at.stiffness * here) worn.opened = std::max(worn.opened, here);
  if (slips) worn.way = std::max(worn.way, std::abs(at.slip));
  return {worn};
}

PointDamage give_back(const SofteningPoint& point, const PointDamage& damage) {
  if (point.rate.brittle() && lost(point, damage) == 1) return damage;
  return {point.before.opened};
}

double lost(const SofteningPoint& point, const PointDamage& damage) {
  const auto& rate = point.rate;
  return rate.damage(rate.kappa(damage.opened, point.before.slipped + damage.way));
}

double energy_taken(const SofteningPoint& point, const PointDamage& damage, double gap, double normal) {
  const JointWear after{std::max(point.before.opened, damage.opened), point.before.slipped + damage.way};
  const auto work = crack_work(point.whole, point.rate, {point.before, 0, 0}, {after, gap + point.gap_before, normal});
  return work.pull + work.cohesion;
}

Damage SofteningPoints::at_start() const {
  Damage damage;
  for (const double opened : opened_) damage.push_back({opened});
  return damage;
}

Damage give_back(const SofteningPoints& points, const Damage& damage) {
  Damage given;
  for (std::size_t k = 0; k < points.size(); ++k) given.push_back(give_back(points[k], damage[k]));
  return given;
}

double lost_beyond(const SofteningPoints& points, const Damage& worn, const Damage& now) {
  double most = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto point = points[k];
    if (!point.rate.brittle()) most = std::max(most, lost(point, worn[k]) - lost(point, now[k]));
  }
  return most;
}

}  // namespace voussoir

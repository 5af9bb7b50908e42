// What single points do in active sets: their status, how they resist, the force that they aim at.
#include <algorithm>
#include <cmath>

#include "nonlinear/active_set.hpp"
#include "nonlinear/point_update.hpp"

namespace voussoir {
namespace {

// [-] cosine of the angle by which a slip may turn and still be the same: within it the derivative points the way.
constexpr double same_direction = 0.5;

}  // namespace

void ActiveSet::set_status(int point, const PointField& lambda, const PointField& gap, const PointField& before) {
  const auto weakened = laws_.at(point);
  const auto& law = weakened.law;
  const std::size_t at = std::size_t(point) * components_;
  const auto motion = [&](int c) { return motion_of(problem_, point, c, gap, lambda); };
  const auto trial = [&](int c) { return lambda[at + c] - stiffness_of(problem_, point, c, 1.0) * motion(c); };
  const double normal = trial(0);
  double* s = &sliding_[std::size_t(point) * (components_ - 1)];
  double shear = 0, advance = 0;
  for (int c = 1; c < components_; ++c) {
    s[c - 1] = trial(c);
    shear += s[c - 1] * s[c - 1];
    advance -= s[c - 1] * motion(c);
  }
  shear = std::sqrt(shear);
  auto status = judge(law, normal, shear, friction_bound(law, normal));
  const bool closed = status != ContactStatus::open;
  closed_[point] = closed;
  const double bound = friction_bound(law, closed ? normal : -law.tension);
  // An open point that still has cohesion sticks or slips likewise.
  if (!closed && bound > 0) status = below_bound(shear, bound) ? ContactStatus::stick : ContactStatus::slip;
  if (status == ContactStatus::slip && turns_round(point, shear, before) && bound > 0) status = ContactStatus::stick;
  auto& r = resistance_[point];
  r.normal = closed ? stiffness_of(problem_, point, 0, augmentation_) : weakened.pull_per_opening;
  if (status == ContactStatus::stick) r.hold(0, stiffness_of(problem_, point, 1, augmentation_));
  if (status != ContactStatus::slip) std::fill(s, s + components_ - 1, 0.0);
  if (status == ContactStatus::slip && bound > 0) slide(point, weakened, turning(point, bound / shear), advance >= 0);
  if (!problem_.compliance().empty()) r = in_series(r, mortar_of(point), components_);
}

/// Stiffness against motion across the slip [N/m]. Newton on q = P(q - k slip) in both: across the slip q is a times
/// its trial force, so q = -k a / (1 - a) slip: friction over slip, as Coulomb's direction turns. Bounded by what
/// sticks, for a point may not have slipped yet.
/// @param share  a, the bound over the size of the trial force
double ActiveSet::turning(int point, double share) const {
  share = std::min(share, 1.0);
  return stiffness_of(problem_, point, 1, 1.0) * share / (1 - share + share / augmentation_);
}

/// What a sliding point's forces change by along its motions.
/// @param across    stiffness against motion across the slip [N/m]
/// @param advances  it slips on, so that more strength is lost
void ActiveSet::slide(int point, const WeakenedLaw& weakened, double across, bool advances) {
  auto& r = resistance_[point];
  across_[point] = across;
  const double friction = std::isfinite(weakened.law.friction) ? weakened.law.friction : 0.0;
  const double pulls = advances && !closed_[point] ? weakened.pull_per_slip : 0.0;
  const double along = advances ? weakened.cohesion_per_slip : 0.0;
  r.slide(&sliding_[std::size_t(point) * (components_ - 1)], components_ - 1,
          friction * r.normal - weakened.cohesion_per_gap, across, along - friction * pulls, -pulls);
}

/// Mortar in series with what the law gives. What resists with the local stiffness has it in series already.
PointCompliance ActiveSet::mortar_of(int point) const {
  if (problem_.compliance().empty()) return {};
  auto mortar = problem_.compliance()[point];
  if (closed_[point]) mortar.normal = 0;
  if (!slides(point)) mortar.tangential = 0;
  return mortar;
}

/// Makes the trial force of a slipping point its direction. No point turns round from the direction in which it slid
/// before: between the two it sticks.
bool ActiveSet::turns_round(int point, double shear, const PointField& before) {
  const int tangents = components_ - 1;
  double* s = &sliding_[std::size_t(point) * tangents];
  // Where nothing rubs and nothing pulls either direction is as good as the other.
  for (int c = 0; c < tangents; ++c) s[c] = shear > 0 ? s[c] / shear : c == 0;
  return alike(point, before) < 0;
}

/// Cosine between the slip of a point and the one before; 0 where either is none.
double ActiveSet::alike(int point, const PointField& before) const {
  double cosine = 0;
  for (int i = point * (components_ - 1); i < (point + 1) * (components_ - 1); ++i) cosine += sliding_[i] * before[i];
  return cosine;
}

/// Whether a point has begun or ceased to slip, or slips to another side. In space directions turn a little with every
/// solve, which the derivative knows.
bool ActiveSet::turned(int point, const PointField& before) const {
  const auto* const was = &before[std::size_t(point) * (components_ - 1)];
  const bool slid = std::any_of(was, was + components_ - 1, [](double c) { return c != 0; });
  return slid != slides(point) || (slid && alike(point, before) < same_direction);
}

/// Forces of all points at these gaps: those of the law where statuses were chosen, and their change from there.
/// @param chosen  [m] gaps that statuses were chosen by
void ActiveSet::set_right_hand_side(const PointField& lambda, const PointField& chosen) {
  target_ = lambda;
  std::vector<double> motion(components_);
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const auto& r = resistance_[k];
    const std::size_t at = std::size_t(k) * components_;
    double* force = &target_[at];
    const bool follows = set_force_of_law(k, lambda, chosen);
    const auto mortar = mortar_of(k);
    for (int c = 0; c < components_; ++c)
      motion[c] = gap_[at + c] - chosen[at + c] + mortar.along(c) * (force[c] - lambda[at + c]);
    r.yield(motion.data(), components_, force);
    if (follows) continue;
    const double bound = friction_bound(laws_[k], force[0]), size = tangential_size(target_, k, components_);
    const double* s = &sliding_[std::size_t(k) * (components_ - 1)];
    for (int c = 1; c < components_; ++c) {
      if (slides(k))
        force[c] = s[c - 1] * bound;
      else if (size > bound)
        force[c] *= bound / size;
    }
  }
}

/// Force that the law gives a point at the gaps by which its status was chosen. Whether its tangential part changes
/// with the point's motion, or is what the bound makes of it in the end.
bool ActiveSet::set_force_of_law(int point, const PointField& lambda, const PointField& chosen) {
  const auto& r = resistance_[point];
  const auto law = laws_.at(point);
  const double* s = &sliding_[std::size_t(point) * (components_ - 1)];
  double* force = &target_[std::size_t(point) * components_];
  const auto motion = [&](int c) { return motion_of(problem_, point, c, chosen, lambda); };
  force[0] = closed_[point] ? force[0] - r.normal * motion(0) : -law.pull;
  if (!slides(point)) {
    if (!closed_[point] && !r.resists_slip()) return false;
    for (int c = 1; c < components_; ++c) force[c] -= r.along(c - 1, c - 1) * motion(c);
    return true;
  }
  const bool turns = components_ == 3 && r.resists_slip();
  if (!r.couples() && !turns) return false;
  const double friction = std::isfinite(law.law.friction) ? law.law.friction : 0.0;
  for (int c = 1; c < components_; ++c) force[c] = s[c - 1] * (law.law.cohesion + friction * force[0]);
  if (!turns) return true;
  const double along = s[0] * motion(1) + s[1] * motion(2);
  for (int c = 1; c < components_; ++c) force[c] -= across_[point] * (motion(c) - along * s[c - 1]);
  return true;
}

}  // namespace voussoir

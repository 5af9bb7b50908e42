#include "joints/joint_statics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"

namespace voussoir {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// A hinge of elastic stones has a compressed zone; with stress that grows linearly to the edge its resultant lies at a
// third of it. A tenth of the joint is where three tenths of it are compressed.
constexpr double at_the_edge = 0.1;
// Closed points stand open by what the solver leaves, 1e-13 m; openings of stones that move are millions of times that.
constexpr double open_share = 1e-9;  // of the length
// Forces are known to the tolerance of the solver, relative to the largest of the structure: a small joint's to less.
constexpr double at_the_cone = 1e-3;
// A side that bears less than this share of what presses on its joint says nothing.
constexpr double negligible = 1e-6;

Vector<2> turned(const Vector<2>& n) { return {-n[1], n[0]}; }

using Points = std::vector<PointOfJoint>;
const PointOfJoint& at(const Points& points, int k) { return points[static_cast<std::size_t>(k)]; }

/// Points that follow each other without a corner.
struct Side {
  std::vector<int> chain;  ///< points, along their tangents
  bool closed = false;     ///< it runs round and has no ends
};

/// All points as they follow each other along a direction.
Side one_side(const Points& points, const Vector<2>& along) {
  Side side;
  for (std::size_t k = 0; k < points.size(); ++k) side.chain.push_back(static_cast<int>(k));
  std::stable_sort(side.chain.begin(), side.chain.end(), [&](int a, int b) {
    return dot(at(points, a).position, along) < dot(at(points, b).position, along);
  });
  return side;
}

std::vector<Side> sides_of(const Points& points, const std::vector<FacetOfJoint>& facets) {
  std::vector<std::vector<int>> next_to(points.size());
  for (const auto& [a, b] : facets) {
    next_to[static_cast<std::size_t>(a)].push_back(b);
    next_to[static_cast<std::size_t>(b)].push_back(a);
  }
  std::vector<char> seen(points.size(), 0);
  std::vector<Side> sides;
  const auto walk = [&](int from, bool closed) {
    Side side{{}, closed};
    for (int k = from; k >= 0;) {
      seen[static_cast<std::size_t>(k)] = 1;
      side.chain.push_back(k);
      const auto& others = next_to[static_cast<std::size_t>(k)];
      const auto on =
          std::find_if(others.begin(), others.end(), [&](int p) { return !seen[static_cast<std::size_t>(p)]; });
      k = on == others.end() ? -1 : *on;
    }
    const auto &first = at(points, side.chain.front()), &last = at(points, side.chain.back());
    if (!closed && dot(last.position - first.position, turned(first.normal)) < 0)
      std::reverse(side.chain.begin(), side.chain.end());
    sides.push_back(std::move(side));
  };
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!seen[k] && next_to[k].size() < 2) walk(static_cast<int>(k), false);
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!seen[k]) walk(static_cast<int>(k), true);
  return sides;
}

/// A side as if it were straightened.
struct StraightSide {
  double pressing = 0, length = 0;
  double edge_margin = nan, friction_margin = nan;
  int near = -1, far = -1;  ///< the end next to the pressure, the other one
  bool holds = false;       ///< has strength beside friction
  bool hinge = false;
};

StraightSide straightened(const Points& points, const Side& side) {
  StraightSide s;
  double moment = 0, shear = 0, bound = 0;
  bool pulls = false;
  const PointOfJoint* before = nullptr;
  for (const int k : side.chain) {
    const auto& p = at(points, k);
    if (before) s.length += norm(p.position - before->position);
    before = &p;
    s.pressing += p.normal_force;
    moment += s.length * p.normal_force;
    shear += p.shear;
    bound += friction_bound(p.law, p.normal_force);
    pulls = pulls || p.law.tension > 0;
    s.holds = s.holds || pulls || p.law.cohesion > 0;
  }
  if (bound > 0) s.friction_margin = std::max(0.0, 1 - std::abs(shear) / bound);
  if (!(s.pressing > 0) || !(s.length > 0) || side.closed) return s;
  const double place = moment / s.pressing;
  s.edge_margin = std::min(place, s.length - place) / s.length;
  if (!pulls) s.edge_margin = std::max(0.0, s.edge_margin);
  s.near = side.chain.front(), s.far = side.chain.back();
  if (2 * place > s.length) std::swap(s.near, s.far);
  s.hinge = s.edge_margin < at_the_edge && at(points, s.far).gap > open_share * s.length &&
            at(points, s.near).normal_force > 0;
  return s;
}

/// The least margins of the sides that are pressed.
void measure(JointStatics& joint, const Points& points, const std::vector<Side>& sides) {
  joint.edge_margin = joint.friction_margin = nan;
  joint.edge = joint.least_shear = {nan, nan};
  joint.sides = static_cast<int>(sides.size());
  int pressed = 0, hinges = 0, sliding = 0;
  for (const auto& side : sides) {
    const auto s = straightened(points, side);
    const bool presses = s.pressing > 0 && s.pressing >= negligible * joint.pressing;
    if (!presses && !s.holds) continue;
    pressed += presses;
    hinges += s.hinge;
    sliding += presses && s.friction_margin < at_the_cone;
    if (s.near >= 0 && !(s.edge_margin >= joint.edge_margin)) {
      joint.edge_margin = s.edge_margin;
      joint.edge = at(points, s.near).position;
    }
    if (!std::isnan(s.friction_margin) && !(s.friction_margin >= joint.friction_margin)) {
      joint.friction_margin = s.friction_margin;
      const auto &first = at(points, side.chain.front()), &last = at(points, side.chain.back());
      joint.least_shear = 0.5 * (first.position + last.position);
    }
  }
  joint.hinge = pressed == 1 && hinges == 1;
  joint.slides = joint.pressing > 0 && pressed > 0 && sliding == pressed;
}

}  // namespace

JointStatics joint_statics(const std::vector<PointOfJoint>& points, const std::vector<FacetOfJoint>& facets) {
  VOUSSOIR_EXPECT(!points.empty());
  Vector<2> normal{};
  for (const auto& p : points) normal = normal + p.normal;
  normal = norm(normal) > 1e-6 ? (1 / norm(normal)) * normal : points.front().normal;
  const auto along = turned(normal);
  const auto whole = one_side(points, along);
  const auto& low = points[static_cast<std::size_t>(whole.chain.front())];
  const auto& high = points[static_cast<std::size_t>(whole.chain.back())];

  JointStatics joint;
  joint.length = dot(high.position - low.position, along);
  joint.middle = 0.5 * (low.position + high.position);
  double moment = 0;
  for (const auto& p : points) {
    const auto force = p.normal_force * p.normal + p.shear * turned(p.normal);
    joint.force = joint.force + force;
    joint.pressing += p.normal_force;
    moment += cross(p.position - joint.middle, force);
    joint.opening = std::max(joint.opening, p.gap);
  }
  joint.normal_force = dot(joint.force, normal);
  joint.shear = dot(joint.force, along);
  joint.eccentricity = nan;
  joint.place = {nan, nan};
  measure(joint, points, facets.empty() ? std::vector<Side>{whole} : sides_of(points, facets));
  if (!(joint.normal_force > 0)) return joint;
  joint.eccentricity = -moment / joint.normal_force;  // along x normal = -1
  joint.place = joint.middle + joint.eccentricity * along;
  return joint;
}

}  // namespace voussoir

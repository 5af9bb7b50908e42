#include "joints/joint_side.hpp"

#include <algorithm>
#include <cmath>

namespace voussoir {
namespace {

using Points = std::vector<PointOfJoint<2>>;
const PointOfJoint<2>& at(const Points& points, int k) { return points[static_cast<std::size_t>(k)]; }

}  // namespace

JointSide whole_side(const Points& points, const Vector<2>& along) {
  JointSide side;
  for (std::size_t k = 0; k < points.size(); ++k) side.points.push_back(static_cast<int>(k));
  std::stable_sort(side.points.begin(), side.points.end(), [&](int a, int b) {
    return dot(at(points, a).position, along) < dot(at(points, b).position, along);
  });
  return side;
}

std::vector<JointSide> sides_of(const Points& points, const std::vector<FacetOfJoint<2>>& facets) {
  std::vector<std::vector<int>> next_to(points.size());
  for (const auto& [a, b] : facets) {
    next_to[static_cast<std::size_t>(a)].push_back(b);
    next_to[static_cast<std::size_t>(b)].push_back(a);
  }
  std::vector<char> seen(points.size(), 0);
  std::vector<JointSide> sides;
  const auto walk = [&](int from, bool closed) {
    JointSide side{{}, closed};
    for (int k = from; k >= 0;) {
      seen[static_cast<std::size_t>(k)] = 1;
      side.points.push_back(k);
      const auto& others = next_to[static_cast<std::size_t>(k)];
      const auto on =
          std::find_if(others.begin(), others.end(), [&](int p) { return !seen[static_cast<std::size_t>(p)]; });
      k = on == others.end() ? -1 : *on;
    }
    const auto &first = at(points, side.points.front()), &last = at(points, side.points.back());
    const Vector<2> tangent{-first.normal[1], first.normal[0]};
    if (!closed && dot(last.position - first.position, tangent) < 0)
      std::reverse(side.points.begin(), side.points.end());
    sides.push_back(std::move(side));
  };
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!seen[k] && next_to[k].size() < 2) walk(static_cast<int>(k), false);
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!seen[k]) walk(static_cast<int>(k), true);
  return sides;
}

// The place of the pressure along the side, the sum of the shear forces along it.
SideStatics<2> side_statics(const Points& points, const JointSide& side) {
  SideStatics<2> s;
  double moment = 0, shear = 0, bound = 0, length = 0;
  bool pulls = false;
  const PointOfJoint<2>* before = nullptr;
  for (const int k : side.points) {
    const auto& p = at(points, k);
    if (before) length += norm(p.position - before->position);
    before = &p;
    s.pressing += p.normal_force;
    moment += length * p.normal_force;
    shear += p.shear;
    bound += friction_bound(p.law, p.normal_force);
    pulls = pulls || p.law.tension > 0;
    s.holds = s.holds || pulls || p.law.cohesion > 0;
  }
  s.middle = 0.5 * (at(points, side.points.front()).position + at(points, side.points.back()).position);
  if (bound > 0) s.friction_margin = std::max(0.0, 1 - std::abs(shear) / bound);
  if (!(s.pressing > 0) || !(length > 0) || side.closed) return s;
  const double place = moment / s.pressing;
  s.edge_margin = std::min(place, length - place) / length;
  if (!pulls) s.edge_margin = std::max(0.0, s.edge_margin);
  int near = side.points.front(), far = side.points.back();
  if (2 * place > length) std::swap(near, far);
  s.edge = at(points, near).position;
  s.hinge =
      s.edge_margin < at_the_edge && at(points, far).gap > open_share * length && at(points, near).normal_force > 0;
  return s;
}

}  // namespace voussoir

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/convex_hull.hpp"
#include "joints/friction_of_patch.hpp"
#include "joints/joint_side.hpp"

namespace voussoir {
namespace {

using PointsInSpace = std::vector<PointOfJoint<3>>;
const PointOfJoint<3>& at(const PointsInSpace& points, int k) { return points[static_cast<std::size_t>(k)]; }

// Of the extent of a side: what its points may be beside a line between others.
constexpr double round_off_of_places = 1e-9;
// A side some of whose points look away from its mean by more than 60 degrees runs round: no plane is near it.
constexpr double looks_along = 0.5;

/// The turn that brings one unit vector onto another by the shortest way, of a vector.
Vector<3> turned_with(const Vector<3>& from, const Vector<3>& to, const Vector<3>& v) {
  const auto axis = cross(from, to);
  const auto once = cross(axis, v);
  return v + once + (1 / (1 + dot(from, to))) * cross(axis, once);
}

/// The mean plane of a side.
struct MeanPlane {
  Vector<3> middle{}, normal{}, along{}, across{};
  bool near = false;  ///< the side lies along it

  MeanPlane(const PointsInSpace& points, const JointSide& side) {
    double area = 0;
    for (const int k : side.points) {
      const auto& p = at(points, k);
      area += p.area;
      middle = middle + p.area * p.position;
      normal = normal + p.area * p.normal;
    }
    middle = (1 / area) * middle;
    if (!(norm(normal) > 0)) return;
    normal = (1 / norm(normal)) * normal;
    near = std::all_of(side.points.begin(), side.points.end(),
                       [&](int k) { return dot(at(points, k).normal, normal) > looks_along; });
    Vector<3> axis{};
    axis[static_cast<std::size_t>(
        std::min_element(normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
        normal.begin())] = 1;
    along = cross(axis, normal);
    along = (1 / norm(along)) * along;
    across = cross(normal, along);
  }
  Vector<2> vector(const Vector<3>& v) const { return {dot(v, along), dot(v, across)}; }
  Vector<2> place(const Vector<3>& x) const { return vector(x - middle); }
  Vector<3> in_space(const Vector<2>& x) const { return middle + x[0] * along + x[1] * across; }
};

/// How a pressure lies to the edges of what can press.
struct NearestEdge {
  double margin = SideStatics<3>::nan;  ///< [-] distance over the width across the edge
  double width = 0;                     ///< [m]
  Vector<2> from{}, inward{}, nearest{};

  double away(const Vector<2>& x) const { return dot(x - from, inward); }
};

/// Compression acts within the convex hull of where points are, whatever the shape of the joint.
NearestEdge nearest_edge(const std::vector<Vector<2>>& places, const Vector<2>& pressure) {
  double extent = 0;
  for (const auto& x : places) extent = std::max(extent, norm(x - places.front()));
  NearestEdge found;
  const auto hull = convex_hull(places, round_off_of_places * extent);
  if (hull.size() < 3) return found;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const auto a = places[static_cast<std::size_t>(hull[k])],
               b = places[static_cast<std::size_t>(hull[(k + 1) % hull.size()])];
    const double length = norm(b - a);
    NearestEdge edge;
    edge.from = a;
    edge.inward = (1 / length) * Vector<2>{a[1] - b[1], b[0] - a[0]};
    for (const int corner : hull)
      edge.width = std::max(edge.width, edge.away(places[static_cast<std::size_t>(corner)]));
    edge.margin = edge.away(pressure) / edge.width;
    if (edge.margin >= found.margin) continue;
    const double foot = dot(pressure - a, b - a) / (length * length);
    edge.nearest = a + std::clamp(foot, 0.0, 1.0) * (b - a);
    found = edge;
  }
  return found;
}

/// Whether a side is open all along the far end of its width, and presses at the edge.
bool turns_about(const PointsInSpace& points, const JointSide& side, const std::vector<Vector<2>>& places,
                 const NearestEdge& edge) {
  double opening = 0;
  bool presses = false;
  for (std::size_t n = 0; n < places.size(); ++n) {
    const auto& p = at(points, side.points[n]);
    const double away = edge.away(places[n]);
    if (away > (1 - round_off_of_places) * edge.width) opening = std::max(opening, p.gap);
    presses |= away < round_off_of_places * edge.width && p.normal_force > 0;
  }
  return presses && opening > open_share * edge.width;
}

}  // namespace

JointSide whole_side(const PointsInSpace& points, const Vector<3>&) {
  JointSide side;
  side.points.resize(points.size());
  std::iota(side.points.begin(), side.points.end(), 0);
  return side;
}

std::vector<JointSide> sides_of(const PointsInSpace& points, const std::vector<FacetOfJoint<3>>& facets) {
  std::vector<int> group(points.size());
  std::iota(group.begin(), group.end(), 0);
  const auto first_of = [&](int k) {
    while (group[static_cast<std::size_t>(k)] != k) k = group[static_cast<std::size_t>(k)];
    return k;
  };
  for (const auto& facet : facets)
    for (const int k : facet) {
      const int a = first_of(k), b = first_of(facet[0]);
      group[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  std::vector<JointSide> sides;
  std::vector<int> side_of(points.size(), -1);
  for (int k = 0; k < static_cast<int>(points.size()); ++k) {
    auto& side = side_of[static_cast<std::size_t>(first_of(k))];
    if (side < 0) side = static_cast<int>(sides.size()), sides.emplace_back();
    sides[static_cast<std::size_t>(side)].points.push_back(k);
  }
  return sides;
}

// Laid onto its mean plane: places along the normal of that, shear turned with the normal of its point.
SideStatics<3> side_statics(const PointsInSpace& points, const JointSide& side) {
  SideStatics<3> s;
  const MeanPlane plane(points, side);
  s.middle = plane.middle;
  std::vector<Vector<2>> places;
  std::vector<RubbingPlace> rubbing;
  Vector<2> moment{};
  double rubbed = 0, bound = 0;
  bool pulls = false;
  for (const int k : side.points) {
    const auto& p = at(points, k);
    s.pressing += p.normal_force;
    pulls = pulls || p.law.tension > 0;
    s.holds = s.holds || pulls || p.law.cohesion > 0;
    rubbed += norm(p.shear);
    bound += friction_bound(p.law, p.normal_force);
    if (!plane.near) continue;
    places.push_back(plane.place(p.position));
    moment = moment + p.normal_force * places.back();
    rubbing.push_back({places.back(), plane.vector(turned_with(p.normal, plane.normal, p.shear)),
                       friction_bound(p.law, p.normal_force)});
  }
  if (bound > 0) s.friction_margin = std::max(0.0, 1 - (plane.near ? friction_used(rubbing) : rubbed / bound));
  if (!plane.near || !(s.pressing > 0)) return s;
  const auto edge = nearest_edge(places, (1 / s.pressing) * moment);
  if (std::isnan(edge.margin)) return s;
  s.edge_margin = pulls ? edge.margin : std::max(0.0, edge.margin);
  s.edge = plane.in_space(edge.nearest);
  s.hinge = s.edge_margin < at_the_edge && turns_about(points, side, places, edge);
  return s;
}

}  // namespace voussoir

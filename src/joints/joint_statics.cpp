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

Vector<2> turned(const Vector<2>& n) { return {-n[1], n[0]}; }

}  // namespace

JointStatics joint_statics(const std::vector<PointOfJoint>& points) {
  VOUSSOIR_EXPECT(!points.empty());
  Vector<2> normal{};
  for (const auto& p : points) normal = normal + p.normal;
  normal = norm(normal) > 1e-6 ? (1 / norm(normal)) * normal : points.front().normal;
  const auto along = turned(normal);
  const auto before = [&](const PointOfJoint& a, const PointOfJoint& b) {
    return dot(a.position, along) < dot(b.position, along);
  };
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), before);

  JointStatics joint;
  joint.length = dot(high->position - low->position, along);
  joint.middle = 0.5 * (low->position + high->position);
  double moment = 0, bound = 0;
  for (const auto& p : points) {
    const auto force = p.normal_force * p.normal + p.shear * turned(p.normal);
    joint.force = joint.force + force;
    moment += cross(p.position - joint.middle, force);
    bound += friction_bound(p.law, p.normal_force);
    joint.opening = std::max(joint.opening, p.gap);
  }
  joint.normal_force = dot(joint.force, normal);
  joint.shear = dot(joint.force, along);
  joint.friction_margin = bound > 0 ? 1 - std::abs(joint.shear) / bound : nan;
  joint.eccentricity = joint.edge_margin = nan;
  joint.place = {nan, nan};
  if (!(joint.normal_force > 0)) return joint;
  joint.slides = joint.friction_margin < at_the_cone;
  joint.eccentricity = -moment / joint.normal_force;  // along x normal = -1
  joint.place = joint.middle + joint.eccentricity * along;
  if (!(joint.length > 0)) return joint;
  joint.edge_margin = 0.5 - std::abs(joint.eccentricity) / joint.length;
  const auto& far = joint.eccentricity > 0 ? *low : *high;
  const auto& near = joint.eccentricity > 0 ? *high : *low;
  joint.hinge = joint.edge_margin < at_the_edge && far.gap > open_share * joint.length && near.normal_force > 0;
  return joint;
}

}  // namespace voussoir

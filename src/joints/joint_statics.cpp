#include "joints/joint_statics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "base/plane_and_space.hpp"
#include "joints/joint_side.hpp"

namespace voussoir {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// Forces are known to the tolerance of the solver, relative to the largest of the structure: a small joint's to less.
constexpr double at_the_cone = 1e-3;
// A side that bears less than this share of what presses on its joint says nothing.
constexpr double negligible = 1e-6;

Vector<2> turned(const Vector<2>& n) { return {-n[1], n[0]}; }

template <int dim>
Vector<dim> nowhere() {
  Vector<dim> x;
  x.fill(nan);
  return x;
}

Vector<2> force_of(const PointOfJoint<2>& p) { return p.normal_force * p.normal + p.shear * turned(p.normal); }
Vector<3> force_of(const PointOfJoint<3>& p) { return p.normal_force * p.normal + p.shear; }

/// Length and middle of the chord of a joint of the plane; area and middle of one in space.
void find_extent(const std::vector<PointOfJoint<2>>& points, const JointSide& whole, const Vector<2>& along,
                 JointStatics<2>& joint) {
  const auto& low = points[static_cast<std::size_t>(whole.points.front())];
  const auto& high = points[static_cast<std::size_t>(whole.points.back())];
  joint.extent = dot(high.position - low.position, along);
  joint.middle = 0.5 * (low.position + high.position);
}

void find_extent(const std::vector<PointOfJoint<3>>& points, const JointSide&, const Vector<3>&,
                 JointStatics<3>& joint) {
  for (const auto& p : points) joint.extent += p.area;
  for (const auto& p : points) joint.middle = joint.middle + (p.area / joint.extent) * p.position;
}

/// The least margins of the sides that are pressed.
template <int dim>
void measure(JointStatics<dim>& joint, const std::vector<PointOfJoint<dim>>& points,
             const std::vector<JointSide>& sides) {
  joint.edge_margin = joint.friction_margin = nan;
  joint.edge = joint.least_shear = nowhere<dim>();
  joint.sides = static_cast<int>(sides.size());
  int pressed = 0, hinges = 0, sliding = 0;
  for (const auto& side : sides) {
    const auto s = side_statics(points, side);
    const bool presses = s.pressing > 0 && s.pressing >= negligible * joint.pressing;
    if (!presses && !s.holds) continue;
    pressed += presses;
    hinges += s.hinge;
    sliding += presses && s.friction_margin < at_the_cone;
    if (!std::isnan(s.edge_margin) && !(s.edge_margin >= joint.edge_margin)) {
      joint.edge_margin = s.edge_margin;
      joint.edge = s.edge;
    }
    if (!std::isnan(s.friction_margin) && !(s.friction_margin >= joint.friction_margin)) {
      joint.friction_margin = s.friction_margin;
      joint.least_shear = s.middle;
    }
  }
  joint.hinge = pressed == 1 && hinges == 1;
  joint.slides = joint.pressing > 0 && pressed > 0 && sliding == pressed;
}

/// Where a resultant crosses a joint, and what remains of it there.
template <int dim>
void find_place(JointStatics<dim>& joint, const Vector<dim>& normal, const Vector<3>& moment) {
  joint.eccentricity = nan;
  joint.place = nowhere<dim>();
  if constexpr (dim == 3) joint.twist = dot(moment, normal);
  if (!(joint.normal_force > 0)) return;
  const auto arm = (1 / joint.normal_force) * cross(in_space(normal), moment);
  joint.place = joint.middle + in_dimension<dim>(arm);
  if constexpr (dim == 2) {
    joint.eccentricity = dot(in_plane(arm), turned(normal));
  } else {
    joint.eccentricity = norm(arm);
    joint.twist = dot(moment - cross(arm, joint.force), normal);
  }
}

}  // namespace

template <int dim>
JointStatics<dim> joint_statics(const std::vector<PointOfJoint<dim>>& points,
                                const std::vector<FacetOfJoint<dim>>& facets) {
  VOUSSOIR_EXPECT(!points.empty());
  Vector<dim> normal{};
  for (const auto& p : points) normal = normal + p.normal;
  normal = norm(normal) > 1e-6 ? (1 / norm(normal)) * normal : points.front().normal;
  auto along = normal;
  if constexpr (dim == 2) along = turned(normal);
  const auto whole = whole_side(points, along);

  JointStatics<dim> joint;
  find_extent(points, whole, along, joint);
  Vector<3> moment{};
  for (const auto& p : points) {
    const auto force = force_of(p);
    joint.force = joint.force + force;
    joint.pressing += p.normal_force;
    moment = moment + cross(in_space(p.position - joint.middle), in_space(force));
    joint.opening = std::max(joint.opening, p.gap);
  }
  joint.normal_force = dot(joint.force, normal);
  if constexpr (dim == 2)
    joint.shear = dot(joint.force, along);
  else
    joint.shear = norm(joint.force - joint.normal_force * normal);
  measure(joint, points, facets.empty() ? std::vector<JointSide>{whole} : sides_of(points, facets));
  find_place(joint, normal, moment);
  return joint;
}

template JointStatics<2> joint_statics(const std::vector<PointOfJoint<2>>&, const std::vector<FacetOfJoint<2>>&);
template JointStatics<3> joint_statics(const std::vector<PointOfJoint<3>>&, const std::vector<FacetOfJoint<3>>&);

}  // namespace voussoir

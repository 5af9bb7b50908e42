// A structure as limit analysis sees it: stones that do not deform, the points at which they may press and rub on each
// other, and what holds them.
//
// In the plane or in space; forces in [N], moments about the middle of a stone in [N m], lengths in [m].
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/tensor.hpp"
#include "joints/contact_law.hpp"
#include "statics/limit_analysis_parameters.hpp"

namespace voussoir {

/// Of a stone that does not deform: as many velocities as there are directions, and the turns.
template <int dim>
constexpr std::size_t freedoms = dim == 2 ? 3 : 6;

/// A force and a moment about the middle of a stone; of a motion: velocities and turns. Turns come last.
template <int dim>
using Wrench = std::array<double, freedoms<dim>>;

template <int dim>
struct RigidStone {
  Vector<dim> middle{};
  double radius = 1;     ///< [m] of the node farthest from the middle
  Wrench<dim> fixed{};   ///< loads that stay as they are
  Wrench<dim> raised{};  ///< loads that are multiplied by the load factor
};

template <int dim>
struct RigidContact {
  int stone_i = 0, stone_j = 0;
  Vector<dim> arm_i{}, arm_j{};         ///< [m] from the middles of the stones to the point
  std::array<Vector<dim>, dim> axis{};  ///< normal from i to j, tangents
  PointLaw law;
  int joint = 0;  ///< points of one joint have one number
};

/// A component of motion of a node that is held.
template <int dim>
struct RigidSupport {
  int stone = 0;
  Vector<dim> arm{};
  Vector<dim> direction{};
  int name = 0;  ///< number of the support it belongs to
};

template <int dim>
struct RigidStructure {
  std::vector<RigidStone<dim>> stones;
  std::vector<RigidContact<dim>> contacts;
  std::vector<RigidSupport<dim>> supports;
  /// What others of the supports hold at its place too: reactions alone ask.
  std::vector<RigidSupport<dim>> held_again;
};

inline double length(const Vector<1>& v) { return std::abs(v[0]); }
inline double length(const Vector<2>& v) { return std::hypot(v[0], v[1]); }
inline double length(const Vector<3>& v) { return std::hypot(v[0], v[1], v[2]); }

/// The force of a wrench, or the velocity of the middle.
inline Vector<2> force_of(const Wrench<2>& w) { return {w[0], w[1]}; }
inline Vector<3> force_of(const Wrench<3>& w) { return {w[0], w[1], w[2]}; }
/// The moment of a wrench, or the turn.
inline Vector<1> moment_of(const Wrench<2>& w) { return {w[2]}; }
inline Vector<3> moment_of(const Wrench<3>& w) { return {w[3], w[4], w[5]}; }

/// Force and moment of a force at a place of a stone.
inline Wrench<2> wrench_of(const Vector<2>& arm, const Vector<2>& force) {
  return {force[0], force[1], cross(arm, force)};
}
inline Wrench<3> wrench_of(const Vector<3>& arm, const Vector<3>& force) {
  const auto moment = cross(arm, force);
  return {force[0], force[1], force[2], moment[0], moment[1], moment[2]};
}

/// Velocity of a place of a stone.
inline Vector<2> velocity_at(const Wrench<2>& motion, const Vector<2>& arm) {
  return {motion[0] - motion[2] * arm[1], motion[1] + motion[2] * arm[0]};
}
inline Vector<3> velocity_at(const Wrench<3>& motion, const Vector<3>& arm) {
  return force_of(motion) + cross(moment_of(motion), arm);
}

/// What forces on a stone come to, about its middle.
template <int dim>
class Resultant {
 public:
  void add(const Vector<dim>& arm, const Vector<dim>& force) {
    sum_ = sum_ + wrench_of(arm, force);
    size_ += length(force);
  }
  /// Nothing where they cancel but for round-off.
  Wrench<dim> wrench(double radius) const {
    const double nothing = LimitAnalysisParameters::no_resultant * size_;
    const bool cancel = length(force_of(sum_)) <= nothing && length(moment_of(sum_)) <= nothing * radius;
    return cancel ? Wrench<dim>{} : sum_;
  }

 private:
  Wrench<dim> sum_{};
  double size_ = 0;
};

/// Of a force and a moment on a stone of a radius: the larger of the force and of what turns it at its edge.
template <std::size_t n>
double size_of(const std::array<double, n>& w, double radius) {
  return std::max(length(force_of(w)), length(moment_of(w)) / radius);
}

/// How far a motion moves a stone of a radius at most.
template <std::size_t n>
double reach_of(const std::array<double, n>& motion, double radius) {
  return length(force_of(motion)) + length(moment_of(motion)) * radius;
}

/// Along the axes of a contact.
template <int dim>
Vector<dim> on_axes(const RigidContact<dim>& c, const Vector<dim>& v) {
  Vector<dim> components{};
  for (std::size_t a = 0; a < dim; ++a) components[a] = dot(v, c.axis[a]);
  return components;
}

/// Of components along the axes of a contact.
template <int dim>
Vector<dim> off_axes(const RigidContact<dim>& c, const Vector<dim>& components) {
  Vector<dim> v = components[0] * c.axis[0];
  for (std::size_t a = 1; a < dim; ++a) v = v + components[a] * c.axis[a];
  return v;
}

/// The tangential part of components along the axes of a contact.
inline Vector<1> tangential(const Vector<2>& on_axes) { return {on_axes[1]}; }
inline Vector<2> tangential(const Vector<3>& on_axes) { return {on_axes[1], on_axes[2]}; }

/// Opening and slip at a point while its stones move [m/s].
template <int dim>
Vector<dim> relative_velocity(const RigidContact<dim>& c, const std::vector<Wrench<dim>>& motion) {
  return on_axes(c, velocity_at(motion[static_cast<std::size_t>(c.stone_j)], c.arm_j) -
                        velocity_at(motion[static_cast<std::size_t>(c.stone_i)], c.arm_i));
}

}  // namespace voussoir

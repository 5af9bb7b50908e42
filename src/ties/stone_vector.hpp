// Motions of a stone as a rigid body, and what resists them: as many numbers as it has ways to move.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/plane_and_space.hpp"

namespace voussoir {

constexpr int ways_of_stone(int dim) { return dim * (dim + 1) / 2; }

/// Displacements [m] and turns [rad] about its middle, or force [N] and moment [N m]: one turn in the plane, three in
/// space.
template <int dim>
using StoneVector = Vector<ways_of_stone(dim)>;

/// Of a force and moment: the force, or the moment over the radius of the stone [N].
inline double size_of(const Vector<3>& v, double radius) {
  return std::max(std::hypot(v[0], v[1]), std::abs(v[2]) / radius);
}
inline double size_of(const Vector<6>& v, double radius) {
  return std::max(std::hypot(v[0], v[1], v[2]), std::hypot(v[3], v[4], v[5]) / radius);
}

/// A force with its moment.
inline Vector<3> wrench(const Vector<2>& arm, const Vector<2>& f) { return {f[0], f[1], cross(arm, f)}; }
inline Vector<6> wrench(const Vector<3>& arm, const Vector<3>& f) {
  const auto m = cross(arm, f);
  return {f[0], f[1], f[2], m[0], m[1], m[2]};
}

/// How a place of a stone moves with it.
inline Vector<2> motion_at(const Vector<2>& arm, const Vector<3>& d) {
  return {d[0] - d[2] * arm[1], d[1] + d[2] * arm[0]};
}
inline Vector<3> motion_at(const Vector<3>& arm, const Vector<6>& d) {
  return Vector<3>{d[0], d[1], d[2]} + cross(Vector<3>{d[3], d[4], d[5]}, arm);
}

/// Moved from the middle of a stone to another point.
inline Vector<3> about(const Vector<3>& v, const Vector<2>& from, const Vector<2>& to) {
  return {v[0], v[1], v[2] + cross(from - to, Vector<2>{v[0], v[1]})};
}
inline Vector<6> about(const Vector<6>& v, const Vector<3>& from, const Vector<3>& to) {
  const auto m = cross(from - to, Vector<3>{v[0], v[1], v[2]});
  return {v[0], v[1], v[2], v[3] + m[0], v[4] + m[1], v[5] + m[2]};
}

}  // namespace voussoir

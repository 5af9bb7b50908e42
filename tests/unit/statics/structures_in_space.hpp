// Rigid structures in space of boxes and of hexahedra with plane faces: walls with returns, domes, what is held.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "statics/limit_analysis.hpp"

namespace voussoir::test {

using Corners = std::vector<Vector<3>>;

/// A stone by the eight corners of a hexahedron, lower face first, with weight per volume 1; its number.
inline int add_hexahedron(RigidStructure<3>& s, const std::array<Vector<3>, 8>& x) {
  Vector<3> inside{};
  for (const auto& p : x) inside = inside + 0.125 * p;
  constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  double volume = 0;
  Vector<3> first{};
  for (const auto& f : faces)
    for (const auto& [b, c] : {std::make_pair(1, 2), std::make_pair(2, 3)}) {
      const auto p = x[f[0]] - inside, q = x[f[b]] - inside, r = x[f[c]] - inside;
      const double part = dot(p, cross(q, r)) / 6;
      volume += part;
      first = first + (part / 4) * (p + q + r);
    }
  RigidStone<3> stone;
  stone.middle = inside + (1 / volume) * first;
  stone.radius = 0;
  for (const auto& p : x) stone.radius = std::max(stone.radius, norm(p - stone.middle));
  stone.fixed = {0, 0, -volume, 0, 0, 0};
  s.stones.push_back(stone);
  return static_cast<int>(s.stones.size()) - 1;
}

inline int add_box(RigidStructure<3>& s, const Vector<3>& low, const Vector<3>& high) {
  const auto at = [&](int x, int y, int z) {
    return Vector<3>{x ? high[0] : low[0], y ? high[1] : low[1], z ? high[2] : low[2]};
  };
  return add_hexahedron(
      s, {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
}

/// A joint with points at places in a plane, whose normal points from i to j.
inline void add_joint(RigidStructure<3>& s, int i, int j, const Corners& places, Vector<3> normal,
                      const PointLaw& law) {
  normal = (1 / norm(normal)) * normal;
  Vector<3> across{};
  across[std::abs(normal[0]) < 0.9 ? 0 : 1] = 1;  // an axis that is not along the normal
  across = across - dot(across, normal) * normal;
  across = (1 / norm(across)) * across;
  const int joint = s.contacts.empty() ? 0 : s.contacts.back().joint + 1;
  for (const auto& x : places) {
    RigidContact<3> c;
    c.stone_i = i, c.stone_j = j;
    c.arm_i = x - s.stones[static_cast<std::size_t>(i)].middle;
    c.arm_j = x - s.stones[static_cast<std::size_t>(j)].middle;
    c.axis = {normal, across, cross(normal, across)};
    c.law = law;
    c.joint = joint;
    s.contacts.push_back(c);
  }
}

/// Holds all components of three places of a stone.
inline void hold(RigidStructure<3>& s, int stone, int name = 0) {
  const double r = s.stones[static_cast<std::size_t>(stone)].radius;
  for (const auto& arm : {Vector<3>{r, 0, 0}, Vector<3>{0, r, 0}, Vector<3>{0, 0, r}})
    for (std::size_t c = 0; c < 3; ++c) {
      Vector<3> direction{};
      direction[c] = 1;
      s.supports.push_back({stone, arm, direction, name});
    }
}

/// Raises the weights of stones, turned to a direction.
inline void push_to(RigidStructure<3>& s, const Vector<3>& direction) {
  for (auto& stone : s.stones) {
    const auto f = -stone.fixed[2] * direction;
    stone.raised = {f[0], f[1], f[2], 0, 0, 0};
  }
}

/// A prism of 1 x 0.6 x 2 m on a held bed, pushed at an angle from x by a share of its weight.
inline RigidStructure<3> prism(double degrees, const PointLaw& law, int points_a_side = 2) {
  RigidStructure<3> s;
  const int bed = add_box(s, {0, 0, -1}, {1, 0.6, 0}), stone = add_box(s, {0, 0, 0}, {1, 0.6, 2});
  Corners places;
  const int cells = points_a_side - 1;
  for (int i = 0; i <= cells; ++i)
    for (int k = 0; k <= cells; ++k) places.push_back({1.0 * i / cells, 0.6 * k / cells, 0});
  add_joint(s, bed, stone, places, {0, 0, 1}, law);
  hold(s, bed);
  const double angle = degrees / 180 * 3.14159265358979323846;
  push_to(s, {std::cos(angle), std::sin(angle), 0});
  return s;
}

/// A box in units of half a stone, 0.2 m.
struct Cuboid {
  std::array<int, 3> low, high;
};

/// Where two boxes touch: on faces across an axis, j above i. Nothing where they do not.
inline Corners face_between(const Cuboid& i, const Cuboid& j, std::size_t axis) {
  if (i.high[axis] != j.low[axis]) return {};
  const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
  const int a0 = std::max(i.low[a], j.low[a]), a1 = std::min(i.high[a], j.high[a]);
  const int b0 = std::max(i.low[b], j.low[b]), b1 = std::min(i.high[b], j.high[b]);
  if (a0 >= a1 || b0 >= b1) return {};
  Corners places;
  for (const auto& [p, q] : {std::make_pair(a0, b0), {a1, b0}, {a1, b1}, {a0, b1}}) {
    Vector<3> x{};
    x[axis] = 0.2 * i.high[axis], x[a] = 0.2 * p, x[b] = 0.2 * q;
    places.push_back(x);
  }
  return places;
}

/// Dry stones of 0.4 x 0.2 x 0.2 m in running bond on held ground: a facade of stones along x in y from 0 to 0.2, and
/// none, one or two returns of three stones behind it. The facade has the corners of even courses.
inline RigidStructure<3> dry_wall(int along, int courses, int returns, double friction) {
  std::vector<Cuboid> boxes;
  const int lx = 2 * along, ly = 6;
  boxes.push_back({{-1, -1, -1}, {lx + 1, ly + 1, 0}});
  for (int k = 0; k < courses; ++k) {
    const bool even = k % 2 == 0;
    const auto box = [&](int x0, int x1, int y0, int y1) { boxes.push_back({{x0, y0, k}, {x1, y1, k + 1}}); };
    const int end = even || returns < 2 ? lx : lx - 1;
    if (returns == 0 && !even) box(0, 1, 0, 1);
    for (int x = even ? 0 : 1; x < end; x += 2) box(x, std::min(x + 2, end), 0, 1);
    for (int side = 0; side < returns; ++side) {
      const int x0 = side == 0 ? 0 : lx - 1;
      for (int y = even ? 1 : 0; y < ly; y += 2) box(x0, x0 + 1, y, std::min(y + 2, ly));
    }
  }
  RigidStructure<3> s;
  const auto place = [](const std::array<int, 3>& x) { return Vector<3>{0.2 * x[0], 0.2 * x[1], 0.2 * x[2]}; };
  for (const auto& b : boxes) add_box(s, place(b.low), place(b.high));
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < boxes.size(); ++j)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto places = i == j ? Corners{} : face_between(boxes[i], boxes[j], axis);
        Vector<3> normal{};
        normal[axis] = 1;
        if (!places.empty()) add_joint(s, static_cast<int>(i), static_cast<int>(j), places, normal, {friction});
      }
  hold(s, 0);
  return s;
}

/// Half a sphere of radius 1 about the middle of its thickness, with an eye: stones with plane faces between angles
/// from the zenith, on held ones below.
inline RigidStructure<3> dome(int lunes, int courses, double thickness, double top, double friction) {
  RigidStructure<3> s;
  const double quarter = 3.14159265358979323846 / 2, step = (quarter - top) / courses;
  const auto at = [&](int side, int course, int lune) {  // inside 0, outside 1; courses from the springing
    const double r = 1 + (side - 0.5) * thickness, p = quarter - step * course, a = 4 * quarter * lune / lunes;
    return Vector<3>{r * std::sin(p) * std::cos(a), r * std::sin(p) * std::sin(a), r * std::cos(p)};
  };
  const auto number = [&](int k, int j) { return (k + 1) * lunes + (j + lunes) % lunes; };
  for (int k = -1; k < courses; ++k)
    for (int j = 0; j < lunes; ++j)
      add_hexahedron(s, {at(0, k, j), at(1, k, j), at(1, k, j + 1), at(0, k, j + 1), at(0, k + 1, j), at(1, k + 1, j),
                         at(1, k + 1, j + 1), at(0, k + 1, j + 1)});
  for (int j = 0; j < lunes; ++j) hold(s, number(-1, j));
  const auto face = [&](int i, int j, const Corners& x) {
    add_joint(s, i, j, x, cross(x[1] - x[0], x[2] - x[0]), {friction});
    auto& c = s.contacts;
    const auto between = s.stones[static_cast<std::size_t>(j)].middle - s.stones[static_cast<std::size_t>(i)].middle;
    if (dot(c.back().axis[0], between) > 0) return;
    c.resize(c.size() - x.size());
    add_joint(s, i, j, x, cross(x[2] - x[0], x[1] - x[0]), {friction});
  };
  for (int k = 0; k < courses; ++k)
    for (int j = 0; j < lunes; ++j) {
      face(number(k - 1, j), number(k, j), {at(0, k, j), at(1, k, j), at(1, k, j + 1), at(0, k, j + 1)});
      face(number(k, j - 1), number(k, j), {at(0, k, j), at(1, k, j), at(1, k + 1, j), at(0, k + 1, j)});
    }
  return s;
}

}  // namespace voussoir::test

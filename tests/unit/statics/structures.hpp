// Rigid structures drawn by hand: stones, joints between two ends, what is held.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "statics/limit_analysis.hpp"

namespace voussoir::test {

constexpr double pi = 3.14159265358979323846;

/// A stone of a weight; its number.
inline int add_stone(RigidStructure<2>& s, const Vector<2>& middle, double radius, double weight) {
  s.stones.push_back({middle, radius, {0, -weight, 0}, {}});
  return static_cast<int>(s.stones.size()) - 1;
}

/// A rectangle; its number.
inline int add_box(RigidStructure<2>& s, const Vector<2>& corner, double width, double height, double weight) {
  return add_stone(s, {corner[0] + width / 2, corner[1] + height / 2}, std::hypot(width, height) / 2, weight);
}

/// A joint with a point at each end; stone j lies to the left of the way from a to b.
inline void add_joint(RigidStructure<2>& s, int i, int j, const Vector<2>& a, const Vector<2>& b, const PointLaw& law) {
  const Vector<2> along = (1 / norm(b - a)) * (b - a);
  const int joint = s.contacts.empty() ? 0 : s.contacts.back().joint + 1;
  for (const auto& x : {a, b}) {
    RigidContact<2> c;
    c.stone_i = i, c.stone_j = j;
    c.arm_i = x - s.stones[static_cast<std::size_t>(i)].middle;
    c.arm_j = x - s.stones[static_cast<std::size_t>(j)].middle;
    c.axis = {Vector<2>{-along[1], along[0]}, along};
    c.law = law;
    c.joint = joint;
    s.contacts.push_back(c);
  }
}

/// Holds both components of two places of a stone.
inline void hold(RigidStructure<2>& s, int stone, int name = 0) {
  for (const double x : {-1.0, 1.0})
    for (const auto& direction : {Vector<2>{1, 0}, Vector<2>{0, 1}})
      s.supports.push_back({stone, {x * s.stones[static_cast<std::size_t>(stone)].radius, 0}, direction, name});
}

/// Raises the weights of stones, turned to the right.
inline void push_sideways(RigidStructure<2>& s) {
  for (auto& stone : s.stones) stone.raised = {-stone.fixed[1], 0, 0};
}

/// A box on a held bed, pushed sideways by a share of its weight.
inline RigidStructure<2> box_on_bed(double width, double height, const PointLaw& law, double weight = 1) {
  RigidStructure<2> s;
  const int bed = add_box(s, {0, -1}, width, 1, 0), box = add_box(s, {0, 0}, width, height, weight);
  hold(s, bed);
  add_joint(s, bed, box, {0, 0}, {width, 0}, law);
  push_sideways(s);
  return s;
}

/// Equal voussoirs between two held abutments, pushed sideways by a share of their weight.
inline RigidStructure<2> ring(int voussoirs, double radius, double thickness, double embrace, const PointLaw& law) {
  RigidStructure<2> s;
  const double inner = radius - thickness / 2, outer = radius + thickness / 2, wedge = embrace / voussoirs;
  const double area = wedge * (outer * outer - inner * inner) / 2;
  const double centre = 2.0 / 3 * (std::pow(outer, 3) - std::pow(inner, 3)) / (outer * outer - inner * inner) *
                        std::sin(wedge / 2) / (wedge / 2);
  const auto at = [&](double rho, double k) {  // from left to right
    const double angle = embrace * (k / voussoirs - 0.5);
    return Vector<2>{rho * std::sin(angle), rho * std::cos(angle)};
  };
  for (int k = -1; k <= voussoirs; ++k) {
    const bool abutment = k < 0 || k == voussoirs;
    const int stone = add_stone(s, at(centre, k + 0.5), norm(at(outer, 0) - at(centre, 0.5)), abutment ? 0 : area);
    if (abutment) hold(s, stone, k < 0 ? 0 : 1);
    if (k >= 0) add_joint(s, stone - 1, stone, at(outer, k), at(inner, k), law);
  }
  push_sideways(s);
  return s;
}

/// Courses of stones of 0.4 x 0.175 m on a held base, from below; widths in half stones, openings negative. The same
/// as the walls of Ferris and Tin-Loi.
inline RigidStructure<2> wall(const std::vector<std::vector<int>>& courses, double friction) {
  struct Placed {
    int stone, row;
    double left, right;
  };
  const double half = 0.2, height = 0.175;
  RigidStructure<2> s;
  double width = 0;
  for (const int w : courses.front()) width += half * std::abs(w);
  hold(s, add_box(s, {0, -height}, width, height, 0));
  std::vector<Placed> placed{{0, -1, 0, width}};
  int row = 0;
  for (const auto& course : courses) {
    int at = 0;
    for (const int w : course) {
      const double left = half * at, right = half * (at + std::abs(w));
      at += std::abs(w);
      if (w < 0) continue;
      const int stone = add_box(s, {left, row * height}, right - left, height, right - left);
      for (const auto& p : placed) {
        const double a = std::max(p.left, left), b = std::min(p.right, right);
        if (p.row == row - 1 && b > a + half / 2)
          add_joint(s, p.stone, stone, {a, row * height}, {b, row * height}, {friction});
        if (p.row == row && std::abs(p.right - left) < half / 2)
          add_joint(s, p.stone, stone, {left, (row + 1) * height}, {left, row * height}, {friction});
      }
      placed.push_back({stone, row, left, right});
    }
    ++row;
  }
  push_sideways(s);
  return s;
}

}  // namespace voussoir::test

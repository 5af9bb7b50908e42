// Stones as files would draw them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "stones/polygon.hpp"
#include "stones/repair.hpp"
#include "stones/stone_files.hpp"
#include "support/input_error.hpp"

namespace voussoir::test {

/// A prism over a polygon of the plane of two axes (0, 1 is the plane of x and y), between two places along the third.
inline StoneSurface prism(const std::string& name, const std::vector<Vector<2>>& outline, double from, double to,
                          int first_axis = 0, int second_axis = 1) {
  StoneSurface stone;
  stone.name = name;
  stone.origin = "drawn";
  const int n = static_cast<int>(outline.size()), along = 3 - first_axis - second_axis;
  for (const double level : {from, to})
    for (const auto& p : outline) {
      Vector<3> x{};
      x[first_axis] = p[0], x[second_axis] = p[1], x[along] = level;
      stone.points.push_back(x);
    }
  std::vector<int> bottom, top;
  for (int k = 0; k < n; ++k) {
    bottom.push_back(n - 1 - k);
    top.push_back(n + k);
    stone.faces.push_back({k, (k + 1) % n, n + (k + 1) % n, n + k});
  }
  stone.faces.push_back(bottom);
  stone.faces.push_back(top);
  if ((second_axis - first_axis + 3) % 3 == 2)  // the third axis points to where the outline is clockwise
    for (auto& face : stone.faces) std::reverse(face.begin(), face.end());
  return stone;
}

inline StoneSurface box(const std::string& name, const Vector<3>& low, const Vector<3>& high) {
  return prism(name, {{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}}, low[2], high[2]);
}

/// A semicircular arch of voussoirs, 1 m thick and 0.6 m deep, of 5 m mean radius, in the plane of x and z.
inline std::vector<StoneSurface> arch(int voussoirs) {
  std::vector<StoneSurface> stones;
  const double step = std::acos(-1.0) / voussoirs;
  for (int k = 0; k < voussoirs; ++k) {
    const auto at = [&](double radius, int j) {
      return Vector<2>{radius * std::cos(j * step), radius * std::sin(j * step)};
    };
    stones.push_back(
        prism("voussoir " + std::to_string(k), {at(4.5, k), at(5.5, k), at(5.5, k + 1), at(4.5, k + 1)}, 0, 0.6, 0, 2));
  }
  return stones;
}

/// Two courses: two boxes of 0.4 x 0.2 x 0.2 m below, one on both of them and half a box beside it.
inline std::vector<StoneSurface> running_bond() {
  return {box("a", {0, 0, 0}, {0.4, 0.2, 0.2}), box("b", {0.4, 0, 0}, {0.8, 0.2, 0.2}),
          box("c", {0.2, 0, 0.2}, {0.6, 0.2, 0.4}), box("d", {0.6, 0, 0.2}, {0.8, 0.2, 0.4})};
}

/// A wall of hexagonal prisms that fill it without gaps, at places of which no coordinate is round: columns of them
/// stand on their flat sides, every other one half a stone higher.
inline std::vector<StoneSurface> honeycomb(int columns, int rows, double side = 0.21, double thick = 0.3) {
  std::vector<StoneSurface> stones;
  const double high = std::sqrt(3.0) * side;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      std::vector<Vector<2>> outline;
      for (int k = 0; k < 6; ++k) {
        const double angle = k * std::acos(-1.0) / 3;
        outline.push_back(
            {0.1 + 1.5 * side * i + side * std::cos(angle), 0.7 + high * (j + 0.5 * (i % 2)) + side * std::sin(angle)});
      }
      stones.push_back(prism("cell " + std::to_string(i) + " " + std::to_string(j), outline, 0, thick, 0, 2));
    }
  return stones;
}

/// A stone shaped as an L that a box lies in, and one below both.
inline std::vector<StoneSurface> corner() {
  return {prism("L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0, 1), box("inner", {1, 1, 0}, {2, 2, 1}),
          box("below", {0, 0, -1}, {2, 2, 0})};
}

/// Turned about an axis that is none of the drawing's, moved and scaled.
inline std::vector<StoneSurface> turned(std::vector<StoneSurface> stones, double scale, const Vector<3>& by) {
  const Vector<3> axis{1 / 3.0, 2 / 3.0, 2 / 3.0};
  const double angle = 0.7;
  for (auto& stone : stones)
    for (auto& x : stone.points)
      x = scale *
              (std::cos(angle) * x + std::sin(angle) * cross(axis, x) + (1 - std::cos(angle)) * dot(axis, x) * axis) +
          by;
  return stones;
}

/// A stone as a binary STL: triangles with corners of their own, in single precision.
inline std::string as_stl(const StoneSurface& stone) {
  std::string triangles;
  std::uint32_t count = 0;
  const auto append = [&](const auto& value) { triangles.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (const auto& face : stone.faces) {
    const auto corners = places_of(stone.points, face);
    for (const auto& t : cut_into_triangles(corners)) {
      for (int k = 0; k < 3; ++k) append(0.f);
      for (const int corner : t)
        for (const double x : corners[corner]) append(static_cast<float>(x));
      append(std::uint16_t{0});
      ++count;
    }
  }
  return std::string(80, ' ') + std::string(reinterpret_cast<const char*>(&count), sizeof count) + triangles;
}

/// Stones written as STL and read again.
inline std::vector<StoneSurface> through_stl(const std::vector<StoneSurface>& stones) {
  std::vector<StoneSurface> read;
  Warnings untold;
  for (const auto& stone : stones) read.push_back(read_stl(stone.name + ".stl", as_stl(stone), untold)[0]);
  return closed(read).stones;
}

/// As measured: every point of every stone somewhere within `noise` of where it is drawn.
inline std::vector<StoneSurface> measured(std::vector<StoneSurface> stones, double noise) {
  std::mt19937 random(1);
  const auto number = [&] { return noise * (2 * (static_cast<double>(random()) / 4294967295.0) - 1); };
  for (auto& stone : stones)
    for (auto& x : stone.points) x = x + Vector<3>{number(), number(), number()};
  return stones;
}

}  // namespace voussoir::test

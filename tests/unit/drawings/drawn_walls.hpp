// Stones in the plane as files would draw them.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "drawings/plane_stones.hpp"
#include "support/input_error.hpp"

namespace voussoir::test {

inline OutlinedStone stone(const std::string& name, const Polygon& corners, const std::vector<Polygon>& holes = {}) {
  OutlinedStone s;
  s.name = name;
  s.origin = "drawn";
  s.loops.push_back({corners, std::vector<char>(corners.size(), 0)});
  for (const auto& hole : holes) s.loops.push_back({hole, std::vector<char>(hole.size(), 0)});
  return s;
}

inline Polygon box(double x, double y, double length, double height) {
  return {{x, y}, {x + length, y}, {x + length, y + height}, {x, y + height}};
}

/// Running bond: even courses of whole stones, odd ones with halves at their ends. Corners are moved by up to `error`.
inline std::vector<OutlinedStone> bond(int courses, int stones, double length, double height, double error = 0,
                                       unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> off(-error, error);
  std::vector<OutlinedStone> all;
  for (int c = 0; c < courses; ++c) {
    std::vector<double> ends{0};
    for (int k = 0; k <= stones; ++k) ends.push_back((k + (c % 2 == 0 ? 0 : 0.5)) * length);
    ends.back() = stones * length;
    if (c % 2 == 0) ends.erase(ends.begin());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      auto p = box(ends[k], c * height, ends[k + 1] - ends[k], height);
      for (auto& x : p) x = x + Vector<2>{off(random), off(random)};
      all.push_back(stone(std::to_string(c) + "." + std::to_string(k), p));
    }
  }
  return all;
}

inline DrawnFile file_of(std::vector<OutlinedStone> stones) {
  DrawnFile file;
  file.stones = std::move(stones);
  return file;
}

inline StonesParameters asked(double snap = 0, double element_size = 0) {
  StonesParameters p;
  p.file = "wall.csv";
  p.snap = snap;
  p.element_size = element_size;
  return p;
}

}  // namespace voussoir::test

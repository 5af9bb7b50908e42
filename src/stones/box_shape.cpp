#include "stones/box_shape.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace voussoir {
namespace {

using Facets = std::set<int>;

/// Per point of a stone that three facets meet at, these.
std::map<int, Facets> corners_of(const FacetedStone& stone) {
  std::map<int, Facets> facets_of_point;
  for (int f = 0; f < static_cast<int>(stone.facets.size()); ++f)
    for (const auto& edge : stone.facets[f].edges) facets_of_point[edge[0]].insert(f);
  for (auto it = facets_of_point.begin(); it != facets_of_point.end();)
    it = it->second.size() < 3 ? facets_of_point.erase(it) : std::next(it);
  return facets_of_point;
}

/// Corners of a facet in the order of its border; empty unless it is one loop with four of them.
std::vector<int> around(const StoneFacet& facet, const std::map<int, Facets>& corners) {
  std::map<int, int> next;
  for (const auto& edge : facet.edges)
    if (!next.emplace(edge[0], edge[1]).second) return {};
  std::vector<int> loop;
  int at = facet.edges[0][0];
  for (std::size_t k = 0; k < facet.edges.size(); ++k, at = next[at])
    if (corners.count(at) > 0) loop.push_back(at);
  return at == facet.edges[0][0] && loop.size() == 4 ? loop : std::vector<int>{};
}

/// The corner across the box from the first facet: it meets the same two others.
int opposite(int corner, int first, const std::map<int, Facets>& corners) {
  Facets wanted = corners.at(corner);
  wanted.erase(first);
  for (const auto& [point, facets] : corners)
    if (point != corner && std::includes(facets.begin(), facets.end(), wanted.begin(), wanted.end())) return point;
  return -1;
}

/// Derivatives of the place by the three coordinates.
std::array<Vector<3>, 3> slopes(const std::array<Vector<3>, 8>& x, const Vector<3>& at) {
  std::array<Vector<3>, 3> slope{};
  for (std::size_t c = 0; c < 8; ++c) {
    Vector<3> factor;
    for (int d = 0; d < 3; ++d) factor[d] = cube_corners[c][d] ? at[d] : 1 - at[d];
    for (int d = 0; d < 3; ++d) {
      const double others = factor[(d + 1) % 3] * factor[(d + 2) % 3];
      slope[d] = slope[d] + (cube_corners[c][d] ? others : -others) * x[c];
    }
  }
  return slope;
}

}  // namespace

Vector<3> BoxShape::place(const Vector<3>& at) const {
  Vector<3> sum{};
  for (std::size_t c = 0; c < 8; ++c) {
    double weight = 1;
    for (int d = 0; d < 3; ++d) weight *= cube_corners[c][d] ? at[d] : 1 - at[d];
    sum = sum + weight * corner[c];
  }
  return sum;
}

Vector<3> BoxShape::where(const Vector<3>& wanted) const {
  Vector<3> at{0.5, 0.5, 0.5};
  for (int round = 0; round < 20; ++round) {  // quadratic: from the middle of a box a handful is enough
    const auto rest = wanted - place(at);
    const auto s = slopes(corner, at);
    const double volume = dot(s[0], cross(s[1], s[2]));
    Vector<3> step;
    for (int d = 0; d < 3; ++d) step[d] = dot(rest, cross(s[(d + 1) % 3], s[(d + 2) % 3])) / volume;
    at = at + step;
    if (norm(step) < 1e-14) break;
  }
  return at;
}

double BoxShape::jacobian(const Vector<3>& at) const {
  const auto s = slopes(corner, at);
  return dot(s[0], cross(s[1], s[2]));
}

double BoxShape::volume() const {
  double sum = 0;  // two Gauss points in each direction are exact
  const double gauss = 0.5 / std::sqrt(3.0);
  for (const auto& c : cube_corners) {
    Vector<3> at;
    for (int d = 0; d < 3; ++d) at[d] = c[d] ? 0.5 + gauss : 0.5 - gauss;
    sum += jacobian(at) / 8;
  }
  return sum;
}

double BoxShape::length(int direction) const {
  double longest = 0;
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      int differ = 0;
      for (int d = 0; d < 3; ++d) differ += cube_corners[a][d] != cube_corners[b][d];
      if (differ == 1 && cube_corners[a][direction] != cube_corners[b][direction])
        longest = std::max(longest, norm(corner[a] - corner[b]));
    }
  return longest;
}

std::optional<BoxShape> box_shape(const StoneStructure& s, int stone) {
  const auto& faceted = s.faceted[stone];
  if (faceted.facets.size() != 6) return {};
  const auto corners = corners_of(faceted);
  if (corners.size() != 8) return {};
  int lowest = 0;  // so that boxes of a wall are alike
  for (int f = 0; f < 6; ++f)
    if (faceted.facets[f].normal[2] < faceted.facets[lowest].normal[2]) lowest = f;
  auto bottom = around(faceted.facets[lowest], corners);
  if (bottom.empty()) return {};
  std::reverse(bottom.begin(), bottom.end());  // counter-clockwise seen from inside
  BoxShape box;
  Facets met;
  for (int k = 0; k < 4; ++k) {
    const int top = opposite(bottom[k], lowest, corners);
    if (top < 0 || corners.at(top).size() != 3 || corners.at(bottom[k]).size() != 3) return {};
    met.insert(top);
    box.corner[k] = s.imprint.points[s.imprint.number[stone][bottom[k]]];
    box.corner[k + 4] = s.imprint.points[s.imprint.number[stone][top]];
  }
  if (met.size() != 4) return {};
  for (int d = 0; d < 3; ++d) box.size = std::max(box.size, box.length(d));
  return box;
}

}  // namespace voussoir

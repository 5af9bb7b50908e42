#include "stones/solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "stones/facets.hpp"
#include "stones/polygon.hpp"

namespace voussoir {
namespace {

// Shares by which a line that grazes an edge is moved aside: neither they nor their quotients are those of a drawing.
constexpr std::array<std::array<double, 2>, 4> moved_aside{
    {{0.2137, 0.5923}, {-0.6181, 0.3347}, {0.4519, -0.7793}, {-0.2861, -0.9407}}};

// [-] of the area that an edge and the farthest corner of a triangle span: a line that passes an edge by less grazes
// it.
constexpr double grazes = 1e-12;

// [-] of the distance of a place from the surface: that far aside of it inside is told from outside without doubt.
constexpr double nearby_place = 0.5;

double distance_to_segment(const Vector<3>& a, const Vector<3>& b, const Vector<3>& place) {
  const auto along = b - a;
  const double squared = dot(along, along);
  const double part = squared > 0 ? std::clamp(dot(place - a, along) / squared, 0.0, 1.0) : 0;
  return norm(place - a - part * along);
}

double distance_to_triangle(const std::array<Vector<3>, 3>& t, const Vector<3>& place) {
  const auto normal = cross(t[1] - t[0], t[2] - t[0]);
  const double size = norm(normal);
  bool above = size > 0;
  for (int k = 0; k < 3 && above; ++k) above = dot(cross(t[(k + 1) % 3] - t[k], place - t[k]), normal) >= 0;
  if (above) return std::abs(dot(place - t[0], normal)) / size;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) least = std::min(least, distance_to_segment(t[k], t[(k + 1) % 3], place));
  return least;
}

/// Of two segments that cross when seen along what is at right angles to both: the nearest of their ends is told else.
double distance_of_crossing(const std::array<Vector<3>, 2>& e, const std::array<Vector<3>, 2>& f) {
  const auto u = e[1] - e[0], v = f[1] - f[0], w = f[0] - e[0], normal = cross(u, v);
  const double squared = dot(normal, normal);
  if (squared <= grazes * dot(u, u) * dot(v, v)) return std::numeric_limits<double>::infinity();
  const double s = dot(cross(w, v), normal) / squared, t = dot(cross(w, u), normal) / squared;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::numeric_limits<double>::infinity();
  return std::abs(dot(w, normal)) / std::sqrt(squared);
}

template <class Corners>
Box<3> box_around(const Corners& corners) {
  Box<3> box{corners[0], corners[0]};
  for (const auto& x : corners) box.add({x, x});
  return box;
}

template <class Pieces>
BoxTree<3> tree_around(const Pieces& pieces) {
  std::vector<Box<3>> boxes;
  for (const auto& piece : pieces) boxes.push_back(box_around(piece));
  return BoxTree<3>(std::move(boxes));
}

std::vector<std::array<Vector<3>, 3>> triangles_of(const StoneSurface& stone) {
  std::vector<std::array<Vector<3>, 3>> all;
  for (const auto& face : stone.faces) {
    const auto corners = places_of(stone.points, face);
    for (const auto& t : cut_into_triangles(corners)) all.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  }
  return all;
}

std::vector<std::array<Vector<3>, 2>> edges_of(const StoneSurface& stone) {
  std::set<std::pair<int, int>> known;
  std::vector<std::array<Vector<3>, 2>> all;
  for (const auto& face : stone.faces)
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      if (known.insert(std::minmax(a, b)).second) all.push_back({stone.points[a], stone.points[b]});
    }
  return all;
}

}  // namespace

Solid::Solid(const StoneSurface& stone)
    : points_(stone.points),
      box_(box_of(stone.points)),
      triangles_(triangles_of(stone)),
      edges_(edges_of(stone)),
      tree_(tree_around(triangles_)),
      edge_tree_(tree_around(edges_)) {}

/// Where a line along an axis goes through the surface, with 1 where it enters and -1 where it leaves; false where it
/// grazes an edge.
bool Solid::crossings(int axis, const Vector<3>& through, std::vector<std::pair<double, int>>& found) const {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Box<3> line{through, through};
  line.low[axis] = box_.low[axis];
  line.high[axis] = box_.high[axis];
  found.clear();
  bool clear = true;
  tree_.visit_overlaps(line, [&](int number) {
    const auto& t = triangles_[number];
    std::array<double, 3> part{};  // twice the areas that the line spans with the edges, seen along the axis
    double all = 0, largest = 0;
    for (int k = 0; k < 3; ++k) {
      const auto &a = t[(k + 1) % 3], &b = t[(k + 2) % 3];
      part[k] = (a[u] - through[u]) * (b[v] - through[v]) - (a[v] - through[v]) * (b[u] - through[u]);
      all += part[k];
      largest = std::max({largest, std::abs(part[k]), std::abs((a[u] - b[u]) * (a[v] - b[v]))});
    }
    const bool outside = std::any_of(part.begin(), part.end(), [&](double p) { return p > grazes * largest; }) &&
                         std::any_of(part.begin(), part.end(), [&](double p) { return p < -grazes * largest; });
    if (outside) return;
    for (const double p : part) clear &= std::abs(p) > grazes * largest;
    if (!clear) return;
    double at = 0;
    for (int k = 0; k < 3; ++k) at += part[k] / all * t[k][axis];
    found.emplace_back(at, all < 0 ? 1 : -1);
  });
  std::sort(found.begin(), found.end());
  return clear;
}

std::vector<std::array<double, 2>> Solid::along(int axis, const Vector<3>& through, double aside) const {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<std::pair<double, int>> found;
  bool clear = crossings(axis, through, found);
  for (std::size_t k = 0; !clear && k < moved_aside.size(); ++k) {
    auto moved = through;
    moved[u] += aside * moved_aside[k][0];
    moved[v] += aside * moved_aside[k][1];
    clear = crossings(axis, moved, found);
  }
  std::vector<std::array<double, 2>> inside;
  int in = 0;
  for (std::size_t k = 0; clear && k + 1 < found.size(); ++k) {
    in += found[k].second;
    if (in > 0) inside.push_back({found[k].first, found[k + 1].first});
  }
  return inside;
}

bool Solid::holds(const Vector<3>& place, double near) const {
  if (!box_.overlaps({place, place})) return false;
  for (const auto& [from, to] : along(2, place, near))
    if (from <= place[2] && place[2] <= to) return true;
  return false;
}

double Solid::distance(const Vector<3>& place, double most) const {
  double least = most;
  for (double reach = norm(box_.high - box_.low) / 64;; reach *= 4) {
    tree_.visit_overlaps(widened(Box<3>{place, place}, std::min(reach, most)),
                         [&](int number) { least = std::min(least, distance_to_triangle(triangles_[number], place)); });
    if (least <= reach || reach >= most) return least;
  }
}

double Solid::depth(const Vector<3>& place) const {
  const double away = distance(place, std::numeric_limits<double>::infinity());
  return holds(place, nearby_place * away) ? away : -away;
}

double Solid::distance(const Solid& other, double most) const {
  double least = most;
  for (const auto& x : points_) least = other.distance(x, least);
  for (const auto& x : other.points_) least = distance(x, least);
  for (const auto& edge : edges_)
    other.edge_tree_.visit_overlaps(widened(box_around(edge), least), [&](int number) {
      least = std::min(least, distance_of_crossing(edge, other.edges_[number]));
    });
  return least;
}

}  // namespace voussoir

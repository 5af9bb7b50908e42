#include "stones/facets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/sort_unique.hpp"
#include "stones/polygon.hpp"
#include "stones/repair.hpp"

namespace voussoir {
namespace {

/// Faces whose planes differ by more are no part of one facet, however thin they are: 26 degrees.
constexpr double least_cosine = 0.9;
/// A corner that points inward by less is straight: a millionth of a radian, what rounded coordinates make of one.
constexpr double straight_corner = 1e-6;

struct Plane {
  Vector<3> normal{}, centre{};
  double farthest = 0;  ///< [m] of the points
};

/// The plane of least squares: the one along the area, tilted by the slopes of the points above it.
Plane fitted(const Places& points, const Vector<3>& area) {
  Plane plane;
  plane.centre = mean(points);
  if (!(norm(area) > 0)) return plane;
  const PlaneAxes axes(plane.centre, area);
  double uu = 0, uv = 0, vv = 0, uz = 0, vz = 0;
  for (const auto& x : points) {
    const auto p = axes(x);
    const double z = dot(x - plane.centre, axes.normal);
    uu += p[0] * p[0], uv += p[0] * p[1], vv += p[1] * p[1], uz += p[0] * z, vz += p[1] * z;
  }
  const double determinant = uu * vv - uv * uv, size = uu + vv;
  plane.normal = axes.normal;
  if (determinant > 1e-12 * size * size) {  // else the points lie on a line, which says nothing of a slope across
    const double a = (uz * vv - vz * uv) / determinant, b = (vz * uu - uz * uv) / determinant;
    plane.normal = axes.normal - a * axes.first - b * axes.second;
    plane.normal = (1 / norm(plane.normal)) * plane.normal;
  }
  for (const auto& x : points) plane.farthest = std::max(plane.farthest, std::abs(dot(x - plane.centre, plane.normal)));
  return plane;
}

/// The faces of a stone, warped ones in triangles.
class Faces {
 public:
  Faces(const StoneSurface& stone, double tolerance, FacetedStone& result) : stone_(stone) {
    for (std::size_t f = 0; f < stone.faces.size(); ++f) {
      const auto& face = stone.faces[f];
      const int part = stone.part.empty() ? 0 : stone.part[f];
      const auto corners = places_of(stone.points, face);
      const double farthest = face.size() > 3 ? fitted(corners, area_vector(corners)).farthest : 0;
      result.farthest = std::max(result.farthest, farthest);
      if (farthest <= tolerance) {
        add(face, part);
        continue;
      }
      ++result.warped;
      for (const auto& t : cut_into_triangles(corners)) add({face[t[0]], face[t[1]], face[t[2]]}, part);
    }
  }
  std::size_t size() const { return face_.size(); }
  const std::vector<int>& operator[](int f) const { return face_[f]; }
  int part(int f) const { return part_[f]; }
  const Vector<3>& area(int f) const { return area_[f]; }
  Places corners(int f) const { return places_of(stone_.points, face_[f]); }
  /// The face across an edge of a face, or -1.
  int across(int a, int b) const {
    const auto found = of_edge_.find({b, a});
    return found == of_edge_.end() ? -1 : found->second;
  }
  /// Faces in the order of their areas, the largest first.
  std::vector<int> by_area() const {
    std::vector<int> order(size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return norm(area_[a]) > norm(area_[b]); });
    return order;
  }

 private:
  void add(const std::vector<int>& face, int part) {
    for (std::size_t k = 0; k < face.size(); ++k)
      of_edge_[{face[k], face[(k + 1) % face.size()]}] = static_cast<int>(face_.size());
    area_.push_back(area_vector(places_of(stone_.points, face)));
    face_.push_back(face);
    part_.push_back(part);
  }

  const StoneSurface& stone_;
  std::vector<std::vector<int>> face_;
  std::vector<int> part_;
  Places area_;
  std::map<std::pair<int, int>, int> of_edge_;
};

/// Faces that lie in the plane of the first, and hang together by edges.
std::vector<int> grown_from(int first, const Faces& faces, const StoneSurface& stone, double tolerance,
                            std::vector<char>& taken) {
  const auto centre = mean(faces.corners(first));
  const auto size = norm(faces.area(first));
  std::vector<int> region{first};
  taken[first] = 1;
  if (size == 0) return region;
  const auto normal = (1 / size) * faces.area(first);
  for (std::size_t k = 0; k < region.size(); ++k) {
    const auto face = faces[region[k]];
    for (std::size_t e = 0; e < face.size(); ++e) {
      const int next = faces.across(face[e], face[(e + 1) % face.size()]);
      if (next < 0 || taken[next] || faces.part(next) != faces.part(first)) continue;
      if (dot(faces.area(next), normal) < least_cosine * norm(faces.area(next))) continue;
      const bool flat = std::all_of(faces[next].begin(), faces[next].end(), [&](int point) {
        return std::abs(dot(stone.points[point] - centre, normal)) <= tolerance;
      });
      if (!flat) continue;
      taken[next] = 1;
      region.push_back(next);
    }
  }
  return region;
}

/// The border of a region as one loop of points; empty when it is none (a hole, a point met twice).
std::vector<int> single_loop(const std::vector<std::array<int, 2>>& edges) {
  std::map<int, int> next;
  for (const auto& e : edges)
    if (!next.emplace(e[0], e[1]).second) return {};
  std::vector<int> loop{edges[0][0]};
  for (int at = next[loop[0]]; at != loop[0] && loop.size() <= edges.size(); at = next[at]) loop.push_back(at);
  return loop.size() == edges.size() ? loop : std::vector<int>{};
}

bool is_convex_in(const PlaneAxes& axes, const Places& places) {
  Polygon polygon;
  for (const auto& x : places) polygon.push_back(axes(x));
  return is_convex(polygon, straight_corner);
}

StoneFacet facet_of(const std::vector<int>& region, const Faces& faces, const StoneSurface& stone) {
  StoneFacet facet;
  std::vector<int> points;
  std::set<std::pair<int, int>> edges;
  Vector<3> area{};
  for (const int f : region) {
    const auto& face = faces[f];
    area = area + faces.area(f);
    points.insert(points.end(), face.begin(), face.end());
    for (std::size_t k = 0; k < face.size(); ++k) edges.insert({face[k], face[(k + 1) % face.size()]});
  }
  sort_unique(points);
  for (const auto& [a, b] : edges)
    if (edges.count({b, a}) == 0) facet.edges.push_back({a, b});
  const auto places = places_of(stone.points, points);
  const Plane plane = fitted(places, area);
  facet.normal = plane.normal;
  facet.centre = plane.centre;
  facet.out_of_plane = plane.farthest;
  facet.area = norm(area);
  facet.box = box_of(places);
  if (facet.area == 0) return facet;
  const PlaneAxes axes(facet.centre, facet.normal);
  if (const auto loop = single_loop(facet.edges); !loop.empty() && is_convex_in(axes, places_of(stone.points, loop))) {
    facet.pieces.push_back(places_of(stone.points, loop));
    return facet;
  }
  for (const int f : region) {
    const auto corners = faces.corners(f);
    if (is_convex_in(axes, corners)) {
      facet.pieces.push_back(corners);
      continue;
    }
    for (const auto& t : cut_into_triangles(corners))
      facet.pieces.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  }
  return facet;
}

/// The borders of all facets of a stone without the points at which they do not turn.
class StraightEdges {
 public:
  StraightEdges(const StoneSurface& stone, std::vector<StoneFacet>& facets) : x_(stone.points), facets_(facets) {
    for (const auto& facet : facets_)
      for (const auto& [a, b] : facet.edges) {
        beside_[a].insert(b);
        beside_[b].insert(a);
      }
    const auto box = box_of(x_);
    turns_ = same_point * norm(box.high - box.low);
  }

  void join() {
    for (const auto& [point, others] : beside_)
      if (others.size() != 2)
        for (const int next : others) walk(point, next);
    for (const auto& [point, others] : beside_)  // rims that no other edge meets
      if (others.size() == 2 && known_.count(point) == 0) walk(point, *others.begin());
    for (auto& facet : facets_) drop_from(facet);
  }

 private:
  /// From a point along points that two edges meet to the next that is none of them, or around.
  void walk(int from, int next) {
    std::vector<int> chain{from};
    for (int at = next; at != from && beside_.at(at).size() == 2; at = next) {
      if (!known_.insert(at).second) return;
      chain.push_back(at);
      const auto& others = beside_.at(at);
      const int before = chain[chain.size() - 2];
      next = *others.begin() == before ? *others.rbegin() : *others.begin();
    }
    chain.push_back(next);
    if (chain.front() != chain.back()) return straighten(chain, 0, chain.size() - 1);
    known_.insert(from);
    std::size_t far = 0;  // of a rim at least a triangle stays: what is farthest from its beginning, and from both
    for (std::size_t k = 0; k < chain.size(); ++k)
      if (norm(x_[chain[k]] - x_[from]) > norm(x_[chain[far]] - x_[from])) far = k;
    straighten(chain, 0, far);
    straighten(chain, far, chain.size() - 1);
  }

  /// Drops the points between two of a chain that lie on the straight line between them, or cuts it at the farthest.
  void straighten(const std::vector<int>& chain, std::size_t from, std::size_t to) {
    const auto along = x_[chain[to]] - x_[chain[from]];
    const double length = norm(along);
    std::size_t far = from;
    double farthest = turns_;
    for (std::size_t k = from + 1; k < to; ++k) {
      const auto apart = x_[chain[k]] - x_[chain[from]];
      const double off = length > 0 ? norm(cross(along, apart)) / length : norm(apart);
      if (off > farthest) far = k, farthest = off;
    }
    if (far == from) {
      dropped_.insert(chain.begin() + static_cast<std::ptrdiff_t>(from) + 1,
                      chain.begin() + static_cast<std::ptrdiff_t>(to));
      return;
    }
    straighten(chain, from, far);
    straighten(chain, far, to);
  }

  void drop_from(StoneFacet& facet) const {
    std::map<int, int> next;  // after a point that is dropped: it is met once
    for (const auto& [a, b] : facet.edges)
      if (dropped_.count(a) > 0) next[a] = b;
    std::vector<std::array<int, 2>> edges;
    for (auto [a, b] : facet.edges) {
      if (dropped_.count(a) > 0) continue;
      while (dropped_.count(b) > 0) b = next.at(b);
      edges.push_back({a, b});
    }
    facet.edges = std::move(edges);
  }

  const Places& x_;
  std::vector<StoneFacet>& facets_;
  std::map<int, std::set<int>> beside_;  ///< per point of a border those at the other ends of its edges
  std::set<int> known_, dropped_;
  double turns_ = 0;  ///< [m] from a straight line
};

}  // namespace

FacetedStone facets_of(const StoneSurface& stone, double tolerance) {
  FacetedStone result;
  result.surface = &stone;
  result.box = box_of(stone.points);
  const Faces faces(stone, tolerance, result);
  std::vector<char> taken(faces.size(), 0);
  for (const int first : faces.by_area())
    if (!taken[first])
      result.facets.push_back(facet_of(grown_from(first, faces, stone, tolerance, taken), faces, stone));
  StraightEdges(stone, result.facets).join();
  return result;
}

std::vector<FacetedStone> facets_of(const std::vector<StoneSurface>& stones, double tolerance) {
  std::vector<FacetedStone> faceted;
  for (const auto& stone : stones) faceted.push_back(facets_of(stone, tolerance));
  return faceted;
}

double distance_along(const StoneFacet& facet, const Vector<3>& point, const Vector<3>& direction) {
  return dot(facet.centre - point, facet.normal) / dot(facet.normal, direction);
}

Box<3> box_of(const Places& places) {
  Box<3> box{places[0], places[0]};
  for (const auto& x : places) box.add({x, x});
  return box;
}

}  // namespace voussoir

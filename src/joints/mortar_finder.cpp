#include "joints/mortar_finder.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/same_side.hpp"

namespace voussoir {
namespace {

// Shares of the length of an edge: ends that lie so near the line of another lie on it, as coordinates of a drawing
// have some ten digits; and what two edges have in common beside round-off is longer.
constexpr double on_the_line = 1e-8, shortest_overlap = 1e-9;
// Weights of a point are about one: what is left of those that vanish is round-off.
constexpr double vanishing_weight = 1e-12;

/// The nodes of an edge in its direction.
struct Edge {
  std::array<int, 2> node;
  std::array<Vector<2>, 2> end;

  Vector<2> along() const { return end[1] - end[0]; }
  Vector<2> outward() const { return {along()[1], -along()[0]}; }
};

std::vector<Edge> edges_of(const BlockWithBorder<2>& b) {
  std::vector<Edge> edges;
  for (const auto& f : b.facets)
    edges.push_back({{f.node[0], f.node[1]}, {b.block.position[f.node[0]], b.block.position[f.node[1]]}});
  return edges;
}

/// What an edge has in common with one of the other block: from and to along it, and where that is along the other,
/// as shares of their lengths.
struct Overlap {
  int other;
  std::array<double, 2> here, there;
};

/// Whether two edges lie on each other, block against block, and where.
bool meet(const Edge& a, const Edge& b, Overlap& overlap) {
  const auto along = a.along();
  const double square = dot(along, along);
  if (!(dot(a.outward(), b.outward()) < 0)) return false;
  std::array<double, 2> at;
  for (int n = 0; n < 2; ++n) {
    const auto arm = b.end[n] - a.end[0];
    if (std::abs(cross(along, arm)) > on_the_line * square) return false;
    at[n] = dot(along, arm) / square;
  }
  overlap.here = {std::max(0.0, std::min(at[0], at[1])), std::min(1.0, std::max(at[0], at[1]))};
  if (!(overlap.here[1] - overlap.here[0] > shortest_overlap)) return false;
  for (int n = 0; n < 2; ++n) overlap.there[n] = (overlap.here[n] - at[0]) / (at[1] - at[0]);
  return true;
}

/// Overlaps of each edge of one block with those of the other.
std::vector<std::vector<Overlap>> overlaps(const std::vector<Edge>& of, const std::vector<Edge>& with) {
  std::vector<std::vector<Overlap>> all(of.size());
  for (std::size_t a = 0; a < of.size(); ++a)
    for (std::size_t b = 0; b < with.size(); ++b) {
      Overlap overlap{static_cast<int>(b), {}, {}};
      if (meet(of[a], with[b], overlap)) all[a].push_back(overlap);
    }
  return all;
}

double covered(const std::vector<Edge>& edges, const std::vector<std::vector<Overlap>>& overlaps) {
  double length = 0;
  for (std::size_t a = 0; a < edges.size(); ++a)
    for (const auto& o : overlaps[a]) length += (o.here[1] - o.here[0]) * norm(edges[a].along());
  return length;
}

using Pair = std::array<double, 2>;

/// Shape functions at a share of an edge.
Pair shapes(double at) { return {1 - at, at}; }

/// A point while it grows: D and D times the weights [m].
struct Growing {
  int node;
  Vector<2> normal{};  ///< [m]
  double share = 0;
  std::map<int, double> weight;
};

/// The dual functions of one edge, as shares of its shape functions: psi_a = sum_c dual[a][c] N_c.
struct Dual {
  std::array<Pair, 2> of{};
  Pair share{};  ///< D_a over the length of the edge [-]

  explicit Dual(const std::vector<Overlap>& overlaps) {
    std::array<Pair, 2> mass{};
    each_gauss_point(overlaps, [&](const Overlap&, double here, double, double weight) {
      const auto n = shapes(here);
      for (int a = 0; a < 2; ++a) {
        share[a] += weight * n[a];
        for (int c = 0; c < 2; ++c) mass[a][c] += weight * n[a] * n[c];
      }
    });
    const double determinant = mass[0][0] * mass[1][1] - mass[0][1] * mass[1][0];
    for (int a = 0; a < 2; ++a)
      of[a] = {(a == 0 ? mass[1][1] : -mass[1][0]) * share[a] / determinant,
               (a == 0 ? -mass[0][1] : mass[0][0]) * share[a] / determinant};
  }

  double at(int a, double here) const { return of[a][0] * (1 - here) + of[a][1] * here; }

  /// f(overlap, place here, place there, weight) at the two Gauss points of each overlap: exact for products of two.
  template <class F>
  static void each_gauss_point(const std::vector<Overlap>& overlaps, const F& f) {
    const double g = 0.5 / std::sqrt(3.0);
    for (const auto& o : overlaps)
      for (const double s : {0.5 - g, 0.5 + g})
        f(o, o.here[0] + s * (o.here[1] - o.here[0]), o.there[0] + s * (o.there[1] - o.there[0]),
          (o.here[1] - o.here[0]) / 2);
  }
};

/// The point of a node on the side with this normal.
Growing& point_of(std::vector<Growing>& points, int node, const Vector<2>& normal, bool fold) {
  for (auto& p : points)
    if (p.node == node && on_same_side(p.normal, normal, fold)) return p;
  points.push_back({node, {}, 0, {}});
  return points.back();
}

std::vector<Growing> grow(const Block<2>& block, const std::vector<Edge>& edges, const std::vector<Edge>& others,
                          const std::vector<std::vector<Overlap>>& overlaps) {
  std::vector<Growing> points;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (overlaps[e].empty()) continue;
    const Dual dual(overlaps[e]);
    const double length = norm(edges[e].along());
    for (int a = 0; a < 2; ++a) {
      auto& p = point_of(points, edges[e].node[a], edges[e].outward(), is_fold(block, edges[e].node[a]));
      p.normal = p.normal + edges[e].outward();
      p.share += length * dual.share[a];
      Dual::each_gauss_point(overlaps[e], [&](const Overlap& o, double here, double there, double weight) {
        const auto n = shapes(there);
        for (int b = 0; b < 2; ++b) p.weight[others[o.other].node[b]] += length * weight * dual.at(a, here) * n[b];
      });
    }
  }
  return points;
}

FoundPoint found(const Growing& p, const Block<2>& mine, const Block<2>& other, bool mine_is_i) {
  std::vector<NodeShare> shares;
  for (const auto& [node, weight] : p.weight)
    if (std::abs(weight) > vanishing_weight * p.share) shares.push_back({node, weight / p.share});
  if (shares.size() == 1) shares.front().weight = 1;
  FoundPoint f;
  f.coincident = shares.size() == 1 && other.vertex[shares.front().node] == mine.vertex[p.node];
  f.shares_i = mine_is_i ? PointSide(p.node) : PointSide(shares);
  f.shares_j = mine_is_i ? PointSide(shares) : PointSide(p.node);
  f.place = in_space(mine.position[p.node]);
  f.normal = in_space((mine_is_i ? 1.0 : -1.0) / norm(p.normal) * p.normal);
  f.extent = p.share;
  return f;
}

}  // namespace

std::vector<FoundPoint> mortar_points(const BlockWithBorder<2>& i, const BlockWithBorder<2>& j) {
  const auto edges_i = edges_of(i), edges_j = edges_of(j);
  const auto of_i = overlaps(edges_i, edges_j), of_j = overlaps(edges_j, edges_i);
  const double length = covered(edges_i, of_i);
  double matched = 0;
  auto coincident = coincident_points<2>(i, j);
  for (const auto& p : coincident) matched += p.extent;
  if (length <= matched * (1 + on_the_line)) return coincident;

  const auto met = [](const auto& list) {
    return std::count_if(list.begin(), list.end(), [](const auto& overlaps) { return !overlaps.empty(); });
  };
  const bool on_i = met(of_i) >= met(of_j);
  const auto& mine = on_i ? i.block : j.block;
  auto points = on_i ? grow(mine, edges_i, edges_j, of_i) : grow(mine, edges_j, edges_i, of_j);
  std::stable_sort(points.begin(), points.end(),
                   [&](const auto& a, const auto& b) { return mine.vertex[a.node] < mine.vertex[b.node]; });
  std::vector<FoundPoint> all;
  for (const auto& p : points) all.push_back(found(p, mine, on_i ? j.block : i.block, on_i));
  return all;
}

}  // namespace voussoir

#include "stones/imprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "stones/cut_edges.hpp"
#include "stones/drawing.hpp"
#include "stones/welded_points.hpp"

namespace voussoir {
namespace {

using Loop = std::vector<int>;

// [-] of the weld: far above round-off of places, far below the width of a cell.
constexpr double beside = 1e-6;

// [-] of the weld: a point that near lies from two edges of a corner of 60 degrees as far as points do that are one.
constexpr double farthest_corner = 2;
using Edge = std::pair<int, int>;

/// The border of polygons that lie side by side: edges that two of them have are none of it.
class Outline {
 public:
  void add(const Loop& loop) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Edge edge{loop[k], loop[(k + 1) % loop.size()]};
      if (edges_.erase({edge.second, edge.first}) == 0) edges_.insert(edge);
    }
  }
  const std::set<Edge>& edges() const { return edges_; }

 private:
  std::set<Edge> edges_;
};

/// A joint on a facet: its number, and its convex pieces in the plane of the facet.
struct OnFacet {
  int joint;
  std::vector<Polygon> pieces;

  /// Whether a place lies in it. One on edges between pieces may be in none of them by round-off: one of two beside it
  /// is, which lie in no direction that drawings have.
  bool holds(const Vector<2>& place, double by_much) const {
    for (const auto& by : {Vector<2>{0, 0}, Vector<2>{0.8391 * by_much, 0.5297 * by_much},
                           Vector<2>{-0.2917 * by_much, 0.9511 * by_much}})
      for (const auto& piece : pieces)
        if (voussoir::holds(piece, place + by)) return true;
    return false;
  }
};

/// The drawing of one facet, over numbers of its own.
class FacetDrawing {
 public:
  FacetDrawing(const StoneFacet& facet, const Places& points) : axes_(facet.centre, facet.normal), x_(points) {}

  void add_edge(int a, int b) {
    if (a == b || !known_.insert(std::minmax(a, b)).second) return;
    drawing_.edges.push_back({local(a), local(b)});
  }
  int local(int point) {
    const auto [known, is_new] = number_.emplace(point, static_cast<int>(points_.size()));
    if (is_new) {
      points_.push_back(point);
      drawing_.points.push_back(axes_(x_[point]));
    }
    return known->second;
  }
  Polygon polygon(const Loop& points) const {
    Polygon p;
    for (const int point : points) p.push_back(axes_(x_[point]));
    return p;
  }
  Loop global(const Loop& local) const {
    Loop points;
    for (const int k : local) points.push_back(points_[k]);
    return points;
  }
  const Drawing2& drawing() const { return drawing_; }

 private:
  PlaneAxes axes_;
  const Places& x_;
  std::set<Edge> known_;
  std::map<int, int> number_;
  Loop points_;
  Drawing2 drawing_;
};

class Imprinting {
 public:
  Imprinting(const std::vector<FacetedStone>& stones, const StoneJoints& joints, double weld)
      : stones_(stones),
        joints_(joints),
        weld_(weld),
        welded_(weld),
        number_(numbers_of_points()),
        pieces_(numbers_of_pieces()),
        cut_(std::make_unique<CutEdges<3>>(welded_.points(), weld)) {
    make_corners_one();
  }

  Imprint run() {
    std::map<std::array<int, 2>, std::vector<int>> joints_of_facet;
    for (int j = 0; j < static_cast<int>(joints_.joints.size()); ++j)
      for (int side = 0; side < 2; ++side)
        joints_of_facet[{joints_.joints[j].stone[side], joints_.joints[j].facet[side]}].push_back(j);
    imprint_.number = number_;
    for (int s = 0; s < static_cast<int>(stones_.size()); ++s)
      for (int f = 0; f < static_cast<int>(stones_[s].facets.size()); ++f) cut_facet(s, f, joints_of_facet[{s, f}]);
    return std::move(imprint_);
  }

 private:
  /// Of points on the borders of facets; -1 for those inside, which a file of triangles may have.
  std::vector<Loop> numbers_of_points() {
    std::vector<Loop> numbers;
    for (const auto& stone : stones_) {
      const auto& places = stone.surface->points;
      std::vector<char> on_border(places.size(), 0);
      for (const auto& facet : stone.facets)
        for (const auto& edge : facet.edges) on_border[edge[0]] = 1;
      numbers.emplace_back();
      for (std::size_t k = 0; k < places.size(); ++k)
        numbers.back().push_back(on_border[k] ? welded_.add(places[k]) : -1);
    }
    return numbers;
  }

  std::vector<std::vector<Loop>> numbers_of_pieces() {
    std::vector<std::vector<Loop>> numbers;
    for (const auto& joint : joints_.joints) {
      numbers.emplace_back();
      for (const auto& piece : joint.pieces) numbers.back().push_back(numbers_of(piece));
    }
    return numbers;
  }

  /// Where nearly parallel edges of two stones cross is chance: such a corner, with no point of a stone near it and
  /// nearly on the line of its neighbours, is none. Corners that are one stand for it together, or each would seem to
  /// lie on the line from the other to the next.
  Loop numbers_of(const Places& corners) {
    const auto are_one = [&](const Vector<3>& x, const Vector<3>& y) {
      const int known = welded_.find(x);
      return known == welded_.find(y) && (known >= 0 || norm(x - y) <= weld_);
    };
    Places piece;
    for (const auto& x : corners)
      if (piece.empty() || !are_one(x, piece.back())) piece.push_back(x);
    while (piece.size() > 1 && are_one(piece.front(), piece.back())) piece.pop_back();
    Loop numbers;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const auto &before = piece[(k + piece.size() - 1) % piece.size()], &after = piece[(k + 1) % piece.size()];
      const double length = norm(after - before);
      const bool straight = norm(cross(after - before, piece[k] - before)) <= weld_ / 2 * length;
      if (!straight || welded_.find(piece[k]) >= 0) numbers.push_back(welded_.add(piece[k]));
    }
    return numbers;
  }

  /// A point that lies on both edges of a corner is that corner, though it is a little farther from it than points that
  /// are one: both edges would go to it and back. Leaves the points of the imprint, in their order.
  void make_corners_one() {
    const auto& x = welded_.points();
    DisjointSets same(x.size());
    for (std::size_t s = 0; s < stones_.size(); ++s)
      for (const auto& facet : stones_[s].facets) {
        std::multimap<int, int> after;
        for (const auto& e : facet.edges) after.emplace(number_[s][e[0]], number_[s][e[1]]);
        for (const auto& [before, corner] : after)
          for (auto [at, end] = after.equal_range(corner); at != end; ++at)
            for (const int point : between(*cut_, before, corner, at->second))
              if (norm(x[point] - x[corner]) <= farthest_corner * weld_) same.unite(point, corner);
      }
    std::map<int, int> number;  // of those that stand for others
    Places left;
    for (int k = 0; k < static_cast<int>(x.size()); ++k)
      if (number.emplace(same.root(k), static_cast<int>(left.size())).second) left.push_back(x[k]);
    imprint_.points = std::move(left);
    if (imprint_.points.size() == x.size()) return;  // edges are cut as they are here
    const auto renumber = [&](Loop& loop) {
      for (int& point : loop)
        if (point >= 0) point = number.at(same.root(point));
    };
    for (auto& loop : number_) renumber(loop);
    for (auto& pieces : pieces_)
      for (auto& loop : pieces) renumber(loop);
    cut_ = std::make_unique<CutEdges<3>>(imprint_.points, weld_);
  }

  /// Points on the way from a to b that are on the way from b to c too.
  static Loop between(CutEdges<3>& edges, int a, int b, int c) {
    if (a == b || b == c || a == c) return {};
    auto one = edges.way(a, b), other = edges.way(b, c);
    Loop both;
    if (one.size() < 3 || other.size() < 3) return both;
    for (const int point : one)
      if (point != a && point != b && std::find(other.begin(), other.end() - 1, point) != other.end() - 1)
        both.push_back(point);
    return both;
  }

  void cut_facet(int s, int f, const std::vector<int>& joints) {
    const auto& facet = stones_[s].facets[f];
    if (facet.area == 0) return;
    FacetDrawing drawing(facet, imprint_.points);
    std::vector<std::array<int, 2>> border;  // of the facet, directed
    for (const auto& e : facet.edges) {
      const int a = number_[s][e[0]], b = number_[s][e[1]];
      if (a == b) continue;
      const Loop way = cut_->way(a, b);
      for (std::size_t k = 0; k + 1 < way.size(); ++k) {
        drawing.add_edge(way[k], way[k + 1]);
        border.push_back({drawing.local(way[k]), drawing.local(way[k + 1])});
      }
    }
    std::vector<OnFacet> on_facet;
    for (const int j : joints) {
      on_facet.push_back({j, {}});
      Outline outline;
      for (Loop corners : pieces_[j]) {
        if (joints_.joints[j].stone[0] != s) std::reverse(corners.begin(), corners.end());
        const Loop loop = cut_->around(corners);
        if (loop.empty()) continue;
        on_facet.back().pieces.push_back(drawing.polygon(loop));
        outline.add(loop);
      }
      for (const auto& [a, b] : outline.edges()) drawing.add_edge(a, b);
    }
    for (std::size_t k = 0; k < crossings_of(drawing.drawing()).size(); ++k)
      imprint_.faults.crossings.push_back({s, f});
    for (const auto& drawn : cells_of(drawing.drawing())) {
      if (winding(drawing.drawing().points, border, drawn.inside) < 1) continue;
      ImprintedCell cell{s, f, -1, drawing.global(drawn.outer), {}, drawn.area};
      for (const auto& hole : drawn.holes) cell.holes.push_back(drawing.global(hole));
      for (const auto& joint : on_facet)
        if (joint.holds(drawn.inside, beside * weld_)) cell.joint = joint.joint;
      imprint_.cells.push_back(std::move(cell));
    }
  }

  const std::vector<FacetedStone>& stones_;
  const StoneJoints& joints_;
  double weld_;
  WeldedPoints<3> welded_;
  std::vector<Loop> number_;               ///< per stone and point
  std::vector<std::vector<Loop>> pieces_;  ///< per joint and piece
  std::unique_ptr<CutEdges<3>> cut_;
  Imprint imprint_;
};

/// A loop as it reads from either side: of all beginnings and both ways the least.
Loop canonical(const Loop& loop) {
  const int least = *std::min_element(loop.begin(), loop.end());
  Loop best;
  for (Loop way : {loop, Loop(loop.rbegin(), loop.rend())})
    for (std::size_t k = 0; k < way.size(); ++k) {
      if (way[k] != least) continue;
      Loop turned(way.begin() + static_cast<std::ptrdiff_t>(k), way.end());
      turned.insert(turned.end(), way.begin(), way.begin() + static_cast<std::ptrdiff_t>(k));
      if (best.empty() || turned < best) best = std::move(turned);
    }
  return best;
}

void pair_cells(Imprint& imprint) {
  std::map<std::vector<Loop>, Loop> of_border;
  for (int c = 0; c < static_cast<int>(imprint.cells.size()); ++c) {
    std::vector<Loop> border{canonical(imprint.cells[c].outer)};
    for (const auto& hole : imprint.cells[c].holes) border.push_back(canonical(hole));
    std::sort(border.begin() + 1, border.end());
    of_border[border].push_back(c);
  }
  imprint.other.assign(imprint.cells.size(), -1);
  for (const auto& [border, cells] : of_border) {
    if (cells.size() == 2 && imprint.cells[cells[0]].stone != imprint.cells[cells[1]].stone) {
      imprint.other[cells[0]] = cells[1];
      imprint.other[cells[1]] = cells[0];
    } else if (cells.size() > 1) {
      imprint.faults.crowded.push_back(cells[0]);
    }
  }
  for (int c = 0; c < static_cast<int>(imprint.cells.size()); ++c)
    if (imprint.cells[c].joint >= 0 && imprint.other[c] < 0) imprint.faults.lonely.push_back(c);
}

/// Every edge of a closed surface is there once each way. Finds those that are not, and the shortest of all.
void look_at_edges(Imprint& imprint) {
  std::map<std::array<int, 3>, int> uses;  // stone, from, to
  imprint.shortest_edge = std::numeric_limits<double>::infinity();
  for (const auto& cell : imprint.cells) {
    auto loops = cell.holes;
    loops.push_back(cell.outer);
    for (const auto& loop : loops)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const int a = loop[k], b = loop[(k + 1) % loop.size()];
        ++uses[{cell.stone, a, b}];
        imprint.shortest_edge = std::min(imprint.shortest_edge, norm(imprint.points[b] - imprint.points[a]));
      }
  }
  std::map<int, int> open;  // per stone a point of an edge
  for (const auto& [edge, number] : uses) {
    const auto back = uses.find({edge[0], edge[2], edge[1]});
    if (number != 1 || back == uses.end() || back->second != 1) open.emplace(edge[0], edge[1]);
  }
  for (const auto& [stone, point] : open) imprint.faults.open_stones.push_back({stone, point});
}

}  // namespace

Imprint imprinted(const std::vector<FacetedStone>& stones, const StoneJoints& joints, double weld) {
  Imprint imprint = Imprinting(stones, joints, weld).run();
  pair_cells(imprint);
  look_at_edges(imprint);
  return imprint;
}

std::vector<StoneJoint> welded_joints(Imprint& imprint, const std::vector<FacetedStone>& stones, int first) {
  std::map<std::array<int, 4>, int> known;  // stones and facets
  std::vector<StoneJoint> joints;
  for (int c = 0; c < static_cast<int>(imprint.cells.size()); ++c) {
    const int beside = imprint.other[c];
    if (beside < c) continue;
    auto &cell = imprint.cells[c], &other = imprint.cells[beside];
    if (cell.joint >= 0 || other.joint >= 0) continue;
    const auto& facet = stones[cell.stone].facets[cell.facet];
    const auto& opposite = stones[other.stone].facets[other.facet];
    const auto [at, is_new] =
        known.insert({{cell.stone, other.stone, cell.facet, other.facet}, static_cast<int>(joints.size())});
    if (is_new)
      joints.push_back({{cell.stone, other.stone}, {cell.facet, other.facet}, facet.normal, {}, 0, 0, 0, true});
    auto& joint = joints[at->second];
    double opening = 0;
    for (const int point : cell.outer) {
      const auto& x = imprint.points[point];
      const double apart = dot(x - facet.centre, facet.normal) + dot(x - opposite.centre, opposite.normal);
      opening += apart / static_cast<double>(cell.outer.size());
      joint.farthest = std::max(joint.farthest, std::abs(apart));
    }
    joint.opening = (joint.opening * joint.area + opening * cell.area) / (joint.area + cell.area);
    joint.area += cell.area;
    cell.joint = other.joint = first + at->second;
  }
  return joints;
}

}  // namespace voussoir

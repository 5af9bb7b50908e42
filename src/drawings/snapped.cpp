#include "drawings/snapped.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/sort_unique.hpp"
#include "mesh/border.hpp"
#include "mesh/box_tree.hpp"
#include "stones/cut_edges.hpp"
#include "stones/drawing.hpp"
#include "stones/welded_points.hpp"

namespace voussoir {
namespace {

using Loop = std::vector<int>;
using Kind = SnapFault::Kind;

/// A stone on one side of an edge.
struct Side {
  int stone = 0;
  bool forth = false;  ///< the edge goes from its lower to its higher point with the stone to its left
};

class Snapping {
 public:
  Snapping(const std::vector<OutlinedStone>& stones, double snap, double reach)
      : stones_(stones), snap_(snap), reach_(reach) {}

  SnappedStones run() {
    weld();
    cut();
    collect_edges();
    find_shared_sides();
    if (s_.faults.empty()) find_crossings();
    if (s_.faults.empty()) find_stones_in_stones();
    if (s_.faults.empty()) find_gaps();
    return std::move(s_);
  }

 private:
  /// Which corners are one is told by the first of them, where they then lie by their mean: it moves each the least,
  /// and evens out what a survey has of error.
  void weld() {
    WeldedPoints<2> welded(snap_);
    std::vector<double> count;
    for (const auto& stone : stones_) {
      s_.drawn.emplace_back();
      for (const auto& loop : stone.loops) {
        s_.drawn.back().emplace_back();
        for (std::size_t k = 0; k < loop.corners.size(); ++k) {
          const int point = welded.add(loop.corners[k]);
          if (point == static_cast<int>(count.size())) {
            count.push_back(0);
            s_.points.push_back({0, 0});
            s_.turns.push_back(0);
          }
          ++count[point];
          s_.points[point] = s_.points[point] + (loop.corners[k] - welded.points()[point]);
          if (!loop.curved[k]) s_.turns[point] = 1;
          s_.drawn.back().back().push_back(point);
          ++s_.corners;
        }
      }
    }
    for (std::size_t p = 0; p < count.size(); ++p) s_.points[p] = welded.points()[p] + (1 / count[p]) * s_.points[p];
    for (std::size_t k = 0; k < stones_.size(); ++k)
      for (std::size_t l = 0; l < stones_[k].loops.size(); ++l)
        for (std::size_t c = 0; c < s_.drawn[k][l].size(); ++c) {
          const auto& from = stones_[k].loops[l].corners[c];
          tell_move(norm(s_.points[s_.drawn[k][l][c]] - from), static_cast<int>(k), from);
        }
  }

  void tell_move(double distance, int stone, const Vector<2>& from) {
    if (distance > s_.farthest) s_.farthest = distance, s_.moved_stone = stone, s_.moved_from = from;
  }

  void cut() {
    CutEdges<2> edges(s_.points, snap_);
    for (std::size_t k = 0; k < stones_.size(); ++k) {
      s_.loops.emplace_back();
      for (auto& corners : s_.drawn[k]) {
        const std::size_t before = corners.size();
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
        s_.dropped += static_cast<int>(before - corners.size());
        Loop loop = corners.size() < 3 ? Loop{} : edges.around(corners);
        if (loop.empty()) {
          s_.faults.push_back({Kind::sliver, static_cast<int>(k), -1, middle_of(stones_[k]), snap_});
        } else {
          look_at_loop(static_cast<int>(k), corners, loop);
        }
        s_.loops.back().push_back(std::move(loop));
      }
    }
  }

  /// A loop that comes by a point twice has a neck or a spike narrower than the tolerance.
  void look_at_loop(int stone, const Loop& corners, const Loop& loop) {
    auto sorted = loop;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    const std::set<int> own(corners.begin(), corners.end());
    const auto lost = std::find_if(corners.begin(), corners.end(),
                                   [&](int c) { return !std::binary_search(sorted.begin(), sorted.end(), c); });
    if (twice != sorted.end() || lost != corners.end())
      s_.faults.push_back({Kind::sliver, stone, -1, s_.points[lost != corners.end() ? *lost : *twice], snap_});
    int from = corners[0];
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (own.count(loop[k]) > 0) {
        from = loop[k];
        continue;
      }
      ++s_.cuts;
      std::size_t end = k;
      while (own.count(loop[end % loop.size()]) == 0 && end < k + loop.size()) ++end;
      const auto &a = s_.points[from], &b = s_.points[loop[end % loop.size()]], &x = s_.points[loop[k]];
      if (norm(b - a) > 0) {
        const auto foot = a + (dot(x - a, b - a) / dot(b - a, b - a)) * (b - a);
        tell_move(norm(x - foot), stone, foot);
      }
    }
  }

  void collect_edges() {
    for (std::size_t k = 0; k < s_.loops.size(); ++k)
      for (const auto& loop : s_.loops[k])
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const int a = loop[i], b = loop[(i + 1) % loop.size()];
          sides_[std::minmax(a, b)].push_back({static_cast<int>(k), a < b});
        }
  }

  Vector<2> middle(const std::pair<int, int>& edge) const {
    return 0.5 * (s_.points[edge.first] + s_.points[edge.second]);
  }

  void find_shared_sides() {
    std::set<std::array<int, 2>> told;
    for (const auto& [edge, sides] : sides_)
      for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          const int one = std::min(sides[i].stone, sides[j].stone), other = std::max(sides[i].stone, sides[j].stone);
          if (one == other) {
            if (told.insert({one, one}).second) s_.faults.push_back({Kind::sliver, one, -1, middle(edge), snap_});
          } else if (sides[i].forth == sides[j].forth) {
            if (told.insert({one, other}).second) add_overlap(one, other, middle(edge));
          } else if (sides.size() == 2) {
            s_.joints.push_back({one, other});
            s_.joint_length += norm(s_.points[edge.second] - s_.points[edge.first]);
          }
        }
    sort_unique(s_.joints);
  }

  /// The points of a stone, whatever their order.
  std::vector<int> points_of(int stone) const {
    std::vector<int> points;
    for (const auto& loop : s_.loops[stone]) points.insert(points.end(), loop.begin(), loop.end());
    sort_unique(points);
    return points;
  }

  void add_overlap(int one, int other, Vector<2> place) {
    const double depth = depth_of_overlap(stones_[one], stones_[other], place);
    const bool same = points_of(one) == points_of(other);
    s_.faults.push_back({same ? Kind::twice : Kind::overlap, one, other, place, same ? 0 : depth});
  }

  void find_crossings() {
    Drawing2 drawing;
    drawing.points = s_.points;
    std::vector<int> stone;
    for (const auto& [edge, sides] : sides_) {
      drawing.edges.push_back({edge.first, edge.second});
      stone.push_back(sides[0].stone);
    }
    std::set<std::array<int, 2>> told;
    for (const auto& [e, f] : crossings_of(drawing)) {
      const int one = std::min(stone[e], stone[f]), other = std::max(stone[e], stone[f]);
      if (!told.insert({one, other}).second) continue;
      const Vector<2> place = s_.points[drawing.edges[e][0]];
      if (one == other)
        s_.faults.push_back({Kind::crossing, one, -1, place, 0});
      else
        add_overlap(one, other, place);
    }
  }

  std::vector<Polygon> polygons_of(int stone) const {
    std::vector<Polygon> loops;
    for (const auto& loop : s_.loops[stone]) {
      loops.emplace_back();
      for (const int p : loop) loops.back().push_back(s_.points[p]);
    }
    return loops;
  }

  std::vector<Box<2>> boxes_of_stones(double wider) const {
    std::vector<Box<2>> boxes;
    for (const auto& loops : s_.loops) {
      Box<2> box{s_.points[loops[0][0]], s_.points[loops[0][0]]};
      for (const int p : loops[0]) box.add({s_.points[p], s_.points[p]});
      for (std::size_t i = 0; i < 2; ++i) box.low[i] -= wider, box.high[i] += wider;
      boxes.push_back(box);
    }
    return boxes;
  }

  /// Where no edges cross and none has two stones on one side, a stone lies in another with a point inside of it.
  void find_stones_in_stones() {
    const BoxTree<2> tree(boxes_of_stones(0));
    for (int k = 0; k < static_cast<int>(stones_.size()); ++k) {
      const Vector<2> inside = point_inside(polygons_of(k));
      tree.visit_overlaps({inside, inside}, [&](int other) {
        if (other == k) return;
        bool within = false;
        for (const auto& loop : polygons_of(other)) within = within != holds(loop, inside);
        if (within) add_overlap(std::min(k, other), std::max(k, other), inside);
      });
    }
  }

  /// Points of free edges that are near free edges of another stone, which has no such point.
  void find_gaps() {
    std::vector<std::pair<int, int>> edges;
    std::vector<int> stone;
    std::vector<Box<2>> boxes;
    std::set<std::pair<int, int>> points;  // point, stone
    for (const auto& [edge, sides] : sides_) {
      if (sides.size() != 1) continue;
      edges.push_back(edge);
      stone.push_back(sides[0].stone);
      boxes.push_back({s_.points[edge.first], s_.points[edge.first]});
      boxes.back().add({s_.points[edge.second], s_.points[edge.second]});
      for (const int p : {edge.first, edge.second}) points.insert({p, stone.back()});
    }
    const BoxTree<2> tree(boxes);
    std::map<std::array<int, 2>, SnapFault> widest;
    for (const auto& [p, of] : points) {
      const auto& x = s_.points[p];
      Box<2> around{x, x};
      for (std::size_t i = 0; i < 2; ++i) around.low[i] -= reach_, around.high[i] += reach_;
      tree.visit_overlaps(around, [&, point = p, own = of](int e) {
        if (stone[e] == own) return;
        const auto &a = s_.points[edges[e].first], &b = s_.points[edges[e].second];
        const auto along = b - a;
        const double part = std::clamp(dot(x - a, along) / dot(along, along), 0.0, 1.0);
        const double gap = norm(x - a - part * along);
        if (gap > reach_ || is_meant(point, own, stone[e], gap)) return;
        auto& known = widest[{std::min(own, stone[e]), std::max(own, stone[e])}];
        if (known.size == 0 || gap < known.size) known = {Kind::gap, own, stone[e], x, gap};
      });
    }
    for (const auto& [pair, fault] : widest) s_.faults.push_back(fault);
  }

  /// Whether a gap between a point of one stone and another stone opens from a corner they have in common.
  bool is_meant(int point, int own, int other, double gap) {
    const auto &mine = points_by_stone(own), &theirs = points_by_stone(other);
    if (std::binary_search(theirs.begin(), theirs.end(), point)) return true;
    for (const int p : mine)
      if (std::binary_search(theirs.begin(), theirs.end(), p) &&
          gap > nearly_touching_at_vertex * norm(s_.points[p] - s_.points[point]))
        return true;
    return false;
  }

  const std::vector<int>& points_by_stone(int stone) {
    const auto [known, is_new] = points_of_.emplace(stone, std::vector<int>{});
    if (is_new) known->second = points_of(stone);
    return known->second;
  }

  const std::vector<OutlinedStone>& stones_;
  double snap_, reach_;
  SnappedStones s_;
  std::map<std::pair<int, int>, std::vector<Side>> sides_;  ///< of each edge
  std::map<int, std::vector<int>> points_of_;               ///< ascending
};

}  // namespace

SnappedStones snapped(const std::vector<OutlinedStone>& stones, double snap, double reach) {
  return Snapping(stones, snap, reach).run();
}

}  // namespace voussoir

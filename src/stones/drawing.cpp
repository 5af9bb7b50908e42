#include "stones/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/sort_unique.hpp"
#include "mesh/box_tree.hpp"

namespace voussoir {
namespace {

using Loop = std::vector<int>;

/// Takes out, again and again, edges with an end where no other begins.
void prune(Drawing2& drawing) {
  for (bool changed = true; changed;) {
    std::vector<int> uses(drawing.points.size(), 0);
    for (const auto& e : drawing.edges) ++uses[e[0]], ++uses[e[1]];
    const auto hangs = [&](const std::array<int, 2>& e) { return uses[e[0]] == 1 || uses[e[1]] == 1; };
    const auto end = std::remove_if(drawing.edges.begin(), drawing.edges.end(), hangs);
    changed = end != drawing.edges.end();
    drawing.edges.erase(end, drawing.edges.end());
  }
}

Polygon polygon_of(const Drawing2& drawing, const Loop& loop) {
  Polygon polygon;
  for (const int p : loop) polygon.push_back(drawing.points[p]);
  return polygon;
}

/// Loops with one cell to the left of each: from an edge go on to the next one clockwise about its end.
std::vector<Loop> loops_of(const Drawing2& drawing) {
  std::vector<std::vector<std::pair<double, int>>> around(drawing.points.size());  // angle, other end
  for (const auto& e : drawing.edges)
    for (const auto& [a, b] : {std::pair<int, int>{e[0], e[1]}, {e[1], e[0]}}) {
      const auto along = drawing.points[b] - drawing.points[a];
      around[a].emplace_back(std::atan2(along[1], along[0]), b);
    }
  for (auto& list : around) std::sort(list.begin(), list.end());
  const auto next = [&](int a, int b) {
    const auto& list = around[b];
    const auto back = std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.second == a; });
    return (back == list.begin() ? list.end() - 1 : back - 1)->second;
  };
  std::vector<Loop> loops;
  std::set<std::pair<int, int>> gone;
  for (int a = 0; a < static_cast<int>(around.size()); ++a)
    for (const auto& entry : around[a]) {
      int from = a, to = entry.second;
      Loop loop;
      while (gone.insert({from, to}).second) {
        loop.push_back(from);
        from = std::exchange(to, next(from, to));
      }
      if (!loop.empty()) loops.push_back(std::move(loop));
    }
  return loops;
}

}  // namespace

Vector<2> point_inside(const std::vector<Polygon>& loops) {
  std::vector<double> levels;
  for (const auto& loop : loops)
    for (const auto& p : loop) levels.push_back(p[1]);
  sort_unique(levels);
  Vector<2> best{};
  double widest = -1;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const double level = levels[k] + (levels[k + 1] - levels[k]) / 2;
    std::vector<double> at;
    for (const auto& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto &a = loop[i], &b = loop[(i + 1) % loop.size()];
        if ((a[1] > level) != (b[1] > level)) at.push_back(a[0] + (level - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
      }
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      const double width = std::min(at[i + 1] - at[i], levels[k + 1] - levels[k]);
      if (width > widest) widest = width, best = {(at[i] + at[i + 1]) / 2, level};
    }
  }
  return best;
}

std::vector<DrawnCell> cells_of(Drawing2 drawing) {
  prune(drawing);
  DisjointSets parts(drawing.points.size());
  for (const auto& e : drawing.edges) parts.unite(e[0], e[1]);
  std::vector<DrawnCell> cells;
  std::vector<Loop> outsides;  // of parts of the drawing that hang together, each seen from around it
  for (auto& loop : loops_of(drawing)) {
    const double inside = area(polygon_of(drawing, loop));
    if (inside > 0)
      cells.push_back({std::move(loop), {}, inside, {}});
    else
      outsides.push_back(std::move(loop));
  }
  for (auto& hole : outsides) {
    const int part = parts.root(hole[0]);
    DrawnCell* holder = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (auto& cell : cells) {
      if (parts.root(cell.outer[0]) == part) continue;
      const Polygon outer = polygon_of(drawing, cell.outer);
      if (const double size = area(outer); size < least && holds(outer, drawing.points[hole[0]]))
        holder = &cell, least = size;
    }
    if (!holder) continue;
    holder->area += area(polygon_of(drawing, hole));
    holder->holes.push_back(std::move(hole));
  }
  for (auto& cell : cells) {
    std::vector<Polygon> loops{polygon_of(drawing, cell.outer)};
    for (const auto& hole : cell.holes) loops.push_back(polygon_of(drawing, hole));
    cell.inside = point_inside(loops);
  }
  return cells;
}

std::vector<std::array<int, 2>> crossings_of(const Drawing2& drawing) {
  std::vector<std::array<int, 2>> pairs;
  const auto turn = [&](int a, int b, int c) {
    return cross(drawing.points[b] - drawing.points[a], drawing.points[c] - drawing.points[a]);
  };
  std::vector<Box<2>> boxes;
  for (const auto& e : drawing.edges) {
    boxes.push_back({drawing.points[e[0]], drawing.points[e[0]]});
    boxes.back().add({drawing.points[e[1]], drawing.points[e[1]]});
  }
  const BoxTree<2> tree(boxes);
  for (int i = 0; i < static_cast<int>(drawing.edges.size()); ++i)
    tree.visit_overlaps(boxes[i], [&](int j) {
      const auto [a, b] = drawing.edges[i];
      const auto [c, d] = drawing.edges[j];
      if (j >= i || a == c || a == d || b == c || b == d) return;
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) pairs.push_back({j, i});
    });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

int winding(const Polygon& points, const std::vector<std::array<int, 2>>& edges, const Vector<2>& at) {
  int turns = 0;
  for (const auto& e : edges) {
    const auto &a = points[e[0]], &b = points[e[1]];
    if ((a[1] > at[1]) != (b[1] > at[1]) && at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      turns += b[1] > a[1] ? 1 : -1;
  }
  return turns;
}

}  // namespace voussoir

#include "stones/box_cuts.hpp"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.hpp"

namespace voussoir {
namespace {

/// More cuts in a direction come from a bond without order: then tetrahedra have fewer cells.
constexpr std::size_t most_cuts = 40;

/// The only direction in which two places of a box differ, or -1.
int direction_of(const Vector<3>& a, const Vector<3>& b, const CutBox& box) {
  int found = -1;
  for (int d = 0; d < 3; ++d) {
    if (std::abs(a[d] - b[d]) <= box.cuts[d].same) continue;
    if (found >= 0) return -1;
    found = d;
  }
  return found;
}

/// A number for each interval between cuts: of a stone and direction from the first on.
struct Intervals {
  std::vector<std::array<int, 3>> first;
  int count = 0;

  explicit Intervals(const std::vector<std::optional<CutBox>>& boxes) : first(boxes.size()) {
    for (std::size_t k = 0; k < boxes.size(); ++k)
      for (int d = 0; d < 3 && boxes[k]; ++d) {
        first[k][d] = count;
        count += static_cast<int>(boxes[k]->cuts[d].at.size()) - 1;
      }
  }
};

}  // namespace

std::size_t Cuts::find(double value) const {
  for (std::size_t k = 0; k < at.size(); ++k)
    if (std::abs(at[k] - value) <= same) return k;
  return at.size();
}

bool Cuts::add(double value) {
  if (find(value) < at.size()) return false;
  at.insert(std::upper_bound(at.begin(), at.end(), value), value);
  return true;
}

BoxCuts::BoxCuts(const StoneStructure& s) : s_(s), box_(s.stones.size()) {
  for (int k = 0; k < static_cast<int>(box_.size()); ++k) {
    const auto shape = box_shape(s, k);
    if (!shape) continue;
    box_[k] = CutBox{*shape, {}};
    for (int d = 0; d < 3; ++d) box_[k]->cuts[d].same = 2 * s.weld / shape->length(d);
  }
  for (const auto& cell : s.imprint.cells)
    if (box_[cell.stone] && !cut_by(cell)) box_[cell.stone].reset();
  leave_out();
  for (int c = 0; c < static_cast<int>(s.imprint.cells.size()); ++c)
    if (s.imprint.other[c] > c && box_[s.imprint.cells[c].stone]) add_joint(c);
  spread();
  leave_out();
}

/// Adds the cuts that a cell of a face makes; false when one of its edges is along no direction of the box.
bool BoxCuts::cut_by(const ImprintedCell& cell) {
  CutBox& box = *box_[cell.stone];
  auto loops = cell.holes;
  loops.push_back(cell.outer);
  for (const auto& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto a = box.shape.where(s_.imprint.points[loop[k]]);
      const auto b = box.shape.where(s_.imprint.points[loop[(k + 1) % loop.size()]]);
      if (direction_of(a, b, box) < 0) return false;
      for (int d = 0; d < 3; ++d) box.cuts[d].add(a[d]);
    }
  return true;
}

/// For each direction of the first stone in a joint its longest edge.
void BoxCuts::add_joint(int c) {
  const auto &mine = s_.imprint.cells[c], &its = s_.imprint.cells[s_.imprint.other[c]];
  const CutBox &a = *box_[mine.stone], &b = *box_[its.stone];
  std::array<std::optional<Along>, 3> found;
  std::array<double, 3> longest{};
  for (std::size_t k = 0; k < mine.outer.size(); ++k) {
    const auto &x = s_.imprint.points[mine.outer[k]], &y = s_.imprint.points[mine.outer[(k + 1) % mine.outer.size()]];
    const auto ax = a.shape.where(x), ay = a.shape.where(y), bx = b.shape.where(x), by = b.shape.where(y);
    const int d = direction_of(ax, ay, a), e = direction_of(bx, by, b);
    if (d < 0 || e < 0 || norm(y - x) <= longest[d]) continue;
    longest[d] = norm(y - x);
    found[d] = Along{{mine.stone, its.stone}, {d, e}, {ax[d], bx[e]}, {ay[d], by[e]}, {1, 1}, {0, 0}};
  }
  for (auto& along : found) {
    if (!along) continue;
    for (int side = 0; side < 2; ++side)
      for (const int point : mine.outer) {
        const double value = box_[along->stone[side]]->shape.where(s_.imprint.points[point])[along->direction[side]];
        along->low[side] = std::min(along->low[side], value);
        along->high[side] = std::max(along->high[side], value);
      }
    along_.push_back(*along);
  }
}

/// Every cut goes on in the stones beyond joints, until nothing is new.
void BoxCuts::spread() {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& a : along_)
      for (int side = 0; side < 2; ++side) {
        if (!box_[a.stone[0]] || !box_[a.stone[1]]) continue;
        const auto values = box_[a.stone[side]]->cuts[a.direction[side]].at;
        auto& cuts = box_[a.stone[1 - side]]->cuts[a.direction[1 - side]];
        for (const double value : values)
          if (value > a.low[side] && value < a.high[side] && cuts.add(a.across(side, value))) changed = true;
        if (cuts.at.size() > most_cuts) box_[a.stone[0]].reset(), box_[a.stone[1]].reset();
      }
  }
}

/// What touches a stone that gets no hexahedra gets none either.
void BoxCuts::leave_out() {
  for (bool changed = true; changed;) {
    changed = false;
    for (int c = 0; c < static_cast<int>(s_.imprint.cells.size()); ++c) {
      if (s_.imprint.other[c] < 0) continue;
      auto& box = box_[s_.imprint.cells[c].stone];
      if (!box || box_[s_.imprint.cells[s_.imprint.other[c]].stone]) continue;
      box.reset();
      changed = true;
    }
  }
}

std::vector<std::array<std::vector<int>, 3>> BoxCuts::cells() const {
  const Intervals intervals(box_);
  DisjointSets alike(static_cast<std::size_t>(intervals.count));
  for (const auto& a : along_) {
    if (!box_[a.stone[0]]) continue;
    const auto &mine = box_[a.stone[0]]->cuts[a.direction[0]], &its = box_[a.stone[1]]->cuts[a.direction[1]];
    for (std::size_t k = 0; k + 1 < mine.at.size(); ++k) {
      if (mine.at[k] < a.low[0] - mine.same || mine.at[k + 1] > a.high[0] + mine.same) continue;
      const auto i = its.find(a.across(0, mine.at[k])), j = its.find(a.across(0, mine.at[k + 1]));
      if (i < its.at.size() && j < its.at.size())
        alike.unite(intervals.first[a.stone[0]][a.direction[0]] + static_cast<int>(k),
                    intervals.first[a.stone[1]][a.direction[1]] + static_cast<int>(std::min(i, j)));
    }
  }
  std::vector<int> number(static_cast<std::size_t>(intervals.count), 1);
  std::vector<std::array<std::vector<int>, 3>> result(box_.size());
  for (const bool counting : {true, false})
    for (std::size_t k = 0; k < box_.size(); ++k)
      for (int d = 0; d < 3 && box_[k]; ++d) {
        const auto& at = box_[k]->cuts[d].at;
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
          int& cells = number[alike.root(intervals.first[k][d] + static_cast<int>(i))];
          const double length = (at[i + 1] - at[i]) * box_[k]->shape.length(d);
          if (counting)
            cells = std::max(cells, static_cast<int>(std::ceil(length / s_.hexahedron_size - 1e-9)));
          else
            result[k][d].push_back(cells);
        }
      }
  return result;
}

}  // namespace voussoir

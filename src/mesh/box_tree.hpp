// Which of many boxes overlap a given one, in logarithmic time, also on strongly graded meshes.
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

template <int dim>
struct Box {
  Vector<dim> low, high;

  bool overlaps(const Box& other) const {
    for (int i = 0; i < dim; ++i)
      if (low[i] > other.high[i] || high[i] < other.low[i]) return false;
    return true;
  }
  void add(const Box& other) {
    for (int i = 0; i < dim; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
};

/// A box that is larger on all sides.
template <int dim>
Box<dim> widened(Box<dim> box, double by) {
  for (int i = 0; i < dim; ++i) {
    box.low[i] -= by;
    box.high[i] += by;
  }
  return box;
}

/// Binary tree of bounding boxes, halved at the median of the longer side.
template <int dim>
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box<dim>> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!boxes_.empty()) build(0, 0, static_cast<int>(order_.size()));
  }

  /// Calls `visit(i)` for every box i that overlaps or touches `box`.
  template <class Visit>
  void visit_overlaps(const Box<dim>& box, Visit visit) const {
    if (!boxes_.empty()) search(0, 0, static_cast<int>(order_.size()), box, visit);
  }

 private:
  static constexpr int leaf = 8;  // boxes: fewer make the tree deeper, more the leaves slower; flat between 4 and 16

  void build(std::size_t branch, int from, int to) {
    if (bounds_.size() <= branch) bounds_.resize(branch + 1);
    Box<dim> bounds = boxes_[order_[from]];
    for (int i = from; i < to; ++i) bounds.add(boxes_[order_[i]]);
    bounds_[branch] = bounds;
    if (to - from <= leaf) return;
    int axis = 0;
    for (int i = 1; i < dim; ++i)
      if (bounds.high[i] - bounds.low[i] > bounds.high[axis] - bounds.low[axis]) axis = i;
    const int middle = (from + to) / 2;
    std::nth_element(order_.begin() + from, order_.begin() + middle, order_.begin() + to, [this, axis](int a, int b) {
      return boxes_[a].low[axis] + boxes_[a].high[axis] < boxes_[b].low[axis] + boxes_[b].high[axis];
    });
    build(2 * branch + 1, from, middle);
    build(2 * branch + 2, middle, to);
  }

  template <class Visit>
  void search(std::size_t branch, int from, int to, const Box<dim>& box, Visit& visit) const {
    if (!bounds_[branch].overlaps(box)) return;
    if (to - from <= leaf) {
      for (int i = from; i < to; ++i)
        if (boxes_[order_[i]].overlaps(box)) visit(order_[i]);
      return;
    }
    const int middle = (from + to) / 2;
    search(2 * branch + 1, from, middle, box, visit);
    search(2 * branch + 2, middle, to, box, visit);
  }

  std::vector<Box<dim>> boxes_;
  std::vector<int> order_;
  std::vector<Box<dim>> bounds_;  ///< children of branch b are 2 b + 1 and 2 b + 2
};

}  // namespace voussoir

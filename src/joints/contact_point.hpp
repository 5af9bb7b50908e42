// A contact point: a place with axes and an area, and on either side a short list of nodes with weights.
//
// The weights of a side sum to one: they say whose motion is that of the side, and who bears how much of the point's
// force. Where meshes match a side is one node of weight one, which takes no room on the heap.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "base/ids.hpp"
#include "base/plane_and_space.hpp"

namespace voussoir {

struct NodeShare {
  int node = 0;
  double weight = 1;
};

/// The nodes of one side.
class PointSide {
 public:
  explicit PointSide(int node = 0) : alone_{node, 1.0} {}
  explicit PointSide(std::vector<NodeShare> shares) : alone_(shares.front()) {
    if (shares.size() > 1) more_ = std::make_shared<const std::vector<NodeShare>>(std::move(shares));
  }
  const NodeShare* begin() const { return more_ ? more_->data() : &alone_; }
  const NodeShare* end() const { return more_ ? more_->data() + more_->size() : &alone_ + 1; }
  bool is_one() const { return !more_; }
  int first() const { return alone_.node; }
  /// The same of nodes whose numbers are higher.
  PointSide from(int first_node) const {
    if (is_one()) return PointSide(alone_.node + first_node);
    std::vector<NodeShare> shares(begin(), end());
    for (auto& share : shares) share.node += first_node;
    return PointSide(std::move(shares));
  }

 private:
  NodeShare alone_;  ///< the first of them
  std::shared_ptr<const std::vector<NodeShare>> more_;
};

struct ContactPoint {
  PointId id = 0;                   ///< the same for any number of ranks: ordered by block i, block j, place
  PointSide shares_i, shares_j;     ///< local nodes of block i and of block j: point_operator.hpp is the door to them
  int joint = 0;                    ///< local number of the joint
  bool coincident = true;           ///< one node on either side, at one place
  double area = 0;                  ///< [m2] share of the joint, thickness included
  Vector<3> place{};                ///< [m] as drawn
  std::array<Vector<3>, 3> axis{};  ///< [0] normal, then tangents; orthonormal, right-handed

  /// Else it is always selected, since no unknown stands for both sides.
  bool can_be_tied() const { return coincident; }
};

/// A point as it is found between two blocks: with the nodes' numbers within each block.
struct FoundPoint {
  PointSide shares_i, shares_j;
  Vector<3> place{};   ///< [m]
  Vector<3> normal{};  ///< unit, outward of block i
  double extent = 0;   ///< [m] in the plane, [m2] in space
  bool coincident = true;
};

}  // namespace voussoir

// Joints that stand open where the drawing shows them closed.
#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include "model/model.hpp"

namespace voussoir {

/// Of joints of this rank's points: by that much [m] their stones, lower number first, may lie in each other as drawn.
class GapsAsDrawn {
 public:
  explicit GapsAsDrawn(const Model& model) {
    const auto& points = model.points();
    const auto& gap = model.initial_gap();
    for (int k = 0; k < points.owned() && !gap.empty(); ++k) {
      if (!(gap[k] > 0)) continue;
      auto& known = of_joint_[{points.joint_of(k).block_i, points.joint_of(k).block_j}];
      known = std::max(known, gap[k]);
    }
  }
  double between(BlockId i, BlockId j) const {
    const auto found = of_joint_.find({i, j});
    return found == of_joint_.end() ? 0.0 : found->second;
  }

 private:
  std::map<std::pair<BlockId, BlockId>, double> of_joint_;
};

}  // namespace voussoir

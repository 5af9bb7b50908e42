#include "range/plane/measures.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "linalg/reduce.hpp"
#include "range/plane/slip_range.hpp"
#include "range/plane/stone_overlap.hpp"
#include "range/plane/stone_places.hpp"
#include "range/turn_range.hpp"

namespace voussoir {
namespace {

/// What is measured once, of this rank's owned blocks and joints and of the whole.
struct Sizes {
  std::vector<double> shortest_side;  ///< [m] per owned block, of its cells
  double smallest_side = 0;           ///< [m] of the structure
  double smallest_half_joint = 0;     ///< [m] of the structure

  /// Collective.
  explicit Sizes(const PlaneModel& model) {
    const auto& s = model.structure();
    double side = INFINITY, half = INFINITY;
    for (int b = 0; b < s.owned_blocks(); ++b) {
      const auto& block = s.blocks()[b];
      shortest_side.push_back(voussoir::shortest_side(block.mesh.cells, &s.drawn_position()[block.first_local]));
      side = std::min(side, shortest_side.back());
    }
    std::vector<double> length(model.points().joints().size(), 0.0);
    for (int k = 0; k < model.points().owned(); ++k)
      length[model.points().points()[k].joint] +=
          model.points().points()[k].area / model.points().joints()[model.points().points()[k].joint].thickness;
    for (const double l : length)
      if (l > 0) half = std::min(half, l / 2);
    smallest_side = least_over_ranks(*s.comm(), side);
    smallest_half_joint = least_over_ranks(*s.comm(), half);
  }
};

}  // namespace

std::vector<RangeMeasure> measures_in_plane(const PlaneModel& model) {
  const auto known = std::make_shared<std::unique_ptr<const Sizes>>();
  const auto sizes = [&model, known]() -> const Sizes& {
    if (!*known) *known = std::make_unique<const Sizes>(model);
    return **known;
  };
  return {[&model](const StepEnd& end) { return look_at_slips(model, end); },
          [&model, sizes](const StepEnd& end) { return look_at_turns(model, end, sizes().smallest_half_joint); },
          [&model, sizes](const StepEnd& end) {
            if (!end.outlines) return RangeFindings{};
            return look_at_outlines(model, end, sizes().shortest_side, sizes().smallest_side);
          }};
}

}  // namespace voussoir

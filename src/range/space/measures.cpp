#include "range/space/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "linalg/reduce.hpp"
#include "range/space/overlap_in_space.hpp"
#include "range/space/slip_in_space.hpp"
#include "range/turn_range.hpp"

namespace voussoir {
namespace {

/// What is measured once, of the whole structure.
struct Sizes {
  double smallest_side = std::numeric_limits<double>::infinity();        ///< [m] of a cell
  double smallest_half_joint = std::numeric_limits<double>::infinity();  ///< [m] of the square that is as large

  /// Collective.
  explicit Sizes(const SpaceModel& model) {
    const auto& s = model.structure();
    for (int b = 0; b < s.owned_blocks(); ++b)
      for (const auto& cell : s.blocks()[b].mesh.cells)
        for (int k = 0; k < cell.count; ++k)
          for (int l = 0; l < k; ++l) {
            const auto first = s.blocks()[b].first_local;
            const auto edge = s.drawn_position()[first + cell.node[k]] - s.drawn_position()[first + cell.node[l]];
            smallest_side = std::min(smallest_side, norm(edge));  // diagonals are longer
          }
    const auto& points = model.points();
    std::vector<double> area(points.joints().size(), 0.0);
    for (int k = 0; k < points.owned(); ++k) area[points.points()[k].joint] += points.points()[k].area;
    for (const double a : area)
      if (a > 0) smallest_half_joint = std::min(smallest_half_joint, std::sqrt(a) / 2);
    smallest_side = least_over_ranks(*s.comm(), smallest_side);
    smallest_half_joint = least_over_ranks(*s.comm(), smallest_half_joint);
  }
};

}  // namespace

std::vector<RangeMeasure> measures_in_space(const SpaceModel& model) {
  const auto known = std::make_shared<std::unique_ptr<const Sizes>>();
  const auto sizes = [&model, known]() -> const Sizes& {
    if (!*known) *known = std::make_unique<const Sizes>(model);
    return **known;
  };
  return {[&model](const StepEnd& end) { return look_at_slips(model, end); },
          [&model, sizes](const StepEnd& end) { return look_at_turns(model, end, sizes().smallest_half_joint); },
          [&model, sizes](const StepEnd& end) {
            return end.outlines ? look_at_overlaps(model, end, sizes().smallest_side) : RangeFindings{};
          }};
}

}  // namespace voussoir

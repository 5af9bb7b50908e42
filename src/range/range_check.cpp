#include "range/range_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/check.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "model/phase.hpp"
#include "range/slip_range.hpp"
#include "range/stone_overlap.hpp"
#include "range/stone_places.hpp"
#include "range/turn_range.hpp"

namespace voussoir {

namespace {

std::string digits(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

std::string three_digits(double value) { return digits("%.3g", value); }

std::string place_text(const Vector<2>& x) { return "(" + digits("%.3f", x[0]) + ", " + digits("%.3f", x[1]) + ") m"; }

std::string at_time(const std::string& stage, double seconds) {
  return "stage '" + stage + "', " + digits("%.6g s", seconds);
}

std::string at_factor(const std::string& stage, double factor) {
  return "stage '" + stage + "', " + digits("load factor %.6g", factor);
}

void RangeCheck::measure() {
  const auto& s = model_.structure();
  double side = INFINITY, half = INFINITY;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    sizes_.shortest_side.push_back(shortest_side(block.mesh.cells, &s.drawn_position()[block.first_local]));
    side = std::min(side, sizes_.shortest_side.back());
  }
  std::vector<double> length(model_.points().joints().size(), 0.0);
  for (int k = 0; k < model_.points().owned(); ++k)
    length[model_.points().points()[k].joint] += model_.points().points()[k].area / s.model().thickness;
  for (const double l : length)
    if (l > 0) half = std::min(half, l / 2);
  sizes_.smallest_side = least_over_ranks(*s.comm(), side);
  sizes_.smallest_half_joint = least_over_ranks(*s.comm(), half);
  measured_ = true;
}

std::string RangeCheck::beyond(const StepEnd& end) {
  expect_state(model_, end.state);
  VOUSSOIR_EXPECT(is_of_nodes(model_, end.load) && "load: of node copies");
  VOUSSOIR_EXPECT((end.absent.empty() || end.absent.size() == model_.structure().blocks().size()) &&
                  "absent: per block, or none");
  Phase phase("range");
  if (!measured_) measure();
  RangeFindings found;
  found.add(look_at_slips(model_, end));
  found.add(look_at_turns(model_, end, sizes_.smallest_half_joint));
  if (end.outlines) found.add(look_at_outlines(model_, end, sizes_.shortest_side, sizes_.smallest_side));
  for (const auto& warning : found.warnings) warn_(warning);
  return found.out_of_range;
}

}  // namespace voussoir

#include "simulation/slip_range.hpp"

#include <cmath>

#include "linalg/gather.hpp"
#include "simulation/error_estimate.hpp"
#include "simulation/stone_places.hpp"

namespace voussoir {
namespace {

// Points that carry less than this share of the largest force press as little as what solvers leave.
constexpr double negligible = 1e-6;
// A joint whose force passes to more than a tenth where one of its faces has ended is wrong by that tenth.
constexpr double borne_by_nothing = 0.1;
// A point stands for half a cell on either side: so far beyond the end of a face its force may be one of the face.
constexpr double share_of_a_cell = 0.5;

/// A joint whose points have slipped beyond their cells.
struct LongSlip {
  BlockId block_i, block_j;
  int points;          ///< that have
  double slip, cell;   ///< [m] the longest beside its cell
  double x, y;         ///< [m] where that is
  double uncovered;    ///< [-] share of the force that passes beyond the ends of both faces
  double outside;      ///< [m] how far the resultant passes beyond the end of a face; 0 where it does not
};

/// Points of a joint in their order along it, with the shorter of the edges beside each [m].
std::vector<std::pair<int, double>> along_the_joint(const Model<2>& model, const std::vector<int>& points) {
  const auto& all = model.points().points();
  const auto& x = model.structure().drawn_position();
  const auto& first = x[all[points.front()].node_i];
  Vector<2> far{};  // runs along the joint whatever way its axes have turned
  for (int k : points)
    if (norm(x[all[k].node_i] - first) > norm(far)) far = x[all[k].node_i] - first;
  std::vector<std::pair<double, int>> order;
  for (int k : points) order.push_back({dot(x[all[k].node_i] - first, far), k});
  std::sort(order.begin(), order.end());
  std::vector<std::pair<int, double>> cells;
  for (std::size_t n = 0; n < order.size(); ++n) {
    double cell = INFINITY;
    for (const std::size_t other : {n - 1, n + 1})
      if (other < order.size()) {
        const double edge = norm(x[all[order[n].second].node_i] - x[all[order[other].second].node_i]);
        if (edge > 0) cell = std::min(cell, edge);  // one place has two points where a joint turns a corner
      }
    cells.push_back({order[n].second, cell});
  }
  return cells;
}

/// How a force that acts on nodes of one block lies to the face of the other.
struct Footing {
  double uncovered = 0;  ///< [-] share at nodes beyond the end of the face by more than their cell
  double outside = 0;    ///< [m] of the resultant beyond the end
};

Footing footing_of(const Model<2>& model, const StepEnd& end, const std::vector<std::pair<int, double>>& points,
                   bool of_i) {
  const auto& s = model.structure();
  const auto& u = end.state.displacement;
  const auto node_of = [&](int k, bool i) {
    const auto& p = model.points().points()[k];
    return i ? p.node_i : p.node_j;
  };
  const int other = s.block_of_node()[node_of(points.front().first, !of_i)];
  const auto face = outline_now(s, u, other);
  const auto drawn = outline_now(s, std::vector<double>(u.size(), 0.0), other);
  const auto beyond = [](const Outline& outline, const Vector<2>& x) {
    return inside(outline, x) ? 0.0 : distance_to_border(outline, x);
  };
  Vector<2> place{}, drawn_place{};
  double force = 0, uncovered = 0, mean_cell = 0;
  for (const auto& [k, cell] : points) {
    const double normal = std::max(0.0, end.state.lambda[2 * k]);
    const auto x = place_now(s, u, node_of(k, of_i));
    force += normal;
    place = place + normal * x;
    drawn_place = drawn_place + normal * s.drawn_position()[node_of(k, of_i)];
    mean_cell += normal * cell;
    if (beyond(face, x) > cell) uncovered += normal;
  }
  if (!(force > 0)) return {};
  // Where a joint is not straight the resultant passes beside its faces as it is drawn.
  const double away = beyond(face, (1 / force) * place) - beyond(drawn, (1 / force) * drawn_place);
  return {uncovered / force, away > share_of_a_cell * mean_cell / force ? away : 0.0};
}

std::vector<LongSlip> long_slips(const Model<2>& model, const StepEnd& end) {
  const auto& points = model.points();
  const double least = negligible * largest_normal_force(model, end.state.lambda);
  const auto gap = model.gaps(end.state.displacement, end.state.lambda);
  const auto slip = [&](int k) { return std::abs(gap[2 * k + 1]); };
  const auto presses = [&](int k) { return least > 0 && end.state.lambda[2 * k] > least; };
  const double thickness = model.structure().model().thickness;
  std::vector<LongSlip> found;
  for (int first = 0, last = 0; first < points.owned(); first = last) {
    const int joint = points.points()[first].joint;
    bool far = false;  // by half the length a point stands for: looked at closely
    for (last = first; last < points.owned() && points.points()[last].joint == joint; ++last)
      far |= presses(last) && slip(last) > points.points()[last].area / thickness / 2;
    if (!far) continue;
    std::vector<int> members;
    for (int k = first; k < last; ++k) members.push_back(k);
    const auto cells = along_the_joint(model, members);
    const auto& blocks = points.joints()[joint];
    LongSlip worst{blocks.block_i, blocks.block_j, 0, 0, 0, 0, 0, 0, 0};
    for (const auto& [k, cell] : cells) {
      if (!presses(k) || !(slip(k) > cell)) continue;
      ++worst.points;
      if (slip(k) <= worst.slip) continue;
      const auto x = place_now(model.structure(), end.state.displacement, points.points()[k].node_i);
      worst.slip = slip(k), worst.cell = cell, worst.x = x[0], worst.y = x[1];
    }
    if (worst.points == 0) continue;
    const auto i = footing_of(model, end, cells, true), j = footing_of(model, end, cells, false);
    const auto held = [&](BlockId b) { return is_held(model, model.structure().local_block(b)); };
    worst.uncovered = std::min(i.uncovered, j.uncovered);
    // A stone that a support holds bears a force wherever it acts.
    worst.outside = std::max(held(worst.block_i) ? 0.0 : i.outside, held(worst.block_j) ? 0.0 : j.outside);
    found.push_back(worst);
  }
  return found;
}

}  // namespace

RangeFindings look_at_slips(const Model<2>& model, const StepEnd& end) {
  auto slips = all_gather(long_slips(model, end), *model.structure().comm());
  if (slips.empty()) return {};
  std::sort(slips.begin(), slips.end(), [](const LongSlip& a, const LongSlip& b) {
    return std::make_tuple(-a.slip, a.block_i, a.block_j) < std::make_tuple(-b.slip, b.block_i, b.block_j);
  });
  RangeFindings found;
  const auto& worst = slips.front();
  found.warnings.push_back(
      {"slip_beyond_cell", names_of(model, worst.block_i, worst.block_j), end.when, worst.slip,
       std::to_string(worst.points) + (worst.points == 1 ? " point that presses has" : " points that press have") +
           " slipped by up to " + three_digits(worst.slip) + " m, near " + place_text({worst.x, worst.y}) +
           ", where cells are " + three_digits(worst.cell) +
           " m long: contact stays with the nodes that were drawn together, so forces and margins of this joint are "
           "those of pieces of face that are no longer opposite" + and_in_others(slips.size() - 1)});
  for (const auto& s : slips) {
    if (s.uncovered <= borne_by_nothing && s.outside <= 0) continue;
    const auto where = s.uncovered > borne_by_nothing
                           ? three_digits(100 * s.uncovered) + " % of its force passes beyond the ends of its faces"
                           : "its force passes " + three_digits(s.outside) + " m beyond the end of a face";
    found.out_of_range = "joint " + names_of(model, s.block_i, s.block_j) + " has slipped by " + three_digits(s.slip) +
                         " m, and " + where + ": contact stays with the nodes that were drawn together, so whether the "
                         "stones still bear each other there cannot be told";
    break;
  }
  return found;
}

}  // namespace voussoir

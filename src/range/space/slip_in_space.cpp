#include "range/space/slip_in_space.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/text.hpp"
#include "linalg/gather.hpp"
#include "model/handed_over.hpp"
#include "range/space/stone_surfaces.hpp"
#include "range/stone_names.hpp"
#include "ties/error_estimate.hpp"

namespace voussoir {
namespace {

// As in the plane (range/plane/slip_range): what solvers leave, and what a point stands for of a cell.
constexpr double negligible = 1e-6, share_of_a_cell = 0.5;

/// A joint whose points have slipped beyond their cells.
struct LongSlip {
  BlockId block_i, block_j;
  int points;         ///< that have
  double slip, cell;  ///< [m] the longest beside its cell
  Vector<3> place;    ///< [m] where that is
  double outside;     ///< [m] how far the resultant passes beyond a stone that must bear it; 0 where it does not
  bool on_others;     ///< it passes where another stone is
};

/// Distances from a point of a joint to the next one [m], per point.
std::vector<double> cells_of(const SpaceModel& model, int first, int last) {
  std::vector<Vector<3>> place;
  for (int k = first; k < last; ++k)
    place.push_back(model.points().at(k).place(Side::i, model.structure().drawn_position()));
  std::vector<double> cell(place.size(), INFINITY);
  for (std::size_t a = 0; a < place.size(); ++a)
    for (std::size_t b = 0; b < place.size(); ++b)
      if (const double apart = norm(place[b] - place[a]); apart > 0) cell[a] = std::min(cell[a], apart);
  return cell;
}

/// How the resultant of what presses in a joint lies to one of its stones, carried along by the other.
void look_at_stone(const SpaceModel& model, const StepEnd& end, int first, const std::vector<double>& cells,
                   Side carries, LongSlip& told) {
  const auto& s = model.structure();
  const auto& u = end.state.displacement;
  const auto& joint = model.points().joint_of(first);
  const int other = carries == Side::i ? joint.local_j : joint.local_i;
  Vector<3> now{}, drawn{};
  double force = 0, cell = 0;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    const auto k = first + static_cast<int>(n);
    const double normal = std::max(0.0, end.state.lambda[3 * static_cast<std::size_t>(k)]);
    now = now + normal * place_now(s, u, model.points().at(k), carries);
    drawn = drawn + normal * model.points().at(k).place(carries, s.drawn_position());
    cell += normal * cells[n];
    force += normal;
  }
  if (!(force > 0)) return;
  now = (1 / force) * now;
  const double half = share_of_a_cell * cell / force;
  const std::vector<double> still(u.size(), 0.0);
  // Where a joint is not plane the resultant passes beside its faces as it is drawn.
  const double away = distance_outside(surface_now(s, u, other), now) -
                      distance_outside(surface_now(s, still, other), (1 / force) * drawn);
  if (!(away > half)) return;
  const int mine = carries == Side::i ? joint.local_i : joint.local_j;
  for (int b = 0; b < s.local_blocks(); ++b) {
    if (b == mine || b == other || (!end.absent.empty() && end.absent[b])) continue;
    if (distance_outside(surface_now(s, u, b), now) > half) continue;
    told.on_others = true;
    return;
  }
  if (!is_held(model, other)) told.outside = std::max(told.outside, away);
}

std::vector<LongSlip> long_slips(const SpaceModel& model, const StepEnd& end) {
  const auto& points = model.points();
  const double least = negligible * largest_normal_force(model, end.state.lambda);
  const auto gap = model.gaps(end.state.displacement, end.state.lambda);
  const auto slip = [&](int k) { return std::hypot(gap[3 * k + 1], gap[3 * k + 2]); };
  const auto presses = [&](int k) { return least > 0 && end.state.lambda[3 * k] > least; };
  std::vector<LongSlip> found;
  for (int first = 0, last = 0; first < points.owned(); first = last) {
    const int joint = points.points()[first].joint;
    bool far = false;  // by half the width of what a point stands for: looked at closely
    for (last = first; last < points.owned() && points.points()[last].joint == joint; ++last)
      far |= presses(last) && slip(last) > std::sqrt(points.points()[last].area) / 2;
    if (!far) continue;
    const auto cells = cells_of(model, first, last);
    LongSlip told{points.joints()[joint].block_i, points.joints()[joint].block_j, 0, 0, 0, {}, 0, false};
    for (int k = first; k < last; ++k) {
      if (!presses(k) || !(slip(k) > cells[k - first])) continue;
      ++told.points;
      if (slip(k) <= told.slip) continue;
      told.slip = slip(k), told.cell = cells[k - first];
      told.place = place_now(model.structure(), end.state.displacement, points.at(k), Side::i);
    }
    if (told.points == 0) continue;
    for (const Side side : {Side::i, Side::j}) look_at_stone(model, end, first, cells, side, told);
    found.push_back(told);
  }
  return found;
}

std::string text(const Vector<3>& x) {
  return "(" + formatted("%.3f", x[0]) + ", " + formatted("%.3f", x[1]) + ", " + formatted("%.3f", x[2]) + ") m";
}

}  // namespace

RangeFindings look_at_slips(const SpaceModel& model, const StepEnd& end) {
  auto slips = all_gather(long_slips(model, end), *model.structure().comm(), WhyWhole{"long slips"});
  if (slips.empty()) return {};
  std::sort(slips.begin(), slips.end(), [](const LongSlip& a, const LongSlip& b) {
    return std::make_tuple(-a.slip, a.block_i, a.block_j) < std::make_tuple(-b.slip, b.block_i, b.block_j);
  });
  const auto on_others = std::count_if(slips.begin(), slips.end(), [](const LongSlip& s) { return s.on_others; });
  const auto& worst = slips.front();
  RangeFindings found;
  found.warnings.push_back(
      {"slip_beyond_cell", names_of(model, worst.block_i, worst.block_j), end.when, worst.slip,
       std::to_string(worst.points) + (worst.points == 1 ? " point that presses has" : " points that press have") +
           " slipped by up to " + three_digits(worst.slip) + " m, near " + text(worst.place) + ", where points are " +
           three_digits(worst.cell) +
           " m apart: contact stays with the nodes that were drawn together, so forces of this joint are those of "
           "pieces "
           "of face that are no longer opposite" +
           and_in_others(slips.size() - 1) +
           (on_others == 0 ? ""
                           : "; the force of " + std::to_string(on_others) +
                                 (on_others == 1 ? " joint passes" : " joints passes") +
                                 " where another stone is, and still acts on the one that was drawn there")});
  for (const auto& s : slips) {
    if (!(s.outside > 0)) continue;
    found.out_of_range = "joint " + names_of(model, s.block_i, s.block_j) + " has slipped by " + three_digits(s.slip) +
                         " m, and its force passes " + three_digits(s.outside) +
                         " m beyond the stone that bears it: contact stays with the nodes that were drawn together, so "
                         "whether the stones still bear each other there cannot be told";
    break;
  }
  return found;
}

}  // namespace voussoir

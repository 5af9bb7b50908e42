#include "range/space/slip_in_space.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/text.hpp"
#include "base/words.hpp"
#include "linalg/gather.hpp"
#include "model/handed_over.hpp"
#include "range/boxes_of_ranks.hpp"
#include "range/range_parameters.hpp"
#include "range/space/stone_surfaces.hpp"
#include "range/stone_names.hpp"
#include "ties/error_estimate.hpp"

namespace voussoir {
namespace {

/// A joint whose points have slipped beyond their cells.
struct LongSlip {
  BlockId block_i, block_j;
  int points;         ///< that have
  double slip, cell;  ///< [m] the longest beside its cell
  Vector<3> place;    ///< [m] where that is
  double uncovered;   ///< [-] share of the force that passes beyond both stones
  double outside;     ///< [m] how far the resultant passes beyond the other of its stones; 0 where it does not
  bool on_others;     ///< part of it passes where other stones are
  Box<3> around;      ///< [m] the nodes of both sides, and a cell around them

  bool past_an_end() const { return uncovered > RangeParameters::borne_by_nothing || outside > 0; }
};

/// The same on the rank that owns the joint, with its first point and the distances from each to the next one [m].
struct OwnSlip {
  LongSlip told;
  int first;
  std::vector<double> cells;
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

/// How a force that acts on nodes of one stone lies to the other.
struct Footing {
  double uncovered = 0;  ///< [-] share at points beyond the other by more than their cell
  double outside = 0;    ///< [m] of the resultant beyond it, where that is more than half a cell
  double on_others = 0;  ///< [-] share that is not uncovered because further stones are there
};

/// Stones round about.
class StonesAbout {
 public:
  /// @param placed  kept by their addresses
  explicit StonesAbout(const std::vector<PlacedSurface>& placed) : placed_(placed), solids_(surfaces_of(placed)) {}

  /// Whether a place lies in one that is no stone of a joint, or no farther outside of one.
  bool hold(const Vector<3>& x, double within, BlockId block_i, BlockId block_j) const {
    for (std::size_t k = 0; k < placed_.size(); ++k) {
      const auto& stone = placed_[k];
      if (stone.block == block_i || stone.block == block_j || !widened(stone.box, within).overlaps({x, x})) continue;
      if (distance_outside(solids_[k], x) <= within) return true;
    }
    return false;
  }

 private:
  static std::vector<const StoneSurface*> surfaces_of(const std::vector<PlacedSurface>& placed) {
    std::vector<const StoneSurface*> surfaces;
    for (const auto& stone : placed) surfaces.push_back(&stone.surface);
    return surfaces;
  }

  const std::vector<PlacedSurface>& placed_;
  Solids solids_;
};

Footing footing_of(const SpaceModel& model, const StepEnd& end, const OwnSlip& slip, Side carries,
                   const StonesAbout& others) {
  const auto& s = model.structure();
  const auto& u = end.state.displacement;
  const auto& joint = model.points().joint_of(slip.first);
  const int other = carries == Side::i ? joint.local_j : joint.local_i;
  const Solid stone(surface_now(s, u, other));
  const auto is_on_another = [&](const Vector<3>& x, double within) {
    return others.hold(x, within, joint.block_i, joint.block_j);
  };
  Footing footing;
  Vector<3> now{}, drawn{};
  double force = 0, cell = 0;
  for (std::size_t n = 0; n < slip.cells.size(); ++n) {
    const auto k = slip.first + static_cast<int>(n);
    const double normal = std::max(0.0, end.state.lambda[3 * static_cast<std::size_t>(k)]);
    if (!(normal > 0)) continue;
    const auto x = place_now(s, u, model.points().at(k), carries);
    now = now + normal * x;
    drawn = drawn + normal * model.points().at(k).place(carries, s.drawn_position());
    cell += normal * slip.cells[n];
    force += normal;
    if (!(distance_outside(stone, x) > slip.cells[n])) continue;
    (is_on_another(x, slip.cells[n]) ? footing.on_others : footing.uncovered) += normal;
  }
  if (!(force > 0)) return {};
  footing.uncovered /= force;
  footing.on_others /= force;
  const double half = RangeParameters::share_of_a_cell * cell / force;
  const std::vector<double> still(u.size(), 0.0);
  // Where a joint is not plane the resultant passes beside its faces as it is drawn.
  const double away = distance_outside(stone, (1 / force) * now) -
                      distance_outside(Solid(surface_now(s, still, other)), (1 / force) * drawn);
  if (away > half && !is_on_another((1 / force) * now, half)) footing.outside = away;
  return footing;
}

/// Whether what presses in a joint weighs on one of its stones as the stone's own loads do: it stands without.
bool only_weighs_on(const SpaceModel& model, const StepEnd& end, const OwnSlip& slip, bool on_i) {
  Vector<3> force{}, load{};
  for (std::size_t n = 0; n < slip.cells.size(); ++n) {
    const auto k = static_cast<std::size_t>(slip.first) + n;
    force = force + (on_i ? -1 : 1) * std::max(0.0, end.state.lambda[3 * k]) * model.points().points()[k].axis[0];
  }
  const auto& joint = model.points().joint_of(slip.first);
  const auto& block = model.structure().blocks()[on_i ? joint.local_i : joint.local_j];
  for (int n = block.first_local; n < block.first_local + block.nodes; ++n)
    load = load + Vector<3>{end.load[3 * n], end.load[3 * n + 1], end.load[3 * n + 2]};
  return dot(force, load) > RangeParameters::weighs * norm(force) * norm(load);
}

/// As in the plane: a stone that a support holds bears a force wherever it acts, and one that bears a stone which has
/// gone on to others bears what is theirs.
void look_at_stones(const SpaceModel& model, const StepEnd& end, OwnSlip& slip, const StonesAbout& others) {
  const auto& joint = model.points().joint_of(slip.first);
  const auto i = footing_of(model, end, slip, Side::i, others), j = footing_of(model, end, slip, Side::j, others);
  const auto bears_all = [&](int block, const Footing& of_the_other) {
    return is_held(model, block) || (of_the_other.on_others > RangeParameters::borne_by_nothing &&
                                     only_weighs_on(model, end, slip, block == joint.local_i));
  };
  slip.told.uncovered = std::min(i.uncovered, j.uncovered);
  slip.told.outside =
      std::max(bears_all(joint.local_i, j) ? 0.0 : i.outside, bears_all(joint.local_j, i) ? 0.0 : j.outside);
  slip.told.on_others = i.on_others > 0 || j.on_others > 0;
}

Box<3> box_around(const SpaceModel& model, const StepEnd& end, const OwnSlip& slip) {
  auto box = empty_box<3>();
  for (std::size_t n = 0; n < slip.cells.size(); ++n)
    for (const Side side : {Side::i, Side::j}) {
      const auto x = place_now(model.structure(), end.state.displacement,
                               model.points().at(slip.first + static_cast<int>(n)), side);
      const Vector<3> cell{slip.cells[n], slip.cells[n], slip.cells[n]};
      box.add({x - cell, x + cell});
    }
  return box;
}

std::vector<OwnSlip> long_slips(const SpaceModel& model, const StepEnd& end) {
  const auto& points = model.points();
  const double least = RangeParameters::negligible * largest_normal_force(model, end.state.lambda);
  const auto gap = model.gaps(end.state.displacement, end.state.lambda);
  const auto slip = [&](int k) { return std::hypot(gap[3 * k + 1], gap[3 * k + 2]); };
  const auto presses = [&](int k) { return least > 0 && end.state.lambda[3 * k] > least; };
  const std::vector<PlacedSurface> none;
  std::vector<OwnSlip> found;
  for (int first = 0, last = 0; first < points.owned(); first = last) {
    const int joint = points.points()[first].joint;
    bool far = false;  // by half the width of what a point stands for: looked at closely
    for (last = first; last < points.owned() && points.points()[last].joint == joint; ++last)
      far |= presses(last) && slip(last) > std::sqrt(points.points()[last].area) / 2;
    if (!far) continue;
    const auto& blocks = points.joints()[joint];
    OwnSlip own{{blocks.block_i, blocks.block_j, 0, 0, 0, {}, 0, 0, false, {}}, first, cells_of(model, first, last)};
    auto& told = own.told;
    for (int k = first; k < last; ++k) {
      if (!presses(k) || !(slip(k) > own.cells[k - first])) continue;
      ++told.points;
      if (slip(k) <= told.slip) continue;
      told.slip = slip(k), told.cell = own.cells[k - first];
      told.place = place_now(model.structure(), end.state.displacement, points.at(k), Side::i);
    }
    if (told.points == 0) continue;
    told.around = box_around(model, end, own);
    look_at_stones(model, end, own, StonesAbout(none));
    found.push_back(std::move(own));
  }
  return found;
}

/// The slips of all ranks, the longest first. Collective.
std::vector<LongSlip> slips_of_all(const SpaceModel& model, const StepEnd& end) {
  auto mine = long_slips(model, end);
  const auto gathered = [&] {
    std::vector<LongSlip> told;
    for (const auto& slip : mine) told.push_back(slip.told);
    return all_gather(told, *model.structure().comm(), WhyWhole{"long slips"});
  };
  auto slips = gathered();
  const auto past_an_end = [](const LongSlip& slip) { return slip.past_an_end(); };
  if (std::any_of(slips.begin(), slips.end(), past_an_end)) {
    // Where a slip has passed an end, stones of any rank may be.
    auto around = empty_box<3>();
    for (const auto& slip : mine)
      if (slip.told.past_an_end()) around.add(slip.told.around);
    const auto placed = surfaces_in(around, surfaces_here(model, end), *model.structure().comm());
    const StonesAbout others(placed);
    for (auto& slip : mine)
      if (slip.told.past_an_end()) look_at_stones(model, end, slip, others);
    slips = gathered();
  }
  std::sort(slips.begin(), slips.end(), [](const LongSlip& a, const LongSlip& b) {
    return std::make_tuple(-a.slip, a.block_i, a.block_j) < std::make_tuple(-b.slip, b.block_i, b.block_j);
  });
  return slips;
}

std::string text(const Vector<3>& x) {
  return "(" + formatted("%.3f", x[0]) + ", " + formatted("%.3f", x[1]) + ", " + formatted("%.3f", x[2]) + ") m";
}

}  // namespace

RangeFindings look_at_slips(const SpaceModel& model, const StepEnd& end) {
  const auto slips = slips_of_all(model, end);
  if (slips.empty()) return {};
  const auto on_others = std::count_if(slips.begin(), slips.end(), [](const LongSlip& s) { return s.on_others; });
  const auto& worst = slips.front();
  RangeFindings found;
  found.warnings.push_back(
      {"slip_beyond_cell", names_of(model, worst.block_i, worst.block_j), end.when, worst.slip,
       counted(worst.points, "point that presses has", "points that press have") + " slipped by up to " +
           three_digits(worst.slip) + " m, near " + text(worst.place) + ", where points are " +
           three_digits(worst.cell) +
           " m apart: contact stays with the nodes that were drawn together, so forces and margins of this joint are "
           "those of pieces of face that are no longer opposite" +
           and_in_others(slips.size() - 1) +
           (on_others == 0
                ? ""
                : "; the force of " + counted(on_others, "joint") + (on_others == 1 ? " passes" : " passes in part") +
                      " where another stone is, and still acts on the one that was drawn there")});
  for (const auto& s : slips) {
    if (!s.past_an_end()) continue;
    const auto where = s.uncovered > RangeParameters::borne_by_nothing
                           ? three_digits(100 * s.uncovered) + " % of its force passes beyond both of its stones"
                           : "its force passes " + three_digits(s.outside) + " m beyond the stone that it comes from";
    found.out_of_range = "joint " + names_of(model, s.block_i, s.block_j) + " has slipped by " + three_digits(s.slip) +
                         " m, and " + where +
                         ": contact stays with the nodes that were drawn together, so whether the stones still bear "
                         "each other there cannot be told";
    break;
  }
  return found;
}

}  // namespace voussoir

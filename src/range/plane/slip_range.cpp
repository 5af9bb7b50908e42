#include "range/plane/slip_range.hpp"

#include <cmath>

#include "base/check.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "linalg/gather.hpp"
#include "mesh/box_tree.hpp"
#include "model/handed_over.hpp"
#include "model/plane/plane_model.hpp"
#include "range/plane/stone_places.hpp"
#include "range/range_parameters.hpp"
#include "ties/error_estimate.hpp"

namespace voussoir {
namespace {

/// A joint whose points have slipped beyond their cells.
struct LongSlip {
  BlockId block_i, block_j;
  int points;         ///< that have
  double slip, cell;  ///< [m] the longest beside its cell
  double x, y;        ///< [m] where that is
  double uncovered;   ///< [-] share of the force that passes beyond the ends of both faces
  double outside;     ///< [m] how far the resultant passes beyond the end of a face; 0 where it does not
  bool on_others;     ///< part of the force passes where other stones continue a face that has ended
  Box<2> place;       ///< [m] of the nodes of both sides, and a cell around them

  bool past_an_end() const { return uncovered > RangeParameters::borne_by_nothing || outside > 0; }
};

/// The same on the rank that owns the joint, with its points and the shorter of the edges beside each [m].
struct OwnSlip {
  LongSlip told;
  std::vector<std::pair<int, double>> cells;
};

/// Points of a joint in their order along it, with the shorter of the edges beside each [m].
std::vector<std::pair<int, double>> along_the_joint(const PlaneModel& model, const std::vector<int>& points) {
  const auto place = [&](int k) { return model.points().at(k).place(Side::i, model.structure().drawn_position()); };
  const auto first = place(points.front());
  Vector<2> far{};  // runs along the joint whatever way its axes have turned
  for (int k : points)
    if (norm(place(k) - first) > norm(far)) far = place(k) - first;
  std::vector<std::pair<double, int>> order;
  for (int k : points) order.push_back({dot(place(k) - first, far), k});
  std::sort(order.begin(), order.end());
  std::vector<std::pair<int, double>> cells;
  for (std::size_t n = 0; n < order.size(); ++n) {
    double cell = INFINITY;
    for (const std::size_t other : {n - 1, n + 1})
      if (other < order.size()) {
        const double edge = norm(place(order[n].second) - place(order[other].second));
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
  double on_others = 0;  ///< [-] share that is not uncovered because other stones continue the face
};

/// @param others  borders of stones round about, which may continue the face
Footing footing_of(const PlaneModel& model, const StepEnd& end, const std::vector<std::pair<int, double>>& points,
                   bool of_i, const Outline& others) {
  const auto& s = model.structure();
  const auto& u = end.state.displacement;
  const Side here = of_i ? Side::i : Side::j, there = of_i ? Side::j : Side::i;
  const auto& joint = model.points().joint_of(points.front().first);
  const int other = of_i ? joint.local_j : joint.local_i;
  const auto stone = outline_now(s, u, other);
  const auto drawn = outline_now(s, std::vector<double>(u.size(), 0.0), other);
  const auto beyond = [](const Outline& outline, const Vector<2>& x) {
    return inside(outline, x) ? 0.0 : distance_to_border(outline, x);
  };
  Outline face;  // with what continues it
  if (!others.empty()) {
    std::vector<int> nodes;
    double cell = INFINITY;
    for (const auto& [k, length] : points) {
      model.points().at(k).each_of(there, [&](int node, double) { nodes.push_back(node); });
      cell = std::min(cell, length);
    }
    face = with_what_goes_on_flush(face_now(s, u, other, std::move(nodes)), others, cell);
  }
  const auto beyond_all = [&](const Vector<2>& x) {
    const double away = beyond(stone, x);
    return away > 0 && !face.empty() ? std::min(away, distance_to_border(face, x)) : away;
  };
  Vector<2> place{}, drawn_place{};
  double force = 0, mean_cell = 0;
  Footing footing;
  for (const auto& [k, cell] : points) {
    const double normal = std::max(0.0, end.state.lambda[2 * k]);
    const auto x = place_now(s, u, model.points().at(k), here);
    force += normal;
    place = place + normal * x;
    drawn_place = drawn_place + normal * model.points().at(k).place(here, s.drawn_position());
    mean_cell += normal * cell;
    if (beyond(stone, x) > cell) (beyond_all(x) > cell ? footing.uncovered : footing.on_others) += normal;
  }
  if (!(force > 0)) return {};
  // Where a joint is not straight the resultant passes beside its faces as it is drawn.
  const double away = beyond_all((1 / force) * place) - beyond(drawn, (1 / force) * drawn_place);
  return {footing.uncovered / force, away > RangeParameters::share_of_a_cell * mean_cell / force ? away : 0.0,
          footing.on_others / force};
}

/// Whether what presses in a joint weighs on one of its blocks as the block's own loads do: it stands without.
bool only_weighs_on(const PlaneModel& model, const StepEnd& end, const std::vector<std::pair<int, double>>& points,
                    bool on_i) {
  Vector<2> force{}, load{};
  for (const auto& [k, cell] : points) {
    const auto& p = model.points().points()[k];
    force = force + (on_i ? -1 : 1) * std::max(0.0, end.state.lambda[2 * k]) * in_plane(p.axis[0]);
  }
  const auto& s = model.structure();
  const auto& joint = model.points().joint_of(points.front().first);
  const auto& block = s.blocks()[on_i ? joint.local_i : joint.local_j];
  for (int n = block.first_local; n < block.first_local + static_cast<int>(block.mesh.position.size()); ++n)
    load = load + Vector<2>{end.load[2 * n], end.load[2 * n + 1]};
  return dot(force, load) > RangeParameters::weighs * norm(force) * norm(load);
}

/// Looks how the force of a joint lies to its faces.
void look_at_faces(const PlaneModel& model, const StepEnd& end, OwnSlip& slip, const Outline& others) {
  auto& told = slip.told;
  const auto i = footing_of(model, end, slip.cells, true, others);
  const auto j = footing_of(model, end, slip.cells, false, others);
  // A stone that a support holds bears a force wherever it acts. One that bears a stone which has gone on to those that
  // continue its face bears what is theirs, wherever that acts.
  const auto bears_all = [&](BlockId b, const Footing& of_the_other) {
    return is_held(model, model.structure().local_block(b)) ||
           (of_the_other.on_others > RangeParameters::borne_by_nothing &&
            only_weighs_on(model, end, slip.cells, b == told.block_i));
  };
  told.uncovered = std::min(i.uncovered, j.uncovered);
  told.outside = std::max(bears_all(told.block_i, j) ? 0.0 : i.outside, bears_all(told.block_j, i) ? 0.0 : j.outside);
  told.on_others = i.on_others > 0 || j.on_others > 0;
}

Box<2> place_of(const PlaneModel& model, const StepEnd& end, const std::vector<std::pair<int, double>>& cells) {
  Box<2> box{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (const auto& [k, cell] : cells) {
    for (const Side side : {Side::i, Side::j}) {
      const auto x = place_now(model.structure(), end.state.displacement, model.points().at(k), side);
      box.add({x - Vector<2>{cell, cell}, x + Vector<2>{cell, cell}});
    }
  }
  return box;
}

std::vector<OwnSlip> long_slips(const PlaneModel& model, const StepEnd& end) {
  const auto& points = model.points();
  const double least = RangeParameters::negligible * largest_normal_force(model, end.state.lambda);
  const auto gap = model.gaps(end.state.displacement, end.state.lambda);
  const auto slip = [&](int k) { return std::abs(gap[2 * k + 1]); };
  const auto presses = [&](int k) { return least > 0 && end.state.lambda[2 * k] > least; };
  std::vector<OwnSlip> found;
  for (int first = 0, last = 0; first < points.owned(); first = last) {
    const int joint = points.points()[first].joint;
    bool far = false;  // by half the length a point stands for: looked at closely
    for (last = first; last < points.owned() && points.points()[last].joint == joint; ++last)
      far |= presses(last) && slip(last) > points.points()[last].area / points.joints()[joint].thickness / 2;
    if (!far) continue;
    std::vector<int> members;
    for (int k = first; k < last; ++k) members.push_back(k);
    const auto& blocks = points.joints()[joint];
    OwnSlip own{{blocks.block_i, blocks.block_j, 0, 0, 0, 0, 0, 0, 0, false, {}}, along_the_joint(model, members)};
    auto& worst = own.told;
    for (const auto& [k, cell] : own.cells) {
      if (!presses(k) || !(slip(k) > cell)) continue;
      ++worst.points;
      if (slip(k) <= worst.slip) continue;
      const auto x = place_now(model.structure(), end.state.displacement, points.at(k), Side::i);
      worst.slip = slip(k), worst.cell = cell, worst.x = x[0], worst.y = x[1];
    }
    if (worst.points == 0) continue;
    worst.place = place_of(model, end, own.cells);
    look_at_faces(model, end, own, {});
    found.push_back(own);
  }
  return found;
}

/// Border edges of all stones in the places of joints that have slipped past an end of a face. Collective.
Outline borders_near(const PlaneModel& model, const StepEnd& end, const std::vector<LongSlip>& slips) {
  const auto& s = model.structure();
  const auto& u = end.state.displacement;
  const auto wanted = [&](const Box<2>& box) {
    return std::any_of(slips.begin(), slips.end(),
                       [&](const LongSlip& slip) { return slip.past_an_end() && slip.place.overlaps(box); });
  };
  Outline mine;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!end.absent.empty() && end.absent[b]) continue;
    const auto& block = s.blocks()[b];
    Box<2> box{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int n = block.first_local; n < block.first_local + static_cast<int>(block.mesh.position.size()); ++n) {
      const auto x = place_now(s, u, n);
      box.add({x, x});
    }
    if (!wanted(box)) continue;
    for (const auto& edge : outline_now(s, u, b)) {
      Box<2> around{edge.from, edge.from};
      around.add({edge.to, edge.to});
      if (wanted(around)) mine.push_back(edge);
    }
  }
  return all_gather(mine, *s.comm(), WhyWhole{"edges beside long slips"});
}

/// The slips of all ranks, the longest first. Collective.
std::vector<LongSlip> slips_of_all(const PlaneModel& model, const StepEnd& end) {
  const auto& comm = *model.structure().comm();
  auto mine = long_slips(model, end);
  const auto gathered = [&] {
    std::vector<LongSlip> told;
    for (const auto& slip : mine) told.push_back(slip.told);
    return all_gather(told, comm, WhyWhole{"long slips"});
  };
  auto slips = gathered();
  if (std::any_of(slips.begin(), slips.end(), [](const LongSlip& slip) { return slip.past_an_end(); })) {
    const auto others = borders_near(model, end, slips);
    for (auto& slip : mine)
      if (slip.told.past_an_end()) look_at_faces(model, end, slip, others);
    slips = gathered();
  }
  std::sort(slips.begin(), slips.end(), [](const LongSlip& a, const LongSlip& b) {
    return std::make_tuple(-a.slip, a.block_i, a.block_j) < std::make_tuple(-b.slip, b.block_i, b.block_j);
  });
  return slips;
}

}  // namespace

RangeFindings look_at_slips(const PlaneModel& model, const StepEnd& end) {
  VOUSSOIR_EXPECT(is_of_points(model, end.state.lambda) && "lambda: of points");
  const auto slips = slips_of_all(model, end);
  if (slips.empty()) return {};
  const auto on_others = std::count_if(slips.begin(), slips.end(), [](const LongSlip& s) { return s.on_others; });
  RangeFindings found;
  const auto& worst = slips.front();
  found.warnings.push_back(
      {"slip_beyond_cell", names_of(model, worst.block_i, worst.block_j), end.when, worst.slip,
       counted(worst.points, "point that presses has", "points that press have") + " slipped by up to " +
           three_digits(worst.slip) + " m, near " + place_text({worst.x, worst.y}) + ", where cells are " +
           three_digits(worst.cell) +
           " m long: contact stays with the nodes that were drawn together, so forces and margins of this joint are "
           "those of pieces of face that are no longer opposite" +
           and_in_others(slips.size() - 1) +
           (on_others == 0
                ? ""
                : "; " + counted(on_others, "joint has", "joints have") +
                      " slipped past the end of a face that other stones continue flush: points stay with "
                      "the stones they were drawn on, so forces go to the wrong ones of the stones in line")});
  for (const auto& s : slips) {
    if (s.uncovered <= RangeParameters::borne_by_nothing && s.outside <= 0) continue;
    const auto where = s.uncovered > RangeParameters::borne_by_nothing
                           ? three_digits(100 * s.uncovered) + " % of its force passes beyond the ends of its faces"
                           : "its force passes " + three_digits(s.outside) + " m beyond the end of a face";
    found.out_of_range = "joint " + names_of(model, s.block_i, s.block_j) + " has slipped by " + three_digits(s.slip) +
                         " m, and " + where +
                         ": contact stays with the nodes that were drawn together, so whether the "
                         "stones still bear each other there cannot be told";
    break;
  }
  return found;
}

}  // namespace voussoir

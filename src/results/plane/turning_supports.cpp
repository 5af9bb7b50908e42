#include "results/plane/turning_supports.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "blocks/rigid_motion.hpp"
#include "model/handed_over.hpp"
#include "model/plane/plane_model.hpp"

namespace voussoir {
namespace {

// Of the largest arm, by which a motion may differ from that of a body: far above round-off of places, far below any
// settlement that matters.
constexpr double of_a_body = 1e-9;
// Of places far from the origin, whose differences have lost digits.
constexpr double round_off = 64 * std::numeric_limits<double>::epsilon();

/// What supports hold of a block: places at the start and end of a step, and forces there.
struct HeldPart {
  std::vector<Vector<2>> from, to, force_before, force;

  Vector<2> middle(const std::vector<Vector<2>>& places) const {
    Vector<2> sum{};
    for (const auto& x : places) sum = sum + (1.0 / static_cast<double>(places.size())) * (x - places[0]);
    return places[0] + sum;
  }
  double beyond_the_chord() const {
    if (from.size() < 2) return 0;
    const auto m0 = middle(from), m1 = middle(to);
    double crossed = 0, along = 0, largest = 0, farthest = 0;
    for (std::size_t k = 0; k < from.size(); ++k) {
      crossed += cross(from[k] - m0, to[k] - m1);
      along += dot(from[k] - m0, to[k] - m1);
      largest = std::max(largest, norm(from[k] - m0));
      farthest = std::max({farthest, norm(from[k]), norm(to[k])});
    }
    const double turn = std::atan2(crossed, along);
    if (turn == 0) return 0;
    const Rotation rotation(turn);
    const double off = of_a_body * largest + round_off * farthest;
    double moment = 0, chord = 0;
    for (std::size_t k = 0; k < from.size(); ++k) {
      const auto r0 = from[k] - m0, r1 = to[k] - m1;
      if (norm(r1 - rotation(r0)) > off) return 0;  // several supports, each with its motion
      moment += cross(r0, force_before[k]) + cross(r1, force[k]);
      chord += 0.5 * dot(force_before[k] + force[k], r1 - r0);
    }
    return moment * std::tan(turn / 2) - chord;
  }
};

}  // namespace

double beyond_the_chord(const Model& model, const ContactState& before, const ContactState& after,
                        const std::vector<double>& reaction_before, const std::vector<double>& reaction) {
  VOUSSOIR_EXPECT(is_of_nodes(model, reaction_before) && is_of_nodes(model, reaction) && "reactions: of node copies");
  if (model.settings().rotations == Rotations::small) return 0;
  const auto& s = plane_geometry(model).structure;
  const auto& held = model.held();
  double work = 0;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    const int first = block.first_local, end = first + static_cast<int>(block.mesh.position.size());
    HeldPart part;
    for (int n = first; n < end; ++n) {
      if (!held[2 * n] || !held[2 * n + 1]) continue;
      const auto of = [n](const std::vector<double>& field) { return Vector<2>{field[2 * n], field[2 * n + 1]}; };
      part.from.push_back(s.drawn_position()[n] + of(before.displacement));
      part.to.push_back(s.drawn_position()[n] + of(after.displacement));
      part.force_before.push_back(of(reaction_before));
      part.force.push_back(of(reaction));
    }
    work += part.beyond_the_chord();
  }
  return work;
}

}  // namespace voussoir

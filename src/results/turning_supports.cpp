#include "results/turning_supports.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "base/plane_and_space.hpp"
#include "base/rotation.hpp"
#include "model/handed_over.hpp"

namespace voussoir {
namespace {

// Of the largest arm, by which a motion may differ from that of a body: far above round-off of places, far below any
// settlement that matters.
constexpr double of_a_body = 1e-9;
// Of places far from the origin, whose differences have lost digits.
constexpr double round_off_of_arms = 64 * std::numeric_limits<double>::epsilon();

/// What supports hold of a block: places at the start and end of a step, and forces there.
template <int dim>
struct HeldPart {
  std::vector<Vector<dim>> from, to, force_before, force;

  Vector<dim> middle(const std::vector<Vector<dim>>& places) const {
    Vector<dim> sum{};
    for (const auto& x : places) sum = sum + (1.0 / static_cast<double>(places.size())) * (x - places[0]);
    return places[0] + sum;
  }
  double beyond_the_chord() const {
    if (from.size() < 2) return 0;
    const auto m0 = middle(from), m1 = middle(to);
    NearestRotation<dim> nearest;
    Vector<dim> longest{};
    double farthest = 0;
    for (std::size_t k = 0; k < from.size(); ++k) {
      const auto r0 = from[k] - m0, r1 = to[k] - m1;
      nearest.add(r0, r1 - r0);
      if (norm(r0) > norm(longest)) longest = r0;
      farthest = std::max({farthest, norm(from[k]), norm(to[k])});
    }
    const auto rotation = nearest.found();
    const auto turn = rotation.vector();
    const double angle = norm(turn);
    const double off = of_a_body * norm(longest) + round_off_of_arms * farthest;
    if (angle == 0 || (dim == 3 && in_one_line(m0, longest, off))) return 0;
    Vector<3> moments{};
    double chord = 0;
    for (std::size_t k = 0; k < from.size(); ++k) {
      const auto r0 = from[k] - m0, r1 = to[k] - m1;
      if (norm(r1 - rotation(r0)) > off) return 0;  // several supports, each with its motion
      moments = moments + cross(in_space(r0), in_space(force_before[k])) + cross(in_space(r1), in_space(force[k]));
      chord += 0.5 * dot(force_before[k] + force[k], r1 - r0);
    }
    return dot(moments, (1 / angle) * turn) * std::tan(angle / 2) - chord;
  }
  /// Then how far it has turned about that line cannot be told, nor do its reactions work against that.
  bool in_one_line(const Vector<dim>& m0, const Vector<dim>& longest, double off) const {
    return std::all_of(from.begin(), from.end(), [&](const auto& x) {
      return norm(cross(in_space(x - m0), in_space(longest))) <= off * norm(longest);
    });
  }
};

template <int dim>
double beyond_the_chord_of(const Structure<dim>& s, const Held& held, const ContactState& before,
                           const ContactState& after, const std::vector<double>& reaction_before,
                           const std::vector<double>& reaction) {
  double work = 0;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    HeldPart<dim> part;
    for (int n = block.first_local; n < block.first_local + block.nodes; ++n) {
      bool all = true;
      for (int c = 0; c < dim; ++c) all = all && held[dim * n + c];
      if (!all) continue;
      const auto of = [n](const std::vector<double>& field) {
        Vector<dim> v;
        for (int c = 0; c < dim; ++c) v[c] = field[dim * n + c];
        return v;
      };
      part.from.push_back(s.drawn_position()[n] + of(before.displacement));
      part.to.push_back(s.drawn_position()[n] + of(after.displacement));
      part.force_before.push_back(of(reaction_before));
      part.force.push_back(of(reaction));
    }
    work += part.beyond_the_chord();
  }
  return work;
}

}  // namespace

double beyond_the_chord(const Model& model, const ContactState& before, const ContactState& after,
                        const std::vector<double>& reaction_before, const std::vector<double>& reaction) {
  VOUSSOIR_EXPECT(is_of_nodes(model, reaction_before) && is_of_nodes(model, reaction) && "reactions: of node copies");
  if (model.settings().rotations == Rotations::small) return 0;
  return model.in_geometry([&](const auto&, const auto& structure) {
    return beyond_the_chord_of(structure, model.held(), before, after, reaction_before, reaction);
  });
}

}  // namespace voussoir

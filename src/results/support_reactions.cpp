#include "results/support_reactions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "blocks/supports.hpp"
#include "linalg/reduce.hpp"
#include "mesh/facet_set.hpp"
#include "model/handed_over.hpp"
#include "model/plane/plane_model.hpp"

namespace voussoir {
namespace {

// A reaction below this share of the largest is what solvers leave: it has no place.
constexpr double negligible = 1e-6;

/// Length of the edges of a set that belong to each node copy of blocks of this rank, half of each [m].
std::vector<double> edges_at_nodes(const Structure<2>& s, const FacetSet& facets) {
  std::vector<double> length(s.nodes(), 0.0);
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    for (const auto& facet : block.mesh.facets) {
      if (!facets.has(block.mesh, facet)) continue;
      const double half = norm(block.mesh.position[facet.node[1]] - block.mesh.position[facet.node[0]]) / 2;
      for (int k = 0; k < facet.count; ++k) length[block.first_local + facet.node[k]] += half;
    }
  }
  return length;
}

}  // namespace

std::vector<std::vector<HeldNode>> held_nodes(const std::vector<Named<SupportParameters>>& supports,
                                              const BlockSource<2>& source, const Structure<2>& s) {
  std::vector<std::vector<double>> edges;
  std::vector<double> edges_of_all(2 * s.nodes(), 0.0);  // that hold a component
  for (const auto& [name, support] : supports) {
    edges.push_back(edges_at_nodes(s, facet_set(source, {support.on, support.blocks})));
    for (std::size_t i = 0; i < edges_of_all.size(); ++i)
      if (holds(support, static_cast<int>(i % 2))) edges_of_all[i] += edges.back()[i / 2];
  }
  std::vector<std::vector<HeldNode>> held(edges.size());
  for (std::size_t k = 0; k < edges.size(); ++k)
    for (int node = 0; node < s.owned_nodes(); ++node) {
      if (!(edges[k][node] > 0)) continue;
      HeldNode here{node, edges[k][node], {}};
      for (int c = 0; c < 2; ++c)
        if (holds(supports[k].parameters, c)) here.share[c] = edges[k][node] / edges_of_all[2 * node + c];
      held[k].push_back(here);
    }
  return held;
}

std::map<std::string, ReactionSummary> support_reactions(const PlaneModel& model, const std::vector<double>& residual) {
  VOUSSOIR_EXPECT(is_of_nodes(model, residual) && "residual: of node copies");
  const auto& s = model.structure();
  const auto& supports = model.supports();
  const auto held = held_nodes(supports, model.source(), s);
  const auto origin = s.middle();  // moments about it keep their digits wherever the structure stands
  std::map<std::string, ReactionSummary> found;
  double largest = 0;
  for (std::size_t k = 0; k < held.size(); ++k) {
    // Number of nodes, sums of their places, their forces, and the moment of these.
    std::array<double, 6> mine{};
    for (const auto& [node, length, share] : held[k]) {
      const auto x = s.position()[node] - origin;
      const Vector<2> force{residual[2 * node] * share[0], residual[2 * node + 1] * share[1]};
      mine = mine + std::array<double, 6>{1, x[0], x[1], force[0], force[1], cross(x, force)};
    }
    const auto [count, sum_x, sum_y, fx, fy, moment] = total_of_each(*s.comm(), mine);
    if (!(count > 0)) continue;
    const double x = sum_x / count, y = sum_y / count, square = fx * fx + fy * fy;
    const double shift = square > 0 ? (moment - x * fy + y * fx) / square : std::numeric_limits<double>::quiet_NaN();
    found[supports[k].name] = {fx, fy, origin[0] + x + shift * fy, origin[1] + y - shift * fx};
    largest = std::max(largest, std::hypot(fx, fy));
  }
  for (auto& [name, reaction] : found)
    if (!(std::hypot(reaction.x, reaction.y) > negligible * largest))
      reaction.through_x = reaction.through_y = std::numeric_limits<double>::quiet_NaN();
  return found;
}

}  // namespace voussoir

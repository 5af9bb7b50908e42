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

namespace voussoir {
namespace {

// A reaction below this share of the largest is what solvers leave: it has no place.
constexpr double negligible = 1e-6;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Length of an edge [m].
double size_of(const Block<2>& block, const TaggedFacet& edge) {
  return norm(block.position[edge.node[1]] - block.position[edge.node[0]]);
}

/// Area of a face [m2], half the product of its diagonals across each other.
double size_of(const Block<3>& block, const TaggedFacet& face) {
  const auto& x = block.position;
  const int last = face.count - 1;
  return norm(cross(x[face.node[2]] - x[face.node[0]], x[face.node[last]] - x[face.node[1]])) / 2;
}

/// Size of the facets of a set that belongs to each node copy of blocks of this rank, an equal share of each.
template <int dim>
std::vector<double> sizes_at_nodes(const Structure<dim>& s, const FacetSet& facets) {
  std::vector<double> size(s.nodes(), 0.0);
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    for (const auto& facet : block.mesh.facets) {
      if (!facets.has(block.mesh, facet)) continue;
      const double share = size_of(block.mesh, facet) / facet.count;
      for (int k = 0; k < facet.count; ++k) size[block.first_local + facet.node[k]] += share;
    }
  }
  return size;
}

}  // namespace

std::vector<std::vector<HeldNode>> held_nodes(const std::vector<Named<SupportParameters>>& supports,
                                              const Model& model) {
  const int dim = model.components();
  const auto& s = model.structure();
  std::vector<std::vector<double>> sizes;
  std::vector<double> size_of_all(static_cast<std::size_t>(dim) * s.nodes(), 0.0);  // that hold a component
  for (const auto& [name, support] : supports) {
    sizes.push_back(model.in_geometry([&, &p = support](const auto& source, const auto& structure) {
      return sizes_at_nodes(structure, facet_set(source, {p.on, p.blocks}));
    }));
    for (std::size_t i = 0; i < size_of_all.size(); ++i)
      if (holds(support, static_cast<int>(i % dim))) size_of_all[i] += sizes.back()[i / dim];
  }
  std::vector<std::vector<HeldNode>> held(sizes.size());
  for (std::size_t k = 0; k < sizes.size(); ++k)
    for (int node = 0; node < s.owned_nodes(); ++node) {
      if (!(sizes[k][node] > 0)) continue;
      HeldNode here{node, sizes[k][node], {}};
      for (int c = 0; c < dim; ++c)
        if (holds(supports[k].parameters, c)) here.share[c] = sizes[k][node] / size_of_all[dim * node + c];
      held[k].push_back(here);
    }
  return held;
}

std::map<std::string, ReactionSummary> support_reactions(const Model& model, const std::vector<double>& residual) {
  VOUSSOIR_EXPECT(is_of_nodes(model, residual) && "residual: of node copies");
  const int dim = model.components();
  const auto& s = model.structure();
  const auto& supports = model.supports();
  const auto held = held_nodes(supports, model);
  const auto origin = s.centre();  // moments about it keep their digits wherever the structure stands
  std::map<std::string, ReactionSummary> found;
  double largest = 0;
  for (std::size_t k = 0; k < held.size(); ++k) {
    // Number of nodes, sums of their places, their forces, and the moments of these.
    std::array<double, 10> mine{};
    for (const auto& [node, size, share] : held[k]) {
      const auto x = s.place(node) - origin;
      Vector<3> force{};
      for (int c = 0; c < dim; ++c) force[c] = residual[dim * node + c] * share[c];
      const auto moment = cross(x, force);
      mine = mine +
             std::array<double, 10>{1, x[0], x[1], x[2], force[0], force[1], force[2], moment[0], moment[1], moment[2]};
    }
    const auto sum = total_of_each(*s.comm(), mine);
    if (!(sum[0] > 0)) continue;
    const Vector<3> middle{sum[1] / sum[0], sum[2] / sum[0], sum[3] / sum[0]};
    const Vector<3> force{sum[4], sum[5], sum[6]};
    const auto moment = Vector<3>{sum[7], sum[8], sum[9]} - cross(middle, force);  // about the middle
    const double square = dot(force, force);
    const auto way = square > 0 ? cross(force, (1 / square) * moment) : Vector<3>{none, none, none};
    found[supports[k].name] = {force, origin + middle + way};
    largest = std::max(largest, norm(force));
  }
  for (auto& [name, reaction] : found)
    if (!(norm(reaction.force) > negligible * largest)) reaction.through = {none, none, none};
  return found;
}

}  // namespace voussoir

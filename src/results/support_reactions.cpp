#include "results/support_reactions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "base/check.hpp"
#include "base/components.hpp"
#include "blocks/supports.hpp"
#include "linalg/reduce.hpp"
#include "mesh/facet_set.hpp"
#include "model/handed_over.hpp"

namespace voussoir {
namespace {

// Of what the nodes of a support bear, by the sizes of their forces: less is what solvers leave, and has no place.
constexpr double negligible_reaction = 1e-6;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// What a support holds of each node copy of blocks of this rank.
struct HeldBySupport {
  std::vector<double> size;        ///< of its facets that belongs to the node, an equal share of each
  std::map<int, Matrix<3>> holds;  ///< takes a vector at a node to what is held of it
};

template <int dim>
HeldBySupport held_by_support(const Structure<dim>& s, const SupportParameters& support, const FacetSet& facets) {
  HeldBySupport of;
  auto& size = of.size;
  size.assign(s.nodes(), 0.0);
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    for (const auto& facet : block.mesh.facets) {
      if (!facets.has(block.mesh, facet)) continue;
      const double share = norm(across(block.mesh, facet)) / facet.count;
      for (int k = 0; k < facet.count; ++k) size[block.first_local + facet.node[k]] += share;
    }
  }
  for (const auto& [node, along] : held_along(s, support, facets)) {
    if (node >= s.owned_nodes()) continue;
    Directions<dim> directions;
    for (const auto& one : along) directions.add(one);
    auto& holds = of.holds[node];
    for (int d = 0; d < directions.count(); ++d)
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) holds[i][j] += directions[d][i] * directions[d][j];
  }
  return of;
}

/// What a support bears of the force on a node, as springs alike in stiffness per size share it: supports that hold
/// different directions bear each what lies along theirs, those that hold the same one go by their sizes.
/// @param of_all  sizes times what is held, of all supports
template <int dim>
Matrix<3> share_of(const Held& held, int node, const Matrix<3>& mine, double size, const Matrix<3>& of_all) {
  const auto free = [&](int c) { return c >= dim || !held[dim * static_cast<std::size_t>(node) + c]; };
  Matrix<3> half{}, own{}, share{};  // of_all along the axes of the node, of which those that are free bear nothing
  for (int i = 0; i < 3; ++i) half[i] = held.to_own(node, of_all[i]);
  for (int j = 0; j < 3; ++j) {
    const auto column = held.to_own(node, Vector<3>{half[0][j], half[1][j], half[2][j]});
    for (int i = 0; i < 3; ++i) own[i][j] = free(i) || free(j) ? 0.0 : column[i];
  }
  for (int i = 0; i < dim; ++i) {
    auto wanted = held.to_own(node, size * mine[i]);
    for (int c = 0; c < 3; ++c)
      if (free(c)) wanted[c] = 0;
    share[i] = held.from_own(node, solve_positive(own, wanted));
  }
  return share;
}

}  // namespace

std::vector<std::vector<HeldNode>> held_nodes(const std::vector<Named<SupportParameters>>& supports,
                                              const Model& model) {
  std::vector<HeldBySupport> each;
  std::map<int, Matrix<3>> all;  // sizes times what is held
  for (const auto& [name, support] : supports) {
    each.push_back(model.in_geometry([&, &p = support](const auto& source, const auto& structure) {
      return held_by_support(structure, p, facet_set(source, {p.on, p.blocks}));
    }));
    for (const auto& [node, holds] : each.back().holds)
      for (int i = 0; i < 3; ++i) all[node][i] = all[node][i] + each.back().size[node] * holds[i];
  }
  std::vector<std::vector<HeldNode>> held(each.size());
  for (std::size_t k = 0; k < each.size(); ++k)
    for (const auto& [node, holds] : each[k].holds) {
      const double size = each[k].size[node];
      const auto share = with_components(model.components(), [&, &n = node, &h = holds](auto dim) {
        return share_of<dim>(model.held(), n, h, size, all[n]);
      });
      held[k].push_back({node, size, share});
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
    // Number of nodes, sums of their places, their forces, the moments and the sizes of these.
    std::array<double, 11> mine{};
    for (const auto& [node, size, share] : held[k]) {
      const auto x = s.place(node) - origin;
      Vector<3> force{};
      for (int c = 0; c < dim; ++c) force[c] = residual[dim * node + c];
      force = {dot(share[0], force), dot(share[1], force), dot(share[2], force)};
      const auto moment = cross(x, force);
      mine = mine + std::array<double, 11>{1,        x[0],      x[1],      x[2],      force[0],   force[1],
                                           force[2], moment[0], moment[1], moment[2], norm(force)};
    }
    const auto sum = total_of_each(*s.comm(), mine);
    if (!(sum[0] > 0)) continue;
    const Vector<3> middle{sum[1] / sum[0], sum[2] / sum[0], sum[3] / sum[0]};
    const Vector<3> force{sum[4], sum[5], sum[6]};
    const auto moment = Vector<3>{sum[7], sum[8], sum[9]} - cross(middle, force);  // about the middle
    const double square = dot(force, force);
    const auto way = square > 0 ? cross(force, (1 / square) * moment) : Vector<3>{none, none, none};
    found[supports[k].name] = {force, origin + middle + way};
    largest = std::max(largest, sum[10]);
  }
  for (auto& [name, reaction] : found)
    if (!(norm(reaction.force) > negligible_reaction * largest)) reaction.through = {none, none, none};
  return found;
}

}  // namespace voussoir

#include "run/support_warnings.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "blocks/supports.hpp"
#include "linalg/reduce.hpp"
#include "mesh/facet_set.hpp"

namespace voussoir {
namespace {

/// Whether a settlement moves component c.
bool moves(const SettlementParameters& load, int c) { return load.rotation != 0 || (c == 0 ? load.ux : load.uy) != 0; }

/// Whether a scene moves a support as this load does another.
bool moves_alike(const Scene& scene, const std::string& support, const SettlementParameters& load) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const LoadParameters& other) {
    const auto* s = load_as<SettlementParameters>(other);
    return s && s->support == support && s->ux == load.ux && s->uy == load.uy && s->rotation == load.rotation;
  });
}

/// Nodes of which both supports hold a component that the load moves, on blocks of all ranks.
long long common_nodes(const Model<2>& model, const SupportParameters& a, const SupportParameters& b,
                       const SettlementParameters& load) {
  const auto& s = model.structure();
  std::vector<char> of_a(s.nodes(), 0), of_b(s.nodes(), 0);
  for_each_node_on(s, facet_set(model.source(), {a.on, a.blocks}), [&](int node) { of_a[node] = 1; });
  for_each_node_on(s, facet_set(model.source(), {b.on, b.blocks}), [&](int node) { of_b[node] = 1; });
  bool moved = false;
  for (int c = 0; c < 2; ++c) moved |= holds(a, c) && holds(b, c) && moves(load, c);
  long long mine = 0;
  for (int node = 0; moved && node < s.owned_nodes(); ++node) mine += of_a[node] && of_b[node];
  return total_over_ranks(*s.comm(), mine);
}

}  // namespace

Warnings support_warnings(const Model<2>& model) {
  const auto& scene = model.scene();
  Warnings all;
  for (const auto& load : scene.loads) {
    const auto* settlement = load_as<SettlementParameters>(load);
    if (!settlement) continue;
    for (std::size_t i = 0; i < scene.supports.size(); ++i)
      for (std::size_t j = 0; j < scene.supports.size(); ++j) {
        const auto &moved = scene.supports[i], &other = scene.supports[j];
        if (i == j || moved.name != settlement->support || moves_alike(scene, other.name, *settlement)) continue;
        const auto nodes = common_nodes(model, moved.parameters, other.parameters, *settlement);
        if (nodes == 0) continue;
        const auto& obeyed = scene.supports[std::min(i, j)].name;
        const std::string what = std::to_string(nodes) + (nodes == 1 ? " node" : " nodes");
        all.push_back({"supports_part", scene.file + ": scene > loads > " + load.name, "", static_cast<double>(nodes),
                       "moves support " + in_quotes(moved.name) + " and not " + in_quotes(other.name) +
                           ", which holds the same component of " + what + "; there " + in_quotes(obeyed) +
                           " is obeyed, which the scene names first, and the cell beside is torn; let one of them end "
                           "before the other, or hold other components"});
      }
  }
  return all;
}

}  // namespace voussoir

#include "range/support_warnings.hpp"

#include <algorithm>
#include <array>

#include "base/dense.hpp"
#include "base/text.hpp"
#include "blocks/supports.hpp"
#include "dynamics/load_steps.hpp"
#include "linalg/reduce.hpp"
#include "mesh/facet_set.hpp"
#include "model/plane/plane_model.hpp"
#include "scene/scene.hpp"

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
long long common_nodes(const PlaneModel& model, const SupportParameters& a, const SupportParameters& b,
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

/// What supports hold of a motion of all stones as one, (along x, along y, turn by the size): sum over what is held of
/// the squares and products, the same on every rank.
std::array<double, 9> held_of_whole(const PlaneModel& model) {
  const auto& s = model.structure();
  const auto is_held = [&](int node, int c) { return model.held()[2 * node + c] != 0; };
  std::array<double, 3> sum{};  // [m, m, -] levers are about the middle of what is held
  for (int node = 0; node < s.owned_nodes(); ++node) {
    if (!is_held(node, 0) && !is_held(node, 1)) continue;
    sum[2] += 1;
    for (int c = 0; c < 2; ++c) sum[c] += s.drawn_position()[node][c];
  }
  const auto total = total_of_each(*s.comm(), sum);
  std::array<double, 9> mine{};
  for (int node = 0; node < s.owned_nodes(); ++node) {
    const auto& x = s.drawn_position()[node];
    const double row[2][3] = {{1, 0, -(x[1] - total[1] / total[2]) / s.size()},
                              {0, 1, (x[0] - total[0] / total[2]) / s.size()}};
    for (int c = 0; c < 2; ++c)
      for (int i = 0; is_held(node, c) && i < 9; ++i) mine[i] += row[c][i / 3] * row[c][i % 3];
  }
  return total_of_each(*s.comm(), mine);
}

/// Supports that leave the whole free to move in some way: where it ends up is then round-off, or nothing holds it.
void warn_of_free_whole(const Scene& scene, const PlaneModel& model, Warnings& all) {
  if (only_time(scene.stages)) return;  // stones may fly
  const auto g = held_of_whole(model);
  const bool x = g[0] > 0, y = g[4] > 0;
  constexpr double round_off = 1e-24;  // of the square of a lever
  const double mean = (g[0] + g[4] + g[8]) / 3;
  if (determinant({{{g[0], g[1], g[2]}, {g[3], g[4], g[5]}, {g[6], g[7], g[8]}}}) > round_off * mean * mean * mean)
    return;
  const std::string way = !x && !y ? "anywhere" : !x ? "along x" : !y ? "along y" : "round";
  all.push_back({"free_to_move", scene.file + ": scene > supports", "", 1.0,
                 "the supports leave the whole structure free to move " + way +
                     ": where it comes to rest there is not told by equilibrium; hold it at one place more"});
}

}  // namespace

Warnings support_warnings(const Scene& scene, const PlaneModel& model) {
  Warnings all;
  warn_of_free_whole(scene, model, all);
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

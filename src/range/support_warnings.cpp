#include "range/support_warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "base/plane_and_space.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "blocks/supports.hpp"
#include "dynamics/load_steps.hpp"
#include "linalg/reduce.hpp"
#include "mesh/facet_set.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

/// Whether a settlement moves anything along a direction.
bool moves(const SettlementParameters& load, const Vector<3>& along) {
  return dot(load.way(), along) != 0 || (load.turn.rotation != 0 && std::abs(dot(load.turn.direction(), along)) < 1);
}

/// Whether a scene moves a support as this load does another.
bool moves_alike(const Scene& scene, const std::string& support, const SettlementParameters& load) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const LoadParameters& other) {
    const auto* s = load_as<SettlementParameters>(other);
    return s && s->support == support && s->way() == load.way() && s->turn.rotation == load.turn.rotation &&
           s->turn.axis == load.turn.axis;
  });
}

/// Nodes of which both supports hold a direction that the load moves, on blocks of all ranks.
long long common_nodes(const Model& model, const SupportParameters& a, const SupportParameters& b,
                       const SettlementParameters& load) {
  const long long mine = model.in_geometry([&](const auto& source, const auto& structure) {
    constexpr int dim = std::tuple_size_v<std::decay_t<decltype(structure.middle())>>;
    std::map<int, Directions<dim>> of_a;
    for (const auto& [node, held] : held_along(structure, a, facet_set(source, {a.on, a.blocks})))
      for (const auto& along : held) of_a[node].add(along);
    long long common = 0;
    for (const auto& [node, held] : held_along(structure, b, facet_set(source, {b.on, b.blocks}))) {
      if (node >= structure.owned_nodes()) continue;
      bool moved = false;
      for (const auto& along : held) moved |= moves(load, in_space(along)) && !Directions<dim>(of_a[node]).add(along);
      common += moved;
    }
    return common;
  });
  return total_over_ranks(*model.structure().comm(), mine);
}

/// Motions of all stones as one: along each axis, then turns by the size about z, in space about x and y too.
constexpr int most_motions = 6;
using Motions = std::array<std::array<double, most_motions>, most_motions>;

/// How far a motion takes a place along a direction [m], per m of it.
/// @param x  [m] from the middle of what is held
double motion_of(int motion, const Vector<3>& x, const Vector<3>& along, int components, double size) {
  if (motion < components) return along[motion];
  constexpr int axes[] = {2, 0, 1};
  Vector<3> axis{};
  axis[axes[motion - components]] = 1;
  return dot(cross(axis, x), along) / size;
}

/// What supports hold of them: sums over what is held of the squares and products, the same on every rank.
Motions held_of_whole(const Model& model, int motions) {
  const auto& s = model.structure();
  const int dim = model.components();
  const auto places = model.in_geometry([](const auto&, const auto& structure) {
    std::vector<Vector<3>> all;
    for (int node = 0; node < structure.owned_nodes(); ++node)
      all.push_back(in_space(structure.drawn_position()[node]));
    return all;
  });
  const auto is_held = [&](int node, int c) { return model.held()[dim * node + c] != 0; };
  std::array<double, 4> sum{};  // [m, m, m, -] levers are about the middle of what is held
  for (int node = 0; node < s.owned_nodes(); ++node) {
    bool any = false;
    for (int c = 0; c < dim; ++c) any |= is_held(node, c);
    if (!any) continue;
    sum[3] += 1;
    for (int c = 0; c < 3; ++c) sum[c] += places[node][c];
  }
  const auto total = total_of_each(*s.comm(), sum);
  const Vector<3> middle{total[0] / total[3], total[1] / total[3], total[2] / total[3]};
  std::array<double, most_motions * most_motions> mine{};
  for (int node = 0; node < s.owned_nodes(); ++node)
    for (int c = 0; c < dim; ++c) {
      if (!is_held(node, c)) continue;
      const auto x = places[node] - middle;
      Vector<3> along{};
      along[c] = 1;
      along = model.held().from_own(node, along);
      for (int i = 0; i < motions; ++i)
        for (int j = 0; j < motions; ++j)
          mine[most_motions * i + j] += motion_of(i, x, along, dim, s.size()) * motion_of(j, x, along, dim, s.size());
    }
  const auto all = total_of_each(*s.comm(), mine);
  Motions held{};
  for (int i = 0; i < motions; ++i)
    for (int j = 0; j < motions; ++j) held[i][j] = all[most_motions * i + j];
  return held;
}

/// Whether every motion is held: Gauss with the largest pivot left, none of which is round-off beside the mean.
bool all_held(Motions g, int motions) {
  constexpr double round_off = 1e-12;  // of sums of squares of levers, which a
                                       // lever of 1e-6 of the size is above
  double mean = 0;
  for (int i = 0; i < motions; ++i) mean += g[i][i] / motions;
  std::vector<int> left;
  for (int i = 0; i < motions; ++i) left.push_back(i);
  while (!left.empty()) {
    const auto most = std::max_element(left.begin(), left.end(), [&](int i, int j) { return g[i][i] < g[j][j]; });
    const int p = *most;
    if (!(g[p][p] > round_off * mean)) return false;
    left.erase(most);
    for (const int i : left)
      for (const int j : left) g[i][j] -= g[i][p] * g[p][j] / g[p][p];
  }
  return true;
}

/// Supports that leave the whole free to move in some way: where it ends up is then round-off, or nothing holds it.
void warn_of_free_whole(const Scene& scene, const Model& model, Warnings& all) {
  if (only_time(scene.stages)) return;  // stones may fly
  const int dim = model.components(), motions = dim * (dim + 1) / 2;
  const auto g = held_of_whole(model, motions);
  if (all_held(g, motions)) return;
  std::string way;
  bool anywhere = true;
  for (int c = 0; c < dim; ++c) {
    anywhere &= !(g[c][c] > 0);
    if (way.empty() && !(g[c][c] > 0)) way = std::string("along ") + "xyz"[c];
  }
  if (anywhere) way = "anywhere";
  if (way.empty()) way = all_held(g, dim) ? "round" : "along what supports hold across their normals";
  all.push_back({"free_to_move", scene.file + ": scene > supports", "", 1.0,
                 "the supports leave the whole structure free to move " + way +
                     ": where it comes to rest there is not told by equilibrium; hold it at one place more"});
}

}  // namespace

Warnings support_warnings(const Scene& scene, const Model& model) {
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
        all.push_back({"supports_part", scene.file + ": scene > loads > " + load.name, "", static_cast<double>(nodes),
                       "moves support " + in_quotes(moved.name) + " and not " + in_quotes(other.name) +
                           ", which holds the same direction of " + counted(nodes, "node") + "; there " +
                           in_quotes(obeyed) +
                           " is obeyed, which the scene names first, and the cell beside is torn; let one of them end "
                           "before the other, or hold other directions"});
      }
  }
  return all;
}

}  // namespace voussoir

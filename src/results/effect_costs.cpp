#include "results/effect_costs.hpp"

#include "joints/softening.hpp"
#include "linalg/reduce.hpp"
#include "scene/scene.hpp"
#include "scene/scene_effects.hpp"

namespace voussoir {
namespace {

// What a law holds of a contact point for each of friction, cohesion and tension strength that is in play.
constexpr long long bytes_of_number = sizeof(double);
// How a point loses its strength, and what it has gone through.
constexpr long long bytes_of_softening = sizeof(Softening) + 2 * sizeof(double);

/// Of all ranks: the mass of each block, as large as the stiffness of its cells, and the matrix of the midpoint rule,
/// as large as its stiffness; velocity and acceleration of each node.
long long bytes_of_inertia(const BlockSystem& s) {
  long long mine = 2LL * s.components() * s.nodes() * static_cast<long long>(sizeof(double));
  for (int b = 0; b < s.local_blocks(); ++b) {
    const auto& block = s.nodes_of(b);
    mine += block.stiffness->bytes() + block.sparse->bytes();
  }
  return total_over_ranks(*s.comm(), mine);
}

}  // namespace

std::map<std::string, EffectSummary> effect_costs(const Scene& scene, const LoadsAtWork& loads,
                                                  const BlockSystem& structure, long long mine) {
  const auto& comm = *structure.comm();
  auto costs = loads.costs(comm);
  const long long points = total_over_ranks(comm, mine);
  for (const auto& effect : effects_of(scene)) costs[effect.name].in_play = effect.in_play();
  const bool friction = costs["friction"].in_play;
  // What a state between load steps holds of a point where something rubs: its slip, as a vector.
  const auto bytes_of_slip = static_cast<long long>(structure.components() * sizeof(double));
  costs["friction"].bytes = friction ? points * (bytes_of_number + bytes_of_slip) : 0;
  for (const auto* bond : {"cohesion", "tension strength"})
    costs[bond].bytes = costs[bond].in_play ? points * bytes_of_number : 0;
  if (costs["cohesion"].in_play || costs["tension strength"].in_play)
    costs[costs["cohesion"].in_play ? "cohesion" : "tension strength"].bytes += points * bytes_of_softening;
  const bool mortar = costs["joint stiffness"].in_play;
  costs["joint stiffness"].bytes = mortar ? points * static_cast<long long>(sizeof(PointCompliance)) : 0;
  costs["inertia"].bytes = costs["inertia"].in_play ? bytes_of_inertia(structure) : 0;
  if (!scene.construction.empty())  // a gap for each point, in the model and in the state
    costs["construction"].bytes = points * 2 * static_cast<long long>(sizeof(double));
  return costs;
}

std::map<std::string, EffectSummary> effect_costs(const Scene& scene, const Model& model) {
  return effect_costs(scene, model.loads_at_work(), model.structure(), model.points().size());
}

}  // namespace voussoir

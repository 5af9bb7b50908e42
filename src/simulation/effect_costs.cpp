#include "simulation/effect_costs.hpp"

#include <Teuchos_CommHelpers.hpp>

#include "scene/scene_effects.hpp"

namespace voussoir {
namespace {

// What a state between load steps and a law hold of a contact point for an effect of joints, whether it is in play or
// not: contact points are all of one kind, so that the solver has one loop.
constexpr long long bytes_of_friction = 3 * sizeof(double);  // tangential force, slip origin, coefficient; in the plane
constexpr long long bytes_of_strength = sizeof(double);      // cohesion, and the same again for tension strength

}  // namespace

std::map<std::string, EffectSummary> effect_costs(const Scene& scene, const LoadsAtWork<2>& loads, long long mine,
                                                  const Teuchos::Comm<int>& comm) {
  auto costs = loads.costs(comm);
  long long points = 0;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(points));
  for (const auto& effect : effects_of(scene)) costs[effect.name].in_play = effect.in_play();
  costs["friction"].bytes = points * bytes_of_friction;
  costs["cohesion"].bytes = costs["tension strength"].bytes = points * bytes_of_strength;
  if (!scene.construction.empty())  // a gap for each point, in the model and in the state
    costs["construction"].bytes = points * 2 * static_cast<long long>(sizeof(double));
  return costs;
}

std::map<std::string, EffectSummary> effect_costs(const Model<2>& model) {
  return effect_costs(model.scene(), model.loads(), model.points().size(), *model.structure().comm());
}

}  // namespace voussoir

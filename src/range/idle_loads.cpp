#include "range/idle_loads.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text.hpp"
#include "linalg/reduce.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

// Forces on free nodes below this share of the largest are round-off of sums over facets.
constexpr double round_off_of_sums = 1e-12;

/// Largest force of a load on a component of a node [N].
struct Forces {
  double held = 0, free = 0;
};

/// A load on edges or faces that stay where they are.
bool is_on_facets(const LoadParameters& load) {
  return load.facets().has_value() && !std::holds_alternative<MovingTrainParameters>(load.kind);
}

Forces forces_of(const Model& model, const std::string& load) {
  const auto& s = model.structure();
  std::vector<double> force, prescribed;
  model.loads({{load, 1.0}}, 0.0, force, prescribed);
  const auto held = model.held().held_part(force, model.components());
  Forces largest;
  for (int i = 0; i < model.components() * s.owned_nodes(); ++i) {
    largest.held = std::max(largest.held, std::abs(held[i]));
    largest.free = std::max(largest.free, std::abs(force[i] - held[i]));
  }
  return {largest_over_ranks(*s.comm(), largest.held), largest_over_ranks(*s.comm(), largest.free)};
}

/// Axes along which a settlement is to move its support, and along which that holds nothing.
std::string axes_not_held(const Model& model, const std::string& load, const SettlementParameters& settlement) {
  const auto& s = model.structure();
  const int dim = model.components();
  std::vector<double> force, prescribed;
  model.loads({{load, 1.0}}, 0.0, force, prescribed);
  const auto held = model.held().held_part(prescribed, dim);
  Vector<3> largest{};
  for (int i = 0; i < dim * s.owned_nodes(); ++i) largest[i % dim] = std::max(largest[i % dim], std::abs(held[i]));
  largest = largest_of_each(*s.comm(), largest);
  std::string axes;
  for (int c = 0; c < dim; ++c)
    if (settlement.way()[c] != 0 && largest[c] == 0) axes += (axes.empty() ? "" : " and ") + std::string(1, "xyz"[c]);
  return axes;
}

/// Whether a load with a function of time does nothing at a time.
bool is_zero_at(const Model& model, const std::string& load, double time) {
  const auto& s = model.structure();
  std::vector<double> force, prescribed;
  model.loads({{load, 1.0}}, time, force, prescribed);
  double largest = 0;
  for (int i = 0; i < model.components() * s.owned_nodes(); ++i)
    largest = std::max({largest, std::abs(force[i]), std::abs(prescribed[i])});
  return largest_over_ranks(*s.comm(), largest) == 0;
}

/// Load steps are all at one time, that of the end of the stages in time before them.
void warn_of_functions_at_rest(const Scene& scene, const Model& model, const std::string& load, Warnings& all) {
  const auto warn = [&](const std::string& where, double time, const std::string& steps) {
    if (!is_zero_at(model, load, time)) return;
    all.push_back({"zero_at_rest", scene.file + ": scene > " + where + " > " + load, "", time,
                   "is 0 in " + steps + ": load steps are all at one time, " + number_text(time) +
                       " s, at which its time function is 0; name it in a stage with a duration, or leave its time "
                       "function out"});
  };
  double time = 0;
  for (const auto& stage : scene.stages) {
    const auto named = stage.factors.find(load);
    if (stage.dynamic())
      time += stage.duration;
    else if (named != stage.factors.end() && named->second != 0)
      warn("steps > stages > " + stage.name + " > loads", time, "the load steps of this stage");
  }
  if (scene.load_factor.pattern.count(load) > 0) warn("load factor > pattern", time, "the search for a load factor");
}

bool is_used(const Scene& scene, const std::string& load) {
  return scene.load_factor.pattern.count(load) > 0 ||
         std::any_of(scene.stages.begin(), scene.stages.end(),
                     [&](const auto& s) { return s.factors.count(load) > 0; });
}

}  // namespace

Warnings warnings_of_idle_loads(const Scene& scene, const Model& model) {
  Warnings all;
  for (const auto& load : scene.loads) {
    if (!is_used(scene, load.name)) continue;
    if (load.time_function.type != TimeFunctionType::constant) {
      warn_of_functions_at_rest(scene, model, load.name, all);
      continue;
    }
    if (const auto* const settlement = std::get_if<SettlementParameters>(&load.kind)) {
      const auto axes = axes_not_held(model, load.name, *settlement);
      if (!axes.empty())
        all.push_back({"settlement_not_held", scene.file + ": scene > loads > " + load.name, "", 0,
                       "moves \"" + settlement->support + "\" along " + axes +
                           ", where that support holds nothing, so nothing moves there; hold it by its components, or "
                           "leave that part of the way out"});
    }
    const auto [held, free] = forces_of(model, load.name);
    if (held == 0 && free == 0 && is_on_facets(load) && !load.is_zero())
      all.push_back({"load_without_force", scene.file + ": scene > loads > " + load.name, "", 0,
                     "presses on none of its facets, so the structure stands as without it; look whether its level or "
                     "its place is where \"on\" lies"});
    if (!(held > 0) || free > round_off_of_sums * held) continue;
    const bool raised = scene.load_factor.pattern.count(load.name) > 0;
    all.push_back({"load_on_supports", scene.file + ": scene > loads > " + load.name, "", held,
                   "all its forces act where supports hold, so the structure stands as without it" +
                       std::string(raised ? ", at any load factor" : "") +
                       "; look whether \"on\" names the edge that is meant"});
  }
  return all;
}

}  // namespace voussoir

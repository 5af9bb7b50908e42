#include "range/absent_stones.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/components.hpp"
#include "base/text.hpp"
#include "linalg/reduce.hpp"
#include "model/scene_fit.hpp"
#include "results/observations.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

/// Acts on all stones there are, so nobody means those that are not there.
bool is_of_all_stones(const LoadParameters& load) {
  if (load_as<SelfWeightParameters>(load) || load_as<AccelerationParameters>(load) ||
      load_as<GroundMotionParameters>(load))
    return true;
  const auto* buoyancy = load_as<BuoyancyParameters>(load);
  const auto* temperature = load_as<TemperatureParameters>(load);
  return (buoyancy && buoyancy->blocks == "all") || (temperature && temperature->blocks == "all");
}

/// Of nodal vectors the sum of sizes on stones that are not there, and of all.
struct Share {
  double gone = 0, all = 0;
};

Share share_of(const BlockSystem& s, const std::vector<double>& nodal, const std::vector<char>& absent) {
  Share share;
  for (int i = 0; i < s.owned_nodes(); ++i) {
    const double size = length_of(&nodal[s.components() * i], s.components());
    share.all += size;
    if (absent[s.block_of_node()[i]]) share.gone += size;
  }
  return {total_over_ranks(*s.comm(), share.gone), total_over_ranks(*s.comm(), share.all)};
}

/// What acts in a stage: loads with a factor at its end.
struct Stage {
  std::string name;
  std::map<std::string, double> factors;
  std::vector<char> absent;  ///< per local block
};

std::vector<Stage> stages_of(const Scene& scene, const Model& model) {
  std::vector<Stage> stages;
  std::map<std::string, double> factors;
  for (std::size_t k = 0; k < scene.stages.size(); ++k) {
    for (const auto& [load, end] : scene.stages[k].factors) factors[load] = end;
    std::vector<char> absent;
    model.in_geometry([&](const auto& source, const auto& structure) {
      for (const auto& block : structure.blocks()) absent.push_back(!is_there(scene, source, block.mesh, k));
    });
    stages.push_back({in_quotes(scene.stages[k].name), factors, absent});
  }
  auto search = stages.back();
  search.name = "the search for a load factor";
  for (const auto& [load, share] : scene.load_factor.pattern) search.factors[load] += share;
  if (scene.load_factor.asked()) stages.push_back(search);
  return stages;
}

void warn_of_load(const Scene& scene, const Model& model, const LoadParameters& load, const std::vector<Stage>& stages,
                  Warnings& all) {
  constexpr double round_off = 1e-12;
  const bool moves = load_as<SettlementParameters>(load) != nullptr;
  std::vector<std::string> in;
  Share worst;
  for (const auto& stage : stages) {
    const auto it = stage.factors.find(load.name);
    if (it == stage.factors.end() || it->second == 0) continue;
    std::vector<double> force, prescribed;
    model.loads({*it}, 0, force, prescribed);
    const auto share = share_of(model.structure(), moves ? prescribed : force, stage.absent);
    if (share.gone <= round_off * share.all) continue;
    in.push_back(stage.name);
    if (share.gone > worst.gone) worst = share;
  }
  if (in.empty()) return;
  const double percent = 100 * worst.gone / worst.all;
  all.push_back(
      {"load_on_absent_stones", scene.file + ": scene > loads > " + load.name, "", worst.gone / worst.all,
       "acts on stones that are not there in " + list_of(in) + ": " +
           (moves ? three_digits(percent) + " % of what it moves; stones that appear later are moved by it as "
                                            "they appear"
                  : six_digits(worst.gone) + " N of " + six_digits(worst.all) +
                        " N are left out; let it act in stages that have these stones")});
}

void warn_of_observations(const Scene& scene, const Model& model, const std::vector<Stage>& stages, Warnings& all) {
  const Observations observations(scene, model);
  const std::vector<double> ones(model.components() * static_cast<std::size_t>(model.structure().nodes()), 1.0);
  for (const auto& observation : scene.observations) {
    if (observation.parameters.place == ObservationParameters::Place::support) continue;  // it bears 0 then
    std::vector<std::string> in;
    for (const auto& stage : stages) {
      const auto values = observations.values({ones, ones, ones, stage.absent});
      for (std::size_t k = 0; k < values.size(); ++k)
        if (observations.columns()[k] == "ux_m of " + observation.name && std::isnan(values[k]))
          in.push_back(stage.name);
    }
    if (!in.empty())
      all.push_back(
          {"observed_absent_stones", scene.file + ": scene > observations > " + observation.name, "",
           static_cast<double>(in.size()),
           "observes stones that are not there in " + list_of(in) + ": its columns of history.csv are empty then"});
  }
}

}  // namespace

Warnings warnings_of_absent_stones(const Scene& scene, const Model& model) {
  Warnings all;
  if (scene.construction.empty()) return all;
  const auto stages = stages_of(scene, model);
  for (const auto& load : scene.loads)
    if (!is_of_all_stones(load)) warn_of_load(scene, model, load, stages, all);
  warn_of_observations(scene, model, stages, all);
  return all;
}

}  // namespace voussoir

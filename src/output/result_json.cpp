#include "output/result_json.hpp"

#include <algorithm>
#include <cmath>

#include <sys/resource.h>

#include <Teuchos_CommHelpers.hpp>
#include <nlohmann/json.hpp>

#include "linalg/agree.hpp"
#include "output/safe_file.hpp"

namespace voussoir {
namespace {

using Json = nlohmann::ordered_json;

const char* word(Outcome outcome) {
  switch (outcome) {
    case Outcome::equilibrium:
      return "equilibrium";
    case Outcome::collapse:
      return "collapse";
    case Outcome::out_of_range:
      return "out_of_range";
    case Outcome::interrupted:
      return "interrupted";
    case Outcome::not_converged:
      break;
  }
  return "not_converged";
}

Json energy_book(const EnergySummary& energy) {
  Json json;
  for (const auto& term : energy_terms) json[term.name] = energy.*term.value;
  json["imbalance_J"] = energy.imbalance;
  json["imbalance_in_time_J"] = energy.imbalance_in_time;
  return json;
}

Json load_factor_search(const CollapseSummary& c) {
  Json json{{"pattern", c.pattern}};
  if (!std::isnan(c.lower)) json["lower"] = c.lower;
  json["upper"] = c.upper;
  json["sharp"] = c.sharp;
  json["certified_upper"] = c.certified;
  json["estimate_without_dilatancy"] = c.estimate;
  json["attempts"] = Json::array();
  for (const auto& a : c.attempts)
    json["attempts"].push_back({{"factor", a.factor}, {"outcome", a.outcome}, {"linear_solves", a.linear_solves}});
  return json;
}

Json joints_and_supports(const StaticsSummary& s) {
  Json json;
  const auto places = [&](const std::vector<StaticsSummary::Place>& list) {
    Json all = Json::array();
    for (const auto& p : list) {
      Json place{{"blocks", {p.block_i, p.block_j}}};
      for (int c = 0; c < s.components; ++c) place[std::string(1, "xyz"[c]) + "_m"] = p.place[c];
      place["opening_m"] = p.opening;
      all.push_back(place);
    }
    return all;
  };
  json["hinges"] = s.hinges;
  json["sliding_joints"] = s.sliding_joints;
  json["least_edge_margin"] = s.least_edge_margin;
  json["least_friction_margin"] = s.least_friction_margin;
  json["widest_hinges"] = places(s.widest_hinges);
  json["first_sliding"] = places(s.first_sliding);
  json["reactions"] = Json::object();
  for (const auto& [support, r] : s.reactions) {
    auto& reaction = json["reactions"][support];
    for (int c = 0; c < s.components; ++c) reaction[std::string(1, "xyz"[c]) + "_N"] = r.force[c];
    for (int c = 0; c < s.components; ++c) reaction[std::string("through_") + "xyz"[c] + "_m"] = r.through[c];
  }
  return json;
}

Json rigid_forces(const RigidSummary& rigid) {
  Json json{{"free_share_of_joints", rigid.free_share},
            {"free_share_is_at_least", rigid.at_least},
            {"geometric_factor_of_safety", rigid.factor},
            {"forces_found_up_to", rigid.borne},
            {"reactions", Json::object()}};
  for (const auto& [support, range] : rigid.reactions)
    for (int c = 0; c < rigid.components; ++c) {
      const auto along = std::string("_") + "xyz"[c] + "_N";
      json["reactions"][support]["least" + along] = range[c].least;
      json["reactions"][support]["most" + along] = range[c].most;
    }
  return json;
}

/// Numbers of steps that go over them alike; a dot in a name leads into an object.
void put_numbers(Json& json, const StepNumbers& numbers, OverSteps which) {
  each_number(
      [&](const char*, std::string name, OverSteps over, const auto& value) {
        std::replace(name.begin(), name.end(), '.', '/');
        if (over == which) json[Json::json_pointer('/' + name)] = value;
      },
      numbers);
}

}  // namespace

std::string result_json(const RunSummary& run) {
  Json json;
  json["scene"] = run.scene;
  json["outcome"] = word(run.outcome);
  json["load_factor"] = run.load_factor;
  if (!run.message.empty()) json["message"] = run.message;
  json["warnings"] = Json::array();
  for (const auto& w : run.warnings)
    json["warnings"].push_back(
        {{"what", w.what}, {"where", w.where}, {"when", w.when}, {"how_much", w.how_much}, {"text", w.text}});
  if (run.mechanism)
    json["mechanism"] = {{"largest_mover_block", run.mechanism->largest_mover},
                         {"largest_mover_name", run.mechanism->name},
                         {"largest_displacement_m", run.mechanism->largest_displacement},
                         {"dilates", run.mechanism->dilates}};
  if (run.statics) json["statics"] = joints_and_supports(*run.statics);
  if (run.collapse) json["collapse"] = load_factor_search(*run.collapse);
  if (run.rigid) json["rigid"] = rigid_forces(*run.rigid);
  json["ranks"] = run.ranks;
  json["blocks"] = run.blocks;
  json["joints"] = run.joints;
  json["nodes"] = run.nodes;
  json["unknowns"] = run.unknowns;
  json["candidate_points"] = run.candidate_points;
  put_numbers(json, run, OverSteps::last);
  json["steps"] = run.steps;
  json["time_s"] = run.time;
  put_numbers(json, run, OverSteps::sum);
  json["largest_penetration_m"] = run.largest_penetration;  // stands before the other largest ones
  put_numbers(json, run, OverSteps::largest);
  json["largest_displacement_m"] = run.largest_displacement;
  json["largest_displacement_time_s"] = run.time > 0 ? run.largest_displacement_time : NAN;
  json["residual_displacement_m"] = run.residual_displacement;
  json["energy"] = energy_book(run.energy);
  json["effects"] = Json::object();
  for (const auto& [name, e] : run.effects)
    json["effects"][name] = {{"in_play", e.in_play}, {"calls", e.calls}, {"seconds", e.seconds}, {"bytes", e.bytes}};
  const auto& p = run.partition;
  json["partition"] = {{"edge_cut", p.edge_cut},
                       {"neighbours", p.neighbours},
                       {"unknowns_imbalance", p.unknowns_imbalance},
                       {"selected_imbalance", p.selected_imbalance}};
  json["seconds"] = run.seconds;
  const auto& memory = run.peak_memory;
  json["peak_memory_MB"] = memory.empty() ? 0.0 : *std::max_element(memory.begin(), memory.end());
  json["peak_memory_MB_per_rank"] = memory;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void write_result_json(const std::string& path, const RunSummary& run, const Teuchos::Comm<int>& comm) {
  on_first_rank(comm, [&] { replace_file(path, result_json(run)); });
}

std::vector<double> peak_memory_per_rank(const Teuchos::Comm<int>& comm) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double here = static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;  // Linux counts in KiB
  std::vector<double> all(static_cast<std::size_t>(comm.getSize()));
  Teuchos::gatherAll(comm, 1, &here, comm.getSize(), all.data());
  return all;
}

}  // namespace voussoir

#include "run/events_of_loads.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "linalg/reduce.hpp"
#include "model/loads_at_work.hpp"
#include "range/range_check.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

/// The largest motion of a support between two sets of load factors at a time [m]. Collective.
double jump_of_supports(const Model& model, const std::map<std::string, double>& from,
                        const std::map<std::string, double>& to, double time) {
  std::vector<double> unused, before, after;
  model.loads(from, time, unused, before);
  model.loads(to, time, unused, after);
  double largest = 0;
  for (std::size_t i = 0; i < after.size(); ++i) largest = std::max(largest, std::abs(after[i] - before[i]));
  return largest_over_ranks(*model.structure().comm(), largest);
}

}  // namespace

void look_ahead(StepControl& control, const Model& model, const LoadSteps& steps) {
  const auto acting = steps.acting();
  const double begun = steps.time(0), duration = steps.stage_parameters().duration;
  control.look_ahead(steps.reached() * duration, [&](double from, double to) {
    return model.loads_at_work().resolution(acting, begun + from, begun + to).time;
  });
}

Warnings warnings_of_time_step(const Model& model, const LoadSteps& steps) {
  const auto& stage = steps.stage_parameters();
  if (stage.time_step == 0) return {};
  const auto shortest = model.loads_at_work().resolution(steps.acting(), steps.time(0), steps.time(1));
  const double interval = 2 * shortest.time;  // two steps see it
  constexpr double round_off = 1e-6;
  if (stage.time_step <= interval * (1 + round_off)) return {};
  return {{"time_step_over_load", model.file() + ": scene > steps > stages > " + stage.name + " > time step",
           "stage " + in_quotes(stage.name), stage.time_step / interval,
           "time step = " + number_text(stage.time_step) + " s is longer than the " + six_digits(interval) +
               " s in which load " + in_quotes(shortest.load) +
               " varies: a step takes its mean, so its impulse is exact, but not what it does within a step; give 0 to "
               "let the program choose"}};
}

void refuse_jumps_of_supports(const Scene& scene, const Model& model) {
  std::map<std::string, double> factors;
  double time = 0;
  for (const auto& stage : scene.stages) {
    const auto before = factors;
    for (const auto& [load, end] : stage.factors) factors[load] = end;
    const std::string where = scene.file + ": scene > steps > stages > " + stage.name;
    const std::string why =
        " (a support that jumps has an infinite speed, and what it gives to the structure would be a "
        "matter of the time step).\n  ";
    if (stage.dynamic() && stage.at_once && jump_of_supports(model, before, factors, time) > 0)
      throw InputError(where + " > at once = true\n  would move a support in no time" + why +
                       "Leave at once out, or move it in a stage of its own with a duration.");
    for (const auto& load : scene.loads) {
      const auto* settlement = load_as<SettlementParameters>(load);
      const bool acts = factors[load.name] != 0 || (before.count(load.name) > 0 && before.at(load.name) != 0);
      if (stage.dynamic() && settlement && acts && model.loads_at_work().jumps(load.name, time, time + stage.duration))
        throw InputError(scene.file + ": scene > loads > " + load.name + " > time function\n  jumps in stage " +
                         in_quotes(stage.name) + ", and would move support " + in_quotes(settlement->support) +
                         " in no time" + why + "Give a sine that begins and ends at 0, or a table.");
    }
    time += stage.duration;
  }
}

}  // namespace voussoir

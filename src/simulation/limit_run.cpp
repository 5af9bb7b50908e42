#include "simulation/limit_run.hpp"

#include <Teuchos_Time.hpp>
#include <cmath>

#include "base/text.hpp"
#include "output/output_folder.hpp"
#include "simulation/adaptive_step.hpp"
#include "simulation/construction.hpp"
#include "simulation/mechanism_words.hpp"
#include "simulation/rigid_limits.hpp"

namespace voussoir {
namespace {

/// The scene for a model that is not solved: one in time alone has no continuum.
Scene without_load_steps(Scene scene) {
  for (auto& stage : scene.stages) stage.duration = 1;
  return scene;
}

/// The stages before the first that takes time.
std::size_t static_stages(const Scene& scene) {
  std::size_t count = 0;
  while (count < scene.stages.size() && !scene.stages[count].dynamic()) ++count;
  return count;
}

std::map<std::string, double> factors_after(const Scene& scene, std::size_t stages) {
  std::map<std::string, double> factors;
  for (std::size_t k = 0; k < stages; ++k)
    for (const auto& [load, factor] : scene.stages[k].factors) factors[load] = factor;
  return factors;
}

void say_reactions(const Scene& scene, const RigidLimits& limits, std::ostream& say) {
  const auto end = [](const std::optional<double>& force) { return force ? six_digits(*force) : std::string("any"); };
  for (std::size_t k = 0; k < scene.supports.size(); ++k) {
    const auto x = limits.reaction(static_cast<int>(k), 0, 0), y = limits.reaction(static_cast<int>(k), 1, 0);
    say << "Support '" << scene.supports[k].name << "' can bear from " << end(x.least) << " to " << end(x.most)
        << " N sideways, from " << end(y.least) << " to " << end(y.most) << " N upwards.\n";
  }
}

}  // namespace

RunSummary limit_run(const Scene& scene, const BlockSource<2>& source, const std::string& folder,
                     const Teuchos::RCP<const Teuchos::Comm<int>>& comm, std::ostream& say) {
  Teuchos::Time clock("limit analysis", true);
  const auto unsolved = without_load_steps(scene);
  Model<2> model(unsolved, source, comm);
  RunSummary summary;
  summary.scene = scene.file;
  summary.ranks = comm->getSize();
  summary.blocks = source.block_count();
  summary.joints = model.points().total_joints();
  summary.nodes = model.structure().total_nodes();
  summary.candidate_points = model.points().total();
  const auto stages = static_stages(scene);
  std::vector<char> absent;
  if (!scene.construction.empty() && stages > 0) {
    Construction<2> construction(model);
    auto state = AdaptiveStep<2>(model).initial_state();
    construction.begin(scene.stages[stages - 1].name, model, state);
    absent = construction.absent();
  }
  const auto factors = factors_after(scene, stages);
  RigidTask task{&absent, nullptr, {}, {}};
  std::vector<double> prescribed;
  model.loads(factors, 0, task.fixed, prescribed);
  const auto& search = scene.load_factor;
  if (search.asked()) task.raised = loads_of_pattern(model, factors, search.pattern, 0);
  const RigidLimits limits(model, task);
  const auto prove = [&](const LimitAnswer& answer) {
    const auto mechanism = limits.on_nodes(answer);
    summary.outcome = Outcome::collapse;
    summary.mechanism = largest_mover(model, mechanism);
    summary.message += "; " + mechanism_in_words(model, mechanism);
  };
  const auto now = limits.bears(0);
  if (now.verdict == LimitVerdict::refused) {
    summary.message =
        "no forces that joints admit balance the loads, so that no equilibrium exists, by the static theorem";
    prove(now);
  } else if (now.verdict == LimitVerdict::unknown) {
    summary.message = "the linear programme could not be solved exactly enough to prove anything";
  } else {
    summary.outcome = Outcome::equilibrium;
    double free_share = 0;
    limits.most_balanced(0, &free_share);
    summary.message = "forces that joints admit balance the loads; they can leave " + six_digits(100 * free_share) +
                      " % of every dry joint free, a geometric factor of safety of " +
                      six_digits(1 / (1 - free_share));
    say_reactions(scene, limits, say);
    if (search.asked()) {
      const auto limit = limits.largest_factor(search.largest);
      summary.collapse = CollapseSummary{search.pattern, 0, INFINITY, true, {}, INFINITY, INFINITY};
      auto& c = *summary.collapse;
      if (limit.verdict == LimitVerdict::limited) {
        c.certified = c.upper = limit.factor;
        if (const auto estimate = limits.without_dilatancy(search.largest, limit)) c.estimate = *estimate;
        summary.message = "above " + six_digits(limit.factor) +
                          " times the pattern no equilibrium exists, by the static theorem; rigid stones whose slip "
                          "dilates stand up to there" +
                          (std::isfinite(c.estimate) ? ", an estimate where it does not is " + six_digits(c.estimate)
                                                     : "");
        prove(limit);
      } else if (limit.verdict == LimitVerdict::unlimited) {
        c.lower = search.largest;
        summary.message +=
            "; so they do at " + six_digits(search.largest) + " times the pattern, the largest asked for";
      } else {
        summary.outcome = Outcome::not_converged;
        summary.message += "; how far the pattern can be raised could not be solved exactly enough";
      }
    }
  }
  summary.seconds["total"] = clock.totalElapsedTime(true);
  summary.peak_memory = peak_memory_per_rank(*comm);
  write_result_json(folder + "/" + result_file, summary, *comm);
  return summary;
}

}  // namespace voussoir

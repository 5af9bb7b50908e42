#include "simulation/simulation.hpp"

#include <Teuchos_Time.hpp>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "base/error.hpp"
#include "dynamics/load_steps.hpp"
#include "mesh/block_source.hpp"
#include "mesh/mesh_check.hpp"
#include "output/output_folder.hpp"
#include "output/safe_file.hpp"
#include "scene/scene_printer.hpp"
#include "simulation/effect_costs.hpp"
#include "simulation/narrator.hpp"
#include "simulation/phase.hpp"
#include "simulation/prediction.hpp"
#include "simulation/recorder.hpp"
#include "simulation/scene_fit.hpp"

namespace voussoir {
namespace {

using Comm = Teuchos::RCP<const Teuchos::Comm<int>>;

void write_scene_file(const Scene& scene, const std::string& folder, const Teuchos::Comm<int>& comm) {
  on_first_rank(comm, [&] {
    std::ostringstream text;
    write_scene(text, scene);
    replace_file(folder + "/scene.xml", text.str());
  });
}

/// The load steps of a scene.
class Run {
 public:
  Run(const Model<2>& model, const RunOptions& options, std::ostream& say)
      : model_(model), step_(model), recorder_(model, step_, options.folder), narrator_(say, options.verbose) {
    step_.narrate = [this](const NewtonProgress& p) { narrator_.solve(p); };
    step_.narrate_round = [this](int round, long long selected, double estimate) {
      narrator_.round(round, selected, estimate);
    };
  }

  RunSummary all_steps() {
    const auto& scene = model_.scene();
    LoadSteps steps(scene.stages, scene.load_steps);
    auto state = step_.initial_state();
    std::vector<double> load(state.displacement.size(), 0.0);
    auto& summary = recorder_.summary();
    summary.outcome = Outcome::equilibrium;
    while (!steps.finished()) {
      const auto before = state;
      std::vector<double> next_load, prescribed;
      model_.loads(steps.factors(), 0.0, next_load, prescribed);
      narrator_.begin(summary.steps + 1, steps.stage(), steps.target(), steps.progress());
      Teuchos::Time clock("step", true);
      const auto report = step_.solve(state, next_load, prescribed);
      const double seconds = clock.totalElapsedTime(true);
      if (report.newton.outcome != NewtonOutcome::converged) {
        const bool collapse = report.newton.outcome == NewtonOutcome::collapse;
        narrator_.failed(report, steps.stage(), steps.target());
        failed_ = state;
        state = before;
        if (steps.halve()) continue;
        fail(collapse, report, steps, state);
        return summary;
      }
      recorder_.set_free_strain(model_.loads().free_strain(steps.factors(), 0.0));
      const std::string stage = steps.stage();
      const double target = steps.target();
      steps.accept();
      const int every = scene.output.every;
      const bool write = steps.finished() || (summary.steps + 1) % every == 0;
      recorder_.record(before, load, state, next_load, report, stage, target, write, seconds);
      narrator_.end(report, recorder_.status(), seconds, summary);
      load = next_load;
    }
    return summary;
  }

 private:
  void fail(bool collapse, const StepReport& report, const LoadSteps& steps, const ContactState& state) {
    auto& summary = recorder_.summary();
    summary.outcome = collapse ? Outcome::collapse : Outcome::not_converged;
    summary.load_factor = steps.reached();
    summary.message = "stage '" + steps.stage() + "', load factor " + std::to_string(steps.target()) + ": " +
                      report.newton.reason;
    if (!collapse) return;
    recorder_.record_mechanism(step_.mechanism(), failed_, steps.stage(), steps.target());
    summary.mechanism = largest_mover(model_, step_.mechanism());
    static_cast<void>(state);
  }

  const Model<2>& model_;
  AdaptiveStep<2> step_;
  Recorder<2> recorder_;
  Narrator narrator_;
  ContactState failed_;
};

}  // namespace

std::unique_ptr<BlockSource<2>> checked_blocks(const Scene& scene, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  Phase phase("mesh");
  std::unique_ptr<BlockSource<2>> source;
  try {
    source = make_block_source<2>(scene.mesh, *comm);
    check_fit(scene, *source);
    std::vector<std::string> supported;
    for (const auto& [name, support] : scene.supports) supported.push_back(support.on);
    if (scene.mesh.type == MeshType::gmsh)
      check_blocks(*source, supported, *comm);
    else
      check_supports(*source, supported);
  } catch (const InputError& error) {
    const std::string what = error.what();
    if (what.rfind(scene.file, 0) == 0) throw;
    throw InputError(scene.file + ": " + what);
  }
  return source;
}

RunSummary run(const Scene& scene, const RunOptions& options, const Comm& comm, std::ostream& say) {
  Teuchos::Time clock("total", true);
  print_scene(say, scene);
  const auto source = checked_blocks(scene, comm);
  if (options.validate) {
    say << "The scene is valid: " << source->block_count() << " blocks.\n";
    return {};
  }
  if (options.dry_run) {
    predict(scene, *source, comm, say);
    return {};
  }
  const std::string kept = prepare_output_folder(options.folder, options.overwrite, *comm);
  if (!kept.empty()) say << "Earlier results were kept in " << kept << "\n";
  write_scene_file(scene, options.folder, *comm);
  const Model<2> model(scene, *source, comm);
  say << source->block_count() << " blocks, " << model.points().total_joints() << " joints, "
      << model.structure().total_nodes() << " nodes, " << model.points().total() << " contact points, on "
      << comm->getSize() << (comm->getSize() == 1 ? " rank\n" : " ranks\n");
  for (const auto& remark : model.loads().remarks()) say << remark << "\n";
  auto summary = Run(model, options, say).all_steps();
  summary.seconds = seconds_of_phases({"mesh", "blocks", "joints", "continuum", "contact", "selection", "output"});
  summary.seconds["total"] = clock.totalElapsedTime(true);
  summary.effects = effect_costs(model);
  summary.peak_memory = peak_memory_per_rank(*comm);
  write_result_json(options.folder + "/result.json", summary, *comm);
  return summary;
}

}  // namespace voussoir

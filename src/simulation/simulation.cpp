#include "simulation/simulation.hpp"

#include <Teuchos_Time.hpp>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "base/error.hpp"
#include "base/text.hpp"
#include "dynamics/load_steps.hpp"
#include "dynamics/step_control.hpp"
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

/// The steps of a scene.
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
    state_ = step_.initial_state();
    load_.assign(state_.displacement.size(), 0.0);
    auto& summary = recorder_.summary();
    summary.outcome = Outcome::equilibrium;
    while (!steps.finished() && (steps.dynamic() ? time_step(steps) : load_step(steps))) {
    }
    return summary;
  }

 private:
  bool load_step(LoadSteps& steps) {
    const auto& summary = recorder_.summary();
    dynamics_.reset();
    state_.velocity.clear();
    const auto before = state_;
    std::vector<double> load, prescribed;
    model_.loads(steps.factors(), steps.time(), load, prescribed);
    narrator_.begin(summary.steps + 1, steps.stage(), steps.target(), steps.progress());
    Teuchos::Time clock("step", true);
    const auto report = step_.solve(state_, load, prescribed);
    const double seconds = clock.totalElapsedTime(true);
    if (report.newton.outcome != NewtonOutcome::converged) {
      narrator_.failed(report, steps.stage(), steps.target());
      failed_ = state_;
      state_ = before;
      if (steps.halve()) return true;
      fail(report, step_.mechanism(), steps);
      return false;
    }
    recorder_.set_free_strain(model_.loads().free_strain(steps.factors(), steps.time()));
    const std::string stage = steps.stage();
    const double target = steps.target();
    steps.accept();
    recorder_.record(before, load_, state_, load, report, stage, target, writes(steps), seconds);
    narrator_.end(report, recorder_.status(), seconds, summary);
    load_ = load;
    return true;
  }

  bool time_step(LoadSteps& steps) {
    const auto& summary = recorder_.summary();
    begin_time(steps);
    const double time_step = control_->time_step();
    steps.set_time_step(time_step);
    dynamics_->set_time_step(time_step);
    const auto before = state_;
    const double target = steps.target(), time = steps.time(target);
    std::vector<double> load, prescribed, unused;
    const double middle = (steps.reached() + target) / 2;
    model_.loads(steps.factors(middle), steps.time(middle), load, unused);
    model_.loads(steps.factors(target), time, unused, prescribed);
    narrator_.begin(summary.steps + 1, steps.stage(), time, steps.progress());
    Teuchos::Time clock("step", true);
    const auto report = dynamics_->solve(state_, load, prescribed);
    const double seconds = clock.totalElapsedTime(true);
    if (report.step.newton.outcome != NewtonOutcome::converged) {
      narrator_.failed(report.step, steps.stage(), time);
      failed_ = state_;
      state_ = before;
      if (control_->halve()) {
        narrator_.say("  Time step halved to " + number_text(control_->time_step()) + " s.");
        return true;
      }
      fail(report.step, dynamics_->mechanism(), steps);
      return false;
    }
    recorder_.set_free_strain(model_.loads().free_strain(steps.factors(), time));
    const std::string stage = steps.stage();
    const double duration = steps.stage_parameters().duration;
    steps.accept();
    const bool write = writes(steps);
    recorder_.record(before, state_, report, stage, target, time, write, seconds);
    narrator_.end(report.step, recorder_.status(), seconds, summary, write);
    if (control_->accept(report.error, target * duration) && !write)
      narrator_.say("  Time step " + number_text(control_->time_step()) + " s from t = " + number_text(time) + " s.");
    if (steps.stage_reached()) control_.reset();
    model_.loads(steps.last_factors(), time, load_, unused);
    return true;
  }

  /// Mass matrices and initial velocities before the first time step, the time step before every stage.
  void begin_time(const LoadSteps& steps) {
    if (!dynamics_) {
      dynamics_ = std::make_unique<DynamicStep<2>>(model_);
      dynamics_->narrate = step_.narrate;
      dynamics_->narrate_round = step_.narrate_round;
      recorder_.give(dynamics_->begin(state_));
    }
    if (control_) return;
    const auto& stage = steps.stage_parameters();
    const auto& time = model_.scene().time;
    control_ = std::make_unique<StepControl>(stage.duration, stage.time_step, dynamics_->courant_time(),
                                             time.largest_courant, time.error_tolerance, time.largest_halvings);
  }

  bool writes(const LoadSteps& steps) const {
    return steps.finished() || (recorder_.summary().steps + 1) % model_.scene().output.every == 0;
  }

  void fail(const StepReport& report, const std::vector<double>& mechanism, const LoadSteps& steps) {
    const bool collapse = report.newton.outcome == NewtonOutcome::collapse;
    auto& summary = recorder_.summary();
    summary.outcome = collapse ? Outcome::collapse : Outcome::not_converged;
    summary.load_factor = steps.reached();
    summary.message = "stage '" + steps.stage() + "', load factor " + std::to_string(steps.target()) + ": " +
                      report.newton.reason;
    if (!collapse) return;
    recorder_.record_mechanism(mechanism, failed_, steps.stage(), steps.target());
    summary.mechanism = largest_mover(model_, mechanism);
  }

  const Model<2>& model_;
  AdaptiveStep<2> step_;
  Recorder<2> recorder_;
  Narrator narrator_;
  std::unique_ptr<DynamicStep<2>> dynamics_;  ///< in stages with a duration
  std::unique_ptr<StepControl> control_;      ///< of the stage
  ContactState state_, failed_;
  std::vector<double> load_;  ///< [N] at the end of the last step
};

}  // namespace

std::unique_ptr<BlockSource<2>> checked_blocks(const Scene& scene, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  Phase phase("mesh");
  std::unique_ptr<BlockSource<2>> source;
  try {
    source = make_block_source<2>(scene.mesh, *comm);
    check_fit(scene, *source);
    std::vector<std::string> supported;
    // Blocks may fly where no static equilibrium is sought: then no support is asked for.
    if (!only_time(scene.stages))
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

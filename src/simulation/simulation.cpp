#include "simulation/simulation.hpp"

#include <Teuchos_Time.hpp>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "dynamics/load_steps.hpp"
#include "dynamics/step_control.hpp"
#include "output/output_folder.hpp"
#include "scene/scene_printer.hpp"
#include "simulation/coarse_joints.hpp"
#include "simulation/construction.hpp"
#include "simulation/effect_costs.hpp"
#include "simulation/finite_rotations.hpp"
#include "simulation/halved_step.hpp"
#include "simulation/input_warnings.hpp"
#include "simulation/limit_run.hpp"
#include "simulation/load_factor_analysis.hpp"
#include "simulation/masonry_statics.hpp"
#include "simulation/mechanism_words.hpp"
#include "simulation/narrator.hpp"
#include "simulation/phase.hpp"
#include "simulation/prediction.hpp"
#include "simulation/range_check.hpp"
#include "simulation/recorder.hpp"
#include "simulation/saved_run.hpp"
#include "simulation/scene_file.hpp"
#include "simulation/shares_of_ranks.hpp"
#include "simulation/static_theorem.hpp"
#include "simulation/stop_signals.hpp"
#include "simulation/tie_balance.hpp"

namespace voussoir {
namespace {

using Comm = Teuchos::RCP<const Teuchos::Comm<int>>;

constexpr auto phases = {"mesh", "blocks", "joints", "continuum", "contact", "selection", "range", "output"};

struct StopWithinStep {};  ///< thrown when a signal is seen within a step, which is given up

/// The steps of a scene.
class Run {
 public:
  /// @param clock  of the whole run
  /// @param branched  the folder to go on from, where that is another
  Run(Model<2>& model, const RunOptions& options, const BranchedFolder* branched, const Teuchos::Time& clock,
      std::ostream& say)
      : model_(model),
        clock_(clock),
        say_(say),
        step_(model),
        steps_(model.scene().stages, model.scene().load_steps),
        state_(step_.initial_state()),
        construction_(model),
        theorem_(model),
        range_(model, [this](const Warning& w) { warn(w); }),
        load_(state_.displacement.size(), 0.0),
        saved_(model, options.folder, options.restart_from) {
    const auto& search = model.scene().load_factor;
    if (search.asked()) load_factor_ = std::make_unique<LoadFactorAnalysis>(search);
    for (const char* phase : phases) seconds_[phase] = 0;
    seconds_["total"] = 0;
    Record so_far;
    if (options.restart || branched) restore(so_far);
    nothing_left_ = options.restart && finished() && holds_result(options.folder, *model.structure().comm());
    if (nothing_left_) return;
    if (branched) branched->copy_records(model.scene().output.fields);
    recorder_ = std::make_unique<Recorder<2>>(model, step_, options.folder, so_far);
    if (recorder_->fields_lost())
      say << "fields.h5 is missing or was damaged when the run was interrupted: fields begin anew from here.\n";
    narrator_ = std::make_unique<Narrator>(say, options.verbose);
    step_.narrate = [this](const NewtonProgress& p) {
      narrator_->solve(p);
      theorem_.count_solve();
      if (stop_signal_on_any_rank(*model_.structure().comm())) throw StopWithinStep{};
    };
    step_.narrate_round = [this](int round, long long selected, double estimate) {
      narrator_->round(round, selected, estimate);
    };
  }

  const RunSummary& summary() const { return recorder_->summary(); }
  /// The run that was to be gone on with has come to its end, and the scene asks for no more: nothing was touched.
  bool nothing_left() const { return nothing_left_; }

  /// Tells and keeps what the result leaves open. The same on all ranks.
  void warn(const Warning& warning) {
    if (recorder_->warn(warning)) narrator_->warn(warning);
  }

  const RunSummary& all_steps() {
    auto& summary = recorder_->summary();
    summary.outcome = Outcome::equilibrium;
    while (!finished()) {
      const bool in_time = !steps_.finished() && steps_.dynamic();
      const auto& stage = steps_.finished() ? model_.scene().stages.back().name : steps_.stage();
      construction_.begin(stage, model_, state_);
      if (in_time) begin_time();  // initial velocities belong to the state a failed step goes back to
      const auto before = state_;
      try {
        if (steps_.finished())
          load_factor_->attempt(attempting());
        else if (!(in_time ? time_step(before) : load_step(before)))
          return summary;
      } catch (const StopWithinStep&) {
        state_ = before;
        return interrupted();
      }
      if (model_.brittle())
        for (const auto& w : coarse_joints(model_, state_, at_factor(stage, recorder_->summary().load_factor))) warn(w);
      if (finished()) break;
      if (stop_signal_on_any_rank(*model_.structure().comm())) return interrupted();
      saved_.save_when_due(here());
    }
    const bool keep = model_.scene().output.checkpoint_at_end;
    if (keep) keep_last_state();  // without the mechanism, which is no step to go on from
    if (load_factor_) load_factor_->conclude(attempting());
    const bool undecided = summary.outcome == Outcome::not_converged || summary.outcome == Outcome::out_of_range;
    if (!keep && undecided) saved_.save(here());
    return summary;
  }

  /// What joints and supports carry in the last equilibrium; nothing of a run that ends in time, or found none.
  void write_joints(const std::string& folder) {
    auto& summary = recorder_->summary();
    if (!in_motion(*model_.structure().comm(), state_) && summary.steps > 0)
      summary.statics = write_statics(model_, step_, state_, load_, folder);
  }
  /// What nobody wants to go on with is removed.
  void end() {
    if (model_.scene().output.checkpoint_at_end) return;
    const auto& summary = recorder_->summary();
    const bool found = summary.collapse && summary.outcome == Outcome::collapse;
    if (summary.outcome == Outcome::equilibrium || found) saved_.remove();
  }
  /// How evenly ranks share what is there now.
  PartitionSummary partition() const {
    const auto quality = partition_quality(model_);
    return {quality.cut, quality.neighbours, quality.imbalance, imbalance_of_selected(model_, state_)};
  }
  /// Seconds by phase, of all parts of the run.
  std::map<std::string, double> seconds() const {
    auto all = seconds_;
    for (const auto& [phase, seconds] : seconds_of_phases(phases)) all[phase] += seconds;
    all["total"] += clock_.totalElapsedTime(true);
    return all;
  }

 private:
  struct Failure {
    ContactState state;
    StepReport report;
    std::vector<double> mechanism;
    double target = 0;
    bool collapse() const { return report.newton.outcome == NewtonOutcome::collapse; }
  };

  /// False when the run ends here.
  bool load_step(const ContactState& before) {
    const auto& summary = recorder_->summary();
    dynamics_.reset();
    if (!state_.velocity.empty()) untie_what_moved(model_, state_);
    state_.velocity.clear();
    std::vector<double> next_load, prescribed;
    model_.loads(steps_.factors(), steps_.time(), next_load, prescribed);
    construction_.restrict(state_, next_load, prescribed);
    narrator_->begin(summary.steps + 1, steps_.stage(), steps_.target(), steps_.progress());
    Teuchos::Time clock("step", true);
    const LoadStepBook<2> book(model_, step_, before, load_);
    theorem_.begin(construction_.absent(), before.broken, load_, next_load, steps_.target() == 1);
    const auto report = theorem_.solve(step_, model_, state_, prescribed);
    const double seconds = clock.totalElapsedTime(true);
    const std::string stage = steps_.stage();
    const double target = steps_.target();
    if (report.newton.outcome != NewtonOutcome::converged) {
      narrator_->failed(report, stage, target);
      const auto failed = std::exchange(state_, before);
      if (const auto& r = theorem_.refusal()) return fail({failed, report, r->mechanism, target}, target);
      if (!failure_ || !failure_->collapse() || report.newton.outcome == NewtonOutcome::collapse)
        failure_ = Failure{failed, report, step_.mechanism(), target};
      const bool same = half_asks_the_same(model_, construction_, steps_, before, next_load, prescribed);
      if (!same && steps_.halve()) return true;
      return fail(*failure_, target);
    }
    if (!in_range({state_, next_load, construction_.absent(), at_factor(stage, target)}, before)) return false;
    for (const auto& w : held_by_ties(report.tied_share, report.tied_block, at_factor(stage, target))) warn(w);
    failure_.reset();
    recorder_->set_free_strain(model_.loads().free_strain(steps_.factors(), steps_.time()));
    steps_.accept();
    recorder_->record(book, state_, next_load, report, stage, target, writes(), seconds);
    narrator_->end(report, recorder_->status(), seconds, summary);
    load_ = next_load;
    return true;
  }

  /// False when the run ends here.
  bool time_step(const ContactState& before) {
    const double time_step = control_->time_step();
    steps_.set_time_step(time_step);
    dynamics_->set_time_step(time_step);
    const std::string stage = steps_.stage();
    const double target = steps_.target(), time = steps_.time(target);
    std::vector<double> load, prescribed;
    loads_of_time_step(model_, steps_, load, prescribed);
    narrator_->begin(recorder_->summary().steps + 1, stage, time, steps_.progress());
    Teuchos::Time clock("step", true);
    const auto report = dynamics_->solve(state_, load, prescribed);
    const double seconds = clock.totalElapsedTime(true);
    if (report.step.newton.outcome != NewtonOutcome::converged) {
      narrator_->failed(report.step, stage, time);
      const auto failed = std::exchange(state_, before);
      if (control_->halve()) {
        narrator_->say("  Time step halved to " + number_text(control_->time_step()) + " s.");
        return true;
      }
      return fail({failed, report.step, dynamics_->mechanism(), steps_.target()}, steps_.target());
    }
    const bool compares = target == 1 || writes();  // outlines of stones
    if (!in_range({state_, load, construction_.absent(), at_time(stage, time), true, compares}, before)) return false;
    for (const auto& w : held_by_ties(report.step.tied_share, report.step.tied_block, at_time(stage, time))) warn(w);
    recorder_->set_free_strain(model_.loads().free_strain(steps_.factors(target), time));
    const double duration = steps_.stage_parameters().duration;
    steps_.accept();
    model_.loads(steps_.last_factors(), time, load_, prescribed);
    const bool write = writes();
    recorder_->record(before, state_, report, stage, target, time, write, seconds);
    narrator_->end(report.step, recorder_->status(), seconds, recorder_->summary(), write);
    control_->accept(report.error, target * duration);
    if (steps_.stage_reached()) {
      control_.reset();
      level_ = {};
    }
    return true;
  }

  /// Mass matrices and initial velocities before the first time step, the time step before every stage.
  void begin_time() {
    if (!dynamics_) {
      dynamics_ = std::make_unique<DynamicStep<2>>(model_);
      dynamics_->narrate = step_.narrate;
      dynamics_->narrate_round = step_.narrate_round;
      recorder_->give(dynamics_->begin(state_));
    }
    if (control_) return;
    const auto& stage = steps_.stage_parameters();
    const auto& time = model_.scene().time;
    const double courant_time = dynamics_->courant_time();
    const double longest = std::min(time.largest_courant * courant_time, model_.loads().resolution());
    control_ = std::make_unique<StepControl>(level_, stage.duration, stage.time_step, courant_time, longest,
                                             time.error_tolerance, time.largest_halvings);
  }

  bool finished() const { return steps_.finished() && (!load_factor_ || load_factor_->finished()); }

  Attempting attempting() {
    return {model_, step_, construction_, steps_, state_, load_, *recorder_, *narrator_, range_};
  }

  bool writes() const {
    return steps_.finished() || (recorder_->summary().steps + 1) % model_.scene().output.every == 0;
  }

  /// False when a step that was solved is beyond what the model can tell; then the run ends in the state before it.
  bool in_range(const StepEnd& end, const ContactState& before) {
    const auto beyond = range_.beyond(end);
    if (beyond.empty()) return true;
    state_ = before;
    go_back(model_, before);
    saved_.save(here());
    auto& summary = recorder_->summary();
    summary.outcome = Outcome::out_of_range;
    summary.load_factor = steps_.reached();
    summary.message = end.when + ": " + beyond;
    return false;
  }

  /// The run ends here: false.
  /// @param last  the load tried last; where a smaller one is not decided, the collapse under a larger one is told
  bool fail(const Failure& failure, double last) {
    auto& summary = recorder_->summary();
    saved_.save(here());
    summary.outcome = failure.collapse() ? Outcome::collapse : Outcome::not_converged;
    summary.load_factor = steps_.reached();
    summary.message = "stage '" + steps_.stage() + "', load factor " + std::to_string(failure.target) + ": " +
                      failure.report.newton.reason;
    if (!failure.collapse()) return false;
    if (last < failure.target)
      summary.message += "; smaller steps, down to load factor " + std::to_string(last) + ", could not be decided";
    recorder_->record_mechanism(failure.mechanism, failure.state, steps_.stage(), failure.target);
    summary.mechanism = largest_mover(model_, failure.mechanism);
    summary.message += "; " + mechanism_in_words(model_, failure.mechanism);
    return false;
  }

  RunState here() {
    seconds_so_far_ = seconds();
    return {steps_, state_, load_, level_, recorder_->so_far(), seconds_so_far_, load_factor_.get()};
  }

  /// The results of a run that is done do not depend on whether its state can be kept.
  void keep_last_state() {
    try {
      saved_.save(here());
    } catch (const ResourceError& error) {
      narrator_->say(std::string("No further stage can follow this run: ") + error.what());
    }
  }

  const RunSummary& interrupted() {
    saved_.save(here());
    recorder_->summary().outcome = Outcome::interrupted;
    return recorder_->summary();
  }

  void restore(Record& so_far) {
    const RunState state{steps_, state_, load_, level_, so_far, seconds_, load_factor_.get()};
    const auto changed = saved_.restore(state);
    if (model_.scene().model.rotations == Rotations::finite) model_.follow(state_.displacement);
    say_ << words_of(state, changed);
    forget_input_warnings(so_far.summary.warnings);
    const auto& stages = model_.scene().stages;
    if (finished() && !stages.empty()) construction_.begin(stages.back().name, model_, state_);
  }

  Model<2>& model_;
  const Teuchos::Time& clock_;
  std::ostream& say_;
  AdaptiveStep<2> step_;
  LoadSteps steps_;
  std::unique_ptr<DynamicStep<2>> dynamics_;  ///< in stages with a duration
  std::unique_ptr<StepControl> control_;      ///< of the stage
  TimeStepLevel level_;
  ContactState state_;
  Construction<2> construction_;
  StaticTheorem theorem_;
  RangeCheck range_;
  std::unique_ptr<LoadFactorAnalysis> load_factor_;  ///< where the scene asks for one
  /// The load step that failed while smaller ones are tried: a collapse where one was found. Not in checkpoints: a run
  /// stopped and restarted meanwhile tells what its last attempt came to.
  std::optional<Failure> failure_;
  std::vector<double> load_;
  SavedRun saved_;
  bool nothing_left_ = false;
  std::map<std::string, double> seconds_;         ///< by phase, of earlier parts of the run
  std::map<std::string, double> seconds_so_far_;  ///< the same with this part
  std::unique_ptr<Recorder<2>> recorder_;
  std::unique_ptr<Narrator> narrator_;
};

}  // namespace

RunSummary run(const Scene& scene, const RunOptions& options, const Comm& comm, std::ostream& say) {
  Teuchos::Time clock("total", true);
  print_scene(say, scene, options.verbose);
  const auto source = checked_blocks(scene, comm);
  if (options.validate || options.dry_run)
    for (const auto& w : mesh_warnings(scene, *source)) say << "WARNING: " << w.where << ": " << w.text << ".\n";
  if (options.validate) {
    say << "The scene is valid: " << source->block_count() << " blocks.\n";
    return {};
  }
  if (options.dry_run) return predict(scene, *source, comm, say), RunSummary{};
  const auto earlier = options.restart ? Earlier::go_on : options.overwrite ? Earlier::remove : Earlier::keep;
  std::optional<BranchedFolder> branched;
  if (!options.restart_from.empty()) branched.emplace(options.restart_from, options.folder, *comm);
  const OutputFolder folder(options.folder, earlier, *comm);
  if (!folder.kept().empty()) say << "Earlier results were kept in " << folder.kept() << "\n";
  if (!options.restart && !branched) write_scene_file(scene, options.folder, *comm);
  if (options.limit_analysis) return limit_run(scene, *source, options.folder, comm, say);
  Model<2> model(scene, *source, comm);
  say << source->block_count() << " blocks, " << model.points().total_joints() << " joints, "
      << model.structure().total_nodes() << " nodes, " << model.points().total() << " contact points, on "
      << comm->getSize() << (comm->getSize() == 1 ? " rank\n" : " ranks\n");
  for (const auto& remark : model.loads().remarks()) say << remark << "\n";
  Run run(model, options, branched ? &*branched : nullptr, clock, say);
  if (run.nothing_left()) {
    say << "Nothing is left to compute, and nothing was changed: the run in " << options.folder
        << " has come to its end.\nGive a scene with further stages to go on, or leave --restart out to compute it "
           "again.\n";
    return {};
  }
  for (const auto& warning : input_warnings(model)) run.warn(warning);
  if (options.restart || branched) write_scene_file(scene, options.folder, *comm);
  if (run.all_steps().outcome == Outcome::interrupted) return run.summary();
  run.write_joints(options.folder);
  auto summary = run.summary();
  summary.seconds = run.seconds();
  summary.effects = effect_costs(model);
  summary.partition = run.partition();
  summary.peak_memory = peak_memory_per_rank(*comm);
  write_result_json(options.folder + "/" + result_file, summary, *comm);
  run.end();
  return summary;
}

}  // namespace voussoir

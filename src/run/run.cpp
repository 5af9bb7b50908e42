#include "run/run.hpp"

#include <limits>
#include <utility>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "linalg/fail_together.hpp"
#include "model/loads_at_work.hpp"
#include "model/phase.hpp"
#include "range/input_warnings.hpp"
#include "results/largest_mover.hpp"
#include "results/shares_of_ranks.hpp"
#include "results/step_warnings.hpp"
#include "run/events_of_loads.hpp"
#include "run/what_is_known.hpp"
#include "step/finite_rotations.hpp"
#include "step/halved_step.hpp"

namespace voussoir {
namespace {

constexpr auto phases = {"mesh", "blocks", "joints", "continuum", "contact", "selection", "range", "output"};

/// The state that a load step starts from: the one before it, or a copy of the present one where that has other stones
/// or no velocities any more.
const ContactState& start_of(bool builds, const ContactState& before, const ContactState& now,
                             std::optional<ContactState>& copy) {
  if (!builds && before.velocity.empty()) return before;
  return copy.emplace(now);
}

}  // namespace

Run::Run(const Scene& scene, Model& model, const Appraisal& appraisal, const RunOptions& options,
         const BranchedFolder* branched, const Teuchos::Time& clock, std::ostream& say)
    : model_(model),
      appraisal_(appraisal),
      output_(scene.output),
      clock_(clock),
      say_(say),
      step_(model),
      progress_(*step_.progress()),
      steps_(scene.stages, scene.load_steps),
      state_(step_.initial_state()),
      construction_(scene, model),
      theorem_(model, appraisal.theorem()),
      refuse_(progress_, [this] { return theorem_.after_solve(); }),
      stop_(progress_,
            [this] {
              stop_wanted_ = stop_wanted(*model_.structure().comm());
              return stopped() ? GoOn::no : GoOn::yes;
            }),
      range_(model, appraisal.measures(), [this](const Warning& w) { warn(w); }),
      load_(state_.displacement.size(), 0.0),
      saved_(scene, model, options.folder, options.restart_from) {
  const auto& search = scene.load_factor;
  if (search.asked()) load_factor_ = std::make_unique<LoadFactorAnalysis>(search);
  for (const char* phase : phases) seconds_[phase] = 0;
  seconds_["total"] = 0;
  Record so_far;
  if (options.restart || branched) restore(so_far);
  nothing_left_ = options.restart && finished() && holds_result(options.folder, *model.structure().comm());
  if (nothing_left_) return;
  refuse_jumps_of_supports(scene, model);
  if (branched) branched->copy_records(scene.output.fields);
  // What is looked up by place is looked up where the structure was drawn, then it goes to where it has moved to.
  recorder_ = std::make_unique<Recorder>(scene, model, step_, options.folder, so_far);
  fail_together(*model_.structure().comm(), [&] {  // before its files are closed, which takes all ranks
    if ((options.restart || branched) && model.settings().rotations == Rotations::finite)
      model_.move_geometry(state_.displacement);
    if (recorder_->fields_lost())
      say << "fields.h5 is missing or was damaged when the run was interrupted: fields begin anew from here.\n";
    tell_of_solves(options.verbose);
  });
}

void Run::tell_of_solves(bool verbose) {
  narrator_ = std::make_unique<Narrator>(say_, verbose, seconds_since_start());
  progress_.print = [this](const NewtonProgress& p) { narrator_->solve(p); };
  progress_.print_round = [this](int round, long long selected, double estimate) {
    narrator_->round(round, selected, estimate);
  };
}

void Run::warn(const Warning& warning) {
  if (recorder_->warn(warning)) narrator_->warn(warning);
}

const RunSummary& Run::all_steps() {
  auto& summary = recorder_->summary();
  summary.outcome = Outcome::equilibrium;
  while (!finished()) {
    if (!one_step()) return summary;
    if (finished()) break;
    stop_wanted_ = stop_wanted(*model_.structure().comm());
    if (stopped()) return interrupted();
    saved_.save_when_due(here());
  }
  const bool keep = output_.checkpoint_at_end;
  if (keep) keep_last_state();  // without the mechanism, which is no step to go on from
  if (load_factor_) load_factor_->conclude(attempting());
  const bool undecided = summary.outcome == Outcome::not_converged || summary.outcome == Outcome::out_of_range;
  if (!keep && undecided) saved_.save(here());
  return summary;
}

bool Run::one_step() {
  const bool in_time = !steps_.finished() && steps_.dynamic();
  const auto stage = steps_.finished() ? steps_.stages().back().name : steps_.stage();
  if (in_time) begin_time();  // initial velocities belong to the state a failed step goes back to
  const auto before = state_;
  construction_.begin(stage, model_, state_);
  bool goes_on = true;
  if (steps_.finished()) {
    narrator_->know(load_factor_->known());
    load_factor_->attempt(attempting());
  } else
    goes_on = in_time ? time_step(before) : load_step(before);
  if (stopped()) {
    state_ = before;
    go_back(model_, before);
    interrupted();
    return false;
  }
  if (!goes_on) return false;
  if (model_.weakens())
    for (const auto& w : appraisal_.of_weakening_joints(state_, at_factor(stage, recorder_->summary().load_factor)))
      warn(w);
  return true;
}

void Run::write_joints(const std::string& folder) {
  auto& summary = recorder_->summary();
  // The last equilibrium may be of the stage before the one that failed, with other stones.
  const auto passed = steps_.passed();
  if (passed > 0 && (steps_.finished() || steps_.reached() == 0))
    construction_.begin(steps_.stages()[passed - 1].name, model_, state_);
  if (!in_motion(*model_.structure().comm(), state_) && summary.steps > 0)
    summary.statics = appraisal_.statics(step_, state_, load_, folder);
}

void Run::end() {
  if (output_.checkpoint_at_end) return;
  const auto& summary = recorder_->summary();
  const bool found = summary.collapse && summary.outcome == Outcome::collapse;
  if (summary.outcome == Outcome::equilibrium || found) saved_.remove();
}

PartitionSummary Run::partition() const {
  const auto quality = partition_quality(model_);
  return {quality.cut, quality.neighbours, quality.imbalance, imbalance_of_selected(model_, state_)};
}

std::map<std::string, double> Run::seconds() const {
  auto all = seconds_;
  for (const auto& [phase, seconds] : seconds_of_phases(phases)) all[phase] += seconds;
  all["total"] += clock_.totalElapsedTime(true);
  return all;
}

/// Books what stones take along that have gone since the last step, as they stood at its end under its loads.
void Run::remove_taken(const ContactState& start) {
  if (!construction_.builds()) return;
  const double inner =
      model_.inner_energy(steps_.last_factors(), steps_.time(), start.displacement, construction_.stays());
  recorder_->remove(construction_.taken(start, state_), inner);
}

bool Run::load_step(const ContactState& before) {
  const auto& summary = recorder_->summary();
  const std::string stage = steps_.stage();
  const double target = steps_.target();
  const auto energy = recorder_->so_far().energy;
  dynamics_.reset();
  const bool moved = in_motion(*model_.structure().comm(), state_);
  if (moved) untie_what_moved(model_, state_);
  state_.velocity.clear();
  std::vector<double> next_load, prescribed;
  model_.loads(steps_.factors(), steps_.time(), next_load, prescribed);
  construction_.restrict(state_, next_load, prescribed);
  narrator_->begin(summary.steps + 1, stage, target, steps_.progress());
  Teuchos::Time clock("step", true);
  std::optional<ContactState> changed;
  const auto& start = start_of(construction_.builds(), before, state_, changed);
  const LoadStepBook book(model_, step_, start, load_, construction_.let_go(), moved);
  theorem_.begin(construction_.absent(), start, load_, next_load, target == 1);
  auto report = theorem_.solve(step_, model_, state_, prescribed);
  if (stopped()) return false;
  if (report.newton.outcome != NewtonOutcome::converged) {
    recorder_->spend(report);
    narrator_->failed(report, stage, target);
    const auto failed = std::exchange(state_, before);
    const auto found = failure_in(failed, report, target);
    if (theorem_.refuses_any_part()) return fail(found, target);
    if (!failure_ || !failure_->collapse() || report.newton.outcome == NewtonOutcome::collapse) failure_ = found;
    if (halve_step(start, next_load, prescribed)) return true;
    if (!pass_in_time(start, {load_, next_load, prescribed}, at_factor(stage, target), report))
      return fail(*failure_, target);
  } else if (jumped(report, model_.settings().internals.step) && halve_step(start, next_load, prescribed)) {
    recorder_->spend(report);
    narrator_->say("  Cracks grow in a jump: tried again with half the step.");
    state_ = before;
    go_back(model_, before);
    return true;
  }
  const double seconds = clock.totalElapsedTime(true);
  const auto loads = at_rest(steps_.time(), steps_.factors());
  if (!in_range({state_, next_load, construction_.absent(), at_factor(stage, target), loads}, before)) return false;
  for (const auto& w : warnings_of(report, model_.settings(), at_factor(stage, target))) warn(w);
  failure_.reset();
  remove_taken(start);
  recorder_->set_loads(steps_.factors(), steps_.time());
  steps_.accept();
  const double jumps = summary.energy.jump;
  recorder_->record(book, state_, next_load, report, stage, target, writes(), seconds);
  for (const auto& w : motion_dropped(moved, energy, summary.energy.removed, at_factor(stage, target))) warn(w);
  for (const auto& w : lost_in_jump(summary.energy.jump - jumps, summary.energy, at_factor(stage, target))) warn(w);
  narrator_->end(report, seconds, summary);
  load_ = next_load;
  return true;
}

Run::Failure Run::failure_in(const ContactState& failed, const StepReport& report, double target) const {
  if (const auto& refusal = theorem_.refusal()) return {failed, report, refusal->mechanism, target, refusal->dilates};
  return {failed, report, step_.mechanism(), target, false};
}

bool Run::halve_step(const ContactState& before, const std::vector<double>& load,
                     const std::vector<double>& prescribed) {
  return !half_asks_the_same(model_, construction_, steps_, before, load, prescribed, theorem_.at_the_start()) &&
         steps_.halve();
}

bool Run::pass_in_time(const ContactState& start, const LoadIncrement& increment, const std::string& when,
                       StepReport& report) {
  if (!model_.weakens() || failure_->collapse() || !can_settle_in_time(model_)) return false;
  narrator_->say("  Statics leads nowhere: let go in time.");
  auto settled = settle_in_time(model_, step_, start, increment, std::numeric_limits<int>::max());
  if (stopped()) return false;
  recorder_->spend(settled.counts);
  if (settled.verdict == Verdict::undecided) return false;
  if (settled.verdict == Verdict::collapse) {
    report.newton.outcome = NewtonOutcome::collapse;
    report.newton.reason = "let go under these loads it moves on with growing speed, as seen in time";
    settled.state.velocity.clear();
    failure_ = Failure{std::move(settled.state), report, std::move(settled.mechanism), steps_.target(), false};
    return false;
  }
  state_ = std::move(settled.state);
  report = settled.report;
  report.passed_in_time = true;
  for (const auto& w : passed_in_time(settled.time, when)) warn(w);
  return true;
}

bool Run::time_step(const ContactState& before) {
  VOUSSOIR_EXPECT(dynamics_ && control_ && "time has begun");
  look_ahead(*control_, model_, steps_);
  const double time_step = control_->time_step();
  steps_.set_time_step(time_step);
  dynamics_->set_time_step(time_step);
  const std::string stage = steps_.stage();
  const double target = steps_.target(), time = steps_.time(target);
  std::vector<double> load, prescribed;
  loads_of_time_step(model_, steps_, load, prescribed);
  narrator_->begin(recorder_->summary().steps + 1, stage, time, steps_.progress());
  Teuchos::Time clock("step", true);
  const auto report = advance(*dynamics_, state_, {load, prescribed});
  if (stopped()) return false;
  const double seconds = clock.totalElapsedTime(true);
  if (report.step.newton.outcome != NewtonOutcome::converged) {
    recorder_->spend(report.step);
    narrator_->failed(report.step, stage, time);
    const auto failed = std::exchange(state_, before);
    if (control_->halve()) {
      narrator_->say("  Time step halved to " + six_digits(control_->time_step()) + " s.");
      return true;
    }
    return fail({failed, report.step, dynamics_->mechanism(), steps_.target(), false}, steps_.target());
  }
  const bool compares = target == 1 || writes();  // outlines of stones
  const StepEnd end{state_, load, construction_.absent(), at_time(stage, time), next_in_time(steps_), true, compares};
  if (!in_range(end, before)) return false;
  for (const auto& w : warnings_of(report.step, model_.settings(), at_time(stage, time))) warn(w);
  recorder_->set_loads(steps_.factors(target), time);
  const double duration = steps_.stage_parameters().duration;
  steps_.accept();
  model_.loads(steps_.last_factors(), time, load_, prescribed);
  const bool write = writes();
  recorder_->record(state_, report, stage, target, time, write, seconds);
  narrator_->end(report.step, seconds, recorder_->summary(), write);
  control_->accept(report.error, target * duration);
  if (steps_.stage_reached()) {
    control_.reset();
    level_ = {};
  }
  return true;
}

void Run::begin_time() {
  if (!dynamics_) {
    dynamics_ = std::make_unique<DynamicStep>(model_, step_.progress());
    recorder_->give(dynamics_->begin(state_, steps_.time() == 0));
  }
  if (control_) return;
  for (const auto& w : warnings_of_time_step(model_, steps_)) warn(w);
  const auto& stage = steps_.stage_parameters();
  const auto& time = model_.settings().time;
  const double courant_time = dynamics_->courant_time();
  const double longest = std::min(time.largest_courant * courant_time, model_.loads_at_work().resolution());
  control_ = std::make_unique<StepControl>(level_, stage.duration, stage.time_step, courant_time, longest,
                                           time.error_tolerance, time.largest_halvings);
}

Attempting Run::attempting() {
  return {model_, appraisal_, step_, construction_, steps_, state_, load_, *recorder_, *narrator_, range_};
}

std::string Run::now() const {
  if (steps_.finished()) return at_factor("load factor", load_factor_->search().next().value_or(0));
  return steps_.dynamic() ? at_time(steps_.stage(), steps_.time(steps_.target()))
                          : at_factor(steps_.stage(), steps_.target());
}

void Run::keep_hard_problems(HardProblems& kept) {
  progress_.keep = [this, &kept](const HardProblem& hard) { narrator_->say(kept.keep(hard, now())); };
}

bool Run::writes() const { return steps_.finished() || (recorder_->summary().steps + 1) % output_.every == 0; }

bool Run::in_range(const StepEnd& end, const ContactState& before) {
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

bool Run::fail(const Failure& failure, double last) {
  if (stopped()) return false;  // what was given up tells nothing
  auto& summary = recorder_->summary();
  // What the step took in vain is of this run, not of the state before it, from which another may go on.
  const auto in_vain = std::exchange(recorder_->so_far().in_vain, {});
  saved_.save(here());
  recorder_->so_far().in_vain = in_vain;
  summary.outcome = failure.collapse() ? Outcome::collapse : Outcome::not_converged;
  summary.load_factor = steps_.reached();
  summary.message =
      "stage '" + steps_.stage() + "', load factor " + six_digits(failure.target) + ": " + failure.report.newton.reason;
  if (!failure.collapse()) summary.message += of_unbounded_friction(model_);
  if (!failure.collapse()) return false;
  if (last < failure.target)
    summary.message += "; smaller steps, down to load factor " + six_digits(last) + ", could not be decided";
  recorder_->record_mechanism(failure.mechanism, failure.state, steps_.stage(), failure.target);
  summary.mechanism = largest_mover(model_, failure.mechanism);
  summary.mechanism->dilates = failure.dilates;
  summary.message += "; " + appraisal_.words_of(failure.mechanism, failure.dilates);
  return false;
}

RunState Run::here() {
  seconds_so_far_ = seconds();
  return {steps_, state_, load_, level_, recorder_->so_far(), seconds_so_far_, load_factor_.get()};
}

void Run::keep_last_state() {
  try {
    saved_.save(here());
  } catch (const ResourceError& error) {
    narrator_->say(std::string("No further stage can follow this run: ") + error.what());
  }
}

const RunSummary& Run::interrupted() {
  saved_.save(here());
  auto& summary = recorder_->summary();
  summary.outcome = Outcome::interrupted;
  summary.load_factor = steps_.finished() ? summary.load_factor : steps_.reached();
  summary.message = what_is_known(stop_wanted_, steps_, load_factor_.get(), summary);
  if (load_factor_ && steps_.finished()) summary.collapse = load_factor_->bracket();
  return summary;
}

void Run::restore(Record& so_far) {
  const RunState state{steps_, state_, load_, level_, so_far, seconds_, load_factor_.get()};
  const auto changed = saved_.restore(state);
  say_ << words_of(state, changed);
  forget_input_warnings(so_far.summary.warnings);
  const auto& stages = steps_.stages();
  if (finished() && !stages.empty()) construction_.begin(stages.back().name, model_, state_);
}

}  // namespace voussoir

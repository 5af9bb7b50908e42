// The steps of a scene: load steps, time steps and the search for a load factor, from where a run begins or goes on.
#pragma once

#include <Teuchos_Time.hpp>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "dynamics/load_steps.hpp"
#include "dynamics/step_control.hpp"
#include "model/construction.hpp"
#include "output/output_folder.hpp"
#include "range/range_check.hpp"
#include "results/narrator.hpp"
#include "results/recorder.hpp"
#include "run/appraisal.hpp"
#include "run/hard_problems.hpp"
#include "run/load_factor_analysis.hpp"
#include "run/saved_run.hpp"
#include "run/settling_in_time.hpp"
#include "run/simulation.hpp"
#include "run/static_theorem.hpp"
#include "run/stop_signals.hpp"
#include "time/dynamic_step.hpp"

namespace voussoir {

/// The steps of a scene.
class Run {
 public:
  /// @param appraisal  of that model
  /// @param clock  of the whole run
  /// @param branched  the folder to go on from, where that is another
  Run(const Scene& scene, Model& model, const Appraisal& appraisal, const RunOptions& options,
      const BranchedFolder* branched, const Teuchos::Time& clock, std::ostream& say);

  const RunSummary& summary() const { return recorder_->summary(); }
  /// The run that was to be gone on with has come to its end, and the scene asks for no more: nothing was touched.
  bool nothing_left() const { return nothing_left_; }

  /// Tells and keeps what the result leaves open. The same on all ranks.
  void warn(const Warning& warning);

  const RunSummary& all_steps();
  /// What there is to tell at the end, but for what its parts add.
  RunSummary result() const { return recorder_->result(); }

  /// What joints and supports carry in the last equilibrium; nothing of a run that ends in time, or found none.
  void write_joints(const std::string& folder);
  /// Writes contact problems that are hard, from here on; must live as long as this.
  void keep_hard_problems(HardProblems&);
  /// What nobody wants to go on with is removed.
  void end();
  /// How evenly ranks share what is there now.
  PartitionSummary partition() const;
  /// Seconds by phase, of all parts of the run.
  std::map<std::string, double> seconds() const;

 private:
  struct Failure {
    ContactState state;
    StepReport report;
    std::vector<double> mechanism;
    double target = 0;
    bool dilates = false;  ///< the mechanism is one of limit analysis whose slip lifts
    bool collapse() const { return report.newton.outcome == NewtonOutcome::collapse; }
  };

  void tell_of_solves(bool verbose);
  /// A load step, a time step or an attempt at a load factor. False when the run ends here.
  bool one_step();

  /// False when the run ends here.
  bool load_step(const ContactState& before);
  void remove_taken(const ContactState& start);

  /// What a load step came to that has not been solved.
  Failure failure_in(const ContactState& failed, const StepReport&, double target) const;

  /// Whether a load step is to be tried again as half of it, which would ask something else.
  /// @param load, prescribed  at its end [N], [m]
  bool halve_step(const ContactState& before, const std::vector<double>& load, const std::vector<double>& prescribed);

  /// A load step that nothing in statics leads through: let go in time, joints that lose strength may come to rest
  /// elsewhere. Where they do, state and report are those of the equilibrium there.
  /// @param start  of the step
  bool pass_in_time(const ContactState& start, const LoadIncrement&, const std::string& when, StepReport&);

  /// False when the run ends here.
  bool time_step(const ContactState& before);

  /// Mass matrices and initial velocities before the first time step, the time step before every stage.
  void begin_time();

  bool finished() const { return steps_.finished() && (!load_factor_ || load_factor_->finished()); }

  Attempting attempting();

  bool writes() const;

  /// What is being computed, such as "stage 'push', load factor 1".
  std::string now() const;

  /// False when a step that was solved is beyond what the model can tell; then the run ends in the state before it.
  bool in_range(const StepEnd& end, const ContactState& before);

  /// The run ends here: false.
  /// @param last  the load tried last; where a smaller one is not decided, the collapse under a larger one is told
  bool fail(const Failure& failure, double last);

  RunState here();

  /// The results of a run that is done do not depend on whether its state can be kept.
  void keep_last_state();

  /// A step that was given up, or one that would follow, does not count.
  bool stopped() const { return stop_wanted_ != Stop::no; }

  /// Saves the state, then says what is known.
  const RunSummary& interrupted();

  void restore(Record& so_far);

  Model& model_;
  const Appraisal& appraisal_;
  const OutputParameters output_;
  const Teuchos::Time& clock_;
  std::ostream& say_;
  AdaptiveStep step_;
  Progress& progress_;
  LoadSteps steps_;
  std::unique_ptr<DynamicStep> dynamics_;  ///< in stages with a duration
  std::unique_ptr<StepControl> control_;   ///< of the stage
  TimeStepLevel level_;
  ContactState state_;
  Construction construction_;
  StaticTheorem theorem_;
  Stop stop_wanted_ = Stop::no;       ///< within a step, which is given up
  Progress::Question refuse_, stop_;  ///< what no forces can bear is not tried; a signal ends a step
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
  std::unique_ptr<Recorder> recorder_;
  std::unique_ptr<Narrator> narrator_;
};

}  // namespace voussoir

#include "run/load_factor_analysis.hpp"

#include <Teuchos_Time.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "linalg/reduce.hpp"
#include "model/loads_at_work.hpp"
#include "results/largest_mover.hpp"
#include "results/step_warnings.hpp"
#include "run/load_factor_analysis_parameters.hpp"
#include "run/settling_in_time.hpp"
#include "run/static_theorem.hpp"
#include "step/finite_rotations.hpp"

namespace voussoir {
namespace {

using Search = LoadFactorAnalysisParameters;

/// How far stones that press on each other would move into each other, relative to the largest motion of a mechanism.
double overlap_of(const std::vector<double>& mechanism, const ContactState& state, const Model& model) {
  std::vector<double> motion;
  relative_motions(model.points(), mechanism, motion);
  double overlap = 0;
  const int dim = model.components();
  for (int k = 0; k < model.points().owned(); ++k)
    if (state.lambda[dim * k] > 0) overlap = std::max(overlap, -motion[dim * k]);
  return largest_over_ranks(*model.structure().comm(), overlap);
}

void tell(const Attempting& run, const Warnings& warnings) {
  for (const auto& w : warnings)
    if (run.recorder.warn(w)) run.narrator.warn(w);
}

}  // namespace

/// What the static theorem and the estimate without dilatancy say, before anything is tried.
void LoadFactorAnalysis::certify(const Attempting& run) {
  asked_theorem_ = true;
  // Stones that turn far stand elsewhere when it comes to that.
  const auto* theorem = run.appraisal.theorem();
  if (!theorem_applies(run.model, theorem) || run.model.settings().rotations == Rotations::finite) return;
  const auto raised = loads_of_pattern(run.model, run.steps.last_factors(), p_.pattern, run.steps.time());
  const RigidTask task{&run.construction.absent(), &run.state, run.load, raised};
  const auto limit = theorem->largest_factor(task, p_.largest, true);
  if (limit.verdict != LimitVerdict::limited && limit.verdict != LimitVerdict::refused) return;
  if (limit.verdict == LimitVerdict::refused) {
    const Warning held{"held_by_ties", "the structure", at_factor(stage, 0), 0,
                       "no admissible forces balance the loads of the last stage, by the static theorem: ties bear "
                       "them beyond the law of their joints; take selection > mode = all"};
    if (run.recorder.warn(held)) run.narrator.warn(held);
  }
  search_.certify(limit.verdict == LimitVerdict::limited ? std::max(0.0, limit.factor) : 0.0);
  limit_mechanism_ = limit.mechanism;
  limit_dilates_ = limit.dilates;
  limit_lambda_ = limit.lambda;
  if (std::isfinite(limit.without_dilatancy)) search_.guess(limit.without_dilatancy);
  run.narrator.say("  Above load factor " + six_digits(search_.certified()) +
                   " no equilibrium exists, by the static theorem (rigid limit analysis).");
  run.narrator.know(known());
}

/// A load step by statics. Of stones that are followed to where they turn to the static theorem is asked.
/// @param most  linear solves; when they are spent nothing is found
LoadFactorAnalysis::Found LoadFactorAnalysis::by_statics(const Attempting& run, const ContactState& before,
                                                         const LoadIncrement& increment, int most) {
  Found found;
  const SolveBudget budget(run.step, most);
  StaticTheorem theorem(run.model, run.appraisal.theorem());
  theorem.begin(run.construction.absent(), before, increment.load_before, increment.load, false);
  std::optional<Progress::Question> asks;
  const bool follows = run.model.settings().rotations == Rotations::finite;
  if (follows) asks.emplace(*run.step.progress(), [&theorem] { return theorem.after_solve(); });
  found.report = follows ? theorem.solve(run.step, run.model, run.state, increment.prescribed)
                         : solve_load_step(run.model, run.step, run.state, increment.load, increment.prescribed);
  if (budget.spent()) {
    found.report = {};
    go_back(run.model, before);
    found.report.newton.newton_iterations = budget.solves();
    found.report.newton.reason = "no equilibrium within " + counted(most, "linear solve") +
                                 ": no attempt that stands took more than 1 / " + std::to_string(Search::patience) +
                                 " of them";
    return found;
  }
  const auto& refusal = theorem.refusal();
  found.mechanism = refusal ? refusal->mechanism : run.step.mechanism();
  found.dilates = refusal && refusal->dilates;
  return found;
}

/// A load step by statics, or else in time. The state is where it ends.
LoadFactorAnalysis::Found LoadFactorAnalysis::decide(const Attempting& run, const ContactState& before,
                                                     const LoadIncrement& increment) {
  const bool in_time = can_settle_in_time(run.model);
  const int most =
      std::max(in_time ? Search::fewest_solves : Search::fewest_in_statics, Search::patience * most_solves_);
  auto found = by_statics(run, before, increment, most);
  if (found.report.newton.outcome == NewtonOutcome::converged)
    most_solves_ = std::max(most_solves_, found.report.newton.newton_iterations);
  if (found.report.newton.outcome != NewtonOutcome::not_converged || !in_time) return found;
  int all = found.report.newton.newton_iterations;
  for (const auto& a : search_.attempts()) all += a.linear_solves;
  run.narrator.say("  Undecided by statics (" + found.report.newton.reason + "): let go in time.");
  auto settled = settle_in_time(run.model, run.step, before, increment, all);
  found.solves = settled.solves;
  found.counts = settled.counts;
  const auto seconds = six_digits(settled.time) + " s";
  if (settled.stopped) {
    found.report.newton.outcome = NewtonOutcome::stopped;
    return found;
  }
  if (settled.verdict == Verdict::undecided) {
    run.narrator.say("  Not decided in " + seconds + " of time, " + counted(settled.solves, "linear solve") + ".");
    return found;
  }
  const bool stands = settled.verdict == Verdict::equilibrium;
  run.narrator.say((stands ? "  Came to rest within " : "  Moves on with growing speed after ") + seconds + ".");
  run.state = std::move(settled.state);
  if (stands) {
    found.counts.add_work(numbers_of(found.report));
    found.solves += found.report.newton.newton_iterations - settled.report.newton.newton_iterations;
    found.report = settled.report;
    found.report.passed_in_time = true;
  } else {
    run.state.velocity.clear();
    found.report.newton.outcome = NewtonOutcome::collapse;
    found.report.newton.reason = "let go under these loads it moves on with growing speed, as seen in time";
    found.mechanism = std::move(settled.mechanism);
  }
  return found;
}

void LoadFactorAnalysis::attempt(const Attempting& run) {
  VOUSSOIR_EXPECT(run.steps.finished() && "all stages are over");
  if (!asked_theorem_) certify(run);
  const auto next = search_.next();
  if (!next) return;
  const double factor = *next;
  auto factors = run.steps.last_factors();
  for (const auto& [load, share] : p_.pattern) factors[load] += factor * share;
  const double time = run.steps.time();
  std::vector<double> next_load, prescribed;
  run.model.loads(factors, time, next_load, prescribed);
  run.construction.restrict(run.state, next_load, prescribed);
  const auto& summary = run.recorder.summary();
  run.narrator.begin(summary.steps + 1, stage, factor, 1.0);
  Teuchos::Time clock("attempt", true);
  const ContactState before = run.state;
  const LoadStepBook book(run.model, run.step, before, run.load);
  const auto found = decide(run, before, {run.load, next_load, prescribed});
  const auto& report = found.report;
  if (report.newton.outcome == NewtonOutcome::stopped) return;  // the run is
  const double seconds = clock.totalElapsedTime(true);
  const int solves = report.newton.newton_iterations + report.estimate_solves + found.solves;
  const bool stands = report.newton.outcome == NewtonOutcome::converged;
  run.recorder.spend(found.counts);
  const StepEnd end{run.state, next_load, run.construction.absent(), at_factor(stage, factor), at_rest(time, factors)};
  const auto beyond = stands ? run.range.beyond(end) : "";
  if (stands && !beyond.empty()) {  // neither an equilibrium nor a mechanism: it cannot be told
    run.narrator.say("  Out of range at load factor " + six_digits(factor) + ": " + beyond + ".");
    run.recorder.spend(report);
    if (factor < beyond_at_) beyond_at_ = factor, beyond_ = beyond;
    run.state = before;
    go_back(run.model, before);
    search_.add(Verdict::undecided, solves);
    return;
  }
  if (stands) {
    search_.add(Verdict::equilibrium, solves);
    tell(run, warnings_of(report, run.model.settings(), end.when));
    run.recorder.set_loads(factors, time);
    const double jumps = summary.energy.jump;
    run.recorder.record(book, run.state, next_load, report, stage, factor, true, seconds);
    tell(run, lost_in_jump(summary.energy.jump - jumps, summary.energy, end.when));
    run.narrator.end(report, seconds, summary);
    run.load = next_load;
    return;
  }
  run.recorder.spend(report);
  run.narrator.failed(report, stage, factor);
  const auto failed = std::exchange(run.state, before);
  const bool collapse = report.newton.outcome == NewtonOutcome::collapse, first = !search_.has_mechanism();
  search_.add(collapse ? Verdict::collapse : Verdict::undecided, solves);
  if (!collapse) return;
  // Close to the limit the motion of a last iteration may be no mechanism yet: stones would pass through each other.
  const auto overlap = [&](const auto& motion, const auto& state) { return overlap_of(motion, state, run.model); };
  if (!first && overlap(found.mechanism, failed) > std::max(Search::believable_overlap, overlap(mechanism_, failed_)))
    return;
  mechanism_ = found.mechanism;
  mechanism_dilates_ = found.dilates;
  failed_ = failed;
}

CollapseSummary LoadFactorAnalysis::bracket() const {
  CollapseSummary found{p_.pattern, search_.lower(),     search_.upper(), search_.sharp(),
                        {},         search_.certified(), search_.guess()};
  constexpr const char* words[] = {"equilibrium", "collapse", "undecided"};
  for (const auto& a : search_.attempts())
    found.attempts.push_back({a.factor, words[static_cast<int>(a.verdict)], a.linear_solves});
  return found;
}

std::string LoadFactorAnalysis::known() const {
  const auto stands = search_.lower() > 0 ? "it stands at " + six_digits(search_.lower()) : std::string();
  if (!search_.found()) return stands.empty() ? "" : stands + " times the pattern";
  const auto falls = six_digits(search_.upper()) + " times the pattern " +
                     (search_.has_mechanism() ? "it falls" : "no equilibrium exists");
  return (stands.empty() ? "" : stands + ", ") + (search_.has_mechanism() ? "at " : "above ") + falls;
}

void LoadFactorAnalysis::judge(const Attempting& run) {
  auto& summary = run.recorder.summary();
  summary.collapse = bracket();
  const std::string stands = "it stands at " + six_digits(search_.lower());
  if (!search_.found()) {
    summary.outcome = search_.lower() >= p_.largest ? Outcome::equilibrium : Outcome::not_converged;
    summary.message = summary.outcome == Outcome::equilibrium
                          ? stands + ", the largest load factor asked for"
                          : stands + " times the pattern; beyond that neither an equilibrium nor a mechanism was found";
    if (beyond_.empty()) return;
    summary.outcome = Outcome::out_of_range;
    summary.message = stands + " times the pattern; at " + six_digits(beyond_at_) + " times it " + beyond_;
    return;
  }
  summary.outcome = Outcome::collapse;
  const bool theorem_alone = !search_.has_mechanism();
  summary.message = theorem_alone ? "above " + six_digits(search_.upper()) +
                                        " times the pattern no equilibrium exists, by the static theorem; " + stands
                                  : "at " + six_digits(search_.upper()) + " times the pattern it collapses; " + stands;
  if (!search_.sharp()) summary.message += "; factors between were tried and could not be decided";
  if (!beyond_.empty() && beyond_at_ > search_.lower() && beyond_at_ < search_.upper())
    summary.message += ": at " + six_digits(beyond_at_) + " " + beyond_;
  if (theorem_alone) {
    mechanism_ = limit_mechanism_;
    failed_ = run.state;
    failed_.lambda = limit_lambda_;
  }
  run.recorder.record_mechanism(mechanism_, failed_, stage, search_.upper());
  summary.mechanism = largest_mover(run.model, mechanism_);
  summary.mechanism->dilates = theorem_alone ? limit_dilates_ : mechanism_dilates_;
  summary.message += "; " + run.appraisal.words_of(mechanism_, summary.mechanism->dilates);
}

void LoadFactorAnalysis::conclude(const Attempting& run) {
  VOUSSOIR_EXPECT(run.steps.finished() && "all stages are over");
  judge(run);
  auto& summary = run.recorder.summary();
  const double share = summary.residual_displacement / run.model.structure().size();
  if (share > Search::small_displacements && run.model.settings().rotations == Rotations::small)
    summary.message += "; by then displacements are " + six_digits(100 * share) +
                       " % of the structure, more than small displacements, which are all that is computed, can tell";
}

}  // namespace voussoir

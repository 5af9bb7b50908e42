#include "run/static_theorem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "base/text.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "run/load_factor_analysis_parameters.hpp"
#include "run/static_theorem_parameters.hpp"
#include "step/release.hpp"

namespace voussoir {
namespace {

using TheoremNumbers = StaticTheoremParameters;

/// So many stones are asked of the theorem; and so few that asking costs next to nothing.
int most_stones(const Model& model) {
  return model.components() == 2 ? TheoremNumbers::most_stones : TheoremNumbers::most_stones_in_space;
}
bool has_few_stones(const Model& model) {
  return model.block_count() <=
         (model.components() == 2 ? TheoremNumbers::most_stones_at_ends : TheoremNumbers::most_stones_at_ends_in_space);
}

bool follows(const Model& model) { return model.settings().rotations == Rotations::finite; }

}  // namespace

bool theorem_applies(const Model& model, const LimitTheorem* theorem) {
  return theorem && model.settings().selection.mode != SelectionMode::bonded && model.points().total() > 0 &&
         model.block_count() <= most_stones(model);
}

void StaticTheorem::begin(const std::vector<char>& absent, const ContactState& before,
                          const std::vector<double>& load_before, const std::vector<double>& load, bool ends_stage) {
  expect_state(model_, before);
  VOUSSOIR_EXPECT(is_of_nodes(model_, load_before) && is_of_nodes(model_, load) && "loads: of node copies");
  VOUSSOIR_EXPECT((absent.empty() || absent.size() == static_cast<std::size_t>(model_.structure().local_blocks())) &&
                  "absent: per block, or none");
  ends_stage_ = ends_stage;
  absent_ = &absent, state_ = &before, before_ = &load_before, load_ = &load;
  asked_ = !applies_;
  solving_ = true;
  arrangement_ = -1;
  places_ = solves_ = 0;
  refusal_.reset();
}

GoOn StaticTheorem::after_solve() {
  if (!solving_) return GoOn::yes;
  ++solves_;
  if (std::exchange(arrangement_, model_.arrangement()) != model_.arrangement()) {
    if (++places_ > 1) asked_ = !applies_ || !follows(model_);
    solves_here_ = 0;
  }
  const bool few = places_ > 1 && has_few_stones(model_);
  const int enough = few ? TheoremNumbers::solves_before_asking_few : TheoremNumbers::solves_before_asking;
  return !asked_ && ++solves_here_ >= enough && refuses() ? GoOn::no : GoOn::yes;
}

StepReport StaticTheorem::solve(AdaptiveStep& step, Model& model, ContactState& state,
                                const std::vector<double>& prescribed) {
  VOUSSOIR_EXPECT(state_ && load_ && "a step has begun");
  const bool asks_first = follows(model_) && has_few_stones(model_);
  const bool at_once = asks_first && nothing_has_moved() && refuses();
  StepReport report;
  if (!at_once) report = solve_load_step(model, step, state, *load_, prescribed);
  solving_ = false;
  if (at_once || (report.newton.stopped && refusal_)) {
    report = {};
    report.newton.newton_iterations = solves_;
  } else if (report.newton.stopped || !in_doubt(report, state) || !refuses()) {
    return report;
  }
  report.newton.outcome = NewtonOutcome::collapse;
  report.newton.reason = reason(model, at_the_start() ? *state_ : state);
  go_back(model, *state_);
  state.lambda = refusal_->lambda;
  return report;
}

bool StaticTheorem::refuses_any_part() const {
  if (!refusal_) return false;
  return !follows(model_) || (at_the_start() && refusal_->share < TheoremNumbers::nothing_borne);
}

/// Stones stand as drawn, and nothing presses them yet.
bool StaticTheorem::nothing_has_moved() const {
  double largest = 0;
  for (const double u : state_->displacement) largest = std::max(largest, std::abs(u));
  return largest_over_ranks(*model_.structure().comm(), largest) == 0;
}

/// Nothing was found where stones stood at the start, or an equilibrium in which ties may bear what their law does not
/// admit.
bool StaticTheorem::in_doubt(const StepReport& report, const ContactState& state) const {
  if (!at_the_start()) return false;
  if (report.newton.outcome == NewtonOutcome::not_converged) return true;
  return report.newton.outcome == NewtonOutcome::converged && ends_stage_ && has_few_stones(model_) &&
         count_selected(model_, state) < model_.points().total();
}

/// Asks once at a place.
bool StaticTheorem::refuses() {
  if (std::exchange(asked_, true)) return refusal_.has_value();
  // What strength the step takes is not known: strengths count as at its beginning, which admits more.
  auto answer = theorem_->refuses({absent_, state_, *load_, {}});
  if (answer.verdict != LimitVerdict::refused) return false;
  refusal_ = Refusal{0, std::move(answer.mechanism), answer.dilates, std::move(answer.lambda)};
  auto more = *load_;
  for (std::size_t k = 0; k < more.size(); ++k) more[k] -= (*before_)[k];
  answer = theorem_->largest_factor({absent_, state_, *before_, std::move(more)}, 1, false);
  if (answer.verdict == LimitVerdict::limited)
    refusal_ =
        Refusal{std::max(0.0, answer.factor), std::move(answer.mechanism), answer.dilates, std::move(answer.lambda)};
  return true;
}

std::string StaticTheorem::reason(Model& model, const ContactState& from) const {
  constexpr auto theorem = " (rigid limit analysis)";
  const auto share = six_digits(100 * refusal_->share) + " % of the way here from the loads before can be borne";
  if (!follows(model_))
    return std::string(
               "no forces that joints admit balance the loads, so that no equilibrium exists, by the static "
               "theorem") +
           theorem + "; " + share;
  return std::string(at_the_start() ? "where stones stand at the start of the step "
                                    : "where stones have moved and turned to under these loads ") +
         "no forces that joints admit balance the loads, so that they move on, by the static theorem" + theorem + "; " +
         share + " there; " + along_the_mechanism(model, from);
}

/// Whether stones that move on come to where forces balance the loads. Leaves the model there.
std::string StaticTheorem::along_the_mechanism(Model& model, const ContactState& from) const {
  std::string at;
  for (const double share : LoadFactorAnalysisParameters::shares_along) {
    auto there = from.displacement;
    const double far = share * model_.structure().size();
    for (std::size_t i = 0; i < there.size(); ++i) there[i] += far * refusal_->mechanism[i];
    model.move_geometry(there);
    if (theorem_->refuses({absent_, state_, *load_, {}}).verdict != LimitVerdict::refused)
      return "moved on by " + six_digits(far) + " m they may come to rest, which load steps do not follow them to";
    at += (at.empty() ? "" : " and ") + six_digits(far) + " m";
  }
  return "moved on by " + at + " along their mechanism none balance them either";
}

}  // namespace voussoir

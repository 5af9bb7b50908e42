#include "run/static_theorem.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "step/release.hpp"

namespace voussoir {
namespace {

// Load steps that stand take no more linear solves than this but for the hardest (the first step of a bridge takes 33);
// those that fall may take thousands.
constexpr int solves_before_asking = 40;
// The simplex method takes some twenty pivots a stone, and each costs in proportion to the stones: so many take ten
// seconds. More are asked of the theorem where a scene or a user asks.
constexpr int most_stones = 1200;
// So many take a few tenths of a second: no more than the stage itself.
constexpr int most_stones_at_ends = 300;

/// Thrown from within a step.
struct Refused {};

}  // namespace

bool theorem_applies(const Model<2>& model) {
  const auto& scene = model.scene();
  return scene.selection.mode != SelectionMode::bonded && scene.model.rotations == Rotations::small &&
         model.points().total() > 0 && model.source().block_count() <= most_stones;
}

void StaticTheorem::begin(const std::vector<char>& absent, const ContactState& before,
                          const std::vector<double>& load_before, const std::vector<double>& load, bool ends_stage) {
  ends_stage_ = ends_stage;
  absent_ = &absent, state_ = &before, before_ = &load_before, load_ = &load;
  waits_ = applies_;
  solves_ = 0;
  refusal_.reset();
}

void StaticTheorem::count_solve() {
  if (waits_ && ++solves_ >= solves_before_asking && refuses()) throw Refused{};
}

StepReport StaticTheorem::solve(AdaptiveStep<2>& step, Model<2>& model, ContactState& state,
                                const std::vector<double>& prescribed) {
  StepReport report;
  try {
    report = solve_load_step(model, step, state, *load_, prescribed);
    if (!in_doubt(report, state) || !refuses()) {
      waits_ = false;
      return report;
    }
  } catch (const Refused&) {
    report = {};
    report.newton.newton_iterations = solves_;
  }
  report.newton.outcome = NewtonOutcome::collapse;
  report.newton.reason =
      "no forces that joints admit balance the loads, so that no equilibrium exists, by the static "
      "theorem (rigid limit analysis); " +
      six_digits(100 * refusal_->share) + " % of the way here from the loads before can be borne";
  state.lambda = refusal_->lambda;
  return report;
}

/// Nothing was found, or an equilibrium in which ties may bear what their law does not admit.
bool StaticTheorem::in_doubt(const StepReport& report, const ContactState& state) const {
  if (report.newton.outcome == NewtonOutcome::not_converged) return true;
  return report.newton.outcome == NewtonOutcome::converged && ends_stage_ &&
         model_.source().block_count() <= most_stones_at_ends &&
         count_selected(model_, state) < model_.points().total();
}

/// Asks once a step.
bool StaticTheorem::refuses() {
  if (!waits_) return refusal_.has_value();
  waits_ = false;
  // What strength the step takes is not known: strengths count as at its beginning, which admits more.
  const RigidLimits whole(model_, {absent_, state_, *load_, {}});
  auto answer = whole.bears(0);
  if (answer.verdict != LimitVerdict::refused) return false;
  refusal_ = Refusal{0, whole.on_nodes(answer), answer.dilates, whole.on_points(answer)};
  auto more = *load_;
  for (std::size_t k = 0; k < more.size(); ++k) more[k] -= (*before_)[k];
  const RigidLimits raised(model_, {absent_, state_, *before_, std::move(more)});
  answer = raised.largest_factor(1);
  if (answer.verdict == LimitVerdict::limited)
    refusal_ = Refusal{std::max(0.0, answer.factor), raised.on_nodes(answer), answer.dilates, raised.on_points(answer)};
  return true;
}

}  // namespace voussoir

#include "step/adaptive_step.hpp"

#include <utility>

#include "base/check.hpp"
#include "joints/tractions.hpp"
#include "model/handed_over.hpp"
#include "model/point_status.hpp"

namespace voussoir {

AdaptiveStep::AdaptiveStep(const Model& model, std::shared_ptr<Progress> progress)
    : model_(model), progress_(std::move(progress)), tools_(model) {}

ContactState AdaptiveStep::initial_state() const {
  const int dim = model_.components();
  ContactState state;
  const int points = model_.points().size();
  state.displacement.assign(static_cast<std::size_t>(dim) * model_.structure().nodes(), 0.0);
  state.lambda.assign(static_cast<std::size_t>(dim) * points, 0.0);
  if (model_.rubs()) state.slip_origin = state.lambda;
  state.selected.assign(points, 0);
  // Open joints cannot begin bonded.
  const auto& gap = model_.initial_gap();
  for (std::size_t k = 0; k < gap.size(); ++k) state.selected[k] = gap[k] > 0;
  // Nor can those that nothing ties.
  const auto& apart = model_.never_tied();
  for (std::size_t k = 0; k < apart.size(); ++k)
    if (apart[k]) state.selected[k] = 1;
  if (model_.settings().builds) {
    state.initial_gap = gap;
    state.initial_gap.resize(points, 0.0);
  }
  if (model_.weakens()) state.opened.assign(points, 0.0);
  state.slipped = state.opened;
  state.status.assign(points, static_cast<char>(PointStatus::stick));
  return state;
}

std::vector<double> AdaptiveStep::residual(const ContactState& state, const std::vector<double>& load) const {
  const int dim = model_.components();
  VOUSSOIR_EXPECT(is_of_nodes(model_, load) && "load: of node copies");
  VOUSSOIR_EXPECT(is_of_points(model_, state.lambda) && "lambda: of points");
  auto r = borne_by_joints(model_.structure(), state.displacement, load);
  add_contact_forces(model_.points(), {}, state.lambda, -1.0, r);
  const auto& absent = model_.absent();
  for (std::size_t i = 0; i < r.size() && !absent.empty(); ++i)
    if (absent[model_.structure().block_of_node()[i / dim]]) r[i] = 0;
  return r;
}

StepReport AdaptiveStep::find_equilibrium(ContactState& state, const StepInput& input) {
  SelectionLoop loop(tools_, state, input, *progress_);
  auto report = loop.run();
  if (!loop.mechanism().empty()) mechanism_ = loop.mechanism();
  return report;
}

StepResult AdaptiveStep::take(const ContactState& before, const StepInput& input) {
  expect_state(model_, before);
  expect_input(model_, input);
  StepResult result{before, {}};
  auto& [state, report] = result;
  report = find_equilibrium(state, input);
  if (report.newton.stopped) state = before;
  if (!report.converged()) return result;
  const auto gap = stone_gaps(state);
  state.status = point_statuses(model_, state, gap, before.slip_origin);
  state.slip_origin = slip_origins(model_, state, gap, before.slip_origin);
  return result;
}

}  // namespace voussoir

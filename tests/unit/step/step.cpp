// A step is a value in and a value out: it leaves the state before it alone, and does not depend on the steps that were
// taken before it. A judge may end it, a printer may not.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <string>
#include <vector>

#include "linalg/reduce.hpp"
#include "support/scenes.hpp"
#include "time/dynamic_step.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

bool same(const ContactState& a, const ContactState& b) {
  return a.displacement == b.displacement && a.lambda == b.lambda && a.slip_origin == b.slip_origin &&
         a.selected == b.selected && a.status == b.status && a.opened == b.opened && a.slipped == b.slipped &&
         a.velocity == b.velocity;
}

bool same(const StepReport& a, const StepReport& b) {
  return a.newton.newton_iterations == b.newton.newton_iterations &&
         a.newton.krylov_iterations == b.newton.krylov_iterations && a.estimate_solves == b.estimate_solves &&
         a.error_estimate == b.error_estimate;
}

/// A scene under its first load.
class Loaded : public Experiment {
 public:
  Loaded(Scene scene, SelectionMode mode) : Experiment(with(std::move(scene), mode)) {
    stands_ = advance({{name(0), 1}});
    model().loads({{name(0), 1}, {name(1), 0.1}}, 0.0, little_, prescribed_little_);
    model().loads({{name(0), 1}, {name(1), 0.8}}, 0.0, much_, prescribed_much_);
  }
  bool stands() const { return stands_; }
  StepInput little() const { return {little_, prescribed_little_}; }
  StepInput much() const { return {much_, prescribed_much_}; }

 private:
  static Scene with(Scene scene, SelectionMode mode) {
    scene.selection.mode = mode;
    return scene;
  }
  const std::string& name(int k) const { return scene().loads[k].name; }

  bool stands_ = false;
  std::vector<double> little_, much_, prescribed_little_, prescribed_much_;
};

TEUCHOS_UNIT_TEST(Step, IsTheSameWhateverStepsWereTakenBefore) {
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive})
    for (const bool arch : {false, true}) {
      Loaded scene(arch ? arch_scene(31) : wall_scene(6), mode);
      TEST_ASSERT(scene.stands());
      const auto before = scene.state();
      AdaptiveStep used(scene.model()), fresh(scene.model());
      auto state = before;
      TEST_ASSERT(advance(used, state, scene.little()).converged());
      TEST_ASSERT(advance(used, state, scene.much()).converged());
      TEST_ASSERT(advance(used, state, scene.little()).converged());
      const auto again = used.take(before, scene.little()), anew = fresh.take(before, scene.little());
      TEST_ASSERT(anew.report.converged());
      TEST_ASSERT(same(again.after, anew.after));
      TEST_ASSERT(same(again.report, anew.report));
      out << anew.report.newton.newton_iterations << " solves, " << again.report.cost.factorised << " factorised, "
          << anew.report.cost.factorised << " anew\n";
    }
}

TEUCHOS_UNIT_TEST(Step, InTimeIsTheSameWhateverStepsWereTakenBefore) {
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive}) {
    Loaded wall(wall_scene(4), mode);
    TEST_ASSERT(wall.stands());
    DynamicStep used(wall.model()), fresh(wall.model());
    auto before = wall.state();
    used.begin(before);
    for (auto* step : {&used, &fresh}) step->set_time_step(2e-3);
    auto state = before;
    for (int k = 0; k < 5; ++k) TEST_ASSERT(advance(used, state, wall.much()).step.converged());
    const auto again = used.take(before, wall.much()), anew = fresh.take(before, wall.much());
    TEST_ASSERT(anew.report.step.converged());
    TEST_ASSERT(same(again.after, anew.after));
    TEST_ASSERT(same(again.report.step, anew.report.step));
    TEST_EQUALITY(again.report.kinetic, anew.report.kinetic);
  }
}

/// Points by status; at rest each must bear and stand as that says. In time forces are those of the middle of the step.
std::array<int, 4> count_statuses(const Loaded& scene, const ContactState& state, Teuchos::FancyOStream& out,
                                  bool& success) {
  const auto& model = scene.model();
  const auto gap = model.gaps(state.displacement);
  double largest = 0;
  for (int k = 0; k < model.points().size(); ++k) largest = std::max(largest, state.lambda[2 * k]);
  std::array<int, 4> count{};
  for (int k = 0; k < model.points().size(); ++k) {
    const auto status = status_of(state, k);
    ++count[static_cast<int>(status)];
    TEST_EQUALITY(status == PointStatus::bonded, !state.selected[k]);
    if (!state.selected[k] || !state.velocity.empty()) continue;
    const double p = state.lambda[2 * k], q = std::abs(state.lambda[2 * k + 1]), small = 1e-6 * largest;
    const double bound = friction_bound(model.law()[k], p);
    if (status == PointStatus::open) TEST_COMPARE(p + q, <=, small);
    if (status != PointStatus::open) TEST_COMPARE(std::abs(gap[2 * k]) * model.local_stiffness()[k], <=, small);
    if (status == PointStatus::slip) TEST_COMPARE(q, >=, bound - small);
    if (status == PointStatus::stick) TEST_COMPARE(q, <=, bound);
  }
  out << count[0] << " open, " << count[1] << " stick, " << count[2] << " slip, " << count[3] << " bonded\n";
  return count;
}

TEUCHOS_UNIT_TEST(Step, KeepsWhatPointsDoAsForcesAndGapsHaveIt) {
  Scene slippery = wall_scene(6);
  for (auto& joint : slippery.joints) joint.parameters.friction_coefficient = 0.14;
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive}) {
    Loaded wall(slippery, mode);
    TEST_ASSERT(wall.stands());
    AdaptiveStep step(wall.model());
    const auto [after, report] = step.take(wall.state(), wall.much());
    TEST_ASSERT(report.converged());
    auto all = count_statuses(wall, after, out, success);
    for (int& n : all) n = total_over_ranks(*wall.model().structure().comm(), n);
    TEST_COMPARE(all[0], >, 0);
    TEST_COMPARE(all[1], >, 0);
    TEST_COMPARE(all[2], >, 0);
    TEST_ASSERT(all[3] == 0 || mode == SelectionMode::adaptive);

    DynamicStep in_time(wall.model());
    auto state = wall.state();
    in_time.begin(state);
    in_time.set_time_step(1e-3);
    for (int k = 0; k < 3; ++k) TEST_ASSERT(advance(in_time, state, wall.little()).step.converged());
    all = count_statuses(wall, state, out, success);
    for (int& n : all) n = total_over_ranks(*wall.model().structure().comm(), n);
    TEST_COMPARE(all[0], >, 0);
    TEST_COMPARE(all[1] + all[2], >, 0);
    TEST_ASSERT(all[3] == 0 || mode == SelectionMode::adaptive);
  }
}

TEUCHOS_UNIT_TEST(Step, EndsWhereAQuestionIsAnsweredNoAndIsTakenAfterwards) {
  Loaded wall(wall_scene(6), SelectionMode::all);
  TEST_ASSERT(wall.stands());
  const auto before = wall.state();
  AdaptiveStep step(wall.model());
  auto& progress = *step.progress();
  std::vector<std::string> order;
  progress.print = [&](const NewtonProgress&) { order.emplace_back("print"); };
  auto state = before;
  {
    const Progress::Question first(progress, [&] {
      order.emplace_back("ask");
      return GoOn::yes;
    });
    const Progress::Question second(progress, [&] { return progress.solves() < 2 ? GoOn::yes : GoOn::no; });
    const Progress::Question third(progress, [&] {
      if (progress.solves() == 2) order.emplace_back("too late");
      return GoOn::yes;
    });
    const auto report = advance(step, state, wall.much());
    TEST_ASSERT(report.newton.outcome == NewtonOutcome::stopped);
    TEST_EQUALITY(report.newton.newton_iterations, 2);
  }
  TEST_ASSERT(same(state, before));
  TEST_EQUALITY(progress.solves(), 2);
  TEST_ASSERT((order == std::vector<std::string>{"print", "ask", "print", "ask"}));
  const auto after = step.take(before, wall.much());
  TEST_ASSERT(after.report.converged());
  TEST_EQUALITY(progress.solves(), 2 + after.report.newton.newton_iterations);
  TEST_EQUALITY(order.size(), 4 + after.report.newton.newton_iterations);
  AdaptiveStep fresh(wall.model());
  TEST_ASSERT(same(after.after, fresh.take(before, wall.much()).after));
}

}  // namespace

// What a run leaves behind: counts, sums and rows of steps, and where an earlier run goes on.
#include "results/recorder.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "model/point_status.hpp"
#include "support/tied_wall.hpp"
#include "unit/output/folders.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

int rows_of(const std::string& folder) {
  world()->barrier();
  std::ifstream file(folder + "/history.csv");
  int lines = 0;
  for (std::string line; std::getline(file, line);) ++lines;
  return lines - 1;  // less the heading
}

/// Two half stones that are free to leave the stone below them, and what is recorded of them.
struct Recorded {
  Experiment wall;
  std::unique_ptr<Recorder> recorder;

  explicit Recorded(const std::string& folder, const Record& so_far = {}) : wall(scene()) {
    recorder = std::make_unique<Recorder>(wall.scene(), wall.model(), wall.step(), folder, so_far);
  }
  static Scene scene() {
    Scene scene = tied_wall();
    scene.selection.mode = SelectionMode::all;
    return scene;
  }
  StepReport step(double sideways) {
    const ContactState before = wall.state();
    const auto load_before = wall.load();
    const LoadStepBook book(wall.model(), wall.step(), before, load_before);
    if (!wall.advance({{"weight", 1}, {"sideways", sideways}})) throw std::runtime_error("no equilibrium");
    const StepReport report = wall.solution().last;
    recorder->record(book, wall.state(), wall.load(), report, "a stage", sideways, true, 0.5);
    return report;
  }
};

TEUCHOS_UNIT_TEST(Recorder, CountsEveryPointAndSumsTheStepsWithoutAnybodyAsking) {
  const std::string folder = fresh_folder("recorded");
  Recorded r(folder);
  const auto& sum = r.recorder->summary();
  TEST_EQUALITY(sum.blocks, 3);
  TEST_EQUALITY(sum.steps, 0);
  const StepReport first = r.step(0), second = r.step(1);
  TEST_EQUALITY(sum.steps, 2);
  TEST_EQUALITY(rows_of(folder), 2);
  TEST_EQUALITY(sum.newton_iterations, first.newton.newton_iterations + second.newton.newton_iterations);
  TEST_EQUALITY(sum.krylov_iterations, first.newton.krylov_iterations + second.newton.krylov_iterations);
  TEST_EQUALITY(sum.load_factor, 1.0);
  TEST_EQUALITY(sum.selected_points, r.wall.model().points().total());
  TEST_EQUALITY(sum.open_points + sum.stick_points + sum.slip_points, sum.selected_points);
  TEST_EQUALITY(sum.largest_displacement, r.wall.solution().largest_displacement());
  // 0.15 g on stones of friction 0.6: nothing slips, so what loads do is what stones hold.
  TEST_FLOATING_EQUALITY(sum.energy.external_work, sum.energy.elastic, 1e-6);
  TEST_EQUALITY(r.recorder->so_far().written, 2);
}

// A point that bears and sticks, one that bears as much friction as it can, one that has parted.
TEUCHOS_UNIT_TEST(Recorder, StatusesAreThoseOfForcesAndGaps) {
  Recorded r(fresh_folder("statuses"));
  r.step(0);
  auto& state = r.wall.state();
  const ContactState before = state;
  const LoadStepBook book(r.wall.model(), r.wall.step(), before, r.wall.load());
  const auto& model = r.wall.model();
  long long by_hand[3] = {0, 0, 0};
  for (int k = 0; k < model.points().size(); ++k) {
    const auto& joint = joint_of(model, k);
    const bool beside = joint.block_i == 1, right = joint.block_j == 2 && !beside;
    state.lambda[2 * k] = beside ? 0 : 100;
    state.lambda[2 * k + 1] = right ? 60 : 0;
    if (k < model.points().owned()) ++by_hand[beside ? 0 : right ? 2 : 1];
  }
  // Block 2 goes 1 mm to the right, in the direction in which it is held back; block 1 stays.
  const auto& s = model.structure();
  std::fill(state.displacement.begin(), state.displacement.end(), 0.0);
  for (int i = 0; i < s.nodes(); ++i)
    if (s.blocks()[s.block_of_node()[i]].mesh.id == 2) state.displacement[2 * i] = 1e-3;
  state.status = point_statuses(model, state, model.gaps(state.displacement, state.lambda), {});
  r.recorder->record(book, state, r.wall.load(), {}, "by hand", 1, false, 0);
  long long all[3];
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_SUM, 3, by_hand, all);
  const auto& count = r.recorder->summary();
  TEST_EQUALITY(count.open_points, all[0]);
  TEST_EQUALITY(count.stick_points, all[1]);
  TEST_EQUALITY(count.slip_points, all[2]);
  TEST_EQUALITY(r.recorder->so_far().written, 1);  // no fields were asked for
}

// What sticks is where it was, though stones are off by what a solve left; what slips is where they are.
TEUCHOS_UNIT_TEST(SlipOrigins, FollowWhatSlipsAlone) {
  Recorded r(fresh_folder("origins"));
  r.step(0);
  auto& state = r.wall.state();
  const auto& model = r.wall.model();
  const auto points = std::size_t(model.points().size());
  const double slip = 1e-3, left = 1e-15;  // [m]
  const PointField before(2 * points, 0.0);
  PointField gap(2 * points, 0.0);
  state.selected.assign(points, 1);
  for (std::size_t k = 0; k < points; ++k) {
    state.lambda[2 * k] = 100;
    state.lambda[2 * k + 1] = k % 2 ? -60 : 10;
    gap[2 * k + 1] = k % 2 ? slip : left;
  }
  const auto after = slip_origins(model, state, gap, before);
  for (std::size_t k = 0; k < points; ++k) TEST_EQUALITY(after[2 * k + 1], k % 2 ? slip : 0.0);
  // A tie holds its point where it is.
  state.selected.assign(points, 0);
  TEST_COMPARE_ARRAYS(slip_origins(model, state, gap, before), gap);
  TEST_ASSERT(slip_origins(model, state, gap, {}).empty());
}

TEUCHOS_UNIT_TEST(Recorder, AnEarlierRunGoesOnBehindTheStepsItRecorded) {
  const std::string folder = fresh_folder("goes-on");
  Record after_one;
  {
    Recorded r(folder);
    r.step(0);
    after_one = r.recorder->so_far();
    r.step(1);  // after the checkpoint: cut off
    TEST_EQUALITY(rows_of(folder), 2);
  }
  Recorded again(folder, after_one);
  TEST_ASSERT(!again.recorder->fields_lost());
  TEST_EQUALITY(rows_of(folder), 1);
  again.step(0.5);
  TEST_EQUALITY(again.recorder->summary().steps, 2);
  TEST_EQUALITY(again.recorder->so_far().written, 2);
  TEST_EQUALITY(rows_of(folder), 2);
}

// What attempts took in vain is counted with the step that follows them, or with the run where none does.
TEUCHOS_UNIT_TEST(Recorder, CountsWhatAttemptsTookInVain) {
  Recorded r(fresh_folder("in-vain"));
  StepReport failed;
  failed.newton.newton_iterations = 7;
  failed.newton.krylov_iterations = 70;
  failed.estimate_solves = 2;
  r.recorder->spend(failed);
  TEST_EQUALITY(r.recorder->summary().linear_solves, 0);
  TEST_EQUALITY(r.recorder->result().linear_solves, 9);
  const StepReport stood = r.step(0);
  const auto& sum = r.recorder->summary();
  TEST_EQUALITY(sum.newton_iterations, 7 + stood.newton.newton_iterations);
  TEST_EQUALITY(sum.krylov_iterations, 70 + stood.newton.krylov_iterations);
  TEST_EQUALITY(r.recorder->result().linear_solves, sum.linear_solves);
}

// Block 2 parts from both others, upwards to the right: a step of fields that is none of the run.
TEUCHOS_UNIT_TEST(Recorder, AMechanismIsWrittenBehindTheStepsAndCountsAsNone) {
  const std::string folder = fresh_folder("mechanism");
  Recorded r(folder);
  r.step(0);
  const auto& s = r.wall.model().structure();
  std::vector<double> mechanism(2 * static_cast<std::size_t>(s.nodes()), 0.0);
  for (std::size_t i = 0; i < mechanism.size(); ++i)
    if (s.blocks()[s.block_of_node()[i / 2]].mesh.id == 2) mechanism[i] = 1;
  const auto before = r.recorder->summary().open_points;
  r.recorder->record_mechanism(mechanism, r.wall.state(), "a stage", 1);
  TEST_EQUALITY(r.recorder->so_far().written, 2);
  TEST_EQUALITY(r.recorder->summary().steps, 1);
  TEST_EQUALITY(rows_of(folder), 1);
  TEST_EQUALITY(r.recorder->summary().open_points, before);
}

/// The names under which a checkpoint keeps numbers, and what stands there.
struct Kept {
  std::map<std::string, double> number;
  template <class T>
  void value(const std::string& name, T& value) {
    if constexpr (std::is_arithmetic_v<T>) number[name] = static_cast<double>(value);
  }
  template <class T>
  void within(const std::string& name, T& value, double, double) {
    number[name] = static_cast<double>(value);
  }
};

// Each number of the list has another value, by which it is found wherever numbers of steps go.
TEUCHOS_UNIT_TEST(Recorder, EveryNumberOfTheListIsInEveryOutput) {
  Record record;
  std::string row;
  int count = 0;
  each_number(
      [&](const char*, const std::string& name, OverSteps over, auto& of_run, auto& in_vain) {
        of_run = ++count + 100;
        if (over == OverSteps::sum) in_vain = count + 200;
        if (name.find('.') == std::string::npos) row += ',' + std::to_string(count + 100);
      },
      record.summary, record.in_vain);
  TEST_EQUALITY(sizeof(StepNumbers), count * sizeof(double));  // of eight bytes each: no member beside the list
  Kept kept;
  record.keep(kept);
  const std::string json = result_json(record.summary), heading = ',' + History::heading() + ',';
  each_number(
      [&](const char* member, const std::string& name, OverSteps over, const auto& value) {
        const auto dot = name.find('.');
        std::ostringstream in_json;
        in_json << '"' << name.substr(dot + 1) << "\": " << value;  // dot + 1 is 0 where there is none
        TEST_INEQUALITY_CONST(json.find(in_json.str()), std::string::npos);
        TEST_EQUALITY(heading.find(',' + name + ',') != std::string::npos, dot == std::string::npos);
        std::string flat = name;
        std::replace(flat.begin(), flat.end(), '.', '_');
        const auto number = static_cast<double>(value);
        TEST_EQUALITY(kept.number.at(flat), number);
        const std::string tried = std::string("in_vain.") + member;
        TEST_EQUALITY(kept.number.count(tried) == 1, over == OverSteps::sum);
        if (over == OverSteps::sum) TEST_EQUALITY(kept.number.at(tried), number + 100);
      },
      record.summary);

  const std::string folder = fresh_folder("numbers");
  HistoryRow of_step;
  static_cast<StepNumbers&>(of_step) = record.summary;
  History(folder + "/history.csv", world()).append(of_step);
  world()->barrier();
  std::stringstream file;
  file << std::ifstream(folder + "/history.csv").rdbuf();
  TEST_INEQUALITY_CONST(file.str().find(row), std::string::npos);
}

TEUCHOS_UNIT_TEST(Recorder, EveryNumberOfAReportIsTaken) {
  StepReport report;
  report.selection_rounds = 1;
  report.estimate_solves = 2;
  report.error_estimate = 3;
  report.newton.newton_iterations = 4;
  report.newton.failed_solves = 5;
  report.newton.krylov_iterations = 6;
  report.newton.local_solves = 7;
  report.newton.complementarity = 8;
  report.newton.penetration = 9;
  report.cost.factorised = 10;
  report.cost.whole = 11;
  report.cost.reused = 12;
  report.cost.levels = 13;
  report.cost.levels_refused = 14;
  const auto numbers = numbers_of(report);
  TEST_EQUALITY_CONST(numbers.linear_solves, 6);
  each_number(
      [&](const char*, const std::string& name, OverSteps, const auto& value) {
        out << name << " = " << value << "\n";
        TEST_EQUALITY(value == 0, name.find("_points") != std::string::npos);
      },
      numbers);
}

TEUCHOS_UNIT_TEST(Recorder, AWarningIsToldOnce) {
  Recorded r(fresh_folder("warned"));
  Warning w;
  w.what = "kind";
  w.text = "The stone hangs.";
  TEST_ASSERT(r.recorder->warn(w));
  TEST_ASSERT(!r.recorder->warn(w));
  TEST_EQUALITY(r.recorder->summary().warnings.size(), 1);
}

}  // namespace

#include "study/motion_study.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "dynamics/load_steps.hpp"
#include "linalg/reduce.hpp"
#include "model/plane/plane_model.hpp"
#include "output/study_table.hpp"
#include "range/checked_blocks.hpp"
#include "step/release.hpp"
#include "study/processor_clock.hpp"
#include "time/dynamic_step.hpp"

namespace voussoir {
namespace {

nlohmann::ordered_json entry_of(const MotionRow& r) {
  return {{"family", r.family},
          {"size", r.size},
          {"peak_m_s2", r.peak},
          {"mode", r.mode},
          {"ranks", r.ranks},
          {"blocks", r.blocks},
          {"candidate_points", r.candidate_points},
          {"steps", r.steps},
          {"selected_points", r.selected},
          {"changed_points", r.changed},
          {"seconds_per_step", r.seconds},
          {"solves_per_step", r.solves},
          {"krylov_per_step", r.krylov},
          {"in_bonded", r.in_bonded},
          {"krylov_in_bonded", r.krylov_in_bonded},
          {"estimate", r.estimate},
          {"outcome", r.outcome}};
}

/// Of every point a rank owns.
std::vector<PointStatus> statuses(const PlaneModel& model, const ContactState& state) {
  std::vector<PointStatus> status;
  for (int k = 0; k < model.points().owned(); ++k) status.push_back(status_of(state, k));
  return status;
}

}  // namespace

MotionStudy::MotionStudy(const std::string& folder, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                         std::ostream& say)
    : folder_(folder), comm_(comm), say_(say) {
  say_ << "family    size  peak [m/s2]  mode      blocks  steps  selected  changed  solves  krylov  s per step  "
          "in bonded steps  their krylov  estimate\n";
}

void MotionStudy::add(const std::string& family, double size, double peak, Scene scene) {
  const auto source = checked_blocks<2>(scene, comm_);
  MotionRow bonded;
  for (const auto mode : {SelectionMode::bonded, SelectionMode::adaptive}) {
    scene.selection.mode = mode;
    const PlaneModel model(scene, *source, comm_);
    MotionRow row;
    row.family = family;
    row.size = size;
    row.peak = peak;
    row.ranks = comm_->getSize();
    row.blocks = source->block_count();
    row.candidate_points = model.points().total();
    row.mode = name_of(mode);
    run(scene, model, row);
    if (mode == SelectionMode::bonded) bonded = row;
    row.in_bonded = row.seconds / bonded.seconds;
    row.krylov_in_bonded = row.krylov / bonded.krylov;
    rows_.push_back(row);
    say(row);
  }
  write();
}

void MotionStudy::run(const Scene& scene, const PlaneModel& model, MotionRow& row) const {
  AdaptiveStep at_rest(model);
  DynamicStep in_time(model);
  LoadSteps steps(scene.stages, scene.load_steps);
  auto state = at_rest.initial_state();
  row.outcome = "done";
  std::vector<double> load, prescribed;
  std::vector<PointStatus> status;
  for (; !steps.finished() && row.outcome == "done"; steps.accept()) {
    if (!steps.dynamic()) {
      model.loads(steps.factors(), 0.0, load, prescribed);
      if (!advance(at_rest, state, {load, prescribed}).converged()) row.outcome = "not converged";
      continue;
    }
    if (!in_motion(*comm_, state)) {
      in_time.begin(state);
      status = statuses(model, state);
    }
    const double time_step = steps.stage_parameters().time_step;
    steps.set_time_step(time_step);
    in_time.set_time_step(time_step);
    loads_of_time_step(model, steps, load, prescribed);
    const ProcessorClock clock(*comm_);
    const auto report = advance(in_time, state, {load, prescribed});
    row.seconds += clock.seconds();
    if (report.step.newton.outcome != NewtonOutcome::converged) row.outcome = "not converged";
    ++row.steps;
    row.solves += report.step.newton.newton_iterations + report.step.estimate_solves;
    row.krylov += static_cast<double>(report.step.newton.krylov_iterations);
    row.selected += static_cast<double>(count_selected(model, state));
    row.estimate = std::max(row.estimate, report.step.error_estimate);
    const auto before = std::exchange(status, statuses(model, state));
    int changed = 0;
    for (std::size_t k = 0; k < status.size(); ++k) changed += status[k] != before[k];
    row.changed += total_over_ranks(*comm_, static_cast<double>(changed));
  }
  for (double* mean : {&row.seconds, &row.solves, &row.krylov, &row.selected, &row.changed})
    *mean /= std::max(1, row.steps);
}

void MotionStudy::say(const MotionRow& r) const {
  std::ostringstream line;
  line << std::setprecision(3) << std::left << std::setw(8) << r.family << std::right << std::setw(6) << r.size
       << std::setw(13) << r.peak << "  " << std::left << std::setw(8) << r.mode << std::right << std::setw(8)
       << r.blocks << std::setw(7) << r.steps << std::setw(10) << r.selected << std::setw(9) << r.changed
       << std::setw(8) << r.solves << std::setw(8) << r.krylov << std::setw(12) << r.seconds << std::setw(17)
       << r.in_bonded << std::setw(14) << r.krylov_in_bonded << std::setw(10) << r.estimate
       << (r.outcome == "done" ? "" : "  " + r.outcome);
  say_ << line.str() << std::endl;
}

void MotionStudy::write() const {
  std::vector<std::string> names;
  const auto empty = entry_of(MotionRow{});
  for (const auto& [name, value] : empty.items()) names.push_back(name);
  auto table = nlohmann::ordered_json::array();
  for (const auto& row : rows_) table.push_back(entry_of(row));
  write_study_table(folder_, "motions", names, table, *comm_);
}

}  // namespace voussoir

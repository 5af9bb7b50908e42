#include "study/accuracy_study.hpp"

#include <Teuchos_Time.hpp>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "dynamics/load_steps.hpp"
#include "linalg/agree.hpp"
#include "linalg/reduce.hpp"
#include "model/plane/plane_model.hpp"
#include "output/safe_file.hpp"
#include "range/checked_blocks.hpp"
#include "step/adaptive_step.hpp"
#include "step/release.hpp"

namespace voussoir {
namespace {

constexpr int dim = 2;

double largest_displacement(const Structure<dim>& structure, const std::vector<double>& u) {
  double largest = 0;
  for (int i = 0; i < structure.owned_nodes(); ++i) largest = std::max(largest, std::hypot(u[dim * i], u[dim * i + 1]));
  return largest_over_ranks(*structure.comm(), largest);
}

/// All load steps of the scene, with halving; the state at the end of the last one that was solved.
ContactState solve(const Scene& scene, const PlaneModel& model, AccuracyRow& row, std::ostream& say) {
  AdaptiveStep step(model);
  LoadSteps steps(scene.stages, scene.load_steps);
  auto state = step.initial_state();
  row.outcome = "equilibrium";
  while (!steps.finished()) {
    const auto before = state;
    std::vector<double> load, prescribed;
    model.loads(steps.factors(), 0.0, load, prescribed);
    const auto report = advance(step, state, {load, prescribed});
    row.linear_solves += report.newton.newton_iterations + report.estimate_solves;
    row.krylov_iterations += report.newton.krylov_iterations;
    if (report.newton.outcome == NewtonOutcome::converged) {
      row.estimate = std::fmax(row.estimate, report.error_estimate);
      row.last_estimate = report.error_estimate;
      row.unknowns = dim * report.largest_clusters;
      steps.accept();
      continue;
    }
    state = before;
    if (steps.halve()) continue;
    row.outcome = report.newton.outcome == NewtonOutcome::collapse ? "collapse" : "not converged";
    say << "  stage '" << steps.stage() << "', load factor " << number_text(steps.target()) << ": "
        << report.newton.reason << "\n";
    break;
  }
  return state;
}

bool solved(const AccuracyRow& row) { return row.outcome == "equilibrium"; }

/// Empty for what is not known.
std::string cell(double value) { return std::isnan(value) ? "" : number_text(value); }

}  // namespace

AccuracyStudy::AccuracyStudy(const Scene& scene, const std::string& folder,
                             const Teuchos::RCP<const Teuchos::Comm<int>>& comm, std::ostream& say)
    : scene_(scene), folder_(folder), comm_(comm), say_(say) {}

AccuracyRow AccuracyStudy::run(const Scene& scene, Field* keep, const Field* truth) const {
  AccuracyRow row;
  row.mode = name_of(scene.selection.mode);
  if (scene.selection.mode == SelectionMode::adaptive) row.threshold = scene.selection.error_tolerance;
  row.element_size = element_size(scene);
  Teuchos::Time clock("run", true);
  const auto source = checked_blocks<2>(scene, comm_);
  const PlaneModel model(scene, *source, comm_);
  const auto state = solve(scene, model, row, say_);
  row.seconds = largest_over_ranks(*comm_, clock.totalElapsedTime(true));

  const auto& structure = model.structure();
  row.blocks = source->block_count();
  row.candidate_points = model.points().total();
  row.selected_points = count_selected(model, state);
  row.energy = structure.elastic_energy(state.displacement);
  row.largest_displacement = largest_displacement(structure, state.displacement);
  Field field;
  field.node.assign(structure.node_id().begin(), structure.node_id().begin() + structure.owned_nodes());
  for (int i = 0; i < structure.owned_nodes(); ++i)
    for (int c = 0; c < dim; ++c) {
      field.displacement.push_back(state.displacement[dim * i + c]);
      field.position.push_back(structure.position()[i][c]);
    }
  if (truth) {
    VOUSSOIR_CHECK(field.node == truth->node && field.position == truth->position);
    // Only owned entries are compared, and they touch owned blocks alone: the halo may stay zero.
    std::vector<double> u(state.displacement.size(), 0.0), e = u;
    for (std::size_t i = 0; i < field.displacement.size(); ++i) {
      u[i] = truth->displacement[i];
      e[i] = field.displacement[i] - u[i];
    }
    const double moved = largest_displacement(structure, u);
    row.error_energy = std::sqrt(structure.elastic_energy(e) / structure.elastic_energy(u));
    row.error_displacement = std::abs(row.largest_displacement - moved) / moved;
  }
  if (keep) *keep = std::move(field);
  return row;
}

void AccuracyStudy::sweep_selection(const std::vector<double>& thresholds) {
  Scene scene = scene_;
  Field truth;
  bool known = false;
  begin("Selection");
  const auto add = [&](Field* keep) {
    auto row = run(scene, keep, known ? &truth : nullptr);
    row.sweep = "selection";
    if (!solved(row)) row.error_energy = row.error_displacement = AccuracyRow::unknown;
    if (keep && solved(row)) {
      known = true;
      row.error_energy = row.error_displacement = 0;
    }
    end(row);
    rows_.push_back(row);
    write();
  };
  scene.selection.mode = SelectionMode::all;
  add(&truth);
  scene.selection.mode = SelectionMode::adaptive;
  if (!known) {
    scene.selection.error_tolerance = 0;
    add(&truth);
  }
  for (double threshold : thresholds) {
    scene.selection.error_tolerance = threshold;
    add(nullptr);
  }
  scene.selection.mode = SelectionMode::bonded;
  add(nullptr);
}

void AccuracyStudy::sweep_element_size(std::vector<double> factors, double affordable) {
  std::sort(factors.rbegin(), factors.rend());
  begin("Element size");
  const std::size_t first = rows_.size();
  for (double factor : factors) {
    const auto scene = with_element_size(scene_, factor);
    AccuracyRow row;
    const double size = element_size(scene);
    if (rows_.size() > first) {
      const auto& coarser = rows_.back();
      if (size == coarser.element_size) continue;  // a block has at least one cell
      const double predicted = static_cast<double>(coarser.unknowns) * std::pow(coarser.element_size / size, dim);
      if (predicted > affordable) {
        say_ << "  " << number_text(size) << " m left out: about " << std::llround(predicted)
             << " unknowns. Ask for it with --sizes.\n";
        break;
      }
    }
    try {
      row = run(scene, nullptr, nullptr);
    } catch (const InputError& error) {
      say_ << error.what() << "\n";
      row.mode = name_of(scene.selection.mode);
      row.element_size = size;
      row.outcome = "refused";
    }
    row.sweep = "element size";
    rows_.push_back(row);
    end(row);
    write();
  }
  const auto finest = std::find_if(rows_.rbegin(), rows_.rend() - static_cast<std::ptrdiff_t>(first), solved);
  if (finest == rows_.rend() - static_cast<std::ptrdiff_t>(first)) return;
  const AccuracyRow best = *finest;
  for (std::size_t k = first; k < rows_.size(); ++k) {
    if (!solved(rows_[k])) continue;
    rows_[k].error_energy = std::sqrt(std::abs(rows_[k].energy - best.energy) / best.energy);
    rows_[k].error_displacement =
        std::abs(rows_[k].largest_displacement - best.largest_displacement) / best.largest_displacement;
  }
  write();
}

void AccuracyStudy::begin(const std::string& what) const {
  say_ << "\n"
       << what << "\n  mode      threshold  size [m]  unknowns  selected      candidates  error      estimate"
       << "   solves  krylov  seconds  outcome\n";
}

void AccuracyStudy::end(const AccuracyRow& row) const {
  std::ostringstream line;
  const auto number = [&](double value, int width) {
    if (std::isnan(value))
      line << std::setw(width) << "--";
    else
      line << std::setw(width) << std::setprecision(3) << value;
    line << "  ";
  };
  line << "  " << std::left << std::setw(8) << row.mode << "  ";
  number(row.threshold, 9);
  number(row.element_size, 8);
  line << std::setw(8) << row.unknowns << "  " << std::setw(12) << row.selected_points << "  " << std::setw(10)
       << row.candidate_points << "  ";
  number(row.error_energy, 9);
  number(row.estimate, 9);
  line << std::setw(6) << row.linear_solves << "  " << std::setw(6) << row.krylov_iterations << "  ";
  number(row.seconds, 7);
  say_ << line.str() << row.outcome << std::endl;
}

void AccuracyStudy::write() const {
  std::ostringstream csv;
  csv << "sweep,mode,threshold,element_size_m,blocks,unknowns,candidate_points,selected_points,error_energy,"
         "error_displacement,estimate,effectivity,seconds,linear_solves,krylov_iterations,outcome,last_estimate,"
         "largest_displacement_m,energy_J\n";
  for (const auto& r : rows_) {
    // The estimate is of what stays bonded, not of the mesh.
    const bool comparable = r.sweep == "selection" && r.error_energy > 0;
    const double effectivity = comparable ? r.estimate / r.error_energy : AccuracyRow::unknown;
    csv << r.sweep << ',' << r.mode << ',' << cell(r.threshold) << ',' << cell(r.element_size) << ',' << r.blocks << ','
        << r.unknowns << ',' << r.candidate_points << ',' << r.selected_points << ',' << cell(r.error_energy) << ','
        << cell(r.error_displacement) << ',' << cell(r.estimate) << ',' << cell(effectivity) << ',' << cell(r.seconds)
        << ',' << r.linear_solves << ',' << r.krylov_iterations << ',' << r.outcome << ',' << cell(r.last_estimate)
        << ',' << cell(r.largest_displacement) << ',' << cell(r.energy) << '\n';
  }
  on_first_rank(*comm_, [&] { replace_file(folder_ + "/accuracy.csv", csv.str()); });
}

}  // namespace voussoir

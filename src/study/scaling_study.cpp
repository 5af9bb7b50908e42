#include "study/scaling_study.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "blocks/assembly.hpp"
#include "dynamics/load_steps.hpp"
#include "linalg/linear_solver.hpp"
#include "linalg/reduce.hpp"
#include "linalg/solver_failure.hpp"
#include "model/plane/plane_model.hpp"
#include "model/step_counts.hpp"
#include "output/result_json.hpp"
#include "output/study_table.hpp"
#include "range/checked_blocks.hpp"
#include "results/shares_of_ranks.hpp"
#include "step/adaptive_step.hpp"
#include "step/release.hpp"
#include "study/processor_clock.hpp"

namespace voussoir {
namespace {

constexpr double price_tolerance = 1e-8;
constexpr int price_repetitions = 3;

void assemble_blocks(const Structure<2>& structure) {
  const auto& model = structure.model();
  for (int b = 0; b < structure.owned_blocks(); ++b) {
    const auto& block = structure.blocks()[b];
    block_stiffness(block.mesh, block.material, model.plane, thickness_of(block.material, model));
  }
}

long long bytes_of_blocks(const Structure<2>& structure) {
  std::set<const LocalCsr*> shapes;
  for (const auto& block : structure.blocks()) shapes.insert(block.stiffness.get());
  long long bytes = 0;
  for (const auto* stiffness : shapes) bytes += stiffness->bytes();
  return bytes;
}

const char* name_of(NewtonOutcome outcome) {
  return outcome == NewtonOutcome::converged  ? "equilibrium"
         : outcome == NewtonOutcome::collapse ? "collapse"
                                              : "not converged";
}

struct Column {
  const char* name;
  nlohmann::ordered_json value;
};

/// The columns of the table, in order.
std::vector<Column> columns(const ScalingRow& r) {
  return {{"family", r.family},
          {"size", r.size},
          {"mode", r.mode},
          {"ranks", r.ranks},
          {"step", r.step},
          {"stage", r.stage},
          {"blocks", r.blocks},
          {"continuum_unknowns", r.price.unknowns},
          {"unknowns", r.unknowns},
          {"candidate_points", r.candidate_points},
          {"selected_points", r.selected_points},
          {"continuum_stiffness_s", r.price.stiffness_seconds},
          {"continuum_setup_s", r.price.setup_seconds},
          {"continuum_solve_s", r.price.solve_seconds},
          {"continuum_s", r.price.seconds()},
          {"continuum_krylov", r.price.krylov_iterations},
          {"seconds", r.seconds},
          {"in_continua", r.in_continua()},
          {"linear_solves", r.linear_solves},
          {"krylov_iterations", r.krylov_iterations},
          {"patch_solves", r.patch_solves},
          {"krylov_in_continua", r.krylov_in_continua()},
          {"mean_krylov", r.mean_krylov()},
          {"largest_krylov", r.largest_krylov},
          {"selection_rounds", r.selection_rounds},
          {"factorised", r.factorised},
          {"factored_whole", r.factorised_whole},
          {"reused", r.factors_reused},
          {"stiffness_bytes_per_unknown", r.stiffness_bytes},
          {"matrix_bytes_per_unknown", r.matrix_bytes},
          {"block_bytes_per_unknown", r.block_bytes},
          {"motion_bytes_per_unknown", r.motion_bytes},
          {"whole_bytes_per_unknown", r.whole_bytes},
          {"edge_cut", r.partition.cut},
          {"neighbours", r.partition.neighbours},
          {"unknowns_imbalance", r.partition.imbalance},
          {"points_imbalance", r.points_imbalance},
          {"messages_per_solve", r.per_solve.messages},
          {"bytes_per_solve", r.per_solve.bytes},
          {"collectives_per_solve", r.per_solve.collectives},
          {"collective_bytes_per_solve", r.per_solve.collective_bytes},
          {"messages_per_krylov", r.per_krylov.messages},
          {"bytes_per_krylov", r.per_krylov.bytes},
          {"collectives_per_krylov", r.per_krylov.collectives},
          {"collective_bytes_per_krylov", r.per_krylov.collective_bytes},
          {"estimate", r.error_estimate},
          {"peak_memory_MB", r.peak_memory_MB},
          {"outcome", r.outcome}};
}

}  // namespace

ContinuumPrice continuum_price(const PlaneModel& model, const std::vector<double>& load,
                               const std::vector<double>& prescribed) {
  const auto& structure = model.structure();
  const auto& comm = *structure.comm();
  constexpr double never = std::numeric_limits<double>::infinity();
  ContinuumPrice price;
  price.stiffness_seconds = price.setup_seconds = price.solve_seconds = never;
  for (int k = 0; k < price_repetitions; ++k) {
    const ProcessorClock assembly(comm);
    assemble_blocks(structure);
    price.stiffness_seconds = std::min(price.stiffness_seconds, assembly.seconds());
    const ProcessorClock setup(comm);
    const Continuum continuum(structure, model.points(), model.held(), model.settings().solver.muelu);
    price.setup_seconds = std::min(price.setup_seconds, setup.seconds());
    // What supports prescribe acts as a load: its columns of the stiffness are on the right-hand side.
    std::vector<double> forces;
    structure.apply_stiffness(model.held().held_part(prescribed, model.components()), forces);
    for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = load[i] - forces[i];
    const auto b = Teuchos::rcp(new TpetraVector(continuum.space().map()));
    const auto x = Teuchos::rcp(new TpetraVector(continuum.space().map()));
    continuum.space().sum(forces, *b);
    price.unknowns = static_cast<long long>(continuum.space().map()->getGlobalNumElements());
    LinearSolver solver(model.settings().solver);
    const ProcessorClock solve(comm);
    const auto solved = solver.solve(continuum.matrix(), continuum.preconditioner(), b, x, price_tolerance);
    if (!solved.converged) throw SolverFailure("scaling: the price of a continuum is unknown: " + solved.failure);
    price.krylov_iterations = solved.iterations;
    price.solve_seconds = std::min(price.solve_seconds, solve.seconds());
  }
  return price;
}

ScalingStudy::ScalingStudy(const std::string& folder, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                           std::ostream& say)
    : folder_(folder), comm_(comm), say_(say) {
  say_ << "family    size  mode      step  blocks  continuum [s]  it  seconds   in continua  selected  solves  krylov  "
          "in continua  estimate  outcome\n";
}

void ScalingStudy::add(const std::string& family, double size, Scene scene, const std::vector<SelectionMode>& modes) {
  const auto source = checked_blocks<2>(scene, comm_);
  // Nothing of the model depends on the mode: runs share it, and its price.
  PlaneModel model(scene, *source, comm_);
  std::vector<double> load, prescribed;
  model.loads(LoadSteps(scene.stages, scene.load_steps).factors(), 0.0, load, prescribed);
  ScalingRow row;
  row.family = family;
  row.size = size;
  row.ranks = comm_->getSize();
  row.blocks = source->block_count();
  row.candidate_points = model.points().total();
  row.partition = partition_quality(model);
  row.price = continuum_price(model, load, prescribed);
  for (const auto mode : modes) {
    scene.selection.mode = mode;
    model.set_selection(scene.selection);
    row.mode = name_of(mode);
    run(scene, model, row);
  }
}

void ScalingStudy::run(const Scene& scene, const PlaneModel& model, ScalingRow row) {
  AdaptiveStep step(model);
  LoadSteps steps(scene.stages, scene.load_steps);
  auto state = step.initial_state();
  row.outcome = name_of(NewtonOutcome::converged);
  for (row.step = 1; !steps.finished() && row.outcome == name_of(NewtonOutcome::converged); ++row.step) {
    std::vector<double> load, prescribed;
    model.loads(steps.factors(), 0.0, load, prescribed);
    row.stage = steps.stage();
    const ProcessorClock clock(*comm_);
    const auto traffic_before = traffic_so_far();
    const auto report = advance(step, state, {load, prescribed});
    const auto traffic = traffic_since(traffic_before);
    row.seconds = clock.seconds();
    static_cast<StepNumbers&>(row) = numbers_of(report);
    row.largest_krylov = report.newton.largest_krylov;
    row.unknowns = 2 * report.largest_clusters;
    row.cost = report.cost;
    const auto per_unknown = [&](long long bytes) {
      return static_cast<double>(total_over_ranks(*comm_, bytes)) / static_cast<double>(row.unknowns);
    };
    row.matrix_bytes = per_unknown(row.cost.matrix_bytes);
    row.block_bytes = per_unknown(row.cost.block_bytes);
    row.motion_bytes = per_unknown(row.cost.motion_bytes);
    row.whole_bytes = per_unknown(row.cost.whole_bytes);
    row.stiffness_bytes = per_unknown(bytes_of_blocks(model.structure()));
    row.outcome = name_of(report.newton.outcome);
    row.selected_points = count_selected(model, state);
    row.points_imbalance = imbalance_of_selected(model, state);
    row.per_krylov = traffic_of_krylov(traffic, *comm_) / row.krylov_iterations;
    row.per_solve = traffic_of_solves(traffic, *comm_) / row.linear_solves;
    const auto memory = peak_memory_per_rank(*comm_);
    row.peak_memory_MB = *std::max_element(memory.begin(), memory.end());
    rows_.push_back(row);
    say(row);
    write();
    steps.accept();
  }
}

void ScalingStudy::say(const ScalingRow& r) const {
  std::ostringstream line;
  line << std::setprecision(3) << std::left << std::setw(8) << r.family << std::right << std::setw(6) << r.size << "  "
       << std::left << std::setw(8) << r.mode << std::right << std::setw(6) << r.step << std::setw(8) << r.blocks
       << std::setw(15) << r.price.seconds() << std::setw(4) << r.price.krylov_iterations << std::setw(9) << r.seconds
       << std::setw(14) << r.in_continua() << std::setw(10) << r.selected_points << std::setw(8) << r.linear_solves
       << std::setw(8) << r.krylov_iterations << std::setw(13) << r.krylov_in_continua() << std::setw(10)
       << r.error_estimate << "  " << r.outcome;
  say_ << line.str() << std::endl;
}

void ScalingStudy::write() const {
  std::vector<std::string> names;
  for (const auto& column : columns({})) names.emplace_back(column.name);
  auto table = nlohmann::ordered_json::array();
  for (const auto& row : rows_) {
    nlohmann::ordered_json entry;
    for (const auto& [name, value] : columns(row)) entry[name] = value;
    table.push_back(entry);
  }
  write_study_table(folder_, "scaling", names, table, *comm_);
}

Scene wall_of(Scene scene, int courses) {
  scene.mesh.wall.courses = scene.mesh.wall.blocks_per_course = courses;
  scene.mesh.wall_in_space.courses = scene.mesh.wall_in_space.blocks_per_course = courses;
  return scene;
}

Scene arch_of(Scene scene, int voussoirs) {
  scene.mesh.arch.voussoirs = voussoirs;
  return scene;
}

}  // namespace voussoir

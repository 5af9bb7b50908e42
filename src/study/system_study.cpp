#include "study/system_study.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <type_traits>

#include "base/digest.hpp"
#include "base/order_of_magnitude.hpp"
#include "dynamics/load_steps.hpp"
#include "linalg/reduce.hpp"
#include "linalg/shared_system.hpp"
#include "model/plane/plane_model.hpp"
#include "model/space/space_model.hpp"
#include "output/result_json.hpp"
#include "output/study_table.hpp"
#include "range/checked_blocks.hpp"
#include "results/shares_of_ranks.hpp"
#include "step/adaptive_step.hpp"
#include "study/processor_clock.hpp"

namespace voussoir {
namespace {

constexpr double tolerance = 1e-8;
constexpr int repetitions = 5;
const char* const hard_stones = "hard stones";

/// A number in [0, 1) that belongs to two others.
double lot(long long a, long long b) {
  const long long numbers[] = {a, b};
  auto bits = digest(numbers, sizeof numbers);
  // The last bytes of FNV-1a hardly reach its first bits: mix them (finaliser of MurmurHash3, public domain).
  bits ^= bits >> 33;
  bits *= 0xff51afd7ed558ccdull;
  bits ^= bits >> 33;
  return static_cast<double>(bits >> 11) / 9007199254740992.0;  // 2^53
}

/// Blocks of another source, half of them in one more set.
template <int dim>
class StonesByLot : public BlockSource<dim> {
 public:
  explicit StonesByLot(const BlockSource<dim>& given) : given_(given), sets_(given.block_sets()) {
    sets_.push_back(hard_stones);
  }
  BlockId block_count() const override { return given_.block_count(); }
  int node_count(BlockId b) const override { return given_.node_count(b); }
  Block<dim> block(BlockId b) const override {
    auto block = given_.block(b);
    if (lot(b, -1) < 0.5) block.sets.push_back(static_cast<int>(sets_.size()) - 1);
    return block;
  }
  std::vector<Neighbour> neighbours(BlockId b) const override { return given_.neighbours(b); }
  const SetNames& block_sets() const override { return sets_; }
  const std::vector<std::string>& facet_sets() const override { return given_.facet_sets(); }

 private:
  const BlockSource<dim>& given_;
  SetNames sets_;  ///< of a generated mesh: all of them
};

std::vector<PointStiffness> resistances_by_lot(const Model& model, const SystemCase& given) {
  std::vector<PointStiffness> stiffness;
  for (int k = 0; k < model.points().size(); ++k) {
    const auto& point = model.points().points()[k];
    const auto& joint = model.points().joints()[point.joint];
    const bool open = lot(joint.block_i, joint.block_j) < given.open;
    const double factor = std::pow(given.spread, 2 * lot(point.id, -2) - 1);
    const double value = open ? 0.0 : factor * model.local_stiffness()[k];
    stiffness.push_back({value, value});
  }
  return stiffness;
}

constexpr const char* kinds[] = {"outside", "set_up", "krylov", "block_motions", "transfer", "continuum"};
static_assert(std::size(kinds) == traffic_kinds);

void add_levels(const std::string& name, const std::vector<MultigridLevel>& levels, nlohmann::ordered_json& e) {
  std::string rows, entries, ranks;
  for (const auto& level : levels) {
    const char* space = rows.empty() ? "" : " ";
    rows += space + std::to_string(level.rows);
    entries += space + std::to_string(level.entries);
    ranks += space + std::to_string(level.ranks);
  }
  e[name + "_rows"] = rows;
  e[name + "_entries"] = entries;
  e[name + "_ranks"] = ranks;
}

nlohmann::ordered_json entry_of(const SystemRow& r) {
  nlohmann::ordered_json e{{"family", r.given.family},
                           {"size", r.given.size},
                           {"contrast", r.given.contrast},
                           {"open", r.given.open},
                           {"spread", r.given.spread},
                           {"dimension", r.dimension},
                           {"ranks", r.ranks},
                           {"blocks", r.blocks},
                           {"unknowns", r.unknowns},
                           {"candidate_points", r.candidate_points},
                           {"entries", r.entries},
                           {"coarse_unknowns", r.coarse_unknowns},
                           {"iterations", r.iterations},
                           {"residual", r.residual},
                           {"setup_s", r.setup_seconds},
                           {"solve_s", r.solve.processor},
                           {"solve_clock_s", r.solve.clock},
                           {"solve_work_s", r.solve.work},
                           {"motions_factor_s", r.motions_factor_seconds},
                           {"motions_solve_s", r.motions_solve_seconds},
                           {"levels_build_s", r.levels_build_seconds},
                           {"levels_cycle_s", r.levels_cycle_seconds},
                           {"edge_cut", r.partition.cut},
                           {"unknowns_imbalance", r.partition.imbalance},
                           {"points_imbalance", r.points_imbalance},
                           {"seconds_imbalance", r.solve.mean_work > 0 ? r.solve.work / r.solve.mean_work : 1.0},
                           {"neighbours", r.partition.neighbours},
                           {"mean_neighbours", r.partition.mean_neighbours},
                           {"motions_bytes", r.motions_bytes},
                           {"bare_memory_MB", r.bare_memory_MB},
                           {"peak_memory_MB", r.peak_memory_MB}};
  add_levels("level", r.levels, e);
  add_levels("motion_level", r.motion_levels, e);
  for (int k = static_cast<int>(TrafficOf::set_up); k < traffic_kinds; ++k)
    for (const bool total : {true, false}) {
      const auto& traffic = (total ? r.total : r.largest)[k];
      const std::string name = std::string(kinds[k]) + (total ? "_total_" : "_largest_");
      e[name + "messages"] = traffic.messages;
      e[name + "bytes"] = traffic.bytes;
      e[name + "collectives"] = traffic.collectives;
      e[name + "collective_bytes"] = traffic.collective_bytes;
      if (!total) e[name + "message_bytes"] = r.largest_sent[k];
    }
  return e;
}

void time_motions(const ContactProblem& problem, const Model& model, const ContactState& state,
                  const std::vector<PointStiffness>& stiffness, SystemRow& row) {
  const auto& comm = *model.structure().comm();
  const std::vector<char> active(model.structure().local_blocks(), 1);
  const auto time = [&](const SharedSystemParameters& numbers, double& build, double& apply) {
    BlockMotions motions(model.structure(), model.points(), state.selected, problem.space(), active, numbers);
    motions.update(stiffness, {});
    const ProcessorClock building(comm);
    motions.update(stiffness, {});
    build = building.seconds();
    TpetraVector r(problem.map()), z(problem.map());
    r.putScalar(1);
    const ProcessorClock applying(comm);
    for (int k = 0; k < repetitions; ++k) motions.add(r, z);
    apply = applying.seconds() / repetitions;
  };
  SharedSystemParameters numbers;
  time(numbers, row.motions_factor_seconds, row.motions_solve_seconds);
  numbers.most_on_first = static_cast<long long>(order_of_magnitude) * numbers.levels.coarsest;
  numbers.levels_on_one_rank = true;
  if (row.coarse_unknowns > numbers.most_on_first) time(numbers, row.levels_build_seconds, row.levels_cycle_seconds);
}

/// Makes the stones that lots mark harder than the others.
void harden(Scene& scene, double contrast) {
  if (contrast == 1) return;
  auto hard = scene.materials.back();
  hard.name = hard.parameters.blocks = hard_stones;
  hard.parameters.young_modulus *= contrast;
  scene.materials.push_back(hard);
}

/// A model with all points selected, under the loads at the end of all its stages.
template <int dim>
struct WholeSystem {
  WholeSystem(const Scene& scene, const BlockSource<dim>& source, const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
      : model(scene, source, comm), solver(scene.solver), state(AdaptiveStep(model).initial_state()) {
    LoadSteps steps(scene.stages, scene.load_steps);
    while (!steps.finished()) steps.accept();
    model.loads(steps.last_factors(), 0.0, load, prescribed);
    state.selected.assign(state.selected.size(), 1);
    problem = std::make_unique<ContactProblem>(
        ContactProblem::Parts{model.structure(), model.points(), model.continuum(), model.held(),
                              model.local_stiffness(), model.initial_gap(), scene.preconditioner, scene.internals,
                              solver},
        state.selected, ContactProblem::Asked{model.law(), state.slip_origin, load, prescribed});
  }

  /// f - K u of the state [N].
  Teuchos::RCP<TpetraVector> right_side() const {
    const auto x = problem->unknowns(state.displacement);
    const auto b = Teuchos::rcp(new TpetraVector(problem->map()));
    PointField gap;
    problem->evaluate(*x, *b, gap);
    b->scale(-1);
    return b;
  }

  const std::conditional_t<dim == 2, PlaneModel, SpaceModel> model;
  LinearSolver solver;
  ContactState state;
  std::vector<double> load, prescribed;
  std::unique_ptr<ContactProblem> problem;
};

/// Solves the system once: iterations, seconds, traffic, and how far the solution is off.
template <int dim>
void time_solution(WholeSystem<dim>& system, const std::vector<PointStiffness>& stiffness, SystemRow& row) {
  auto& problem = *system.problem;
  const auto& comm = *system.model.structure().comm();
  const auto b = system.right_side();
  const auto d = Teuchos::rcp(new TpetraVector(problem.map()));
  const ClockOfRanks clock(comm);
  const auto before = traffic_so_far();
  forget_largest_sent();
  row.iterations = problem.solve(stiffness, 1.0, b, d, {tolerance}).iterations;  // the residual below says how far
  const auto since = traffic_since(before);
  row.largest_sent = largest_of_each(comm, largest_sent());
  row.solve = clock.seconds();
  for (int k = 0; k < traffic_kinds; ++k) {
    row.total[k] = total_traffic(since[k], comm);
    row.largest[k] = largest_traffic(since[k], comm);
  }
  const auto product = Teuchos::rcp(new TpetraVector(problem.map()));
  problem.system().matrix()->apply(*d, *product);
  product->update(1.0, *b, -1.0);
  row.residual = product->norm2() / b->norm2();
}

/// Of the rank with most, so far.
double largest_memory_MB(const Teuchos::Comm<int>& comm) {
  const auto memory = peak_memory_per_rank(comm);
  return *std::max_element(memory.begin(), memory.end());
}

}  // namespace

SystemStudy::SystemStudy(const std::string& folder, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                         std::ostream& say)
    : folder_(folder), comm_(comm), say_(say), bare_memory_MB_(largest_memory_MB(*comm)) {
  say_ << "family    size  contrast  open  spread  ranks    blocks   unknowns  iterations  set-up  solve [s]  "
          "messages  kB  collectives (an iteration, busiest rank)\n";
}

void SystemStudy::add(const SystemCase& given, Scene scene) {
  scene.preconditioner.factored_up_to = 0;  // iterations are what is counted
  if (scene.mesh.dimension() == 2)
    add_in<2>(given, scene);
  else
    add_in<3>(given, scene);
}

template <int dim>
void SystemStudy::add_in(const SystemCase& given, Scene& scene) {
  const auto source = checked_blocks<dim>(scene, comm_);
  const StonesByLot<dim> stones(*source);
  harden(scene, given.contrast);
  SystemRow row;
  row.given = given;
  const ProcessorClock setup(*comm_);
  WholeSystem<dim> system(scene, stones, comm_);
  const auto stiffness = resistances_by_lot(system.model, given);
  row.setup_seconds = setup.seconds();
  time_solution(system, stiffness, row);
  const auto& problem = *system.problem;
  row.dimension = dim;
  row.ranks = comm_->getSize();
  row.blocks = source->block_count();
  row.unknowns = static_cast<long long>(problem.map()->getGlobalNumElements());
  row.candidate_points = system.model.points().total();
  row.entries = static_cast<long long>(problem.system().matrix()->getGlobalNumEntries());
  row.coarse_unknowns = problem.preconditioner().motions();
  row.motion_levels = problem.preconditioner().motion_levels();
  row.motions_bytes = static_cast<long long>(largest_over_ranks(*comm_, double(problem.cost().motion_bytes)));
  row.partition = partition_quality(system.model);
  row.points_imbalance = imbalance_of_selected(system.model, system.state);
  row.levels = system.model.continuum().levels();
  row.bare_memory_MB = bare_memory_MB_;
  row.peak_memory_MB = largest_memory_MB(*comm_);
  if (row.ranks == 1) time_motions(problem, system.model, system.state, stiffness, row);
  rows_.push_back(row);
  say(row);
  write();
}

void SystemStudy::say(const SystemRow& r) const {
  Traffic sum;
  for (int k = static_cast<int>(TrafficOf::krylov); k < traffic_kinds; ++k) sum = sum + r.largest[k];
  const double n = std::max(1, r.iterations);
  std::ostringstream line;
  line << std::setprecision(3) << std::left << std::setw(8) << r.given.family << std::right << std::setw(6)
       << r.given.size << std::setw(10) << r.given.contrast << std::setw(6) << r.given.open << std::setw(8)
       << r.given.spread << std::setw(7) << r.ranks << std::setw(10) << r.blocks << std::setw(11) << r.unknowns
       << std::setw(12) << r.iterations << std::setw(8) << r.setup_seconds << std::setw(11) << r.solve.processor
       << std::setw(10) << static_cast<double>(sum.messages) / n << std::setw(6)
       << static_cast<double>(sum.bytes) / n / 1e3 << std::setw(8) << static_cast<double>(sum.collectives) / n
       << (r.residual < 2 * tolerance ? "" : "  not converged");
  say_ << line.str() << std::endl;
}

void SystemStudy::write() const {
  std::vector<std::string> names;
  const auto empty = entry_of(SystemRow{});
  for (const auto& [name, value] : empty.items()) names.push_back(name);
  auto table = nlohmann::ordered_json::array();
  for (const auto& row : rows_) table.push_back(entry_of(row));
  write_study_table(folder_, "systems", names, table, *comm_);
}

}  // namespace voussoir

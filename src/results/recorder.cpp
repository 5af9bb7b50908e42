#include "results/recorder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.hpp"
#include "blocks/stresses.hpp"
#include "linalg/fail_together.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"
#include "model/loads_at_work.hpp"
#include "model/phase.hpp"
#include "results/acting_loads.hpp"
#include "results/mesh_rows.hpp"
#include "results/step_warnings.hpp"

namespace voussoir {
namespace {

// Less than a thousandth of the largest motion cannot be seen where a mechanism is drawn.
constexpr double seen = 1e-3;

// As the numbers of fields.h5.
constexpr int open = static_cast<int>(PointStatus::open), stick = static_cast<int>(PointStatus::stick),
              slip = static_cast<int>(PointStatus::slip), bonded = static_cast<int>(PointStatus::bonded);

// Of stones that are not there, and of their joints.
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Appends a force that is given along the axes of a point.
void add_force(const ContactPoint& point, const double* along_axes, std::vector<double>& forces) {
  Vector<3> force{};
  for (int a = 0; a < 3; ++a) force = force + along_axes[a] * point.axis[a];
  forces.insert(forces.end(), force.begin(), force.end());
}

double tangential(const PointField& f, int k, int dim) {
  if (dim == 2) return f[2 * k + 1];  // signed: along the one tangent
  double sum = 0;
  for (int c = 1; c < dim; ++c) sum += f[dim * k + c] * f[dim * k + c];
  return std::sqrt(sum);
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Model& model, const AdaptiveStep& step, const std::string& folder,
                   const Record& so_far)
    : model_(model), step_(step), observations_(scene, model), record_(so_far) {
  Phase phase("output");
  const auto& comm = model.structure().comm();
  auto& sum = record_.summary;
  sum.scene = scene.file;
  sum.ranks = comm->getSize();
  sum.blocks = model.block_count();
  sum.joints = model.points().total_joints();
  sum.nodes = model.structure().total_nodes();
  sum.unknowns = model.components() * sum.nodes;
  sum.candidate_points = model.points().total();
  history_ = std::make_unique<History>(folder + "/history.csv", comm, so_far.summary.steps, observations_.columns());
  if (scene.output.fields) {
    const std::string path = folder + "/fields.h5";
    const bool kept = so_far.written > 0 && cut_fields(path, so_far.written, *comm);
    fields_lost_ = so_far.written > 0 && !kept;
    if (!kept) record_.written = 0;
    fields_ = std::make_unique<FieldsFile>(path, comm, model.components(), record_.written);
    fail_together(*comm, [this] { write_tables(); });  // before the file is closed, which takes all ranks
  }
}

void Recorder::write_tables() {
  const auto& s = model_.structure();
  const int dim = model_.components();
  fields_->write_mesh(model_.in_geometry(
      [&](const auto& source, const auto& structure) { return mesh_rows(source, structure, model_.held()); }));
  JointRows joints;
  for (int k = 0; k < model_.points().owned(); ++k) {
    const auto& p = model_.points().points()[k];
    joints.point.push_back(p.id);
    const auto nodes = model_.points().at(k);
    const auto x = nodes.place(Side::i, s);
    joints.position.insert(joints.position.end(), x.begin(), x.begin() + dim);
    joints.normal.insert(joints.normal.end(), p.axis[0].begin(), p.axis[0].begin() + dim);
    joints.area.push_back(p.area);
    joints.block_i.push_back(model_.points().joints()[p.joint].block_i);
    joints.block_j.push_back(model_.points().joints()[p.joint].block_j);
    joints.main_of_i.push_back(s.node_id()[nodes.main_node(Side::i)]);
    joints.main_of_j.push_back(s.node_id()[nodes.main_node(Side::j)]);
  }
  fields_->write_joints(joints);
}

/// Of the cells of this rank [Pa]; stones that are not there have none.
std::vector<double> Recorder::stresses(const std::vector<double>& deformation) const {
  const int dim = model_.components(), of_cell = dim * (dim + 1) / 2;
  const auto inner = model_.loads_at_work().inner_loads(factors_, time_of_loads_, model_.structure());
  return model_.in_geometry([&](const auto&, const auto& s) {
    auto stress = cell_stresses(s, deformation, inner);
    auto of_block = stress.begin();
    for (int b = 0; b < s.owned_blocks(); ++b) {
      const auto values = static_cast<long>(s.blocks()[b].mesh.cells.size()) * of_cell;
      if (!model_.absent().empty() && model_.absent()[b]) std::fill_n(of_block, values, nothing);
      of_block += values;
    }
    return stress;
  });
}

void Recorder::write_step(const ContactState& state, const std::vector<double>& displacement,
                          const std::vector<double>& deformation, const std::vector<int>& status,
                          const std::string& stage, double load_factor, std::optional<double> time) {
  if (!fields_) return;
  StepRows rows;
  rows.number = ++record_.written;
  rows.stage = stage;
  rows.load_factor = load_factor;
  rows.time = time;
  const int dim = model_.components();
  const auto owned = dim * model_.structure().owned_nodes();
  if (time) rows.velocity.assign(state.velocity.begin(), state.velocity.begin() + owned);
  rows.displacement.assign(displacement.begin(), displacement.begin() + owned);
  rows.stress = stresses(deformation);
  const auto gap = step_.gaps(displacement);
  for (int k = 0; k < model_.points().owned(); ++k) {
    const bool joined = model_.joined(k);
    rows.gap.push_back(joined ? gap[dim * k] : nothing);
    rows.slip.push_back(joined ? tangential(gap, k, dim) : nothing);
    rows.normal_force.push_back(state.lambda[dim * k]);
    rows.tangential_force.push_back(tangential(state.lambda, k, dim));
    if (dim == 3) add_force(model_.points().points()[k], &state.lambda[3 * static_cast<std::size_t>(k)], rows.force);
    rows.selected.push_back(joined ? state.selected[k] : 0);
  }
  rows.status = status;
  rows.loads = acting_loads(model_, factors_, time_of_loads_);
  if (model_.weakens()) {
    rows.damage.emplace();
    for (int k = 0; k < model_.points().owned(); ++k)
      rows.damage->push_back(model_.joined(k) ? damage_of(model_, state, k) : nothing);
  }
  fields_->write_step(rows);
}

void Recorder::record(const LoadStepBook& book, const ContactState& after, const std::vector<double>& load,
                      const StepReport& report, const std::string& stage, double load_factor, bool write_fields,
                      double seconds) {
  Phase phase("output");
  const bool jump = report.passed_in_time || jumped(report, model_.settings().internals.step);
  record_.energy.advance(book.close(after, load, jump), false,
                         model_.inner_energy(factors_, time_of_loads_, after.displacement, model_.absent()));
  const auto reaction = observations_.ask_reactions() ? step_.residual(after, load) : std::vector<double>{};
  finish(after, report, stage, load_factor, {}, reaction, write_fields, seconds);
}

void Recorder::record(const ContactState& after, const TimeStepReport& report, const std::string& stage,
                      double stage_share, double time, bool write_fields, double seconds) {
  Phase phase("output");
  EnergyOfStep energy;
  energy.elastic = report.elastic;
  energy.kinetic = report.kinetic;
  energy.external_work = report.external_work;
  energy.friction = report.friction;
  energy.fracture = report.fracture;
  energy.damping = report.damping;
  energy.work_within_steps = report.work_within;
  record_.energy.advance(energy, true,
                         model_.inner_energy(factors_, time_of_loads_, after.displacement, model_.absent()));
  record_.summary.time = time;
  finish(after, report.step, stage, stage_share, time, report.reaction, write_fields, seconds);
}

/// Points by status, of all ranks.
void Recorder::count(const std::vector<int>& status, StepNumbers& numbers) const {
  for (const int s : status) VOUSSOIR_EXPECT(s >= open && s <= bonded && "status: one of those of fields.h5");
  std::array<long long, 4> mine{};
  for (int s : status) ++mine[s];
  const auto all = total_of_each(*model_.structure().comm(), mine);
  numbers.selected_points = all[open] + all[stick] + all[slip];
  numbers.open_points = all[open];
  numbers.stick_points = all[stick];
  numbers.slip_points = all[slip];
}

/// Of a node [m], over all ranks.
double Recorder::largest_displacement(const std::vector<double>& displacement) const {
  const int dim = model_.components();
  double largest = 0;
  const auto& absent = model_.absent();
  for (int i = 0; i < model_.structure().owned_nodes(); ++i) {
    if (!absent.empty() && absent[model_.structure().block_of_node()[i]]) continue;
    double square = 0;
    for (int c = 0; c < dim; ++c) square += displacement[dim * i + c] * displacement[dim * i + c];
    largest = std::max(largest, std::sqrt(square));
  }
  return largest_over_ranks(*model_.structure().comm(), largest);
}

RunSummary Recorder::result() const {
  auto sum = record_.summary;
  sum.add_work(record_.in_vain);
  return sum;
}

/// The sums of the run.
void Recorder::add_to_sums(const StepNumbers& numbers, double load_factor, double largest_displacement) {
  const auto& energy = record_.energy;
  auto& sum = record_.summary;
  sum.add_step(numbers);
  sum.residual_displacement = largest_displacement;
  if (largest_displacement > sum.largest_displacement) {
    sum.largest_displacement = largest_displacement;
    sum.largest_displacement_time = sum.time;
  }
  sum.energy = {energy.sums(), energy.imbalance(), energy.imbalance_in_time()};
  sum.load_factor = load_factor;
}

/// Counts, the row of the history, the sums of the run, and the fields.
void Recorder::finish(const ContactState& after, const StepReport& report, const std::string& stage, double load_factor,
                      std::optional<double> time, const std::vector<double>& reaction, bool write_fields,
                      double seconds) {
  expect_state(model_, after);
  VOUSSOIR_EXPECT((reaction.empty() || is_of_nodes(model_, reaction)) && "reactions: of node copies, or none");
  VOUSSOIR_EXPECT(seconds >= 0 && "seconds: not negative");
  std::vector<int> status;
  for (int k = 0; k < model_.points().owned(); ++k)
    status.push_back(model_.joined(k) ? static_cast<int>(status_of(after, k)) : bonded);
  const auto& u = after.displacement;
  const double largest = largest_displacement(u);
  HistoryRow row;
  StepNumbers& numbers = row;
  numbers = numbers_of(report);
  count(status, numbers);
  numbers.add_work(std::exchange(record_.in_vain, {}));
  const auto& energy = record_.energy;
  row.energy = energy.sums();
  row.imbalance = energy.imbalance();
  row.imbalance_in_time = energy.imbalance_in_time();
  row.step = ++record_.summary.steps;
  row.stage = stage;
  row.load_factor = load_factor;
  if (time) row.time = *time;
  row.largest_displacement = largest;
  row.seconds = seconds;
  row.observed = observations_.values({u, after.velocity, reaction, model_.absent()});
  history_->append(row);
  add_to_sums(numbers, load_factor, largest);
  if (write_fields) write_step(after, u, model_.structure().deformation(u), status, stage, load_factor, time);
}

std::vector<int> Recorder::statuses_of_motion(const PointField& opening) const {
  const int dim = model_.components();
  std::vector<int> status(model_.points().owned(), stick);
  for (int k = 0; k < model_.points().owned(); ++k) {
    if (std::abs(tangential(opening, k, dim)) > seen) status[k] = slip;
    if (opening[dim * k] > seen) status[k] = open;
    if (!model_.joined(k)) status[k] = bonded;
  }
  return status;
}

void Recorder::record_mechanism(const std::vector<double>& mechanism, const ContactState& state,
                                const std::string& stage, double load_factor) {
  VOUSSOIR_EXPECT(is_of_nodes(model_, mechanism) && "mechanism: of node copies");
  VOUSSOIR_EXPECT(is_of_points(model_, state.lambda) && is_per_point(model_, state.selected) && "state: of the points");
  Phase phase("output");
  write_step(state, mechanism, mechanism, statuses_of_motion(step_.gaps(mechanism)), stage + ": mechanism", load_factor,
             {});
}

void Recorder::record_forces(const PointField& force, const std::string& stage, double load_factor) {
  VOUSSOIR_EXPECT(is_of_points(model_, force) && "force: of points");
  Phase phase("output");
  auto state = step_.initial_state();
  state.lambda = force;
  const std::vector<int> status(model_.points().owned(), bonded);
  write_step(state, state.displacement, state.displacement, status, stage, load_factor, {});
}

}  // namespace voussoir

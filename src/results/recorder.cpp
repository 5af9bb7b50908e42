#include "results/recorder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.hpp"
#include "blocks/stresses.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"
#include "model/phase.hpp"
#include "model/plane/plane_model.hpp"
#include "results/step_warnings.hpp"

namespace voussoir {
namespace {

// Less than a thousandth of the largest motion cannot be seen where a mechanism is drawn.
constexpr double seen = 1e-3;

// As the numbers of fields.h5.
constexpr int open = static_cast<int>(PointStatus::open), stick = static_cast<int>(PointStatus::stick),
              slip = static_cast<int>(PointStatus::slip), bonded = static_cast<int>(PointStatus::bonded);

constexpr int stresses_of_cell = 3;

// Of stones that are not there, and of their joints.
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double tangential(const PointField& f, int k, int dim) {
  if (dim == 2) return f[2 * k + 1];  // signed: along the one tangent
  double sum = 0;
  for (int c = 1; c < dim; ++c) sum += f[dim * k + c] * f[dim * k + c];
  return std::sqrt(sum);
}

}  // namespace

template <int dim>
Recorder<dim>::Recorder(const Scene& scene, const PlaneModel& model, const AdaptiveStep& step,
                        const std::string& folder, const Record& so_far)
    : model_(model), step_(step), observations_(scene, model.source(), model.structure()), record_(so_far) {
  Phase phase("output");
  const auto& comm = model.structure().comm();
  history_ = std::make_unique<History>(folder + "/history.csv", comm, so_far.summary.steps, observations_.columns());
  if (scene.output.fields) {
    const std::string path = folder + "/fields.h5";
    const bool kept = so_far.written > 0 && cut_fields(path, so_far.written, *comm);
    fields_lost_ = so_far.written > 0 && !kept;
    if (!kept) record_.written = 0;
    fields_ = std::make_unique<FieldsFile>(path, comm, dim, record_.written);
    write_tables();
  }
  auto& sum = record_.summary;
  sum.scene = scene.file;
  sum.ranks = comm->getSize();
  sum.blocks = model.source().block_count();
  sum.joints = model.points().total_joints();
  sum.nodes = model.structure().total_nodes();
  sum.unknowns = dim * sum.nodes;
  sum.candidate_points = model.points().total();
}

template <int dim>
void Recorder<dim>::write_tables() {
  const auto& s = model_.structure();
  MeshRows mesh;
  mesh.block_set_names = model_.source().block_sets();
  std::size_t most = 0;
  for (int b = 0; b < s.owned_blocks(); ++b) most = std::max(most, s.blocks()[b].mesh.sets.size());
  mesh.sets_of_a_block = static_cast<int>(largest_over_ranks(*s.comm(), static_cast<long long>(most)));
  // Cells are numbered block by block, like nodes.
  std::vector<long long> mine(s.owner_of_block().size(), 0);
  for (int b = 0; b < s.owned_blocks(); ++b)
    mine[s.blocks()[b].mesh.id] = static_cast<long long>(s.blocks()[b].mesh.cells.size());
  const auto cells = total_of_each(*s.comm(), mine);
  std::vector<long long> first(cells.size() + 1, 0);
  for (std::size_t b = 0; b < cells.size(); ++b) first[b + 1] = first[b] + cells[b];
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    mesh.block.push_back(block.mesh.id);
    mesh.block_set.push_back(block.mesh.sets.empty() ? -1 : block.mesh.sets.front());
    for (int k = 0; k < mesh.sets_of_a_block; ++k)
      mesh.block_sets.push_back(k < static_cast<int>(block.mesh.sets.size()) ? block.mesh.sets[k] : -1);
    for (std::size_t i = 0; i < block.mesh.position.size(); ++i) {
      mesh.node.push_back(block.first_node + static_cast<NodeId>(i));
      mesh.block_of_node.push_back(block.mesh.id);
      const auto held = model_.held().begin() + dim * (block.first_local + static_cast<long>(i));
      mesh.held.push_back(std::any_of(held, held + dim, [](char one) { return one != 0; }));
      mesh.coordinates.insert(mesh.coordinates.end(), block.mesh.position[i].begin(), block.mesh.position[i].end());
    }
    for (std::size_t c = 0; c < block.mesh.cells.size(); ++c) {
      const auto& cell = block.mesh.cells[c];
      mesh.cell.push_back(first[block.mesh.id] + static_cast<long long>(c));
      mesh.corner_count.push_back(cell.count);
      mesh.block_of_cell.push_back(block.mesh.id);
      for (int i = 0; i < cell.count; ++i) mesh.corners.push_back(block.first_node + cell.node[i]);
    }
  }
  fields_->write_mesh(mesh);

  JointRows joints;
  for (int k = 0; k < model_.points().owned(); ++k) {
    const auto& p = model_.points().points()[k];
    joints.point.push_back(p.id);
    const auto nodes = model_.points().at(k);
    const auto x = nodes.place(Side::i, s.position());
    joints.position.insert(joints.position.end(), x.begin(), x.end());
    joints.normal.insert(joints.normal.end(), p.axis[0].begin(), p.axis[0].begin() + dim);
    joints.area.push_back(p.area);
    joints.block_i.push_back(model_.points().joints()[p.joint].block_i);
    joints.block_j.push_back(model_.points().joints()[p.joint].block_j);
    joints.main_of_i.push_back(s.node_id()[nodes.main_node(Side::i)]);
    joints.main_of_j.push_back(s.node_id()[nodes.main_node(Side::j)]);
  }
  fields_->write_joints(joints);
}

template <int dim>
void Recorder<dim>::write_step(const ContactState& state, const std::vector<double>& displacement,
                               const std::vector<double>& deformation, const std::vector<int>& status,
                               const std::string& stage, double load_factor, std::optional<double> time) {
  if (!fields_) return;
  StepRows rows;
  rows.number = ++record_.written;
  rows.stage = stage;
  rows.load_factor = load_factor;
  rows.time = time;
  const auto& s = model_.structure();
  const auto owned = dim * s.owned_nodes();
  if (time) rows.velocity.assign(state.velocity.begin(), state.velocity.begin() + owned);
  rows.displacement.assign(displacement.begin(), displacement.begin() + owned);
  rows.stress = cell_stresses(s, deformation, free_strain_);
  auto of_cell = rows.stress.begin();
  for (int b = 0; b < s.owned_blocks(); ++b) {  // stones that are not there have none
    const auto values = static_cast<long>(s.blocks()[b].mesh.cells.size()) * stresses_of_cell;
    if (!model_.absent().empty() && model_.absent()[b]) std::fill_n(of_cell, values, nothing);
    of_cell += values;
  }
  const auto gap = step_.gaps(displacement);
  for (int k = 0; k < model_.points().owned(); ++k) {
    const bool joined = model_.joined(k);
    rows.gap.push_back(joined ? gap[dim * k] : nothing);
    rows.slip.push_back(joined ? tangential(gap, k, dim) : nothing);
    rows.normal_force.push_back(state.lambda[dim * k]);
    rows.tangential_force.push_back(tangential(state.lambda, k, dim));
    rows.selected.push_back(joined ? state.selected[k] : 0);
  }
  rows.status = status;
  if (model_.weakens()) {
    rows.damage.emplace();
    for (int k = 0; k < model_.points().owned(); ++k)
      rows.damage->push_back(model_.joined(k) ? damage_of(model_, state, k) : nothing);
  }
  fields_->write_step(rows);
}

template <int dim>
void Recorder<dim>::record(const LoadStepBook<dim>& book, const ContactState& after, const std::vector<double>& load,
                           const StepReport& report, const std::string& stage, double load_factor, bool write_fields,
                           double seconds) {
  Phase phase("output");
  const bool jump = report.passed_in_time || jumped(report, model_.settings().internals.step);
  record_.energy.advance(book.close(after, load, jump));
  const auto reaction = observations_.ask_reactions() ? step_.residual(after, load) : std::vector<double>{};
  finish(after, report, stage, load_factor, {}, reaction, write_fields, seconds);
}

template <int dim>
void Recorder<dim>::record(const ContactState& after, const TimeStepReport& report, const std::string& stage,
                           double stage_share, double time, bool write_fields, double seconds) {
  Phase phase("output");
  EnergyOfStep energy;
  energy.elastic = report.elastic;
  energy.kinetic = report.kinetic;
  energy.external_work = report.external_work;
  energy.friction = report.friction;
  energy.fracture = report.fracture;
  energy.damping = report.damping;
  energy.work_within_steps = report.work_of_impulses;
  record_.energy.advance(energy, true);
  record_.summary.time = time;
  finish(after, report.step, stage, stage_share, time, report.reaction, write_fields, seconds);
}

/// Points by status, of all ranks.
template <int dim>
void Recorder<dim>::count(const std::vector<int>& status, StepNumbers& numbers) const {
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
template <int dim>
double Recorder<dim>::largest_displacement(const std::vector<double>& displacement) const {
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

template <int dim>
RunSummary Recorder<dim>::result() const {
  auto sum = record_.summary;
  sum.add_work(record_.in_vain);
  return sum;
}

/// The sums of the run.
template <int dim>
void Recorder<dim>::add_to_sums(const StepNumbers& numbers, double load_factor, double largest_displacement) {
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
template <int dim>
void Recorder<dim>::finish(const ContactState& after, const StepReport& report, const std::string& stage,
                           double load_factor, std::optional<double> time, const std::vector<double>& reaction,
                           bool write_fields, double seconds) {
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

template <int dim>
std::vector<int> Recorder<dim>::statuses_of_motion(const PointField& opening) const {
  std::vector<int> status(model_.points().owned(), stick);
  for (int k = 0; k < model_.points().owned(); ++k) {
    if (std::abs(tangential(opening, k, dim)) > seen) status[k] = slip;
    if (opening[dim * k] > seen) status[k] = open;
    if (!model_.joined(k)) status[k] = bonded;
  }
  return status;
}

template <int dim>
void Recorder<dim>::record_mechanism(const std::vector<double>& mechanism, const ContactState& state,
                                     const std::string& stage, double load_factor) {
  VOUSSOIR_EXPECT(is_of_nodes(model_, mechanism) && "mechanism: of node copies");
  VOUSSOIR_EXPECT(is_of_points(model_, state.lambda) && is_per_point(model_, state.selected) && "state: of the points");
  Phase phase("output");
  write_step(state, mechanism, mechanism, statuses_of_motion(step_.gaps(mechanism)), stage + ": mechanism", load_factor,
             {});
}

template <int dim>
void Recorder<dim>::record_forces(const PointField& force, const std::string& stage, double load_factor) {
  VOUSSOIR_EXPECT(is_of_points(model_, force) && "force: of points");
  Phase phase("output");
  auto state = step_.initial_state();
  state.lambda = force;
  const std::vector<int> status(model_.points().owned(), bonded);
  write_step(state, state.displacement, state.displacement, status, stage, load_factor, {});
}

template class Recorder<2>;

}  // namespace voussoir

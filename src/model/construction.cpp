#include "model/construction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "joints/tractions.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"
#include "model/scene_fit.hpp"
#include "scene/scene.hpp"

namespace voussoir {

Construction::Construction(const Scene& scene, const Model& model)
    : structure_(model.structure()),
      builds_(model.settings().builds),
      all_selected_(model.settings().selection.mode == SelectionMode::all) {
  if (!builds_) return;
  drawn_gap_ = model.initial_gap();
  absent_.assign(structure_.local_blocks(), 0);
  for (std::size_t number = 0; number < scene.stages.size(); ++number) {
    auto& absent = absent_in_[scene.stages[number].name];
    model.in_geometry([&, stage = number](const auto& source, const auto& structure) {
      for (const auto& block : structure.blocks()) absent.push_back(!is_there(scene, source, block.mesh, stage));
    });
  }
}

bool Construction::joined(const Model& model, int k) const {
  const auto& joint = model.points().joint_of(k);
  return !absent_[joint.local_i] && !absent_[joint.local_j];
}

/// Blocks that go take their energy along, and their forces on the others are let go. They stay where they were.
void Construction::take(const Model& model, const ContactState& state) {
  const int dim = structure_.components();
  std::vector<double> gone(state.displacement.size(), 0.0), force;
  const auto gaps = model.gaps(state.displacement, state.lambda);
  stays_.assign(absent_.size(), 1);  // but what is absent from now on: some joint of it is not apart yet
  for (int k = 0; k < model.points().size(); ++k)
    for (const int block : {model.points().joint_of(k).local_i, model.points().joint_of(k).local_j})
      if (state.initial_gap[k] != apart() && absent_[block]) stays_[block] = 0;
  for (std::size_t i = 0; i < gone.size(); ++i)
    if (!stays_[structure_.block_of_node()[i / dim]]) gone[i] = state.displacement[i];
  structure_.apply_stiffness(gone, force);
  energy_gone_ = 0;
  for (int i = 0; i < dim * structure_.owned_nodes(); ++i) energy_gone_ += gone[i] * force[i] / 2;
  PointField lambda(state.lambda.size(), 0.0);
  for (int k = 0; k < model.points().size(); ++k) {
    if (joined(model, k) || state.initial_gap[k] == apart()) continue;
    for (int c = 0; c < dim; ++c) lambda[dim * k + c] = state.lambda[dim * k + c];
    if (k < model.points().owned()) energy_gone_ += held_by_joint(model, state, gaps[dim * k], k);
  }
  energy_gone_ += model.mortar_energy(lambda);
  let_go_.assign(gone.size(), 0.0);
  add_contact_forces(model.points(), {}, lambda, 1.0, let_go_);
}

double Construction::taken(const ContactState& start, const ContactState& after) const {
  const int dim = structure_.components();
  VOUSSOIR_EXPECT(start.displacement.size() == after.displacement.size() && "states of one structure");
  if (!builds_) return 0;  // of the scene: a rank may have no block
  double work = 0;
  for (int i = 0; i < dim * structure_.owned_nodes(); ++i)
    work += let_go_[i] * (after.displacement[i] - start.displacement[i]) / 2;
  return total_over_ranks(*structure_.comm(), energy_gone_ - work);
}

/// A side of the point is not there: it stands as far open as the structure is large, and bears nothing.
void Construction::part(int k, ContactState& state) const {
  const int dim = structure_.components();
  state.initial_gap[k] = apart();
  state.selected[k] = 1;
  std::fill_n(state.lambda.begin() + static_cast<long>(dim) * k, dim, 0.0);
}

/// A side of the point appears where the mesh draws it: gap and slip count from where its neighbour has moved to.
void Construction::give_birth(int k, bool can_be_tied, const Vector<3>& between, ContactState& state) const {
  const int dim = structure_.components();
  state.initial_gap[k] = drawn(k) - between[0];
  for (int a = 1; a < dim && !state.slip_origin.empty(); ++a) state.slip_origin[dim * k + a] = between[a];
  // Where both sides are as drawn the point may be tied; else only contact knows where it was born.
  const bool moved = std::any_of(between.begin(), between.end(), [](double motion) { return motion != 0; });
  state.selected[k] = moved || !can_be_tied || drawn(k) > 0 || all_selected_;
  if (!state.opened.empty()) state.opened[k] = state.slipped[k] = 0;
}

/// The 1e-15 m that a solver leaves between closed stones must not wedge what is born on both of them: that would be a
/// force of some percent of the largest, which creeps in or out.
void Construction::close(int k, const Vector<3>& between, ContactState& state) const {
  const double gap = state.initial_gap[k] + between[0];
  if (state.selected[k] && std::abs(gap) < closed_gap * structure_.size()) state.initial_gap[k] -= gap;
  if (all_selected_) state.selected[k] = 1;
}

void Construction::begin(const std::string& stage, Model& model, ContactState& state) {
  if (!builds_) return;
  VOUSSOIR_EXPECT(absent_in_.count(stage) == 1 && "stage: one of the scene");
  expect_state(model, state);
  VOUSSOIR_EXPECT(is_per_point(model, state.initial_gap) && "initial_gap: per point, of what is built");
  absent_ = absent_in_.at(stage);
  model.set_initial_gap(state.initial_gap);
  take(model, state);
  model.set_absent(absent_);

  const int count = model.points().size();
  for (int k = 0; k < count; ++k) {
    const auto between = model.points().at(k).motion(state.displacement);
    if (!joined(model, k))
      part(k, state);
    else if (state.initial_gap[k] == apart())
      give_birth(k, model.points().points()[k].can_be_tied(), between, state);
    else
      close(k, between, state);
  }
  model.set_initial_gap(state.initial_gap);
  for (int k = 0; k < count; ++k)
    VOUSSOIR_ENSURE(state.initial_gap[k] != apart() || !(model.law()[k].tension > 0 || model.law()[k].cohesion > 0));
}

void Construction::restrict(const ContactState& state, std::vector<double>& force,
                            std::vector<double>& prescribed) const {
  const int dim = structure_.components();
  VOUSSOIR_EXPECT(force.size() == state.displacement.size() && "force: of node copies, as the state");
  VOUSSOIR_EXPECT(prescribed.size() == state.displacement.size() &&
                  "prescribed displacement: of node copies, as the state");
  for (std::size_t b = 0; b < absent_.size(); ++b) {
    if (!absent_[b]) continue;
    const auto& block = structure_.nodes_of(static_cast<int>(b));
    const std::size_t from = dim * block.first_local, to = from + dim * block.nodes;
    for (std::size_t i = from; i < to; ++i) {
      force[i] = 0;
      prescribed[i] = state.displacement[i];
    }
  }
}

}  // namespace voussoir

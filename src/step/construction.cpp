#include "step/construction.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "step/scene_fit.hpp"

namespace voussoir {
template <int dim>
Construction<dim>::Construction(const Model<dim>& model)
    : scene_(model.scene()), source_(model.source()), structure_(model.structure()) {
  if (scene_.construction.empty()) return;
  drawn_gap_ = model.initial_gap();
  absent_.assign(structure_.blocks().size(), 0);
}

template <int dim>
bool Construction<dim>::present(const Block<dim>& block, std::size_t stage) const {
  const auto number = [this](const std::string& name) {
    std::size_t k = 0;
    while (scene_.stages[k].name != name) ++k;
    return k;
  };
  for (const auto& [name, c] : scene_.construction) {
    if (!in_set(source_, block, c.blocks)) continue;
    if (!c.appears.empty() && stage < number(c.appears)) return false;
    if (!c.disappears.empty() && stage >= number(c.disappears)) return false;
  }
  return true;
}

/// A side of the point is not there: it stands as far open as the structure is large, and bears nothing.
template <int dim>
void Construction<dim>::part(int k, ContactState& state) const {
  state.initial_gap[k] = apart();
  state.selected[k] = 1;
  std::fill_n(state.lambda.begin() + static_cast<long>(dim) * k, dim, 0.0);
}

/// A side of the point appears where the mesh draws it: gap and slip count from where its neighbour has moved to.
template <int dim>
void Construction<dim>::give_birth(int k, const Vector<dim>& between, ContactState& state) const {
  state.initial_gap[k] = drawn(k) - between[0];
  for (int a = 1; a < dim && !state.slip_origin.empty(); ++a) state.slip_origin[dim * k + a] = between[a];
  // Where both sides are as drawn the point may be tied; else only contact knows where it was born.
  const bool moved = std::any_of(between.begin(), between.end(), [](double motion) { return motion != 0; });
  state.selected[k] = moved || drawn(k) > 0 || scene_.selection.mode == SelectionMode::all;
  if (!state.opened.empty()) state.opened[k] = state.slipped[k] = 0;
}

/// The 1e-15 m that a solver leaves between closed stones must not wedge what is born on both of them: that would be a
/// force of some percent of the largest, which creeps in or out.
template <int dim>
void Construction<dim>::close(int k, const Vector<dim>& between, ContactState& state) const {
  const double gap = state.initial_gap[k] + between[0];
  if (state.selected[k] && std::abs(gap) < closed_gap * structure_.size()) state.initial_gap[k] -= gap;
  if (scene_.selection.mode == SelectionMode::all) state.selected[k] = 1;
}

template <int dim>
void Construction<dim>::begin(const std::string& stage, Model<dim>& model, ContactState& state) {
  if (absent_.empty()) return;
  std::size_t number = 0;
  while (scene_.stages[number].name != stage) ++number;
  for (std::size_t b = 0; b < absent_.size(); ++b) absent_[b] = !present(structure_.blocks()[b].mesh, number);

  const auto& points = model.points().points();
  const int count = static_cast<int>(points.size());
  for (int k = static_cast<int>(state.initial_gap.size()); k < count; ++k) state.initial_gap.push_back(drawn(k));
  for (int k = 0; k < count; ++k) {
    const auto& p = points[k];
    const auto between = relative_motion(p, state.displacement);
    if (absent_[structure_.block_of_node()[p.node_i]] || absent_[structure_.block_of_node()[p.node_j]])
      part(k, state);
    else if (state.initial_gap[k] == apart())
      give_birth(k, between, state);
    else
      close(k, between, state);
  }
  model.set_initial_gap(state.initial_gap);
  model.set_absent(absent_);
  for (int k = 0; k < count; ++k)
    VOUSSOIR_ENSURE(state.initial_gap[k] != apart() || !(model.law()[k].tension > 0 || model.law()[k].cohesion > 0));
}

template <int dim>
void Construction<dim>::restrict(const ContactState& state, std::vector<double>& force,
                                 std::vector<double>& prescribed) const {
  for (std::size_t b = 0; b < absent_.size(); ++b) {
    if (!absent_[b]) continue;
    const auto& block = structure_.blocks()[b];
    const std::size_t from = dim * block.first_local, to = from + dim * block.mesh.position.size();
    for (std::size_t i = from; i < to; ++i) {
      force[i] = 0;
      prescribed[i] = state.displacement[i];
    }
  }
}

template class Construction<2>;

}  // namespace voussoir

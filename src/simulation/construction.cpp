#include "simulation/construction.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/scene_fit.hpp"

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

template <int dim>
void Construction<dim>::begin(const std::string& stage, Model<dim>& model, ContactState& state) {
  if (absent_.empty()) return;
  std::size_t number = 0;
  while (scene_.stages[number].name != stage) ++number;
  for (std::size_t b = 0; b < absent_.size(); ++b) absent_[b] = !present(structure_.blocks()[b].mesh, number);

  // Nothing moves as far as the structure is large.
  const double apart = structure_.size();
  const auto& points = model.points().points();
  const bool all = scene_.selection.mode == SelectionMode::all;
  const auto drawn = [this](std::size_t k) { return drawn_gap_.empty() ? 0.0 : drawn_gap_[k]; };
  if (state.initial_gap.empty())
    for (std::size_t k = 0; k < points.size(); ++k) state.initial_gap.push_back(drawn(k));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& p = points[k];
    const bool missing = absent_[structure_.block_of_node()[p.node_i]] || absent_[structure_.block_of_node()[p.node_j]];
    const bool was_missing = state.initial_gap[k] == apart;
    const auto between = relative_motion(p, state.displacement);
    if (missing) {
      state.initial_gap[k] = apart;
      state.selected[k] = 1;
      std::fill_n(state.lambda.begin() + static_cast<long>(dim * k), dim, 0.0);
    } else if (was_missing) {
      bool moved = false;
      for (int a = 0; a < dim; ++a) {
        moved |= between[a] != 0;
        if (a == 0)
          state.initial_gap[k] = drawn(k) - between[a];
        else if (!state.slip_origin.empty())
          state.slip_origin[dim * k + a] = between[a];
      }
      // Where both sides are as drawn the point may be tied; else only contact knows where it was born.
      state.selected[k] = moved || all || drawn(k) > 0;
      state.broken[k] = 0;
    } else {
      // The 1e-15 m that a solver leaves between closed stones must not wedge what is born on both of them: that would
      // be a force of some percent of the largest, which creeps in or out.
      const double gap = state.initial_gap[k] + between[0];
      if (state.selected[k] && std::abs(gap) < closed_gap * structure_.size()) state.initial_gap[k] -= gap;
      if (all) state.selected[k] = 1;
    }
  }
  model.set_initial_gap(state.initial_gap);
  model.set_absent(absent_);
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

#include "results/observations.hpp"

#include <algorithm>
#include <limits>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/plane_and_space.hpp"
#include "base/text.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
#include "loads/loads.hpp"
#include "model/scene_fit.hpp"
#include "results/support_reactions.hpp"

namespace voussoir {
namespace {

using Place = ObservationParameters::Place;

constexpr const char* axis[] = {"x", "y", "z"};

/// Nodes of this rank with their weights.
using Weights = std::vector<std::pair<int, double>>;

template <int dim>
Weights node_near(const ObservationParameters& p, const std::string& where, const Structure<dim>& s,
                  const std::vector<char>& observed) {
  const auto at = in_dimension<dim>({p.x, p.y, p.z});
  const auto node = nearest_node(s, at, observed);
  if (node.distance > p.tolerance)
    throw InputError(where + " > tolerance = " + number_text(p.tolerance) +
                     " [m]\n  is exceeded: the node nearest to " + vector_text(at) + " m is " +
                     six_digits(node.distance) +
                     " m away.\n  Move the point to the structure, or give a larger tolerance.");
  if (node.local < 0 || node.local >= s.owned_nodes()) return {};
  return {{node.local, 1.0}};
}

/// Of some nodes by what they weigh, [local node copies].
Weights mean_of(const BlockSystem& s, const std::vector<double>& weight) {
  double mine = 0;
  Weights weights;
  for (int node = 0; node < s.owned_nodes(); ++node) {
    if (!(weight[node] > 0)) continue;
    weights.emplace_back(node, weight[node]);
    mine += weight[node];
  }
  const double all = total_over_ranks(*s.comm(), mine);
  for (auto& [node, share] : weights) share /= all;
  return weights;
}

std::size_t index_of(const Scene& scene, const std::string& support) {
  std::size_t k = 0;
  while (scene.supports[k].name != support) ++k;  // the check of the scene has found it
  return k;
}

Weights motion_of(const Scene& scene, const std::string& name, const ObservationParameters& p, const Model& model,
                  const std::vector<std::vector<HeldNode>>& held) {
  const auto& s = model.structure();
  if (p.place == Place::support) {
    std::vector<double> size(s.nodes(), 0.0);
    for (const auto& h : held[index_of(scene, p.support)]) size[h.node] = h.size;
    return mean_of(s, size);
  }
  return model.in_geometry([&](const auto& source, const auto& structure) {
    std::vector<char> observed(s.nodes(), 0);
    for (const auto& b : structure.blocks())
      if (in_set(source, b.mesh, p.blocks)) std::fill_n(observed.begin() + b.first_local, b.mesh.position.size(), 1);
    if (p.place != Place::mean)
      return node_near(p, scene.file + ": scene > observations > " + name, structure, observed);
    auto volume = s.nodal_volumes();
    for (std::size_t i = 0; i < volume.size(); ++i)
      if (!observed[i]) volume[i] = 0;
    return mean_of(s, volume);
  });
}

}  // namespace

Observations::Observations(const Scene& scene, const Model& model) : structure_(model.structure()) {
  if (scene.observations.empty()) return;
  const int dim = model.components();
  bool in_time = false;
  for (const auto& stage : scene.stages) in_time |= stage.dynamic();
  std::vector<std::vector<HeldNode>> held;
  if (std::any_of(scene.observations.begin(), scene.observations.end(),
                  [](const auto& o) { return o.parameters.place == Place::support; }))
    held = held_nodes(scene.supports, model);
  for (const auto& [name, p] : scene.observations) {
    const auto motion = motion_of(scene, name, p, model, held);
    const auto add = [&, name = name](Field field, const std::string& quantity, const auto& weight) {
      for (int c = 0; c < dim; ++c) {
        std::string column = quantity;
        column.insert(1, axis[c]);
        columns_.push_back(column + " of " + name);
        sums_.push_back({field, weight(c)});
      }
    };
    const auto of_motion = [&](int c) {
      std::vector<Weight> weights;
      for (const auto& [node, weight] : motion) weights.push_back({dim * node + c, weight});
      return weights;
    };
    add(Field::displacement, "u_m", of_motion);
    if (in_time) add(Field::velocity, "v_m_per_s", of_motion);
    if (p.place != Place::support) continue;
    ask_reactions_ = true;
    add(Field::reaction, "f_N", [&, support = index_of(scene, p.support)](int c) {
      std::vector<Weight> weights;
      for (const auto& h : held[support])
        for (int d = 0; d < dim; ++d)
          if (h.share[c][d] != 0) weights.push_back({dim * h.node + d, h.share[c][d]});
      return weights;
    });
  }
}

std::vector<double> Observations::values(const Observed& observed) const {
  if (columns_.empty()) return {};
  const int dim = structure_.components();
  const auto nodes = static_cast<std::size_t>(dim) * structure_.nodes();
  VOUSSOIR_EXPECT(observed.displacement.size() == nodes && "displacement: of node copies");
  VOUSSOIR_EXPECT((observed.velocity.empty() || observed.velocity.size() == nodes) &&
                  "velocity: of node copies, or none");
  VOUSSOIR_EXPECT((observed.reaction.empty() || observed.reaction.size() == nodes) &&
                  "reaction: of node copies, or none");
  VOUSSOIR_EXPECT(
      (observed.absent.empty() || observed.absent.size() == static_cast<std::size_t>(structure_.local_blocks())) &&
      "absent: per block, or none");
  const auto of = [&](Field f) -> const std::vector<double>& {
    return f == Field::displacement ? observed.displacement
           : f == Field::velocity   ? observed.velocity
                                    : observed.reaction;
  };
  const std::size_t columns = columns_.size();
  // Sums, their weights that are not there, and whether there is a field: those of a rank without nodes are all empty.
  std::vector<double> mine(3 * columns, 0.0);
  const auto gone = [&](int at) {
    return !observed.absent.empty() && observed.absent[structure_.block_of_node()[at / dim]];
  };
  for (std::size_t k = 0; k < columns; ++k) {
    const auto& field = of(sums_[k].field);
    if (field.empty()) continue;
    mine[2 * columns + k] = 1;
    for (const auto& [at, weight] : sums_[k].weights)
      (gone(at) ? mine[columns + k] : mine[k]) += gone(at) ? weight : weight * field[at];
  }
  auto all = total_of_list(*structure_.comm(), mine, WhyWhole{"numbers that a scene observes"});
  constexpr double round_off = 1e-9;  // of weights, which add up to 1
  for (std::size_t k = 0; k < columns; ++k) {
    const bool is_mean = sums_[k].field != Field::reaction;
    const double there = is_mean ? 1 - all[columns + k] : 1.0;
    const bool none = all[2 * columns + k] == 0 || there < round_off;
    if (none)
      all[k] = std::numeric_limits<double>::quiet_NaN();
    else if (there < 1)
      all[k] /= there;
  }
  all.resize(columns);
  return all;
}

}  // namespace voussoir

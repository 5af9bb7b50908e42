#include "step/release.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "base/components.hpp"
#include "linalg/reduce.hpp"
#include "selection/marking.hpp"

namespace voussoir {
namespace {

/// Brings the forces of selected points to the nearest admissible ones.
template <int dim>
void admit_in(const PointLaws& law, ContactState& state) {
  for (std::size_t k = 0; k < law.size(); ++k) {
    if (!state.selected[k]) continue;
    Vector<dim> f;
    std::copy_n(state.lambda.begin() + dim * k, dim, f.begin());
    f = nearest_lawful(law[k], f);
    std::copy_n(f.begin(), dim, state.lambda.begin() + dim * k);
  }
}

void admit(const Model& model, const PointLaws& law, ContactState& state) {
  with_components(model.components(), [&](auto dim) { admit_in<dim>(law, state); });
}

}  // namespace

long long release(const Model& model, const PointLaws& law, const std::vector<int>& cluster,
                  const std::vector<double>& eta, ContactState& state) {
  VOUSSOIR_EXPECT(eta.size() == static_cast<std::size_t>(model.points().owned()) && "decreases: per owned point");
  VOUSSOIR_EXPECT(cluster.size() == static_cast<std::size_t>(model.structure().nodes()) && "cluster: per node copy");
  VOUSSOIR_EXPECT(law.size() == state.selected.size() && "laws: per point");
  const auto& points = model.points();
  const auto& comm = *model.structure().comm();
  const auto& parameters = model.settings().selection;
  const double share = parameters.error_tolerance > 0 ? parameters.bulk : 1.0;
  const auto marked = mark_bulk(eta, share, comm);
  std::vector<double> flag(points.size(), 0.0);
  for (int k = 0; k < points.owned(); ++k) flag[k] = marked[k];
  points.exchange().update(flag, 1);
  // A marked point that is selected already is tied by others at its vertex: they must go.
  std::vector<char> vertex(model.structure().nodes(), 0), joint(points.joints().size(), 0);
  for (int k = 0; k < points.size(); ++k) {
    if (flag[k] == 0) continue;
    joint[points.points()[k].joint] = 1;
    const auto& p = points.points()[k];
    if (state.selected[k] && is_tied(p, cluster)) vertex[cluster_of_tied(p, cluster)] = 1;
  }
  long long released = 0;
  for (int k = 0; k < points.owned(); ++k) {
    const auto& p = points.points()[k];
    const bool chosen = flag[k] != 0 || (parameters.whole_joints && joint[p.joint]) ||
                        (is_tied(p, cluster) && vertex[cluster_of_tied(p, cluster)]);
    if (!chosen || state.selected[k]) continue;
    state.selected[k] = 1;
    ++released;
  }
  std::vector<double> selected(state.selected.begin(), state.selected.end());
  points.exchange().update(selected, 1);
  for (int k = 0; k < points.size(); ++k) state.selected[k] = selected[k] != 0;
  admit(model, law, state);
  return total_over_ranks(comm, released);
}

bool release_all(const Model& model, const PointLaws& law, ContactState& state) {
  const bool more = count_selected(model, state) < model.points().total();
  std::fill(state.selected.begin(), state.selected.end(), 1);
  admit(model, law, state);
  return more;
}

bool release_mortar(const Model& model, const PointLaws& law, ContactState& state) {
  if (model.softest_mortar() == JointLawParameters::infinity) return false;
  const auto before = count_selected(model, state);
  const auto& mortar = model.compliance();
  for (std::size_t k = 0; k < mortar.size(); ++k)
    if (mortar[k].normal > 0 || mortar[k].tangential > 0) state.selected[k] = 1;
  admit(model, law, state);
  return count_selected(model, state) > before;
}

long long release_blocks(const Model& model, const PointLaws& law, const std::vector<char>& marked,
                         ContactState& state) {
  VOUSSOIR_EXPECT(marked.size() == static_cast<std::size_t>(model.structure().local_blocks()) &&
                  "marked: per local block");
  const auto before = count_selected(model, state);
  std::vector<double> selected(state.selected.begin(), state.selected.end());
  for (int k = 0; k < model.points().owned(); ++k) {
    const auto& joint = model.points().joint_of(k);
    if (marked[joint.local_i] || marked[joint.local_j]) selected[k] = 1;
  }
  model.points().exchange().update(selected, 1);
  for (std::size_t k = 0; k < selected.size(); ++k) state.selected[k] = selected[k] != 0;
  admit(model, law, state);
  return count_selected(model, state) - before;
}

long long count_selected(const Model& model, const ContactState& state) {
  const auto owned = state.selected.begin() + model.points().owned();
  return total_over_ranks<long long>(*model.structure().comm(), std::count(state.selected.begin(), owned, 1));
}

}  // namespace voussoir

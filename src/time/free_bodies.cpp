#include "time/free_bodies.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <numeric>

#include "base/check.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"

namespace voussoir {
namespace {

constexpr int dim = 2;  // a body has one turn

/// Lowest number of a block of the same body, per block of the structure; -1 where a support holds the body.
/// Collective.
std::vector<int> bodies_of(const Model& model, const std::vector<char>& selected) {
  const auto& s = model.structure();
  const auto& graph = model.graph();
  const auto blocks = s.owner_of_block().size();
  const auto id_of = [&](int node) { return s.nodes_of(s.block_of_node()[node]).id; };
  std::vector<int> mine(graph.neighbour.size() + blocks, 0), all(mine.size());  // tied pairs, held blocks
  for (int k = 0; k < model.points().owned(); ++k) {
    if (selected[k]) continue;
    const BlockId i = model.points().joint_of(k).block_i, j = model.points().joint_of(k).block_j;
    for (int e = graph.start[i]; e < graph.start[i + 1]; ++e)
      if (graph.neighbour[e] == j) mine[e] = 1;
  }
  for (std::size_t i = 0; i < model.held().size(); ++i)
    if (model.held()[i]) mine[graph.neighbour.size() + id_of(static_cast<int>(i) / dim)] = 1;
  all = largest_of_each(*s.comm(), mine);
  std::vector<int> body(blocks);
  std::iota(body.begin(), body.end(), 0);
  const auto first_of = [&](int b) {
    while (body[b] != b) b = body[b] = body[body[b]];
    return b;
  };
  for (std::size_t b = 0; b < blocks; ++b)
    for (int e = graph.start[b]; e < graph.start[b + 1]; ++e) {
      if (!all[e]) continue;
      const int i = first_of(static_cast<int>(b)), j = first_of(graph.neighbour[e]);
      body[std::max(i, j)] = std::min(i, j);
    }
  std::vector<char> held(blocks, 0);
  for (std::size_t b = 0; b < blocks; ++b)
    if (all[graph.neighbour.size() + b]) held[first_of(static_cast<int>(b))] = 1;
  std::vector<int> free(blocks);
  for (std::size_t b = 0; b < blocks; ++b)
    free[b] = held[first_of(static_cast<int>(b))] ? -1 : first_of(static_cast<int>(b));
  return free;
}

}  // namespace

FreeBodies::FreeBodies(const Model& model, const BlockSystem& mass, const std::vector<char>& selected)
    : mass_(mass), turn_(static_cast<std::size_t>(dim) * mass.nodes(), 0.0) {
  VOUSSOIR_EXPECT(model.components() == dim && "bodies of the plane");
  VOUSSOIR_EXPECT(is_per_point(model, selected) && "selected: per point");
  VOUSSOIR_EXPECT(mass.nodes() == model.structure().nodes() && "mass: of the structure at rest");
  const auto first = bodies_of(model, selected);
  std::vector<int> number(first.size(), -1);  // of bodies that begin with a block
  int count = 0;
  for (std::size_t b = 0; b < first.size(); ++b)
    if (first[b] == static_cast<int>(b)) number[b] = count++;
  for (int b = 0; b < mass.local_blocks(); ++b) {
    const int body = first[mass.nodes_of(b).id];
    body_.push_back(body < 0 ? -1 : number[body]);
  }

  const auto& of_node = mass.block_of_node();
  std::vector<double> along(turn_.size(), 0.0), weight;
  for (std::size_t i = 0; i < along.size(); i += dim) along[i] = 1;
  mass.apply_stiffness(along, weight);
  std::vector<double> sums(3 * count, 0.0);  // mass and its moments
  for (int n = 0; n < mass.owned_nodes(); ++n) {
    const int b = body_[of_node[n]];
    if (b < 0) continue;
    const auto arm = model.structure().place(n) - model.structure().centre();
    sums[3 * b] += weight[dim * n];
    for (int c = 0; c < 2; ++c) sums[3 * b + 1 + c] += weight[dim * n] * arm[c];
  }
  sums = total_of_each(*mass.comm(), sums);
  for (int n = 0; n < mass.nodes(); ++n) {
    const int b = body_[of_node[n]];
    if (b < 0) continue;
    const auto arm = model.structure().place(n) - model.structure().centre();
    turn_[dim * n] = -(arm[1] - sums[3 * b + 2] / sums[3 * b]);
    turn_[dim * n + 1] = arm[0] - sums[3 * b + 1] / sums[3 * b];
  }
  mass.apply_stiffness(turn_, weight);
  inertia_.assign(count, 0.0);
  for (int i = 0; i < dim * mass.owned_nodes(); ++i)
    if (const int b = body_[of_node[i / dim]]; b >= 0) inertia_[b] += turn_[i] * weight[i];
  inertia_ = total_of_each(*mass.comm(), inertia_);
  for (int b = 0; b < count; ++b) weight_.push_back(sums[3 * b]);
}

Vector<3> FreeBodies::remove_motion(std::vector<double>& velocity) const {
  VOUSSOIR_EXPECT(velocity.size() == turn_.size() && "velocity: of node copies");
  const auto& of_node = mass_.block_of_node();
  std::vector<double> momentum;
  mass_.apply_stiffness(velocity, momentum);
  std::vector<double> sums(3 * weight_.size(), 0.0);  // momentum, and its moment about the mass centre
  for (int i = 0; i < dim * mass_.owned_nodes(); ++i) {
    const int b = body_[of_node[i / dim]];
    if (b < 0) continue;
    sums[3 * b + i % dim] += momentum[i];
    sums[3 * b + 2] += turn_[i] * momentum[i];
  }
  sums = total_of_each(*mass_.comm(), sums);
  for (int i = 0; i < dim * mass_.nodes(); ++i)
    if (const int b = body_[of_node[i / dim]]; b >= 0)
      velocity[i] -= sums[3 * b + i % dim] / weight_[b] + sums[3 * b + 2] / inertia_[b] * turn_[i];
  Vector<3> all{};
  for (std::size_t b = 0; b < weight_.size(); ++b)
    for (int c = 0; c < dim; ++c) all[c] += sums[3 * b + c];
  return all;
}

}  // namespace voussoir

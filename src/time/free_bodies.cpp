#include "time/free_bodies.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <numeric>

#include "base/check.hpp"
#include "linalg/gather.hpp"
#include "model/handed_over.hpp"

namespace voussoir {
namespace {

constexpr WhyWhole of_bodies{"sums of bodies that nothing holds"};

/// Lowest number of a block of the same body, per block of the structure; -1 where a support holds the body.
/// Collective.
std::vector<int> bodies_of(const Model& model, const std::vector<char>& selected) {
  const auto& s = model.structure();
  const int dim = s.components();
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
  all = largest_of_list(*s.comm(), mine, WhyWhole{"two numbers per pair of neighbours and block"});
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
    : mass_(mass), turns_(mass.components() == 2 ? 1 : 3) {
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
  find_turns(model, count);
  find_inertia(count);
}

/// Weights of bodies, and how nodes move when they turn about their mass centres. Collective.
void FreeBodies::find_turns(const Model& model, int count) {
  const int dim = mass_.components();
  const auto& of_node = mass_.block_of_node();
  std::vector<double> along(static_cast<std::size_t>(dim) * mass_.nodes(), 0.0), weight;
  for (std::size_t i = 0; i < along.size(); i += dim) along[i] = 1;
  mass_.apply_stiffness(along, weight);
  std::vector<double> sums(4 * count, 0.0);  // mass and its moments
  const auto arm_of = [&](int n) { return model.structure().place(n) - model.structure().centre(); };
  for (int n = 0; n < mass_.owned_nodes(); ++n) {
    const int b = body_[of_node[n]];
    if (b < 0) continue;
    const auto arm = arm_of(n);
    sums[4 * b] += weight[dim * n];
    for (int c = 0; c < dim; ++c) sums[4 * b + 1 + c] += weight[dim * n] * arm[c];
  }
  sums = total_of_list(*mass_.comm(), sums, of_bodies);
  for (int b = 0; b < count; ++b) weight_.push_back(sums[4 * b]);
  turn_.assign(turns_, std::vector<double>(along.size(), 0.0));
  for (int n = 0; n < mass_.nodes(); ++n) {
    const int b = body_[of_node[n]];
    if (b < 0) continue;
    auto arm = arm_of(n);
    for (int c = 0; c < dim; ++c) arm[c] -= sums[4 * b + 1 + c] / sums[4 * b];
    for (int r = 0; r < turns_; ++r) {
      Vector<3> axis{};
      axis[turns_ == 1 ? 2 : r] = 1;
      const auto velocity = cross(axis, arm);
      for (int c = 0; c < dim; ++c) turn_[r][dim * n + c] = velocity[c];
    }
  }
}

/// Of bodies against turns about their mass centres. Collective.
void FreeBodies::find_inertia(int count) {
  const int dim = mass_.components();
  std::vector<double> sums(9 * count, 0.0), momentum;
  for (int r = 0; r < turns_; ++r) {
    mass_.apply_stiffness(turn_[r], momentum);
    for (int i = 0; i < dim * mass_.owned_nodes(); ++i)
      if (const int b = body_[mass_.block_of_node()[i / dim]]; b >= 0)
        for (int q = 0; q < turns_; ++q) sums[9 * b + 3 * q + r] += turn_[q][i] * momentum[i];
  }
  sums = total_of_list(*mass_.comm(), sums, of_bodies);
  inertia_.resize(count);
  for (std::size_t k = 0; k < sums.size(); ++k) inertia_[k / 9][k % 9 / 3][k % 3] = sums[k];
}

/// Turns of a body [1/s] that has a moment of momentum.
Vector<3> FreeBodies::turns_of(int body, const Vector<3>& moment) const {
  const auto& inertia = inertia_[body];
  if (turns_ == 1) return {moment[0] / inertia[0][0], 0, 0};
  return solve_positive(inertia, moment);
}

Vector<3> FreeBodies::remove_motion(std::vector<double>& velocity) const {
  const int dim = mass_.components();
  VOUSSOIR_EXPECT(velocity.size() == static_cast<std::size_t>(dim) * mass_.nodes() && "velocity: of node copies");
  const auto& of_node = mass_.block_of_node();
  std::vector<double> momentum;
  mass_.apply_stiffness(velocity, momentum);
  std::vector<double> sums(6 * weight_.size(), 0.0);  // momentum, and its moment about the mass centre
  for (int i = 0; i < dim * mass_.owned_nodes(); ++i) {
    const int b = body_[of_node[i / dim]];
    if (b < 0) continue;
    sums[6 * b + i % dim] += momentum[i];
    for (int r = 0; r < turns_; ++r) sums[6 * b + 3 + r] += turn_[r][i] * momentum[i];
  }
  sums = total_of_list(*mass_.comm(), sums, of_bodies);
  std::vector<Vector<3>> turns;
  for (std::size_t b = 0; b < weight_.size(); ++b)
    turns.push_back(turns_of(static_cast<int>(b), {sums[6 * b + 3], sums[6 * b + 4], sums[6 * b + 5]}));
  for (int i = 0; i < dim * mass_.nodes(); ++i)
    if (const int b = body_[of_node[i / dim]]; b >= 0) {
      double moved = sums[6 * b + i % dim] / weight_[b];
      for (int r = 0; r < turns_; ++r) moved += turns[b][r] * turn_[r][i];
      velocity[i] -= moved;
    }
  Vector<3> all{};
  for (std::size_t b = 0; b < weight_.size(); ++b)
    for (int c = 0; c < dim; ++c) all[c] += sums[6 * b + c];
  return all;
}

}  // namespace voussoir

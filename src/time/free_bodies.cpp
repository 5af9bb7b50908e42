#include "time/free_bodies.hpp"

#include <algorithm>
#include <map>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "linalg/groups.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"

namespace voussoir {
namespace {

/// Blocks of this rank that something ties, each pair with its joint.
std::vector<HangsWith> tied_pairs(const Model& model, const std::vector<char>& selected) {
  const auto& s = model.structure();
  std::vector<HangsWith> pairs;
  int last = -1;  // joint that is told of: points of a joint follow each other
  for (int k = 0; k < model.points().size(); ++k) {
    if (selected[k] || model.points().points()[k].joint == last) continue;
    last = model.points().points()[k].joint;
    const auto& joint = model.points().joints()[last];
    if (joint.local_i < s.owned_blocks()) pairs.push_back({joint.block_i, joint.block_j, s.owner_of(joint.local_j)});
    if (joint.local_j < s.owned_blocks()) pairs.push_back({joint.block_j, joint.block_i, s.owner_of(joint.local_i)});
  }
  return pairs;
}

/// Lowest number of a block of the same body, per local block; -1 where a support holds the body. Collective.
std::vector<long long> bodies_of(const Model& model, const std::vector<char>& selected) {
  const auto& s = model.structure();
  std::vector<long long> mine;
  for (int b = 0; b < s.owned_blocks(); ++b) mine.push_back(s.nodes_of(b).id);
  const auto least = least_of_group(mine, tied_pairs(model, selected), *s.comm());
  std::map<long long, std::array<double, 1>> holds;
  for (const auto body : least) holds[body] = {0};
  const auto held_here = model.components() * static_cast<std::size_t>(s.owned_nodes());
  for (std::size_t i = 0; i < held_here; ++i)
    if (model.held()[i]) holds[least[s.block_of_node()[i / model.components()]]] = {1};
  holds = totals_by_key(holds, *s.comm());
  std::vector<long long> of_node(s.nodes(), -1), body;
  for (int n = 0; n < s.owned_nodes(); ++n)
    if (const auto first = least[s.block_of_node()[n]]; !(holds.at(first)[0] > 0)) of_node[n] = first;
  s.node_exchange().update(of_node);
  for (int b = 0; b < s.local_blocks(); ++b) body.push_back(of_node[s.nodes_of(b).first_local]);
  return body;
}

}  // namespace

FreeBodies::FreeBodies(const Model& model, const BlockSystem& mass, const std::vector<char>& selected)
    : mass_(mass), turns_(mass.components() == 2 ? 1 : 3) {
  VOUSSOIR_EXPECT(is_per_point(model, selected) && "selected: per point");
  VOUSSOIR_EXPECT(mass.nodes() == model.structure().nodes() && "mass: of the structure at rest");
  const auto first = bodies_of(model, selected);
  first_block_.assign(first.begin(), first.end());
  sort_unique(first_block_);
  if (!first_block_.empty() && first_block_.front() < 0) first_block_.erase(first_block_.begin());
  for (const auto block : first)
    body_.push_back(block < 0 ? -1
                              : static_cast<int>(std::lower_bound(first_block_.begin(), first_block_.end(), block) -
                                                 first_block_.begin()));
  find_turns(model);
  find_inertia();
}

/// Of all ranks, for the bodies that this rank has a part of. Collective.
template <std::size_t n>
std::vector<std::array<double, n>> FreeBodies::totals(const std::vector<std::array<double, n>>& mine) const {
  std::map<long long, std::array<double, n>> sums;
  for (std::size_t b = 0; b < mine.size(); ++b) sums[first_block_[b]] = mine[b];
  std::vector<std::array<double, n>> all;
  for (const auto& [first, total] : totals_by_key(sums, *mass_.comm())) all.push_back(total);
  return all;
}

/// Weights of bodies, and how nodes move when they turn about their mass centres. Collective.
void FreeBodies::find_turns(const Model& model) {
  const int dim = mass_.components();
  const auto& of_node = mass_.block_of_node();
  std::vector<double> along(static_cast<std::size_t>(dim) * mass_.nodes(), 0.0), weight;
  for (std::size_t i = 0; i < along.size(); i += dim) along[i] = 1;
  mass_.apply_stiffness(along, weight);
  std::vector<std::array<double, 4>> sums(first_block_.size(), std::array<double, 4>{});  // mass and its moments
  const auto arm_of = [&](int n) { return model.structure().place(n) - model.structure().centre(); };
  for (int n = 0; n < mass_.owned_nodes(); ++n) {
    const int b = body_[of_node[n]];
    if (b < 0) continue;
    const auto arm = arm_of(n);
    sums[b][0] += weight[dim * n];
    for (int c = 0; c < dim; ++c) sums[b][1 + c] += weight[dim * n] * arm[c];
  }
  sums = totals(sums);
  for (const auto& sum : sums) weight_.push_back(sum[0]);
  turn_.assign(turns_, std::vector<double>(along.size(), 0.0));
  for (int n = 0; n < mass_.nodes(); ++n) {
    const int b = body_[of_node[n]];
    if (b < 0) continue;
    auto arm = arm_of(n);
    for (int c = 0; c < dim; ++c) arm[c] -= sums[b][1 + c] / sums[b][0];
    for (int r = 0; r < turns_; ++r) {
      Vector<3> axis{};
      axis[turns_ == 1 ? 2 : r] = 1;
      const auto velocity = cross(axis, arm);
      for (int c = 0; c < dim; ++c) turn_[r][dim * n + c] = velocity[c];
    }
  }
}

/// Of bodies against turns about their mass centres. Collective.
void FreeBodies::find_inertia() {
  const int dim = mass_.components();
  std::vector<std::array<double, 9>> sums(first_block_.size(), std::array<double, 9>{});
  std::vector<double> momentum;
  for (int r = 0; r < turns_; ++r) {
    mass_.apply_stiffness(turn_[r], momentum);
    for (int i = 0; i < dim * mass_.owned_nodes(); ++i)
      if (const int b = body_[mass_.block_of_node()[i / dim]]; b >= 0)
        for (int q = 0; q < turns_; ++q) sums[b][3 * q + r] += turn_[q][i] * momentum[i];
  }
  sums = totals(sums);
  inertia_.resize(sums.size());
  for (std::size_t b = 0; b < sums.size(); ++b)
    for (std::size_t k = 0; k < 9; ++k) inertia_[b][k / 3][k % 3] = sums[b][k];
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
  std::vector<std::array<double, 6>> sums(weight_.size(), std::array<double, 6>{});  // and moments about mass centres
  Vector<3> together{};
  for (int i = 0; i < dim * mass_.owned_nodes(); ++i) {
    const int b = body_[of_node[i / dim]];
    if (b < 0) continue;
    sums[b][i % dim] += momentum[i];
    together[i % dim] += momentum[i];
    for (int r = 0; r < turns_; ++r) sums[b][3 + r] += turn_[r][i] * momentum[i];
  }
  sums = totals(sums);
  std::vector<Vector<3>> turns;
  for (std::size_t b = 0; b < weight_.size(); ++b)
    turns.push_back(turns_of(static_cast<int>(b), {sums[b][3], sums[b][4], sums[b][5]}));
  for (int i = 0; i < dim * mass_.nodes(); ++i)
    if (const int b = body_[of_node[i / dim]]; b >= 0) {
      double moved = sums[b][i % dim] / weight_[b];
      for (int r = 0; r < turns_; ++r) moved += turns[b][r] * turn_[r][i];
      velocity[i] -= moved;
    }
  return total_of_each(*mass_.comm(), together);
}

}  // namespace voussoir

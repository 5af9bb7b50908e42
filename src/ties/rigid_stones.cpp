#include "ties/rigid_stones.hpp"

#include <limits>

#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {

double stiffness_of_springs(const Model& model) {
  double softest = std::numeric_limits<double>::max();
  for (int k = 0; k < model.points().size(); ++k) {
    const double sigma = model.local_stiffness()[k];
    softest = std::min(softest, sigma);
    if (model.compliance().empty()) continue;
    for (int c = 0; c < model.components(); ++c)
      softest = std::min(softest, sigma / (1 + sigma * model.compliance()[k].along(c)));
  }
  return -largest_over_ranks(*model.structure().comm(), -softest);
}

std::vector<char> absent_here(const Model& model) {
  const auto& s = model.structure();
  const auto& gap = model.initial_gap();
  const auto is_far = [&](double g) { return g >= s.size(); };
  if (std::none_of(gap.begin(), gap.end(), is_far)) return {};
  std::vector<int> near(s.local_blocks(), 0), far(s.local_blocks(), 0);
  for (int k = 0; k < model.points().size(); ++k) {
    const auto& joint = model.points().joint_of(k);
    auto& count = is_far(gap[k]) ? far : near;
    ++count[joint.local_i];
    ++count[joint.local_j];
  }
  std::vector<char> absent(s.owned_blocks());
  for (int b = 0; b < s.owned_blocks(); ++b) absent[b] = far[b] > 0 && near[b] == 0;
  return absent;
}

DependentStones dependent_stones(const Model& model, const std::vector<char>& absent) {
  const auto& s = model.structure();
  const int dim = model.components();
  std::vector<double> there(s.nodes(), 1.0);  // of their blocks
  for (int n = 0; n < s.owned_nodes(); ++n)
    if (!absent.empty() && absent[s.block_of_node()[n]]) there[n] = 0;
  s.node_exchange().update(there, 1);
  const auto is_there = [&](int block) { return there[s.nodes_of(block).first_local] > 0; };
  std::vector<char> supported(s.owned_blocks(), 0);
  for (std::size_t i = 0; i < dim * static_cast<std::size_t>(s.owned_nodes()); ++i)
    if (model.held()[i]) supported[s.block_of_node()[i / dim]] = 1;
  std::vector<BlockId> stones;
  std::vector<HoldEachOther> pairs, across;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!is_there(b)) continue;
    const BlockId id = s.nodes_of(b).id;
    stones.push_back(id);
    if (supported[b]) pairs.push_back({the_ground, id});
    for (const auto& [other, shared] : model.neighbours(id)) {
      const int local = s.local_block(other);
      if (shared < dim || !is_there(local)) continue;  // those that share no facet hold nothing of each other
      (local < s.owned_blocks() ? pairs : across).push_back({id, other});
    }
  }
  const OwnStones own(std::move(stones), pairs, across);
  const HeldStones known(all_gather(own.at_borders(), *s.comm(),
                                    WhyWhole{"stones at the borders of ranks, and what holds them together"}));
  return DependentStones(all_gather(own.dependences(known), *s.comm(), WhyWhole{"stones that hang on one other"}));
}

}  // namespace voussoir

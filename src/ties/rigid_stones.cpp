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
  const auto blocks = static_cast<long>(s.owner_of_block().size());
  std::vector<int> mine(2 * blocks, 0);  // is a block held, is it absent
  const int dim = model.components();
  for (std::size_t i = 0; i < model.held().size(); ++i)
    if (model.held()[i]) mine[s.nodes_of(s.block_of_node()[i / dim]).id] = 1;
  for (std::size_t b = 0; b < absent.size(); ++b) mine[blocks + s.nodes_of(static_cast<int>(b)).id] = absent[b];
  const auto all = largest_of_list(*s.comm(), mine, WhyWhole{"two marks per block"});
  return {model.graph(), {all.begin(), all.begin() + blocks}, {all.begin() + blocks, all.end()}, dim};
}

}  // namespace voussoir

#include "results/shares_of_ranks.hpp"

#include <algorithm>
#include <set>

#include "linalg/gather.hpp"

namespace voussoir {

PartitionQuality partition_quality(const Model& model) {
  const auto& structure = model.structure();
  const int me = structure.comm()->getRank();
  RankShare mine;
  std::set<int> beside;
  for (int b = 0; b < structure.owned_blocks(); ++b) {
    const auto& block = structure.nodes_of(b);
    mine.work += structure.components() * block.nodes;
    for (const auto& [other, shared] : model.neighbours(block.id)) {
      const int owner = structure.owner_of(structure.local_block(other));
      mine.vertices += shared;
      if (owner == me) continue;
      mine.cut += shared;
      beside.insert(owner);
    }
  }
  mine.neighbours = static_cast<int>(beside.size());
  return partition_quality(
      all_gather(std::vector<RankShare>{mine}, *structure.comm(), WhyWhole{"four numbers of each rank"}));
}

double imbalance_of_selected(const Model& model, const ContactState& state) {
  const auto mine = std::count(state.selected.begin(), state.selected.begin() + model.points().owned(), 1);
  return imbalance(*model.structure().comm(), mine);
}

}  // namespace voussoir

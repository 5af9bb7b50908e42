#include "results/shares_of_ranks.hpp"

#include <algorithm>

#include "linalg/gather.hpp"

namespace voussoir {

PartitionQuality partition_quality(const Model& model) {
  const auto& structure = model.structure();
  std::vector<double> work(structure.owner_of_block().size(), 0.0);
  for (int b = 0; b < structure.owned_blocks(); ++b) {
    const auto& block = structure.nodes_of(b);
    work[block.id] = structure.components() * block.nodes;
  }
  return partition_quality(model.graph(), structure.owner_of_block(),
                           total_of_list(*structure.comm(), work, WhyWhole{"a number per block, told once of a run"}),
                           structure.comm()->getSize());
}

double imbalance_of_selected(const Model& model, const ContactState& state) {
  const auto mine = std::count(state.selected.begin(), state.selected.begin() + model.points().owned(), 1);
  return imbalance(*model.structure().comm(), mine);
}

}  // namespace voussoir

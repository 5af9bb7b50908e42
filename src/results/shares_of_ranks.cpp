#include "results/shares_of_ranks.hpp"

#include "model/plane/plane_model.hpp"

#include <algorithm>

namespace voussoir {

PartitionQuality partition_quality(const PlaneModel& model) {
  const auto& source = model.source();
  std::vector<double> work;
  for (BlockId b = 0; b < source.block_count(); ++b) work.push_back(2 * source.node_count(b));
  const auto& structure = model.structure();
  return partition_quality(source.graph(), structure.owner_of_block(), work, structure.comm()->getSize());
}

double imbalance_of_selected(const PlaneModel& model, const ContactState& state) {
  const auto mine = std::count(state.selected.begin(), state.selected.begin() + model.points().owned(), 1);
  return imbalance(*model.structure().comm(), mine);
}

}  // namespace voussoir

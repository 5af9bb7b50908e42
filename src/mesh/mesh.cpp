// Numbering that every source of blocks shares.
#include "mesh/mesh.hpp"

namespace voussoir {

template <int dim>
std::vector<NodeId> first_nodes(const BlockSource<dim>& source) {
  const BlockId blocks = source.block_count();
  std::vector<NodeId> first(static_cast<std::size_t>(blocks) + 1, 0);
  for (BlockId b = 0; b < blocks; ++b) first[b + 1] = first[b] + source.node_count(b);
  return first;
}

template std::vector<NodeId> first_nodes(const BlockSource<2>&);
template std::vector<NodeId> first_nodes(const BlockSource<3>&);

}  // namespace voussoir

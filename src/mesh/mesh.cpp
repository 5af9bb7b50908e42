#include "mesh/mesh.hpp"

#include <utility>

#include "base/sort_unique.hpp"
#include "linalg/parcels.hpp"
#include "mesh/bytes.hpp"

namespace voussoir {

template <int dim>
BlockGraph graph_of(const BlockSource<dim>& source, BlockSpan span) {
  BlockGraph graph;
  graph.start.push_back(0);
  for (BlockId b = span.from; b < span.to; ++b) {
    for (const auto& [other, shared] : source.neighbours(b)) {
      graph.neighbour.push_back(other);
      graph.shared_vertices.push_back(shared);
    }
    graph.start.push_back(static_cast<int>(graph.neighbour.size()));
  }
  return graph;
}

template <int dim>
void bring_neighbours(const BlockSource<dim>& source, BlockSpan span, const Teuchos::Comm<int>& comm) {
  std::vector<BlockId> beside;
  for (BlockId b = span.from; b < span.to; ++b)
    for (const auto& neighbour : source.neighbours(b)) beside.push_back(neighbour.block);
  sort_unique(beside);
  source.bring(beside, comm);
}

template <int dim>
std::vector<std::string> names_of_block_sets(const BlockSource<dim>& source, const Teuchos::Comm<int>& comm) {
  const auto& known = source.block_sets();
  ByteWriter writer;
  if (comm.getRank() == 0 || !known.are_all())
    for (const auto& [number, name] : known) {
      writer.plain(number);
      plain_list(writer, name);
    }
  std::vector<std::string> names;
  for (const auto& parcel : exchange_parcels<char>({{0, {writer.bytes.begin(), writer.bytes.end()}}}, comm)) {
    const std::string bytes(parcel.items.begin(), parcel.items.end());
    for (ByteReader reader(bytes); reader.left() > 0;) {
      int number = 0;
      std::string name;
      reader.plain(number);
      plain_list(reader, name);
      if (number >= static_cast<int>(names.size())) names.resize(static_cast<std::size_t>(number) + 1);
      names[number] = std::move(name);
    }
  }
  return names;
}

template BlockGraph graph_of(const BlockSource<2>&, BlockSpan);
template BlockGraph graph_of(const BlockSource<3>&, BlockSpan);
template std::vector<std::string> names_of_block_sets(const BlockSource<2>&, const Teuchos::Comm<int>&);
template std::vector<std::string> names_of_block_sets(const BlockSource<3>&, const Teuchos::Comm<int>&);
template void bring_neighbours(const BlockSource<2>&, BlockSpan, const Teuchos::Comm<int>&);
template void bring_neighbours(const BlockSource<3>&, BlockSpan, const Teuchos::Comm<int>&);

}  // namespace voussoir

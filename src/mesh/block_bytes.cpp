#include "mesh/block_bytes.hpp"

#include "mesh/bytes.hpp"

namespace voussoir {
namespace {

/// @param one  const when it is written
template <class Bytes, class BlockAndMore>
void exchange(Bytes& bytes, BlockAndMore& one) {
  auto& block = one.block;
  bytes.plain(block.id);
  plain_list(bytes, block.name);
  plain_list(bytes, block.position);
  plain_list(bytes, block.vertex);
  plain_list(bytes, block.cells);
  plain_list(bytes, block.curved);
  plain_list(bytes, block.folds);
  plain_list(bytes, block.facets);
  plain_list(bytes, block.sets);
  const std::size_t names = bytes.size(one.set_names, sizeof(std::size_t));
  for (std::size_t k = 0; k < names; ++k) plain_list(bytes, one.set_names[k]);
  plain_list(bytes, one.neighbours);
}

template <class Bytes, class List>
void exchange_all(Bytes& bytes, List& list) {
  const std::size_t count = bytes.size(list, sizeof list[0].block.id);
  for (std::size_t k = 0; k < count; ++k) exchange(bytes, list[k]);
}

}  // namespace

template <int dim>
std::string bytes_of(const std::vector<BlockToSend<dim>>& blocks) {
  ByteWriter writer;
  exchange_all(writer, blocks);
  return writer.bytes;
}

template <int dim>
std::vector<BlockToSend<dim>> blocks_of_bytes(const std::string& bytes) {
  std::vector<BlockToSend<dim>> blocks;
  ByteReader reader(bytes);
  exchange_all(reader, blocks);
  return blocks;
}

template std::string bytes_of(const std::vector<BlockToSend<2>>&);
template std::string bytes_of(const std::vector<BlockToSend<3>>&);
template std::vector<BlockToSend<2>> blocks_of_bytes(const std::string&);
template std::vector<BlockToSend<3>> blocks_of_bytes(const std::string&);

}  // namespace voussoir

// Blocks of files: every rank is the reader of a span of them, and has no others but those it is brought.
#pragma once

#include <Teuchos_Comm.hpp>
#include <functional>
#include <memory>
#include <string>

#include "mesh/block_list.hpp"

namespace voussoir {

/// A source of blocks of which each rank has those that it reads by number (BlockSource::read_by). Who shares vertices
/// with whom is found by all ranks together, each for some of the vertices; edges that bend are found by readers, who
/// are brought what touches their spans. Collective.
/// @param of_span  blocks of the span of this rank with their ids, ascending, and the names of their sets of blocks;
///                 other names and words the same on every rank
template <int dim>
std::unique_ptr<BlockSource<dim>> make_source_of_readers(BlockList<dim> of_span, const Teuchos::Comm<int>&);

/// Hands the blocks of the first rank out to their readers, reader by reader, with the names of their sets; words and
/// warnings go to all. Collective.
/// @param of_first  all blocks; of the other ranks nothing is taken
/// @return  as the function above takes it
template <int dim>
BlockList<dim> handed_out(BlockList<dim> of_first, const Teuchos::Comm<int>&);

/// What the first rank has for this one. Parts go reader by reader, so that no more than one of them is there twice.
/// Collective.
/// @param part  asked of the first rank, for each in turn
std::string part_of_first(const Teuchos::Comm<int>&, const std::function<std::string(int reader)>& part);

/// Words, warnings and names of sets of facets of the first rank, on every rank, without blocks. Collective.
/// @param of_first  of the other ranks nothing is taken
template <int dim>
BlockList<dim> without_blocks(const BlockList<dim>& of_first, const Teuchos::Comm<int>&);

}  // namespace voussoir

// Blocks from a file of stones, on every rank.
#pragma once

#include <Teuchos_Comm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "stones/stones_parameters.hpp"

namespace voussoir {

struct StoneBlocks {
  std::unique_ptr<BlockSource<3>> source;
  std::vector<std::string> report;  ///< what was found, made and mended, line by line
};

/// Reads the file, finds joints and meshes the stones on rank 0, and gives the blocks to every rank. Collective; throws
/// InputError on every rank alike.
StoneBlocks read_stone_blocks(const StonesParameters&, const Teuchos::Comm<int>&);

}  // namespace voussoir

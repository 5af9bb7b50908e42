// Rigid ground under an arch that the generator builds without piers, so that its springings can open and slide too.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "mesh/block_list.hpp"
#include "mesh/mesh.hpp"

namespace voussoir::test {

/// The blocks of a source, and behind every facet set called "springing ..." a block one cell deep whose far side is
/// the facet set "ground". The springings become joints.
inline std::unique_ptr<BlockSource<2>> on_abutments(const BlockSource<2>& arch, double depth) {
  BlockList<2> list;
  list.block_sets = arch.block_sets();
  list.facet_sets = arch.facet_sets();
  const int ground = static_cast<int>(list.facet_sets.size());
  list.facet_sets.push_back("ground");
  VertexId next = 0;
  for (BlockId b = 0; b < arch.block_count(); ++b) {
    list.blocks.push_back(arch.block(b));
    for (VertexId v : list.blocks.back().vertex) next = std::max(next, v + 1);
  }
  for (int set = 0; set < ground; ++set) {
    if (list.facet_sets[set].rfind("springing", 0) != 0) continue;
    Block<2> abutment;
    abutment.id = static_cast<BlockId>(list.blocks.size());
    abutment.name = "abutment of " + list.facet_sets[set];
    std::map<VertexId, std::pair<int, int>> nodes;  // at the springing, at the ground
    for (const auto& voussoir : std::vector<Block<2>>(list.blocks))
      for (const auto& facet : voussoir.facets) {
        if (facet.set != set) continue;
        const auto along = voussoir.position[facet.node[1]] - voussoir.position[facet.node[0]];
        const Vector<2> outward = (depth / norm(along)) * Vector<2>{along[1], -along[0]};
        int corner[4];
        for (int end = 0; end < 2; ++end) {
          const int node = facet.node[end];
          const auto [it, is_new] = nodes.try_emplace(voussoir.vertex[node]);
          if (is_new) {
            it->second = {static_cast<int>(abutment.vertex.size()), static_cast<int>(abutment.vertex.size()) + 1};
            abutment.position.push_back(voussoir.position[node]);
            abutment.position.push_back(voussoir.position[node] + outward);
            abutment.vertex.push_back(voussoir.vertex[node]);
            abutment.vertex.push_back(next++);
          }
          corner[end] = it->second.first;
          corner[3 - end] = it->second.second;
        }
        abutment.cells.push_back({{corner[1], corner[0], corner[3], corner[2]}, 4});
        abutment.facets.push_back({{corner[3], corner[2]}, 2, ground});
      }
    list.blocks.push_back(std::move(abutment));
  }
  return make_source(std::move(list));
}

}  // namespace voussoir::test

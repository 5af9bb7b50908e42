#include "mesh/mesh_check.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/words.hpp"
#include "linalg/agree.hpp"

namespace voussoir {
namespace {

/// Number of the group each block belongs to: the smallest block reached from it over joints.
template <int dim>
std::vector<BlockId> groups_of_joined_blocks(const BlockGraph& graph) {
  std::vector<BlockId> group(graph.start.size() - 1, -1);
  std::vector<BlockId> to_visit;
  for (BlockId seed = 0; seed < static_cast<BlockId>(group.size()); ++seed) {
    if (group[seed] >= 0) continue;
    group[seed] = seed;
    to_visit.push_back(seed);
    while (!to_visit.empty()) {
      const BlockId b = to_visit.back();
      to_visit.pop_back();
      for (int k = graph.start[b]; k < graph.start[b + 1]; ++k) {
        const BlockId other = graph.neighbour[k];
        if (graph.shared_vertices[k] < dim || group[other] >= 0) continue;
        group[other] = seed;
        to_visit.push_back(other);
      }
    }
  }
  return group;
}

/// The first of a group of blocks that nothing holds.
InputError without_support(const std::string& name, int blocks, bool meets_in_a_point, const std::string& facet,
                           const std::vector<FacetNames>& supported) {
  std::string message = "mesh: " + name;
  if (blocks > 1)
    message += " and " + counted(blocks - 1, "more block") + " joined to it have no support";
  else
    message += " has neither support nor joint";
  message += "\n  (nothing holds ";
  message += blocks > 1 ? "them" : meets_in_a_point ? "it; it touches other blocks in single points only" : "it";
  message += ", so there is no equilibrium).\n  Add one of its " + facet + "s to a supported set (now: ";
  for (std::size_t k = 0; k < supported.size(); ++k) message += (k == 0 ? "" : ", ") + supported[k].on;
  return InputError(message + "), or let it share a " + facet + " with a neighbour.");
}

}  // namespace

template <int dim>
void check_supports(const BlockSource<dim>& source, const std::vector<FacetNames>& supported) {
  if (supported.empty()) return;
  std::vector<FacetSet> sets;
  for (const FacetNames& names : supported) {
    const auto& known = source.facet_sets();
    if (std::find(known.begin(), known.end(), names.on) != known.end()) sets.push_back(facet_set(source, names));
  }
  const BlockGraph& graph = source.graph();
  const std::vector<BlockId> group = groups_of_joined_blocks<dim>(graph);
  std::vector<char> held(group.size(), 0);
  std::vector<int> size(group.size(), 0);
  for (BlockId b = 0; b < source.block_count(); ++b) {
    ++size[group[b]];
    if (held[group[b]]) continue;
    const Block<dim> block = source.block(b);
    for (const TaggedFacet& facet : block.facets)
      for (const FacetSet& set : sets)
        if (set.has(block, facet)) held[group[b]] = 1;
  }
  for (BlockId b = 0; b < source.block_count(); ++b)
    if (group[b] == b && !held[b])
      throw without_support(source.block(b).name, size[b], graph.start[b + 1] > graph.start[b],
                            dim == 2 ? "curve" : "face", supported);
}

template <int dim>
void check_blocks(const BlockSource<dim>& source, const std::vector<FacetNames>& supported) {
  static_assert(dim == 2, "borders of spatial blocks are not checked yet");
  std::vector<Block<dim>> blocks;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    blocks.push_back(source.block(b));
    check_block(blocks.back());
  }
  check_borders(blocks);
  check_supports(source, supported);
}

template <int dim>
void check_blocks(const BlockSource<dim>& source, const std::vector<FacetNames>& supported,
                  const Teuchos::Comm<int>& comm) {
  on_first_rank(comm, [&] { check_blocks(source, supported); });
}

template void check_supports(const BlockSource<2>&, const std::vector<FacetNames>&);
template void check_supports(const BlockSource<3>&, const std::vector<FacetNames>&);
template void check_blocks(const BlockSource<2>&, const std::vector<FacetNames>&);
template void check_blocks(const BlockSource<2>&, const std::vector<FacetNames>&, const Teuchos::Comm<int>&);

}  // namespace voussoir

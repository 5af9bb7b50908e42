#include "mesh/mesh_check.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "base/error.hpp"
#include "base/words.hpp"
#include "linalg/agree.hpp"
#include "linalg/groups.hpp"

namespace voussoir {
namespace {

/// The smallest block that each of the blocks a rank reads is joined to, directly or through others. Collective.
template <int dim>
std::vector<long long> groups_of_joined_blocks(const BlockSource<dim>& source, const BlockSpan& read,
                                               const Teuchos::Comm<int>& comm) {
  std::vector<long long> mine;
  std::vector<HangsWith> pairs;
  for (BlockId b = read.from; b < read.to; ++b) {
    mine.push_back(b);
    for (const auto& [other, shared] : source.neighbours(b))
      if (shared >= dim) pairs.push_back({b, other, source.reader_of(other, comm.getSize())});
  }
  return least_of_group(mine, pairs, comm);
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
void check_supports(const BlockSource<dim>& source, const std::vector<FacetNames>& supported,
                    const Teuchos::Comm<int>& comm) {
  if (supported.empty()) return;
  std::vector<FacetSet> sets;
  for (const FacetNames& names : supported) {
    const auto& known = source.facet_sets();
    if (std::find(known.begin(), known.end(), names.on) != known.end()) sets.push_back(facet_set(source, names));
  }
  const auto read = source.read_by(comm.getRank(), comm.getSize());
  const auto group = groups_of_joined_blocks(source, read, comm);
  std::map<long long, std::array<double, 2>> mine;  // blocks of a group, and whether any is held
  for (BlockId b = read.from; b < read.to; ++b) {
    auto& [size, held] = mine[group[b - read.from]];
    ++size;
    if (held > 0) continue;
    const Block<dim> block = source.block(b);
    for (const TaggedFacet& facet : block.facets)
      for (const FacetSet& set : sets)
        if (set.has(block, facet)) held = 1;
  }
  const auto all = totals_by_key(mine, comm);
  agree(comm, [&] {
    for (const auto& [first, sums] : all) {
      const auto b = static_cast<BlockId>(first);
      if (sums[1] > 0 || b < read.from || b >= read.to) continue;
      throw without_support(source.block(b).name, static_cast<int>(sums[0]), !source.neighbours(b).empty(),
                            dim == 2 ? "curve" : "face", supported);
    }
  });
}

void check_mesh(const std::vector<Block<2>>& blocks) {
  for (const auto& block : blocks) check_block(block);
  check_borders(blocks);
}

template void check_supports(const BlockSource<2>&, const std::vector<FacetNames>&, const Teuchos::Comm<int>&);
template void check_supports(const BlockSource<3>&, const std::vector<FacetNames>&, const Teuchos::Comm<int>&);

}  // namespace voussoir

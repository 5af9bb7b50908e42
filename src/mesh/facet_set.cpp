#include "mesh/facet_set.hpp"

#include <algorithm>
#include <tuple>

#include "base/check.hpp"
#include "linalg/parcels.hpp"

namespace voussoir {
namespace {

int index_of(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  VOUSSOIR_CHECK(found != names.end());
  return static_cast<int>(found - names.begin());
}

/// A facet of a block by its vertices, so that both sides of a joint have the same.
template <int dim>
struct FacetSide {
  static constexpr std::size_t corners = TwoSidedFacet<dim>::corners;
  std::array<VertexId, corners> vertices;  ///< ascending
  BlockId block;
  std::array<Vector<dim>, corners> x;  ///< [m]
  bool operator<(const FacetSide& o) const { return std::tie(vertices, block) < std::tie(o.vertices, o.block); }
};

template <int dim>
FacetSide<dim> side_of(const Block<dim>& block, const TaggedFacet& facet) {
  constexpr std::size_t corners = FacetSide<dim>::corners;
  FacetSide<dim> side;
  side.block = block.id;
  for (std::size_t k = 0; k < corners; ++k) {
    side.vertices[k] = block.vertex[facet.node[k]];
    side.x[k] = block.position[facet.node[k]];
  }
  // A triangle has one vertex twice, whichever it is on either side: the largest of them on both.
  const auto largest = *std::max_element(side.vertices.begin(), side.vertices.end());
  if (corners == 4 && facet.count == 3) side.vertices[corners - 1] = largest;
  std::sort(side.vertices.begin(), side.vertices.end());
  return side;
}

}  // namespace

template <int dim>
FacetSet facet_set(const BlockSource<dim>& source, const FacetNames& names) {
  const bool every = names.blocks.empty() || names.blocks == "all";
  return {index_of(source.facet_sets(), names.on),
          every ? FacetSet::every : source.block_sets().number_of(names.blocks)};
}

template <int dim>
std::vector<TwoSidedFacet<dim>> two_sided_facets(const BlockSource<dim>& source, const FacetSet& set,
                                                 const Teuchos::Comm<int>& comm) {
  const int ranks = comm.getSize();
  const auto read = source.read_by(comm.getRank(), ranks);
  Post<FacetSide<dim>> sides_there(comm);  // both sides of a facet meet on one rank, which their vertices tell
  for (BlockId b = read.from; b < read.to; ++b) {
    const auto block = source.block(b);
    for (const TaggedFacet& facet : block.facets)
      if (set.has(block, facet)) {
        const auto side = side_of(block, facet);
        sides_there.add(static_cast<int>(side.vertices[0] % ranks), side);
      }
  }
  auto sides = std::move(sides_there).send_all();
  std::sort(sides.begin(), sides.end());
  Post<TwoSidedFacet<dim>> found(comm);
  for (std::size_t k = 0; k + 1 < sides.size(); ++k)
    if (sides[k].vertices == sides[k + 1].vertices && sides[k].block != sides[k + 1].block)
      found.add(source.reader_of(sides[k].block, ranks), {sides[k].block, sides[k + 1].block, sides[k].x});
  auto both = std::move(found).send_all();
  std::stable_sort(both.begin(), both.end(), [](const auto& a, const auto& b) {
    return std::tie(a.block_i, a.block_j) < std::tie(b.block_i, b.block_j);
  });
  return both;
}

template <int dim>
bool has_facets(const BlockSource<dim>& source, const FacetSet& set, BlockSpan among) {
  for (BlockId b = among.from; b < among.to; ++b) {
    const auto block = source.block(b);
    for (const TaggedFacet& facet : block.facets)
      if (set.has(block, facet)) return true;
  }
  return false;
}

template FacetSet facet_set(const BlockSource<2>&, const FacetNames&);
template FacetSet facet_set(const BlockSource<3>&, const FacetNames&);
template std::vector<TwoSidedFacet<2>> two_sided_facets(const BlockSource<2>&, const FacetSet&,
                                                        const Teuchos::Comm<int>&);
template std::vector<TwoSidedFacet<3>> two_sided_facets(const BlockSource<3>&, const FacetSet&,
                                                        const Teuchos::Comm<int>&);
template bool has_facets(const BlockSource<2>&, const FacetSet&, BlockSpan);
template bool has_facets(const BlockSource<3>&, const FacetSet&, BlockSpan);

}  // namespace voussoir

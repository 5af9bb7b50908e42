// Which facets a support or a load means.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// The facets of a named set, of all blocks or of those of a named set alone. A curve or surface between two stones
/// belongs to both of them, so only the blocks tell its two sides apart.
struct FacetSet {
  static constexpr int every = -2;
  int facets;          ///< index into BlockSource::facet_sets()
  int blocks = every;  ///< number in BlockSource::block_sets(); -1 for one that is not known here

  FacetSet(int facets_, int blocks_ = every) : facets(facets_), blocks(blocks_) {}
  template <int dim>
  bool has_side(const Block<dim>& block) const {
    if (blocks == every) return true;
    for (const int set : block.sets)
      if (set == blocks) return true;
    return false;
  }
  template <int dim>
  bool has(const Block<dim>& block, const TaggedFacet& facet) const {
    return facet.set == facets && has_side(block);
  }
};

/// The same by its names, which must be those of the source. Of blocks that are brought later it knows nothing.
struct FacetNames {
  std::string on;
  std::string blocks;  ///< a set of blocks; "all" or nothing for every block
  FacetNames(std::string on_, std::string blocks_ = "") : on(std::move(on_)), blocks(std::move(blocks_)) {}
  FacetNames(const char* on_) : on(on_) {}
};
template <int dim>
FacetSet facet_set(const BlockSource<dim>&, const FacetNames&);

/// A facet of a joint of which a set has both sides, once.
template <int dim>
struct TwoSidedFacet {
  static constexpr int corners = 2 * (dim - 1);
  BlockId block_i, block_j;            ///< ascending
  std::array<Vector<dim>, corners> x;  ///< [m] its corners; a triangle has its last one twice
  /// Normal to it, in space as long as its area [m2], in the plane as it is long [m].
  Vector<dim> normal() const;
  double size() const { return norm(normal()); }
};
template <>
inline Vector<2> TwoSidedFacet<2>::normal() const {
  return {x[1][1] - x[0][1], x[0][0] - x[1][0]};
}
template <>
inline Vector<3> TwoSidedFacet<3>::normal() const {
  return 0.5 * cross(x[2] - x[0], x[3] - x[1]);
}

/// Facets of which a set has both sides, each on the rank that reads the lower one of its blocks, by blocks.
/// Collective.
template <int dim>
std::vector<TwoSidedFacet<dim>> two_sided_facets(const BlockSource<dim>&, const FacetSet&, const Teuchos::Comm<int>&);

/// Some of these blocks have a facet of the set.
template <int dim>
bool has_facets(const BlockSource<dim>&, const FacetSet&, BlockSpan among);

}  // namespace voussoir

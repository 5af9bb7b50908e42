// Which node copies are held along what, and where settlements move them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "blocks/held.hpp"
#include "blocks/structure.hpp"
#include "blocks/support_parameters.hpp"
#include "mesh/facet_set.hpp"

namespace voussoir {

/// Calls visit(local node) for every node of a facet of the set, on blocks of this rank and its halo;
/// a node of two facets is visited twice.
template <int dim, class Visit>
void for_each_node_on(const Structure<dim>& s, const FacetSet& set, const Visit& visit) {
  for (const auto& b : s.blocks())
    for (const auto& f : b.mesh.facets)
      if (set.has(b.mesh, f))
        for (int i = 0; i < f.count; ++i) visit(b.first_local + f.node[i]);
}

/// Across a facet as drawn, as long as the edge [m] or as large as the face [m2]; to which side is not said.
Vector<2> across(const Block<2>&, const TaggedFacet& edge);
Vector<3> across(const Block<3>&, const TaggedFacet& face);

/// Directions square to each other, of which every other one is made that is held.
template <int dim>
class Directions {
 public:
  /// Takes what of a unit vector is none of those yet. Returns whether there is any.
  bool add(const Vector<dim>& along);
  int count() const { return count_; }
  const Vector<dim>& operator[](int i) const { return along_[i]; }
  /// What of a vector lies across all of them.
  Vector<dim> across(Vector<dim> v) const;

 private:
  std::array<Vector<dim>, dim> along_{};
  int count_ = 0;
};

/// Unit vectors along which a support holds a node copy: axes of the drawing, or the normals of its facets there. These
/// are one, the mean, where facets meet in a smooth surface, and several at an edge between two.
template <int dim>
struct HeldAlong {
  int node;
  std::vector<Vector<dim>> along;
};

/// What a support holds, on blocks of this rank and its halo, by nodes in ascending order.
template <int dim>
std::vector<HeldAlong<dim>> held_along(const Structure<dim>&, const SupportParameters&, const FacetSet&);

/// Adds what a support holds along axes to held[dim node + component].
template <int dim>
void hold(const Structure<dim>& s, const SupportParameters& support, const FacetSet& set, std::vector<char>& held) {
  for_each_node_on(s, set, [&](int node) {
    for (int c = 0; c < dim; ++c)
      if (support.holds(c)) held[dim * node + c] = 1;
  });
}

/// A support of a scene and its facets.
struct SupportedFacets {
  SupportParameters support;
  FacetSet facets;
};

/// What supports hold all together.
template <int dim>
Held held_by(const Structure<dim>&, const std::vector<SupportedFacets>&);

}  // namespace voussoir

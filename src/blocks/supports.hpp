// Which node copies are held, and where settlements move them.
#pragma once

#include <string>
#include <vector>

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

/// Whether the support holds component c, "x" = 0, "y" = 1, "z" = 2.
inline bool holds(const SupportParameters& support, int c) {
  return support.components == "all" || support.components.find("xyz"[c]) != std::string::npos;
}

/// Marks held[dim node + component] for one support.
template <int dim>
void hold(const Structure<dim>& s, const SupportParameters& support, const FacetSet& set, std::vector<char>& held) {
  for_each_node_on(s, set, [&](int node) {
    for (int c = 0; c < dim; ++c)
      if (holds(support, c)) held[dim * node + c] = 1;
  });
}

}  // namespace voussoir

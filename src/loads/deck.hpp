// The deck that wheels roll along x on, in pieces between the places where the stones or cells below them change.
#pragma once

#include <array>
#include <vector>

#include "blocks/structure.hpp"
#include "loads/facets.hpp"
#include "mesh/facet_set.hpp"

namespace voussoir {

/// What lies below a line of wheels between two x: a wheel there is borne by these nodes, whose shares go linearly from
/// one end to the other and add up to one, so that force and moment are exact, and by edges that bend between them.
struct DeckPiece {
  std::array<double, 2> x;                     ///< [m] rising
  std::array<std::array<double, 4>, 2> share;  ///< [-] of each node, at either end
  std::array<long long, 3> id;                 ///< nodes; -1 for none
  Bearers local;                               ///< the same on this rank, none elsewhere
  BlockId stone;
};

/// All of a deck below a line of wheels.
struct Deck {
  std::vector<DeckPiece> pieces;      ///< that bear wheels, by their beginning
  std::vector<DeckPiece> other_hand;  ///< that could bear them as well where the line runs along facets
};

/// The pieces of a set of facets, on every rank. Collective.
/// @param across  [m] y of the line of wheels in space; of no meaning in the plane
template <int dim>
Deck pieces_of_deck(const Structure<dim>&, const FacetSet&, double across);

extern template Deck pieces_of_deck<2>(const Structure<2>&, const FacetSet&, double);
extern template Deck pieces_of_deck<3>(const Structure<3>&, const FacetSet&, double);

}  // namespace voussoir

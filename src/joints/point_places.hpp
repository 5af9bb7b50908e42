// Points known by where they are: numbers and ranks change where points come and go, places do not.
#pragma once

#include <Teuchos_Comm.hpp>
#include <vector>

#include "joints/contact_points.hpp"

namespace voussoir {

/// A point as the mesh draws it.
struct PointPlace {
  BlockId block_i = 0, block_j = 0;
  Vector<3> place{};   ///< [m]
  Vector<3> normal{};  ///< one place has two points where a joint turns a corner
};

/// Of all points of this rank, wherever their blocks have turned to.
template <int dim>
std::vector<PointPlace> places_of(const ContactPoints&, const Structure<dim>&);

/// For each point the number of the one that stands at its place among others, -1 where none does. No other is taken
/// twice.
/// @param near  [m] places within this are one
std::vector<int> same_places(const std::vector<PointPlace>& points, const std::vector<PointPlace>& others, double near);

/// The same among others that ranks have shared in any way, each in the order of their numbers: no rank hears of all.
/// Points of one joint meet the others of that joint on one rank. Collective.
/// @param first  number of the first of others, which this rank has without a gap
std::vector<long long> same_places_over_ranks(const std::vector<PointPlace>& points,
                                              const std::vector<PointPlace>& others, long long first, double near,
                                              const Teuchos::Comm<int>&);

}  // namespace voussoir

// Surfaces of stones in space where a displacement has moved them.
#pragma once

#include <algorithm>
#include <vector>

#include "mesh/box_tree.hpp"
#include "model/space/space_model.hpp"
#include "range/range_check.hpp"
#include "stones/solid.hpp"

namespace voussoir {

inline Vector<3> place_now(const Structure<3>& s, const std::vector<double>& u, int node) {
  return s.drawn_position()[node] + Vector<3>{u[3 * node], u[3 * node + 1], u[3 * node + 2]};
}

/// Where a side of a point is.
inline Vector<3> place_now(const Structure<3>& s, const std::vector<double>& u, const PointOperator& p, Side side) {
  Vector<3> place{};
  p.each_of(side, [&](int node, double weight) { place = place + weight * place_now(s, u, node); });
  return place;
}

/// A stone with its surface where it is.
struct PlacedSurface {
  BlockId block;
  StoneSurface surface;
  double turn;  ///< [rad] by which it has turned without being followed
  Box<3> box;
};

/// Those of this rank that are there, ascending.
std::vector<PlacedSurface> surfaces_here(const SpaceModel&, const StepEnd&);
/// Those of all ranks that lie in a box of this rank, or reach into it, ascending. Collective.
/// @param here  surfaces_here()
std::vector<PlacedSurface> surfaces_in(const Box<3>& mine, const std::vector<PlacedSurface>& here,
                                       const Teuchos::Comm<int>&);

/// Border of a local block, its faces outward.
StoneSurface surface_now(const Structure<3>&, const std::vector<double>& u, int block);

/// [m] How far a place is outside of a stone, 0 in it.
inline double distance_outside(const Solid& stone, const Vector<3>& place) {
  return std::max(0.0, -stone.depth(place));
}

}  // namespace voussoir

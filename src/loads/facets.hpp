// Edges and faces of a set, and forces spread along edges, for loads on facets.
#pragma once

#include <cmath>
#include <vector>

#include "blocks/structure.hpp"
#include "mesh/facet_set.hpp"

namespace voussoir {

/// An edge of a block on this rank or its halo.
struct LoadedEdge {
  int node[2];        ///< local node copies
  Vector<2> x[2];     ///< [m] their positions
  Vector<2> outward;  ///< unit normal that leaves the block
  double length;      ///< [m]

  /// Position at s in [0, 1] from the first node to the second.
  Vector<2> at(double s) const { return x[0] + s * (x[1] - x[0]); }
};

/// Whether an edge has a horizontal projection. Corners of a vertical joint differ by the rounding of a drawing, 1e-16
/// of coordinates and up to 1e-12 of an edge; what is steeper than this carries nothing that could be measured.
inline bool has_width(const Vector<2>& a, const Vector<2>& b) { return std::abs(a[0] - b[0]) > 1e-9 * norm(b - a); }

/// All edges of a set, on blocks of this rank and its halo. The outward side is where the block is not, judged from the
/// cell an edge belongs to, so that the order in which a file names the nodes does not matter.
std::vector<LoadedEdge> edges_of_set(const Structure<2>&, const FacetSet&);

/// A face of a block on this rank or its halo.
struct LoadedFace {
  int node[4];           ///< local node copies
  Vector<3> outward[4];  ///< [m2] integral of the shape function of each times the unit normal that leaves the block
};
std::vector<LoadedFace> faces_of_set(const Structure<3>&, const FacetSet&);

/// Share [from, to] of an edge, as s in [0, 1], where low <= component c of the position <= high; from >= to for none.
struct PartOfEdge {
  double from = 0, to = 1;
};
PartOfEdge part_between(const LoadedEdge&, int c, double low, double high);

/// Adds the consistent nodal forces of a traction [Pa] along a part of an edge. Two Gauss points: exact for a traction
/// that is linear along the part.
/// @param traction  Vector<2>(const Vector<2>& position)
template <class Traction>
void add_along(const LoadedEdge& e, const PartOfEdge& part, double thickness, const Traction& traction,
               std::vector<double>& force) {
  if (part.from >= part.to) return;
  const double middle = (part.from + part.to) / 2, half = (part.to - part.from) / 2;
  for (const double xi : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
    const double s = middle + xi * half, area = half * e.length * thickness;
    const Vector<2> t = traction(e.at(s));
    for (int c = 0; c < 2; ++c) {
      force[2 * e.node[0] + c] += (1 - s) * area * t[c];
      force[2 * e.node[1] + c] += s * area * t[c];
    }
  }
}

}  // namespace voussoir

// Edges and faces of a set, and forces spread over parts of them, for loads on facets.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
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
  double thickness;   ///< [m] of its block, out of plane

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
  int count;             ///< of corners, 3 or 4
  int node[4];           ///< local node copies
  Vector<3> x[4];        ///< [m] their positions
  Vector<3> outward[4];  ///< [m2] integral of the shape function of each times the unit normal that leaves the block
};
std::vector<LoadedFace> faces_of_set(const Structure<3>&, const FacetSet&);

/// What lies between two values of a coordinate [m].
struct Slab {
  int component;
  double low, high;
};
inline Slab below(int component, double high) { return {component, -std::numeric_limits<double>::infinity(), high}; }

/// Share [from, to] of an edge, as s in [0, 1], where low <= component c of the position <= high; from >= to for none.
struct PartOfEdge {
  double from = 0, to = 1;
};
PartOfEdge part_between(const LoadedEdge&, int c, double low, double high);

/// Adds the consistent nodal forces of a traction [Pa] along a part of an edge. Two Gauss points: exact for a traction
/// that is linear along the part.
/// @param traction  Vector<2>(const Vector<2>& position)
template <class Traction>
void add_along(const LoadedEdge& e, const PartOfEdge& part, const Traction& traction, std::vector<double>& force) {
  if (part.from >= part.to) return;
  const double middle = (part.from + part.to) / 2, half = (part.to - part.from) / 2;
  for (const double xi : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
    const double s = middle + xi * half, area = half * e.length * e.thickness;
    const Vector<2> t = traction(e.at(s));
    for (int c = 0; c < 2; ++c) {
      force[2 * e.node[0] + c] += (1 - s) * area * t[c];
      force[2 * e.node[1] + c] += s * area * t[c];
    }
  }
}

/// A point of a part of a face at which tractions are summed up.
struct FacePoint {
  Vector<3> at;       ///< [m]
  Vector<3> outward;  ///< unit normal that leaves the block
  double area[4];     ///< [m2] its weight times the shape function of each corner
};

/// Points and weights that are exact for a traction that is linear over what of a face lies in all slabs. One of four
/// corners counts as two triangles, once along each diagonal with half the weight, so that none is preferred; force and
/// moment are exact.
std::vector<FacePoint> points_of(const LoadedFace&, const std::vector<Slab>&);

/// Adds the consistent nodal forces of a traction [Pa] on what of the facets of a set lies in all slabs. Exact for
/// tractions that are linear along a facet.
/// @param traction  Vector<dim>(const Vector<dim>& position, const Vector<dim>& outward)
template <class Traction>
void add_on_facets(const Structure<2>& s, const FacetSet& set, const std::vector<Slab>& slabs, const Traction& traction,
                   std::vector<double>& force) {
  for (const auto& e : edges_of_set(s, set)) {
    PartOfEdge part;
    for (const auto& slab : slabs) {
      const auto other = part_between(e, slab.component, slab.low, slab.high);
      part = {std::max(part.from, other.from), std::min(part.to, other.to)};
    }
    add_along(
        e, part, [&](const Vector<2>& x) { return traction(x, e.outward); }, force);
  }
}

template <class Traction>
void add_on_facets(const Structure<3>& s, const FacetSet& set, const std::vector<Slab>& slabs, const Traction& traction,
                   std::vector<double>& force) {
  for (const auto& face : faces_of_set(s, set))
    for (const auto& point : points_of(face, slabs)) {
      const Vector<3> t = traction(point.at, point.outward);
      for (int i = 0; i < face.count; ++i)
        for (int c = 0; c < 3; ++c) force[3 * face.node[i] + c] += point.area[i] * t[c];
    }
}

}  // namespace voussoir

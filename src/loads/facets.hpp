// Edges and faces of a set, and forces spread over parts of them, for loads on facets.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "blocks/block_forces.hpp"
#include "blocks/structure.hpp"
#include "mesh/facet_set.hpp"

namespace voussoir {

/// What an edge or face bears a force by, on this rank: its corners, and those of its edges that bend. -1 for none.
struct Bearers {
  std::array<int, 4> node{-1, -1, -1, -1};
  std::array<int, 3> edge{-1, -1, -1};  ///< between corners 0 and 1, 1 and 2, 2 and 0 of an edge or triangle

  /// Adds what comes to them of a force [N] at a place: to a corner L_i of it, to an edge that bends 4 L_i L_j.
  /// @param share  L_i of each corner there
  template <int dim>
  void add(const std::array<double, 4>& share, const Vector<dim>& force, BlockForces& to) const {
    for (std::size_t i = 0; i < node.size(); ++i)
      for (int c = 0; c < dim && node[i] >= 0; ++c) to.of_nodes[dim * node[i] + c] += share[i] * force[c];
    for (std::size_t i = 0; i < edge.size(); ++i)
      for (int c = 0; c < dim && edge[i] >= 0; ++c)
        to.of_edges[dim * edge[i] + c] += 4 * share[i] * share[(i + 1) % 3] * force[c];
  }
};
/// Those of corners of one block, of which the last may be -1.
template <int dim>
Bearers bearers_of(const Structure<dim>&, const std::array<int, 4>& node);

/// An edge of a block on this rank or its halo.
struct LoadedEdge : Bearers {
  Vector<2> x[2];     ///< [m] positions of its nodes
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
struct LoadedFace : Bearers {
  int count;             ///< of corners, 3 or 4
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

/// Adds the consistent forces of a traction [Pa] along a part of an edge. Two Gauss points: exact for a traction that
/// is linear along the part, on an edge that bends too.
/// @param traction  Vector<2>(const Vector<2>& position)
template <class Traction>
void add_along(const LoadedEdge& e, const PartOfEdge& part, const Traction& traction, BlockForces& force) {
  if (part.from >= part.to) return;
  const double middle = (part.from + part.to) / 2, half = (part.to - part.from) / 2;
  for (const double xi : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
    const double s = middle + xi * half, area = half * e.length * e.thickness;
    const Vector<2> t = traction(e.at(s));
    e.add<2>({1 - s, s, 0, 0}, area * t, force);
  }
}

/// A point of a part of a face at which tractions are summed up.
struct FacePoint {
  Vector<3> at;                 ///< [m]
  Vector<3> outward;            ///< unit normal that leaves the block
  double area;                  ///< [m2] its weight
  std::array<double, 4> share;  ///< [-] shape function of each corner
};

/// Points and weights that are exact for a traction that is linear over what of a face lies in all slabs, on one whose
/// edges bend too. One of four
/// corners counts as two triangles, once along each diagonal with half the weight, so that none is preferred; force and
/// moment are exact.
std::vector<FacePoint> points_of(const LoadedFace&, const std::vector<Slab>&);

/// Adds the consistent forces of a traction [Pa] on what of the facets of a set lies in all slabs. Exact for
/// tractions that are linear along a facet.
/// @param traction  Vector<dim>(const Vector<dim>& position, const Vector<dim>& outward)
template <class Traction>
void add_on_facets(const Structure<2>& s, const FacetSet& set, const std::vector<Slab>& slabs, const Traction& traction,
                   BlockForces& force) {
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
                   BlockForces& force) {
  for (const auto& face : faces_of_set(s, set))
    for (const auto& point : points_of(face, slabs))
      face.add<3>(point.share, point.area * traction(point.at, point.outward), force);
}

}  // namespace voussoir

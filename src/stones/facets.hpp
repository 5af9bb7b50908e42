// Plane facets of a stone: faces that lie in one plane are one facet, whatever edges a file has drawn on it.
#pragma once

#include <vector>

#include "mesh/box_tree.hpp"
#include "stones/surface.hpp"

namespace voussoir {

/// A part of the surface of a stone that is plane to a tolerance.
struct StoneFacet {
  Vector<3> normal{}, centre{};           ///< of its plane; outward
  double area = 0;                        ///< [m2]
  double out_of_plane = 0;                ///< [m] its farthest point
  std::vector<std::array<int, 2>> edges;  ///< its border, facet to the left: numbers of points of the stone
  std::vector<Places> pieces;             ///< convex, counter-clockwise from outside; together the facet
  Box<3> box{};
};

struct FacetedStone {
  const StoneSurface* surface = nullptr;
  std::vector<StoneFacet> facets;
  int warped = 0;       ///< faces that are not plane, cut into triangles
  double farthest = 0;  ///< [m] a point of a face from the plane of the face
  Box<3> box{};
};

/// Facets grow from the largest face over edges, while every point of the next face lies within the tolerance of the
/// plane of the first. Faces that are farther than it from their own plane are cut into triangles, by shortest
/// diagonals, so that the two sides of a joint are cut alike.
/// @param stone      closed, faces outward; kept by its address
/// @param tolerance  [m]
FacetedStone facets_of(const StoneSurface& stone, double tolerance);
std::vector<FacetedStone> facets_of(const std::vector<StoneSurface>&, double tolerance);

/// [m] how far a point lies outside of the plane of a facet along another direction.
double distance_along(const StoneFacet&, const Vector<3>& point, const Vector<3>& direction);

Box<3> box_of(const Places&);

}  // namespace voussoir

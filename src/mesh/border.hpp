// The borders of blocks, facet by facet: edges in the plane, faces in space.
#pragma once

#include <array>
#include <tuple>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// A facet that belongs to one cell of its block: an edge of the plane, or a face of four nodes in space.
template <int dim>
struct BorderFacet {
  static constexpr int corners = 2 * (dim - 1);
  std::array<VertexId, corners> vertices;  ///< ascending, so that both sides of a joint have the same
  BlockId block;
  /// Local numbers, counter-clockwise about the block: it lies to the left of an edge, and behind a face whose nodes
  /// are counter-clockwise.
  std::array<int, corners> node;
  bool operator<(const BorderFacet& other) const {
    return std::tie(vertices, block) < std::tie(other.vertices, other.block);
  }
};
using BorderEdge = BorderFacet<2>;
using BorderFace = BorderFacet<3>;

/// Borders that leave a common vertex and stay closer than this part of the shorter edge were meant to touch, as chords
/// of different length along one arc do. Chords of 18 degrees (ten to a semicircle) and of 9 degrees leave it 4.5
/// degrees apart: 0.08 of the shorter.
constexpr double nearly_touching_at_vertex = 0.15;

std::array<VertexId, 2> ascending(VertexId, VertexId);

/// Border facets of all blocks, sorted: the sides of a joint follow each other.
template <int dim>
std::vector<BorderFacet<dim>> border_facets(const std::vector<Block<dim>>&);

}  // namespace voussoir

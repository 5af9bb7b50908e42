// Which facets that meet at a node are one side of a stone. Where that is a joint they have one point, and the mean of
// their normals.
#pragma once

#include <algorithm>
#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// Cosines of the angles up to which facets are one side. What is curved is meshed by facets that turn by up to 20
/// degrees (mesh/divisions), and their mean is its normal to the second order: a point for each would bear forces
/// beyond the cone of friction. Where a drawing has an edge, both sides of it are meant, and the mean of their
/// normals is that of neither: it admits motions into both. Places that were rounded turn faces by less than 5 degrees.
constexpr double cosine_of_curved = 0.94, cosine_of_drawn = 0.9961947;
constexpr double turn_of_curved = 0.35;  ///< [rad] the angle itself, for outlines whose turns are known

/// Whether two normals, of any length, are of one side of a block.
/// @param drawn  whether the drawing has an edge there
template <std::size_t n>
bool on_same_side(const std::array<double, n>& a, const std::array<double, n>& b, bool drawn) {
  return dot(a, b) > (drawn ? cosine_of_drawn : cosine_of_curved) * norm(a) * norm(b);
}

/// Whether the drawing of a block has an edge at this node.
template <class Block>
bool is_fold(const Block& block, int node) {
  return std::binary_search(block.folds.begin(), block.folds.end(), node);
}

}  // namespace voussoir

// Which points of a joint are neighbours: those at the ends of one facet of the drawing.
#pragma once

#include <vector>

#include "joints/contact_points.hpp"
#include "joints/joint_statics.hpp"

namespace voussoir {

/// Facets between owned points, per joint of this rank, as numbers of points within the joint. A point is at the node
/// of the side that is one node, of block i where both are.
std::vector<std::vector<FacetOfJoint>> facets_of_joints(const BlockSource<2>&, const Structure<2>&,
                                                        const ContactPoints&);

}  // namespace voussoir

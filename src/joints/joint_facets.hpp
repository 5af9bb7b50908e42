// Which points of a joint are neighbours: those at the ends of one facet of the drawing.
#pragma once

#include <vector>

#include "joints/contact_points.hpp"
#include "joints/joint_statics.hpp"

namespace voussoir {

/// Facets between owned points, per joint of this rank, as numbers of points within the joint. A point is at the node
/// of the side that is one node, of block i where both are. Where a node has two points of a joint, a facet has the one
/// whose side it is of.
template <int dim>
std::vector<std::vector<FacetOfJoint<dim>>> facets_of_joints(const BlockSource<dim>&, const Structure<dim>&,
                                                             const ContactPoints&);

}  // namespace voussoir

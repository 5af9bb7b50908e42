// What one joint carries, from the forces at its contact points: resultant, how far it is from the edge and from the
// friction cone, and whether the joint is a hinge or slides.
//
// Conventions  src/README.md, "Contact"; forces are those of block i on block j. The resultant is told against the mean
//              normal of the joint; its place is where it crosses the tangent of that through the joint's middle.
//
// Margins are those of the sides of a joint: chains of facets without a corner, at which it could not slide along. A
// side that bends is measured as if it were straightened: the place of its pressure along it, the sum of the shear
// forces along it. So no margin is below zero where every point obeys its law, and none is zero but where all that
// presses is at an end, or all points slide one way. Of several sides the least margin is told.
//
// In space a side is laid onto its mean plane. Its edges are those of the convex hull of its points, since compression
// acts anywhere within; its friction is used by shear and twist together (joints/friction_of_patch.hpp).
#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "base/tensor.hpp"
#include "joints/contact_law.hpp"

namespace voussoir {

template <int dim>
struct PointOfJoint {
  Vector<dim> position{};                                     ///< [m]
  Vector<dim> normal{};                                       ///< unit, from block i to block j
  double normal_force = 0;                                    ///< [N] compression positive
  std::conditional_t<dim == 2, double, Vector<dim>> shear{};  ///< [N] along the normal turned by +90 degrees; a vector
  double gap = 0;                                             ///< [m] > 0 open
  PointLaw law;                                               ///< as it is now: what broke has no strength
  double area = 0;                                            ///< [m2] its share of the joint; asked in space
};

/// A facet of a joint, as the numbers of the points at its corners; a triangle has its last one twice.
template <int dim>
using FacetOfJoint = std::array<int, 2 * (dim - 1)>;

template <int dim>
struct JointStatics {
  Vector<dim> force{};      ///< [N] on block j
  double normal_force = 0;  ///< [N] along the mean normal, compression positive
  double shear = 0;         ///< [N] along the joint; in space its size
  double twist = 0;         ///< [N m] about the mean normal through the place of the resultant; none in the plane
  double pressing = 0;      ///< [N] sum of the normal forces of its points, each along its own normal
  double extent = 0;        ///< [m] of the chord from its first point to its last; in space its area [m2]
  Vector<dim> middle{};     ///< [m]
  Vector<dim> place{};      ///< [m] where the resultant crosses the joint; NaN without compression
  double eccentricity = 0;  ///< [m] from the middle to the place, along the joint; NaN without compression
  /// [-] Distance of the pressure from an edge of its side over the length of that, in space the width across the edge,
  /// at the edge where this is least: 0.5 in the middle of a strip, 0 at the edge, negative beyond it, where strength
  /// in tension holds; NaN without compression.
  double edge_margin = 0;
  /// [-] Share of the strength in shear that is left: 1 without shear, 0 when the whole side slides, and where bonded
  /// points bear more than their law admits; NaN where no shear could be borne.
  double friction_margin = 0;
  int sides = 0;              ///< how many it has
  Vector<dim> edge{};         ///< [m] the place of the edge from which the edge margin counts; NaN without one
  Vector<dim> least_shear{};  ///< [m] middle of the side with the least friction margin; NaN without one
  double opening = 0;         ///< [m] the widest gap, 0 when none is open
  bool hinge = false;         ///< open at one edge, the pressure at the other
  bool slides = false;        ///< nothing of its strength in shear is left on any side that is pressed
};

/// @param points  of one joint, at least one, in any order
/// @param facets  between them; none: all points follow each other on one side
template <int dim>
JointStatics<dim> joint_statics(const std::vector<PointOfJoint<dim>>& points,
                                const std::vector<FacetOfJoint<dim>>& facets = {});

}  // namespace voussoir

// Where blocks meet: contact points, each a place with nodes and weights on either side.
//
// Conventions  The normal of a point runs from its block i (the lower number) to block j.
//              Component 0 of a gap or force is normal, the others tangential.
//              Gap [m] > 0 is open; normal force [N] > 0 is compression.
//              Places and axes have three components in the plane too, the third of which is none.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "blocks/structure.hpp"
#include "joints/point_operator.hpp"
#include "mesh/border.hpp"

namespace voussoir {

/// A joint: all points between two blocks.
struct Joint {
  BlockId block_i = 0, block_j = 0;
  int local_i = 0, local_j = 0;  ///< their numbers on this rank
  int family = 0;                ///< index into the scene's joint laws
  double thickness = 1;          ///< [m] out of plane, of the thinner block: so much of both bears; 1 in space
};

/// A block with its border.
template <int dim>
struct BlockWithBorder {
  Block<dim> block;
  std::vector<BorderFacet<dim>> facets;
};

/// Finds the points between two blocks, the one with the lower number first, in an order that no rank changes.
template <int dim>
using PointFinder =
    std::function<std::vector<FoundPoint>(const BlockWithBorder<dim>& i, const BlockWithBorder<dim>& j)>;

/// Pairs of coincident nodes, as joint_finder and joint_finder_in_space find them.
template <int dim>
std::vector<FoundPoint> coincident_points(const BlockWithBorder<dim>& i, const BlockWithBorder<dim>& j);

/// All contact points geometry allows (the candidates) between blocks of this rank and its halo.
class ContactPoints {
 public:
  /// @param finder  is asked for blocks that are neighbours in the source's graph. Where points have weights, that
  ///                names whoever shares a vertex with a block, or with one that it meets without
  template <int dim>
  ContactPoints(const BlockSource<dim>&, const Structure<dim>&,
                const PointFinder<dim>& finder = coincident_points<dim>);

  /// The owned points (block i is owned) first, ascending by id; then those of the halo.
  const std::vector<ContactPoint>& points() const { return points_; }
  int size() const { return static_cast<int>(points_.size()); }
  int owned() const { return owned_; }
  /// Of displacements and forces: 2 in the plane, 3 in space.
  int components() const { return components_; }
  /// What a point does to its nodes.
  PointOperator at(int point) const { return {points_[point], components_}; }
  const std::vector<Joint>& joints() const { return joints_; }
  std::vector<Joint>& joints() { return joints_; }
  const Joint& joint_of(int point) const { return joints_[points_[point].joint]; }
  PointId total() const { return total_; }
  long long total_joints() const { return total_joints_; }
  const Exchange& exchange() const { return *exchange_; }
  /// 1 for points that are no pair of coincident nodes, which nothing can tie; empty where all are.
  std::vector<char> untieable() const;
  /// Turns the axes of every point as far as its two blocks have turned from their drawing in the mean. Blocks that
  /// meet at a vertex and have turned alike count as turned by their mean: then points of faces that were one plane as
  /// drawn are in one, where three of them could not be closed at once if each had a plane of its own. Collective.
  /// @param alike  [rad] by which blocks that have turned alike differ at most
  template <int dim>
  void turn_axes(const Structure<dim>&, double alike);

 private:
  template <int dim>
  void find(const BlockSource<dim>&, const Structure<dim>&, const PointFinder<dim>&);
  void number(const BlockSystem&);

  int components_;
  std::vector<ContactPoint> points_;
  std::vector<Joint> joints_;
  int owned_ = 0;
  PointId total_ = 0;
  long long total_joints_ = 0;
  std::unique_ptr<Exchange> exchange_;
  std::vector<std::array<Vector<3>, 3>> drawn_axes_;  ///< of points that have been followed
};

/// The relative motions of all points [points x components], written over.
/// @param u  on node copies
void relative_motions(const ContactPoints&, const std::vector<double>& u, std::vector<double>& motions);

/// Whether a point holds its two nodes together, or others at its place do.
/// @param cluster  per local node copy, nodes with one number move together
inline bool is_tied(const ContactPoint& p, const std::vector<int>& cluster) {
  return p.coincident && cluster[p.shares_i.first()] == cluster[p.shares_j.first()];
}

/// What nodes that a tied point holds together have in common.
inline int cluster_of_tied(const ContactPoint& p, const std::vector<int>& cluster) {
  return cluster[p.shares_i.first()];
}

extern template ContactPoints::ContactPoints(const BlockSource<2>&, const Structure<2>&, const PointFinder<2>&);
extern template ContactPoints::ContactPoints(const BlockSource<3>&, const Structure<3>&, const PointFinder<3>&);

}  // namespace voussoir

// Where blocks meet: contact points, pairs of coincident nodes on one joint.
//
// Conventions  The normal of a point runs from its block i (the lower number) to block j.
//              Component 0 of a gap or force is normal, the others tangential.
//              Gap [m] > 0 is open; normal force [N] > 0 is compression.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "blocks/structure.hpp"

namespace voussoir {

template <int dim>
struct ContactPoint {
  PointId id = 0;                       ///< the same for any number of ranks: ordered by block i, block j, vertex
  int node_i = 0;                       ///< local node of block i
  int node_j = 0;                       ///< local node of block j
  int joint = 0;                        ///< local number of the joint
  double area = 0;                      ///< [m2] share of the joint, thickness included
  std::array<Vector<dim>, dim> axis{};  ///< [0] normal, then tangents; orthonormal, right-handed
};

/// How much further block j moves than block i at a point, along its axes.
/// @param u  on node copies, dim numbers each
template <int dim>
Vector<dim> relative_motion(const ContactPoint<dim>& p, const std::vector<double>& u) {
  Vector<dim> motion{};
  for (int a = 0; a < dim; ++a)
    for (int c = 0; c < dim; ++c) motion[a] += (u[dim * p.node_j + c] - u[dim * p.node_i + c]) * p.axis[a][c];
  return motion;
}

/// A joint: all points between two blocks.
struct Joint {
  BlockId block_i = 0, block_j = 0;
  int family = 0;  ///< index into the scene's joint laws
};

/// All contact points geometry allows (the candidates) between blocks of this rank and its halo.
template <int dim>
class ContactPoints {
 public:
  ContactPoints(const BlockSource<dim>&, const Structure<dim>&);

  /// The owned points (block i is owned) first, ascending by id; then those of the halo.
  const std::vector<ContactPoint<dim>>& points() const { return points_; }
  int size() const { return static_cast<int>(points_.size()); }
  int owned() const { return owned_; }
  const std::vector<Joint>& joints() const { return joints_; }
  std::vector<Joint>& joints() { return joints_; }
  PointId total() const { return total_; }
  long long total_joints() const { return total_joints_; }
  const Exchange& exchange() const { return *exchange_; }
  /// Turns the axes of every point as far as its two blocks have turned from their drawing in the mean; in the
  /// plane alone.
  void follow(const Structure<dim>&);

 private:
  std::vector<ContactPoint<dim>> points_;
  std::vector<Joint> joints_;
  int owned_ = 0;
  PointId total_ = 0;
  long long total_joints_ = 0;
  std::unique_ptr<Exchange> exchange_;
  std::vector<Vector<dim>> drawn_normal_;  ///< of points that have been followed
};

/// The relative motions of all points [points x components], written over.
/// @param u  on node copies, dim numbers each
template <int dim>
void relative_motions(const ContactPoints<dim>& points, const std::vector<double>& u, std::vector<double>& motions) {
  motions.resize(static_cast<std::size_t>(dim) * points.size());
  for (int k = 0; k < points.size(); ++k) {
    const auto motion = relative_motion(points.points()[k], u);
    std::copy(motion.begin(), motion.end(), motions.begin() + static_cast<long>(dim) * k);
  }
}

template <>
void ContactPoints<3>::follow(const Structure<3>&);
extern template class ContactPoints<2>;
extern template class ContactPoints<3>;

}  // namespace voussoir

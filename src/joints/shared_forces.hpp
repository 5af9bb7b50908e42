// Forces that nothing tells apart: where three stones meet, three points see two relative motions, and forces that run
// round between the stones change neither equilibrium nor motion. Of all splits that the law admits this takes the one
// with the least sum of force^2 / w, as for tied points (tractions.hpp). It is unique.
//
//   minimise  sum |f_k + d_k|^2 / w_k     d in balance at every node that no support holds, and
//             d_k = 0 where a point is open, along its friction where it slips, free where it sticks
//             f_k + d_k lawful where it sticks, as far as such splits exist
//
// Where a point slips beside one that opens and still sticks along the same line, friction that follows the pressure
// leaves no such d, and yet nothing binds the pressure: every share of it has a motion of its own that the law admits.
// So once an equilibrium is found friction is held where forces could then run round in more ways, and what that
// leaves out of balance is solved for, until the split changes nothing. Within a solve it follows, as Newton's method
// wants it.
//
// In space friction is bounded by a disc, which half planes that touch it stand for: in the direction of a force that
// they leave outside there is one more, until none is left. So bounds may be nearly parallel, and the least split
// within them is found exactly (base/half_spaces.hpp): a method that sweeps over bounds does not get there.
#pragma once

#include <vector>

#include "blocks/held.hpp"
#include "joints/contact_points.hpp"
#include "joints/point_freedom.hpp"

namespace voussoir {

class SharedForces {
 public:
  /// @param cluster  per local node copy, nodes with one number move together
  /// @param held     per cluster and component: 1 where a support bears what is left
  /// @param counts   per point: 1 where its force is one of those sought. Of points with weights none is: what a joint
  ///                 bears where meshes do not match is told by the nodes of the side that has one node a point
  SharedForces(const BlockSystem&, const ContactPoints&, const std::vector<int>& cluster, const Held& held,
               const std::vector<char>& counts);

  bool any() const { return !places_.empty(); }
  /// Splits the forces [N, points x components] anew where points of owned nodes meet; the caller updates ghosts.
  void split(const std::vector<PointFreedom>&, SharedFriction, std::vector<double>& lambda) const;

 private:
  /// Points that meet, and the balance of their nodes.
  struct Place {
    std::vector<int> points;
    std::vector<double> weight;  ///< [m2] per point
    std::vector<std::vector<double>>
        balance;  ///< per node and component: coefficients of the forces, one per component of each point
  };
  void split(const Place&, const std::vector<PointFreedom>&, SharedFriction, std::vector<double>& lambda) const;

  std::size_t components_;
  std::vector<Place> places_;
};

}  // namespace voussoir

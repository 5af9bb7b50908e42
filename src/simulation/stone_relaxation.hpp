// Stones let go as rigid bodies between springs, until each is in balance or moves on and on.
//
// The springs are the contact points, each with its local stiffness and its law; what holds is told by motion, as in
// the structure itself: a stone that opens its joints, slides on all of them or tips over an edge finds no balance,
// a wedge finds one where it is pressed and none where it would have to be. A stone takes half the step that balances
// it between neighbours that stay, as all move at once, and as if every spring held: so it never moves farther than
// the stiffest of its neighbours could bear. Owners compute the steps, so that ranks do not matter.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "simulation/model.hpp"

namespace voussoir {

/// A stone in plane: two displacements [m] and a turn [rad] about its middle, or the force [N] and moment [N m].
using StoneVector = std::array<double, 3>;

/// Of a force and moment: the force, or the moment over the radius of the stone [N].
inline double size_of(const StoneVector& v, double radius) {
  return std::max(std::hypot(v[0], v[1]), std::abs(v[2]) / radius);
}

/// A block as one rigid body.
struct Stone {
  Vector<2> middle{};      ///< [m] of its nodes
  double radius = 0;       ///< [m] of the node farthest from there
  StoneVector lacks{};     ///< force and moment that it lacks at first
  double bearable = 0;     ///< [N] of force, or moment over radius, that it may lack
  StoneVector support{};   ///< [N/m, N/m, N m] stiffness of what holds its nodes
};

/// A contact point as a spring with a law.
struct StonePoint {
  PointLaw law;
  Vector<2> force{};      ///< [N] lawful, at first: normal, tangential
  Vector<2> stiffness{};  ///< [N/m] normal, tangential
  double gap = 0;         ///< [m] open at first
};

class StoneRelaxation {
 public:
  /// Collective.
  /// @param stones  per local block; those of the halo need no more than their middle
  /// @param points  per local point
  StoneRelaxation(const Model<2>&, std::vector<Stone> stones, const std::vector<StonePoint>& points);

  /// Lets the stones go. Returns per owned block the force that it still lacks, or the moment over its radius [N].
  /// Collective.
  std::vector<double> relax();
  /// The force, or moment over its radius, that an owned stone still lacks where it lacks least [N]: it begins with a
  /// lack, stones that ride on it move along, all others stay, and it stops where that is bearable. To be asked before
  /// relax().
  double alone(int block, const StoneVector& lacks, double bearable, const std::function<bool(int block)>& rides);

 private:
  struct Link {
    int point;
    int other;      ///< local block on the other side
    double sign;    ///< of the point's force on this stone
    Vector<2> arm;  ///< [m] from the middle of the stone
  };
  Vector<2> motion_of(int block, int node, const ContactPoint<2>&) const;
  void update_force(int point);
  StoneVector lacking(int block) const;
  StoneVector step_of(int block, const StoneVector& lack) const;
  void move(std::vector<double>& steps);

  const Model<2>& model_;
  std::vector<Stone> stones_;
  const std::vector<StonePoint>& points_;
  Exchange exchange_;                     ///< of blocks
  std::vector<std::vector<Link>> links_;  ///< of local blocks
  std::vector<Vector<2>> force_;          ///< [N] of points at the present place
  std::vector<StoneVector> place_, way_;  ///< of local blocks: from where they began, and in the last sweep
  std::vector<StoneVector> lack_;         ///< of owned blocks
};

}  // namespace voussoir

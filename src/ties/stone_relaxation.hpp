// Stones let go as rigid bodies between springs, until each is in balance or moves on and on.
//
// The springs are the contact points, alike in stiffness, each with its law; what holds is told by motion, as in the
// structure itself: a stone that opens its joints, slides on all of them or tips over an edge finds no balance,
// a wedge finds one where it is pressed and none where it would have to be. A stone takes half the step that balances
// it between neighbours that stay, as all move at once, and as if every spring held: so it never moves farther than
// the stiffest of its neighbours could bear. Owners compute the steps, so that ranks do not matter.
//
// Forces follow from where stones are alone, not from how they came there. So the places where balance was found are
// kept, and asked first under the next forces: where they balance these too, as at rest from one time step to the next,
// nothing is searched. Where they do not, the search begins as if there had been none.
#pragma once

#include <optional>
#include <vector>

#include "model/model.hpp"
#include "ties/stone_vector.hpp"

namespace voussoir {

/// A block as one rigid body.
template <int dim>
struct Stone {
  Vector<dim> middle{};        ///< [m] of its nodes
  double radius = 0;           ///< [m] of the node farthest from there
  StoneVector<dim> support{};  ///< [N/m, N m] stiffness of what holds its nodes
  int rides_on = -1;           ///< local block without which it would be cut off from every support; -1 for none here
};

/// A contact point as a spring with a law.
template <int dim>
struct StonePoint {
  PointLaw law;
  Vector<dim> force{};  ///< [N] lawful, at first: normal, tangential
  double gap = 0;       ///< [m] open at first
};

/// Where no stone finds a better place.
struct RelaxedStones {
  std::vector<double> lacks;  ///< [N] of force, or moment over radius, per owned block
  bool any_loose = false;     ///< some stone of some rank lacks more than it may, or was loose already
};

template <int dim>
class StoneRelaxation {
 public:
  static constexpr int ways = ways_of_stone(dim);

  /// Collective.
  /// @param stones     per local block
  /// @param stiffness  of every spring [N/m]
  StoneRelaxation(const Model&, std::vector<Stone<dim>> stones, double stiffness);

  /// Takes the stones back to where they are.
  /// @param points  per local point
  /// @param lacks   force and moment that each owned stone lacks at first
  void begin(std::vector<StonePoint<dim>> points, std::vector<StoneVector<dim>> lacks);
  const std::vector<Stone<dim>>& stones() const { return stones_; }
  /// Half the magnitudes of the forces of its points: what passes through a local block at first [N].
  double passing(int block) const;
  /// The force, or moment over its radius, that an owned stone still lacks where it lacks least [N]: it begins with a
  /// lack, stones that ride on it move along, all others stay, and it stops where that is bearable. To be asked before
  /// relax().
  double alone(int block, const StoneVector<dim>& lacks, double bearable);
  /// Lets all stones go. Collective.
  /// @param bearable  [N] of force, or moment over radius, that each owned stone may lack
  /// @param loose     stones of this rank that are loose already
  RelaxedStones relax(const std::vector<double>& bearable, int loose);

 private:
  struct Link {
    int point;
    int other;        ///< local block on the other side
    bool rides;       ///< that block rides on this one
    double sign;      ///< of the point's force on this stone
    Vector<dim> arm;  ///< [m] from the middle of the stone
  };
  struct Lacking {
    double stones = 0, force = 0;  ///< that lack more than they may and can move, and what they lack together [N]
    double stuck = 0;              ///< stones that lack more than they may and touch no point
  };
  enum class Neighbours { all, that_stay };
  Vector<dim> motion_of(int point, Side) const;
  Vector<dim> axis_of(int point, int component) const;
  void update_force(int point);
  StoneVector<dim> lacking(int block, const StoneVector<dim>& at_first, Neighbours) const;
  StoneVector<dim> step_of(int block, const StoneVector<dim>& lack, Neighbours) const;
  void take_back();
  void go_to(const std::vector<StoneVector<dim>>& places);
  Lacking measure(std::vector<double>& lacks) const;
  std::vector<double> steps(const std::vector<double>& lacks) const;
  void move(std::vector<double> steps);
  void take_up(const std::vector<int>& moved);

  const Model& model_;
  const TieParameters numbers_;
  std::vector<Stone<dim>> stones_;
  double stiffness_;
  Exchange exchange_;                             ///< of blocks
  std::vector<std::vector<Link>> links_;          ///< of local blocks
  std::vector<std::array<Vector<dim>, 2>> arms_;  ///< [m] of points, from the middles of their stones i and j
  std::vector<StonePoint<dim>> points_;
  std::vector<StoneVector<dim>> lacks_;  ///< at first, of owned blocks
  std::vector<double> bearable_;         ///< of owned blocks
  std::vector<Vector<dim>> force_;       ///< [N] of points at the present place
  std::vector<StoneVector<dim>> place_,
      way_;                                    ///< of local blocks: from where they began, and in the last sweep
  std::vector<StoneVector<dim>> lack_;         ///< of owned blocks
  std::vector<StoneVector<dim>> known_alone_;  ///< of local blocks: where balance was found, alone
  /// And together: of local blocks. All ranks have a list or none has, one of no stones where there are none.
  std::optional<std::vector<StoneVector<dim>>> known_;
};

extern template class StoneRelaxation<2>;
extern template class StoneRelaxation<3>;

}  // namespace voussoir

// What one load step adds to the energy book.
//
// External work is that of loads and moved supports, forces times ways. Of both only the ends of a step are known, so
// it is the mean of forces, which is exact where stones only deform, and what joints that slip or crack within the step
// make of it: their force goes to its bound first, and only there it slips, or falls on the law's own way
// (joints/crack_work). The mean of bounds, or the work on that way, stands in the place of the mean of their forces. A
// stone that is pushed to and fro costs force times way, however long a step is. But the forces of loads and supports
// decide how much that can be: while they go from those at the start to those at the end they do no less than the
// lesser of the two, and no more than the larger and what joints bore beyond both. So what laws say of a step can be
// off by no more than its size.
//
// A jump. Where the law's own way would have loads do less than that, by more than can be meant by the latter, it is no
// way of equilibria: the structure let go faster than it was moved, as a bar that snaps. Then loads do the work of
// their mean, and what joints did not take of the energy let go is lost in the jump.
//
// After time steps. What moves is in no equilibrium: inertia bears a part of the loads. Load steps know none, so that
// part lets go within the first of them, from what it was to none, and what it does on that way is removed, as is the
// kinetic energy. That is exact where the way is straight.
//
// Friction takes the force at the end of the step times the slip, as the return mapping of the solver has it
// (joints/friction_work.hpp). What is left is the imbalance: slips under a pressure that changes within the step (the
// bound at its end less the mean of bounds), pressure of joints that open or close within it, and a share of t^2/12 of
// what reactions do that turn with a support by t (results/turning_supports.hpp). It goes with their size.
#pragma once

#include "dynamics/energy_book.hpp"
#include "joints/crack_work.hpp"
#include "model/model.hpp"
#include "step/adaptive_step.hpp"

namespace voussoir {

/// Of loads and moved supports in a step [J].
struct WorkOfForces {
  double of_mean = 0;              ///< of the mean of forces at its ends
  double change_of_loads = 0;      ///< of that of loads within it, on what no support holds
  double change_of_reactions = 0;  ///< likewise, of reactions on what supports move
};

/// External work of a step, and what was lost in a jump.
/// @param beyond_mean  [J] work of joints on the law's way beyond that of the mean of their forces
/// @param overshoot    [J] of that, no more than what they bore beyond their forces at both ends. Where a law's way
///                     leaves the range of forces on the other side by less, it may be that it was not straight: no
///                     jump is told, and what is lacking is imbalance
/// @param jumped       the solver has seen the step jump
void add_work(const WorkOfForces&, double beyond_mean, double overshoot, bool jumped, EnergyOfStep&);

/// Opened before a load step is solved, where stones stand at its start; closed after it.
class LoadStepBook {
 public:
  /// @param before, load_before  state and nodal loads [N] at the start; both must outlive the book
  /// @param let_go  forces of stones that are gone, none at the end [N]; what they do is removed, and no work of loads
  /// @param from_motion  whether the structure had velocities there, which the state has no more
  LoadStepBook(const Model&, const AdaptiveStep&, const ContactState& before, const std::vector<double>& load_before,
               std::vector<double> let_go = {}, bool from_motion = false);

  /// Collective.
  /// @param after, load  state and nodal loads [N] at the end, where stones stand now
  /// @param jumped  whether the solver has seen cracks grow in a jump
  EnergyOfStep close(const ContactState& after, const std::vector<double>& load, bool jumped = false) const;
  const ContactState& before() const { return before_; }

 private:
  struct OfPoints {
    double friction = 0, fracture = 0;
    double held = 0;         ///< that open joints would give back
    double beyond_mean = 0;  ///< that the mean of forces leaves out of the work of loads and reactions
    double overshoot = 0;    ///< that they may have done under forces beyond those at both ends
  };
  OfPoints of_points(const ContactState& after) const;
  CrackWork add_fracture(const ContactState& after, const PointField& gap, int k, OfPoints&) const;
  template <int dim>
  void add_friction(const ContactState& after, const PointField& gap, const CrackWork&, int k, OfPoints&) const;

  const Model& model_;
  const AdaptiveStep& step_;
  const ContactState& before_;
  const std::vector<double>& load_before_;
  const std::vector<double> let_go_;
  const bool from_motion_;
  std::vector<double> reaction_before_;  ///< [N]
  PointField gap_before_;                ///< [m] of stones, gap and slip along the axes of the start
};

}  // namespace voussoir

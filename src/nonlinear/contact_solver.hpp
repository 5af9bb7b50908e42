// Closing the contact conditions of one load step or time step: the fast way first, the sure ways after it.
//
//   1  active sets, where they have not failed of late
//   2  interior path, whatever changes; near its end active sets again, which then have the statuses,
//      unless loose stones stopped them
//   3  pseudo-time from where the path ends, when it ends early; it also tells a collapse from slow progress.
//      Where it takes long, another path from the state it has reached, and so on with twice the patience
//
// Without contact points the system is linear. Where joints soften, 2 and 3 are gone with strength that is held, and 1
// with strength that falls (wear_down); method.md, section 6.
//
// Ends   converged      a state whose equilibrium and contact residuals, each the largest component by the largest
//                       force in play, are no more than the tolerance (size of residuals.hpp), as measured here or, by
//                       its own header, by the method that arrived
//        collapse       pseudo-time has found a motion without end
//        not_converged  no linear solves are left, a way is switched off, or a library refused systems: `reason`
//        stopped        whoever watches wanted no more
// Back   x, lambda and damage. Converged, forces that nothing tells apart are split in the one way, and the report has
//        residuals and penetration of that; `round_off` where round-off is what keeps them above the tolerance,
//        `lost_on_the_way` and `unstable` where joints soften. Else the state in which the last way ended.
#pragma once

#include "nonlinear/active_set.hpp"
#include "nonlinear/fast_way.hpp"
#include "nonlinear/interior_path.hpp"
#include "nonlinear/iterate.hpp"
#include "nonlinear/method_parameters.hpp"
#include "nonlinear/pseudo_time.hpp"

namespace voussoir {

struct Instability;

/// What is asked of a solve.
struct ContactRequest {
  double tolerance;  ///< Karush-Kuhn-Tucker residual relative to the largest force; may be looser than the parameters'
  /// Held: what is found only shows where joints are overloaded, and nothing is lost.
  StrengthIs strength = StrengthIs::falling;
  /// Gaps of a state in equilibrium with the forces of the start, that supports and loads have left; may be null.
  const PointField* known_gap = nullptr;
};

class ContactSolver {
 public:
  ContactSolver(NonlinearProblem&, const NewtonParameters&, const MethodParameters&, FastWay&);

  /// Told and asked after each linear solve; may be empty.
  SolveWatch watch;

  /// Solves from a state whose held unknowns are at their prescribed values. On collapse x holds the run-away state and
  /// mechanism() its direction.
  NewtonReport solve(const Iterate&, const ContactRequest&);

  /// Displacement of the last step in pseudo-time, scaled to a largest component of 1.
  const TpetraVector& mechanism() const { return *mechanism_; }

 private:
  double measure(const Iterate&, StrengthIs, NewtonReport&) const;
  void solve_linear(const Iterate&, const ContactRequest&, NewtonReport&);
  /// The ways in their order. Leaves the outcome in the report.
  void go_the_ways(const Iterate&, ContactRequest, NewtonReport&);
  /// Where it leads away from equilibrium the state stays as it was.
  /// @param shortcut  whether active sets may take over near the end
  PathEnd along_the_path(const Iterate&, const ContactRequest&, bool shortcut, NewtonReport&);
  /// Where strength that falls keeps active sets from arriving: strength is held, an equilibrium is found with it, what
  /// that opens wears, and so on. Leaves the outcome in the report.
  void wear_down(const Iterate&, const ContactRequest&, NewtonReport&);
  /// Without the damage of the states on the way to this equilibrium, where there is one close by that does without.
  /// Else leaves in the report how much more has been lost.
  void forget_the_way(const Iterate&, double tolerance, NewtonReport&);
  void find_stable_branch(const Iterate&, double tolerance, NewtonReport&);
  void crack_one_by_one(const Iterate&, double tolerance, int left, NewtonReport&);
  bool close_needless_cracks(const Iterate&, double tolerance, int left, NewtonReport&);
  bool leave_branch(const Instability&, double sign, const Iterate&, double tolerance, NewtonReport&);
  void finish(const Iterate&, const ContactRequest&, NewtonReport&);
  void split_forces(const Iterate&, const ContactRequest&, NewtonReport&);
  void leave_the_way(const Iterate&, const ContactRequest&, NewtonReport&);
  bool solve_from(const Iterate&, const ContactRequest&, NewtonReport&);
  void go_the_hard_way(const Iterate&, const ContactRequest&, NewtonReport&);
  void tell_undetermined(const PointField& found, const PointField& split, NewtonReport&) const;
  void in_pseudo_time(const Iterate&, const ContactRequest&, int most, NewtonReport&);
  /// Are active sets to be tried now? Counts what they wait for.
  bool may_be_fast();
  /// Where they do not arrive the state stays as it was.
  ActiveSetEnd try_active_set(const Iterate&, const ContactRequest&, int patience, NewtonReport&);

  NonlinearProblem& problem_;
  NewtonParameters parameters_;
  MethodParameters methods_;
  FastWay& fast_;
  Teuchos::RCP<TpetraVector> mechanism_;
};

}  // namespace voussoir

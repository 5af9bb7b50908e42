// Closing the contact conditions of one load step or time step: the fast way first, the sure ways after it.
//
//   1  active sets, where they have not failed of late
//   2  interior path, whatever changes; near its end active sets again, which then have the statuses,
//      unless loose stones stopped them
//   3  pseudo-time from where the path ends, when it ends early; it also tells a collapse from slow progress.
//      Where it takes long, another path from the state it has reached, and so on with twice the patience
//
// Without contact points the system is linear.
#pragma once

#include "nonlinear/active_set.hpp"
#include "nonlinear/fast_way.hpp"
#include "nonlinear/interior_path.hpp"
#include "nonlinear/method_parameters.hpp"
#include "nonlinear/pseudo_time.hpp"

namespace voussoir {

struct Instability;

class ContactSolver {
 public:
  ContactSolver(NonlinearProblem&, const NewtonParameters&, const MethodParameters&, FastWay&);

  /// Told and asked after each linear solve; may be empty.
  SolveWatch watch;

  /// Strength stays as it is wherever points open or slip to: what is found only shows where joints are overloaded.
  void hold_strength() { holds_strength_ = problem_.softening() != nullptr; }

  /// Solves from x (held unknowns already at their prescribed values) and contact forces lambda [N].
  /// @param tolerance  Karush-Kuhn-Tucker residual relative to the largest force; may be looser than the parameters'
  /// @param known_gap  gaps of a state in equilibrium with lambda that supports and loads have left; may be null
  /// On collapse x holds the run-away state and mechanism() its direction.
  NewtonReport solve(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap = nullptr);

  /// Displacement of the last step in pseudo-time, scaled to a largest component of 1.
  const TpetraVector& mechanism() const { return *mechanism_; }

 private:
  double measure(const TpetraVector& x, const PointField& lambda, NewtonReport&) const;
  void solve_linear(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport&);
  /// The ways in their order. Leaves the outcome in the report.
  void go_the_ways(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap, NewtonReport&);
  /// Where it leads away from equilibrium the state stays as it was.
  /// @param shortcut  whether active sets may take over near the end
  PathEnd along_the_path(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap,
                         bool shortcut, NewtonReport&);
  /// Where strength that falls keeps active sets from arriving: strength is held, an equilibrium is found with it, what
  /// that opens wears, and so on. Leaves the outcome in the report.
  void wear_down(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap, NewtonReport&);
  /// Without the wear of the states on the way to this equilibrium, where there is one close by that does without. Else
  /// leaves in the report how much more has been lost.
  void forget_the_way(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport&);
  void find_stable_branch(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport&);
  bool leave(const Instability&, double sign, TpetraVector& x, PointField& lambda, double tolerance, NewtonReport&);
  void finish(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport&);
  void split_forces(const TpetraVector& x, PointField& lambda, double tolerance) const;
  void in_pseudo_time(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap, int most,
                      NewtonReport&);
  /// Are active sets to be tried now? Counts what they wait for.
  bool may_be_fast();
  /// Where they do not arrive the state stays as it was.
  ActiveSetEnd try_active_set(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap,
                              int patience, NewtonReport&);

  NonlinearProblem& problem_;
  NewtonParameters parameters_;
  MethodParameters methods_;
  FastWay& fast_;
  bool holds_strength_ = false;
  Teuchos::RCP<TpetraVector> mechanism_;
};

}  // namespace voussoir

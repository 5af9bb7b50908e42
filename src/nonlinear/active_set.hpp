// The short way: each linear solve takes the statuses that the last state asks for, friction follows the pressure,
// forces follow as far as points resist.
//
// A point that is closed resists with R, far above the local stiffness, so what is left of its gap falls by that ratio
// with every solve; one that slips has the force s mu p. Once statuses stay, two or three solves are left. A stone that
// comes loose on the way would fly: then the step is made again with points that yield only slowly. With mass steps are
// shortened while residuals grow. It may circle: then it says so, and another way is taken.
//
// Theory   P. Alart, A. Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991) 353-375 (generalised Newton, 2D);
//          M. Hintermueller, K. Ito, K. Kunisch, SIAM J. Optim. 13 (2002) 865-888 (active sets as Newton's method).
#pragma once

#include <functional>

#include "nonlinear/method_parameters.hpp"
#include "nonlinear/newton_report.hpp"
#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir {

/// Where active sets ended: at a solution, nowhere since they circle or take too long, or before stones that next to
/// nothing holds.
enum class ActiveSetEnd { arrived, circled, loose_stones };

/// What is solved: a structure at rest, one whose blocks have mass, and no free motions, or a patch, where solves are
/// direct and loose stones can be moved on.
enum class ActiveSetUse { at_rest, in_time, in_patch };

class ActiveSet {
 public:
  /// @param problem   with two components
  /// @param patience  so many solves that gain less than half: it circles
  ActiveSet(NonlinearProblem& problem, ActiveSetUse, const MethodParameters&, int patience);

  /// Called after each linear solve; may be empty.
  std::function<void(const NewtonProgress&)> narrate;

  /// Solves from x and contact forces lambda [N], which are somewhere unless it arrives, in a patch where they were
  /// nearest to rest.
  /// @param known_gap  gaps that tell the first statuses, of a state that supports and loads have left; may be null
  /// @param report     gains what is done, and the residuals
  ActiveSetEnd solve(TpetraVector& x, PointField& lambda, double tolerance, int largest_solves,
                     const PointField* known_gap, NewtonReport& report);

 private:
  bool in_time() const { return use_ == ActiveSetUse::in_time; }
  void choose(const PointField& lambda, const PointField& gap, bool in_balance);
  bool same_statuses(const std::vector<PointStiffness>& resistance, const std::vector<double>& sliding) const;
  void set_statuses(const PointField& lambda, const PointField& gap, const std::vector<double>& before);
  void aim(const PointField& lambda);
  double accuracy_of_next(double tolerance, const NewtonReport&) const;
  LinearSolveResult step(TpetraVector& x, PointField& lambda, double damping, double relative_tolerance, int most);
  bool correct_locally(TpetraVector& x, PointField& lambda, double tolerance, const TpetraVector& start, double known,
                       double& size, NewtonReport&);
  void move_loose_stones(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport&);
  double step_length(const PointField& lambda) const;
  double measure(const TpetraVector& x, const PointField& lambda, NewtonReport&);
  void tell(const NewtonReport&, int krylov, int local_solves = 0) const;

  NonlinearProblem& problem_;
  const ActiveSetParameters numbers_;
  const PatchParameters patches_;
  ActiveSetUse use_;
  double augmentation_, proximal_;
  const int most_patience_;
  int patience_;
  std::vector<PointStiffness> resistance_;
  std::vector<double> sliding_;  ///< per point: direction of friction, 0 where it sticks or is open
  bool settled_ = false;         ///< statuses are those of the last solve; where that is asked
  std::vector<char> stops_;      ///< 1 where a loose stone has come to a stop
  PointField target_, force_, gap_, gap_direction_, admissible_;
  double scale_ = 1;   ///< [N]
  double length_ = 1;  ///< of the last step
  Teuchos::RCP<TpetraVector> linear_, gradient_, direction_;
};

}  // namespace voussoir

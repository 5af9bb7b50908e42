// The way to the neighbourhood of a solution: an infeasible interior-point method for contact with friction.
//
// Each inequality of the contact law gets a slack w >= 0 for its force and y >= 0 for its motion,
//
//   opening    w = p + tensile strength    y = g_N
//   slipping   the disc |q| <= b and the slip g_T - g_T0, of one tangent or two: friction_disc.hpp,
//              b = cohesion + mu p
//
// and Newton follows the path w y = nu as nu falls. A point resists with 1 / (y/w + 1/k), a number between nothing and
// a multiple k of its local stiffness (along a joint a matrix of such numbers), so each linear system looks like those
// of active sets and all statuses of all points move at once: no collision of points cuts a step to nothing. k rises as
// nu falls. The friction bound b follows the pressure within a step, which makes the systems unsymmetric; past a fold
// of the path it follows less.
// Decisions: README.md of this folder.
//
// Ends   Before every step the state is judged: equilibrium and contact (residuals.hpp), by the largest force in play
//        at the start, with the forces of the path, which keep a distance from their bounds.
//        arrived   their size is no more than the tolerance, and no more either once the forces are made admissible;
//                  or the shortcut has arrived
//        stuck     friction follows as little as it may, and in `patience` steps the larger residual has fallen by less
//                  than a tenth (gained), and so has equilibrium, unless it is below a tenth (balanced) of contact; or
//                  no steps are left, or a library refused a system
//        ran_away  an unknown has moved by more than a fifth (run away) of the structure
//        stopped   whoever watches wanted no more
// Back   Arrived or stuck, x and admissible forces: those of open points what they pull with, the others within their
//        bounds. After ran_away both as they were. Stopped, x and the forces of the path.
//
// Theory   S. J. Wright, Primal-Dual Interior-Point Methods, SIAM 1997, chapters 4 to 6;
//          S. Pougkakiotis, J. Gondzio, Comput. Optim. Appl. 78 (2021) 307-351 (proximal multipliers, here 1/k).
#pragma once

#include <array>
#include <functional>

#include "nonlinear/friction_disc.hpp"
#include "nonlinear/method_parameters.hpp"
#include "nonlinear/newton_report.hpp"
#include "nonlinear/nonlinear_problem.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"

namespace voussoir {

/// Where a path ended: at its aim, where it led no further, nowhere, as the structure moved without end, or where no
/// more solves were wanted.
enum class PathEnd { arrived, stuck, ran_away, stopped };

class InteriorPath {
 public:
  /// @param strength  with its damage where joints soften
  InteriorPath(NonlinearProblem&, const MethodParameters&, Strength strength = {});

  /// Told and asked after each linear solve; may be empty.
  SolveWatch watch;
  /// A shorter way to the end, tried when a solution is near, and again as it comes nearer; false when it leads
  /// nowhere, which leaves x and lambda as they were. May be empty.
  std::function<bool(TpetraVector& x, PointField& lambda)> shortcut;

  /// Moves x and lambda [N] to a state whose residuals are below tolerance x the largest force; held unknowns of x
  /// must have their prescribed values. Contact forces end admissible.
  /// @param known_gap  gaps [m] of a state in equilibrium with lambda, from which supports and loads have moved;
  ///                   null when x is near equilibrium with lambda
  /// After PathEnd::ran_away x and lambda are as they were.
  PathEnd trace(TpetraVector& x, PointField& lambda, double tolerance, int largest_iterations,
                const PointField* known_gap, NewtonReport&);

 private:
  struct Point {
    double w = 0, y = 0, dw = 0, dy = 0;  ///< [N], [m] of the opening
    FrictionDisc disc;
    double friction = 0;              ///< [-] change of the bound with the pressure
    InDisc drag;                      ///< [m/N] slip wanted per change of the normal force
    double gain = 0;                  ///< [m] right-hand side of the normal row
    InDisc wanted;                    ///< [m] of the tangential ones
    double normal = 0;                ///< [N/m] resistance without what it pulls back with
    double pulls_back = 0;            ///< [N/m] tension per opening
    bool opens = true, slips = true;  ///< the law bounds the force in this direction
    /// Of an opening that the force has to follow [-].
    double share_of_opening() const { return 1 + (opens ? y / w * pulls_back : 0.0); }
  };

  /// How far a path has come.
  struct Progress {
    std::vector<Imbalance> residuals;  ///< ahead of every step, relative to the scale
    double step = 0;                   ///< length of the last one, 1 where no slack would have vanished
    int changed = 0;                   ///< step at which friction last followed by less
  };

  void predict(TpetraVector& x, PointField& lambda, const PointField& known_gap, NewtonReport&);
  void enter(const PointField& lambda, const PointField& gap, double shift);
  void set_out(PointField& lambda, double shift);
  void resistances(const PointField& lambda, bool predicting);
  void pull_back(const TpetraVector& x, PointField& lambda);
  Imbalance measure(const TpetraVector& x, const PointField& lambda);
  Imbalance residuals(const PointField& lambda);
  double after_projection(PointField lambda);
  bool take_shortcut(TpetraVector& x, PointField& lambda);
  double barrier() const;
  void set_right_hand_side(const PointField& lambda, double target);
  LinearSolveResult solve(NewtonReport&);
  double step_length();
  bool is_near(const Imbalance&) const;
  bool gains_too_little(const Progress&) const;
  bool follow_less(Progress&);
  LinearSolveResult step(TpetraVector& x, PointField& lambda, Progress&, NewtonReport&);
  void project_to_admissible(PointField& lambda) const;
  void report_progress(NewtonReport&, double equilibrium, double contact, int krylov, double step) const;
  double bound(int point, double normal) const;
  double friction(int point, double normal) const;
  std::size_t first_of(int point) const { return static_cast<std::size_t>(point) * components_; }
  std::array<double, 2> slip(int point, const PointField& gap, const PointField& lambda) const;

  NonlinearProblem& problem_;
  const InteriorPathParameters numbers_;
  const double run_away_;
  const int components_;
  CurrentLaws laws_;
  std::vector<Point> path_;
  std::vector<PointStiffness> resistance_;
  PointField gap_, gap_direction_, force_;
  Teuchos::RCP<TpetraVector> linear_, gradient_, direction_, work_;
  double augmentation_ = 1;  ///< largest resistance of a point, relative to its local stiffness
  double follows_ = 1;       ///< share of the pressure's change that the friction bound follows within a step
  double scale_ = 1;         ///< [N]
};

}  // namespace voussoir

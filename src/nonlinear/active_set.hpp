// The short way: each linear solve takes the statuses that the last state asks for, friction follows the pressure,
// forces follow as far as points resist.
//
// A point that is closed resists with R, far above the local stiffness, so what is left of its gap falls by that ratio
// with every solve; one that slips along s has the force s mu p, and in space it resists across s with mu p over its
// slip, as fast as the direction turns. Once statuses stay, two or three solves are left. A stone that comes loose
// on the way would fly: then the step is made again with points that yield only slowly. It may circle: then it says so,
// and another way is taken.
//
// In time, against a drag and in a patch a step is cut where the imbalance ceases to drive it (driven_share.hpp). At
// rest it is full, which takes fewer solves of most structures (patches.md). In a patch points that give way resist
// less with every step in full, more after one that was cut, for nothing else holds a stone there.
//
// Ends   After every linear solve the state is judged with the forces that the law admits, lambda projected with the
//        bounds of its own pressures: equilibrium and contact (residuals.hpp), by the largest force then in play.
//        arrived       their size is no more than the tolerance
//        circled       so many solves (patience) without one whose size is at most half (gained) of the least before,
//                      or no solves are left; `patience` of the settings in a patch that is at rest and aims at more
//        loose_stones  not in time: a solve of `many krylov` iterations (or `.. in space`) has not gained
//        refused       a library refused the system; in a patch the first, later ones end as circled
//        stopped       whoever watches wanted no more
// Back   Where it arrives x, and lambda as it was judged. Else x and lambda as they were last or, in a patch, where
//        their size was least. The report has the two residuals that were judged last.
//
// Theory   P. Alart, A. Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991) 353-375 (generalised Newton);
//          M. Hintermueller, K. Ito, K. Kunisch, SIAM J. Optim. 13 (2002) 865-888 (active sets as Newton's method);
//          D. W. Marquardt, J. SIAM 11 (1963) 431-441 (resistance that falls with success).
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "nonlinear/method_parameters.hpp"
#include "nonlinear/newton_report.hpp"
#include "nonlinear/nonlinear_problem.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/saved_position.hpp"

namespace voussoir {

/// Where active sets ended: at a solution, nowhere since they circle or take too long, before stones that next to
/// nothing holds, before a system that a library refused, or where no more solves were wanted.
enum class ActiveSetEnd { arrived, circled, loose_stones, refused, stopped };

/// What is solved: a structure at rest, one whose blocks have mass or move against a drag, and no free motions, or a
/// patch, where solves are direct.
enum class ActiveSetUse { at_rest, in_time, in_patch };

class ActiveSet {
 public:
  /// @param patience  so many solves that gain less than half: it circles
  /// @param strength  with its damage where joints soften
  ActiveSet(NonlinearProblem& problem, ActiveSetUse, const MethodParameters&, int patience, Strength strength = {});

  /// Told and asked after each linear solve; may be empty.
  SolveWatch watch;

  /// Solves from x and contact forces lambda [N], which are somewhere unless it arrives, in a patch where they were
  /// nearest to rest.
  /// @param known_gap  gaps that tell the first statuses, of a state that supports and loads have left; may be null
  /// @param report     gains what is done, and the residuals
  ActiveSetEnd solve(TpetraVector& x, PointField& lambda, double tolerance, int largest_solves,
                     const PointField* known_gap, NewtonReport& report);

 private:
  /// How far a search has come.
  struct Search {
    double tolerance = 0;
    int largest_solves = 0;
    double known = std::numeric_limits<double>::infinity();  ///< residual of the start, where it is a measure
    double largest_force = 0;                                ///< [N] at the start
    double size = 0;                                         ///< residual after the last solve
    double best = std::numeric_limits<double>::infinity();   ///< least of those that gained
    double damping = 0;  ///< resistance of points that give way, relative to their local stiffness
    int solves = 0, last_gain = 0;
    bool local = true;  ///< stuck stones may be brought to rest alone
  };
  /// Where a patch was nearest to rest.
  struct Nearest {
    double size = std::numeric_limits<double>::infinity();
    std::unique_ptr<SavedPosition> position;
    PointField lambda;
  };

  bool in_time() const { return use_ == ActiveSetUse::in_time; }
  bool in_patch() const { return use_ == ActiveSetUse::in_patch; }
  void choose(const PointField& lambda, const PointField& gap, bool in_balance);
  void set_status(int point, const PointField& lambda, const PointField& gap, const PointField& before);
  double turning(int point, double share) const;
  void slide(int point, const WeakenedLaw&, double across, bool advances);
  bool same_statuses(const std::vector<char>& closed, const PointField& sliding) const;
  bool turns_round(int point, double shear, const PointField& before);
  double alike(int point, const PointField& before) const;
  bool turned(int point, const PointField& before) const;
  void set_right_hand_side(const PointField& lambda, const PointField& chosen);
  bool set_force_of_law(int point, const PointField& lambda, const PointField& chosen);
  bool slides(int point) const {
    const double* s = &sliding_[std::size_t(point) * (components_ - 1)];
    return std::any_of(s, s + components_ - 1, [](double c) { return c != 0; });
  }
  PointCompliance mortar_of(int point) const;
  double driven_length(const PointField& lambda) const;
  double damping_after(double damping) const;
  double accuracy_of_next(const Search&, const NewtonReport&) const;
  LinearSolveResult step(TpetraVector& x, PointField& lambda, double damping, double relative_tolerance, int most);
  std::optional<ActiveSetEnd> solve_once(TpetraVector& x, PointField& lambda, Search&, NewtonReport&);
  std::optional<ActiveSetEnd> judge_solve(TpetraVector& x, PointField& lambda, const TpetraVector& start, int krylov,
                                          Search&, NewtonReport&);
  bool lost_a_stone(const Search&) const;
  int many_krylov() const { return components_ == 2 ? numbers_.many_krylov : numbers_.many_krylov_in_space; }
  void correct_locally(TpetraVector& x, PointField& lambda, const TpetraVector& start, Search&, NewtonReport&);
  double measure(const TpetraVector& x, const PointField& lambda, NewtonReport&);
  void report_progress(NewtonReport&, int krylov, int local_solves = 0) const;

  NonlinearProblem& problem_;
  const MethodParameters methods_;
  const ActiveSetParameters& numbers_;
  const PatchParameters& patches_;
  const ActiveSetUse use_;
  const int components_;
  double augmentation_;
  const double proximal_;
  const int patience_;
  CurrentLaws laws_;
  std::vector<PointStiffness> resistance_;
  std::vector<char> closed_;  ///< per point
  PointField sliding_;  ///< direction of friction, [points x tangential components]; 0 where a point sticks or is open
  std::vector<double> across_;  ///< [N/m] of points that slip, against motion across their slip
  bool settled_ = false;        ///< statuses are those of the last solve
  PointField target_, force_, gap_, gap_direction_, admissible_;
  PointField change_before_, change_;  ///< [N] of forces by the last two linear solves at full length; empty in patches
  double scale_ = 1;                   ///< [N]
  double length_ = 1;                  ///< of the last step
  Teuchos::RCP<TpetraVector> linear_, gradient_, direction_;
};

}  // namespace voussoir

// What a nonlinear solve did, for history, narration and tests.
#pragma once

#include <functional>
#include <string>

#include "linalg/linear_solve_result.hpp"

namespace voussoir {

/// Stopped: whoever was asked after a linear solve wanted no more. Nothing is told of the state then.
enum class NewtonOutcome { converged, not_converged, collapse, stopped };

/// Whether a solve goes on, as asked after each of its linear solves. The same on every rank.
enum class GoOn { yes, no };

/// One line of the solver's narration.
struct NewtonProgress {
  int iteration = 0;
  double residual = 0;         ///< [N] largest imbalance
  double complementarity = 0;  ///< [N]
  long long closed = 0, slipping = 0;
  int krylov = 0;
  double damping = 1;
  double augmentation = 1;  ///< relative to the local stiffness
  int local_solves = 0;     ///< of patches; 0 unless this is a local correction, after the linear solve of that number
};

/// Told of every linear solve, and asked whether there are to be more; may be empty.
using SolveWatch = std::function<GoOn(const NewtonProgress&)>;

struct NewtonReport {
  NewtonOutcome outcome = NewtonOutcome::not_converged;
  int outer_iterations = 0;   ///< updates of the contact forces
  int newton_iterations = 0;  ///< linear solves
  int failed_solves = 0;      ///< linear solves that ended short of the accuracy asked for
  long long krylov_iterations = 0;
  int largest_krylov = 0;      ///< of one solve
  int local_solves = 0;        ///< linear solves of patches
  double residual = 0;         ///< [-] equilibrium, relative to the largest force
  double complementarity = 0;  ///< [-] contact law, relative to the largest force
  double penetration = 0;      ///< [m]
  double round_off = 0;        ///< [-] larger residual, where round-off leaves more than was asked for; else 0
  double lost_on_the_way = 0;  ///< [-] largest damage of a point beyond what the state found gives it
  double unstable = 0;         ///< [-] by how much the state gives way on its own (stability.hpp); 0 where it does not
  long long unstable_at = -1;  ///< number of the point that softens fastest there
  int alike = 0;               ///< joints that were alike where one was let crack and others stayed; 0 where none was
  long long alike_at = -1;     ///< number of a point of that one
  double undetermined = 0;     ///< [-] by how much forces that stones share could be others, relative to the largest
  long long undetermined_at = -1;  ///< number of the point where that is most
  std::string reason;              ///< why it stopped, when it did not converge
  std::string failure;             ///< what the last of the failed linear solves said
  bool no_way_on = false;          ///< it stopped because a library refused a system
  bool stopped = false;            ///< no more linear solves are wanted: every method ends where it is
  /// The way that comes first did not close the contact conditions, or was left out since it has failed of late. Of
  /// this solve alone.
  bool hard = false;

  /// One more linear solve.
  void count(const LinearSolveResult& solve) {
    ++newton_iterations;
    krylov_iterations += solve.iterations;
    largest_krylov = largest_krylov > solve.iterations ? largest_krylov : solve.iterations;
    if (solve.converged) return;
    ++failed_solves;
    failure = solve.failure;
  }
  /// Tells of it, and asks.
  void show(const SolveWatch& watch, const NewtonProgress& solve) {
    if (watch && watch(solve) == GoOn::no) stopped = true;
  }
  /// Of a solve that ends here.
  void fail(const std::string& why) {
    outcome = NewtonOutcome::not_converged;
    reason = why;
  }
  /// One joint was let crack of several that were alike.
  void choose(int joints, long long number) {
    if (joints < 2 || joints <= alike) return;
    alike = joints;
    alike_at = number;
  }
  /// What another solve took, whatever it came to.
  void add_work(const NewtonReport& other) {
    outer_iterations += other.outer_iterations;
    newton_iterations += other.newton_iterations;
    failed_solves += other.failed_solves;
    if (other.failed_solves > 0) failure = other.failure;
    krylov_iterations += other.krylov_iterations;
    largest_krylov = largest_krylov > other.largest_krylov ? largest_krylov : other.largest_krylov;
    local_solves += other.local_solves;
    stopped = stopped || other.stopped;
  }
  void add(const NewtonReport& other) {
    add_work(other);
    outcome = other.outcome;
    residual = other.residual;
    complementarity = other.complementarity;
    penetration = other.penetration;
    round_off = other.round_off;
    lost_on_the_way = other.lost_on_the_way;
    unstable = other.unstable;
    unstable_at = other.unstable_at;
    choose(other.alike, other.alike_at);
    undetermined = other.undetermined;
    undetermined_at = other.undetermined_at;
    reason = other.reason;
    no_way_on = other.no_way_on;
  }
};

}  // namespace voussoir

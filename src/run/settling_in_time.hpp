// Whether a structure stands under loads at which statics finds neither an equilibrium nor a mechanism: let go from its
// last equilibrium, with inertia and damping, it comes to rest or moves on and on.
//
// Loads grow and supports move slowly, over several periods of the structure, and stay. Damping is in proportion to the
// stiffness of the stones: it takes vibrations away and leaves motions as wholes, mechanisms, alone. Mortar is a spring
// as in load steps, and stones that are not there have no mass. Time steps grow as
// time goes by, so that a slow mechanism shows as well as a fast one. What has come to rest is shown to be an
// equilibrium by a load step that begins there.
#pragma once

#include "dynamics/factor_search.hpp"
#include "model/model.hpp"
#include "model/step_counts.hpp"
#include "step/adaptive_step.hpp"

namespace voussoir {

/// A load step from an equilibrium.
struct LoadIncrement {
  const std::vector<double>& load_before;  ///< [N] of the equilibrium
  const std::vector<double>& load;         ///< [N]
  const std::vector<double>& prescribed;   ///< [m]
};

struct Settled {
  Verdict verdict = Verdict::undecided;
  ContactState state;             ///< at rest, or moving
  StepReport report;              ///< of the load step that shows the equilibrium, or of none
  std::vector<double> mechanism;  ///< how it moved at last [1], on local nodes, the largest 1
  int solves = 0;                 ///< linear solves of it all, each correction by patches counted as one
  StepNumbers counts;             ///< of it all but that load step
  double time = 0;                ///< [s] it took the structure
  bool stopped = false;           ///< by somebody else: nothing of it is to be used
};

/// Whether a scene can be told so: stones have mass and turn by small angles.
bool can_settle_in_time(const Model&);

/// Collective.
/// @param most_solves  linear solves after which it is given up
Settled settle_in_time(Model&, AdaptiveStep&, const ContactState& equilibrium, const LoadIncrement&, int most_solves);

/// Gives a step no more than so many linear solves while it lives, and counts them.
class SolveBudget {
 public:
  template <class Step>
  SolveBudget(const Step& step, int most)
      : progress_(*step.progress()), before_(progress_.solves()), question_(progress_, [this, most] {
          spent_ = solves() >= most;
          return spent_ ? GoOn::no : GoOn::yes;
        }) {}
  int solves() const { return progress_.solves() - before_; }
  /// Whether it has ended a step.
  bool spent() const { return spent_; }

 private:
  Progress& progress_;
  int before_;
  bool spent_ = false;
  Progress::Question question_;
};

}  // namespace voussoir

// Numbers of the active sets: semismooth Newton with Coulomb's coupling (active_set.hpp).
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct ActiveSetParameters {
  bool damping = true;  ///< a solve that loses a stone is made again with points that yield slowly; in patches always
  bool step_lengths = true;               ///< in time steps are shortened while residuals grow
  bool creeping = true;                   ///< closed points resist more while forces creep with the statuses they have
  double augmentation_in_time = 1000;     ///< resistance of closed points in time, relative to their local stiffness
  double augmentation_at_rest = 100;      ///< the same in load steps
  double augmentation_of_creeping = 1e4;  ///< the same while forces creep
  double accuracy = 1e-4;                 ///< of linear solves, relative to their right side
  double finest_accuracy = 1e-10;         ///< of linear solves in time where statuses stay
  int patience = 8;                       ///< solves that gain too little after which it circles
  int patience_alone = 4;                 ///< the same where stones cannot be brought to rest alone
  double gained = 0.5;                    ///< share of the best residual below which a solve has gained
  int many_krylov = 50;  ///< Krylov iterations of a first solve that mean loose stones: another way is taken
  int most_krylov = 80;  ///< Krylov iterations of later solves
  double near = 1e-2;    ///< residual below which loose stones are no reason to leave
  /// right sides are solved as accurately as if they were no more than so many times the largest force
  double flown = 3;
  double descent = 0.2;        ///< share of a step by which squared residuals must fall in time
  double shortest = 1.0 / 64;  ///< shortest step in time
  double lost = 10;            ///< growth of the residual that means a lost stone
  /// resistance of points that give way once a stone is lost, relative to their local stiffness
  double first_damping = 1e-2;
  /// by which that rises with every repeated solve, and falls with every step that is taken
  double damping_factor = 10;
  double largest_damping = 1e4;    ///< of these resistances
  double no_damping = 1e-5;        ///< resistance below which it is taken for none
  double damped = 0.5;             ///< share of the residual without damping above which nothing was lost
  double damping_in_patch = 1e-3;  ///< resistance of points that give way in patches
  void declare(ParameterSection&);
};

}  // namespace voussoir

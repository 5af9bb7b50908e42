// Numbers of the augmented Lagrangian (augmented_lagrangian.hpp), and of collapses, which it tells.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct AugmentedLagrangianParameters {
  bool used = true;                    ///< the augmented Lagrangian closes what the path leaves, and tells collapses
  double largest_augmentation = 1000;  ///< relative to the local stiffness
  /// proximal term at first and where Newton labours, relative to the weights of the problem
  double largest_proximal = 1;
  double smallest_proximal = 1e-6;  ///< the same while forces creep
  double factor = 10;               ///< by which augmentation and proximal term change
  double creeping = 0.5;        ///< share of the last change of forces above which one step of Newton gained too little
  int labouring = 4;            ///< steps of Newton with bounds that follow the pressure, while forces creep
  int struggling = 10;          ///< steps of Newton after which augmentation and proximal term go back
  double stagnating = 0.9;      ///< share of the last change of forces above which an outer step stagnates
  int stagnant_steps = 2;       ///< outer steps that may stagnate
  double relaxation = 0.5;      ///< by how much friction bounds follow pressures while forces creep
  double collision_step = 0.1;  ///< a shorter step ran into points that its direction knew nothing of
  int largest_inner = 60;       ///< steps of Newton that an update waits for
  double aim = 0.1;        ///< share of the tolerance, and of the last change of forces, to which a minimum is found
  double solve_aim = 0.1;  ///< share of that to which a linear system is solved
  double finest_accuracy = 1e-8;    ///< of linear solves
  double coarsest_accuracy = 1e-2;  ///< of linear solves
  double finest_alone = 1e-12;      ///< accuracy of the linear solve where no point is selected
  double prediction = 1e-3;         ///< accuracy of the solve that moves supports and loads
  double run_away = 0.2;   ///< share of the structure that is no elastic displacement of masonry, on the path too
  double unchanged = 0.5;  ///< share of the imbalance that a motion without end may change
  /// contact residual, of the largest force, at which a motion without end is believed
  double believable = 0.01;
  double settled = 0.1;    ///< share of the imbalance below which forces have settled
  double drifting = 0.5;   ///< share of the last imbalance above which it stays
  int drifting_steps = 1;  ///< outer steps of which it may stay before a motion without end is looked for
  void declare(ParameterSection&);
};

}  // namespace voussoir

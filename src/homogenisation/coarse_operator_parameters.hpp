// Numbers of the preconditioner: its parts are parameters of a scene (preconditioner_parameters.hpp).
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct CoarseOperatorParameters {
  bool shear = true;                ///< stones that many points let go shear in the block motions
  bool whole_factorisation = true;  ///< systems on which Krylov's method labours are factored whole
  bool released_region = true;   ///< where little has parted it is solved directly; as preconditioner > released region
  double block_weight = 0.5;     ///< w of the block solves
  double same = 0.1;             ///< change of a resistance up to which factors stay
  double many = 0.125;           ///< share of its points that have to give way for a block to shear
  double giving_way = 0.1;       ///< a point gives way below this share of what the stiffest resists
  int krylov_to_shear = 12;      ///< Krylov iterations of a system after which stones shear in those that follow
  int krylov_to_factor = 20;     ///< Krylov iterations after which a system is factored whole
  int layers = 3;                ///< layers of cells around nodes that have parted
  double largest_region = 0.25;  ///< largest share of all unknowns in them
  int smallest_multigrid = 2000;  ///< unknowns of the continuum from which on it is preconditioned by multigrid
  double even = 10;               ///< ratio of the stiffest stone to the softest up to which multigrid will do
  int largest_factor = 300000;    ///< unknowns of the continuum up to which it is factored where stones are uneven
  void declare(ParameterSection&);
};

}  // namespace voussoir

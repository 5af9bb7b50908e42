// All numbers and switches that decide how contact conditions are closed, one struct per method.
#pragma once

#include "nonlinear/active_set_parameters.hpp"
#include "nonlinear/contact_solver_parameters.hpp"
#include "nonlinear/interior_path_parameters.hpp"
#include "nonlinear/patch_parameters.hpp"
#include "nonlinear/pseudo_time_parameters.hpp"

namespace voussoir {

struct MethodParameters {
  ContactSolverParameters solver;
  ActiveSetParameters active_set;
  PatchParameters patches;
  InteriorPathParameters path;
  PseudoTimeParameters pseudo_time;
};

}  // namespace voussoir

// A scene: everything a run needs to know, as read from XML and validated.
#pragma once

#include <string>
#include <vector>

#include "base/warning.hpp"
#include "blocks/material_parameters.hpp"
#include "blocks/support_parameters.hpp"
#include "dynamics/construction_parameters.hpp"
#include "dynamics/load_factor_parameters.hpp"
#include "dynamics/load_step_parameters.hpp"
#include "dynamics/time_parameters.hpp"
#include "homogenisation/preconditioner_parameters.hpp"
#include "joints/joint_law_parameters.hpp"
#include "linalg/solver_parameters.hpp"
#include "loads/load_parameters.hpp"
#include "mesh/mesh_parameters.hpp"
#include "nonlinear/newton_parameters.hpp"
#include "output/observation_parameters.hpp"
#include "output/output_parameters.hpp"
#include "scene/internals.hpp"
#include "scene/named.hpp"
#include "selection/selection_parameters.hpp"

namespace voussoir {

struct Scene {
  std::string file;   ///< path of the XML, as given
  std::string name;   ///< file name without folder and ending
  std::string title;  ///< one line for the report
  MeshParameters mesh;
  ModelParameters model;
  std::vector<Named<MaterialParameters>> materials;  ///< in the order of the file
  std::vector<Named<JointLawParameters>> joints;
  std::vector<Named<SupportParameters>> supports;
  std::vector<LoadParameters> loads;
  std::vector<Named<ConstructionParameters>> construction;
  std::vector<StageParameters> stages;
  LoadStepParameters load_steps;
  LoadFactorParameters load_factor;
  TimeParameters time;
  std::vector<Named<InitialVelocityParameters>> velocities;
  SelectionParameters selection;
  NewtonParameters newton;
  PreconditionerParameters preconditioner;
  SolverParameters solver;
  Internals internals;  ///< how steps are solved: for studies
  std::vector<Named<ObservationParameters>> observations;
  OutputParameters output;
  Warnings warnings;  ///< what is legal but has no effect, by its place in the scene
  Warnings remarks;   ///< what may be as meant in a part of the stages; the head of a run tells, not its result
};

}  // namespace voussoir

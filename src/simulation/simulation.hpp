// A whole run, in the order of the data flow: scene, mesh, blocks, joints, load steps, results.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <ostream>
#include <string>

#include "output/result_json.hpp"
#include "scene/scene.hpp"

namespace voussoir {

struct RunOptions {
  std::string folder;      ///< where results go
  bool overwrite = false;  ///< remove earlier results instead of keeping them beside
  bool validate = false;   ///< check the scene and its mesh, then stop
  bool dry_run = false;    ///< also count unknowns and predict the cost, then stop
  bool verbose = false;    ///< a line for every linear solve
};

/// Runs a scene. Collective; throws InputError, ConvergenceError or ResourceError on every rank alike.
/// @param say  where rank 0 narrates; other ranks pass a stream that goes nowhere
RunSummary run(const Scene&, const RunOptions&, const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream& say);

}  // namespace voussoir

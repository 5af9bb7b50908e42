// A whole run, in the order of the data flow: scene, mesh, blocks, joints, load steps, results.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <ostream>
#include <string>

#include "mesh/geo_commands.hpp"
#include "output/result_json.hpp"
#include "scene/scene.hpp"

namespace voussoir {

struct RunOptions {
  std::string folder;           ///< where results go
  bool overwrite = false;       ///< remove earlier results instead of keeping them beside
  bool restart = false;         ///< go on from the checkpoint in the folder
  std::string restart_from;     ///< or from that in this folder, which stays as it is
  bool validate = false;        ///< check the scene and its mesh, then stop
  bool dry_run = false;         ///< also count unknowns and predict the cost, then stop
  bool limit_analysis = false;  ///< ask rigid limit analysis alone
  std::string fclib;            ///< where contact problems that were hard go, as files of FCLib; empty: nowhere
  bool verbose = false;         ///< a line for every linear solve
  Trust trust = Trust::no;      ///< whether a .geo may run programs, and read and write files
};

/// Runs a scene. Collective; throws InputError, ConvergenceError or ResourceError on every rank alike.
/// @param say  where rank 0 narrates; other ranks pass a stream that goes nowhere
/// @return with no scene named where nothing was computed: to validate, for a dry run, or with nothing left to do
RunSummary run(const Scene&, const RunOptions&, const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream& say);

}  // namespace voussoir

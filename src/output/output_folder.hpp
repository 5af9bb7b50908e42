// The folder a run writes to; results of an earlier run are never lost by accident.
#pragma once

#include <string>

#include <Teuchos_Comm.hpp>

namespace voussoir {

/// What to do with results that are there already.
enum class Earlier {
  keep,    ///< rename the folder, so that they stay beside; refuse when they can be continued
  remove,  ///< take the results away, leave other files
  go_on    ///< continue them: they must hold a checkpoint
};

/// Makes `folder`, parents included, and proves that it can be written. Collective; throws ResourceError on all ranks.
///
/// Results are never lost by accident: a folder that holds some is renamed to folder.1 (or the next free number), and
/// one that holds a run that did not end, but left a checkpoint, is not touched at all unless told to.
/// @return where the earlier results went, empty when there were none to keep; the same on all ranks
std::string prepare_output_folder(const std::string& folder, Earlier, const Teuchos::Comm<int>& comm);

/// The files of a run by name.
inline const char* const result_file = "result.json";
inline const char* const checkpoint_file = "checkpoint.h5";

}  // namespace voussoir

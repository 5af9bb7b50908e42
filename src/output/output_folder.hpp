// The folder a run writes to; results of an earlier run are never lost by accident.
#pragma once

#include <string>

#include <Teuchos_Comm.hpp>

namespace voussoir {

/// Makes `folder`, parents included, and proves that it can be written. Collective; throws ResourceError on all ranks.
///
/// A folder that holds a result.json is a finished run: it is renamed to folder.1 (or the next free number) first.
/// With `overwrite`, or when the earlier run never finished, its result files are removed instead, so that the new
/// run's are not mixed with them. Other files stay.
/// @return where the earlier results went, empty when there were none to keep; the same on all ranks
std::string prepare_output_folder(const std::string& folder, bool overwrite, const Teuchos::Comm<int>& comm);

}  // namespace voussoir

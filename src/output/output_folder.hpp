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

/// A folder that is ready to be written to, by this run alone as long as the object lives.
///
/// Results are never lost by accident: a folder that holds some is renamed to folder.1 (or the next free number), and
/// one that holds a run that did not end, but left a checkpoint, is not touched at all unless told to. A folder that
/// another run writes to is refused; the lock ends with the process, however that ends.
class OutputFolder {
 public:
  /// Makes `folder`, parents included, and proves that it can be written. Collective; all ranks throw ResourceError.
  OutputFolder(const std::string& folder, Earlier, const Teuchos::Comm<int>& comm);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where the earlier results went, empty when there were none to keep; the same on all ranks.
  const std::string& kept() const { return kept_; }

 private:
  std::string kept_;
  int lock_ = -1;  ///< of the first rank
};

/// The files of a run by name.
inline const char* const result_file = "result.json";
inline const char* const checkpoint_file = "checkpoint.h5";
inline const char* const joints_file = "joints.csv";

}  // namespace voussoir

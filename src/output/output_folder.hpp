// The folder a run writes to; results of an earlier run are never lost by accident.
#pragma once

#include <string>
#include <vector>

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
/// Results are never lost by accident: a folder that holds some is renamed to folder.1 (or the next free number), what
/// else lies in it stays where it is, and one that holds a run that did not end, but left a checkpoint, is not touched
/// at all unless told to. A folder that another run writes to is refused; the lock ends with the process, however that
/// ends.
class OutputFolder {
 public:
  /// Makes `folder`, parents included, and proves that it can be written. Collective; all ranks throw ResourceError.
  /// @param inputs  files and folders that the run reads: a folder where one of them would be replaced is refused
  OutputFolder(const std::string& folder, Earlier, const Teuchos::Comm<int>& comm,
               const std::vector<std::string>& inputs = {});
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where the earlier results went, empty when there were none to keep; the same on all ranks.
  const std::string& kept() const { return kept_; }

 private:
  std::string kept_;
  int lock_ = -1;  ///< of the first rank
};

/// Whether a run has come to its end in a folder. Collective; the same on all ranks.
bool holds_result(const std::string& folder, const Teuchos::Comm<int>&);

/// The folder of a run that another folder goes on with. It is read and left as it is: whatever is computed from its
/// checkpoint is written elsewhere, so that several variants can begin where it stands.
class BranchedFolder {
 public:
  /// Keeps runs from writing to `from` as long as the object lives. Collective; all ranks throw ResourceError when it
  /// holds no checkpoint, when a run writes to it, or when what would be written to `to` could touch it.
  BranchedFolder(const std::string& from, const std::string& to, const Teuchos::Comm<int>& comm);
  ~BranchedFolder();
  BranchedFolder(const BranchedFolder&) = delete;
  BranchedFolder& operator=(const BranchedFolder&) = delete;

  /// Copies the history and, where they are wanted, the fields of the run. Collective; all ranks throw ResourceError.
  void copy_records(bool fields) const;

 private:
  std::string from_, to_;
  const Teuchos::Comm<int>& comm_;
  int lock_ = -1;  ///< of the first rank
};

/// The files of a run by name.
inline const char* const result_file = "result.json";
inline const char* const interrupted_file = "interrupted.json";  ///< the same, of a run that can be gone on with
inline const char* const checkpoint_file = "checkpoint.h5";
inline const char* const joints_file = "joints.csv";
inline const char* const history_file = "history.csv";
inline const char* const fields_file = "fields.h5";
inline const char* const drawing_file = "drawing.svg";

}  // namespace voussoir

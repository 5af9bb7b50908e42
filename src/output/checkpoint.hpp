// A checkpoint: the state of a run in one HDF5 file, which is there whole or not at all.
//
// It is written beside the last one and takes its place when it is on disk, so a kill at any moment leaves one of the
// two. One function per module names what it keeps, and the same calls save and restore: the two cannot drift apart.
//
//   template <class Archive> void keep(Archive& archive) { archive.value("friction_J", friction_); }
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "output/hdf5_file.hpp"

namespace voussoir {

/// Rows of a table as a rank holds them: the owned ones first, then its halo, each part ascending.
struct LocalRows {
  std::vector<long long> ids;  ///< to restore, -1 for what has no row in the file: it reads as zero
  long long owned = 0;
  long long total = 0;  ///< of all ranks
};

/// Every function is collective and throws ResourceError on all ranks.
class Checkpoint {
 public:
  enum class Way { save, restore };

  /// @param path  "out/wall/checkpoint.h5"; saving writes beside it until publish()
  Checkpoint(const std::string& path, const Teuchos::RCP<const Teuchos::Comm<int>>&, Way);
  ~Checkpoint();

  bool saving() const { return way_ == Way::save; }
  /// A number or text that all ranks know. T is bool, int, long long, double or std::string.
  template <class T>
  void value(const std::string& name, T&);
  /// A number with its range, such as an index: a file that holds another is refused. T is int, long long or double.
  template <class T>
  void within(const std::string& name, T&, double least, double most);
  /// A table by global rows, so that any number of ranks can restore it. A table that is empty everywhere is left out
  /// and restored empty, but where there are values before there must be a table. Numbers are finite. T is char, int or
  /// double.
  template <class T>
  void rows(const std::string& name, const LocalRows&, int columns, std::vector<T>&);
  /// The same with a range, such as for words or counts: a file that holds another number is refused.
  template <class T>
  void rows_within(const std::string& name, const LocalRows&, int columns, std::vector<T>&, double least, double most);
  /// Lines of text that all ranks know, without blanks at their ends.
  void texts(const std::string& name, std::vector<std::string>&);
  /// Puts what was saved in the place of the last checkpoint.
  void publish();

 private:
  /// Throws on all ranks where a number of any rank is not as it must be.
  void require_all(const std::string& what, bool mine) const;

  std::string path_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  Way way_;
  std::unique_ptr<Hdf5File> file_;
};

}  // namespace voussoir

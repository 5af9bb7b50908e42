// An HDF5 file that all ranks write and read together with MPI-IO. The only place that knows HDF5.
//
// Tables are addressed by global rows: a rank gives the numbers of its rows and their values, and the file does not
// show how many ranks wrote it. Every function is collective. What fails on one rank is thrown on all as ResourceError.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include "output/safe_file.hpp"

namespace voussoir {

/// What a table is, the same on every rank.
struct Table {
  long long rows = 0;  ///< of all ranks together
  int columns = 1;     ///< 1 is written as a plain vector
  std::string unit;    ///< "m", "Pa"; "-" or empty for a number without one
  std::string text{};  ///< what the numbers mean, for those who open the file
};

class Hdf5File {
 public:
  enum class Mode { create, read, append };  ///< create replaces what was there, append adds to it

  /// @param elsewhere  what to do where the file cannot be written, beside freeing the place
  Hdf5File(const std::string& file, Teuchos::RCP<const Teuchos::Comm<int>> comm, Mode mode,
           const std::string& elsewhere = other_folder);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  /// Writes a new table; groups on the way are made. T is double, int or long long.
  /// @param ids     rows of this rank, strictly ascending, may be empty; every row has one owner
  /// @param values  row-major, ids.size() x table.columns
  template <class T>
  void write_rows(const std::string& path, const std::vector<long long>& ids, const std::vector<T>& values,
                  const Table& table);
  /// Rows `ids` (strictly ascending) of a table; ranks may ask for the same row.
  template <class T>
  std::vector<T> read_rows(const std::string& path, const std::vector<long long>& ids) const;
  /// Rows, columns, unit and text of a table.
  Table table(const std::string& path) const;
  bool has(const std::string& path) const;

  /// A table of `columns` columns that shows table `source` and zeros behind it, without storing either again
  /// (a virtual dataset): viewers take a field for a vector only when it has three components.
  /// For viewers alone: HDF5 1.10 refuses to read such a view in parallel.
  void write_padded_view(const std::string& path, const std::string& source, int columns);

  /// Texts as strings of one length (HDF5 cannot write strings of several lengths in parallel).
  /// @param texts  of the first rank; of the others the same or none
  void write_texts(const std::string& path, const std::vector<std::string>& texts);
  std::vector<std::string> read_texts(const std::string& path) const;

  /// Attribute of a table or group (a missing group is made). T is double, long long or std::string; same on all ranks.
  template <class T>
  void write_attribute(const std::string& path, const std::string& name, const T& value);
  template <class T>
  T read_attribute(const std::string& path, const std::string& name) const;
  bool has_attribute(const std::string& path, const std::string& name) const;

  /// Brings everything to disk: what was written so far survives when the run is killed.
  void flush();
  /// Ends the file and tells when that failed, which the destructor cannot. Nothing else may follow.
  void close();

  /// Whether a file could not be written to its end. HDF5 1.10 then crashes when it ends, in MPI_Finalize: a program
  /// must leave without.
  static bool any_broken();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Copies groups and tables of one file, with all they hold, into a new one. Not collective. Throws ResourceError.
void copy_hdf5(const std::string& from, const std::string& to, const std::vector<std::string>& paths);

}  // namespace voussoir

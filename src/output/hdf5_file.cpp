#include "output/hdf5_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include <hdf5.h>
#include <Teuchos_DefaultMpiComm.hpp>

#include "base/check.hpp"
#include "base/error.hpp"
#include "linalg/agree.hpp"
#include "linalg/mpi_handle.hpp"
#include "output/even_rows.hpp"
#include "output/safe_file.hpp"

namespace voussoir {
namespace {

/// An HDF5 identifier with the function that releases it.
class Handle {
 public:
  Handle(hid_t id, herr_t (*release)(hid_t)) : id_(id), release_(release) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), release_(other.release_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() { close(); }
  operator hid_t() const { return id_; }
  bool good() const { return id_ >= 0; }
  bool close() { return id_ < 0 || release_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  herr_t (*release_)(hid_t);
};

template <class T>
hid_t native();
template <>
hid_t native<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
hid_t native<int>() {
  return H5T_NATIVE_INT;
}
template <>
hid_t native<long long>() {
  return H5T_NATIVE_LLONG;
}

/// A string type of fixed length: at least one byte, or HDF5 refuses it.
Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, std::max<std::size_t>(length, 1));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

std::string trimmed(std::string text) {
  text.resize(std::strlen(text.c_str()));
  return text;
}

/// The innermost entry of HDF5's error stack: nearest to the cause.
std::string last_error() {
  std::string reason;
  const auto first = [](unsigned, const H5E_error2_t* entry, void* text) -> herr_t {
    auto& found = *static_cast<std::string*>(text);
    if (found.empty() && entry->desc) found = entry->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, first, &reason);
  return reason.empty() ? "an unknown error of HDF5" : reason;
}

const Teuchos::MpiComm<int>* with_mpi(const Teuchos::Comm<int>& comm) {
  return dynamic_cast<const Teuchos::MpiComm<int>*>(&comm);
}

}  // namespace

class Hdf5File::Impl {
 public:
  Impl(std::string path, Teuchos::RCP<const Teuchos::Comm<int>> teuchos_comm, Mode open_mode, std::string other_place)
      : name(std::move(path)),
        elsewhere(std::move(other_place)),
        mode(open_mode),
        comm(std::move(teuchos_comm)),
        mpi(mpi_handle(*comm)) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors become exceptions, not pages on the screen
    on_first_rank(*comm, [this] { try_to_open(); });
    Handle access = access_to_file();
    const unsigned how = mode == Mode::append ? H5F_ACC_RDWR : H5F_ACC_RDONLY;
    const hid_t id = mode == Mode::create ? H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)
                                          : H5Fopen(name.c_str(), how, access);
    require(id >= 0);
    file_id = id;
  }

  ~Impl() {
    if (file_id >= 0 && !broken) H5Fclose(file_id);
  }

  /// Every rank agrees before anyone throws.
  /// @param why  reason, where it is not HDF5 that refused
  void require(bool good, const char* why = nullptr) const {
    const auto reason = first_text(*comm, good ? std::optional<std::string>() : why ? why : last_error());
    if (!reason) return;
    broken = mode != Mode::read;
    any_broken |= broken;
    throw ResourceError(mode == Mode::read ? cannot_read(name, *reason) : cannot_write(name, *reason, elsewhere));
  }

  Handle create(const std::string& path, hid_t type, hid_t space, hid_t properties) const {
    Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links, 1);
    return {H5Dcreate2(file_id, path.c_str(), type, space, links, properties, H5P_DEFAULT), H5Dclose};
  }

  Handle open(const std::string& path) const { return {H5Dopen2(file_id, path.c_str(), H5P_DEFAULT), H5Dclose}; }

  /// The object an attribute belongs to; a group that is not there yet is made.
  Handle object(const std::string& path) const {
    if (mode != Mode::read && !exists(path)) {
      Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
      H5Pset_create_intermediate_group(links, 1);
      Handle group(H5Gcreate2(file_id, path.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
      require(group.good());
    }
    return {H5Oopen(file_id, path.c_str(), H5P_DEFAULT), H5Oclose};
  }

  /// HDF5 answers only for the last name of a path, so each part is asked for in turn.
  bool exists(const std::string& path) const {
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
      const std::string part = path.substr(0, end);
      if (part != "/" && H5Lexists(file_id, part.c_str(), H5P_DEFAULT) <= 0) return false;
      if (end == std::string::npos) return true;
    }
  }

  void put_attribute(const std::string& path, const std::string& key, hid_t type, const void* value) const {
    Handle owner = object(path);
    Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    if (owner.good() && H5Aexists(owner, key.c_str()) > 0) H5Adelete(owner, key.c_str());
    Handle attribute(H5Acreate2(owner, key.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    require(attribute.good() && H5Awrite(attribute, type, value) >= 0);
  }

  void put_attribute(const std::string& path, const std::string& key, const std::string& value) const {
    put_attribute(path, key, text_type(value.size()), value.c_str());
  }

  /// Selects `count` rows from `first` on in a table; nothing when count is zero.
  static void select_rows(hid_t space, hsize_t first, hsize_t count, hsize_t columns) {
    const hsize_t start[2] = {first, 0}, extent[2] = {count, columns};
    if (count == 0)
      H5Sselect_none(space);
    else
      H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, extent, nullptr);
  }

  static Handle table_space(long long rows, int columns) {
    const hsize_t extent[2] = {static_cast<hsize_t>(rows), static_cast<hsize_t>(columns)};
    return {H5Screate_simple(columns == 1 ? 1 : 2, extent, nullptr), H5Sclose};
  }

  /// How tables are moved: by all ranks together.
  Handle collective() const {
    Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
    if (with_mpi(*comm)) H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
    return transfer;
  }

  std::string name, elsewhere;
  Mode mode;
  Teuchos::RCP<const Teuchos::Comm<int>> comm;
  MPI_Comm mpi;
  hid_t file_id = -1;
  mutable bool broken = false;  ///< writing has failed; closing would fail half way
  static inline bool any_broken = false;

 private:
  /// With MPI always MPI-IO, on one rank too. Without it files are not locked either.
  Handle access_to_file() const {
    Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    if (with_mpi(*comm))
      H5Pset_fapl_mpio(access, mpi, MPI_INFO_NULL);
    else
      H5Pset_file_locking(access, false, true);
    return access;
  }

  /// Asks the system first: its reason is clearer than that of MPI-IO.
  void try_to_open() const {
    const char* how = mode == Mode::create ? "wb" : mode == Mode::append ? "r+b" : "rb";
    std::FILE* stream = std::fopen(name.c_str(), how);
    const std::string reason = stream ? "" : std::strerror(errno);
    if (stream)
      std::fclose(stream);
    else
      throw ResourceError(mode == Mode::read ? cannot_read(name, reason) : cannot_write(name, reason, elsewhere));
  }
};

Hdf5File::Hdf5File(const std::string& file, Teuchos::RCP<const Teuchos::Comm<int>> comm, Mode mode,
                   const std::string& elsewhere)
    : impl_(std::make_unique<Impl>(file, std::move(comm), mode, elsewhere)) {}

Hdf5File::~Hdf5File() = default;

template <class T>
void Hdf5File::write_rows(const std::string& path, const std::vector<long long>& ids, const std::vector<T>& values,
                          const Table& table) {
  const EvenRows even(ids, table.rows, impl_->mpi);
  VOUSSOIR_CHECK(even.every_row_has_one_owner());
  const std::vector<T> rows = even.gather(values, table.columns);

  Handle space = Impl::table_space(table.rows, table.columns);
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER);  // every row is written, so none is filled before
  Handle dataset = impl_->create(path, native<T>(), space, properties);
  impl_->require(dataset.good());
  if (table.rows > 0) {
    Impl::select_rows(space, even.first(), even.count(), table.columns);
    Handle memory = Impl::table_space(even.count(), table.columns);
    Impl::select_rows(memory, 0, even.count(), table.columns);
    impl_->require(H5Dwrite(dataset, native<T>(), memory, space, impl_->collective(), rows.data()) >= 0);
  }
  impl_->require(dataset.close());
  if (!table.unit.empty()) impl_->put_attribute(path, "unit", table.unit);
  if (!table.text.empty()) impl_->put_attribute(path, "text", table.text);
}

template <class T>
std::vector<T> Hdf5File::read_rows(const std::string& path, const std::vector<long long>& ids) const {
  const Table shape = table(path);
  impl_->require(ids.empty() || ids.back() < shape.rows, "fewer rows than are asked for");
  const EvenRows even(ids, shape.rows, impl_->mpi);
  std::vector<T> rows(static_cast<std::size_t>(even.count()) * shape.columns);
  Handle dataset = impl_->open(path);
  Handle space(H5Dget_space(dataset), H5Sclose);
  if (shape.rows > 0) {
    Impl::select_rows(space, even.first(), even.count(), shape.columns);
    Handle memory = Impl::table_space(even.count(), shape.columns);
    Impl::select_rows(memory, 0, even.count(), shape.columns);
    impl_->require(H5Dread(dataset, native<T>(), memory, space, impl_->collective(), rows.data()) >= 0);
  }
  return even.scatter(rows, shape.columns);
}

Table Hdf5File::table(const std::string& path) const {
  Handle dataset = impl_->open(path);
  impl_->require(dataset.good());
  Handle space(H5Dget_space(dataset), H5Sclose);
  hsize_t extent[2] = {0, 1};
  impl_->require(H5Sget_simple_extent_ndims(space) <= 2 && H5Sget_simple_extent_dims(space, extent, nullptr) >= 1);
  constexpr hsize_t largest = std::numeric_limits<int>::max();
  impl_->require(extent[1] <= largest && extent[0] <= largest * largest, "a table larger than any");
  Table result{static_cast<long long>(extent[0]), static_cast<int>(extent[1]), ""};
  if (H5Aexists(dataset, "unit") > 0) result.unit = read_attribute<std::string>(path, "unit");
  if (H5Aexists(dataset, "text") > 0) result.text = read_attribute<std::string>(path, "text");
  return result;
}

bool Hdf5File::has(const std::string& path) const { return impl_->exists(path); }

void Hdf5File::write_padded_view(const std::string& path, const std::string& source, int columns) {
  const Table shape = table(source);
  VOUSSOIR_CHECK(shape.columns > 1 && shape.columns <= columns && shape.rows > 0);
  Handle seen = Impl::table_space(shape.rows, columns);
  Handle stored = Impl::table_space(shape.rows, shape.columns);
  Impl::select_rows(seen, 0, shape.rows, shape.columns);
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const double zero = 0.0;
  impl_->require(H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &zero) >= 0 &&
                 H5Pset_virtual(properties, seen, ".", source.c_str(), stored) >= 0);
  H5Sselect_all(seen);
  impl_->require(impl_->create(path, H5T_NATIVE_DOUBLE, seen, properties).good());
  if (!shape.unit.empty()) impl_->put_attribute(path, "unit", shape.unit);
}

void Hdf5File::write_texts(const std::string& path, const std::vector<std::string>& texts) {
  std::size_t length = 1;
  for (const auto& text : texts) length = std::max(length, text.size());
  length = largest_over_ranks(*impl_->comm, length);
  const auto rows = largest_over_ranks(*impl_->comm, static_cast<long long>(texts.size()));
  std::string padded;
  if (impl_->comm->getRank() == 0)
    for (const auto& text : texts) padded += text + std::string(length - text.size(), '\0');
  Handle type = text_type(length);
  Handle space = Impl::table_space(rows, 1);
  Handle dataset = impl_->create(path, type, space, H5P_DEFAULT);
  impl_->require(dataset.good());
  if (rows == 0) return;
  Impl::select_rows(space, 0, impl_->comm->getRank() == 0 ? rows : 0, 1);
  impl_->require(H5Dwrite(dataset, type, space, space, impl_->collective(), padded.data()) >= 0);
}

std::vector<std::string> Hdf5File::read_texts(const std::string& path) const {
  const Table shape = table(path);
  Handle dataset = impl_->open(path);
  Handle type(H5Dget_type(dataset), H5Tclose);
  const std::size_t length = H5Tget_size(type);
  impl_->require(H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0, "no texts of one length");
  constexpr std::size_t most = std::size_t{1} << 30;  // bytes: a scene of 16 MB in lines as long as its longest
  impl_->require(length <= most && static_cast<std::size_t>(shape.rows) <= most / length, "more text than any");
  std::string padded(length * shape.rows, '\0');
  if (shape.rows > 0) impl_->require(H5Dread(dataset, type, H5S_ALL, H5S_ALL, impl_->collective(), padded.data()) >= 0);
  std::vector<std::string> texts;
  for (long long k = 0; k < shape.rows; ++k) texts.push_back(trimmed(padded.substr(k * length, length)));
  return texts;
}

template <class T>
void Hdf5File::write_attribute(const std::string& path, const std::string& name, const T& value) {
  if constexpr (std::is_same_v<T, std::string>)
    impl_->put_attribute(path, name, value);
  else
    impl_->put_attribute(path, name, native<T>(), &value);
}

template <class T>
T Hdf5File::read_attribute(const std::string& path, const std::string& name) const {
  Handle owner = impl_->object(path);
  Handle attribute(H5Aopen(owner, name.c_str(), H5P_DEFAULT), H5Aclose);
  impl_->require(attribute.good());
  Handle space(H5Aget_space(attribute), H5Sclose);
  impl_->require(H5Sget_simple_extent_npoints(space) == 1, "several values where one is meant");
  Handle type(H5Aget_type(attribute), H5Tclose);
  T value{};
  if constexpr (std::is_same_v<T, std::string>) {
    constexpr std::size_t longest = 1 << 20;  // bytes
    const bool text = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
    impl_->require(text && H5Tget_size(type) <= longest, "no text of fixed length");
    value.resize(H5Tget_size(type));
    impl_->require(H5Aread(attribute, type, value.data()) >= 0);
    return trimmed(value);
  } else {
    impl_->require(H5Tget_class(type) == H5T_INTEGER || H5Tget_class(type) == H5T_FLOAT, "no number");
    impl_->require(H5Aread(attribute, native<T>(), &value) >= 0);
    return value;
  }
}

bool Hdf5File::has_attribute(const std::string& path, const std::string& name) const {
  return H5Aexists_by_name(impl_->file_id, path.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5File::close() {
  flush();  // fails where closing would
  impl_->require(H5Fclose(std::exchange(impl_->file_id, -1)) >= 0);
}

bool Hdf5File::any_broken() { return Impl::any_broken; }

void Hdf5File::flush() { impl_->require(H5Fflush(impl_->file_id, H5F_SCOPE_GLOBAL) >= 0); }

void copy_hdf5(const std::string& from, const std::string& to, const std::vector<std::string>& paths) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Handle source(H5Fopen(from.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!source.good()) throw ResourceError(cannot_read(from, last_error()));
  Handle target(H5Fcreate(to.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  if (!target.good()) throw ResourceError(cannot_write(to, last_error()));
  Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  for (const auto& path : paths)
    if (H5Ocopy(source, path.c_str(), target, path.c_str(), H5P_DEFAULT, links) < 0)
      throw ResourceError(cannot_read(from + ", " + path, last_error()));
  if (!target.close()) throw ResourceError(cannot_write(to, last_error()));
}

template void Hdf5File::write_rows(const std::string&, const std::vector<long long>&, const std::vector<double>&,
                                   const Table&);
template void Hdf5File::write_rows(const std::string&, const std::vector<long long>&, const std::vector<int>&,
                                   const Table&);
template void Hdf5File::write_rows(const std::string&, const std::vector<long long>&, const std::vector<long long>&,
                                   const Table&);
template std::vector<double> Hdf5File::read_rows(const std::string&, const std::vector<long long>&) const;
template std::vector<int> Hdf5File::read_rows(const std::string&, const std::vector<long long>&) const;
template std::vector<long long> Hdf5File::read_rows(const std::string&, const std::vector<long long>&) const;
template void Hdf5File::write_attribute(const std::string&, const std::string&, const double&);
template void Hdf5File::write_attribute(const std::string&, const std::string&, const long long&);
template void Hdf5File::write_attribute(const std::string&, const std::string&, const std::string&);
template double Hdf5File::read_attribute(const std::string&, const std::string&) const;
template long long Hdf5File::read_attribute(const std::string&, const std::string&) const;
template std::string Hdf5File::read_attribute(const std::string&, const std::string&) const;

}  // namespace voussoir

#include "output/checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>

#include "base/check.hpp"
#include "base/error.hpp"
#include "linalg/agree.hpp"
#include "linalg/reduce.hpp"
#include "output/safe_file.hpp"

namespace voussoir {
namespace {

const char* const group_of_numbers = "/run";

std::string beside(const std::string& path) { return path + ".part"; }

template <class T>
std::string outside(const std::string& path, const std::string& name, T number) {
  return cannot_read(path, name + " = " + std::to_string(number) + " outside its range");
}

/// Opens the file; one to be restored is looked at before HDF5, which may crash on a damaged one.
std::unique_ptr<Hdf5File> opened(const std::string& path, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                                 Checkpoint::Way way) {
  if (way == Checkpoint::Way::save) return std::make_unique<Hdf5File>(beside(path), comm, Hdf5File::Mode::create);
  on_first_rank(*comm, [&] { check_seal(path); });
  return std::make_unique<Hdf5File>(path, comm, Hdf5File::Mode::read);
}

}  // namespace

Checkpoint::Checkpoint(const std::string& path, const Teuchos::RCP<const Teuchos::Comm<int>>& comm, Way way)
    : path_(path), comm_(comm), way_(way), file_(opened(path, comm, way)) {}

Checkpoint::~Checkpoint() {
  if (saving() && file_ && comm_->getRank() == 0) std::remove(beside(path_).c_str());
}

template <class T>
void Checkpoint::value(const std::string& name, T& v) {
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int>) {
    auto wide = static_cast<long long>(v);
    value(name, wide);
    v = static_cast<T>(wide);
    if (v != wide) throw ResourceError(outside(path_, name, wide));
  } else if (saving()) {
    file_->write_attribute(group_of_numbers, name, v);
  } else {
    v = file_->read_attribute<T>(group_of_numbers, name);
  }
}

template <class T>
void Checkpoint::within(const std::string& name, T& number, double least, double most) {
  value(name, number);
  if (!saving() && !(least <= static_cast<double>(number) && static_cast<double>(number) <= most))
    throw ResourceError(outside(path_, name, number));
}

template <class T>
void Checkpoint::rows(const std::string& name, const LocalRows& local, int columns, std::vector<T>& values) {
  using Stored = std::conditional_t<std::is_same_v<T, double>, double, int>;
  const std::string path = "/state/" + name;
  const bool anywhere = any_of_ranks(*comm_, !values.empty());
  if (saving()) {
    if (!anywhere) return;
    VOUSSOIR_EXPECT(values.size() == local.ids.size() * columns);
    const std::vector<long long> ids(local.ids.begin(), local.ids.begin() + local.owned);
    const std::vector<Stored> owned(values.begin(), values.begin() + local.owned * columns);
    file_->write_rows(path, ids, owned, Table{local.total, columns, ""});
    return;
  }
  values.clear();
  if (!file_->has(path)) {
    if (anywhere) throw ResourceError(cannot_read(path_, name + " that is not there"));
    return;
  }
  const Table shape = file_->table(path);
  if (shape.rows != local.total || shape.columns != columns)
    throw ResourceError(cannot_read(path_, name + " of another size than the structure's"));
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < local.ids.size(); ++k)
    if (local.ids[k] >= 0) order.push_back(k);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return local.ids[a] < local.ids[b]; });
  std::vector<long long> ascending;
  for (const auto k : order) ascending.push_back(local.ids[k]);
  const auto stored = file_->read_rows<Stored>(path, ascending);
  values.resize(local.ids.size() * columns);
  for (std::size_t k = 0; k < order.size(); ++k)
    std::transform(stored.begin() + static_cast<long>(k) * columns, stored.begin() + static_cast<long>(k + 1) * columns,
                   values.begin() + static_cast<long>(order[k]) * columns, [](Stored v) { return static_cast<T>(v); });
  require_all(name + " with a number that is not finite",
              std::all_of(stored.begin(), stored.end(), [](Stored v) { return std::isfinite(double(v)); }));
}

void Checkpoint::require_all(const std::string& what, bool mine) const {
  if (!all_of_ranks(*comm_, mine)) throw ResourceError(cannot_read(path_, what));
}

template <class T>
void Checkpoint::rows_within(const std::string& name, const LocalRows& local, int columns, std::vector<T>& values,
                             double least, double most) {
  rows(name, local, columns, values);
  if (saving()) return;
  require_all(name + " with a number outside its range",
              std::all_of(values.begin(), values.end(), [&](T v) { return least <= v && v <= most; }));
}

void Checkpoint::texts(const std::string& name, std::vector<std::string>& lines) {
  const std::string path = "/texts/" + name;
  if (saving())
    file_->write_texts(path, lines);
  else if (file_->has(path))
    lines = file_->read_texts(path);
  else
    throw ResourceError(cannot_read(path_, name + " that is not there"));
}

void Checkpoint::publish() {
  file_->close();
  on_first_rank(*comm_, [this] {
    seal_file(beside(path_));
    publish_file(beside(path_), path_);
  });
  file_.reset();
}

template void Checkpoint::value(const std::string&, bool&);
template void Checkpoint::value(const std::string&, int&);
template void Checkpoint::value(const std::string&, long long&);
template void Checkpoint::value(const std::string&, double&);
template void Checkpoint::value(const std::string&, std::string&);
template void Checkpoint::within(const std::string&, int&, double, double);
template void Checkpoint::within(const std::string&, long long&, double, double);
template void Checkpoint::within(const std::string&, double&, double, double);
template void Checkpoint::rows(const std::string&, const LocalRows&, int, std::vector<char>&);
template void Checkpoint::rows(const std::string&, const LocalRows&, int, std::vector<int>&);
template void Checkpoint::rows(const std::string&, const LocalRows&, int, std::vector<double>&);
template void Checkpoint::rows_within(const std::string&, const LocalRows&, int, std::vector<char>&, double, double);
template void Checkpoint::rows_within(const std::string&, const LocalRows&, int, std::vector<double>&, double, double);

}  // namespace voussoir

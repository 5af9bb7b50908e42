// Tables of fields.h5 and of checkpoints: what is written by some ranks is what any ranks read.
#include "output/hdf5_file.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <stdexcept>

#include <sys/resource.h>

#include <Teuchos_UnitTestHarness.hpp>

#include "base/error.hpp"
#include "unit/output/folders.hpp"

namespace voussoir {
namespace {

using namespace test;
using Ids = std::vector<long long>;

/// Runs on one and on two ranks may happen side by side in the same folder.
std::string file_name(const std::string& name) { return name + "-np" + std::to_string(world()->getSize()) + ".h5"; }

/// Rows rank, rank + ranks, rank + 2 ranks, ...: no two rows of a rank are neighbours.
Ids interleaved(long long rows) {
  Ids ids;
  for (long long id = world()->getRank(); id < rows; id += world()->getSize()) ids.push_back(id);
  return ids;
}

Ids all_rows(long long rows) {
  Ids ids(static_cast<std::size_t>(rows));
  std::iota(ids.begin(), ids.end(), 0LL);
  return ids;
}

/// A value that tells its row and column.
template <class T>
std::vector<T> values_of(const Ids& ids, int columns) {
  std::vector<T> values;
  for (const long long id : ids)
    for (int c = 0; c < columns; ++c) values.push_back(static_cast<T>(10 * id + c));
  return values;
}

// Equal bit for bit: numbers are stored in the type they have in memory.
template <class T>
bool reads_back_equal(const std::string& name) {
  const std::string file = file_name(name);
  const long long rows = 23;  // does not divide by the number of ranks
  Hdf5File(file, world(), Hdf5File::Mode::create)
      .write_rows("/deep/er/table", interleaved(rows), values_of<T>(interleaved(rows), 3), {rows, 3, "m"});
  const Hdf5File written(file, world(), Hdf5File::Mode::read);
  return written.read_rows<T>("/deep/er/table", interleaved(rows)) == values_of<T>(interleaved(rows), 3) &&
         written.read_rows<T>("/deep/er/table", all_rows(rows)) == values_of<T>(all_rows(rows), 3);
}

std::string message_of_resource_error(const std::function<void()>& action) {
  try {
    action();
  } catch (const ResourceError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEUCHOS_UNIT_TEST(Hdf5File, RowsOfInterleavedNumbersReadBackEqualInEveryType) {
  TEST_ASSERT(reads_back_equal<double>("double"));
  TEST_ASSERT(reads_back_equal<int>("int"));
  TEST_ASSERT(reads_back_equal<long long>("long"));
}

TEUCHOS_UNIT_TEST(Hdf5File, ARankMayOwnNoRowsAndATableMayHaveNone) {
  const std::string file = file_name("empty-rank");
  const bool last = world()->getRank() == world()->getSize() - 1;
  {
    Hdf5File written(file, world(), Hdf5File::Mode::create);
    const Ids mine = last ? all_rows(5) : Ids{};
    written.write_rows("/full", mine, values_of<int>(mine, 1), {5, 1, "-"});
    written.write_rows("/none", Ids{}, std::vector<double>{}, {0, 2, "m"});
  }
  const Hdf5File read(file, world(), Hdf5File::Mode::read);
  TEST_ASSERT(read.read_rows<int>("/full", all_rows(5)) == values_of<int>(all_rows(5), 1));
  TEST_ASSERT(read.read_rows<int>("/full", last ? Ids{} : Ids{3}) == (last ? std::vector<int>{} : std::vector{30}));
  TEST_EQUALITY(read.table("/none").rows, 0);
  TEST_EQUALITY(read.table("/none").columns, 2);
  TEST_ASSERT(read.read_rows<double>("/none", Ids{}).empty());
}

TEUCHOS_UNIT_TEST(Hdf5File, ATableTellsItsShapeUnitAndMeaning) {
  const std::string file = file_name("shape");
  Hdf5File(file, world(), Hdf5File::Mode::create)
      .write_rows("/gap", interleaved(7), values_of<double>(interleaved(7), 1), {7, 1, "m", "> 0 open"});
  const Hdf5File read(file, world(), Hdf5File::Mode::read);
  TEST_EQUALITY(read.table("/gap").rows, 7);
  TEST_EQUALITY(read.table("/gap").columns, 1);
  TEST_EQUALITY(read.table("/gap").unit, "m");
  TEST_EQUALITY(read.table("/gap").text, "> 0 open");
  TEST_ASSERT(read.has("/gap"));
  TEST_ASSERT(!read.has("/slip"));
  TEST_ASSERT(!read.has("/steps/0001/gap"));
}

// HDF5 reads views in serial only, so their numbers are looked at from Python in read_fields.py.
TEUCHOS_UNIT_TEST(Hdf5File, APaddedViewHasTheRowsOfItsSourceAndMoreColumns) {
  const std::string file = file_name("padded");
  {
    Hdf5File written(file, world(), Hdf5File::Mode::create);
    written.write_rows("/a/u", interleaved(4), values_of<double>(interleaved(4), 2), {4, 2, "m"});
    written.write_padded_view("/a/u_xyz", "/a/u", 3);
  }
  const Hdf5File read(file, world(), Hdf5File::Mode::read);
  TEST_EQUALITY(read.table("/a/u_xyz").rows, 4);
  TEST_EQUALITY(read.table("/a/u_xyz").columns, 3);
  TEST_EQUALITY(read.table("/a/u_xyz").unit, "m");
}

TEUCHOS_UNIT_TEST(Hdf5File, TextsAndAttributesReadBackEqual) {
  const std::string file = file_name("texts");
  const std::vector<std::string> names = {"ring west", "", "Gewölbe"};
  {
    Hdf5File written(file, world(), Hdf5File::Mode::create);
    written.write_texts("/names", names);
    written.write_texts("/nobody", {});
    written.write_attribute("/steps/0001", "stage", std::string("own weight"));
    written.write_attribute("/steps/0001", "load_factor", 0.1);
    written.write_attribute("/steps/0001", "step", 1LL);
  }
  const Hdf5File read(file, world(), Hdf5File::Mode::read);
  TEST_ASSERT(read.read_texts("/names") == names);
  TEST_ASSERT(read.read_texts("/nobody").empty());
  TEST_EQUALITY(read.read_attribute<std::string>("/steps/0001", "stage"), "own weight");
  TEST_EQUALITY(read.read_attribute<double>("/steps/0001", "load_factor"), 0.1);
  TEST_EQUALITY(read.read_attribute<long long>("/steps/0001", "step"), 1);
}

TEUCHOS_UNIT_TEST(Hdf5File, WhatWasFlushedCanBeReadWhileTheFileIsStillOpen) {
  const std::string file = file_name("open"), copy = file_name("copy");
  Hdf5File written(file, world(), Hdf5File::Mode::create);
  written.write_rows("/t", interleaved(9), values_of<double>(interleaved(9), 1), {9, 1, "m"});
  written.flush();
  world()->barrier();
  if (world()->getRank() == 0)
    std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing);
  world()->barrier();
  const Hdf5File read(copy, world(), Hdf5File::Mode::read);
  TEST_ASSERT(read.read_rows<double>("/t", all_rows(9)) == values_of<double>(all_rows(9), 1));
}

TEUCHOS_UNIT_TEST(Hdf5File, ARowWithoutOrWithTwoOwnersIsABrokenContractOnAllRanks) {
  Hdf5File written(file_name("owners"), world(), Hdf5File::Mode::create);
  TEST_THROW(written.write_rows("/missing", interleaved(5), values_of<int>(interleaved(5), 1), {6, 1, "-"}),
             std::logic_error);
  TEST_THROW(written.write_rows("/disorder", Ids{1, 0}, std::vector<int>{1, 0}, {2, 1, "-"}), std::logic_error);
  if (world()->getSize() > 1) {
    TEST_THROW(written.write_rows("/twice", all_rows(2), std::vector<int>{0, 1}, {2, 1, "-"}), std::logic_error);
  }
}

TEUCHOS_UNIT_TEST(Hdf5File, AFileThatCannotBeWrittenIsNamedOnAllRanks) {
  // A folder below a regular file cannot exist, not even for root.
  const std::string blocked = file_name("regular");
  if (world()->getRank() == 0) std::ofstream(blocked) << "not a folder";
  world()->barrier();
  const std::string message =
      message_of_resource_error([&] { Hdf5File(blocked + "/fields.h5", world(), Hdf5File::Mode::create); });
  TEST_ASSERT(contains(message, blocked + "/fields.h5: cannot be written"));
  TEST_ASSERT(contains(message, "Not a directory"));
}

TEUCHOS_UNIT_TEST(Hdf5File, AFileOrTableThatCannotBeReadIsNamedOnAllRanks) {
  TEST_ASSERT(contains(message_of_resource_error([] { Hdf5File("nowhere.h5", world(), Hdf5File::Mode::read); }),
                       "nowhere.h5: cannot be read"));
  const std::string file = file_name("not-hdf5");
  if (world()->getRank() == 0) std::ofstream(file) << "not HDF5";
  world()->barrier();
  TEST_ASSERT(contains(message_of_resource_error([&] { Hdf5File(file, world(), Hdf5File::Mode::read); }), file));

  const std::string good = file_name("no-table");
  Hdf5File(good, world(), Hdf5File::Mode::create).write_attribute("/steps", "step", 1LL);
  const Hdf5File read(good, world(), Hdf5File::Mode::read);
  TEST_ASSERT(contains(message_of_resource_error([&] { read.read_rows<int>("/t", Ids{}); }), good));
  TEST_ASSERT(contains(message_of_resource_error([&] { read.read_attribute<double>("/steps", "time"); }), good));
}

// A limit on the size of files stands for a full disk: the system refuses the write in the same way.
TEUCHOS_UNIT_TEST(Hdf5File, AFullDiskIsAResourceErrorOnAllRanks) {
  const std::string file = file_name("full");
  const long long rows = 20000;  // 160 kB, ten times the limit
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  std::string message;
  {
    Hdf5File written(file, world(), Hdf5File::Mode::create);
    rlimit tight = before;
    tight.rlim_cur = 16384;
    setrlimit(RLIMIT_FSIZE, &tight);
    message = message_of_resource_error([&] {
      written.write_rows("/t", interleaved(rows), values_of<double>(interleaved(rows), 1), {rows, 1, "m"});
      written.flush();
    });
    setrlimit(RLIMIT_FSIZE, &before);
  }
  std::signal(SIGXFSZ, handler);
  TEST_ASSERT(contains(message, file + ": cannot be written"));
}

}  // namespace
}  // namespace voussoir

// What a run saves is what it gets back, on any number of ranks; half a checkpoint never replaces a whole one.
#include "output/checkpoint.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "base/error.hpp"
#include "output/history.hpp"
#include "output/output_folder.hpp"
#include "unit/output/folders.hpp"

namespace voussoir {
namespace {

using namespace test;
namespace fs = std::filesystem;
using Way = Checkpoint::Way;

/// Rows this rank owns, ascending, then some of its neighbour's as a halo.
LocalRows with_halo(long long total) {
  const int rank = world()->getRank(), ranks = world()->getSize();
  LocalRows rows;
  rows.total = total;
  for (long long k = rank; k < total; k += ranks) rows.ids.push_back(k);
  rows.owned = static_cast<long long>(rows.ids.size());
  for (long long k = (rank + 1) % ranks; ranks > 1 && k < total / 2; k += ranks) rows.ids.push_back(k);
  return rows;
}

double value_of(long long row, int column) { return std::sin(static_cast<double>(3 * row + column)) / 3; }

std::vector<double> values_of(const LocalRows& rows, int columns) {
  std::vector<double> values;
  for (const long long id : rows.ids)
    for (int c = 0; c < columns; ++c) values.push_back(value_of(id, c));
  return values;
}

/// One of everything a checkpoint can hold.
struct Everything {
  bool flag = false;
  int count = 0;
  long long large = 0;
  double number = 0, tiny = 0;
  std::string text;
  std::vector<double> field, nothing;
  std::vector<char> marks;

  void keep(Checkpoint& archive, const LocalRows& rows) {
    archive.value("flag", flag);
    archive.value("count", count);
    archive.value("large", large);
    archive.value("number", number);
    archive.value("tiny", tiny);
    archive.value("text", text);
    archive.rows("field", rows, 2, field);
    archive.rows("nothing", rows, 2, nothing);
    archive.rows("marks", rows, 1, marks);
  }
};

Everything example(const LocalRows& rows) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  Everything all{true, -7, 5'000'000'000, 0.1, tiny, "stage \"1\" < 2", {}, {}, {}};
  all.field = values_of(rows, 2);
  for (const long long id : rows.ids) all.marks.push_back(id % 3 == 0);
  return all;
}

void save(const std::string& path, Everything what, const LocalRows& rows) {
  Checkpoint archive(path, world(), Way::save);
  what.keep(archive, rows);
  archive.publish();
}

TEUCHOS_UNIT_TEST(Checkpoint, GivesBackEverythingToTheLastBitHaloIncluded) {
  const std::string path = fresh_folder("checkpoint") + "/checkpoint.h5";
  const auto rows = with_halo(17);
  const auto saved = example(rows);
  save(path, saved, rows);
  Everything back;
  Checkpoint archive(path, world(), Way::restore);
  back.keep(archive, rows);
  TEST_EQUALITY(back.flag, saved.flag);
  TEST_EQUALITY(back.count, saved.count);
  TEST_EQUALITY(back.large, saved.large);
  TEST_EQUALITY(back.number, saved.number);
  TEST_EQUALITY(back.tiny, saved.tiny);
  TEST_EQUALITY(back.text, saved.text);
  TEST_ASSERT(back.field == saved.field);
  TEST_ASSERT(back.nothing.empty());
  TEST_ASSERT(back.marks == saved.marks);
}

TEUCHOS_UNIT_TEST(Checkpoint, DoesNotKnowHowManyRanksWroteIt) {
  const std::string path = fresh_folder("checkpoint-ranks") + "/checkpoint.h5";
  const auto rows = with_halo(11);
  save(path, example(rows), rows);
  // Every rank reads all rows, in an order that is not theirs.
  LocalRows all{{7, 8, 9, 10, 0, 1, 2, 3, 4, 5, 6}, 4, 11};
  Everything back;
  Checkpoint archive(path, world(), Way::restore);
  back.keep(archive, all);
  TEST_ASSERT(back.field == values_of(all, 2));
}

TEUCHOS_UNIT_TEST(Checkpoint, TheLastOneStaysUntilTheNextIsWhole) {
  const std::string folder = fresh_folder("checkpoint-half"), path = folder + "/checkpoint.h5";
  const auto rows = with_halo(5);
  save(path, example(rows), rows);
  {
    Checkpoint given_up(path, world(), Way::save);
    int count = 99;
    given_up.value("count", count);
    TEST_ASSERT(fs::exists(path));
  }
  world()->barrier();
  Everything back;
  Checkpoint archive(path, world(), Way::restore);
  back.keep(archive, rows);
  TEST_EQUALITY(back.count, -7);
  TEST_ASSERT(!fs::exists(path + ".part"));
}

TEUCHOS_UNIT_TEST(Checkpoint, AValueThatIsNotThereIsAnErrorOnAllRanks) {
  const std::string path = fresh_folder("checkpoint-lacks") + "/checkpoint.h5";
  const auto rows = with_halo(5);
  save(path, example(rows), rows);
  Checkpoint archive(path, world(), Way::restore);
  int unknown = 0;
  TEST_THROW(archive.value("unknown", unknown), ResourceError);
}

TEUCHOS_UNIT_TEST(Checkpoint, DamageAnywhereIsSeenBeforeHdf5ReadsIt) {
  const std::string path = fresh_folder("checkpoint-damaged") + "/checkpoint.h5";
  const auto rows = with_halo(5);
  save(path, example(rows), rows);
  const auto size = static_cast<long>(fs::file_size(path));
  for (const long place : {0L, size / 3, size / 2, size - 1}) {
    const auto turn = [&] {  // one bit, there and back
      if (world()->getRank() == 0) {
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekg(place);
        const auto byte = static_cast<char>(file.get() ^ 1);
        file.seekp(place);
        file.put(byte);
      }
      world()->barrier();
    };
    turn();
    TEST_THROW(Checkpoint(path, world(), Way::restore), ResourceError);
    world()->barrier();
    turn();
    TEST_NOTHROW(Checkpoint(path, world(), Way::restore));
    world()->barrier();
  }
}

TEUCHOS_UNIT_TEST(Checkpoint, TablesOfAnotherSizeAndNumbersThatAreNoneAreErrorsOnAllRanks) {
  const std::string path = fresh_folder("checkpoint-other") + "/checkpoint.h5";
  const auto rows = with_halo(7);
  auto saved = example(rows);
  if (world()->getRank() == 0) saved.field[1] = std::numeric_limits<double>::quiet_NaN();
  save(path, saved, rows);
  Checkpoint archive(path, world(), Way::restore);
  std::vector<double> field;
  TEST_THROW(archive.rows("field", rows, 3, field), ResourceError);          // it has 2 columns
  TEST_THROW(archive.rows("field", with_halo(6), 2, field), ResourceError);  // it has 7 rows
  TEST_THROW(archive.rows("field", rows, 2, field), ResourceError);          // not finite
  int count = 0;
  bool flag = false;
  TEST_THROW(archive.value("text", flag), ResourceError);
  TEST_THROW(archive.value("large", count), ResourceError);  // 5e9 is no int
  TEST_THROW(archive.value("count", flag), ResourceError);   // -7 is neither true nor false
  std::string text;
  TEST_THROW(archive.value("number", text), ResourceError);
  std::vector<double> needed(rows.ids.size(), 0.0);
  TEST_THROW(archive.rows("nothing", rows, 1, needed), ResourceError);  // there were values
}

TEUCHOS_UNIT_TEST(Checkpoint, NumbersOutsideTheirRangeAreErrorsOnAllRanks) {
  const std::string path = fresh_folder("checkpoint-range") + "/checkpoint.h5";
  const auto rows = with_halo(7);
  auto saved = example(rows);
  saved.tiny = std::numeric_limits<double>::quiet_NaN();
  save(path, saved, rows);
  Checkpoint archive(path, world(), Way::restore);
  int count = 0;
  TEST_THROW(archive.within("count", count, 0, 9), ResourceError);  // -7
  TEST_THROW(archive.within("count", count, -9, -8), ResourceError);
  archive.within("count", count, -7, -7);
  TEST_EQUALITY_CONST(count, -7);
  long long large = 0;
  TEST_THROW(archive.within("large", large, 0, 4e9), ResourceError);
  double number = 0;
  TEST_THROW(archive.within("number", number, 0.2, 1), ResourceError);
  TEST_THROW(archive.within("tiny", number, -1, std::numeric_limits<double>::infinity()), ResourceError);  // NaN
}

TEUCHOS_UNIT_TEST(History, IsCutBehindTheRowsThatCount) {
  const std::string path = fresh_folder("history-cut") + "/history.csv";
  const auto append = [&](History& history, int step) {
    HistoryRow row;
    row.step = step;
    row.stage = "push";
    history.append(row);
  };
  {
    History history(path, world());
    for (int step : {1, 2, 3}) append(history, step);
  }
  {
    History again(path, world(), 2);
    append(again, 33);
  }
  world()->barrier();
  std::ifstream lines(path);
  std::string line, steps;
  std::getline(lines, line);
  TEST_EQUALITY(line, History::heading());
  while (std::getline(lines, line)) steps += line.substr(0, line.find(',')) + ' ';
  TEST_EQUALITY(steps, "1 2 33 ");
}

TEUCHOS_UNIT_TEST(OutputFolder, AnInterruptedRunIsLeftAloneUnlessToldOtherwise) {
  const std::string folder = fresh_folder("interrupted");
  if (world()->getRank() == 0) std::ofstream(folder + "/" + checkpoint_file) << "state";
  world()->barrier();
  TEST_THROW(OutputFolder(folder, Earlier::keep, *world()).kept(), ResourceError);
  TEST_ASSERT(fs::exists(folder + "/" + checkpoint_file));
  OutputFolder(folder, Earlier::go_on, *world()).kept();
  TEST_ASSERT(fs::exists(folder + "/" + checkpoint_file));
  world()->barrier();  // before the first rank removes what the others look for
  OutputFolder(folder, Earlier::remove, *world()).kept();
  TEST_ASSERT(!fs::exists(folder + "/" + checkpoint_file));
  TEST_THROW(OutputFolder(folder, Earlier::go_on, *world()).kept(), ResourceError);
}

TEUCHOS_UNIT_TEST(OutputFolder, BelongsToOneRunAtATime) {
  const std::string folder = fresh_folder("locked") + "/wall";
  {
    const OutputFolder first(folder, Earlier::keep, *world());
    for (const auto earlier : {Earlier::keep, Earlier::remove, Earlier::go_on})
      TEST_THROW(OutputFolder(folder, earlier, *world()), ResourceError);
  }
  world()->barrier();
  TEST_NOTHROW(OutputFolder(folder, Earlier::keep, *world()));
}

TEUCHOS_UNIT_TEST(OutputFolder, WhatAKilledRunLeftBeforeItsFirstCheckpointIsKeptBeside) {
  const std::string folder = fresh_folder("killed") + "/wall";
  OutputFolder(folder, Earlier::keep, *world()).kept();
  if (world()->getRank() == 0) std::ofstream(folder + "/history.csv") << "rows";
  world()->barrier();
  const std::string kept = OutputFolder(folder, Earlier::keep, *world()).kept();
  TEST_EQUALITY(kept, folder + ".1");
  TEST_ASSERT(fs::exists(folder + ".1/history.csv"));
  TEST_ASSERT(fs::is_empty(folder));
}

}  // namespace
}  // namespace voussoir

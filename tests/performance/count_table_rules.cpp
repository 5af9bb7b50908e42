// The rules by which counts are compared with the table: what is no change, what is more, what is fewer.
#include <Teuchos_UnitTestHarness.hpp>
#include <sstream>
#include <stdexcept>

#include "performance/count_table.hpp"

namespace {

using namespace voussoir::test;

const Range hundred{100, 100}, six{6, 6}, none_at_all{0, 0};

TEUCHOS_UNIT_TEST(CountTable, ATenthOfTheKeptCountIsNoChange) {
  TEST_ASSERT(change_of(hundred, 110) == Change::none);
  TEST_ASSERT(change_of(hundred, 111) == Change::more);
  TEST_ASSERT(change_of(hundred, 90) == Change::none);
  TEST_ASSERT(change_of(hundred, 89) == Change::fewer);
}

TEUCHOS_UNIT_TEST(CountTable, OneIsNoChangeHoweverFewThereAre) {
  TEST_ASSERT(change_of(six, 7) == Change::none);
  TEST_ASSERT(change_of(six, 8) == Change::more);
  TEST_ASSERT(change_of(six, 4) == Change::fewer);
  TEST_ASSERT(change_of(none_at_all, 1) == Change::none);
  TEST_ASSERT(change_of(none_at_all, 2) == Change::more);
}

TEUCHOS_UNIT_TEST(CountTable, WhatAnyProcessorCountsIsNoChange) {
  const Range kept{100, 200};
  for (int counted : {90, 100, 150, 200, 220}) TEST_ASSERT(change_of(kept, counted) == Change::none);
  TEST_ASSERT(change_of(kept, 221) == Change::more);
  TEST_ASSERT(change_of(kept, 89) == Change::fewer);
}

TEUCHOS_UNIT_TEST(CountTable, OfACountThatJumpsOnlyTwiceTheMostIsTooMuch) {
  const Range kept{12, 197, true};
  for (int counted : {0, 12, 394}) TEST_ASSERT(change_of(kept, counted) == Change::none);
  TEST_ASSERT(change_of(kept, 395) == Change::more);
}

TEUCHOS_UNIT_TEST(CountTable, OneCountThatRoseCountsForAllThatFell) {
  const CountRanges kept{{10, 10}, {100, 100}, {10, 10}, {0, 0}};
  TEST_ASSERT(change_of(kept, {10, 80, 10, 0}) == Change::fewer);
  TEST_ASSERT(change_of(kept, {5, 50, 5, 9}) == Change::more);
  TEST_ASSERT(change_of(kept, {10, 100, 15, 0}) == Change::more);
  TEST_ASSERT(change_of(kept, {11, 109, 9, 1}) == Change::none);
}

TEUCHOS_UNIT_TEST(CountTable, ASceneThatIsMissingFailsAndPrintsItsCounts) {
  std::ostringstream said;
  TEST_ASSERT(!as_in_table("no such scene", {1, 2, 3, 4}, said));
  TEST_ASSERT(said.str().find("\n  counted: no such scene,1,2,3,4\n") != std::string::npos);
}

TEUCHOS_UNIT_TEST(CountTable, RowsAreReadWholeOrNotAtAll) {
  const std::string head = "# of some processors\nscene,solves,krylov,whole,patches\n";
  const auto rows = read_counts(head + "W(8) pushed,1,2-5,3,~4-40\n# a remark\nA(9),5,6,7,8\n");
  TEST_EQUALITY(rows.size(), 2);
  TEST_EQUALITY(rows.at("W(8) pushed").text(), "1,2-5,3,~4-40");
  for (const char* wrong :
       {"A(9),5,6,7", "A(9),5,6,7,8,", "A(9),5,6,7,8,9", "A(9),five,6,7,8", ",5,6,7,8", "A(9),1,2,3,4\nA(9),1,2,3,4",
        "A(9),2-1,2,3,4", "A(9),1+2,2,3,4", "A(9),1-2-3,2,3,4", "A(9),-1,2,3,4", "A(9),~,2,3,4"})
    TEST_THROW(read_counts(head + wrong), std::runtime_error);
  TEST_THROW(read_counts("A(9),5,6,7,8\n"), std::runtime_error);
  TEST_THROW(read_counts(""), std::runtime_error);
}

}  // namespace

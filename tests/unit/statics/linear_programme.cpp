// Small linear programmes whose answers are known by heart.
#include "statics/linear_programme.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <limits>

namespace {

using namespace voussoir;

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double close = 1e-12;

/// 3 x + 5 y with x <= 4, 2 y <= 12, 3 x + 2 y <= 18: 36 at (2, 6).
LinearProgramme workshop() {
  LinearProgramme p;
  for (const double b : {4.0, 12.0, 18.0}) p.add_row(-endless, b);
  p.add_column({{0, 1}, {2, 3}}, 0, endless, 3);
  p.add_column({{1, 2}, {2, 2}}, 0, endless, 5);
  return p;
}

TEUCHOS_UNIT_TEST(LinearProgramme, FindsTheLargestValueAndWhatBoundsAreWorth) {
  auto p = workshop();
  const auto found = p.maximise();
  TEST_ASSERT(found.end == ProgrammeEnd::optimal);
  TEST_FLOATING_EQUALITY(found.value, 36.0, close);
  TEST_FLOATING_EQUALITY(found.x[0], 2.0, close);
  TEST_FLOATING_EQUALITY(found.x[1], 6.0, close);
  TEST_ASSERT(std::abs(found.price[0]) < close);
  TEST_FLOATING_EQUALITY(found.price[1], 1.5, close);
  TEST_FLOATING_EQUALITY(found.price[2], 1.0, close);
}

TEUCHOS_UNIT_TEST(LinearProgramme, GoesOnFromTheLastBasisWhereNumbersChange) {
  auto p = workshop();
  p.maximise();
  p.set_column(1, 0, 3);
  TEST_FLOATING_EQUALITY(p.maximise().value, 27.0, close);
  p.set_column(1, 0, endless);
  p.set_row(1, -endless, 14);
  TEST_FLOATING_EQUALITY(p.maximise().value, 39.0, close);
  p.set_row(1, -endless, 12);
  p.set_cost(0, -1);
  TEST_FLOATING_EQUALITY(p.maximise().value, 30.0, close);
}

TEUCHOS_UNIT_TEST(LinearProgramme, BeginsFromTheBasisOfAnotherAndEndsAtItsOwnAnswer) {
  auto first = workshop();
  TEST_ASSERT(first.basis().empty());
  const auto from_nothing = first.maximise();
  TEST_COMPARE(from_nothing.iterations, >, 0);
  auto same = workshop();
  same.start_from(first.basis());
  const auto found = same.maximise();
  TEST_EQUALITY(found.iterations, 0);
  TEST_FLOATING_EQUALITY(found.value, 36.0, close);
  // One whose best corner is another: x alone is worth anything, so it goes from (2, 6) to (4, 3).
  auto other = workshop();
  other.set_cost(1, 0.5);
  other.start_from(first.basis());
  TEST_FLOATING_EQUALITY(other.maximise().value, 13.5, close);
  auto more = workshop();
  more.add_column({{2, 1}}, 0, endless, 0.5);  // worth less than its row: it stays at rest
  more.start_from(first.basis());
  const auto at_rest = more.maximise();
  TEST_EQUALITY(at_rest.iterations, 0);
  TEST_FLOATING_EQUALITY(at_rest.value, 36.0, close);
  LinearProgramme small;
  small.add_row(-endless, 3);
  small.add_column({{0, 1}}, 0, endless, 2);
  small.start_from(first.basis());  // of no use to it
  TEST_FLOATING_EQUALITY(small.maximise().value, 6.0, close);
}

TEUCHOS_UNIT_TEST(LinearProgramme, GoesOnWithColumnsThatAreAddedAndChangedBeforeItIsAskedAgain) {
  auto p = workshop();
  p.maximise();
  p.add_column({{2, 1}}, 0, endless, 0);  // at a worth of 1 for the third bound: one by one, then changed
  const int dear = p.add_column({{2, 1}}, 0, endless, 0);
  p.add_column({{1, 4}}, 0, endless, 1);
  p.set_cost(dear, 4);
  p.set_column(dear, 0, 5);
  const auto found = p.maximise();
  TEST_ASSERT(found.end == ProgrammeEnd::optimal);
  TEST_FLOATING_EQUALITY(found.value, 51.0, close);  // 5 of it and of y 6, x 1/3
  TEST_FLOATING_EQUALITY(found.x[static_cast<std::size_t>(dear)], 5.0, close);
  TEST_EQUALITY(p.basis().size(), 8);
  p.add_column({{2, 1}}, 0, endless, 5);
  TEST_EQUALITY(p.basis().size(), 9);
  TEST_FLOATING_EQUALITY(p.maximise_from_prices().value, 93.0, close);  // 18 of it, and 3 of the one before
}

TEUCHOS_UNIT_TEST(LinearProgramme, TellsWhatCannotBeMetFromWhatHasNoEnd) {
  LinearProgramme contradicts;
  contradicts.add_row(1, 1);
  contradicts.add_row(2, 2);
  contradicts.add_column({{0, 1}, {1, 1}}, -endless, endless, 1);
  TEST_ASSERT(contradicts.maximise().end == ProgrammeEnd::infeasible);
  LinearProgramme grows;
  grows.add_row(0, 0);
  grows.add_column({{0, 1}}, 0, endless, 1);
  grows.add_column({{0, -1}}, 0, endless, 1);
  TEST_ASSERT(grows.maximise().end == ProgrammeEnd::unbounded);
}

TEUCHOS_UNIT_TEST(LinearProgramme, IsMovedAndStillThere) {
  auto p = workshop();
  auto q = std::move(p);
  TEST_EQUALITY(q.rows(), 3);
  TEST_EQUALITY(q.columns(), 2);
  TEST_FLOATING_EQUALITY(q.maximise().value, 36.0, close);
}

}  // namespace

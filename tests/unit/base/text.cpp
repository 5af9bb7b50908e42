// Numbers and words of messages.
#include "base/text.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <limits>

#include "base/range.hpp"
#include "base/words.hpp"

namespace {

using namespace voussoir;

TEUCHOS_UNIT_TEST(Text, NumbersAreShortAndReadBackExactly) {
  TEST_EQUALITY_CONST(number_text(0.1), "0.1");
  TEST_EQUALITY_CONST(number_text(2e10), "2e10");
  TEST_EQUALITY_CONST(number_text(1e-8), "1e-8");
  TEST_EQUALITY_CONST(number_text(-0.25), "-0.25");
  TEST_EQUALITY_CONST(number_text(INFINITY), "inf");
  using Limits = std::numeric_limits<double>;
  for (const double x :
       {1.0 / 3, 1e22, 1e23, Limits::max(), Limits::min(), Limits::denorm_min(), -0.0, std::nextafter(1.0, 2.0)}) {
    TEST_ASSERT(number_in(number_text(x)).has_value());
    TEST_EQUALITY(*number_in(number_text(x)), x);
  }
}

TEUCHOS_UNIT_TEST(Text, OnlyAWholeNumberIsANumber) {
  for (const char* text : {"", "1e9x", "1,5", "1 m", "0x10", "--1", "+-1", "1e999", "e5"})
    TEST_ASSERT(!number_in(text));
  for (const char* text : {"1.5", "", "99999999999", "1e3", "one"}) TEST_ASSERT(!whole_number_in(text));
  TEST_EQUALITY_CONST(*number_in(" +1.5e3 "), 1500.0);
  TEST_ASSERT(std::isinf(*number_in("inf")));
  TEST_EQUALITY_CONST(*whole_number_in("-7"), -7);
  TEST_EQUALITY_CONST(*truth_in("True"), true);
  TEST_ASSERT(!truth_in("maybe"));
}

TEUCHOS_UNIT_TEST(Text, TheNearestWordIsTheOneMeant) {
  const std::vector<std::string> keys{"friction coefficient", "cohesion", "tension strength", "on"};
  TEST_EQUALITY_CONST(nearest("friction", keys), "friction coefficient");
  TEST_EQUALITY_CONST(nearest("Cohesion", keys), "cohesion");
  TEST_EQUALITY_CONST(nearest("tension_strenght", keys), "tension strength");
  TEST_EQUALITY_CONST(nearest("no", keys), "on");
  TEST_EQUALITY_CONST(nearest("gravity", keys), "");
  TEST_EQUALITY_CONST(nearest(std::string(100000, 'a'), keys), "");
}

TEUCHOS_UNIT_TEST(Text, OneThingIsNamedAsOne) {
  TEST_EQUALITY(counted(1, "stone"), "1 stone");
  TEST_EQUALITY(counted(std::size_t{0}, "stone"), "0 stones");
  TEST_EQUALITY(counted(2LL, "vertex", "vertices"), "2 vertices");
  TEST_EQUALITY(counted(1, "face is", "faces are"), "1 face is");
}

TEUCHOS_UNIT_TEST(Text, OnlyLettersOfAsciiBecomeSmall) {
  TEST_EQUALITY(in_small_letters("CM/S^2 \xc3\x84"), "cm/s^2 \xc3\x84");
}

TEUCHOS_UNIT_TEST(Text, PlainTextIsUtf8OfOneLine) {
  TEST_ASSERT(is_plain_text("caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x8f\x9b"));
  for (const char* text : {"a\nb", "\xe9", "\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\x7f"})
    TEST_ASSERT(!is_plain_text(text));
}

TEUCHOS_UNIT_TEST(Range, EndsBelongToItAsItsTextSays) {
  TEST_ASSERT(at_least(0).contains(0) && !above(0).contains(0));
  TEST_ASSERT(!inside(-1, 0.5).contains(0.5) && above_up_to(0, 1).contains(1) && !from_below(0, 1).contains(1));
  TEST_ASSERT(between(2, 8).even().contains(4) && !between(2, 8).even().contains(5));
  TEST_EQUALITY_CONST(inside(-1, 0.5).text(), "> -1 and < 0.5");
  TEST_EQUALITY_CONST(at_least(0).or_infinite().text(), ">= 0 or inf");
}

TEUCHOS_UNIT_TEST(Range, InfinityOnlyWhereItIsAllowedAndNeverNan) {
  TEST_ASSERT(!any_number().contains(INFINITY) && at_least(0).or_infinite().contains(INFINITY));
  TEST_ASSERT(!at_least(0).or_infinite().contains(-INFINITY));
  TEST_ASSERT(!any_number().contains(NAN) && !at_least(0).or_infinite().contains(NAN));
}

}  // namespace

// Records as networks, table programs and people write them: read as a scene lays them out, or refused with its keys.
#include "loads/time_series.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <fstream>

#include "base/error.hpp"
#include "loads/acceleration_unit.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double exact = 1e-15;  // numbers are read to the last bit; times are a product of two

/// Reads a file of this text. Collective: other ranks wait for the first to have written and read.
TimeSeries read(const std::string& text, const RecordLayoutParameters& layout = {}, int column = 0) {
  const std::string file = "time_series.txt";
  if (everyone()->getRank() == 0) std::ofstream(file) << text;
  return read_time_series(file, layout, {"x column", column}, "scene > loads > quake > x record", *everyone());
}

std::string said(const std::string& text, const RecordLayoutParameters& layout = {}, int column = 0) {
  try {
    read(text, layout, column);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool names(const std::string& message, const std::vector<std::string>& pieces) {
  if (message.rfind("scene > loads > quake > x record = ", 0) != 0) return false;
  for (const auto& piece : pieces)
    if (message.find(piece) == std::string::npos) return false;
  return true;
}

RecordLayoutParameters values_every(double time_step) {
  RecordLayoutParameters p;
  p.layout = RecordLayout::values;
  p.time_step = time_step;
  return p;
}

RecordLayoutParameters at2() {
  RecordLayoutParameters p;
  p.layout = RecordLayout::peer_at2;
  return p;
}

RecordLayoutParameters times_in(int column) {
  RecordLayoutParameters p;
  p.time_column = column;
  return p;
}

TEUCHOS_UNIT_TEST(TimeSeries, OfMoreThanTwoColumnsIsRefusedUnlessTheSceneNamesThem) {
  const std::string numbered = ",time [s],acc [m/s2]\n0,0.00,0.05\n1,0.01,0.25\n2,0.02,-0.45\n";
  TEST_ASSERT(names(said(numbered), {"line 2 must hold two numbers, the time [s] and its value, but holds 3",
                                     "time column", "x column", "layout = values"}));
  const auto read_so = read(numbered, times_in(2), 3);
  TEST_COMPARE_ARRAYS(read_so.time, (std::vector<double>{0, 0.01, 0.02}));
  TEST_COMPARE_ARRAYS(read_so.value, (std::vector<double>{0.05, 0.25, -0.45}));
  // Blanks, tabs and semicolons do not hide a column; nor do two components beside the time.
  for (const std::string row : {"1 0.01 0.2", "1\t0.01\t0.2", "1;0.01;0.2", "0.01, 0.2, 0.1", "0.01 0.2 0.1 0.3"})
    TEST_ASSERT(names(said(row + "\n"), {"line 1 must hold two numbers"}));
  TEST_COMPARE_ARRAYS(read("0 7 1\n1 8 2\n", times_in(1), 3).value, (std::vector<double>{1, 2}));
  TEST_COMPARE_ARRAYS(read("0 7 1\n1 8 2\n", times_in(1), 2).value, (std::vector<double>{7, 8}));
}

TEUCHOS_UNIT_TEST(TimeSeries, OfColumnsHasNoRowShorterOrLongerThanTheOthers) {
  TEST_ASSERT(names(said("0 1 2\n1 3\n", times_in(1), 3), {"line 2 must hold 3 numbers or more", "x column = 3"}));
  TEST_ASSERT(names(said("0 1 2 3\n1 3 4\n", times_in(1), 3), {"line 2 must hold 4 numbers like the rows above"}));
  TEST_ASSERT(names(said("0,1,2\n1,,3\n", times_in(1), 3), {"line 2", "has an empty field"}));
  TEST_EQUALITY(read("0,1,2,\n1,2,3,\n", times_in(1), 3).value.size(), 2u);  // a separator that ends the line
}

TEUCHOS_UNIT_TEST(TimeSeries, OfValuesAloneIsRefusedWithTheKeysThatReadIt) {
  const std::string fives = "1e-3 2e-3 3e-3 4e-3 5e-3\n6e-3 7e-3\n";
  TEST_ASSERT(
      names(said(fives), {"line 1 must hold two numbers", "but holds 5", "layout = values", "record time step"}));
  TEST_ASSERT(names(said("0.1\n0.2\n"), {"line 1 must hold two numbers", "but holds 1", "layout = values"}));
  const auto series = read(fives, values_every(0.5));
  TEST_COMPARE_ARRAYS(series.value, (std::vector<double>{1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3, 7e-3}));
  TEST_COMPARE_ARRAYS(series.time, (std::vector<double>{0, 0.5, 1, 1.5, 2, 2.5, 3}));
  // A heading of key and value, as ITACA and K-NET write it, then a column; lines of digits are named.
  TEST_EQUALITY(
      read("EVENT_DATE: 20120529\nSAMPLING_INTERVAL_S: 0.005\n\n0.1\n-0.2\n", values_every(0.005)).value.size(), 2u);
  auto named = values_every(0.005);
  named.header_lines = 2;
  TEST_COMPARE_ARRAYS(read("12 lines of text\n 3 4 5\n0.1 0.2\n0.3\n", named).value,
                      (std::vector<double>{0.1, 0.2, 0.3}));
}

TEUCHOS_UNIT_TEST(TimeSeries, OfPeerIsReadByItsHeading) {
  const std::string title = "STRONG MOTION RECORD\n1 STATION, 090\nACCELERATION TIME SERIES IN UNITS OF G\n";
  const std::string values = " 0.1E-01 .2E-01 -.3E-01\n 4E-2\n";
  for (const std::string line :
       {"NPTS=   4, DT= .01000 SEC\n", "   4    0.0100    NPTS, DT\n", "npts=4,dt=0.01 sec,\n"}) {
    const auto series = read(title + line + values, at2());
    TEST_COMPARE_ARRAYS(series.value, (std::vector<double>{0.01, 0.02, -0.03, 0.04}));
    TEST_COMPARE_FLOATING_ARRAYS(series.time, (std::vector<double>{0, 0.01, 0.02, 0.03}), exact);
    TEST_ASSERT(unit_named_in(series.heading) == AccelerationUnit::g);
    TEST_ASSERT(!names_other_motion(series.heading));
  }
  const std::string four = "NPTS= 4, DT= .01 SEC\n";
  TEST_ASSERT(names(said(title + four + values), {"line 2", "layout = peer at2"}));
  TEST_ASSERT(names(said("A\n" + four + values), {"line 3 must hold two numbers", "layout = peer at2"}));
  TEST_ASSERT(names(said(title + four + "1 2 3\n", at2()), {"NPTS = 4, but holds 3"}));
  TEST_ASSERT(names(said(title + four + "1 2 3 4 5\n", at2()), {"NPTS = 4, but holds 5"}));
  TEST_ASSERT(names(said(title + "NPTS= ?, DT= ?\n" + values, at2()), {"NPTS"}));
  TEST_ASSERT(names(said("0 1\n1 2\n", at2()), {"heading of an AT2 file"}));
  TEST_ASSERT(names_other_motion(read("A\nB\nVELOCITY TIME SERIES IN UNITS OF CM/S\n" + four + values, at2()).heading));
}

TEUCHOS_UNIT_TEST(TimeSeries, HasNoLineThatIsLeftOutUnseen) {
  TEST_ASSERT(names(said("0 1\nNaN 2\n"), {"line 2"}));
  TEST_ASSERT(names(said("nan, 2\n1, 2\n"), {"line 1", "not finite"}));
  TEST_ASSERT(names(said("t, a\n0, 1\nsecond part\n0, 1\n"), {"line 3"}));
  TEST_ASSERT(names(said("0,05;1,5\n0,1;2\n"), {"line 1", "has commas in its numbers"}));
  TEST_ASSERT(names(said("0,05 1,5\n", values_every(1)), {"has commas in its numbers"}));
  TEST_ASSERT(names(said("0,05\n0,06\n", values_every(1)), {"has commas in its numbers"}));
  TEST_ASSERT(names(said("0,05\n0,06\n"), {"rising", "commas"}));
  // Headings of table programs: marks of Unicode, quotation marks, signs of comment.
  TEST_EQUALITY(read("\xEF\xBB\xBF\"time\",\"a\"\n% made by hand\n0, 1\n# in between\n1, 2\n").value.size(), 2u);
}

TEUCHOS_UNIT_TEST(TimeSeries, LinesEndInAnyWay) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const auto series = read("t, a" + end + end + "0, 1" + end + "1, 2" + end);
    TEST_COMPARE_ARRAYS(series.value, (std::vector<double>{1, 2}));
    TEST_ASSERT(names(said("0 1" + end + end + "1 b" + end), {"line 3"}));
  }
}

TEUCHOS_UNIT_TEST(TimeSeries, UnitsAreReadWhereHeadingsNameThem) {
  const auto named = [](const std::string& line) { return unit_named_in({"a station (north)", line}); };
  for (const std::string text :
       {"t [s], a [cm/s2]", "a (cm/s/s)", "UNITS: cm/s^2", "in units of CM/SEC2", "[cm / s**2]"})
    TEST_ASSERT(named(text) == AccelerationUnit::cm_per_s2);
  TEST_ASSERT(named("a [gal]") == AccelerationUnit::gal);
  TEST_ASSERT(named("a [mm/s2]") == AccelerationUnit::mm_per_s2);
  TEST_ASSERT(named("a [m/sec/sec]") == AccelerationUnit::m_per_s2);
  TEST_ASSERT(named("acceleration (g)") == AccelerationUnit::g);
  TEST_ASSERT(!named("g of the site, no brackets"));
  TEST_ASSERT(!named("a [m/s2], b [g]"));  // which of them is meant, nobody knows
  TEST_EQUALITY(in_si(AccelerationUnit::gal), 0.01);
  TEST_EQUALITY(in_si(AccelerationUnit::mm_per_s2), 0.001);
}

}  // namespace

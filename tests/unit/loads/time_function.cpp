// Factors over time at points where they are known by hand.
#include "loads/time_function.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// Sines of exact arguments of pi are good to some units in the last place.
constexpr double round_off = 1e-14;

TimeFunction made(const TimeFunctionParameters& p) { return TimeFunction(p, "scene > loads > push", *everyone()); }

TimeFunctionParameters parameters(TimeFunctionType type, double start, double duration, double amplitude) {
  TimeFunctionParameters p;
  p.type = type;
  p.start = start;
  p.duration = duration;
  p.amplitude = amplitude;
  return p;
}

TEUCHOS_UNIT_TEST(TimeFunction, IsOneWhenASceneSaysNothingAndHoldsNothing) {
  const TimeFunction f = made({});
  TEST_EQUALITY(f(-3.0), 1.0);
  TEST_EQUALITY(f(1e6), 1.0);
  TEST_EQUALITY(f.bytes(), std::size_t{0});
}

TEUCHOS_UNIT_TEST(TimeFunction, OfATableIsLinearBetweenPointsAndHeldOutside) {
  TimeFunctionParameters p;
  p.type = TimeFunctionType::table;
  p.time = {1, 2, 4};
  p.value = {3, 5, -5};
  const TimeFunction f = made(p);
  TEST_EQUALITY(f(0.0), 3.0);
  TEST_EQUALITY(f(1.0), 3.0);
  TEST_EQUALITY(f(1.25), 3.5);
  TEST_EQUALITY(f(2.0), 5.0);
  TEST_EQUALITY(f(3.0), 0.0);
  TEST_EQUALITY(f(4.0), -5.0);
  TEST_EQUALITY(f(9.0), -5.0);
}

TEUCHOS_UNIT_TEST(TimeFunction, OfARampGoesFromOneValueToTheOther) {
  auto p = parameters(TimeFunctionType::ramp, 2, 4, 1);
  p.from = 1;
  p.to = 3;
  const TimeFunction f = made(p);
  TEST_EQUALITY(f(0.0), 1.0);
  TEST_EQUALITY(f(3.0), 1.5);
  TEST_EQUALITY(f(7.0), 3.0);
}

TEUCHOS_UNIT_TEST(TimeFunction, OfASineHasItsAmplitudeAfterAQuarterAndEnds) {
  auto p = parameters(TimeFunctionType::sine, 1, 1, 2.5);
  p.frequency = 0.5;
  p.end = 5;
  TEST_FLOATING_EQUALITY(made(p)(1.5), 2.5, round_off);
  TEST_FLOATING_EQUALITY(made(p)(2.5), -2.5, round_off);
  TEST_EQUALITY(made(p)(0.99), 0.0);
  TEST_EQUALITY(made(p)(5.01), 0.0);
  p.phase = std::acos(0.0);
  TEST_FLOATING_EQUALITY(made(p)(1.0), 2.5, round_off);
}

TEUCHOS_UNIT_TEST(TimeFunction, OfAPulseIsHalfASine) {
  const TimeFunction f = made(parameters(TimeFunctionType::pulse, 2, 0.5, 4));
  TEST_EQUALITY(f(1.9), 0.0);
  TEST_FLOATING_EQUALITY(f(2.25), 4.0, round_off);
  TEST_FLOATING_EQUALITY(f(2.0 + 0.5 / 6), 2.0, round_off);  // sin 30 degrees
  TEST_EQUALITY(f(2.6), 0.0);
}

TEUCHOS_UNIT_TEST(TimeFunction, OfASweepPassesAsManyPeriodsAsItsMeanFrequencySays) {
  auto p = parameters(TimeFunctionType::sine_sweep, 0, 10, 1);
  p.first_frequency = 1;
  p.last_frequency = 3;
  const TimeFunction f = made(p);
  int rises = 0;  // from below zero to above
  for (int k = 1; k < 10000; ++k) rises += f(k * 1e-3 - 5e-4) < 0 && f(k * 1e-3 + 5e-4) >= 0;
  TEST_EQUALITY(rises, 19);  // 20 periods: a mean of 2 Hz over 10 s; the first rise is at the start
  // After 2.5 s the frequency is 1.5 Hz, the mean 1.25 Hz, and 3.125 periods are over: sin 45 degrees.
  TEST_FLOATING_EQUALITY(f(2.5), std::sqrt(0.5), 1e-13);
}

TEUCHOS_UNIT_TEST(TimeFunction, OfARecordReadsRowsAndScalesThem) {
  const std::string file = "time_function_record.csv";
  if (everyone()->getRank() == 0) std::ofstream(file) << "# made by a test\nt, factor\n0, 0\r\n0.5; 2\n\n1.5 4\n";
  TimeFunctionParameters p;
  p.type = TimeFunctionType::record;
  p.file = file;
  p.scale = 0.5;
  const TimeFunction f = made(p);  // collective: other ranks wait for the first to have written and read
  TEST_EQUALITY(f(0.25), 0.5);
  TEST_EQUALITY(f(1.0), 1.5);
  TEST_EQUALITY(f(3.0), 2.0);
  TEST_COMPARE(f.bytes(), >=, 6 * sizeof(double));
}

TEUCHOS_UNIT_TEST(TimeFunction, TellsATimeStepThatSeesIt) {
  TEST_ASSERT(std::isinf(made({}).resolution()));
  TEST_ASSERT(std::isinf(made(parameters(TimeFunctionType::ramp, 0, 1e-3, 1)).resolution()));
  TEST_FLOATING_EQUALITY(made(parameters(TimeFunctionType::pulse, 1, 0.5, 1)).resolution(), 0.05, round_off);
  auto sweep = parameters(TimeFunctionType::sine_sweep, 0, 2, 1);
  sweep.first_frequency = 10;
  sweep.last_frequency = 2;
  TEST_FLOATING_EQUALITY(made(sweep).resolution(), 0.005, round_off);
  const PiecewiseLinear record({0, 0.01, 0.02, 0.06}, {0, 1, 2, 3});
  TEST_FLOATING_EQUALITY(record.resolution(), 0.01, round_off);
}

std::string said_of(const std::string& file, const std::string& text) {
  if (everyone()->getRank() == 0) std::ofstream(file) << text;
  TimeFunctionParameters p;
  p.type = TimeFunctionType::record;
  p.file = file;
  try {
    made(p);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEUCHOS_UNIT_TEST(TimeFunction, TellsWhereItVariesAndWhereItJumps) {
  TimeFunctionParameters p;
  p.type = TimeFunctionType::table;
  p.time = {0, 1, 1.5, 3, 3.2};
  p.value = {0, 0, 1, 1, 0};
  const TimeFunction table = made(p);
  std::vector<double> corners;
  table.add_corners(1.0, 3.2, corners);  // within, without the ends
  TEST_COMPARE_ARRAYS(corners, (std::vector<double>{1.5, 3}));
  TEST_ASSERT(std::isinf(table.resolution(0, 1)));
  TEST_FLOATING_EQUALITY(table.resolution(0.9, 1.1), 0.25, round_off);
  TEST_ASSERT(std::isinf(table.resolution(1.5, 3)));
  TEST_FLOATING_EQUALITY(table.resolution(0, 10), 0.1, 10 * round_off);
  TEST_ASSERT(std::isinf(table.resolution(3.2, 10)));

  auto sine = parameters(TimeFunctionType::sine, 1, 0, 1);
  sine.end = 1.75;
  const TimeFunction f = made(sine);
  corners.clear();
  f.add_corners(0, 2, corners);
  TEST_COMPARE_ARRAYS(corners, (std::vector<double>{1, 1.75}));
  TEST_ASSERT(std::isinf(f.resolution(0, 1)));
  TEST_FLOATING_EQUALITY(f.resolution(0, 1.1), 0.05, round_off);
  TEST_ASSERT(!f.jumps(0, 1.5));  // it begins at 0
  TEST_ASSERT(f.jumps(1.5, 2));
}

TEUCHOS_UNIT_TEST(TimeFunction, SaysWhatIsWrongWithARecord) {
  const auto names = [&](const std::string& message, const std::string& piece) {
    return message.find("scene > loads > push > time function > file = ") == 0 &&
           message.find(piece) != std::string::npos;
  };
  TEST_ASSERT(names(said_of("bad_row.csv", "0, 0\n1, x\n"), "line 2 must hold 2 finite numbers"));
  TEST_ASSERT(names(said_of("bad_order.csv", "0, 0\n1, 1\n1, 2\n"), "row 3 is at 1 s after 1 s"));
  TEST_ASSERT(names(said_of("bad_empty.csv", "t, a\n"), "holds no rows of numbers"));
  TEST_ASSERT(names(said_of("no/such/folder.csv", ""), "cannot be read"));
}

}  // namespace

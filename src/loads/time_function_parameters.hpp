// How a load varies with time: a factor without unit, 1 when a scene says nothing.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "loads/record_layout_parameters.hpp"

namespace voussoir {

class ParameterSection;

enum class TimeFunctionType { constant, table, ramp, sine, pulse, sine_sweep, record };

struct TimeFunctionParameters {
  TimeFunctionType type = TimeFunctionType::constant;
  std::string times, values;                             ///< table: numbers, as text
  double start = 0, duration = 1;                        ///< [s] ramp, pulse, sine sweep; the start of a sine too
  double end = std::numeric_limits<double>::infinity();  ///< [s] of a sine
  double from = 0, to = 1;                               ///< [-] ramp: before and after it
  double amplitude = 1;                                  ///< [-] sine, pulse, sine sweep
  double frequency = 1, phase = 0;                       ///< [Hz], [rad] sine
  double first_frequency = 1, last_frequency = 10;       ///< [Hz] sine sweep
  std::string file;                                      ///< record: made absolute when the scene is read
  RecordLayoutParameters layout;                         ///< of that file
  int value_column = 0;                                  ///< of rows with more than two numbers, from 1
  double scale = 1;                                      ///< [-] record: times every value
  std::vector<double> time, value;                       ///< the table, from its texts

  void declare(ParameterSection&);
};

}  // namespace voussoir

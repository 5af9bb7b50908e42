// The factor of a load over time.
#pragma once

#include <Teuchos_Comm.hpp>
#include <string>
#include <vector>

#include "loads/time_function_parameters.hpp"

namespace voussoir {

/// Linear between points, held before the first and after the last.
class PiecewiseLinear {
 public:
  PiecewiseLinear() = default;
  /// @param time  rising [s], as many as values, at least one
  PiecewiseLinear(std::vector<double> time, std::vector<double> value);
  double operator()(double t) const;
  const std::vector<double>& time() const { return time_; }
  const std::vector<double>& value() const { return value_; }
  /// [s] Half the mean interval of its points; infinite for fewer than two.
  double resolution() const;
  /// [s] Half the shortest of the intervals in which it changes between two times; infinite where it does not change.
  double resolution(double from, double to) const;
  /// Adds the times of its points between two times [s].
  void add_corners(double from, double to, std::vector<double>& times) const;
  std::size_t bytes() const { return (time_.capacity() + value_.capacity()) * sizeof(double); }

 private:
  std::vector<double> time_, value_;
};

class TimeFunction {
 public:
  /// 1 at all times.
  TimeFunction() = default;
  /// Reads the file of a record. Collective; throws InputError on every rank alike.
  /// @param where  of the load, "xml/wall.xml: scene > loads > push"
  TimeFunction(const TimeFunctionParameters&, const std::string& where, const Teuchos::Comm<int>&);

  /// [-] at a time [s]
  double operator()(double t) const;
  /// [s] A time step that sees how the factor varies: half the mean interval of a record, a twentieth of the shortest
  /// period of a sine, a sweep or a pulse; infinite for lines, which ask for short steps only where they change.
  double resolution() const;
  /// [s] The same for steps between two times: half of the shortest interval of its points in which it changes then.
  double resolution(double from, double to) const;
  bool constant() const { return type_ == TimeFunctionType::constant; }
  /// Adds the times between two times at which it is not smooth [s].
  void add_corners(double from, double to, std::vector<double>& times) const;
  /// Whether it jumps between two times, the first one included.
  bool jumps(double from, double to) const;
  /// [s] Between its corners it is smooth over so long a time: as a polynomial is.
  double smooth() const;
  std::size_t bytes() const { return line_.bytes(); }

 private:
  TimeFunctionType type_ = TimeFunctionType::constant;
  double start_ = 0, end_ = 0;                       ///< [s]
  double amplitude_ = 0, phase_ = 0;                 ///< [-], [rad]
  double first_frequency_ = 0, last_frequency_ = 0;  ///< [Hz]
  PiecewiseLinear line_;                             ///< table, ramp, record
};

}  // namespace voussoir

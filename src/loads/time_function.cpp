#include "loads/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "loads/time_series.hpp"

namespace voussoir {
namespace {

constexpr double pi = 3.141592653589793;
constexpr double steps_of_a_period = 20;  // the midpoint rule then lags behind by less than a hundredth of a period
constexpr double pieces_of_a_period = 8;  // a polynomial of seventh degree is a sine there to 1e-9

}  // namespace

PiecewiseLinear::PiecewiseLinear(std::vector<double> time, std::vector<double> value)
    : time_(std::move(time)), value_(std::move(value)) {
  VOUSSOIR_CHECK(!time_.empty() && time_.size() == value_.size());
}

double PiecewiseLinear::operator()(double t) const {
  const auto after = std::upper_bound(time_.begin(), time_.end(), t);
  if (after == time_.begin()) return value_.front();
  if (after == time_.end()) return value_.back();
  const auto k = static_cast<std::size_t>(after - time_.begin());
  const double share = (t - time_[k - 1]) / (time_[k] - time_[k - 1]);
  return value_[k - 1] + share * (value_[k] - value_[k - 1]);
}

double PiecewiseLinear::resolution() const {
  if (time_.size() < 2) return std::numeric_limits<double>::infinity();
  return (time_.back() - time_.front()) / static_cast<double>(time_.size() - 1) / 2;
}

double PiecewiseLinear::resolution(double from, double to) const {
  double shortest = std::numeric_limits<double>::infinity();
  const auto after = std::upper_bound(time_.begin(), time_.end(), from) - time_.begin();
  for (auto k = std::max<std::size_t>(1, static_cast<std::size_t>(after)); k < time_.size() && time_[k - 1] < to; ++k)
    if (value_[k] != value_[k - 1]) shortest = std::min(shortest, (time_[k] - time_[k - 1]) / 2);
  return shortest;
}

void PiecewiseLinear::add_corners(double from, double to, std::vector<double>& times) const {
  const auto begin = std::upper_bound(time_.begin(), time_.end(), from);
  times.insert(times.end(), begin, std::lower_bound(begin, time_.end(), to));
}

TimeFunction::TimeFunction(const TimeFunctionParameters& p, const std::string& where, const Teuchos::Comm<int>& comm)
    : type_(p.type), start_(p.start), end_(p.start + p.duration), amplitude_(p.amplitude) {
  switch (type_) {
    case TimeFunctionType::constant:
    case TimeFunctionType::pulse:
      break;
    case TimeFunctionType::table:
      line_ = {p.time, p.value};
      break;
    case TimeFunctionType::ramp:
      line_ = {{start_, end_}, {p.from, p.to}};
      break;
    case TimeFunctionType::sine:
      end_ = p.end;
      phase_ = p.phase;
      first_frequency_ = last_frequency_ = p.frequency;
      break;
    case TimeFunctionType::sine_sweep:
      first_frequency_ = p.first_frequency;
      last_frequency_ = p.last_frequency;
      break;
    case TimeFunctionType::record: {
      const std::string key = where + " > time function > file";
      auto series = read_time_series(p.file, p.layout, {"value column", p.value_column}, key, comm);
      for (double& v : series.value) v *= p.scale;
      line_ = {std::move(series.time), std::move(series.value)};
      break;
    }
  }
}

double TimeFunction::resolution() const {
  constexpr double none = std::numeric_limits<double>::infinity();
  switch (type_) {
    case TimeFunctionType::record:
      return line_.resolution();
    case TimeFunctionType::pulse:
      return 2 * (end_ - start_) / steps_of_a_period;
    case TimeFunctionType::sine:
    case TimeFunctionType::sine_sweep:
      return 1 / (std::max(std::abs(first_frequency_), std::abs(last_frequency_)) * steps_of_a_period);
    default:
      return none;
  }
}

double TimeFunction::resolution(double from, double to) const {
  if (!line_.time().empty()) return line_.resolution(from, to);
  return start_ < to && from < end_ ? resolution() : std::numeric_limits<double>::infinity();
}

void TimeFunction::add_corners(double from, double to, std::vector<double>& times) const {
  line_.add_corners(from, to, times);
  if (constant() || !line_.time().empty()) return;
  for (const double end : {start_, end_})
    if (from < end && end < to) times.push_back(end);
}

bool TimeFunction::jumps(double from, double to) const {
  if (constant() || !line_.time().empty()) return false;
  const auto is_within = [&](double end) { return from <= end && end < to; };
  const auto is_some = [&](double end) { return std::abs((*this)(end)) > 1e-9 * std::abs(amplitude_); };
  return (is_within(start_) && is_some(start_)) || (is_within(end_) && is_some(end_));
}

double TimeFunction::smooth() const {
  return line_.time().empty() ? resolution() * steps_of_a_period / pieces_of_a_period
                              : std::numeric_limits<double>::infinity();
}

double TimeFunction::operator()(double t) const {
  if (type_ == TimeFunctionType::constant) return 1;
  if (!line_.time().empty()) return line_(t);
  if (t < start_ || t > end_) return 0;
  const double passed = t - start_;
  if (type_ == TimeFunctionType::pulse) return amplitude_ * std::sin(pi * passed / (end_ - start_));
  // Of a sweep the phase is 2 pi times the integral of a frequency that changes linearly; of a sine it does not change.
  const double sweep =
      type_ == TimeFunctionType::sine ? 0 : (last_frequency_ - first_frequency_) / (2 * (end_ - start_));
  return amplitude_ * std::sin(2 * pi * (first_frequency_ + sweep * passed) * passed + phase_);
}

}  // namespace voussoir

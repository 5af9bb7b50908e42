#include "base/range.hpp"

#include <cmath>
#include <limits>

#include "base/text.hpp"

namespace voussoir {
namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
}

Range::Range(double low, bool with_low, double high, bool with_high)
    : low_(low), high_(high), with_low_(with_low), with_high_(with_high) {}

bool Range::contains(double x) const {
  if (std::isnan(x)) return false;
  if (std::isinf(x)) return infinite_ && x > 0;
  if (even_ && std::fmod(x, 2) != 0) return false;
  return (with_low_ ? x >= low_ : x > low_) && (with_high_ ? x <= high_ : x < high_);
}

std::string Range::text() const {
  std::string text;
  if (low_ > -infinity) text += (with_low_ ? ">= " : "> ") + number_text(low_);
  if (high_ < infinity)
    text += (text.empty() ? "" : " and ") + std::string(with_high_ ? "<= " : "< ") + number_text(high_);
  if (text.empty()) text = "finite";
  if (even_) text += " and even";
  if (infinite_) text += " or inf";
  return text;
}

Range Range::or_infinite() const {
  Range range = *this;
  range.infinite_ = true;
  return range;
}

Range Range::usually(double least, double most) const {
  Range range = *this;
  range.least_usual_ = least;
  range.most_usual_ = most;
  return range;
}

bool Range::is_usual(double x) const {
  if (most_usual_ == 0 || x == 0 || std::isinf(x)) return true;
  return least_usual_ <= std::abs(x) && std::abs(x) <= most_usual_;
}

std::string Range::usual_text() const {
  return most_usual_ == 0 ? "" : number_text(least_usual_) + " to " + number_text(most_usual_);
}

Range Range::even() const {
  Range range = *this;
  range.even_ = true;
  return range;
}

Range any_number() { return {-infinity, false, infinity, false}; }
Range at_least(double low) { return {low, true, infinity, false}; }
Range above(double low) { return {low, false, infinity, false}; }
Range between(double low, double high) { return {low, true, high, true}; }
Range above_up_to(double low, double high) { return {low, false, high, true}; }
Range from_below(double low, double high) { return {low, true, high, false}; }
Range inside(double low, double high) { return {low, false, high, false}; }

}  // namespace voussoir

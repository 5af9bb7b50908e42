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

#include "nonlinear/driven_share.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voussoir {
namespace {

constexpr double round_off = std::numeric_limits<double>::epsilon();

/// Share in (0, 1) from which on a step is worked against. Between two kinks work is next to linear, so that secants
/// come near its root, from either side by turns (the Illinois method: an end that stays counts half). Where one has
/// not halved what is left, the middle is next. To the last bits: a kink may lie anywhere, and what stones meet there
/// has to show in their statuses.
double where_it_turns(const std::function<double(double)>& drives, double at_low, double at_high) {
  double low = 0, high = 1, left = 1;
  bool by_secant = true, rose = false, fell = false;
  for (double t = 0.5; low < t && t < high && t > round_off; t = (low + high) / 2) {
    const double least = round_off * high;
    if (by_secant && high - low > 2 * least)
      t = std::clamp(low + (high - low) * at_low / (at_low - at_high), low + least, high - least);
    const double found = drives(t);
    if (found > 0) {
      low = t;
      at_low = found;
      if (rose) at_high /= 2;
    } else {
      high = t;
      at_high = found;
      if (fell) at_low /= 2;
    }
    rose = found > 0;
    fell = !rose;
    by_secant = high - low <= left / 2 || !by_secant;
    left = high - low;
  }
  return high;
}

}  // namespace

double driven_share(const std::function<double(double)>& work, double left) {
  const double start = work(0), against = -left * std::abs(start);
  if (start == 0) return 1;
  const double full = work(1);
  if (!(full < against)) return 1;
  const double way = start > 0 ? 1 : -1;
  const auto drives = [&](double t) { return way * work(way * t); };
  const double end = way > 0 ? full : drives(1);
  return end < against ? way * where_it_turns(drives, std::abs(start), end) : way;
}

}  // namespace voussoir

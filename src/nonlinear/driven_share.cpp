#include "nonlinear/driven_share.hpp"

#include <cmath>
#include <limits>

namespace voussoir {

double driven_share(const std::function<double(double)>& work, double left) {
  const double start = work(0), against = -left * std::abs(start);
  if (start == 0 || !(work(1) < against)) return 1;
  const double way = start > 0 ? 1 : -1;
  const auto drives = [&](double t) { return way * work(way * t); };
  if (!(drives(1) < against)) return way;
  double low = 0, high = 1;
  // To the last bits: a kink may lie anywhere, and what stones meet there has to show in their statuses.
  for (double t = 0.5; low < t && t < high && t > std::numeric_limits<double>::epsilon(); t = (low + high) / 2)
    (drives(t) > 0 ? low : high) = t;
  return way * high;
}

}  // namespace voussoir

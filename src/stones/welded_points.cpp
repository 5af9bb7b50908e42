#include "stones/welded_points.hpp"

#include <cmath>

#include "base/check.hpp"

namespace voussoir {

std::size_t WeldedPoints::Hash::operator()(const Cube& cube) const {
  std::size_t sum = 0;
  for (const long long i : cube) sum = sum * 1000003u + static_cast<std::size_t>(i);
  return sum;
}

WeldedPoints::Cube WeldedPoints::cube_of(const Vector<3>& x) const {
  Cube cube{};
  for (int i = 0; i < 3; ++i) {
    const double place = std::floor((x[i] - points_[0][i]) / (2 * within_));
    VOUSSOIR_EXPECT(std::abs(place) < 1e18);
    cube[i] = static_cast<long long>(place);
  }
  return cube;
}

int WeldedPoints::find(const Vector<3>& x) const {
  if (points_.empty()) return -1;
  const Cube middle = cube_of(x);
  int nearest = -1;
  double distance = within_;
  for (long long i = -1; i <= 1; ++i)
    for (long long j = -1; j <= 1; ++j)
      for (long long k = -1; k <= 1; ++k) {
        const auto found = cubes_.find({middle[0] + i, middle[1] + j, middle[2] + k});
        if (found == cubes_.end()) continue;
        for (const int other : found->second) {
          const double d = norm(points_[other] - x);
          if (d < distance || (d == distance && (nearest < 0 || other < nearest))) nearest = other, distance = d;
        }
      }
  return nearest;
}

int WeldedPoints::add(const Vector<3>& x) {
  if (const int known = find(x); known >= 0) return known;
  points_.push_back(x);
  cubes_[cube_of(x)].push_back(static_cast<int>(points_.size()) - 1);
  return static_cast<int>(points_.size()) - 1;
}

}  // namespace voussoir

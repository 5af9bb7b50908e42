#include "stones/welded_points.hpp"

#include <cmath>

#include "base/check.hpp"

namespace voussoir {

template <int dim>
std::size_t WeldedPoints<dim>::Hash::operator()(const Cube& cube) const {
  std::size_t sum = 0;
  for (const long long i : cube) sum = sum * 1000003u + static_cast<std::size_t>(i);
  return sum;
}

template <int dim>
typename WeldedPoints<dim>::Cube WeldedPoints<dim>::cube_of(const Vector<dim>& x) const {
  Cube cube{};
  for (std::size_t i = 0; i < dim; ++i) {
    const double place = std::floor((x[i] - points_[0][i]) / (2 * within_));
    VOUSSOIR_EXPECT(std::abs(place) < 1e18);
    cube[i] = static_cast<long long>(place);
  }
  return cube;
}

template <int dim>
int WeldedPoints<dim>::find(const Vector<dim>& x) const {
  if (points_.empty()) return -1;
  const Cube middle = cube_of(x);
  int nearest = -1;
  double distance = within_;
  constexpr int around = dim == 2 ? 9 : 27;
  for (int c = 0; c < around; ++c) {
    Cube cube = middle;
    for (int i = 0, rest = c; i < dim; ++i, rest /= 3) cube[static_cast<std::size_t>(i)] += rest % 3 - 1;
    const auto found = cubes_.find(cube);
    if (found == cubes_.end()) continue;
    for (const int other : found->second) {
      const double d = norm(points_[other] - x);
      if (d < distance || (d == distance && (nearest < 0 || other < nearest))) nearest = other, distance = d;
    }
  }
  return nearest;
}

template <int dim>
int WeldedPoints<dim>::add(const Vector<dim>& x) {
  if (const int known = find(x); known >= 0) return known;
  points_.push_back(x);
  cubes_[cube_of(x)].push_back(static_cast<int>(points_.size()) - 1);
  return static_cast<int>(points_.size()) - 1;
}

template class WeldedPoints<2>;
template class WeldedPoints<3>;

}  // namespace voussoir

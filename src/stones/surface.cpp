#include "stones/surface.hpp"

#include <algorithm>

namespace voussoir {

std::string in_words(const StoneSurface& stone) { return "stone \"" + stone.name + "\" (" + stone.origin + ")"; }

double volume(const StoneSurface& stone) {
  if (stone.points.empty()) return 0;
  const auto& origin = stone.points[0];
  double sum = 0;
  for (const auto& face : stone.faces) {
    const auto corners = places_of(stone.points, face);
    const auto middle = mean(corners) - origin;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto& next = corners[(k + 1) % corners.size()];
      sum += dot(middle, cross(corners[k] - origin, next - origin)) / 6;
    }
  }
  return sum;
}

double extent(const Places& points) {
  if (points.empty()) return 0;
  auto low = points[0], high = points[0];
  for (const auto& x : points)
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], x[i]);
      high[i] = std::max(high[i], x[i]);
    }
  return norm(high - low);
}

Places places_of(const Places& points, const std::vector<int>& numbers) {
  Places places;
  places.reserve(numbers.size());
  for (const int n : numbers) places.push_back(points[n]);
  return places;
}

Vector<3> mean(const Places& places) {
  Vector<3> sum{};
  for (const auto& x : places) sum = sum + (x - places[0]);
  return places[0] + (1.0 / static_cast<double>(places.size())) * sum;
}

Vector<3> area_vector(const Places& polygon) {
  Vector<3> doubled{};
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    doubled = doubled + cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return 0.5 * doubled;
}

}  // namespace voussoir

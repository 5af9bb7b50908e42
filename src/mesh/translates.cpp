#include "mesh/translates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/check.hpp"

namespace voussoir {
namespace {

using Places = std::vector<Vector<3>>;

/// Per place the number of its coordinate among those of all, where such as differ by round-off are one.
std::vector<int> ranks_along(int axis, const Places& places, double within) {
  std::vector<int> order(places.size()), rank(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return places[a][axis] < places[b][axis]; });
  for (std::size_t k = 1; k < order.size(); ++k)
    rank[order[k]] = rank[order[k - 1]] + (places[order[k]][axis] - places[order[k - 1]][axis] > within);
  return rank;
}

/// By the coordinates of places, the first ones foremost.
std::vector<int> order_of(const Places& places, double within) {
  std::vector<std::array<int, 4>> keys(places.size());
  for (int axis = 0; axis < 3; ++axis) {
    const auto rank = ranks_along(axis, places, within);
    for (std::size_t k = 0; k < places.size(); ++k) keys[k][axis] = rank[k];
  }
  for (std::size_t k = 0; k < places.size(); ++k) keys[k][3] = static_cast<int>(k);
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  for (const auto& key : keys) order.push_back(key[3]);
  return order;
}

/// Parts by other numbers, each ascending, and all of them.
std::vector<int> renumbered(const std::vector<int>& parts, int width, const std::vector<int>& number) {
  std::vector<std::vector<int>> all;
  for (auto from = parts.begin(); from != parts.end(); from += width) {
    all.emplace_back();
    for (int k = 0; k < width; ++k) all.back().push_back(number[from[k]]);
    std::sort(all.back().begin(), all.back().end());
  }
  std::sort(all.begin(), all.end());
  std::vector<int> flat;
  flat.reserve(parts.size());
  for (const auto& part : all) flat.insert(flat.end(), part.begin(), part.end());
  return flat;
}

}  // namespace

double largest_coordinate(const Places& places) {
  double largest = 0;
  for (const auto& x : places)
    for (const double c : x) largest = std::max(largest, std::abs(c));
  return largest;
}

DrawnNumbers::DrawnNumbers(double largest) {
  int exponent = 0;
  std::frexp(largest, &exponent);  // largest < 2^exponent
  largest_ = std::ldexp(1.0, exponent);
}

Vector<3> DrawnNumbers::rounded(Vector<3> x) const {
  const double step = largest_ / (1LL << 50);
  for (double& c : x) c = step * std::nearbyint(c / step);
  return x;
}

Translates::Shape Translates::shape_of(const Places& places, int width, const std::vector<int>& parts) const {
  Shape shape;
  shape.order = order_of(places, within_);
  std::vector<int> number(places.size());
  for (std::size_t k = 0; k < shape.order.size(); ++k) {
    number[shape.order[k]] = static_cast<int>(k);
    shape.relative.push_back(places[shape.order[k]] - places[shape.order[0]]);
    shape.spread += norm(shape.relative.back());
  }
  shape.parts = renumbered(parts, width, number);
  return shape;
}

bool Translates::alike(const Shape& a, const Shape& b) const {
  if (a.parts != b.parts || a.relative.size() != b.relative.size()) return false;
  for (std::size_t k = 0; k < a.relative.size(); ++k)
    for (int d = 0; d < 3; ++d)
      if (std::abs(a.relative[k][d] - b.relative[k][d]) > within_) return false;
  return true;
}

Translates::Match Translates::add(const Places& places, int width, const std::vector<int>& parts) {
  VOUSSOIR_EXPECT(!places.empty() && width > 0 && parts.size() % static_cast<std::size_t>(width) == 0);
  auto here = shape_of(places, width, parts);
  // Distances of shapes that are alike differ by less than two of `within`.
  const double most = 2 * within_ * static_cast<double>(places.size());
  const auto end = by_spread_.upper_bound(here.spread + most);
  for (auto known = by_spread_.lower_bound(here.spread - most); known != end; ++known) {
    const auto& first = first_[known->second];
    if (!alike(first, here)) continue;
    Match match{known->second, false, std::vector<int>(places.size())};
    for (std::size_t k = 0; k < here.order.size(); ++k) match.order[first.order[k]] = here.order[k];
    return match;
  }
  Match match{shapes(), true, std::vector<int>(places.size())};
  std::iota(match.order.begin(), match.order.end(), 0);
  by_spread_.emplace(here.spread, match.shape);
  first_.push_back(std::move(here));
  return match;
}

}  // namespace voussoir

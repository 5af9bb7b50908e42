#include "base/convex_hull.hpp"

#include <algorithm>
#include <utility>

namespace voussoir {

// Andrew's monotone chain.
std::vector<int> convex_hull(const std::vector<Vector<2>>& places, double off) {
  struct Place {
    long long across;  ///< of places that are as far along one is not left of the other for its round-off
    Vector<2> x;
    int number;
  };
  std::vector<Place> order;
  for (std::size_t k = 0; k < places.size(); ++k)
    order.push_back({std::llround(places[k][0] / off), places[k], static_cast<int>(k)});
  std::stable_sort(order.begin(), order.end(), [](const Place& p, const Place& q) {
    return std::make_pair(p.across, p.x[1]) < std::make_pair(q.across, q.x[1]);
  });
  if (order.empty()) return {};
  std::vector<Place> hull;
  const auto go = [&](const Place& p, std::size_t begin) {
    while (hull.size() > begin) {
      const auto &last = hull[hull.size() - 1].x, &before = hull[hull.size() - 2].x;
      if (cross(last - before, p.x - last) > off * norm(p.x - before)) break;
      hull.pop_back();
    }
    if (norm(p.x - hull.back().x) > off) hull.push_back(p);
  };
  hull.push_back(order.front());
  for (const auto& p : order) go(p, 1);
  const auto half = hull.size();
  for (std::size_t k = order.size(); k-- > 0;) go(order[k], half);
  std::vector<int> corners;
  for (const auto& p : hull) corners.push_back(p.number);
  if (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
  return corners;
}

Rectangle least_rectangle(const std::vector<Vector<2>>& places, double round_off) {
  double extent = 0;
  for (const auto& x : places) extent = std::max(extent, norm(x - places.front()));
  const auto hull = convex_hull(places, round_off * extent);
  Rectangle least;
  bool any = false;
  for (std::size_t k = 0; k < hull.size() && hull.size() > 1; ++k) {
    const auto from = places[static_cast<std::size_t>(hull[k])],
               to = places[static_cast<std::size_t>(hull[(k + 1) % hull.size()])];
    Rectangle r;
    r.along = (1 / norm(to - from)) * (to - from);
    double ahead = 0, behind = 0, left = 0;
    for (const int corner : hull) {
      const auto arm = places[static_cast<std::size_t>(corner)] - from;
      ahead = std::max(ahead, dot(r.along, arm));
      behind = std::min(behind, dot(r.along, arm));
      left = std::max(left, cross(r.along, arm));
    }
    r.length = {ahead - behind, left};
    if (r.length[1] > r.length[0] * (1 + round_off)) {  // round-off makes no other way of a square
      r.along = {-r.along[1], r.along[0]};
      std::swap(r.length[0], r.length[1]);
    }
    if (r.along[0] < 0) r.along = -1.0 * r.along;
    const double slack = round_off * extent * extent;
    const bool equal = any && std::abs(r.area() - least.area()) <= slack;
    if (any && !(r.area() < least.area() - slack) && !(equal && r.along[0] > least.along[0] + round_off)) continue;
    least = r;
    any = true;
  }
  return least;
}

}  // namespace voussoir

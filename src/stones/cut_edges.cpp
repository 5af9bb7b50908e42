#include "stones/cut_edges.hpp"

#include <algorithm>

namespace voussoir {
namespace {

template <int dim>
std::vector<Box<dim>> boxes_of(const std::vector<Vector<dim>>& points) {
  std::vector<Box<dim>> boxes;
  for (const auto& x : points) boxes.push_back({x, x});
  return boxes;
}

}  // namespace

template <int dim>
CutEdges<dim>::CutEdges(const std::vector<Vector<dim>>& points, double within)
    : x_(points), within_(within), tree_(boxes_of<dim>(points)) {}

template <int dim>
typename CutEdges<dim>::Loop CutEdges<dim>::way(int a, int b) {
  const auto [known, is_new] = ways_.emplace(std::minmax(a, b), Loop{});
  if (is_new) known->second = cut(known->first.first, known->first.second);
  return a < b ? known->second : Loop(known->second.rbegin(), known->second.rend());
}

template <int dim>
typename CutEdges<dim>::Loop CutEdges<dim>::around(const Loop& corners) {
  Loop loop;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const int a = corners[k], b = corners[(k + 1) % corners.size()];
    if (a == b) continue;
    const Loop part = way(a, b);
    loop.insert(loop.end(), part.begin(), part.end() - 1);
  }
  for (std::size_t k = 0; k < loop.size() && loop.size() > 2;) {
    const int before = loop[(k + loop.size() - 1) % loop.size()], after = loop[(k + 1) % loop.size()];
    if (loop[k] == before || before == after) {
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(k));
      k = 0;
    } else {
      ++k;
    }
  }
  return loop.size() > 2 ? loop : Loop{};
}

template <int dim>
typename CutEdges<dim>::Loop CutEdges<dim>::cut(int a, int b) const {
  const auto along = x_[b] - x_[a];
  const double squared = dot(along, along);
  Box<dim> box{x_[a], x_[a]};
  box.add({x_[b], x_[b]});
  for (std::size_t i = 0; i < dim; ++i) box.low[i] -= within_, box.high[i] += within_;
  std::vector<std::pair<double, int>> between;
  tree_.visit_overlaps(box, [&](int point) {
    if (point == a || point == b) return;
    const double part = dot(x_[point] - x_[a], along) / squared;
    if (part > 0 && part < 1 && norm(x_[point] - x_[a] - part * along) <= within_) between.emplace_back(part, point);
  });
  std::sort(between.begin(), between.end());
  Loop way{a};
  for (const auto& [part, point] : between) way.push_back(point);
  way.push_back(b);
  return way;
}

template class CutEdges<2>;
template class CutEdges<3>;

}  // namespace voussoir

#include "stones/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace voussoir {
namespace {

Vector<3> doubled_area(const std::vector<Vector<3>>& polygon) {
  Vector<3> sum{};
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    sum = sum + cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return sum;
}

/// What is left of a polygon while ears are cut off it.
class Rest {
 public:
  explicit Rest(const std::vector<Vector<3>>& polygon) : x_(polygon), left_(polygon.size()) {
    std::iota(left_.begin(), left_.end(), 0);
    normal_ = doubled_area(polygon);
    size_ = std::sqrt(norm(normal_));
    for (const auto& x : polygon) size_ = std::max(size_, norm(x - polygon[0]));
  }
  std::size_t size() const { return left_.size(); }
  std::array<int, 3> ear(std::size_t k) const {
    return {left_[(k + size() - 1) % size()], left_[k], left_[(k + 1) % size()]};
  }
  void cut(std::size_t k) { left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(k)); }

  /// The corner turns to the left, and no other corner lies in the triangle.
  bool is_ear(std::size_t k) const {
    const auto t = ear(k);
    const auto &a = x_[t[0]], &b = x_[t[1]], &c = x_[t[2]];
    const double round_off = 1e-14 * size_ * size_ * norm(normal_);
    if (dot(cross(b - a, c - b), normal_) <= round_off) return false;
    for (std::size_t at = 0; at < size(); ++at)
      if (enters(at, t)) return false;
    return std::none_of(left_.begin(), left_.end(), [&](int other) {
      if (std::any_of(t.begin(), t.end(), [&](int corner) { return x_[corner] == x_[other]; })) return false;
      const auto left_of = [&](const Vector<3>& p, const Vector<3>& q) {
        return dot(cross(q - p, x_[other] - p), normal_) > -round_off;
      };
      return left_of(a, b) && left_of(b, c) && left_of(c, a);
    });
  }

  /// Whether at a corner that lies on one of a triangle's, as a polygon has that goes to a hole and back, an edge runs
  /// into the triangle.
  bool enters(std::size_t at, const std::array<int, 3>& t) const {
    const auto turn = [&](const Vector<3>& u, const Vector<3>& v) { return dot(cross(u, v), normal_); };
    for (int k = 0; k < 3; ++k) {
      const int other = left_[at];
      if (other == t[0] || other == t[1] || other == t[2] || x_[other] != x_[t[k]]) continue;
      const auto &corner = x_[t[k]], next = x_[t[(k + 1) % 3]] - corner, before = x_[t[(k + 2) % 3]] - corner;
      for (const int end : {left_[(at + 1) % size()], left_[(at + size() - 1) % size()]}) {
        const auto edge = x_[end] - corner;
        const double round_off = 1e-14 * size_ * size_ * norm(normal_);
        if (turn(next, edge) > round_off && turn(edge, before) > round_off) return true;
      }
    }
    return false;
  }

  /// Whether the diagonal of ear j goes before that of ear k. Lengths and places that differ by round-off are the
  /// same: 1e-7 of the polygon, far above the rounding of coordinates and below what a drawing means.
  bool before(std::size_t j, std::size_t k) const {
    const auto s = ear(j), t = ear(k);
    const double same = 1e-7 * size_;
    const double lengths = norm(x_[s[2]] - x_[s[0]]) - norm(x_[t[2]] - x_[t[0]]);
    if (std::abs(lengths) > same) return lengths < 0;
    const auto lower = [&](int p, int q) {
      for (int i = 0; i < 3; ++i)
        if (std::abs(x_[p][i] - x_[q][i]) > same) return x_[p][i] < x_[q][i];
      return false;
    };
    auto first = std::make_pair(s[0], s[2]), second = std::make_pair(t[0], t[2]);
    for (auto* ends : {&first, &second})
      if (lower(ends->second, ends->first)) std::swap(ends->first, ends->second);
    if (lower(first.first, second.first) || lower(second.first, first.first)) return lower(first.first, second.first);
    return lower(first.second, second.second);
  }

 private:
  const std::vector<Vector<3>>& x_;
  std::vector<int> left_;
  Vector<3> normal_{};
  double size_ = 0;
};

}  // namespace

double area(const Polygon& p) {
  double doubled = 0;
  for (std::size_t k = 1; k + 1 < p.size(); ++k) doubled += cross(p[k] - p[0], p[k + 1] - p[0]);
  return doubled / 2;
}

double perimeter(const Polygon& p) {
  double sum = 0;
  for (std::size_t k = 0; k < p.size(); ++k) sum += norm(p[(k + 1) % p.size()] - p[k]);
  return sum;
}

double mean_width(const Polygon& p) {
  const double around = perimeter(p);
  return around > 0 ? 2 * std::abs(area(p)) / around : 0;
}

bool is_convex(const Polygon& p, double slack) {
  for (std::size_t k = 0; k < p.size(); ++k) {
    const auto before = p[k] - p[(k + p.size() - 1) % p.size()], after = p[(k + 1) % p.size()] - p[k];
    if (cross(before, after) < -slack * norm(before) * norm(after)) return false;
  }
  return true;
}

bool holds(const Polygon& p, const Vector<2>& x) {
  bool inside = false;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const auto &a = p[k], &b = p[(k + 1) % p.size()];
    if ((a[1] > x[1]) != (b[1] > x[1]) && x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
  }
  return inside;
}

std::vector<std::vector<int>> loops_apart(const Polygon& border) {
  std::vector<std::vector<int>> loops;
  std::vector<int> open;
  for (int k = 0; k < static_cast<int>(border.size()); ++k) {
    const auto again = std::find_if(open.begin(), open.end(), [&](int n) { return border[n] == border[k]; });
    if (again != open.end()) {
      loops.emplace_back(again, open.end());
      open.erase(again, open.end());
    }
    open.push_back(k);
  }
  loops.push_back(open);
  return loops;
}

Polygon common_part(Polygon p, const Polygon& clip) {
  for (std::size_t side = 0; side < clip.size(); ++side) {
    const auto &from = clip[side], &to = clip[(side + 1) % clip.size()];
    const double length = norm(to - from);
    if (length == 0) continue;
    std::vector<double> left;  // [m] how far each corner lies to the left of the side
    for (const auto& x : p) left.push_back(cross(to - from, x - from) / length);
    Polygon rest;
    for (std::size_t k = 0; k < p.size(); ++k) {
      const std::size_t last = (k + p.size() - 1) % p.size();
      if ((left[last] < 0) != (left[k] < 0))
        rest.push_back(p[last] + (left[last] / (left[last] - left[k])) * (p[k] - p[last]));
      if (left[k] >= 0) rest.push_back(p[k]);
    }
    p = std::move(rest);
    if (p.size() < 3) return {};
  }
  return p;
}

Polygon corners_of(const Polygon& p, double within) {
  Polygon left;
  for (const auto& x : p)
    if (left.empty() || norm(x - left.back()) > within) left.push_back(x);
  if (left.size() > 1 && norm(left.front() - left.back()) <= within) left.pop_back();
  for (std::size_t k = 0; left.size() > 3 && k < left.size();) {
    const auto &a = left[(k + left.size() - 1) % left.size()], &c = left[(k + 1) % left.size()];
    const double length = norm(c - a);
    if (length > 0 && std::abs(cross(c - a, left[k] - a)) <= within * length) {
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
      k = k > 0 ? k - 1 : 0;
    } else {
      ++k;
    }
  }
  return left;
}

std::vector<std::array<int, 3>> cut_into_triangles(const std::vector<Vector<3>>& polygon) {
  std::vector<std::array<int, 3>> triangles;
  Rest rest(polygon);
  while (rest.size() > 3) {
    std::size_t best = 0;
    bool found = false;
    for (const bool ears_only : {true, false}) {  // a polygon that crosses itself may have no ear
      for (std::size_t k = 0; k < rest.size(); ++k)
        if ((!ears_only || rest.is_ear(k)) && (!found || rest.before(k, best))) best = k, found = true;
      if (found) break;
    }
    triangles.push_back(rest.ear(best));
    rest.cut(best);
  }
  triangles.push_back(rest.ear(1));
  return triangles;
}

PlaneAxes::PlaneAxes(const Vector<3>& at, const Vector<3>& along_normal) : origin(at) {
  normal = (1 / norm(along_normal)) * along_normal;
  Vector<3> least{};
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  least[static_cast<std::size_t>(std::min_element(normal.begin(), normal.end(), smaller) - normal.begin())] = 1;
  first = cross(normal, least);
  first = (1 / norm(first)) * first;
  second = cross(normal, first);
}

}  // namespace voussoir

#include "joints/shared_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/half_spaces.hpp"
#include "base/orthogonal.hpp"
#include "base/product.hpp"

namespace voussoir {
namespace {

using Rows = std::vector<std::vector<double>>;

// Coefficients of balance are cosines: what elimination leaves of one that vanishes is round-off, far below this.
constexpr double vanishing_cosine = 1e-10;
// [-] of the largest force: so far within its law a point is left that bears what it can, or round-off would decide
// whether it sticks. A hundred times what solvers leave of forces.
constexpr double within = 1e-6;
// Half planes in the place of discs are cut in the direction of what they leave outside. Of it a cut leaves the square
// of its angle, so a few are enough where there is any answer.
constexpr int most_cuts = 30;

/// Vectors that span all z with rows z = 0, by elimination with full pivots.
Rows null_space(Rows rows, int unknowns) {
  std::vector<int> pivot_of(unknowns, -1);
  int rank = 0;
  for (; rank < static_cast<int>(rows.size()); ++rank) {
    int row = -1, column = -1;
    double largest = vanishing_cosine;
    for (int i = rank; i < static_cast<int>(rows.size()); ++i)
      for (int j = 0; j < unknowns; ++j)
        if (pivot_of[j] < 0 && std::abs(rows[i][j]) > largest) {
          largest = std::abs(rows[i][j]);
          row = i;
          column = j;
        }
    if (row < 0) break;
    std::swap(rows[row], rows[rank]);
    pivot_of[column] = rank;
    const double pivot = rows[rank][column];
    for (auto& value : rows[rank]) value /= pivot;
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
      const double factor = rows[i][column];
      if (i == rank || factor == 0) continue;
      for (int j = 0; j < unknowns; ++j) rows[i][j] -= factor * rows[rank][j];
    }
  }
  Rows basis;
  for (int free = 0; free < unknowns; ++free) {
    if (pivot_of[free] >= 0) continue;
    std::vector<double> z(unknowns, 0.0);
    z[free] = 1;
    for (int j = 0; j < unknowns; ++j)
      if (pivot_of[j] >= 0) z[j] = -rows[pivot_of[j]][free];
    basis.push_back(z);
  }
  return basis;
}

/// Makes vectors orthonormal.
void make_orthonormal(Rows& basis) {
  Rows done;
  for (auto v : basis) {
    take_off(done, product, v);
    const double length = std::sqrt(product(v, v));
    for (auto& value : v) value /= length;
    done.push_back(v);
  }
  basis = done;
}

/// What a point bears at a place: its normal force first, then along its tangents.
using PointForce = std::array<double, 3>;

/// An orthonormal basis of what forces of points that meet can change by, each over the root of its weight.
/// @param points   that meet;  @param weight  of each
/// @param balance  of their nodes: coefficients of the forces, n per point
/// @param follows  friction of those that slip follows their normal forces
Rows ways_to_split(const std::vector<int>& points, const std::vector<double>& weight, const Rows& balance,
                   const std::vector<PointFreedom>& freedom, std::size_t n, bool follows) {
  // Directions in which a force may change: its components, or all in proportion.
  struct Direction {
    std::size_t at;  // of the point
    PointForce force;
  };
  std::vector<Direction> directions;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& f = freedom[points[i]];
    const bool alone = f.tangential || !follows;
    if (f.normal) directions.push_back({i, alone ? PointForce{1} : PointForce{1, f.slope[0], f.slope[1]}});
    for (std::size_t t = 1; t < n && f.tangential; ++t) {
      directions.push_back({i, {}});
      directions.back().force[t] = 1;
    }
  }
  Rows rows;
  for (const auto& row : balance) {
    rows.emplace_back();
    for (const auto& d : directions) {
      double sum = 0;
      for (std::size_t c = 0; c < n; ++c) sum += row[n * d.at + c] * d.force[c];
      rows.back().push_back(sum);
    }
  }
  Rows basis;
  for (const auto& z : null_space(rows, static_cast<int>(directions.size()))) {
    std::vector<double> force(n * points.size(), 0.0);
    for (std::size_t j = 0; j < z.size(); ++j) {
      const double root = std::sqrt(weight[directions[j].at]);
      for (std::size_t c = 0; c < n; ++c) force[n * directions[j].at + c] += z[j] * directions[j].force[c] / root;
    }
    basis.push_back(force);
  }
  make_orthonormal(basis);
  return basis;
}

/// Bounds of the laws of points that meet, for changes y along a basis of their forces over the roots of their weights.
class LawfulSplit {
 public:
  /// @param force   from which they change
  /// @param margin  by which a law is to be kept
  LawfulSplit(const Rows& basis, const std::vector<double>& force, double margin, std::size_t n)
      : basis_(basis), force_(force), margin_(margin), n_(n) {}

  /// Of point i: it does not part, and its shear is bounded along each of its tangents.
  /// @param root  of its weight
  void add_point(const PointFreedom& f, std::size_t i, double root) {
    if (f.normal) add(i, {1}, f.law.tension / root);
    if (!f.tangential) return;
    shears_.push_back({i, f.law.friction, f.law.cohesion / root});
    for (std::size_t t = 1; t < n_; ++t)
      for (const double side : {-1.0, 1.0}) {
        PointForce slope{f.law.friction};
        slope[t] = side;
        add(i, slope, f.law.cohesion / root);
      }
  }

  /// The shortest change within all laws; none where there is no such change.
  std::vector<double> shortest_change() {
    auto y = within_bounds();
    for (int cut = 0; n_ == 3 && !y.empty() && cut < most_cuts && cut_discs(y); ++cut) y = within_bounds();
    return y;
  }

 private:
  struct Shear {
    std::size_t point;
    double friction, cohesion;  ///< of forces over the root of the weight
  };

  void add(std::size_t i, const PointForce& slope, double strength) {
    if (!std::isfinite(strength) || !std::isfinite(slope[0])) return;
    HalfSpace b;
    b.least = margin_ - strength;
    for (std::size_t c = 0; c < n_; ++c) b.least -= slope[c] * force_[n_ * i + c];
    for (const auto& z : basis_) {
      b.slope.push_back(0);
      for (std::size_t c = 0; c < n_; ++c) b.slope.back() += slope[c] * z[n_ * i + c];
    }
    const double length = std::sqrt(product(b.slope, b.slope));
    if (length <= vanishing_cosine) return;  // no change moves the point this way, so that none can keep or break it
    for (auto& value : b.slope) value /= length;
    b.least /= length;
    bounds_.push_back(std::move(b));
  }

  std::vector<double> within_bounds() const { return shortest_within(bounds_, basis_.size()); }

  /// Whether a force was left outside of its disc by more than half the margin: now none goes as far that way.
  bool cut_discs(const std::vector<double>& y) {
    bool any = false;
    for (const auto& s : shears_) {
      PointForce f{};
      for (std::size_t c = 0; c < n_; ++c) {
        f[c] = force_[n_ * s.point + c];
        for (std::size_t j = 0; j < y.size(); ++j) f[c] += y[j] * basis_[j][n_ * s.point + c];
      }
      const double size = std::hypot(f[1], f[2]);
      if (!(size > s.cohesion + s.friction * f[0] - margin_ / 2) || size == 0) continue;
      add(s.point, {s.friction, -f[1] / size, -f[2] / size}, s.cohesion);
      any = true;
    }
    return any;
  }

  const Rows& basis_;
  const std::vector<double>& force_;
  double margin_;
  std::size_t n_;
  std::vector<HalfSpace> bounds_;
  std::vector<Shear> shears_;
};

/// Points that meet, in groups, where a node is of this rank: those of one group in the order of their numbers.
template <class NodeOf>
std::vector<std::vector<int>> points_that_meet(const BlockSystem& s, const ContactPoints& points,
                                               const std::vector<char>& counts, const NodeOf& node_of) {
  DisjointSets sets(s.nodes());
  std::vector<int> those;
  for (int k = 0; k < points.size(); ++k)
    if (counts[k] && points.points()[k].can_be_tied()) those.push_back(k);
  for (const int k : those) {
    const auto& p = points.points()[k];
    sets.join(sets.root(node_of(p.shares_i.first())), sets.root(node_of(p.shares_j.first())));
  }
  std::vector<char> own(s.nodes(), 0);
  std::map<int, std::vector<int>> points_at;  // by root
  for (const int k : those) {
    const int root = sets.root(node_of(points.points()[k].shares_i.first()));
    points_at[root].push_back(k);
    if (points.at(k).any([&](int node) { return node < s.owned_nodes(); })) own[root] = 1;
  }
  std::vector<std::vector<int>> groups;
  for (auto& [root, here] : points_at) {
    if (!own[root]) continue;
    std::sort(here.begin(), here.end(), [&](int a, int b) { return points.points()[a].id < points.points()[b].id; });
    groups.push_back(std::move(here));
  }
  return groups;
}

}  // namespace

SharedForces::SharedForces(const BlockSystem& s, const ContactPoints& points, const std::vector<int>& cluster,
                           const Held& held, const std::vector<char>& counts)
    : components_(static_cast<std::size_t>(points.components())) {
  const std::size_t n = components_;
  std::vector<int> first(s.nodes(), -1);  // node copy of each cluster
  const auto node_of = [&](int node) {
    auto& f = first[cluster[node]];
    return f < 0 ? f = node : f;
  };
  for (auto& here : points_that_meet(s, points, counts, node_of)) {
    Place place;
    std::map<NodeId, Rows> rows;  // by node, in an order that no rank changes
    const std::size_t size = n * here.size();
    for (std::size_t i = 0; i < here.size(); ++i) {
      const auto& p = points.points()[here[i]];
      place.weight.push_back(p.area);
      points.at(here[i]).each([&](int node, double weight) {
        auto& row = rows[s.node_id()[node_of(node)]];
        row.resize(n);
        for (std::size_t a = 0; a < n; ++a) {
          const auto axis = held.to_own(cluster[node], p.axis[a]);
          for (std::size_t c = 0; c < n; ++c) {
            if (held[n * cluster[node] + c]) continue;
            row[c].resize(size, 0.0);
            row[c][n * i + a] += weight * axis[c];
          }
        }
      });
    }
    for (auto& [node, row] : rows)
      for (auto& r : row)
        if (!r.empty()) place.balance.push_back(std::move(r));
    place.points = std::move(here);
    if (!null_space(place.balance, static_cast<int>(size)).empty()) places_.push_back(std::move(place));
  }
}

void SharedForces::split(const std::vector<PointFreedom>& freedom, SharedFriction friction,
                         std::vector<double>& lambda) const {
  for (const auto& place : places_) split(place, freedom, friction, lambda);
}

void SharedForces::split(const Place& place, const std::vector<PointFreedom>& freedom, SharedFriction friction,
                         std::vector<double>& lambda) const {
  const std::size_t n = components_;
  auto basis = ways_to_split(place.points, place.weight, place.balance, freedom, n, true);
  const bool any_slips = std::any_of(place.points.begin(), place.points.end(),
                                     [&](int k) { return freedom[k].normal && !freedom[k].tangential; });
  if (any_slips && friction == SharedFriction::held_where_it_hides)
    if (auto held = ways_to_split(place.points, place.weight, place.balance, freedom, n, false);
        held.size() > basis.size())
      basis = std::move(held);
  if (basis.empty()) return;
  std::vector<double> force(n * place.points.size());
  for (std::size_t i = 0; i < place.points.size(); ++i)
    for (std::size_t c = 0; c < n; ++c) force[n * i + c] = lambda[n * place.points[i] + c] / std::sqrt(place.weight[i]);
  for (const auto& z : basis) {
    const double along = product(z, force);
    for (std::size_t i = 0; i < z.size(); ++i) force[i] -= along * z[i];
  }
  double largest = 0;  // of what nothing bounds, which does not depend on how large the forces were that run round
  for (const double f : force) largest = std::max(largest, std::abs(f));
  LawfulSplit lawful(basis, force, within * largest, n);
  for (std::size_t i = 0; i < place.points.size(); ++i)
    lawful.add_point(freedom[place.points[i]], i, std::sqrt(place.weight[i]));
  const auto y = lawful.shortest_change();
  for (std::size_t i = 0; i < place.points.size(); ++i)
    for (std::size_t c = 0; c < n; ++c) {
      for (std::size_t j = 0; j < y.size(); ++j) force[n * i + c] += y[j] * basis[j][n * i + c];
      lambda[n * place.points[i] + c] = force[n * i + c] * std::sqrt(place.weight[i]);
    }
}

}  // namespace voussoir

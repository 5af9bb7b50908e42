#include "joints/tractions.hpp"

#include <algorithm>
#include <cmath>

#include "base/dense.hpp"

namespace voussoir {
namespace {

// A tied point that stands open counts as if it had this share of its area: far more than round-off, far less than any
// closed point.
constexpr double share_of_open = 1e-6;

struct TiedPoint {
  int cluster;
  int point;
};

/// The tied points of one place, and the node copies that they hold together.
class PlaceOfTies {
 public:
  struct Tie {
    int point, i, j;  ///< the nodes by their numbers here
    double share;     ///< [m2]
  };

  explicit PlaceOfTies(int nodes) : number_(nodes, -1) {}

  /// @param share  [m2] of a point
  template <class Share>
  void begin(const ContactPoints& points, const Share& share, const TiedPoint* first, const TiedPoint* last) {
    for (const int node : nodes_) number_[node] = -1;
    nodes_.clear();
    ties_.clear();
    for (auto tied = first; tied != last; ++tied) {
      const auto& p = points.points()[tied->point];
      const int i = number_of(p.shares_i.first()), j = number_of(p.shares_j.first());
      ties_.push_back({tied->point, i, j, share(tied->point)});
    }
  }

  const std::vector<int>& nodes() const { return nodes_; }
  const std::vector<Tie>& ties() const { return ties_; }

  /// The potential whose differences balance what nodes carry in one component.
  std::vector<double> potential(const std::vector<double>& carried, const Held& held, int components, int c) const {
    const int n = static_cast<int>(nodes_.size());
    std::vector<double> a(n * n, 0.0), b(n);
    double mean = 0;
    for (int i = 0; i < n; ++i) {
      b[i] = carried[components * nodes_[i] + c];
      mean += b[i] / n;
    }
    for (const auto& tie : ties_) {
      a[tie.i * n + tie.i] += tie.share;
      a[tie.j * n + tie.j] += tie.share;
      a[tie.i * n + tie.j] -= tie.share;
      a[tie.j * n + tie.i] -= tie.share;
    }
    bool grounded = false;
    const auto ground = [&](int i) {
      for (int j = 0; j < n; ++j) a[i * n + j] = a[j * n + i] = 0;
      a[i * n + i] = 1;
      b[i] = 0;
      grounded = true;
    };
    for (int i = 0; i < n; ++i)
      if (held[components * nodes_[i] + c]) ground(i);
    if (!grounded) {
      for (auto& value : b) value -= mean;  // what the linear solver left over
      ground(0);
    }
    solve_positive(a, b);  // a grounded graph Laplacian, of the few blocks that meet at a vertex
    return b;
  }

 private:
  int number_of(int node) {
    if (number_[node] < 0) {
      number_[node] = static_cast<int>(nodes_.size());
      nodes_.push_back(node);
    }
    return number_[node];
  }

  std::vector<int> number_, nodes_;
  std::vector<Tie> ties_;
};

/// The tied points, those of a cluster together.
std::vector<TiedPoint> by_cluster(const ContactPoints& points, const std::vector<int>& cluster) {
  std::vector<TiedPoint> tied;
  for (int k = 0; k < points.size(); ++k) {
    const auto& p = points.points()[k];
    if (is_tied(p, cluster)) tied.push_back({cluster_of_tied(p, cluster), k});
  }
  std::stable_sort(tied.begin(), tied.end(), [](const auto& a, const auto& b) { return a.cluster < b.cluster; });
  return tied;
}

}  // namespace

void add_contact_forces(const ContactPoints& points, const std::vector<int>& cluster, const std::vector<double>& lambda,
                        double factor, std::vector<double>& nodal) {
  const std::size_t components = points.components();
  for (int k = 0; k < points.size(); ++k)
    if (cluster.empty() || !is_tied(points.points()[k], cluster))
      points.at(k).add_forces(&lambda[components * k], factor, nodal);
}

void recover_tied_forces(const ContactPoints& points, const std::vector<int>& cluster, const Held& held,
                         const std::vector<double>& residual, std::vector<double>& lambda,
                         const std::vector<double>& before, const std::vector<char>& open) {
  const int dim = points.components();
  auto carried = residual;
  if (!before.empty())
    for (int k = 0; k < points.size(); ++k)
      if (is_tied(points.points()[k], cluster)) std::copy_n(before.begin() + dim * k, dim, lambda.begin() + dim * k);
  add_contact_forces(points, before.empty() ? cluster : std::vector<int>{}, lambda, -1.0, carried);
  const auto share = [&](int k) { return points.points()[k].area * (!open.empty() && open[k] ? share_of_open : 1.0); };

  const auto tied = by_cluster(points, cluster);
  PlaceOfTies place(static_cast<int>(cluster.size()));
  for (std::size_t first = 0; first < tied.size();) {
    std::size_t last = first;
    while (last < tied.size() && tied[last].cluster == tied[first].cluster) ++last;
    place.begin(points, share, &tied[first], &tied[last - 1] + 1);
    std::vector<double> force(place.nodes().size() * dim, 0.0);  // potential, then per node and component
    for (int c = 0; c < dim; ++c) {
      const auto of_nodes = place.potential(carried, held, dim, c);
      for (std::size_t i = 0; i < of_nodes.size(); ++i) force[i * dim + c] = of_nodes[i];
    }
    for (const auto& tie : place.ties()) {
      const auto& p = points.points()[tie.point];
      for (int axis = 0; axis < dim; ++axis) {
        double value = 0;
        for (int c = 0; c < dim; ++c) value += (force[tie.j * dim + c] - force[tie.i * dim + c]) * p.axis[axis][c];
        value *= tie.share;
        lambda[dim * tie.point + axis] = before.empty() ? value : lambda[dim * tie.point + axis] + value;
      }
    }
    first = last;
  }
}

}  // namespace voussoir

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

}  // namespace

template <int dim>
void add_contact_forces(const ContactPoints<dim>& points, const std::vector<int>& cluster,
                        const std::vector<double>& lambda, double factor, std::vector<double>& nodal) {
  for (int k = 0; k < points.size(); ++k) {
    const auto& p = points.points()[k];
    if (!cluster.empty() && cluster[p.node_i] == cluster[p.node_j]) continue;
    for (int a = 0; a < dim; ++a)
      for (int c = 0; c < dim; ++c) {
        const double force = factor * lambda[dim * k + a] * p.axis[a][c];
        nodal[dim * p.node_j + c] += force;
        nodal[dim * p.node_i + c] -= force;
      }
  }
}

template <int dim>
void recover_tied_forces(const Structure<dim>& s, const ContactPoints<dim>& points, const std::vector<int>& cluster,
                         const std::vector<char>& held, const std::vector<double>& residual,
                         std::vector<double>& lambda, const std::vector<double>& before,
                         const std::vector<char>& open) {
  auto carried = residual;
  if (!before.empty())
    for (int k = 0; k < points.size(); ++k)
      if (cluster[points.points()[k].node_i] == cluster[points.points()[k].node_j])
        std::copy_n(before.begin() + dim * k, dim, lambda.begin() + dim * k);
  add_contact_forces(points, before.empty() ? cluster : std::vector<int>{}, lambda, -1.0, carried);
  const auto share = [&](int k) { return points.points()[k].area * (!open.empty() && open[k] ? share_of_open : 1.0); };

  std::vector<TiedPoint> tied;
  for (int k = 0; k < points.size(); ++k) {
    const auto& p = points.points()[k];
    if (cluster[p.node_i] == cluster[p.node_j]) tied.push_back({cluster[p.node_i], k});
  }
  std::stable_sort(tied.begin(), tied.end(), [](const auto& a, const auto& b) { return a.cluster < b.cluster; });

  std::vector<int> number(s.nodes(), -1);
  for (std::size_t first = 0; first < tied.size();) {
    std::size_t last = first;
    std::vector<int> nodes;
    for (; last < tied.size() && tied[last].cluster == tied[first].cluster; ++last) {
      const auto& p = points.points()[tied[last].point];
      for (int node : {p.node_i, p.node_j})
        if (number[node] < 0) {
          number[node] = static_cast<int>(nodes.size());
          nodes.push_back(node);
        }
    }
    const int n = static_cast<int>(nodes.size());
    std::vector<double> force(n * dim, 0.0);  // potential, then per node and component
    for (int c = 0; c < dim; ++c) {
      std::vector<double> a(n * n, 0.0), b(n);
      bool grounded = false;
      double mean = 0;
      for (int i = 0; i < n; ++i) {
        b[i] = carried[dim * nodes[i] + c];
        mean += b[i] / n;
      }
      for (std::size_t k = first; k < last; ++k) {
        const auto& p = points.points()[tied[k].point];
        const int i = number[p.node_i], j = number[p.node_j];
        const double area = share(tied[k].point);
        a[i * n + i] += area;
        a[j * n + j] += area;
        a[i * n + j] -= area;
        a[j * n + i] -= area;
      }
      const auto ground = [&](int i) {
        for (int j = 0; j < n; ++j) a[i * n + j] = a[j * n + i] = 0;
        a[i * n + i] = 1;
        b[i] = 0;
        grounded = true;
      };
      for (int i = 0; i < n; ++i)
        if (held[dim * nodes[i] + c]) ground(i);
      if (!grounded) {
        for (auto& value : b) value -= mean;  // what the linear solver left over
        ground(0);
      }
      solve_positive(a, b);  // a grounded graph Laplacian, of the few blocks that meet at a vertex
      for (int i = 0; i < n; ++i) force[i * dim + c] = b[i];
    }
    for (std::size_t k = first; k < last; ++k) {
      const auto& p = points.points()[tied[k].point];
      for (int axis = 0; axis < dim; ++axis) {
        double value = 0;
        for (int c = 0; c < dim; ++c)
          value += (force[number[p.node_j] * dim + c] - force[number[p.node_i] * dim + c]) * p.axis[axis][c];
        value *= share(tied[k].point);
        lambda[dim * tied[k].point + axis] = before.empty() ? value : lambda[dim * tied[k].point + axis] + value;
      }
    }
    for (int node : nodes) number[node] = -1;
    first = last;
  }
}

template void add_contact_forces<2>(const ContactPoints<2>&, const std::vector<int>&, const std::vector<double>&,
                                    double, std::vector<double>&);
template void recover_tied_forces<2>(const Structure<2>&, const ContactPoints<2>&, const std::vector<int>&,
                                     const std::vector<char>&, const std::vector<double>&, std::vector<double>&,
                                     const std::vector<double>&, const std::vector<char>&);

}  // namespace voussoir

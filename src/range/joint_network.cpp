#include "range/joint_network.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace voussoir {
namespace {

// Stones that no joint holds are held by springs of this share of what else there is: far above round-off, far below
// anything that bears.
constexpr double held_in_space = 1e-9;

/// What a joint feels of its two stones' motions: rows along its axes and about them; columns motions of i, then of j.
template <int dim>
using Strain = std::array<std::array<double, 2 * ways_of_network<dim>>, ways_of_network<dim>>;

/// Moments of a unit force at an arm, one in the plane.
std::array<double, 1> moments(const Vector<2>& arm, const Vector<2>& force) { return {cross(arm, force)}; }
Vector<3> moments(const Vector<3>& arm, const Vector<3>& force) { return cross(arm, force); }

template <int dim>
Strain<dim> strain_of(const NetworkJoint<dim>& joint) {
  constexpr int ways = ways_of_network<dim>;
  Strain<dim> b{};
  for (int row = 0; row < dim; ++row) {
    const auto& axis = joint.axis[row];
    const auto of_i = moments(joint.arm_i, axis), of_j = moments(joint.arm_j, axis);
    for (int c = 0; c < dim; ++c) b[row][c] = -axis[c], b[row][ways + c] = axis[c];
    for (int r = 0; r < ways - dim; ++r) b[row][dim + r] = -of_i[r], b[row][ways + dim + r] = of_j[r];
  }
  for (int r = 0; r < ways - dim; ++r)
    for (int c = 0; c < ways - dim; ++c) {
      const double along = dim == 2 ? 1.0 : joint.axis[r][c];
      b[dim + r][dim + c] = -along, b[dim + r][ways + dim + c] = along;
    }
  return b;
}

template <int dim>
std::array<int, 2 * ways_of_network<dim>> unknowns_of(const NetworkJoint<dim>& joint) {
  constexpr int ways = ways_of_network<dim>;
  std::array<int, 2 * ways> unknown{};
  for (int c = 0; c < ways; ++c) {
    unknown[c] = joint.i < 0 ? -1 : ways * joint.i + c;
    unknown[c + ways] = joint.j < 0 ? -1 : ways * joint.j + c;
  }
  return unknown;
}

struct Entry {
  int row, column;
  double value;
  bool operator<(const Entry& o) const { return row != o.row ? row < o.row : column < o.column; }
};

/// Upper triangle, each row beginning with its diagonal.
template <int dim>
LocalCsr matrix_of(int stones, const std::vector<NetworkJoint<dim>>& joints) {
  constexpr int ways = ways_of_network<dim>;
  std::vector<Entry> entries;
  for (int row = 0; row < ways * stones; ++row) entries.push_back({row, row, 0});
  for (const auto& joint : joints) {
    const auto b = strain_of(joint);
    const auto unknown = unknowns_of(joint);
    for (int p = 0; p < 2 * ways; ++p)
      for (int q = 0; q < 2 * ways; ++q) {
        if (unknown[p] < 0 || unknown[q] < unknown[p]) continue;
        double sum = 0;
        for (int row = 0; row < ways; ++row) sum += b[row][p] * joint.stiffness[row] * b[row][q];
        entries.push_back({unknown[p], unknown[q], sum});
      }
  }
  std::stable_sort(entries.begin(), entries.end());
  LocalCsr a;
  for (std::size_t k = 0; k < entries.size();) {
    const int row = entries[k].row, column = entries[k].column;
    double sum = 0;
    for (; k < entries.size() && entries[k].row == row && entries[k].column == column; ++k) sum += entries[k].value;
    if (row == column) sum = sum > 0 ? (1 + held_in_space) * sum : 1;
    a.column.push_back(column);
    a.value.push_back(sum);
    if (k == entries.size() || entries[k].row != row) a.start.push_back(static_cast<int>(a.column.size()));
  }
  return a;
}

}  // namespace

template <int dim>
std::vector<NetworkForce<dim>> borne_by_network(int stones, const std::vector<NetworkJoint<dim>>& joints,
                                                const std::vector<NetworkLoad<dim>>& load) {
  VOUSSOIR_EXPECT(load.size() == static_cast<std::size_t>(stones) && "loads: per stone");
  for (const auto& joint : joints) {
    VOUSSOIR_EXPECT(joint.i < stones && joint.j < stones && "stones of a joint: of the network");
    VOUSSOIR_EXPECT(std::abs(norm(joint.axis[0]) - 1) < 1e-9 && "normal of a joint: of length one");
  }
  std::vector<NetworkForce<dim>> forces(joints.size(), NetworkForce<dim>{});
  if (stones == 0 || joints.empty()) return forces;
  std::vector<double> x;
  for (const auto& l : load) x.insert(x.end(), l.begin(), l.end());
  SparseCholesky(matrix_of(stones, joints)).solve(x.data(), x.data());
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto b = strain_of(joints[k]);
    const auto unknown = unknowns_of(joints[k]);
    for (std::size_t row = 0; row < b.size(); ++row)
      for (std::size_t p = 0; p < unknown.size(); ++p)
        if (unknown[p] >= 0) forces[k][row] -= joints[k].stiffness[row] * b[row][p] * x[unknown[p]];
  }
  return forces;
}

template std::vector<NetworkForce<2>> borne_by_network<2>(int, const std::vector<NetworkJoint<2>>&,
                                                          const std::vector<NetworkLoad<2>>&);
template std::vector<NetworkForce<3>> borne_by_network<3>(int, const std::vector<NetworkJoint<3>>&,
                                                          const std::vector<NetworkLoad<3>>&);

}  // namespace voussoir

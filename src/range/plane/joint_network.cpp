#include "range/plane/joint_network.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace voussoir {
namespace {

// Stones that no joint holds are held by springs of this share of what else there is: far above round-off, far below
// anything that bears.
constexpr double held_in_space = 1e-9;

/// What a joint feels of its two stones' motions: rows parting, sliding, turning; columns x, y, turn of i, then of j.
using Strain = std::array<std::array<double, 6>, 3>;

Strain strain_of(const NetworkJoint& joint) {
  const Vector<2> tangent{-joint.normal[1], joint.normal[0]};
  Strain b{};
  for (int row = 0; row < 2; ++row) {
    const auto& axis = row == 0 ? joint.normal : tangent;
    b[row] = {-axis[0], -axis[1], -cross(joint.arm_i, axis), axis[0], axis[1], cross(joint.arm_j, axis)};
  }
  b[2] = {0, 0, -1, 0, 0, 1};
  return b;
}

std::array<int, 6> unknowns_of(const NetworkJoint& joint) {
  std::array<int, 6> unknown{};
  for (int c = 0; c < 3; ++c) {
    unknown[c] = joint.i < 0 ? -1 : 3 * joint.i + c;
    unknown[c + 3] = joint.j < 0 ? -1 : 3 * joint.j + c;
  }
  return unknown;
}

struct Entry {
  int row, column;
  double value;
  bool operator<(const Entry& o) const { return row != o.row ? row < o.row : column < o.column; }
};

/// Upper triangle, each row beginning with its diagonal.
LocalCsr matrix_of(int stones, const std::vector<NetworkJoint>& joints) {
  std::vector<Entry> entries;
  for (int row = 0; row < 3 * stones; ++row) entries.push_back({row, row, 0});
  for (const auto& joint : joints) {
    const auto b = strain_of(joint);
    const auto unknown = unknowns_of(joint);
    for (int p = 0; p < 6; ++p)
      for (int q = 0; q < 6; ++q) {
        if (unknown[p] < 0 || unknown[q] < unknown[p]) continue;
        double sum = 0;
        for (int row = 0; row < 3; ++row) sum += b[row][p] * joint.stiffness[row] * b[row][q];
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

std::vector<NetworkForce> borne_by_network(int stones, const std::vector<NetworkJoint>& joints,
                                           const std::vector<std::array<double, 3>>& load) {
  VOUSSOIR_EXPECT(load.size() == static_cast<std::size_t>(stones) && "loads: per stone");
  for (const auto& joint : joints) {
    VOUSSOIR_EXPECT(joint.i < stones && joint.j < stones && "stones of a joint: of the network");
    VOUSSOIR_EXPECT(std::abs(norm(joint.normal) - 1) < 1e-9 && "normal of a joint: of length one");
  }
  std::vector<NetworkForce> forces(joints.size(), NetworkForce{});
  if (stones == 0 || joints.empty()) return forces;
  std::vector<double> x;
  for (const auto& l : load) x.insert(x.end(), l.begin(), l.end());
  SparseCholesky(matrix_of(stones, joints)).solve(x.data(), x.data());
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto b = strain_of(joints[k]);
    const auto unknown = unknowns_of(joints[k]);
    for (int row = 0; row < 3; ++row)
      for (int p = 0; p < 6; ++p)
        if (unknown[p] >= 0) forces[k][row] -= joints[k].stiffness[row] * b[row][p] * x[unknown[p]];
  }
  return forces;
}

}  // namespace voussoir

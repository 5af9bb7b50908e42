#include "statics/limit_programme.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voussoir {
namespace {

using Column = std::vector<ProgrammeEntry>;

/// Adds a wrench on a stone to a column, in the rows of its balance.
void add_wrench(const RigidStructure& s, int stone, const Wrench& wrench, double sign, double unit, Column& column) {
  const auto w = scaled(wrench, s.stones[static_cast<std::size_t>(stone)].radius, unit);
  for (int c = 0; c < 3; ++c) column.push_back({3 * stone + c, sign * w[static_cast<std::size_t>(c)]});
}

/// A force of a contact along a direction of its axes, on both stones.
Column column_of(const RigidStructure& s, const RigidContact& c, const std::array<Vector<2>, 2>& arm,
                 const Vector<2>& direction) {
  const Vector<2> f = direction[0] * c.axis[0] + direction[1] * c.axis[1];
  Column column;
  add_wrench(s, c.stone_j, wrench_of(arm[1], f), 1, 1, column);
  add_wrench(s, c.stone_i, wrench_of(arm[0], f), -1, 1, column);
  return column;
}

}  // namespace

/// Balance of every stone, rows in units of the largest load: forces of contacts and supports + factor x raised loads
/// = - fixed loads.
/// @param share_of_joints  of dry straight joints, about their middle, that may bear
/// @param sliding  friction with hardly any slope beside a bound on shear that the caller sets
/// @param most  at which the forces of joints end, times the largest load
LimitAnalysis::Programme LimitAnalysis::programme(double share_of_joints, bool sliding, double most) const {
  Programme p;
  p.move = (1 - share_of_joints) / 2;
  for (const auto& stone : s_.stones) {
    const auto load = scaled(stone.fixed, stone.radius, unit_);
    for (const double l : load) p.lp.add_row(-l, -l);
  }
  add_forces_of_joints(p, sliding, most);
  add_forces_of_supports(p);
  add_raised_loads(p);
  return p;
}

/// Forces of a law are its apex and what is added along its generators: apexes are loads, generators columns.
void LimitAnalysis::add_forces_of_joints(Programme& p, bool sliding, double most) const {
  std::vector<double> apex(3 * s_.stones.size(), 0.0);
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    const auto& c = s_.contacts[static_cast<std::size_t>(kept_[k])];
    std::array<Vector<2>, 2> arm{c.arm_i, c.arm_j};
    if (partner_[k] >= 0) {
      const auto& other = s_.contacts[static_cast<std::size_t>(partner_[k])];
      arm = {c.arm_i + p.move * (other.arm_i - c.arm_i), c.arm_j + p.move * (other.arm_j - c.arm_j)};
    }
    auto law = c.law;
    const bool slides = sliding && law.friction > 0 && std::isfinite(law.friction) && dry(law);
    if (slides) law = {LimitAnalysisParameters::slope_left * law.friction, 1, 0};
    p.forces.push_back(admissible_forces(law));
    p.arm.push_back(arm);
    p.first_column.push_back(p.lp.columns());
    for (const auto& g : p.forces.back().generators)
      p.lp.add_column(column_of(s_, c, arm, g.direction), std::max(g.lower / unit_, -most),
                      std::min(g.upper / unit_, most), 0);
    for (const auto& e : column_of(s_, c, arm, p.forces.back().apex))
      apex[static_cast<std::size_t>(e.row)] += e.value / unit_;
  }
  for (std::size_t row = 0; row < apex.size(); ++row) {
    if (apex[row] == 0) continue;
    const auto& stone = s_.stones[row / 3];
    const double b = -scaled(stone.fixed, stone.radius, unit_)[row % 3] - apex[row];
    p.lp.set_row(static_cast<int>(row), b, b);
  }
}

/// In directions at right angles: what one holds of a stone no other holds again.
void LimitAnalysis::add_forces_of_supports(Programme& p) const {
  p.held_column = p.lp.columns();
  std::vector<std::vector<Wrench>> of_stone(s_.stones.size());
  for (const auto& support : s_.supports) {
    auto& basis = of_stone[static_cast<std::size_t>(support.stone)];
    const double radius = s_.stones[static_cast<std::size_t>(support.stone)].radius;
    auto w = scaled(wrench_of(support.arm, support.direction), radius, 1);
    for (const auto& b : basis) {
      const double share = power(b, w);
      for (std::size_t c = 0; c < 3; ++c) w[c] -= share * b[c];
    }
    const double left = std::sqrt(power(w, w));
    if (left < LimitAnalysisParameters::straight) continue;
    for (auto& x : w) x /= left;
    basis.push_back(w);
    Column column;
    for (int c = 0; c < 3; ++c) column.push_back({3 * support.stone + c, w[static_cast<std::size_t>(c)]});
    p.lp.add_column(column, -endless, endless, 0);
    p.held.push_back({support.stone, support.name, w});
  }
}

void LimitAnalysis::add_raised_loads(Programme& p) const {
  Column raised;
  for (std::size_t b = 0; b < s_.stones.size(); ++b)
    add_wrench(s_, static_cast<int>(b), s_.stones[b].raised, 1, raised_unit_, raised);
  p.factor_column = p.lp.add_column(raised, 0, 0, 0);
}

}  // namespace voussoir

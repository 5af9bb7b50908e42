#include "statics/limit_programme.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/orthogonal.hpp"

namespace voussoir {
namespace {

using Column = std::vector<ProgrammeEntry>;

/// Adds a wrench on a stone to a column, in the rows of its balance.
template <int dim>
void add_wrench(const RigidStructure<dim>& s, int stone, const Wrench<dim>& wrench, double sign, double unit,
                Column& column) {
  const int n = freedoms<dim>;
  const auto w = scaled(wrench, s.stones[static_cast<std::size_t>(stone)].radius, unit);
  for (int c = 0; c < n; ++c) column.push_back({n * stone + c, sign * w[static_cast<std::size_t>(c)]});
}

/// A force of a contact along a direction of its axes, on both stones.
template <int dim>
Column column_of(const RigidStructure<dim>& s, const RigidContact<dim>& c, const std::array<Vector<dim>, 2>& arm,
                 const Vector<dim>& direction) {
  const auto f = off_axes(c, direction);
  Column column;
  add_wrench(s, c.stone_j, wrench_of(arm[1], f), 1, 1, column);
  add_wrench(s, c.stone_i, wrench_of(arm[0], f), -1, 1, column);
  return column;
}

}  // namespace

/// Balance of every stone, rows in units of the largest load: forces of contacts and supports + factor x raised loads
/// = - fixed loads.
template <int dim>
typename LimitAnalysis<dim>::Programme LimitAnalysis<dim>::programme(const Terms& terms) const {
  Programme p;
  p.share_moved = 1 - terms.share_of_joints;
  p.pyramid = terms.pyramid;
  p.finer = terms.finer;
  p.off_the_cone = terms.off_the_cone;
  p.most_for_finer = terms.most_for_finer;
  p.most = terms.most;
  for (const auto& stone : s_.stones) {
    const auto load = scaled(stone.fixed, stone.radius, unit_);
    for (const double l : load) p.lp.add_row(-l, -l);
  }
  add_forces_of_joints(p, terms);
  add_forces_of_supports(p);
  add_raised_loads(p);
  if (terms.lines)
    for (const auto& [k, line] : *terms.lines) add_line(p, k, line);
  return p;
}

template <int dim>
void LimitAnalysis<dim>::add_generator(Programme& p, std::size_t k, const Generator<dim>& g) const {
  const auto& c = s_.contacts[static_cast<std::size_t>(corners_.kept[k])];
  p.columns[k].push_back(p.lp.add_column(column_of(s_, c, p.arm[k], g.direction), std::max(g.lower / unit_, -p.most),
                                         std::min(g.upper / unit_, p.most), 0));
}

/// A line of a cone, beside those that its pyramid began with.
template <int dim>
void LimitAnalysis<dim>::add_line(Programme& p, std::size_t k, const Generator<dim>& line) const {
  p.forces[k].generators.push_back(line);
  p.added.emplace_back(k, line);
  add_generator(p, k, line);
}

/// Forces of a law are its apex and what is added along its generators: apexes are loads, generators columns.
template <int dim>
void LimitAnalysis<dim>::add_forces_of_joints(Programme& p, const Terms& terms) const {
  const std::size_t n = freedoms<dim>;
  std::vector<double> apex(n * s_.stones.size(), 0.0);
  for (std::size_t k = 0; k < corners_.kept.size(); ++k) {
    const auto& c = s_.contacts[static_cast<std::size_t>(corners_.kept[k])];
    std::array<Vector<dim>, 2> arm{c.arm_i, c.arm_j};
    const double share = p.share_moved / corners_.count[k];
    for (int q = corners_.first[k]; q < corners_.first[k] + corners_.count[k]; ++q) {
      if (q == static_cast<int>(k)) continue;
      const auto& other = s_.contacts[static_cast<std::size_t>(corners_.kept[static_cast<std::size_t>(q)])];
      arm = {arm[0] + share * (other.arm_i - c.arm_i), arm[1] + share * (other.arm_j - c.arm_j)};
    }
    auto law = c.law;
    const bool slides = terms.sliding && law.friction > 0 && std::isfinite(law.friction) && dry(law);
    if (slides) law = {LimitAnalysisParameters::slope_left * law.friction, 1, 0};
    p.forces.push_back(admissible_forces<dim>(law, terms.pyramid));
    p.arm.push_back(arm);
    p.columns.emplace_back();
    for (const auto& g : p.forces.back().generators) add_generator(p, k, g);
    for (const auto& e : column_of(s_, c, arm, p.forces.back().apex))
      apex[static_cast<std::size_t>(e.row)] += e.value / unit_;
  }
  for (std::size_t row = 0; row < apex.size(); ++row) {
    if (apex[row] == 0) continue;
    const auto& stone = s_.stones[row / n];
    const double b = -scaled(stone.fixed, stone.radius, unit_)[row % n] - apex[row];
    p.lp.set_row(static_cast<int>(row), b, b);
  }
}

/// In directions at right angles: what one holds of a stone no other holds again, whatever support it belongs to.
template <int dim>
void LimitAnalysis<dim>::add_forces_of_supports(Programme& p) const {
  const int n = freedoms<dim>;
  p.held_column = p.lp.columns();
  std::vector<std::vector<Wrench<dim>>> of_stone(s_.stones.size());
  for (const auto& support : s_.supports) {
    auto& basis = of_stone[static_cast<std::size_t>(support.stone)];
    const double radius = s_.stones[static_cast<std::size_t>(support.stone)].radius;
    auto w = scaled(wrench_of(support.arm, support.direction), radius, 1);
    take_off(
        basis, [](const Wrench<dim>& a, const Wrench<dim>& b) { return dot(a, b); }, w);
    const double left = std::sqrt(dot(w, w));
    if (left < LimitAnalysisParameters::straight) continue;
    for (auto& x : w) x /= left;
    basis.push_back(w);
    Column column;
    for (int c = 0; c < n; ++c) column.push_back({n * support.stone + c, w[static_cast<std::size_t>(c)]});
    p.lp.add_column(column, -endless, endless, 0);
    p.held.push_back({support.stone, w});
  }
}

template <int dim>
void LimitAnalysis<dim>::add_raised_loads(Programme& p) const {
  Column raised;
  for (std::size_t b = 0; b < s_.stones.size(); ++b)
    add_wrench(s_, static_cast<int>(b), s_.stones[b].raised, 1, raised_unit_, raised);
  p.factor_column = p.lp.add_column(raised, 0, 0, 0);
}

template LimitAnalysis<2>::Programme LimitAnalysis<2>::programme(const Terms&) const;
template LimitAnalysis<3>::Programme LimitAnalysis<3>::programme(const Terms&) const;
template void LimitAnalysis<2>::add_line(Programme&, std::size_t, const Generator<2>&) const;
template void LimitAnalysis<3>::add_line(Programme&, std::size_t, const Generator<3>&) const;
template void LimitAnalysis<2>::add_generator(Programme&, std::size_t, const Generator<2>&) const;
template void LimitAnalysis<3>::add_generator(Programme&, std::size_t, const Generator<3>&) const;

}  // namespace voussoir

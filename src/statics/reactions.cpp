// The ends of reactions of supports over all forces that balance loads.
//
// What holds a stone is found by balance, whatever its supports are called. Of the wrench w that holds it a support
// bears g . w along an axis, with g . w the component of w for what this support alone holds, and 0 for what the others
// hold. Where both hold the same they can press against each other as much as one likes: there is no such g.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "base/orthogonal.hpp"
#include "statics/limit_analysis_parameters.hpp"
#include "statics/limit_programme.hpp"

namespace voussoir {
namespace {

using Numbers = LimitAnalysisParameters;

template <int dim>
using Wrenches = std::vector<Wrench<dim>>;  // moments over the radius of a stone

/// What each support holds of a stone, by name: orthonormal. Those of stones that are not there yet have no name.
template <int dim>
using HeldByName = std::map<int, Wrenches<dim>>;

template <int dim>
std::size_t largest_of(const Wrenches<dim>& all) {
  const auto smaller = [](const Wrench<dim>& a, const Wrench<dim>& b) { return dot(a, a) < dot(b, b); };
  return static_cast<std::size_t>(std::max_element(all.begin(), all.end(), smaller) - all.begin());
}

template <int dim>
void take_off_one(const Wrench<dim>& unit, Wrench<dim>& w) {
  take_off(
      Wrenches<dim>{unit}, [](const Wrench<dim>& a, const Wrench<dim>& b) { return dot(a, b); }, w);
}

/// Orthonormal wrenches that make up all of some, the largest first.
template <int dim>
Wrenches<dim> basis_of(Wrenches<dim> all) {
  Wrenches<dim> basis;
  while (!all.empty()) {
    auto unit = all[largest_of<dim>(all)];
    const double size = std::sqrt(dot(unit, unit));
    if (size < Numbers::holds_nothing) break;
    for (auto& x : unit) x /= size;
    for (auto& w : all) take_off_one<dim>(unit, w);
    basis.push_back(unit);
  }
  return basis;
}

/// What one support bears along an axis of a wrench that it and others hold; nothing where it has no end.
/// @param mine, others  orthonormal
template <int dim>
std::optional<Wrench<dim>> borne_along(std::size_t axis, const Wrenches<dim>& mine, const Wrenches<dim>& others) {
  Wrench<dim> borne{};
  if (others.empty()) {
    borne[axis] = mine.empty() ? 0.0 : 1.0;
    return borne;
  }
  auto left = mine;  // beside what the others hold, and along the axis what the wrenches left are to be told as
  std::vector<double> along;
  for (auto& w : left) {
    along.push_back(w[axis]);
    for (const auto& other : others) take_off_one<dim>(other, w);
  }
  while (!left.empty()) {
    const auto best = largest_of<dim>(left);
    auto unit = left[best];
    const double size = std::sqrt(dot(unit, unit));
    if (size < Numbers::holds_nothing) break;
    for (auto& x : unit) x /= size;
    const double of_unit = along[best] / size;
    for (std::size_t k = 0; k < left.size(); ++k) {
      along[k] -= of_unit * dot(unit, left[k]);
      take_off_one<dim>(unit, left[k]);
    }
    left.erase(left.begin() + static_cast<long>(best));
    along.erase(along.begin() + static_cast<long>(best));
    borne = borne + of_unit * unit;
  }
  for (const double beyond : along)
    if (std::abs(beyond) > Numbers::holds_nothing) return {};
  return borne;
}

template <int dim>
std::vector<HeldByName<dim>> held_by_name(const RigidStructure<dim>& s) {
  std::vector<HeldByName<dim>> of_stone(s.stones.size());
  for (const auto* list : {&s.supports, &s.held_again})
    for (const auto& support : *list) {
      const auto stone = static_cast<std::size_t>(support.stone);
      const auto w = scaled(wrench_of(support.arm, support.direction), s.stones[stone].radius, 1);
      of_stone[stone][support.name].push_back(w);
    }
  for (auto& names : of_stone)
    for (auto& [name, held] : names) held = basis_of<dim>(std::move(held));
  return of_stone;
}

/// What a support bears along an axis, of the wrench that holds each stone; nothing where it has no end.
template <int dim>
std::optional<Wrenches<dim>> borne_of_stones(const std::vector<HeldByName<dim>>& of_stone, int support,
                                             std::size_t axis) {
  Wrenches<dim> borne(of_stone.size());
  for (std::size_t b = 0; b < of_stone.size(); ++b) {
    const auto mine = of_stone[b].find(support);
    if (mine == of_stone[b].end() || of_stone[b].begin()->first < 0) continue;
    Wrenches<dim> others;
    for (const auto& [name, held] : of_stone[b])
      if (name != support) others.insert(others.end(), held.begin(), held.end());
    const auto one = borne_along<dim>(axis, mine->second, basis_of<dim>(std::move(others)));
    if (!one) return {};
    borne[b] = *one;
  }
  return borne;
}

}  // namespace

/// Forces that balance loads are found first, without a cost and without an end, which costs the simplex method several
/// times as much; from them it goes from one extreme to the next, which takes it a tenth of what each alone does.
template <int dim>
std::vector<std::array<ReactionRange, dim>> LimitAnalysis<dim>::reactions(int supports, double factor,
                                                                          const LimitAnswer<dim>& borne) const {
  VOUSSOIR_EXPECT(supports >= 0 && "supports: a count");
  std::vector<std::array<ReactionRange, dim>> ranges(static_cast<std::size_t>(supports));
  auto p = programme({1, endless, Pyramid::around, false});
  const double f = factor * raised_unit_ / unit_;
  p.lp.set_column(p.factor_column, f, f);
  if (!borne.basis.empty()) {
    auto basis = borne.basis;
    rest_at_lower_bound(basis, p.factor_column);
    p.lp.start_from(std::move(basis));
  }
  p.lp.maximise();
  for (std::size_t k = 0; k < p.forces.size(); ++k)
    for (std::size_t g = 0; g < p.forces[k].generators.size(); ++g) {
      const auto& of = p.forces[k].generators[g];
      p.lp.set_column(p.columns[k][g], std::max(of.lower / unit_, -Numbers::most_force),
                      std::min(of.upper / unit_, Numbers::most_force));
    }
  if (p.lp.maximise().end != ProgrammeEnd::optimal) return ranges;
  const auto of_stone = held_by_name(s_);
  for (int support = 0; support < supports; ++support)
    for (std::size_t c = 0; c < dim; ++c)
      if (const auto of_wrench = borne_of_stones<dim>(of_stone, support, c))
        ranges[static_cast<std::size_t>(support)][c] = ends_of(p, *of_wrench);
  return ranges;
}

/// The ends of a sum of what is borne of the wrenches that hold stones.
template <int dim>
ReactionRange LimitAnalysis<dim>::ends_of(Programme& p, const std::vector<Wrench<dim>>& borne) const {
  ReactionRange range;
  for (const double sign : {1.0, -1.0}) {
    bool held = false;
    for (std::size_t k = 0; k < p.held.size(); ++k) {
      const double share = dot(p.held[k].direction, borne[static_cast<std::size_t>(p.held[k].stone)]);
      p.lp.set_cost(p.held_column + static_cast<int>(k), sign * share);
      held = held || std::abs(share) > Numbers::straight;
    }
    auto& end = sign > 0 ? range.most : range.least;
    if (!held) {
      end = 0;
      continue;
    }
    const auto found = p.lp.maximise();
    const double force = std::abs(found.value) > Numbers::out_of_balance ? sign * found.value * unit_ : 0.0;
    if (found.end == ProgrammeEnd::optimal && found.value < Numbers::endless_reaction) end = force;
  }
  return range;
}

template std::vector<std::array<ReactionRange, 2>> LimitAnalysis<2>::reactions(int, double,
                                                                               const LimitAnswer<2>&) const;
template std::vector<std::array<ReactionRange, 3>> LimitAnalysis<3>::reactions(int, double,
                                                                               const LimitAnswer<3>&) const;

}  // namespace voussoir

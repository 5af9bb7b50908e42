// Which of all forces that balance given loads are told: the most balanced ones.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "statics/limit_analysis_parameters.hpp"
#include "statics/limit_programme.hpp"

namespace voussoir {
namespace {

using Numbers = LimitAnalysisParameters;

// The least share of joints that is looked for, to which it is bisected in the plane.
constexpr double finest = 1 - Numbers::largest_free_share;

/// Goes from a share that is borne to the least one, but for what is told.
/// @param is_borne  whether a share is
template <class Ask>
double least_share(double borne, double told, const Ask& is_borne) {
  for (double falls = finest; borne - falls > told;) {
    const double share = (borne + falls) / 2;
    (is_borne(share) ? borne : falls) = share;
  }
  return borne;
}

}  // namespace

/// Whether loads that are raised from nothing are borne by a share of joints.
/// @param most_for_finer  iterations that it may cost to make pyramids finer; none: they are not
/// @param lines           of other shares, which serve this one too
/// @param basis           to begin from, of another share
template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::borne_on_share(double share, int most_for_finer, Lines& lines,
                                                    ProgrammeBasis& basis) const {
  bool balanced = true;
  Terms terms;
  terms.share_of_joints = share, terms.pyramid = Pyramid::within, terms.lines = &lines;
  terms.finer = most_for_finer > 0, terms.most_for_finer = most_for_finer;
  terms.off_the_cone = RoundConeParameters::off_the_cone_at_last;
  return raised_up_to(1, terms, &balanced, &basis);
}

/// Shares are asked of pyramids as they are; in space the next one is asked of finer ones at last, which may cost as
/// much again as the first solution, and the lines found there serve all shares.
template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::most_balanced(double factor, double* free_share) const {
  const auto loaded = under_loads(factor);
  ProgrammeBasis basis;  // shares that are near each other have bases that are
  Lines lines;
  // Walls that carry in many ways bear on the middle of their joints alone: that is asked first.
  auto best = loaded.borne_on_share(finest, 0, lines, basis);
  const int at_first = best.iterations;
  double stands = best.verdict == LimitVerdict::unlimited ? finest : 1;
  if (stands == 1) best = loaded.borne_on_share(1, std::numeric_limits<int>::max(), lines, basis);
  const auto is_borne = [&](double share, int most_for_finer) {
    auto answer = loaded.borne_on_share(share, most_for_finer, lines, basis);
    const bool borne = answer.verdict == LimitVerdict::unlimited;
    if (borne) best = std::move(answer);
    return borne;
  };
  const double told = dim == 2 ? finest : RoundConeParameters::share_told;
  for (bool more = stands == 1 && best.verdict == LimitVerdict::unlimited; more;) {
    stands = least_share(stands, told, [&](double share) { return is_borne(share, 0); });
    more = dim == 3 && stands - told > finest && is_borne(stands - told, at_first);
    if (more) stands -= told;
  }
  if (free_share) *free_share = 1 - stands;
  if (best.verdict != LimitVerdict::unlimited) return best;
  auto least = loaded.least_of_joints(stands, basis, &lines);
  if (least.verdict != LimitVerdict::unlimited) least = loaded.least_of_joints(stands, {}, &lines);
  return least.verdict == LimitVerdict::unlimited ? least : best;
}

template <int dim>
bool LimitAnalysis<dim>::is_rows() const {
  const auto count = s_.stones.size();
  std::vector<std::set<int>> neighbours(count);
  for (const auto& c : s_.contacts) {
    neighbours[static_cast<std::size_t>(c.stone_i)].insert(c.stone_j);
    neighbours[static_cast<std::size_t>(c.stone_j)].insert(c.stone_i);
  }
  std::vector<std::size_t> most(count, 2);
  for (const auto& h : s_.supports) most[static_cast<std::size_t>(h.stone)] = 1;
  for (std::size_t b = 0; b < count; ++b)
    if (neighbours[b].size() > most[b]) return false;
  // Rows have ends: what is left when they are taken away one after the other are rings that close.
  std::vector<int> ends;
  for (std::size_t b = 0; b < count; ++b)
    if (neighbours[b].size() < 2) ends.push_back(static_cast<int>(b));
  std::size_t taken = 0;
  for (std::vector<char> gone(count, 0); !ends.empty();) {
    const int end = ends.back();
    ends.pop_back();
    if (std::exchange(gone[static_cast<std::size_t>(end)], 1)) continue;
    ++taken;
    for (const int next : neighbours[static_cast<std::size_t>(end)])
      if (neighbours[static_cast<std::size_t>(next)].erase(end) > 0) ends.push_back(next);
  }
  return taken == count && std::count(corners_.count.begin(), corners_.count.end(), 1) == 0;
}

/// Forces that balance all raised loads with the least sum of normal forces: where stones hold each other in many ways,
/// any force can be added to others.
template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::least_of_joints(double share_of_joints, const ProgrammeBasis& basis,
                                                     Lines* lines) const {
  Terms terms;
  terms.share_of_joints = share_of_joints, terms.pyramid = Pyramid::within, terms.lines = lines;
  auto p = programme(terms);
  const double all = raised_unit_ / unit_;
  p.lp.set_column(p.factor_column, all, all);
  seek_least(p);
  p.lp.start_from(basis);
  return judge(p, p.lp.maximise(), 1);
}

template <int dim>
void LimitAnalysis<dim>::seek_least(Programme& p) const {
  p.lp.set_cost(p.factor_column, 0);
  for (std::size_t k = 0; k < p.forces.size(); ++k)
    for (std::size_t g = 0; g < p.forces[k].generators.size(); ++g)
      p.lp.set_cost(p.columns[k][g], -p.forces[k].generators[g].direction[0]);
}

/// By the pyramids that have been made finer for the limit: those at the start may not bear as much.
template <int dim>
void LimitAnalysis<dim>::tell_least(Programme& p, LimitAnswer<dim>& answer) const {
  const double below = answer.factor * (1 - Numbers::no_motion), factor = below * raised_unit_ / unit_;
  p.lp.set_column(p.factor_column, factor, factor);
  seek_least(p);
  const auto least = judge(p, p.lp.maximise(), below);
  if (least.verdict == LimitVerdict::unlimited) answer.force = least.force;
}

template LimitAnswer<2> LimitAnalysis<2>::most_balanced(double, double*) const;
template LimitAnswer<3> LimitAnalysis<3>::most_balanced(double, double*) const;
template LimitAnswer<2> LimitAnalysis<2>::least_of_joints(double, const ProgrammeBasis&, Lines*) const;
template LimitAnswer<3> LimitAnalysis<3>::least_of_joints(double, const ProgrammeBasis&, Lines*) const;
template void LimitAnalysis<2>::seek_least(Programme&) const;
template void LimitAnalysis<3>::seek_least(Programme&) const;
template void LimitAnalysis<2>::tell_least(Programme&, LimitAnswer<2>&) const;
template void LimitAnalysis<3>::tell_least(Programme&, LimitAnswer<3>&) const;
template bool LimitAnalysis<2>::is_rows() const;
template bool LimitAnalysis<3>::is_rows() const;

}  // namespace voussoir

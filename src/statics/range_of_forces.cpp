// Which of all forces that balance given loads are told: the most balanced ones.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "statics/limit_analysis_parameters.hpp"
#include "statics/limit_programme.hpp"

namespace voussoir {
namespace {

using Numbers = LimitAnalysisParameters;

// The least share of joints that is looked for, to which it is bisected in the plane.
constexpr double finest = 1 - Numbers::largest_free_share;

}  // namespace

/// The same structure under loads that given forces balance when those of every joint are drawn together about their
/// mean; what is raised makes them the loads it has. Of loads raised from nothing too small a share bears none, and all
/// columns stay at rest: the simplex method gropes there, for minutes on walls of a hundred stones. Here it begins with
/// forces that balance, and ends where part of the way is borne.
template <int dim>
LimitAnalysis<dim> LimitAnalysis<dim>::drawn_together(const std::vector<Vector<dim>>& force, double ratio) const {
  auto s = s_;
  std::vector<Wrench<dim>> taken(s.stones.size());
  for (std::size_t k = 0; k < corners_.kept.size(); ++k) {
    if (!corners_.is_corner(k)) continue;
    Vector<dim> mean{};
    for (int q = corners_.first[k]; q < corners_.first[k] + corners_.count[k]; ++q)
      mean =
          mean + 1.0 / corners_.count[k] * force[static_cast<std::size_t>(corners_.kept[static_cast<std::size_t>(q)])];
    const auto at = static_cast<std::size_t>(corners_.kept[k]);
    const auto& c = s.contacts[at];
    const auto off = off_axes(c, (1 - ratio) * (force[at] - mean));
    auto &of_i = taken[static_cast<std::size_t>(c.stone_i)], &of_j = taken[static_cast<std::size_t>(c.stone_j)];
    of_i = of_i - wrench_of(c.arm_i, off);
    of_j = of_j + wrench_of(c.arm_j, off);
  }
  double most = 0;
  for (std::size_t b = 0; b < taken.size(); ++b) most = std::max(most, size_of(taken[b], s.stones[b].radius));
  const bool nothing = most <= Numbers::out_of_balance * unit_;
  for (std::size_t b = 0; b < taken.size(); ++b) {
    auto& stone = s.stones[b];
    stone.fixed = stone.fixed + stone.raised;
    stone.raised = {};
    if (nothing) continue;
    stone.fixed = stone.fixed + taken[b];
    stone.raised = -1.0 * taken[b];
  }
  return LimitAnalysis(std::move(s));
}

/// Whether loads are borne by a share of joints.
/// @param most_for_finer  iterations that it may cost to make pyramids finer; none: they are not
/// @param lines           of other shares, which serve this one too
/// @param basis           to begin from, of another share
template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::borne_on_share(double share, int most_for_finer, Lines& lines,
                                                    const ProgrammeBasis& basis) const {
  bool balanced = true;
  Terms terms;
  terms.share_of_joints = share, terms.pyramid = Pyramid::within, terms.lines = &lines;
  terms.finer = most_for_finer > 0, terms.most_for_finer = most_for_finer;
  terms.off_the_cone = RoundConeParameters::off_the_cone_at_last;
  auto begin = basis;
  return raised_up_to(1, terms, &balanced, &begin);
}

/// The least share of joints that bears loads, and forces that do.
template <int dim>
struct LimitAnalysis<dim>::Narrowing {
  const LimitAnalysis& loaded;
  double told;  ///< [-] of joints, to which the share is looked for
  Lines lines = {};
  LimitAnswer<dim> best = {}, refused = {};  ///< of the least share that is borne, and of the largest that is not
  double stands = 1, falls = finest;         ///< these shares
  std::optional<LimitAnalysis> eased = {};   ///< what refused is an answer of

  /// Forces that are borne on the least share so far, drawn together, balance what they do: from there loads are
  /// raised, and the programme begins inside of its bounds.
  bool ask(double share) {
    auto from = loaded.drawn_together(best.force, share / stands);
    auto answer = from.borne_on_share(share, 0, lines, best.basis);
    if (answer.verdict == LimitVerdict::unlimited) {
      best = std::move(answer), stands = share;
      return true;
    }
    refused = std::move(answer), falls = share;
    eased.emplace(std::move(from));
    return false;
  }

  void bisect() {
    while (stands - falls > told) ask((stands + falls) / 2);
  }

  /// Whether the share that is not borne is by finer pyramids; the programme goes on where it ended.
  bool ask_finer(int most_for_finer) {
    if (!eased) return false;
    auto answer = eased->borne_on_share(falls, most_for_finer, lines, refused.basis);
    if (answer.verdict != LimitVerdict::unlimited) return false;
    best = std::move(answer), stands = falls, falls = finest;
    eased.reset();
    return true;
  }
};

/// Shares are asked of pyramids as they are; in space the largest that is not borne is asked of finer ones at last,
/// which may cost as much again as the first solution, and the lines found there serve all shares.
template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::most_balanced(double factor, double* free_share,
                                                   const LimitAnswer<dim>& borne) const {
  const auto loaded = under_loads(factor);
  Narrowing in{loaded, dim == 2 ? finest : RoundConeParameters::share_told};
  in.best = loaded.borne_on_share(1, std::numeric_limits<int>::max(), in.lines, borne.basis);
  const int at_first = std::max(borne.iterations, in.best.iterations);
  const bool stands = in.best.verdict == LimitVerdict::unlimited;
  for (bool more = stands; more; more = dim == 3 && in.ask_finer(at_first)) in.bisect();
  if (stands && !in.eased && in.stands > finest) in.ask(finest);
  if (free_share) *free_share = 1 - in.stands;
  if (!stands) return in.best;
  auto least = loaded.least_of_joints(in.stands, in.best.basis, &in.lines);
  if (least.verdict != LimitVerdict::unlimited) least = loaded.least_of_joints(in.stands, {}, &in.lines);
  return least.verdict == LimitVerdict::unlimited ? least : in.best;
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

template LimitAnswer<2> LimitAnalysis<2>::most_balanced(double, double*, const LimitAnswer<2>&) const;
template LimitAnswer<3> LimitAnalysis<3>::most_balanced(double, double*, const LimitAnswer<3>&) const;
template LimitAnswer<2> LimitAnalysis<2>::least_of_joints(double, const ProgrammeBasis&, Lines*) const;
template LimitAnswer<3> LimitAnalysis<3>::least_of_joints(double, const ProgrammeBasis&, Lines*) const;
template void LimitAnalysis<2>::seek_least(Programme&) const;
template void LimitAnalysis<3>::seek_least(Programme&) const;
template void LimitAnalysis<2>::tell_least(Programme&, LimitAnswer<2>&) const;
template void LimitAnalysis<3>::tell_least(Programme&, LimitAnswer<3>&) const;
template bool LimitAnalysis<2>::is_rows() const;
template bool LimitAnalysis<3>::is_rows() const;

}  // namespace voussoir

// Pyramids are made finer where they stand for a round cone too coarsely: those around it where a force lies between
// it and them, those within it where a motion presses into it that does not press into them.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "statics/limit_analysis_parameters.hpp"
#include "statics/limit_programme.hpp"

namespace voussoir {
namespace {

using Numbers = LimitAnalysisParameters;

}  // namespace

/// Solves a programme for the largest factor again and again, from where it was, with finer pyramids.
/// @param basis  after the first time, for another programme
/// @param borne  a factor for which forces within the cones balance, where one is known
template <int dim>
ProgrammeSolution LimitAnalysis<dim>::solve(Programme& p, double largest, ProgrammeBasis& basis,
                                            std::optional<double> borne) const {
  auto found = p.lp.maximise();
  basis = p.lp.basis();
  if (dim == 2 || !p.finer) return found;
  const int at_first = found.iterations;
  int for_nothing = 0;
  for (int round = 0; round < RoundConeParameters::most_rounds && found.end == ProgrammeEnd::optimal; ++round) {
    if (found.iterations - at_first > p.most_for_finer || !make_finer(p, found)) break;
    const auto before = found;
    // Cut pyramids leave prices as they may be and take forces away, added lines do the opposite.
    found = p.pyramid == Pyramid::around ? p.lp.maximise_from_prices() : p.lp.maximise();
    found.iterations += before.iterations;
    if (p.pyramid == Pyramid::within || found.end != ProgrammeEnd::optimal) continue;
    // A round that changes nothing says nothing: where a face is cut forces go to another of the same worth. Whether
    // forces within the cones are among them is asked once such rounds have cost as much as the first solution.
    if (found.value >= before.value * (1 - RoundConeParameters::nothing_left))
      for_nothing += found.iterations - before.iterations;
    if (!borne && for_nothing > at_first) {
      const auto found_within = largest_borne(largest);
      borne = found_within.verdict == LimitVerdict::unknown ? 0.0 : found_within.factor;
    }
    if (borne && found.value * unit_ / raised_unit_ <= *borne * (1 + RoundConeParameters::nothing_left)) break;
  }
  return found;
}

/// In space what pyramids around cones bear is proven of none within them: forces are looked for there, and where there
/// are none pyramids around cones are made as fine as these.
template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::with_forces(double largest, LimitAnswer<dim> answer) const {
  if (dim == 2 || answer.verdict != LimitVerdict::unlimited) return answer;
  bool balanced = true;
  Terms terms;
  terms.off_the_cone = RoundConeParameters::off_the_cone_at_last;
  terms.pyramid = Pyramid::within;
  auto found = raised_up_to(largest, terms, &balanced);
  if (found.verdict == LimitVerdict::unlimited) return found;
  terms.pyramid = Pyramid::around;
  terms.borne = found.factor;
  auto refused = raised_up_to(largest, terms, &balanced);
  if (refused.verdict == LimitVerdict::limited) return refused;
  found.verdict = LimitVerdict::unknown;
  return found;
}

/// Whether any was.
template <int dim>
bool LimitAnalysis<dim>::make_finer(Programme& p, const ProgrammeSolution& found) const {
  bool finer = false;
  const auto motion = p.pyramid == Pyramid::within ? motion_of(found.price) : std::vector<Wrench<dim>>{};
  if (p.pyramid == Pyramid::within && motion.empty()) return false;
  for (std::size_t k = 0; k < corners_.kept.size(); ++k) {
    if (!has_cone(s_.contacts[static_cast<std::size_t>(corners_.kept[k])].law)) continue;
    finer = (p.pyramid == Pyramid::around ? cut_pyramid(p, k, found.x) : extend_pyramid(p, k, motion)) || finer;
  }
  return finer;
}

/// Whether there is an edge clearly between whose faces the direction is.
template <>
bool LimitAnalysis<3>::cut_edge(Programme& p, std::size_t k, double angle) const {
  const double apart = RoundConeParameters::side * p.off_the_cone;
  auto& generators = p.forces[k].generators;
  for (std::size_t g = 0; g < generators.size(); ++g) {
    const double from = generators[g].from, to = generators[g].to;
    if (generators[g].upper == 0 || !(from + apart < angle && angle < to - apart)) continue;
    generators[g].upper = 0;
    p.lp.set_column(p.columns[k][g], 0, 0);
    const double slope = s_.contacts[static_cast<std::size_t>(corners_.kept[k])].law.friction;
    for (const auto& edge : {edge_between(slope, from, angle), edge_between(slope, angle, to)}) {
      generators.push_back(edge);
      add_generator(p, k, edge);
    }
    return true;
  }
  return false;
}

/// A face that touches the cone where the force lies takes away the edge beyond which that is; at all corners of the
/// joint, or the force would go to the edge of another.
template <>
bool LimitAnalysis<3>::cut_pyramid(Programme& p, std::size_t k, const std::vector<double>& x) const {
  const double slope = s_.contacts[static_cast<std::size_t>(corners_.kept[k])].law.friction;
  const auto& generators = p.forces[k].generators;
  Vector<3> force{};
  for (std::size_t g = 0; g < generators.size(); ++g) {
    const auto column = static_cast<std::size_t>(p.columns[k][g]);
    const bool is_new = column >= x.size();  // of a cut that another corner of this joint has made since
    if (generators[g].to > generators[g].from && !is_new) force = force + x[column] * generators[g].direction;
  }
  const double shear = length(tangential(force));
  const double borne = (1 + p.off_the_cone) * slope * force[0];
  if (shear <= Numbers::tolerance || shear <= borne) return false;
  const double angle = std::atan2(force[2], force[1]);
  bool cut = false;
  for (int q = corners_.first[k]; q < corners_.first[k] + corners_.count[k]; ++q)
    cut = cut_edge(p, static_cast<std::size_t>(q), angle < 0 ? angle + 2 * RoundConeParameters::pi : angle) || cut;
  return cut;
}

/// The line of the cone that the motion presses most.
template <>
bool LimitAnalysis<3>::extend_pyramid(Programme& p, std::size_t k, const std::vector<Wrench<3>>& motion) const {
  const auto& c = s_.contacts[static_cast<std::size_t>(corners_.kept[k])];
  const auto moved = [&](int stone, int side) {
    return velocity_at(motion[static_cast<std::size_t>(stone)], p.arm[k][static_cast<std::size_t>(side)]);
  };
  const auto v = on_axes(c, moved(c.stone_j, 1) - moved(c.stone_i, 0));
  const double slip = length(tangential(v)), slope = c.law.friction, presses = slope * slip - v[0];
  if (slip <= Numbers::no_motion || presses <= p.off_the_cone * slope * slip || presses <= Numbers::against_the_law)
    return false;
  add_line(p, k, line_on_cone(slope, std::atan2(-v[2], -v[1])));
  return true;
}

template <>
bool LimitAnalysis<2>::cut_pyramid(Programme&, std::size_t, const std::vector<double>&) const {
  return false;
}
template <>
bool LimitAnalysis<2>::cut_edge(Programme&, std::size_t, double) const {
  return false;
}
template <>
bool LimitAnalysis<2>::extend_pyramid(Programme&, std::size_t, const std::vector<Wrench<2>>&) const {
  return false;
}

template LimitAnswer<2> LimitAnalysis<2>::with_forces(double, LimitAnswer<2>) const;
template LimitAnswer<3> LimitAnalysis<3>::with_forces(double, LimitAnswer<3>) const;
template ProgrammeSolution LimitAnalysis<2>::solve(Programme&, double, ProgrammeBasis&, std::optional<double>) const;
template ProgrammeSolution LimitAnalysis<3>::solve(Programme&, double, ProgrammeBasis&, std::optional<double>) const;

}  // namespace voussoir

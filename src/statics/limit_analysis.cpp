#include "statics/limit_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "statics/coulomb_motion.hpp"
#include "statics/limit_analysis_parameters.hpp"
#include "statics/limit_programme.hpp"

namespace voussoir {
namespace {

using Numbers = LimitAnalysisParameters;

/// By how much stones of a motion move into each other, or what is held moves.
template <int dim>
double closes(const RigidStructure<dim>& s, const std::vector<Wrench<dim>>& motion) {
  double most = 0;
  for (const auto& c : s.contacts) most = std::max(most, -relative_velocity(c, motion)[0]);
  for (const auto& h : s.supports)
    most = std::max(most, std::abs(dot(velocity_at(motion[static_cast<std::size_t>(h.stone)], h.arm), h.direction)));
  return most;
}

/// The contract of a structure.
template <int dim>
void expect_structure(const RigidStructure<dim>& s) {
  const auto is_stone = [&](int stone) { return stone >= 0 && stone < static_cast<int>(s.stones.size()); };
  const auto is_unit = [](const Vector<dim>& v) { return std::abs(norm(v) - 1) < Numbers::straight; };
  for (const auto& stone : s.stones) VOUSSOIR_EXPECT(stone.radius > 0 && "radius of a stone: positive");
  for (const auto& c : s.contacts) {
    VOUSSOIR_EXPECT(is_stone(c.stone_i) && is_stone(c.stone_j) && "stones of a contact: of the structure");
    for (std::size_t a = 0; a < dim; ++a) {
      VOUSSOIR_EXPECT(is_unit(c.axis[a]) && "axes of a contact: of length one");
      for (std::size_t b = 0; b < a; ++b)
        VOUSSOIR_EXPECT(std::abs(dot(c.axis[a], c.axis[b])) < Numbers::straight &&
                        "axes of a contact: at right angles");
    }
  }
  for (const auto& held : s.supports) {
    VOUSSOIR_EXPECT(is_stone(held.stone) && "stone of a support: of the structure");
    VOUSSOIR_EXPECT(is_unit(held.direction) && "direction of a support: of length one");
  }
}

}  // namespace

/// Velocities of the stones as prices of a programme tell them, the largest motion 1.
template <int dim>
std::vector<Wrench<dim>> LimitAnalysis<dim>::motion_of(const std::vector<double>& price) const {
  const std::size_t n = freedoms<dim>;
  std::vector<Wrench<dim>> motion;
  double size = 0;
  for (std::size_t b = 0; b < s_.stones.size(); ++b) {
    const double r = s_.stones[b].radius;
    Wrench<dim> w;
    for (std::size_t c = 0; c < n; ++c) w[c] = c < dim ? price[n * b + c] : price[n * b + c] / r;
    size = std::max(size, reach_of(w, r));
    motion.push_back(w);
  }
  if (!(size > 0)) return {};
  for (auto& w : motion)
    for (auto& v : w) v /= size;
  return motion;
}

template <int dim>
LimitAnalysis<dim>::LimitAnalysis(RigidStructure<dim> s) : s_(std::move(s)) {
  expect_structure(s_);
  corners_ = joint_corners(s_);
  for (const auto& stone : s_.stones) {
    unit_ = std::max(unit_, size_of(stone.fixed, stone.radius));
    raised_unit_ = std::max(raised_unit_, size_of(stone.raised, stone.radius));
  }
  if (unit_ == 0) unit_ = raised_unit_ > 0 ? raised_unit_ : 1;
  if (raised_unit_ == 0) raised_unit_ = unit_;
}

/// Forces of contacts as a programme has them, and by how much they and what holds leave stones out of balance.
template <int dim>
void LimitAnalysis<dim>::tell_forces(const Programme& p, const ProgrammeSolution& found, double factor,
                                     LimitAnswer<dim>& answer) const {
  answer.force.assign(s_.contacts.size(), Vector<dim>{});
  std::vector<Wrench<dim>> left(s_.stones.size());
  for (std::size_t b = 0; b < left.size(); ++b) left[b] = s_.stones[b].fixed + factor * s_.stones[b].raised;
  const auto push = [&](int stone, const Wrench<dim>& w, double amount) {
    left[static_cast<std::size_t>(stone)] = left[static_cast<std::size_t>(stone)] + amount * w;
  };
  for (std::size_t k = 0; k < corners_.kept.size(); ++k) {
    const auto& c = s_.contacts[static_cast<std::size_t>(corners_.kept[k])];
    const auto f = p.force(k, found.x, unit_);
    const auto force = off_axes(c, f);
    // A force between the corners of its joint is told as its equivalent at these.
    const double share = p.share_moved / corners_.count[k];
    for (int q = corners_.first[k]; q < corners_.first[k] + corners_.count[k]; ++q) {
      auto& there = answer.force[static_cast<std::size_t>(corners_.kept[static_cast<std::size_t>(q)])];
      const double here = q == static_cast<int>(k) ? 1 - share * (corners_.count[k] - 1) : share;
      there = there + (corners_.is_corner(k) ? here : 1.0) * f;
    }
    push(c.stone_j, wrench_of(p.arm[k][1], force), 1);
    push(c.stone_i, wrench_of(p.arm[k][0], force), -1);
  }
  for (std::size_t k = 0; k < p.held.size(); ++k) {
    auto w = p.held[k].direction;
    for (std::size_t c = dim; c < w.size(); ++c) w[c] *= s_.stones[static_cast<std::size_t>(p.held[k].stone)].radius;
    push(p.held[k].stone, w, unit_ * found.x[static_cast<std::size_t>(p.held_column) + k]);
  }
  for (std::size_t b = 0; b < left.size(); ++b)
    answer.out_of_balance = std::max(answer.out_of_balance, size_of(left[b], s_.stones[b].radius) / unit_);
}

/// The factor that a mechanism bears by its power; none where it is no mechanism, or loads gain nothing along it.
template <int dim>
std::optional<typename LimitAnalysis<dim>::Bound> LimitAnalysis<dim>::bound_of(
    const Programme& p, const std::vector<Wrench<dim>>& mechanism) const {
  double of_fixed = 0, of_raised = 0, turned_over = 0, absorbed = 0, by_pyramids = 0, against = 0;
  for (std::size_t b = 0; b < s_.stones.size(); ++b) {
    of_fixed += dot(s_.stones[b].fixed, mechanism[b]);
    of_raised += dot(s_.stones[b].raised, mechanism[b]);
    turned_over += std::abs(dot(s_.stones[b].raised, mechanism[b]));
  }
  for (const auto& c : s_.contacts) {
    const auto most = absorbed_at_most(c.law, relative_velocity(c, mechanism));
    absorbed += most.power;
    against = std::max(against, most.against);
  }
  for (std::size_t k = 0; k < corners_.kept.size(); ++k) {
    const auto& c = s_.contacts[static_cast<std::size_t>(corners_.kept[k])];
    by_pyramids += absorbed_at_most(p.forces[k], relative_velocity(c, mechanism)).power;
  }
  for (const auto& h : s_.supports)
    against =
        std::max(against, std::abs(dot(velocity_at(mechanism[static_cast<std::size_t>(h.stone)], h.arm), h.direction)));
  if (against > Numbers::against_the_law || !(of_raised > Numbers::clear_gain * turned_over)) return {};
  return Bound{(absorbed - of_fixed) / of_raised, of_raised, (by_pyramids - of_fixed) / of_raised};
}

/// What a programme says, checked with the structure's own numbers: forces against balance, the mechanism against the
/// laws, and the factors that both give against each other. Of pyramids within cones forces alone are told.
template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::judge(const Programme& p, const ProgrammeSolution& found, double largest) const {
  LimitAnswer<dim> answer;
  answer.iterations = found.iterations;
  if (found.end != ProgrammeEnd::optimal) return answer;
  const double factor = found.x[static_cast<std::size_t>(p.factor_column)] * unit_ / raised_unit_;
  tell_forces(p, found, factor, answer);
  answer.factor = factor;
  if (answer.out_of_balance > Numbers::out_of_balance) return answer;
  if (factor >= largest * (1 - Numbers::clear_gain)) {
    answer.verdict = LimitVerdict::unlimited;
    return answer;
  }
  if (dim == 3 && p.pyramid == Pyramid::within) {
    answer.verdict = LimitVerdict::limited;
    return answer;
  }
  answer.mechanism = motion_of(found.price);
  if (answer.mechanism.empty()) return answer;
  const auto bound = bound_of(p, answer.mechanism);
  if (!bound) return answer;
  answer.factor = bound->factor;
  // The mechanism proves by itself. Forces agree as well as balance lets them, which of light stones is little.
  const double apart = Numbers::clear_gain * std::max(1.0, factor) + Numbers::out_of_balance * unit_ / bound->power;
  if (std::abs(bound->of_pyramids - factor) <= apart && answer.factor < largest * (1 - Numbers::clear_gain))
    answer.verdict = LimitVerdict::limited;
  return answer;
}

template <int dim>
LimitAnalysis<dim> LimitAnalysis<dim>::under_loads(double factor) const {
  auto s = s_;
  for (auto& stone : s.stones) {
    stone.raised = stone.fixed + factor * stone.raised;
    stone.fixed = {};
  }
  return LimitAnalysis(std::move(s));
}

/// The largest factor of raised loads, up to one, of a structure whose dry joints bear on a share of their faces.
/// Forces have an end only where they are out of balance without one: it costs the simplex method as much again.
/// @param basis  to begin from, of another share or of other loads, where none is raised yet; holds that of this one
///               afterwards. What comes out unclear is begun anew.
template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::raised_up_to(double largest, const Terms& terms, bool* balanced_unraised,
                                                  ProgrammeBasis* basis) const {
  LimitAnswer<dim> answer;
  ProgrammeBasis own;
  if (!basis) basis = &own;
  const bool begun = !basis->empty();
  bool at_rest = begun;
  for (const double most : {endless, Numbers::most_force}) {
    auto ending = terms;
    ending.most = most;
    auto p = programme(ending);
    p.lp.set_column(p.factor_column, 0, largest * raised_unit_ / unit_);
    p.lp.set_cost(p.factor_column, 1);
    if (std::exchange(at_rest, false)) rest_at_lower_bound(*basis, p.factor_column);
    if (begun) p.lp.start_from(*basis);
    const auto found = solve(p, largest, *basis, terms.borne);
    if (terms.lines) *terms.lines = p.added, *basis = p.lp.basis();
    *balanced_unraised = found.end != ProgrammeEnd::infeasible;
    answer = judge(p, found, largest);
    answer.basis = *basis;
    if (terms.least && answer.verdict == LimitVerdict::limited) tell_least(p, answer);
    if (found.end != ProgrammeEnd::optimal || answer.verdict != LimitVerdict::unknown) break;
  }
  if (!begun || answer.verdict != LimitVerdict::unknown) return answer;
  basis->clear();
  return raised_up_to(largest, terms, balanced_unraised, basis);
}

/// Whether a stone moves that neither carries a load at the limit nor is pressed there. Friction under its normal
/// forces is none, so that it would slide though it stands as soon as loads come to it: where a loose stone falls under
/// the first of its weight, the stones beside it have none of theirs yet.
template <int dim>
bool LimitAnalysis<dim>::moves_what_bears_nothing(const LimitAnswer<dim>& answer,
                                                  const std::vector<Wrench<dim>>& motion) const {
  const double nothing = Numbers::out_of_balance * unit_;
  std::vector<char> bears(s_.stones.size());
  for (std::size_t b = 0; b < bears.size(); ++b) {
    const auto& stone = s_.stones[b];
    bears[b] = size_of(stone.fixed + answer.factor * stone.raised, stone.radius) > nothing;
  }
  for (std::size_t k = 0; k < answer.force.size(); ++k)
    if (answer.force[k][0] > nothing)
      for (const int b : {s_.contacts[k].stone_i, s_.contacts[k].stone_j}) bears[static_cast<std::size_t>(b)] = 1;
  for (std::size_t b = 0; b < bears.size(); ++b)
    if (!bears[b] && reach_of(motion[b], s_.stones[b].radius) > Numbers::no_motion) return true;
  return false;
}

/// Adds the motion of an answer that has a mechanism. Where what slides in it would have to lift, it is that of the
/// structure without dilatancy, if that bears as much.
template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::in_motion(double largest, LimitAnswer<dim> answer) const {
  if (answer.verdict != LimitVerdict::limited) return answer;
  std::vector<Wrench<dim>> driving;
  for (const auto& stone : s_.stones) driving.push_back(stone.raised);
  auto motion = coulomb_motion<dim>(s_, answer.mechanism, driving);
  answer.motion = std::move(motion.of_stones);
  answer.dilates = motion.dilates;
  if (!answer.dilates) return answer;
  std::vector<Wrench<dim>> undilated;
  answer.estimate = without_dilatancy(largest, answer, &undilated);
  const bool bears_as_much = answer.estimate && *answer.estimate >= answer.factor * (1 - 2 * Numbers::settled);
  if (!bears_as_much || undilated.empty() || moves_what_bears_nothing(answer, undilated) ||
      closes<dim>(s_, undilated) > Numbers::against_the_law)
    return answer;
  answer.motion = std::move(undilated);
  answer.dilates = false;
  return answer;
}

/// Pyramids around the cones, which need be no finer than forces within them ask for.
template <int dim>
typename LimitAnalysis<dim>::Terms LimitAnalysis<dim>::around_cones(const LimitAnswer<dim>& borne) const {
  Terms terms;
  if (dim == 3 && borne.verdict == LimitVerdict::limited) terms.borne = borne.factor;
  return terms;
}

template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::largest_factor(double largest, const LimitAnswer<dim>& borne) const {
  VOUSSOIR_EXPECT(largest > 0 && "largest factor: positive");
  bool balanced_unraised = true;
  auto basis = borne.basis;
  auto answer = raised_up_to(largest, around_cones(borne), &balanced_unraised, &basis);
  if (balanced_unraised) return in_motion(largest, with_forces(largest, std::move(answer)));
  answer = refuses(0);
  if (answer.verdict != LimitVerdict::refused) answer.verdict = LimitVerdict::unknown;
  return answer;
}

template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::largest_borne(double largest, const ProgrammeBasis& begin, bool least) const {
  bool balanced = true;
  Terms terms;
  terms.pyramid = Pyramid::within;
  terms.least = least;
  auto basis = begin;
  auto answer = raised_up_to(largest, terms, &balanced, &basis);
  answer.mechanism.clear();
  return answer;
}

template <int dim>
bool LimitAnalysis<dim>::borne_at_any_factor() const {
  auto s = s_;
  for (auto& stone : s.stones) stone.fixed = std::exchange(stone.raised, Wrench<dim>{});
  for (auto& contact : s.contacts) contact.law.cohesion = contact.law.tension = 0;
  return LimitAnalysis(std::move(s)).bears(0).verdict == LimitVerdict::unlimited;
}

template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::bears(double factor) const {
  VOUSSOIR_EXPECT(std::isfinite(factor) && "factor: finite");
  bool balanced = true;
  const auto loaded = under_loads(factor);
  LimitAnswer<dim> borne;
  if (dim == 3) {  // forces within cones settle it, and stones that stand have them more often than a mechanism
    borne = loaded.largest_borne(1);
    if (borne.verdict == LimitVerdict::unlimited) return borne;
  }
  auto answer = loaded.in_motion(1, loaded.with_forces(1, loaded.raised_up_to(1, around_cones(borne), &balanced)));
  if (answer.verdict == LimitVerdict::limited) answer.verdict = LimitVerdict::refused;
  return answer;
}

template <int dim>
LimitAnswer<dim> LimitAnalysis<dim>::refuses(double factor) const {
  VOUSSOIR_EXPECT(std::isfinite(factor) && "factor: finite");
  bool balanced = true;
  const auto loaded = under_loads(factor);
  LimitAnswer<dim> borne;
  if (dim == 3) {  // as bears() asks
    borne = loaded.largest_borne(1);
    if (borne.verdict == LimitVerdict::unlimited) {
      borne.verdict = LimitVerdict::unknown;
      return borne;
    }
  }
  auto answer = loaded.in_motion(1, loaded.raised_up_to(1, around_cones(borne), &balanced));
  answer.verdict = answer.verdict == LimitVerdict::limited ? LimitVerdict::refused : LimitVerdict::unknown;
  return answer;
}

/// Friction under given normal forces [N], whatever the programme makes of these.
template <int dim>
void LimitAnalysis<dim>::bound_shear(Programme& p, const std::vector<double>& presses) const {
  for (std::size_t k = 0; k < presses.size(); ++k) {
    const auto& law = s_.contacts[static_cast<std::size_t>(corners_.kept[k])].law;
    if (!has_cone(law) || !dry(law)) continue;
    const double shear =
        (1 - Numbers::slope_left) * law.friction * std::max(0.0, presses[k]) / unit_;  // but for round-off
    for (std::size_t g = 0; g < p.columns[k].size(); ++g) {
      const double of_unit_shear = p.forces[k].generators[g].upper;
      if (std::isfinite(of_unit_shear)) p.lp.set_column(p.columns[k][g], -shear * of_unit_shear, shear * of_unit_shear);
    }
  }
}

template <int dim>
std::optional<double> LimitAnalysis<dim>::without_dilatancy(double largest, const LimitAnswer<dim>& associated,
                                                            std::vector<Wrench<dim>>* motion) const {
  if (associated.verdict == LimitVerdict::unlimited) return associated.factor;
  if (dim == 3 || associated.verdict != LimitVerdict::limited) return {};
  if (associated.estimate) return associated.estimate;
  const auto& kept = corners_.kept;
  auto p = programme({1, Numbers::most_force, Pyramid::around, true});
  p.lp.set_column(p.factor_column, 0, largest * raised_unit_ / unit_);
  p.lp.set_cost(p.factor_column, 1);
  std::vector<double> presses;
  for (const int k : kept) presses.push_back(associated.force[static_cast<std::size_t>(k)][0]);
  double last = associated.factor;
  for (int round = 0; round < Numbers::most_programmes; ++round) {
    bound_shear(p, presses);
    const auto found = p.lp.maximise();
    if (found.end != ProgrammeEnd::optimal) return {};
    const double factor = found.x[static_cast<std::size_t>(p.factor_column)] * unit_ / raised_unit_;
    if (round > 0 && std::abs(factor - last) <= Numbers::settled * std::max(factor, last)) {
      if (motion) *motion = motion_of(found.price);
      return factor;
    }
    last = factor;
    for (std::size_t k = 0; k < kept.size(); ++k)
      presses[k] += Numbers::weight_of_last * (p.force(k, found.x, unit_)[0] - presses[k]);
  }
  return {};
}

template class LimitAnalysis<2>;
template class LimitAnalysis<3>;

}  // namespace voussoir

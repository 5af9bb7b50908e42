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

double size_of(const Wrench& w, double radius) { return std::max(std::hypot(w[0], w[1]), std::abs(w[2]) / radius); }

/// Whether contacts [first, last) of an order are dry and on one line.
bool on_a_line(const RigidStructure& s, const std::vector<int>& order, std::size_t first, std::size_t last) {
  const auto& a = s.contacts[static_cast<std::size_t>(order[first])];
  const double radius = s.stones[static_cast<std::size_t>(a.stone_i)].radius;
  for (std::size_t k = first; k < last; ++k) {
    const auto& c = s.contacts[static_cast<std::size_t>(order[k])];
    if (!dry(c.law) || c.law.friction != a.law.friction || norm(c.axis[0] - a.axis[0]) > Numbers::straight ||
        std::abs(dot(c.arm_i - a.arm_i, a.axis[0])) > Numbers::straight * radius ||
        std::abs(dot(c.arm_j - a.arm_j, a.axis[0])) > Numbers::straight * radius)
      return false;
  }
  return true;
}

/// Velocities of the stones as prices of a programme tell them, the largest motion 1.
std::vector<Wrench> motion_of(const RigidStructure& s, const std::vector<double>& price) {
  std::vector<Wrench> motion;
  double size = 0;
  for (std::size_t b = 0; b < s.stones.size(); ++b) {
    const double r = s.stones[b].radius;
    motion.push_back({price[3 * b], price[3 * b + 1], price[3 * b + 2] / r});
    size = std::max(size, std::hypot(motion[b][0], motion[b][1]) + std::abs(motion[b][2]) * r);
  }
  if (!(size > 0)) return {};
  for (auto& w : motion)
    for (auto& v : w) v /= size;
  return motion;
}

/// By how much stones of a motion move into each other, or what is held moves.
double closes(const RigidStructure& s, const std::vector<Wrench>& motion) {
  double most = 0;
  for (const auto& c : s.contacts) most = std::max(most, -relative_velocity(c, motion)[0]);
  for (const auto& h : s.supports)
    most = std::max(most, std::abs(dot(velocity_at(motion[static_cast<std::size_t>(h.stone)], h.arm), h.direction)));
  return most;
}

/// The contract of a structure.
void expect_structure(const RigidStructure& s) {
  const auto is_stone = [&](int stone) { return stone >= 0 && stone < static_cast<int>(s.stones.size()); };
  const auto is_unit = [](const Vector<2>& v) { return std::abs(norm(v) - 1) < Numbers::straight; };
  for (const auto& stone : s.stones) VOUSSOIR_EXPECT(stone.radius > 0 && "radius of a stone: positive");
  for (const auto& c : s.contacts) {
    VOUSSOIR_EXPECT(is_stone(c.stone_i) && is_stone(c.stone_j) && "stones of a contact: of the structure");
    VOUSSOIR_EXPECT(is_unit(c.axis[0]) && is_unit(c.axis[1]) && "axes of a contact: of length one");
    VOUSSOIR_EXPECT(std::abs(dot(c.axis[0], c.axis[1])) < Numbers::straight && "axes of a contact: at right angles");
  }
  for (const auto& held : s.supports) {
    VOUSSOIR_EXPECT(is_stone(held.stone) && "stone of a support: of the structure");
    VOUSSOIR_EXPECT(is_unit(held.direction) && "direction of a support: of length one");
  }
}

}  // namespace

/// Contacts that bear whatever all of them can bear, in pairs where a joint is dry and straight.
void LimitAnalysis::keep_ends_of_joints() {
  const auto& s = s_;
  std::vector<int> order(s.contacts.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
  const auto at = [&](int k) -> const RigidContact& { return s.contacts[static_cast<std::size_t>(k)]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return at(a).joint < at(b).joint; });
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && at(order[last]).joint == at(order[first]).joint) ++last;
    const auto begin = order.begin() + static_cast<long>(first), end = order.begin() + static_cast<long>(last);
    if (last - first > 1 && on_a_line(s, order, first, last)) {
      const auto tangent = at(*begin).axis[1];
      const auto ends = std::minmax_element(
          begin, end, [&](int a, int b) { return dot(at(a).arm_i, tangent) < dot(at(b).arm_i, tangent); });
      for (const auto& [one, other] : {ends, std::make_pair(ends.second, ends.first)}) {
        kept_.push_back(*one);
        partner_.push_back(*other);
      }
    } else {
      kept_.insert(kept_.end(), begin, end);
      partner_.resize(kept_.size(), -1);
    }
  }
}

LimitAnalysis::LimitAnalysis(RigidStructure s) : s_(std::move(s)) {
  expect_structure(s_);
  keep_ends_of_joints();
  for (const auto& stone : s_.stones) {
    unit_ = std::max(unit_, size_of(stone.fixed, stone.radius));
    raised_unit_ = std::max(raised_unit_, size_of(stone.raised, stone.radius));
  }
  if (unit_ == 0) unit_ = raised_unit_ > 0 ? raised_unit_ : 1;
  if (raised_unit_ == 0) raised_unit_ = unit_;
}

/// Forces of contacts as a programme has them, and by how much they and what holds leave stones out of balance.
void LimitAnalysis::tell_forces(const Programme& p, const ProgrammeSolution& found, double factor,
                                LimitAnswer& answer) const {
  answer.force.assign(s_.contacts.size(), Vector<2>{});
  std::vector<Wrench> left(s_.stones.size());
  for (std::size_t b = 0; b < left.size(); ++b)
    for (std::size_t c = 0; c < 3; ++c) left[b][c] = s_.stones[b].fixed[c] + factor * s_.stones[b].raised[c];
  const auto push = [&](int stone, const Wrench& w, double amount) {
    for (std::size_t c = 0; c < 3; ++c) left[static_cast<std::size_t>(stone)][c] += amount * w[c];
  };
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    const auto& c = s_.contacts[static_cast<std::size_t>(kept_[k])];
    const auto f = p.force(k, found.x, unit_);
    const Vector<2> force = f[0] * c.axis[0] + f[1] * c.axis[1];
    // A force between the ends of its joint is told as its equivalent at both.
    const double at_other = partner_[k] >= 0 ? p.move : 0;
    auto& here = answer.force[static_cast<std::size_t>(kept_[k])];
    here = here + (1 - at_other) * f;
    if (at_other > 0) {
      auto& there = answer.force[static_cast<std::size_t>(partner_[k])];
      there = there + at_other * f;
    }
    push(c.stone_j, wrench_of(p.arm[k][1], force), 1);
    push(c.stone_i, wrench_of(p.arm[k][0], force), -1);
  }
  for (std::size_t k = 0; k < p.held.size(); ++k) {
    auto w = p.held[k].direction;
    w[2] *= s_.stones[static_cast<std::size_t>(p.held[k].stone)].radius;
    push(p.held[k].stone, w, unit_ * found.x[static_cast<std::size_t>(p.held_column) + k]);
  }
  for (std::size_t b = 0; b < left.size(); ++b)
    answer.out_of_balance = std::max(answer.out_of_balance, size_of(left[b], s_.stones[b].radius) / unit_);
}

/// The factor that a mechanism bears by its power; none where it is no mechanism, or loads gain nothing along it.
std::optional<LimitAnalysis::Bound> LimitAnalysis::bound_of(const std::vector<Wrench>& mechanism) const {
  double of_fixed = 0, of_raised = 0, turned_over = 0, absorbed = 0, against = 0;
  for (std::size_t b = 0; b < s_.stones.size(); ++b) {
    of_fixed += power(s_.stones[b].fixed, mechanism[b]);
    of_raised += power(s_.stones[b].raised, mechanism[b]);
    turned_over += std::abs(power(s_.stones[b].raised, mechanism[b]));
  }
  for (const auto& c : s_.contacts) {
    const auto most = absorbed_at_most(admissible_forces(c.law), relative_velocity(c, mechanism));
    absorbed += most.power;
    against = std::max(against, most.against);
  }
  for (const auto& h : s_.supports)
    against =
        std::max(against, std::abs(dot(velocity_at(mechanism[static_cast<std::size_t>(h.stone)], h.arm), h.direction)));
  if (against > Numbers::against_the_law || !(of_raised > Numbers::clear_gain * turned_over)) return {};
  return Bound{(absorbed - of_fixed) / of_raised, of_raised};
}

/// What a programme says, checked with the structure's own numbers: forces against balance, the mechanism against the
/// laws, and the factors that both give against each other.
LimitAnswer LimitAnalysis::judge(const Programme& p, const ProgrammeSolution& found, double largest) const {
  LimitAnswer answer;
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
  answer.mechanism = motion_of(s_, found.price);
  if (answer.mechanism.empty()) return answer;
  const auto bound = bound_of(answer.mechanism);
  if (!bound) return answer;
  answer.factor = bound->factor;
  // The mechanism proves by itself. Forces agree as well as balance lets them, which of light stones is little.
  const double apart = Numbers::clear_gain * std::max(1.0, factor) + Numbers::out_of_balance * unit_ / bound->power;
  if (std::abs(answer.factor - factor) <= apart && answer.factor < largest * (1 - Numbers::clear_gain))
    answer.verdict = LimitVerdict::limited;
  return answer;
}

LimitAnalysis LimitAnalysis::under_loads(double factor) const {
  auto s = s_;
  for (auto& stone : s.stones)
    for (std::size_t c = 0; c < 3; ++c)
      stone.raised[c] = stone.fixed[c] + factor * std::exchange(stone.raised[c], 0.0), stone.fixed[c] = 0;
  return LimitAnalysis(std::move(s));
}

/// The largest factor of raised loads, up to one, of a structure whose dry joints bear on a share of their length.
/// Forces have an end only where they are out of balance without one: it costs the simplex method as much again.
/// @param basis  to begin from, of another share; holds that of this one afterwards. What comes out unclear is begun
/// anew.
LimitAnswer LimitAnalysis::raised_up_to(double largest, double share_of_joints, bool* balanced_unraised,
                                        ProgrammeBasis* basis) const {
  LimitAnswer answer;
  const bool begun = basis && !basis->empty();
  for (const double most : {endless, Numbers::most_force}) {
    auto p = programme(share_of_joints, false, most);
    p.lp.set_column(p.factor_column, 0, largest * raised_unit_ / unit_);
    p.lp.set_cost(p.factor_column, 1);
    if (begun) p.lp.start_from(*basis);
    const auto found = p.lp.maximise();
    if (basis) *basis = p.lp.basis();
    *balanced_unraised = found.end != ProgrammeEnd::infeasible;
    answer = judge(p, found, largest);
    if (found.end != ProgrammeEnd::optimal || answer.verdict != LimitVerdict::unknown) break;
  }
  if (!begun || answer.verdict != LimitVerdict::unknown) return answer;
  basis->clear();
  return raised_up_to(largest, share_of_joints, balanced_unraised, basis);
}

/// Adds the motion of an answer that has a mechanism. Where what slides in it would have to lift, it is that of the
/// structure without dilatancy, if that bears as much.
LimitAnswer LimitAnalysis::in_motion(double largest, LimitAnswer answer) const {
  if (answer.verdict != LimitVerdict::limited) return answer;
  std::vector<Wrench> driving;
  for (const auto& stone : s_.stones) driving.push_back(stone.raised);
  auto motion = coulomb_motion(s_, answer.mechanism, driving);
  answer.motion = std::move(motion.of_stones);
  answer.dilates = motion.dilates;
  if (!answer.dilates) return answer;
  std::vector<Wrench> undilated;
  answer.estimate = without_dilatancy(largest, answer, &undilated);
  const bool bears_as_much = answer.estimate && *answer.estimate >= answer.factor * (1 - 2 * Numbers::settled);
  if (!bears_as_much || undilated.empty() || closes(s_, undilated) > Numbers::against_the_law) return answer;
  answer.motion = std::move(undilated);
  answer.dilates = false;
  return answer;
}

LimitAnswer LimitAnalysis::largest_factor(double largest) const {
  VOUSSOIR_EXPECT(largest > 0 && "largest factor: positive");
  bool balanced_unraised = true;
  auto answer = raised_up_to(largest, 1, &balanced_unraised);
  if (balanced_unraised) return in_motion(largest, std::move(answer));
  answer = bears(0);
  if (answer.verdict != LimitVerdict::refused) answer.verdict = LimitVerdict::unknown;
  return answer;
}

bool LimitAnalysis::borne_at_any_factor() const {
  auto s = s_;
  for (auto& stone : s.stones) stone.fixed = std::exchange(stone.raised, Wrench{});
  for (auto& contact : s.contacts) contact.law.cohesion = contact.law.tension = 0;
  return LimitAnalysis(std::move(s)).bears(0).verdict == LimitVerdict::unlimited;
}

LimitAnswer LimitAnalysis::bears(double factor) const {
  VOUSSOIR_EXPECT(std::isfinite(factor) && "factor: finite");
  bool balanced = true;
  const auto loaded = under_loads(factor);
  auto answer = loaded.in_motion(1, loaded.raised_up_to(1, 1, &balanced));
  if (answer.verdict == LimitVerdict::limited) answer.verdict = LimitVerdict::refused;
  return answer;
}

std::optional<double> LimitAnalysis::without_dilatancy(double largest, const LimitAnswer& associated,
                                                       std::vector<Wrench>* motion) const {
  if (associated.verdict == LimitVerdict::unlimited) return associated.factor;
  if (associated.verdict != LimitVerdict::limited) return {};
  if (associated.estimate) return associated.estimate;
  auto p = programme(1, true, Numbers::most_force);
  p.lp.set_column(p.factor_column, 0, largest * raised_unit_ / unit_);
  p.lp.set_cost(p.factor_column, 1);
  std::vector<double> presses;
  for (const int k : kept_) presses.push_back(associated.force[static_cast<std::size_t>(k)][0]);
  double last = associated.factor;
  for (int round = 0; round < Numbers::most_programmes; ++round) {
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      const auto& law = s_.contacts[static_cast<std::size_t>(kept_[k])].law;
      if (p.forces[k].generators.size() != 3 || !dry(law)) continue;
      const double shear =
          (1 - Numbers::slope_left) * law.friction * std::max(0.0, presses[k]) / unit_;  // but for round-off
      p.lp.set_column(p.first_column[k] + 2, -shear, shear);
    }
    const auto found = p.lp.maximise();
    if (found.end != ProgrammeEnd::optimal) return {};
    const double factor = found.x[static_cast<std::size_t>(p.factor_column)] * unit_ / raised_unit_;
    if (round > 0 && std::abs(factor - last) <= Numbers::settled * std::max(factor, last)) {
      if (motion) *motion = motion_of(s_, found.price);
      return factor;
    }
    last = factor;
    for (std::size_t k = 0; k < kept_.size(); ++k)
      presses[k] += Numbers::weight_of_last * (p.force(k, found.x, unit_)[0] - presses[k]);
  }
  return {};
}

}  // namespace voussoir

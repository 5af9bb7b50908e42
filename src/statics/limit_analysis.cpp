#include "statics/limit_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "statics/coulomb_motion.hpp"
#include "statics/limit_programme.hpp"

namespace voussoir {
namespace {

// A motion may press into points by so much of its size, a hundred times the programme's tolerance; more than that
// proves nothing.
constexpr double against_the_law = 1e-8;
// Loads gain along a mechanism by more than this share of what they turn over: a hundred times what an equilibrium of
// the elastic structure may be out of balance.
constexpr double clear_gain = 1e-6;
// Friction that hardly dilates: this share of Coulomb's slope is left, so that programmes keep an inside.
constexpr double slope_left = 1e-3;
// What the normal forces of the last programme weigh in the next, and when the sequence has settled, as in the source.
constexpr double weight_of_last = 0.6;
constexpr double settled = 1e-4;
constexpr int most_programmes = 100;

Wrench scaled(const Wrench& w, double radius, double unit) {
  return {w[0] / unit, w[1] / unit, w[2] / (radius * unit)};
}

double size_of(const Wrench& w, double radius) { return std::max(std::hypot(w[0], w[1]), std::abs(w[2]) / radius); }

double power(const Wrench& load, const Wrench& motion) {
  return load[0] * motion[0] + load[1] * motion[1] + load[2] * motion[2];
}

bool dry(const PointLaw& law) { return law.cohesion == 0 && law.tension == 0; }

/// Whether contacts [first, last) of an order are dry and on one line.
bool on_a_line(const RigidStructure& s, const std::vector<int>& order, std::size_t first, std::size_t last) {
  const auto& a = s.contacts[static_cast<std::size_t>(order[first])];
  const double radius = s.stones[static_cast<std::size_t>(a.stone_i)].radius;
  for (std::size_t k = first; k < last; ++k) {
    const auto& c = s.contacts[static_cast<std::size_t>(order[k])];
    if (!dry(c.law) || c.law.friction != a.law.friction || norm(c.axis[0] - a.axis[0]) > straight ||
        std::abs(dot(c.arm_i - a.arm_i, a.axis[0])) > straight * radius ||
        std::abs(dot(c.arm_j - a.arm_j, a.axis[0])) > straight * radius)
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
  keep_ends_of_joints();
  for (const auto& stone : s_.stones) {
    unit_ = std::max(unit_, size_of(stone.fixed, stone.radius));
    raised_unit_ = std::max(raised_unit_, size_of(stone.raised, stone.radius));
  }
  if (unit_ == 0) unit_ = raised_unit_ > 0 ? raised_unit_ : 1;
  if (raised_unit_ == 0) raised_unit_ = unit_;
}

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
  const auto entries = [&](int stone, const Wrench& wrench, double sign, std::vector<ProgrammeEntry>& list) {
    const auto w = scaled(wrench, s_.stones[static_cast<std::size_t>(stone)].radius, 1);
    for (int c = 0; c < 3; ++c) list.push_back({3 * stone + c, sign * w[static_cast<std::size_t>(c)]});
  };
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
    if (slides) law = {slope_left * law.friction, 1, 0};
    p.forces.push_back(admissible_forces(law));
    p.arm.push_back(arm);
    const auto column = [&](const Vector<2>& direction) {
      const Vector<2> f = direction[0] * c.axis[0] + direction[1] * c.axis[1];
      std::vector<ProgrammeEntry> list;
      entries(c.stone_j, wrench_of(arm[1], f), 1, list);
      entries(c.stone_i, wrench_of(arm[0], f), -1, list);
      return list;
    };
    p.first_column.push_back(p.lp.columns());
    for (const auto& g : p.forces.back().generators)
      p.lp.add_column(column(g.direction), std::max(g.lower / unit_, -most), std::min(g.upper / unit_, most), 0);
    for (const auto& e : column(p.forces.back().apex)) apex[static_cast<std::size_t>(e.row)] += e.value / unit_;
  }
  for (std::size_t row = 0; row < apex.size(); ++row) {
    if (apex[row] == 0) continue;
    const auto& stone = s_.stones[row / 3];
    const double b = -scaled(stone.fixed, stone.radius, unit_)[row % 3] - apex[row];
    p.lp.set_row(static_cast<int>(row), b, b);
  }
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
    if (left < straight) continue;
    for (auto& x : w) x /= left;
    basis.push_back(w);
    std::vector<ProgrammeEntry> list;
    for (int c = 0; c < 3; ++c) list.push_back({3 * support.stone + c, w[static_cast<std::size_t>(c)]});
    p.lp.add_column(list, -endless, endless, 0);
    p.held.push_back({support.stone, support.name, w});
  }
  std::vector<ProgrammeEntry> raised;
  for (std::size_t b = 0; b < s_.stones.size(); ++b) {
    const auto w = scaled(s_.stones[b].raised, s_.stones[b].radius, raised_unit_);
    for (int c = 0; c < 3; ++c) raised.push_back({3 * static_cast<int>(b) + c, w[static_cast<std::size_t>(c)]});
  }
  p.factor_column = p.lp.add_column(raised, 0, 0, 0);
  return p;
}

/// What a programme says, checked with the structure's own numbers: forces against balance, the mechanism against the
/// laws, and the factors that both give against each other.
LimitAnswer LimitAnalysis::judge(const Programme& p, const ProgrammeSolution& found, double largest) const {
  LimitAnswer answer;
  answer.iterations = found.iterations;
  if (found.end != ProgrammeEnd::optimal) return answer;
  const double factor = found.x[static_cast<std::size_t>(p.factor_column)] * unit_ / raised_unit_;
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
  answer.factor = factor;
  if (answer.out_of_balance > out_of_balance) return answer;
  if (factor >= largest * (1 - clear_gain)) {
    answer.verdict = LimitVerdict::unlimited;
    return answer;
  }
  answer.mechanism = motion_of(s_, found.price);
  if (answer.mechanism.empty()) return answer;
  double of_fixed = 0, of_raised = 0, turned_over = 0, absorbed = 0, against = 0;
  for (std::size_t b = 0; b < s_.stones.size(); ++b) {
    of_fixed += power(s_.stones[b].fixed, answer.mechanism[b]);
    of_raised += power(s_.stones[b].raised, answer.mechanism[b]);
    turned_over += std::abs(power(s_.stones[b].raised, answer.mechanism[b]));
  }
  for (const auto& c : s_.contacts) {
    const auto most = absorbed_at_most(admissible_forces(c.law), relative_velocity(c, answer.mechanism));
    absorbed += most.power;
    against = std::max(against, most.against);
  }
  for (const auto& h : s_.supports)
    against = std::max(
        against, std::abs(dot(velocity_at(answer.mechanism[static_cast<std::size_t>(h.stone)], h.arm), h.direction)));
  if (against > against_the_law || !(of_raised > clear_gain * turned_over)) return answer;
  answer.factor = (absorbed - of_fixed) / of_raised;
  // The mechanism proves by itself. Forces agree as well as balance lets them, which of light stones is little.
  const double apart = clear_gain * std::max(1.0, factor) + out_of_balance * unit_ / of_raised;
  if (std::abs(answer.factor - factor) <= apart && answer.factor < largest * (1 - clear_gain))
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
  for (const double most : {endless, most_force}) {
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
  const bool bears_as_much = answer.estimate && *answer.estimate >= answer.factor * (1 - 2 * settled);
  if (!bears_as_much || undilated.empty() || closes(s_, undilated) > against_the_law) return answer;
  answer.motion = std::move(undilated);
  answer.dilates = false;
  return answer;
}

LimitAnswer LimitAnalysis::largest_factor(double largest) const {
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
  auto p = programme(1, true, most_force);
  p.lp.set_column(p.factor_column, 0, largest * raised_unit_ / unit_);
  p.lp.set_cost(p.factor_column, 1);
  std::vector<double> presses;
  for (const int k : kept_) presses.push_back(associated.force[static_cast<std::size_t>(k)][0]);
  double last = associated.factor;
  for (int round = 0; round < most_programmes; ++round) {
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      const auto& law = s_.contacts[static_cast<std::size_t>(kept_[k])].law;
      if (p.forces[k].generators.size() != 3 || !dry(law)) continue;
      const double shear = (1 - slope_left) * law.friction * presses[k] / unit_;
      p.lp.set_column(p.first_column[k] + 2, -shear, shear);
    }
    const auto found = p.lp.maximise();
    if (found.end != ProgrammeEnd::optimal) return {};
    const double factor = found.x[static_cast<std::size_t>(p.factor_column)] * unit_ / raised_unit_;
    if (round > 0 && std::abs(factor - last) <= settled * std::max(factor, last)) {
      if (motion) *motion = motion_of(s_, found.price);
      return factor;
    }
    last = factor;
    for (std::size_t k = 0; k < kept_.size(); ++k)
      presses[k] += weight_of_last * (p.force(k, found.x, unit_)[0] - presses[k]);
  }
  return {};
}

}  // namespace voussoir

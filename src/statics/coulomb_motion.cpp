#include "statics/coulomb_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "base/order_of_magnitude.hpp"
#include "statics/admissible_forces.hpp"
#include "statics/limit_analysis_parameters.hpp"
#include "statics/linear_programme.hpp"

namespace voussoir {
namespace {

constexpr double none = LimitAnalysisParameters::no_motion;
const double quarter = RoundConeParameters::pi / 2;
const double side = RoundConeParameters::side;

/// Stones that move as one have the components of motion of its first stone, turns times its radius.
struct Part {
  int first_stone = 0;
  double radius = 0;  ///< [m] of the farthest place from the middle of that stone
};

template <int dim>
class MotionProgramme {
 public:
  /// @param work  of the loads, in that along the mechanism
  MotionProgramme(const RigidStructure<dim>& s, const std::vector<Wrench<dim>>& mechanism,
                  const std::vector<Wrench<dim>>& driving, double work)
      : s_(s), mechanism_(mechanism) {
    join_stones();
    for (std::size_t k = 0; k < n * parts_.size(); ++k) rows_of_column_.emplace_back();
    for (const auto& c : s_.contacts) add_contact(c);
    for (const auto& h : s_.supports) add_row(terms_of(h.stone, h.arm, h.direction, 1), -none, none);
    add_driving(driving, work);
    add_distance();
  }

  bool slides() const { return !sliding_.empty(); }

  /// Nothing where what slides cannot stay closed.
  std::vector<Wrench<dim>> solve() {
    for (std::size_t k = 0; k < rows_of_column_.size(); ++k)
      lp_.add_column(std::move(rows_of_column_[k]), -endless, endless, -cost_[k]);
    for (const auto& [row, sign] : distances_) lp_.add_column({{row, sign}}, 0, endless, 0);
    const auto closest = lp_.maximise();
    const double allowed = 2 * none * static_cast<double>(sliding_.size());
    if (closest.end != ProgrammeEnd::optimal || -closest.value > allowed) return {};
    const int columns = static_cast<int>(cost_.size());
    for (int k = 0; k < columns; ++k) lp_.set_cost(k, 0);
    for (std::size_t k = 0; k < distances_.size(); ++k) lp_.set_cost(columns + static_cast<int>(k), -1);
    for (const int row : sliding_) lp_.set_row(row, -none, allowed);
    const auto nearest = lp_.maximise();
    return motions(nearest.end == ProgrammeEnd::optimal ? nearest.x : closest.x);
  }

 private:
  using Terms = std::vector<std::pair<int, double>>;  ///< column, factor
  static const std::size_t n = freedoms<dim>;

  double radius(int stone) const { return s_.stones[static_cast<std::size_t>(stone)].radius; }
  const Wrench<dim>& moves(int stone) const { return mechanism_[static_cast<std::size_t>(stone)]; }
  bool rests(int stone) const { return reach_of(moves(stone), radius(stone)) <= none; }

  /// Parts of stones that touch and turn alike, without what rests.
  void join_stones() {
    const auto count = s_.stones.size();
    std::vector<int> root(count);
    for (std::size_t b = 0; b < count; ++b) root[b] = static_cast<int>(b);
    const auto find = [&](int b) {
      while (root[static_cast<std::size_t>(b)] != b) b = root[static_cast<std::size_t>(b)];
      return b;
    };
    for (const auto& c : s_.contacts) {
      const double turn = length(moment_of(moves(c.stone_i)) - moment_of(moves(c.stone_j)));
      if (norm(relative_velocity(c, mechanism_)) > none || turn * std::min(radius(c.stone_i), radius(c.stone_j)) > none)
        continue;
      const int a = find(c.stone_i), b = find(c.stone_j);
      root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    part_.assign(count, -1);
    for (std::size_t b = 0; b < count; ++b) {
      const int first = find(static_cast<int>(b));
      if (rests(first)) continue;
      auto& part = part_[static_cast<std::size_t>(first)];
      if (part < 0) part = static_cast<int>(parts_.size()), parts_.push_back({first, 0});
      part_[b] = part;
      auto& reach = parts_[static_cast<std::size_t>(part)].radius;
      reach = std::max(reach, norm(from_first(static_cast<int>(b))) + radius(static_cast<int>(b)));
    }
  }

  /// The middle of a stone from that of the first of its part [m].
  Vector<dim> from_first(int stone) const {
    const auto first = parts_[static_cast<std::size_t>(part_[static_cast<std::size_t>(stone)])].first_stone;
    return s_.stones[static_cast<std::size_t>(stone)].middle - s_.stones[static_cast<std::size_t>(first)].middle;
  }

  /// Velocity of a place of a stone along a direction; nothing of one that rests.
  Terms terms_of(int stone, const Vector<dim>& arm, const Vector<dim>& direction, double sign) const {
    const int part = part_[static_cast<std::size_t>(stone)];
    if (part < 0) return {};
    const auto w = wrench_of(from_first(stone) + arm, direction);
    const double reach = parts_[static_cast<std::size_t>(part)].radius;
    Terms terms;
    for (std::size_t c = 0; c < n; ++c)
      terms.emplace_back(static_cast<int>(n) * part + static_cast<int>(c), c < dim ? sign * w[c] : sign * w[c] / reach);
    return terms;
  }

  int add_row(const Terms& terms, double lower, double upper) {
    if (terms.empty()) return -1;
    const int row = lp_.add_row(lower, upper);
    for (const auto& [column, factor] : terms)
      rows_of_column_[static_cast<std::size_t>(column)].push_back({row, factor});
    return row;
  }

  void add_contact(const RigidContact<dim>& c) {
    if (part_[static_cast<std::size_t>(c.stone_i)] == part_[static_cast<std::size_t>(c.stone_j)]) return;
    const auto relative = [&](const Vector<dim>& axis) {
      auto terms = terms_of(c.stone_j, c.arm_j, axis, 1);
      const auto less = terms_of(c.stone_i, c.arm_i, axis, -1);
      terms.insert(terms.end(), less.begin(), less.end());
      return terms;
    };
    const auto v = relative_velocity(c, mechanism_);
    const double slip = length(tangential(v));
    const double friction = c.law.friction < LimitAnalysisParameters::endless_friction ? c.law.friction : 0;
    // As a pyramid around the cone may have it: by friction times slip, and up to its edges.
    const double edge = dim == 2 ? friction : friction / std::cos(side / 2);
    if (norm(v) <= none) {
      for (const auto& axis : c.axis) add_row(relative(axis), -none, none);
    } else if (slip > none && v[0] >= friction * slip - none && v[0] <= edge * slip + none) {
      const auto opening = relative(c.axis[0]);
      sliding_.push_back(add_row(opening, -none, endless));
      cost_.resize(rows_of_column_.size(), 0.0);
      for (const auto& [column, factor] : opening) cost_[static_cast<std::size_t>(column)] += factor;
      keep_way(c, v, relative);
    } else {
      add_row(relative(c.axis[0]), -none, endless);
    }
  }

  template <class Relative>
  void keep_way(const RigidContact<2>& c, const Vector<2>& v, const Relative& relative) {
    if (v[1] > 0)
      add_row(relative(c.axis[1]), 0, endless);
    else
      add_row(relative(c.axis[1]), -endless, 0);
  }
  /// Within half a side of a pyramid to both sides of it.
  template <class Relative>
  void keep_way(const RigidContact<3>& c, const Vector<3>& v, const Relative& relative) {
    const double way = std::atan2(v[2], v[1]);
    for (const double aside : {way + quarter - side / 2, way - quarter + side / 2})
      add_row(relative(std::cos(aside) * c.axis[1] + std::sin(aside) * c.axis[2]), 0, endless);
  }

  /// The loads do so many times the work that they do along the mechanism.
  void add_driving(const std::vector<Wrench<dim>>& driving, double work) {
    double all = 0;
    std::vector<double> sum(rows_of_column_.size(), 0.0);
    for (std::size_t b = 0; b < part_.size(); ++b) {
      if (part_[b] < 0) continue;
      all += dot(driving[b], mechanism_[b]);
      const auto part = static_cast<std::size_t>(part_[b]);
      const auto& load = driving[b];
      const auto moment = wrench_of(from_first(static_cast<int>(b)), force_of(load));
      for (std::size_t c = 0; c < n; ++c)
        sum[n * part + c] += c < dim ? load[c] : (moment[c] + load[c]) / parts_[part].radius;
    }
    Terms terms;
    for (std::size_t k = 0; k < sum.size(); ++k) terms.emplace_back(static_cast<int>(k), sum[k] / (work * all));
    add_row(terms, 1, 1);
  }

  /// Of every component from the mechanism's: a column for more and one for less.
  void add_distance() {
    cost_.resize(rows_of_column_.size(), 0.0);
    for (std::size_t k = 0; k < rows_of_column_.size(); ++k) {
      const auto& part = parts_[k / n];
      const double here = moves(part.first_stone)[k % n] * (k % n < dim ? 1 : part.radius);
      const int row = lp_.add_row(here, here);
      rows_of_column_[k].push_back({row, 1});
      distances_.emplace_back(row, 1.0);
      distances_.emplace_back(row, -1.0);
    }
  }

  std::vector<Wrench<dim>> motions(const std::vector<double>& x) const {
    std::vector<Wrench<dim>> all(part_.size(), Wrench<dim>{});
    for (std::size_t b = 0; b < part_.size(); ++b) {
      if (part_[b] < 0) continue;
      const auto part = static_cast<std::size_t>(part_[b]);
      auto& motion = all[b];
      for (std::size_t c = 0; c < n; ++c) motion[c] = c < dim ? x[n * part + c] : x[n * part + c] / parts_[part].radius;
      const auto v = velocity_at(motion, from_first(static_cast<int>(b)));
      std::copy(v.begin(), v.end(), motion.begin());
    }
    return all;
  }

  const RigidStructure<dim>& s_;
  const std::vector<Wrench<dim>>& mechanism_;
  std::vector<int> part_;  ///< of a stone; -1 for one that rests
  std::vector<Part> parts_;
  LinearProgramme lp_;
  std::vector<std::vector<ProgrammeEntry>> rows_of_column_;
  std::vector<double> cost_;  ///< per column: of opening where the mechanism slides
  std::vector<int> sliding_;  ///< rows of those openings
  std::vector<std::pair<int, double>> distances_;
};

}  // namespace

template <int dim>
CoulombMotion<dim> coulomb_motion(const RigidStructure<dim>& s, const std::vector<Wrench<dim>>& mechanism,
                                  const std::vector<Wrench<dim>>& driving) {
  VOUSSOIR_EXPECT(mechanism.size() == s.stones.size() && "mechanism: per stone");
  VOUSSOIR_EXPECT(driving.size() == s.stones.size() && "driving loads: per stone");
  std::vector<Wrench<dim>> motion;
  // Next to the limit the mechanism does hardly any work, and a closed motion of the same work is as small as what the
  // programme lets joints open. Work is raised until the motion is of the order of the mechanism, 1 m.
  double work = 1;
  for (double size = 0, before = -1; order_of_magnitude * size < 1 && size > before;) {
    MotionProgramme<dim> programme(s, mechanism, driving, work);
    if (!programme.slides()) return {mechanism, false};
    motion = programme.solve();
    if (motion.empty()) return {mechanism, true};
    before = std::exchange(size, 0);
    for (std::size_t b = 0; b < motion.size(); ++b) size = std::max(size, reach_of(motion[b], s.stones[b].radius));
    work /= std::max(size, none);
  }
  return {std::move(motion), false};
}

template CoulombMotion<2> coulomb_motion(const RigidStructure<2>&, const std::vector<Wrench<2>>&,
                                         const std::vector<Wrench<2>>&);
template CoulombMotion<3> coulomb_motion(const RigidStructure<3>&, const std::vector<Wrench<3>>&,
                                         const std::vector<Wrench<3>>&);

}  // namespace voussoir

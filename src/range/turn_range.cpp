#include "range/turn_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/check.hpp"
#include "base/text.hpp"
#include "linalg/agree.hpp"
#include "linalg/gather.hpp"
#include "linalg/parcels.hpp"
#include "linalg/reduce.hpp"
#include "range/joint_network.hpp"
#include "range/stone_names.hpp"
#include "range/turn_records.hpp"

namespace voussoir {
namespace {

// A stone that rocks by the share s of the angle at which it topples is held back by 1 - s of what first order says. Up
// to a tenth that is what cells of a usual size are wrong by; from one on it falls where first order lets it stand.
constexpr double worth_telling = 0.1, past_balance = 1;
// Joints that carry less than this share of the largest force say nothing: that is what solvers leave.
constexpr double negligible = 1e-6;

/// The sum of (turn x arm) x force.
Vector<3> moment_added(const Vector<3>& turn, const Virial& of) {
  const double trace = of[0][0] + of[1][1] + of[2][2];
  return Vector<3>{dot(of[0], turn), dot(of[1], turn), dot(of[2], turn)} - trace * turn;
}

NetworkLoad<2> load_of(const Vector<3>& force, const Vector<3>& moment, std::integral_constant<int, 2>) {
  return {force[0], force[1], moment[2]};
}
NetworkLoad<3> load_of(const Vector<3>& force, const Vector<3>& moment, std::integral_constant<int, 3>) {
  return {force[0], force[1], force[2], moment[0], moment[1], moment[2]};
}

template <int dim>
Vector<dim> in_dim(const Vector<3>& v) {
  Vector<dim> part{};
  std::copy_n(v.begin(), dim, part.begin());
  return part;
}

/// All stones and joints as springs, on the first rank; none on the others.
template <int dim>
struct Network {
  using Dim = std::integral_constant<int, dim>;
  std::vector<StoneRecord> stones;
  std::vector<JointRecord> joints;
  std::vector<NetworkJoint<dim>> springs;
  std::vector<int> free;  ///< number among those that no support holds, per stone; -1 for the others
  int moving = 0;

  Network(const ModelOfBlocks<dim>& model, const StepEnd& end) {
    const auto& comm = *model.structure().comm();
    stones = gather_on_first(stones_here(model, end), comm);
    joints = gather_on_first(joints_here(model, end), comm);
    std::sort(stones.begin(), stones.end(), [](const auto& a, const auto& b) { return a.block < b.block; });
    std::sort(joints.begin(), joints.end(), [](const auto& a, const auto& b) {
      return std::tie(a.block_i, a.block_j, a.middle) < std::tie(b.block_i, b.block_j, b.middle);
    });
    for (const auto& stone : stones) free.push_back(stone.held ? -1 : moving++);
    const auto missing = [&](const JointRecord& r) { return stone_of(r.block_i) < 0 || stone_of(r.block_j) < 0; };
    joints.erase(std::remove_if(joints.begin(), joints.end(), missing), joints.end());
    for (const auto& r : joints) {
      const auto i = stone_of(r.block_i), j = stone_of(r.block_j);
      NetworkJoint<dim> spring{
          free[i], free[j], in_dim<dim>(r.middle - stones[i].centre), in_dim<dim>(r.middle - stones[j].centre), {}, {}};
      for (int a = 0; a < dim; ++a) spring.axis[a] = in_dim<dim>(r.axis[a]);
      springs.push_back(spring);
    }
  }

  int stone_of(BlockId block) const {
    const auto it = std::lower_bound(stones.begin(), stones.end(), block,
                                     [](const StoneRecord& s, BlockId id) { return s.block < id; });
    return it != stones.end() && it->block == block ? static_cast<int>(it - stones.begin()) : -1;
  }

  /// Per joint: what bears nothing does not stand.
  std::vector<char> touching() const {
    double largest = 0;
    for (const auto& r : joints) largest = std::max(largest, r.presses);
    std::vector<char> touches;
    for (const auto& r : joints) touches.push_back(r.presses > negligible * largest);
    return touches;
  }

  /// Springs that resist a motion by one number, and a turn by it times the square of an arm.
  static NetworkLoad<dim> springs_of(const JointRecord& r, double motion, double of_half) {
    const double a = of_half * r.half[0], b = of_half * r.half[1];
    if constexpr (dim == 2)
      return {motion, motion, motion * a * a};
    else
      return {motion, motion, motion, motion * (a * a + b * b), motion * b * b, motion * a * a};
  }

  /// In time forces come and go with every knock: what joints bear is taken from the loads, joints as springs as large
  /// as they are.
  void bear_loads() {
    std::vector<NetworkLoad<dim>> load(moving);
    for (std::size_t k = 0; k < stones.size(); ++k)
      if (free[k] >= 0) load[free[k]] = load_of(stones[k].load, stones[k].load_moment, Dim());
    for (std::size_t k = 0; k < joints.size(); ++k)
      springs[k].stiffness = springs_of(joints[k], joints[k].area, 1 / std::sqrt(3.0));
    const auto borne = borne_by_network(moving, springs, load);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      auto& r = joints[k];
      r.force = {};
      for (int a = 0; a < dim; ++a) r.force = r.force + borne[k][a] * r.axis[a];
      r.virial_i = r.virial_j = {};
      add_virial(r.middle - stones[stone_of(r.block_i)].centre, -1.0 * r.force, r.virial_i);
      add_virial(r.middle - stones[stone_of(r.block_j)].centre, r.force, r.virial_j);
      r.presses = std::abs(borne[k][0]);
    }
  }

  /// The largest share of what a joint bears that it is asked for beside.
  static double share_of(const JointRecord& r, const NetworkForce<dim>& more) {
    double most = std::abs(more[0]);
    if constexpr (dim == 2)
      most = std::max(most, std::abs(more[2]) / r.half[0]);
    else  // a moment about one tangent has its arm along the other; a twist moves no force off the joint
      most = std::max({most, std::abs(more[4]) / r.half[1], std::abs(more[5]) / r.half[0]});
    return most;
  }

  /// Forces keep their places on stones that turn. The moments that makes are shared out so that joints are asked for
  /// as small a share of what they bear as can be. Returns for each joint that share.
  std::vector<double> shares() {
    std::vector<NetworkLoad<dim>> moment(moving);
    double largest = 0;
    for (const auto& r : joints) largest = std::max(largest, r.presses);
    std::vector<double> share(joints.size(), 0.0);
    if (!(largest > 0)) return share;
    const auto add = [&](int stone, const Virial& virial) {
      if (free[stone] < 0) return;
      const auto more = load_of({}, (1 / largest) * moment_added(stones[stone].turn, virial), Dim());
      moment[free[stone]] = moment[free[stone]] + more;
    };
    for (std::size_t k = 0; k < stones.size(); ++k) add(static_cast<int>(k), stones[k].virial);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const auto& r = joints[k];
      add(stone_of(r.block_i), r.virial_i);
      add(stone_of(r.block_j), r.virial_j);
      const double bears = r.presses > negligible * largest ? r.presses / largest : 0.0;
      springs[k].stiffness = springs_of(r, bears * bears, 1);
    }
    const auto more = borne_by_network(moving, springs, moment);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const auto& r = joints[k];
      if (!(springs[k].stiffness[0] > 0)) continue;
      share[k] = share_of(r, more[k]) * largest / r.presses;
      // A bed that turns is a slope: what it carries slides when it has turned by the angle of friction.
      auto slope = 0.5 * (stones[stone_of(r.block_i)].turn + stones[stone_of(r.block_j)].turn);
      slope = slope - dot(slope, r.axis[0]) * r.axis[0];
      if (r.friction > 0) share[k] = std::max(share[k], norm(slope) / r.friction);
    }
    return share;
  }
};

/// Nothing can be worth telling as long as stones turn by less than a share of every angle of friction, and nothing
/// moves against anything by that share of half a joint. Collective.
template <int dim>
bool small_motion(const ModelOfBlocks<dim>& model, const StepEnd& end, double smallest_half_joint) {
  const auto& s = model.structure();
  const auto& comm = *s.comm();
  const auto& u = end.state.displacement;
  std::array<double, 2 * dim> range;  // x, -x, y, -y
  range.fill(-INFINITY);
  for (int n = 0; n < s.owned_nodes(); ++n)
    for (int c = 0; c < dim; ++c) {
      range[2 * c] = std::max(range[2 * c], u[dim * n + c]);
      range[2 * c + 1] = std::max(range[2 * c + 1], -u[dim * n + c]);
    }
  const auto all = largest_of_each(comm, range);
  Vector<dim> apart;
  for (int c = 0; c < dim; ++c) apart[c] = all[2 * c] + all[2 * c + 1];
  if (norm(apart) > worth_telling * smallest_half_joint) return false;
  double friction = INFINITY, turn = 0;
  for (const auto& joint : model.families())
    if (const double mu = joint.parameters.friction_coefficient; mu > 0) friction = std::min(friction, mu);
  for (int b = 0; b < s.owned_blocks(); ++b) turn = std::max(turn, norm(turn_of(s, b, u)));
  return largest_over_ranks(comm, turn) <= worth_telling * friction;
}

/// The joint that is asked for the largest share of what it bears.
struct WorstJoint {
  BlockId block_i, block_j;
  BlockId turned;  ///< of these the stone that has turned more
  double turn;     ///< [rad] how far
  double share;
  long long others;   ///< joints of which it is worth telling
  bool past_balance;  ///< what stands on some joint is past its point of balance
};

/// For the first rank; none where nothing is worth telling.
template <int dim>
std::vector<WorstJoint> worst_joint(Network<dim>& network, bool in_time) {
  const auto touches = network.touching();
  if (in_time) network.bear_loads();
  const auto share = network.shares();
  const auto worst = static_cast<std::size_t>(std::max_element(share.begin(), share.end()) - share.begin());
  if (share.empty() || !(share[worst] > worth_telling)) return {};
  const auto others = std::count_if(share.begin(), share.end(), [](double s) { return s > worth_telling; }) - 1;
  bool past = false;
  for (std::size_t k = 0; k < share.size(); ++k) past |= share[k] >= past_balance && touches[k];
  const auto turn = [&](BlockId b) { return network.stones[network.stone_of(b)].turn; };
  const auto& r = network.joints[worst];
  const BlockId more = norm(turn(r.block_i)) > norm(turn(r.block_j)) ? r.block_i : r.block_j;
  return {{r.block_i, r.block_j, more, dim == 2 ? turn(more)[2] : norm(turn(more)), share[worst], others, past}};
}

}  // namespace

template <int dim>
RangeFindings look_at_turns(const ModelOfBlocks<dim>& model, const StepEnd& end, double smallest_half_joint) {
  VOUSSOIR_EXPECT(smallest_half_joint > 0 && "half a joint: of some length");
  if (is_followed(model, end) || model.points().total() == 0 || small_motion(model, end, smallest_half_joint))
    return {};
  const auto& comm = *model.structure().comm();
  Network<dim> network(model, end);
  std::vector<WorstJoint> found_first;
  on_first_rank(comm, [&] { found_first = worst_joint(network, end.in_time); });
  const auto told = all_gather(found_first, comm, WhyWhole{"the joint that is worst off"});
  if (told.empty()) return {};
  const auto& worst = told.front();
  const std::string joint = names_of(model, worst.block_i, worst.block_j);
  const std::string what = model.block_name(worst.turned) + " has turned by " + three_digits(worst.turn) + " rad, " +
                           three_digits(100 * worst.share) + " % of what joint " + joint +
                           " can bear before what stands on it topples or slides";
  const std::string advice = end.in_time ? "" : "; model > rotations = finite follows the stones";
  RangeFindings found;
  found.warnings.push_back({"turn_beyond_first_order", joint, end.when, worst.share,
                            what + ": small rotations, which are all that is computed" +
                                (end.in_time ? " in time" : "") + ", overrate what holds it by that share" + advice +
                                and_in_others(static_cast<std::size_t>(worst.others))});
  if (worst.past_balance)
    found.out_of_range = what + ": it is past its point of balance, and small rotations would let it stand" + advice;
  return found;
}

template RangeFindings look_at_turns<2>(const ModelOfBlocks<2>&, const StepEnd&, double);
template RangeFindings look_at_turns<3>(const ModelOfBlocks<3>&, const StepEnd&, double);

}  // namespace voussoir

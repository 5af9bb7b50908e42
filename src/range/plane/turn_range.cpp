#include "range/plane/turn_range.hpp"

#include <array>
#include <cmath>
#include <tuple>

#include "base/check.hpp"
#include "base/text.hpp"
#include "blocks/assembly.hpp"
#include "blocks/rigid_motion.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
#include "model/joint_strength.hpp"
#include "model/plane/plane_model.hpp"
#include "range/plane/joint_network.hpp"
#include "range/plane/stone_places.hpp"

namespace voussoir {
namespace {

// A stone that rocks by the share s of the angle at which it topples is held back by 1 - s of what first order says. Up
// to a tenth that is what cells of a usual size are wrong by; from one on it falls where first order lets it stand.
constexpr double worth_telling = 0.1, past_balance = 1;
// Joints that carry less than this share of the largest force say nothing: that is what solvers leave.
constexpr double negligible = 1e-6;

struct StoneRecord {
  BlockId block;
  bool held;
  double x, y, turn;                           ///< [m] centre of mass as drawn; [rad]
  double load_x, load_y, load_moment, virial;  ///< of the loads: force, moment about the centre, sum of place x force
};

struct JointRecord {
  BlockId block_i, block_j;
  double x, y, normal_x, normal_y, length;  ///< [m] middle as drawn
  double force_x, force_y;                  ///< [N] on block j
  double virial_i, virial_j;                ///< [N m] of its forces about the centres of the two
  double presses;                           ///< [N] sum of what its points bear
  double friction;                          ///< [-]; infinite where a strength bears as well
};

Vector<2> centre_of_mass(const Structure<2>& s, int b) {
  const auto& block = s.blocks()[b];
  const auto volume = nodal_volumes(block.mesh, s.model().thickness);
  Vector<2> sum{};
  double total = 0;
  for (std::size_t n = 0; n < volume.size(); ++n) {
    sum = sum + volume[n] * (s.drawn_position()[block.first_local + n] - s.drawn_position()[block.first_local]);
    total += volume[n];
  }
  return s.drawn_position()[block.first_local] + (1 / total) * sum;
}

double turn_of(const Structure<2>& s, int b, const std::vector<double>& u) {
  return rigid_motion(s.drawn_position(), s.blocks()[b], u).rotation;
}

std::vector<StoneRecord> stones_here(const PlaneModel& model, const StepEnd& end) {
  const auto& s = model.structure();
  std::vector<StoneRecord> stones;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!end.absent.empty() && end.absent[b]) continue;
    const auto& block = s.blocks()[b];
    const auto centre = centre_of_mass(s, b);
    StoneRecord r{
        block.mesh.id, is_held(model, b), centre[0], centre[1], turn_of(s, b, end.state.displacement), 0, 0, 0, 0};
    for (int n = block.first_local; n < block.first_local + static_cast<int>(block.mesh.position.size()); ++n) {
      const Vector<2> f{end.load[2 * n], end.load[2 * n + 1]}, arm = s.drawn_position()[n] - centre;
      r.load_x += f[0], r.load_y += f[1];
      r.load_moment += cross(arm, f);
      r.virial += dot(arm, f);
    }
    stones.push_back(r);
  }
  return stones;
}

std::vector<JointRecord> joints_here(const PlaneModel& model, const StepEnd& end) {
  const auto& s = model.structure();
  const auto& points = model.points();
  std::vector<JointRecord> joints;
  for (int first = 0, last = 0; first < points.owned(); first = last) {
    const int number = points.points()[first].joint;
    const auto& joint = points.joints()[number];
    const auto centre_i = centre_of_mass(s, s.local_block(joint.block_i));
    const auto centre_j = centre_of_mass(s, s.local_block(joint.block_j));
    JointRecord r{joint.block_i, joint.block_j, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, INFINITY};
    Vector<2> normal{}, from_i{};
    double area = 0;
    for (last = first; last < points.owned() && points.points()[last].joint == number; ++last) {
      const auto& p = points.points()[last];
      const auto x = points.at(last).place(Side::i, s.drawn_position());
      const double n = end.state.lambda[2 * last], t = end.state.lambda[2 * last + 1];
      const auto f = in_plane(n * p.axis[0] + t * p.axis[1]);
      const auto law = law_left(model, end.state, last);
      const bool glued = law.cohesion > 0 || law.tension > 0;
      area += p.area;
      normal = normal + p.area * in_plane(p.axis[0]);
      from_i = from_i + p.area * (x - centre_i);
      r.force_x += f[0], r.force_y += f[1];
      r.virial_j += dot(x - centre_j, f);
      r.virial_i -= dot(x - centre_i, f);
      r.presses += glued ? norm(f) : std::max(0.0, n);
      if (!glued) r.friction = std::min(r.friction, law.friction);
    }
    if (!(norm(normal) > 0) || !(area > 0)) continue;
    normal = (1 / norm(normal)) * normal;
    const auto middle = centre_i + (1 / area) * from_i;
    r.x = middle[0], r.y = middle[1], r.normal_x = normal[0], r.normal_y = normal[1];
    r.length = area / s.model().thickness;
    joints.push_back(r);
  }
  return joints;
}

constexpr WhyWhole whole_network{"all stones and joints, of a structure that has moved"};

/// All stones and joints, numbered alike on every rank, as springs.
struct Network {
  std::vector<StoneRecord> stones;
  std::vector<JointRecord> joints;
  std::vector<NetworkJoint> springs;
  std::vector<int> free;  ///< number among those that no support holds, per stone; -1 for the others
  int moving = 0;

  Network(const PlaneModel& model, const StepEnd& end) {
    const auto& comm = *model.structure().comm();
    stones = all_gather(stones_here(model, end), comm, whole_network);
    joints = all_gather(joints_here(model, end), comm, whole_network);
    std::sort(stones.begin(), stones.end(), [](const auto& a, const auto& b) { return a.block < b.block; });
    std::sort(joints.begin(), joints.end(), [](const auto& a, const auto& b) {
      return std::tie(a.block_i, a.block_j) < std::tie(b.block_i, b.block_j);
    });
    for (const auto& stone : stones) free.push_back(stone.held ? -1 : moving++);
    const auto missing = [&](const JointRecord& r) { return stone_of(r.block_i) < 0 || stone_of(r.block_j) < 0; };
    joints.erase(std::remove_if(joints.begin(), joints.end(), missing), joints.end());
    for (const auto& r : joints) {
      const auto i = stone_of(r.block_i), j = stone_of(r.block_j);
      springs.push_back({free[i],
                         free[j],
                         {r.x - stones[i].x, r.y - stones[i].y},
                         {r.x - stones[j].x, r.y - stones[j].y},
                         {r.normal_x, r.normal_y},
                         {}});
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

  /// In time forces come and go with every knock: what joints bear is taken from the loads, joints as springs as long
  /// as they are.
  void bear_loads() {
    std::vector<std::array<double, 3>> load(moving);
    for (std::size_t k = 0; k < stones.size(); ++k)
      if (free[k] >= 0) load[free[k]] = {stones[k].load_x, stones[k].load_y, stones[k].load_moment};
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const double length = joints[k].length;
      springs[k].stiffness = {length, length, length * length * length / 12};
    }
    const auto borne = borne_by_network(moving, springs, load);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      auto& r = joints[k];
      const Vector<2> n = springs[k].normal, f = borne[k][0] * n + borne[k][1] * Vector<2>{-n[1], n[0]};
      r.force_x = f[0], r.force_y = f[1];
      r.virial_i = -dot(springs[k].arm_i, f), r.virial_j = dot(springs[k].arm_j, f);
      r.presses = std::abs(borne[k][0]);
    }
  }

  /// Forces keep their places on stones that turn. The moments -theta r.f that makes are shared out so that joints are
  /// asked for as small a share of what they bear as can be. Returns for each joint that share.
  std::vector<double> shares() {
    std::vector<std::array<double, 3>> moment(moving);
    double largest = 0;
    for (const auto& r : joints) largest = std::max(largest, r.presses);
    std::vector<double> share(joints.size(), 0.0);
    if (!(largest > 0)) return share;
    for (std::size_t k = 0; k < stones.size(); ++k)
      if (free[k] >= 0) moment[free[k]][2] -= stones[k].turn * stones[k].virial / largest;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const auto& r = joints[k];
      const int i = stone_of(r.block_i), j = stone_of(r.block_j);
      if (free[i] >= 0) moment[free[i]][2] -= stones[i].turn * r.virial_i / largest;
      if (free[j] >= 0) moment[free[j]][2] -= stones[j].turn * r.virial_j / largest;
      const double bears = r.presses > negligible * largest ? r.presses / largest : 0.0, arm = bears * r.length / 2;
      springs[k].stiffness = {bears * bears, bears * bears, arm * arm};
    }
    const auto more = borne_by_network(moving, springs, moment);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const auto& r = joints[k];
      if (!(springs[k].stiffness[0] > 0)) continue;
      const double bears = r.presses / largest;
      share[k] = std::max(std::abs(more[k][0]), std::abs(more[k][2]) / (r.length / 2)) / bears;
      // A bed that turns is a slope: what it carries slides when it has turned by the angle of friction.
      const double slope = (stones[stone_of(r.block_i)].turn + stones[stone_of(r.block_j)].turn) / 2;
      if (r.friction > 0) share[k] = std::max(share[k], std::abs(slope) / r.friction);
    }
    return share;
  }
};

/// Nothing can be worth telling as long as stones turn by less than a share of every angle of friction, and nothing
/// moves against anything by that share of half a joint. Collective.
bool small_motion(const PlaneModel& model, const StepEnd& end, double smallest_half_joint) {
  const auto& s = model.structure();
  const auto& comm = *s.comm();
  const auto& u = end.state.displacement;
  std::array<double, 4> range{-INFINITY, -INFINITY, -INFINITY, -INFINITY};  // x, -x, y, -y
  for (int n = 0; n < s.owned_nodes(); ++n)
    for (int c = 0; c < 2; ++c) {
      range[2 * c] = std::max(range[2 * c], u[2 * n + c]);
      range[2 * c + 1] = std::max(range[2 * c + 1], -u[2 * n + c]);
    }
  const auto all = largest_of_each(comm, range);
  if (std::hypot(all[0] + all[1], all[2] + all[3]) > worth_telling * smallest_half_joint) return false;
  double friction = INFINITY, turn = 0;
  for (const auto& joint : model.families())
    if (const double mu = joint.parameters.friction_coefficient; mu > 0) friction = std::min(friction, mu);
  for (int b = 0; b < s.owned_blocks(); ++b) turn = std::max(turn, std::abs(turn_of(s, b, u)));
  return largest_over_ranks(comm, turn) <= worth_telling * friction;
}

/// Which of the two stones of a joint has turned more, how far, and what that is of what the joint can bear.
std::string what_turned(const PlaneModel& model, const Network& network, std::size_t joint, double share) {
  const auto turn = [&](BlockId b) { return network.stones[network.stone_of(b)].turn; };
  const auto& r = network.joints[joint];
  const BlockId more = std::abs(turn(r.block_i)) > std::abs(turn(r.block_j)) ? r.block_i : r.block_j;
  return model.source().block(more).name + " has turned by " + three_digits(turn(more)) + " rad, " +
         three_digits(100 * share) + " % of what joint " + names_of(model, r.block_i, r.block_j) +
         " can bear before what stands on it topples or slides";
}

}  // namespace

RangeFindings look_at_turns(const PlaneModel& model, const StepEnd& end, double smallest_half_joint) {
  VOUSSOIR_EXPECT(smallest_half_joint > 0 && "half a joint: of some length");
  const bool followed = !end.in_time && model.settings().rotations == Rotations::finite;
  if (followed || model.points().total() == 0 || small_motion(model, end, smallest_half_joint)) return {};
  Network network(model, end);
  const auto touches = network.touching();
  if (end.in_time) network.bear_loads();
  const auto share = network.shares();
  const auto worst = static_cast<std::size_t>(std::max_element(share.begin(), share.end()) - share.begin());
  if (share.empty() || !(share[worst] > worth_telling)) return {};
  const auto others = std::count_if(share.begin(), share.end(), [](double s) { return s > worth_telling; }) - 1;
  const std::string what = what_turned(model, network, worst, share[worst]);
  const std::string advice = end.in_time ? "" : "; model > rotations = finite follows the stones";
  const auto& joint = network.joints[worst];
  RangeFindings found;
  found.warnings.push_back(
      {"turn_beyond_first_order", names_of(model, joint.block_i, joint.block_j), end.when, share[worst],
       what + ": small rotations, which are all that is computed" + (end.in_time ? " in time" : "") +
           ", overrate what holds it by that share" + advice + and_in_others(static_cast<std::size_t>(others))});
  for (std::size_t k = 0; k < share.size(); ++k)
    if (share[k] >= past_balance && touches[k]) {
      found.out_of_range = what + ": it is past its point of balance, and small rotations would let it stand" + advice;
      break;
    }
  return found;
}

}  // namespace voussoir

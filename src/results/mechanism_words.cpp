#include "results/mechanism_words.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/text.hpp"
#include "blocks/rigid_motion.hpp"
#include "linalg/gather.hpp"
#include "results/largest_mover.hpp"
#include "statics/round_cone_parameters.hpp"

namespace voussoir {
namespace {

// Blocks and joints that move by less than this share of the largest motion do not take part.
constexpr double noticeable = 0.01;
// Of a motion: round-off of a linear programme.
constexpr double flow = 1e-6;
// So many joints of a kind are named, the widest; the report draws all.
constexpr std::size_t named = 3;

enum Kind { hinges, slides, parts, kinds };
constexpr const char* verbs[] = {"open like hinges", "slide", "part"};

/// A joint that takes part, and by how much [m].
struct MovingJoint {
  int kind;
  BlockId block_i, block_j;
  double size;
};

/// Motion of a block: of its middle, and what its rotation moves its corners by. [m]
template <int dim>
struct BlockMotion {
  BlockId block;
  Vector<dim> way{};
  Vector<dim == 2 ? 1 : 3> turning{};  ///< [m] counter-clockwise; about axes of space
  Vector<dim> middle{};
  double radius = 0;
};

template <std::size_t n>
double size_of(const std::array<double, n>& v) {
  return n == 1 ? std::abs(v[0]) : norm(v);
}

std::vector<MovingJoint> moving_joints(const Model& model, const std::vector<double>& motion, double least) {
  struct Extremes {
    double narrowest = INFINITY, widest = -INFINITY, slip = 0;
    bool dilates = false;  ///< opens by friction times slip where it opens least, by the flow rule of limit analysis
  };
  // Slip that dilates opens by friction times slip, in space up to an edge of the pyramid around the cone.
  const double edge = model.components() == 2 ? 1 : 1 / std::cos(RoundConeParameters::side / 2);
  const auto& points = model.points();
  std::vector<Extremes> of_joint(points.joints().size());
  for (int k = 0; k < points.owned(); ++k) {
    const auto& p = points.points()[k];
    const auto between = points.at(k).motion(motion);
    double slip = std::abs(between[1]);
    for (int c = 2; c < model.components(); ++c) slip = std::hypot(slip, between[c]);
    const double opening = between[0], friction = model.law()[k].friction;
    auto& e = of_joint[p.joint];
    const double off = std::max(friction * slip - opening, opening - edge * friction * slip);
    if (opening < e.narrowest) e.dilates = off <= flow * std::max(std::abs(opening), slip);
    e.narrowest = std::min(e.narrowest, opening);
    e.widest = std::max(e.widest, opening);
    e.slip = std::max(e.slip, slip);
  }
  std::vector<MovingJoint> moving;
  for (std::size_t k = 0; k < of_joint.size(); ++k) {
    const auto& [narrowest, widest, slip, dilates] = of_joint[k];
    const bool flows = dilates && slip > least && widest - narrowest <= slip;
    const int kind = flows ? slides : narrowest > least ? parts : widest > std::max(least, slip) ? hinges : slides;
    const double size = kind == slides ? slip : widest;
    if (size > least) moving.push_back({kind, points.joints()[k].block_i, points.joints()[k].block_j, size});
  }
  return moving;
}

BlockMotion<2> motion_of(const RigidMotion& rigid, double) {
  return {0, rigid.mean, {rigid.rotation * rigid.radius}, rigid.middle, rigid.radius};
}
BlockMotion<3> motion_of(const RigidMotionInSpace& rigid, double radius) {
  return {0, rigid.mean, radius * rigid.rotation, rigid.middle, radius};
}

template <int dim>
std::vector<BlockMotion<dim>> block_motions(const Structure<dim>& s, const std::vector<double>& motion, double least) {
  std::vector<BlockMotion<dim>> moving;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    double largest = 0;
    for (int i = block.first_local; i < block.first_local + block.nodes; ++i) {
      Vector<dim> u;
      for (int c = 0; c < dim; ++c) u[c] = motion[dim * i + c];
      largest = std::max(largest, norm(u));
    }
    if (largest <= least) continue;
    const auto rigid = rigid_motion(s.position(), block, motion);
    double radius = 0;
    for (int i = block.first_local; i < block.first_local + block.nodes; ++i)
      radius = std::max(radius, norm(s.position()[i] - rigid.middle));
    moving.push_back(motion_of(rigid, radius));
    moving.back().block = block.mesh.id;
  }
  return moving;
}

/// Such as "along x", or "along (0.71, 0.71, 0)".
std::string along(const Vector<3>& direction) {
  constexpr double nearly = 0.995;  // of the cosine: within six degrees
  for (int c = 0; c < 3; ++c)
    if (std::abs(direction[c]) > nearly) return std::string("along ") + "xyz"[c];
  const auto hundredths = [](double v) { return six_digits(std::round(100 * v) / 100 + 0.0); };
  return "along (" + hundredths(direction[0]) + ", " + hundredths(direction[1]) + ", " + hundredths(direction[2]) + ")";
}

/// The axis of a turn, and a place where it passes; of one along an axis of the drawing two coordinates.
std::string axis_of(const BlockMotion<3>& m) {
  const auto turn = (1 / m.radius) * m.turning;
  const auto place = m.middle + (1 / dot(turn, turn)) * cross(turn, m.way);
  const auto words = along((1 / norm(turn)) * turn);
  std::string through;
  for (int c = 0; c < 3; ++c) {
    if (words == std::string("along ") + "xyz"[c]) continue;
    const double rounded = std::round(1e3 * place[c] / m.radius) / 1e3 * m.radius;  // a thousandth of the block
    through += (through.empty() ? "" : ", ") + std::string(1, "xyz"[c]) + " = " + three_digits(rounded + 0.0) + " m";
  }
  return "turning about an axis " + words + " through " + through;
}

void add(std::string& words, const std::string& more) { words += (words.empty() ? "" : " and ") + more; }

std::string direction(const BlockMotion<2>& m, double) {
  const double clearly = 0.2 * std::max(size_of(m.way), size_of(m.turning));
  std::string words;
  if (std::abs(m.way[1]) > clearly) add(words, m.way[1] > 0 ? "up" : "down");
  if (std::abs(m.way[0]) > clearly) add(words, m.way[0] > 0 ? "to the right" : "to the left");
  if (std::abs(m.turning[0]) > clearly)
    add(words, m.turning[0] > 0 ? "turning counter-clockwise" : "turning clockwise");
  return words;
}

/// A turn is told where it moves the structure by as much as the block goes: about an axis far from it as well.
/// @param size  [m] of the structure
std::string direction(const BlockMotion<3>& m, double size) {
  const double clearly = 0.2 * std::max(size_of(m.way), size_of(m.turning));
  std::string words;
  if (std::abs(m.way[2]) > clearly) add(words, m.way[2] > 0 ? "up" : "down");
  for (int c = 0; c < 2; ++c)
    if (std::abs(m.way[c]) > clearly) add(words, std::string("towards ") + (m.way[c] > 0 ? "+" : "-") + "xy"[c]);
  if (size_of(m.turning) * size > clearly * m.radius) add(words, axis_of(m));
  return words;
}

/// How many blocks move, and which of them how.
template <int dim>
std::string of_blocks(const Model& model, const Structure<dim>& s, const std::vector<double>& motion, double least,
                      const MechanismSummary& most) {
  const auto blocks = all_gather(block_motions(s, motion, least), *s.comm(), WhyWhole{"blocks of a mechanism"});
  const bool one = blocks.size() == 1;
  const auto all = model.block_count();
  std::string words = all == 1 ? "the block moves, "
                               : std::to_string(blocks.size()) + " of " + std::to_string(all) +
                                     (one ? " blocks moves, " : " blocks move, ");
  words += most.name + (one ? ": " : " most, ");
  for (const auto& block : blocks)
    if (block.block == most.largest_mover) words += direction(block, s.size());
  return words;
}

}  // namespace

std::string of_slip_that_dilates(bool dilates) {
  return dilates ? "; this is the motion of slip that dilates, by which limit analysis proves the limit: what slides "
                   "rises by friction times its slip, and the structure itself moves otherwise"
                 : "";
}

std::string mechanism_in_words(const Model& model, const std::vector<double>& motion) {
  const auto& comm = *model.structure().comm();
  const auto most = largest_mover(model, motion);
  const double least = noticeable * most.largest_displacement;
  auto joints = all_gather(moving_joints(model, motion, least), comm, WhyWhole{"joints of a mechanism"});
  // By size; equal ones by their blocks, whatever ranks they came from.
  std::sort(joints.begin(), joints.end(), [](const MovingJoint& a, const MovingJoint& b) {
    return std::make_tuple(-a.size, a.block_i, a.block_j) < std::make_tuple(-b.size, b.block_i, b.block_j);
  });
  const auto name = [&](BlockId b) { return model.block_name(b); };
  auto words = model.in_geometry([&](const auto&, const auto& s) { return of_blocks(model, s, motion, least, most); });
  for (int kind = 0; kind < kinds; ++kind) {
    std::size_t count = 0;
    std::string list;
    for (const auto& joint : joints)
      if (joint.kind == kind && count++ < named)
        list += (count > 1 ? ", " : "") + name(joint.block_i) + " / " + name(joint.block_j);
    if (count > named) list += " and " + std::to_string(count - named) + " more";
    if (count > 0) words += "; joints that " + std::string(verbs[kind]) + ": " + list;
  }
  return words;
}

}  // namespace voussoir

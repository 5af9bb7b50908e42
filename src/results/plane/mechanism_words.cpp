#include "results/plane/mechanism_words.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "blocks/rigid_motion.hpp"
#include "linalg/gather.hpp"
#include "model/plane/plane_model.hpp"
#include "results/largest_mover.hpp"

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
struct BlockMotion {
  BlockId block;
  double right, up, turning;
};

std::vector<MovingJoint> moving_joints(const Model& model, const std::vector<double>& motion, double least) {
  struct Extremes {
    double narrowest = INFINITY, widest = -INFINITY, slip = 0;
    bool dilates = false;  ///< opens by friction times slip where it opens least, by the flow rule of limit analysis
  };
  const auto& points = model.points();
  std::vector<Extremes> of_joint(points.joints().size());
  for (int k = 0; k < points.owned(); ++k) {
    const auto& p = points.points()[k];
    const auto between = points.at(k).motion(motion);
    const double opening = between[0], slip = between[1];
    auto& e = of_joint[p.joint];
    const double off = std::abs(opening - model.law()[k].friction * std::abs(slip));
    if (opening < e.narrowest) e.dilates = off <= flow * std::max(std::abs(opening), std::abs(slip));
    e.narrowest = std::min(e.narrowest, opening);
    e.widest = std::max(e.widest, opening);
    e.slip = std::max(e.slip, std::abs(slip));
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

std::vector<BlockMotion> block_motions(const Model& model, const std::vector<double>& motion, double least) {
  const auto& s = plane_geometry(model).structure;
  std::vector<BlockMotion> moving;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    const int first = block.first_local, count = static_cast<int>(block.mesh.position.size());
    double largest = 0;
    for (int i = first; i < first + count; ++i)
      largest = std::max(largest, std::hypot(motion[2 * i], motion[2 * i + 1]));
    if (largest <= least) continue;
    const RigidMotion rigid = rigid_motion(s.position(), block, motion);
    moving.push_back({block.mesh.id, rigid.mean[0], rigid.mean[1], rigid.rotation * rigid.radius});
  }
  return moving;
}

std::string direction(const BlockMotion& m) {
  const double way = std::hypot(m.right, m.up), clearly = 0.2 * std::max(way, std::abs(m.turning));
  std::string words;
  const auto add = [&](const char* word) { words += (words.empty() ? "" : " and ") + std::string(word); };
  if (std::abs(m.up) > clearly) add(m.up > 0 ? "up" : "down");
  if (std::abs(m.right) > clearly) add(m.right > 0 ? "to the right" : "to the left");
  if (std::abs(m.turning) > clearly) add(m.turning > 0 ? "turning counter-clockwise" : "turning clockwise");
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
  const auto blocks = all_gather(block_motions(model, motion, least), comm);
  auto joints = all_gather(moving_joints(model, motion, least), comm);
  // By size; equal ones by their blocks, whatever ranks they came from.
  std::sort(joints.begin(), joints.end(), [](const MovingJoint& a, const MovingJoint& b) {
    return std::make_tuple(-a.size, a.block_i, a.block_j) < std::make_tuple(-b.size, b.block_i, b.block_j);
  });
  const auto name = [&](BlockId b) { return model.block_name(b); };
  const bool one = blocks.size() == 1;
  std::string words = std::to_string(blocks.size()) + " of " + std::to_string(model.block_count()) +
                      (one ? " blocks moves, " : " blocks move, ") + most.name + (one ? ": " : " most, ");
  for (const auto& block : blocks)
    if (block.block == most.largest_mover) words += direction(block);
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

#include "range/plane/coarse_joints.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/check.hpp"
#include "base/text.hpp"
#include "joints/coarse_joint.hpp"
#include "linalg/gather.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"
#include "model/plane/plane_model.hpp"

namespace voussoir {
namespace {

// What is overrated by less is within what meshes cost anyway.
constexpr double worth_saying = 0.05;
constexpr std::size_t most_points = cells_of_a_fine_joint;  // of a joint with fewer cells
// Points of a straight joint have one direction; the cosine of five degrees.
constexpr double straight = 0.996;

/// A joint that may be overrated.
struct Found {
  int family = 0;
  BlockId block_i = 0, block_j = 0;
  CoarseJoint joint;
};

/// Of the joints whose block i this rank owns; all points of a joint are with its owner.
std::vector<Found> found_here(const PlaneModel& model, const ContactState& state) {
  const auto& points = model.points();
  std::vector<std::vector<int>> of_joint(points.joints().size());
  for (int k = 0; k < points.owned(); ++k) of_joint[points.points()[k].joint].push_back(k);
  std::vector<Found> all;
  for (std::size_t j = 0; j < of_joint.size(); ++j) {
    const auto& here = of_joint[j];
    const auto& joint = points.joints()[j];
    const auto& law = model.families()[joint.family].parameters;
    if (here.size() < 2 || here.size() > most_points || !model.weakens() || !model.softening()[here[0]].brittle())
      continue;
    const auto& axis = points.points()[here[0]].axis;
    std::vector<BrittlePoint> brittle;
    bool bent = false;
    for (const int k : here) {
      const auto& p = points.points()[k];
      bent |= dot(p.axis[0], axis[0]) < straight;
      const auto place = points.at(k).place(Side::i, model.structure().position());
      brittle.push_back({dot(place, in_plane(axis[1])), p.area, state.lambda[2 * k], state.lambda[2 * k + 1],
                         damage_of(model, state, k) == 1});
    }
    if (bent) continue;
    const auto coarse = coarse_joint(brittle, law.tension_strength, law.cohesion, law.friction_coefficient);
    if (coarse.overrating > worth_saying) all.push_back({joint.family, joint.block_i, joint.block_j, coarse});
  }
  return all;
}

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

}  // namespace

Warnings coarse_joints(const PlaneModel& model, const ContactState& state, const std::string& when) {
  VOUSSOIR_EXPECT(is_of_points(model, state.lambda) && "lambda: of points");
  std::map<int, std::vector<Found>> families;
  for (const auto& found :
       all_gather(found_here(model, state), *model.structure().comm(), WhyWhole{"joints too coarse to tell"}))
    families[found.family].push_back(found);
  Warnings all;
  for (const auto& [family, found] : families) {
    // The first in the order of blocks among equals, so that ranks do not matter.
    const auto worst = std::min_element(found.begin(), found.end(), [](const Found& a, const Found& b) {
      if (a.joint.overrating != b.joint.overrating) return a.joint.overrating > b.joint.overrating;
      return std::make_pair(a.block_i, a.block_j) < std::make_pair(b.block_i, b.block_j);
    });
    const auto& joint = worst->joint;
    std::string text = "joint " + std::to_string(worst->block_i) + " - " + std::to_string(worst->block_j) + " has " +
                       std::to_string(joint.cells) + (joint.cells == 1 ? " cell" : " cells") + " along it";
    text += joint.edge_use > 0 ? " and comes to " + percent(joint.point_use) +
                                     " of its strength at its points, by stress linear along it to " +
                                     percent(joint.edge_use) + " at its edge"
                               : " and has broken";
    text += ": its strength may be overrated by " + percent(joint.overrating);
    if (found.size() > 1) text += ", that of " + std::to_string(found.size() - 1) + " others of the family by less";
    text += "; give it six cells or more";
    all.push_back({"coarse_joint", "scene > joints > " + model.families()[family].name, when, joint.overrating, text});
  }
  return all;
}

}  // namespace voussoir

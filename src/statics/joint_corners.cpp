#include "statics/joint_corners.hpp"

#include <algorithm>
#include <cmath>

#include "base/convex_hull.hpp"
#include "statics/limit_analysis_parameters.hpp"

namespace voussoir {
namespace {

using Numbers = LimitAnalysisParameters;
using Contacts = std::vector<int>;

template <int dim>
const RigidContact<dim>& at(const RigidStructure<dim>& s, int k) {
  return s.contacts[static_cast<std::size_t>(k)];
}

template <int dim>
double flat(const RigidStructure<dim>& s, const RigidContact<dim>& c) {
  return Numbers::straight * s.stones[static_cast<std::size_t>(c.stone_i)].radius;
}

/// Whether contacts are dry and on one line, or in one plane.
template <int dim>
bool on_a_face(const RigidStructure<dim>& s, const Contacts& joint) {
  const auto& a = at(s, joint.front());
  const double off = flat(s, a);
  return std::all_of(joint.begin(), joint.end(), [&](int k) {
    const auto& c = at(s, k);
    // In space stones may have turned against each other about the normal: then no force is shared alike on both.
    const bool parted = dim == 3 && length((c.arm_j - a.arm_j) - (c.arm_i - a.arm_i)) > off;
    return dry(c.law) && c.law.friction == a.law.friction && norm(c.axis[0] - a.axis[0]) <= Numbers::straight &&
           !parted && std::abs(dot(c.arm_i - a.arm_i, a.axis[0])) <= off &&
           std::abs(dot(c.arm_j - a.arm_j, a.axis[0])) <= off;
  });
}

Contacts corners(const RigidStructure<2>& s, const Contacts& joint) {
  const auto tangent = at(s, joint.front()).axis[1];
  const auto ends = std::minmax_element(joint.begin(), joint.end(), [&](int a, int b) {
    return dot(at(s, a).arm_i, tangent) < dot(at(s, b).arm_i, tangent);
  });
  return {*ends.first, *ends.second};
}

/// Those of the convex hull.
Contacts corners(const RigidStructure<3>& s, const Contacts& joint) {
  const auto& a = at(s, joint.front());
  std::vector<Vector<2>> places;
  for (const int k : joint) places.push_back(tangential(on_axes(a, at(s, k).arm_i - a.arm_i)));
  Contacts found;
  for (const int corner : convex_hull(places, flat(s, a))) found.push_back(joint[static_cast<std::size_t>(corner)]);
  return found;
}

}  // namespace

template <int dim>
JointCorners joint_corners(const RigidStructure<dim>& s) {
  JointCorners all;
  Contacts order(s.contacts.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return at(s, a).joint < at(s, b).joint; });
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && at(s, order[last]).joint == at(s, order[first]).joint) ++last;
    const Contacts joint(order.begin() + static_cast<long>(first), order.begin() + static_cast<long>(last));
    const bool narrows = joint.size() > 1 && on_a_face(s, joint);
    const auto kept = narrows ? corners(s, joint) : joint;
    const int begin = static_cast<int>(all.kept.size()), count = static_cast<int>(kept.size());
    all.kept.insert(all.kept.end(), kept.begin(), kept.end());
    for (int k = 0; k < count; ++k) {
      all.first.push_back(narrows ? begin : begin + k);
      all.count.push_back(narrows ? count : 1);
    }
  }
  return all;
}

template JointCorners joint_corners(const RigidStructure<2>&);
template JointCorners joint_corners(const RigidStructure<3>&);

}  // namespace voussoir

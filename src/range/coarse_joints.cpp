#include "range/coarse_joints.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/check.hpp"
#include "base/convex_hull.hpp"
#include "base/plane_and_space.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "joints/joint_facets.hpp"
#include "linalg/gather.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"

namespace voussoir {
namespace {

// What is overrated by less is within what meshes cost anyway.
constexpr double worth_saying = 0.05;
// Points of a plane joint have one direction; the cosine of five degrees.
constexpr double straight = 0.996;
// Of the extent of a joint: what is beside a line by less is on it.
constexpr double round_off_of_places = 1e-9;

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

std::string cells_in_words(const JointSection& section) {
  if (section.axes() == 1) return counted(section.cells[0], "cell");
  return std::to_string(section.cells[0]) + " x " + std::to_string(section.cells[1]) + " cells";
}

/// Of a joint of the plane: its points stand for pieces of a line.
JointSection section_of(const std::vector<Vector<2>>& place, const std::vector<double>& share) {
  JointSection section;
  double first = place[0][0], last = first;
  for (std::size_t k = 0; k < place.size(); ++k) {
    section.area += share[k];
    section.middle = section.middle + share[k] * place[k];
    first = std::min(first, place[k][0]);
    last = std::max(last, place[k][0]);
  }
  section.middle = (1 / section.area) * section.middle;
  section.length[0] = last - first;
  section.second_moment[0][0] = section.area * section.length[0] * section.length[0] / 12;
  section.cells[0] = static_cast<int>(place.size()) - 1;
  return section;
}

/// Adds a triangle to the integrals of 1, x and x x over a section; its middle is not yet divided by the area.
void add_triangle(const std::array<Vector<2>, 3>& x, JointSection& section) {
  const double area = std::abs(cross(x[1] - x[0], x[2] - x[0])) / 2;
  const auto sum = x[0] + x[1] + x[2];
  section.area += area;
  section.middle = section.middle + (area / 3) * sum;
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 2; ++c) {
      double squares = sum[r] * sum[c];
      for (const auto& corner : x) squares += corner[r] * corner[c];
      section.second_moment[r][c] += area / 12 * squares;
    }
}

/// Of a joint in space: the sum of its facets. Cells along an axis are as many as facets of a mean extent fill it with.
JointSection section_of(const std::vector<Vector<2>>& place, const std::vector<FacetOfJoint<3>>& facets,
                        const Vector<2>& length) {
  JointSection section;
  section.length = length;
  Vector<2> extent{};
  for (const auto& facet : facets) {
    const double before = section.area;
    std::array<Vector<2>, 4> x;
    for (std::size_t c = 0; c < x.size(); ++c) x[c] = place[static_cast<std::size_t>(facet[c])];
    add_triangle({x[0], x[1], x[2]}, section);
    add_triangle({x[0], x[2], x[3]}, section);
    for (std::size_t a = 0; a < 2; ++a) {
      const auto ends = std::minmax({x[0][a], x[1][a], x[2][a], x[3][a]});
      extent[a] += (section.area - before) * (ends.second - ends.first);
    }
  }
  if (!(section.area > 0)) return section;
  section.middle = (1 / section.area) * section.middle;
  for (std::size_t r = 0; r < 2; ++r) {
    for (std::size_t c = 0; c < 2; ++c)
      section.second_moment[r][c] -= section.area * section.middle[r] * section.middle[c];
    section.cells[r] = std::max(1, static_cast<int>(std::lround(length[r] * section.area / extent[r])));
  }
  return section;
}

}  // namespace

/// A joint that may be overrated.
template <int dim>
struct CoarseJoints<dim>::Found {
  int family = 0;
  BlockId block_i = 0, block_j = 0;
  JointSection section;
  CoarseJoint joint;
};

template <int dim>
CoarseJoints<dim>::CoarseJoints(const ModelOfBlocks<dim>& model) : model_(model) {
  if (!model.weakens()) return;
  const auto& points = model.points();
  std::vector<std::vector<int>> of_joint(points.joints().size());
  for (int k = 0; k < points.owned(); ++k) of_joint[points.points()[k].joint].push_back(k);
  std::vector<std::vector<FacetOfJoint<dim>>> facets(of_joint.size());
  if constexpr (dim == 3) facets = facets_of_joints(model.source(), model.structure(), points);
  for (std::size_t j = 0; j < of_joint.size(); ++j) {
    const auto& here = of_joint[j];
    if (here.size() < dim || !model.softening()[here[0]].brittle()) continue;
    const auto& normal = points.points()[here[0]].axis[0];
    const bool bent = std::any_of(here.begin(), here.end(),
                                  [&](int k) { return dot(points.points()[k].axis[0], normal) < straight; });
    if (!bent) add(static_cast<int>(j), here, facets[j]);
  }
}

template <int dim>
void CoarseJoints<dim>::add(int joint, const std::vector<int>& points, const std::vector<FacetOfJoint<dim>>& facets) {
  const auto place = [&](int k) {
    return in_space(model_.points().at(k).place(Side::i, model_.structure().drawn_position()));
  };
  const auto& axis = model_.points().points()[points[0]].axis;
  Candidate found{joint, {}, points, {}, {}};
  std::vector<double> share;
  for (const int k : points) {
    const auto arm = place(k) - place(points[0]);
    found.place.push_back({dot(arm, axis[1]), dim == 2 ? 0.0 : dot(arm, axis[2])});
    share.push_back(model_.points().points()[k].area);
  }
  Vector<2> along{1, 0};
  if constexpr (dim == 3) {
    const auto around = least_rectangle(found.place, round_off_of_places);
    along = around.along;
    for (auto& x : found.place) x = {dot(along, x), cross(along, x)};
    found.section = section_of(found.place, facets, around.length);
  } else {
    found.section = section_of(found.place, share);
  }
  if (!(found.section.area > 0) || found.section.is_fine()) return;
  const std::array<Vector<3>, 2> own{along[0] * axis[1] + along[1] * axis[2], along[0] * axis[2] - along[1] * axis[1]};
  for (const int k : points) {
    const auto& p = model_.points().points()[k];
    found.tangent.push_back({});
    for (int a = 0; a + 1 < dim; ++a)
      for (int c = 0; c + 1 < dim; ++c) found.tangent.back()[a][c] = dot(p.axis[a + 1], own[c]);
  }
  candidates_.push_back(std::move(found));
}

template <int dim>
CoarseJoint CoarseJoints<dim>::look_at(const Candidate& candidate, const ContactState& state) const {
  const auto& joint = model_.points().joints()[candidate.joint];
  const auto& law = model_.families()[joint.family].parameters;
  std::vector<BrittlePoint> brittle;
  for (std::size_t n = 0; n < candidate.points.size(); ++n) {
    const int k = candidate.points[n];
    const double* const force = &state.lambda[dim * static_cast<std::size_t>(k)];
    BrittlePoint p;
    p.place = candidate.place[n];
    p.area = model_.points().points()[k].area;
    p.normal_force = force[0];
    for (int a = 1; a < dim; ++a) p.shear = p.shear + force[a] * candidate.tangent[n][a - 1];
    p.opened = state.opened[k];
    p.broken = damage_of(model_, state, k) == 1;
    brittle.push_back(p);
  }
  return coarse_joint(candidate.section, brittle, law.tension_strength, law.cohesion, law.friction_coefficient);
}

template <int dim>
std::vector<typename CoarseJoints<dim>::Found> CoarseJoints<dim>::found_here(const ContactState& state) const {
  std::vector<Found> all;
  for (const auto& candidate : candidates_) {
    const auto coarse = look_at(candidate, state);
    const auto& joint = model_.points().joints()[candidate.joint];
    if (coarse.overrating > worth_saying)
      all.push_back({joint.family, joint.block_i, joint.block_j, candidate.section, coarse});
  }
  return all;
}

template <int dim>
Warnings CoarseJoints<dim>::look(const ContactState& state, const std::string& when) const {
  VOUSSOIR_EXPECT(is_of_points(model_, state.lambda) && "lambda: of points");
  if (!model_.weakens()) return {};
  std::map<int, std::vector<Found>> families;
  for (const auto& found :
       all_gather(found_here(state), *model_.structure().comm(), WhyWhole{"joints too coarse to tell"}))
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
                       cells_in_words(worst->section) + " along it";
    text += joint.edge_use > 0 ? " and comes to " + percent(joint.point_use) +
                                     " of its strength at its points, by stress linear along it to " +
                                     percent(joint.edge_use) + " at its edge"
                               : " and has broken";
    // Beyond twice the strength the share that is left says more.
    text += joint.overrating > 1
                ? ": it may bear as little as " + percent(1 / (1 + joint.overrating)) + " of what its points do"
                : ": its strength may be overrated by " + percent(joint.overrating);
    if (found.size() > 1) text += ", that of " + counted(found.size() - 1, "other") + " of the family by less";
    text += "; give it six cells or more";
    all.push_back({"coarse_joint", "scene > joints > " + model_.families()[family].name, when, joint.overrating, text});
  }
  return all;
}

template class CoarseJoints<2>;
template class CoarseJoints<3>;

}  // namespace voussoir

#include "results/masonry_statics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "base/plane_and_space.hpp"
#include "joints/joint_facets.hpp"
#include "linalg/agree.hpp"
#include "linalg/parcels.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"
#include "output/joint_table.hpp"
#include "output/output_folder.hpp"
#include "output/safe_file.hpp"
#include "results/support_reactions.hpp"

namespace voussoir {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// Joints that carry less than this share of the largest normal force say nothing: that is what solvers leave.
constexpr double negligible = 1e-6;
// Elastic stones open a little at the joints beside a hinge: less than this share of the widest hinge is no other one.
constexpr double beside_a_hinge = 0.05;
constexpr std::size_t longest_list = 50;  // in result.json; all are in joints.csv

/// A point as joint_statics asks for it.
template <int dim>
PointOfJoint<dim> point_of_joint(const ModelOfBlocks<dim>& model, const ContactState& state, double gap, int k) {
  const auto& p = model.points().points()[k];
  const double* const force = &state.lambda[dim * static_cast<std::size_t>(k)];
  PointOfJoint<dim> point;
  point.position = model.points().at(k).place(Side::i, model.structure().position());
  point.normal = in_dimension<dim>(p.axis[0]);
  point.normal_force = force[0];
  if constexpr (dim == 2)
    point.shear = force[1];
  else
    point.shear = force[1] * p.axis[1] + force[2] * p.axis[2];
  point.gap = gap;
  point.law = law_left(model, state, k);
  point.area = p.area;
  return point;
}

/// Rows of the joints whose block i this rank owns; all points of a joint are with its owner.
template <int dim>
std::vector<JointRow> rows_here(const ModelOfBlocks<dim>& model, const AdaptiveStep& step, const ContactState& state) {
  const auto& points = model.points();
  const auto gap = step.stone_gaps(state);
  std::vector<std::vector<PointOfJoint<dim>>> of_joint(points.joints().size());
  std::vector<double> area(of_joint.size(), 0.0), lost(of_joint.size(), 0.0);  // [m2]
  std::vector<char> joined(of_joint.size(), 1);                                // both stones are there
  for (int k = 0; k < points.owned(); ++k) {
    const auto& p = points.points()[k];
    area[p.joint] += p.area;
    joined[p.joint] = model.joined(k);
    lost[p.joint] += p.area * damage_of(model, state, k);
    of_joint[p.joint].push_back(point_of_joint(model, state, gap[dim * static_cast<std::size_t>(k)], k));
  }
  const auto facets = facets_of_joints(model.source(), model.structure(), points);
  std::vector<JointRow> rows;
  for (std::size_t k = 0; k < of_joint.size(); ++k) {
    if (of_joint[k].empty()) continue;
    const auto& joint = points.joints()[k];
    const auto s = joint_statics(of_joint[k], facets[k]);
    rows.push_back({joint.block_i,
                    joint.block_j,
                    in_space(s.middle),
                    s.extent,
                    in_space(s.force),
                    s.normal_force,
                    s.shear,
                    s.twist,
                    in_space(s.place),
                    s.eccentricity,
                    s.edge_margin,
                    in_space(s.edge),
                    s.friction_margin,
                    in_space(s.least_shear),
                    s.opening,
                    lost[k] / area[k],
                    s.pressing,
                    s.sides,
                    s.hinge,
                    s.slides});
    if (!joined[k]) rows.back().opening = rows.back().damage = nan;
  }
  return rows;
}

/// Rows of all ranks by blocks, on the first rank; nothing is said of joints that carry next to nothing.
template <int dim>
std::vector<JointRow> all_rows(const ModelOfBlocks<dim>& model, const AdaptiveStep& step, const ContactState& state) {
  auto rows = gather_on_first(rows_here(model, step, state), *model.structure().comm());
  std::sort(rows.begin(), rows.end(), [](const JointRow& a, const JointRow& b) {
    return std::make_pair(a.block_i, a.block_j) < std::make_pair(b.block_i, b.block_j);
  });
  double largest = 0;
  for (const auto& row : rows) largest = std::max(largest, row.pressing);
  for (auto& row : rows) {
    if (row.pressing > negligible * largest) continue;
    row.eccentricity = row.edge_margin = row.friction_margin = nan;
    row.through = row.edge = row.least_shear = {nan, nan, nan};
    row.hinge = row.slides = 0;
  }
  double widest = 0;
  for (const auto& row : rows)
    if (row.hinge) widest = std::max(widest, row.opening);
  for (auto& row : rows) row.hinge = row.hinge && row.opening >= beside_a_hinge * widest;
  return rows;
}

}  // namespace

template <int dim>
StaticsSummary write_statics(const ModelOfBlocks<dim>& model, const AdaptiveStep& step, const ContactState& state,
                             const std::vector<double>& load, const std::string& folder) {
  expect_state(model, state);
  const auto rows = all_rows(model, step, state);
  on_first_rank(*model.structure().comm(), [&] { replace_file(folder + "/" + joints_file, joint_table(rows, dim)); });
  StaticsSummary sum;
  sum.components = dim;
  sum.least_edge_margin = sum.least_friction_margin = nan;
  for (const auto& row : rows) {
    sum.hinges += row.hinge;
    sum.sliding_joints += row.slides;
    sum.least_edge_margin = std::fmin(sum.least_edge_margin, row.edge_margin);  // the number, where one is none
    sum.least_friction_margin = std::fmin(sum.least_friction_margin, row.friction_margin);
    // Resultants of points that pull and press may cross the plane of their joint anywhere; a motion is at the joint.
    if (row.hinge) sum.widest_hinges.push_back({row.block_i, row.block_j, row.edge, row.opening});
    if (row.slides && sum.first_sliding.size() < longest_list)
      sum.first_sliding.push_back({row.block_i, row.block_j, row.least_shear, row.opening});
  }
  std::stable_sort(sum.widest_hinges.begin(), sum.widest_hinges.end(),
                   [](const auto& a, const auto& b) { return a.opening > b.opening; });
  if (sum.widest_hinges.size() > longest_list) sum.widest_hinges.resize(longest_list);
  sum.reactions = support_reactions(model, step.residual(state, load));
  return sum;
}

template StaticsSummary write_statics(const ModelOfBlocks<2>&, const AdaptiveStep&, const ContactState&,
                                      const std::vector<double>&, const std::string&);
template StaticsSummary write_statics(const ModelOfBlocks<3>&, const AdaptiveStep&, const ContactState&,
                                      const std::vector<double>&, const std::string&);

}  // namespace voussoir

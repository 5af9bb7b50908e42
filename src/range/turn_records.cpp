#include "range/turn_records.hpp"

#include <algorithm>
#include <cmath>

#include "base/convex_hull.hpp"
#include "base/plane_and_space.hpp"
#include "blocks/assembly.hpp"
#include "blocks/rigid_motion.hpp"
#include "model/joint_strength.hpp"
#include "model/loads_at_work.hpp"
#include "range/stone_names.hpp"

namespace voussoir {
namespace {

template <int dim>
Vector<3> field_at(const std::vector<double>& field, int node) {
  Vector<3> v{};
  std::copy_n(field.begin() + static_cast<long>(dim) * node, dim, v.begin());
  return v;
}

template <int dim>
Vector<3> centre_of_mass(const Structure<dim>& s, int b) {
  const auto& block = s.blocks()[b];
  const auto volume = nodal_volumes(block.mesh, block.material, s.model());
  Vector<dim> sum{};
  double total = 0;
  for (std::size_t n = 0; n < volume.size(); ++n) {
    sum = sum + volume[n] * (s.drawn_position()[block.first_local + n] - s.drawn_position()[block.first_local]);
    total += volume[n];
  }
  return in_space(s.drawn_position()[block.first_local] + (1 / total) * sum);
}

/// The axes of the least rectangle around the points of a joint, and half its sides, made as small as the joint is.
void find_lengths(const std::vector<Vector<3>>& arms, JointRecord& r) {
  constexpr double round_off = 1e-9;  // of the joint
  const auto t = r.axis[1], u = r.axis[2];
  std::vector<Vector<2>> places;
  for (const auto& arm : arms) places.push_back({dot(arm, t), dot(arm, u)});
  const auto around = least_rectangle(places, round_off);
  r.axis[1] = around.along[0] * t + around.along[1] * u;
  r.axis[2] = cross(r.axis[0], r.axis[1]);
  if (!(around.area() > 0)) return;
  for (std::size_t a = 0; a < 2; ++a) r.half[a] = around.length[a] / 2 * std::sqrt(r.area / around.area());
}

/// What the points of a joint bear, about the centres of its stones.
template <int dim>
void add_forces(const ModelOfBlocks<dim>& model, const StepEnd& end, int first, int last,
                const std::array<Vector<3>, 2>& centre, JointRecord& r) {
  const auto& s = model.structure();
  for (int k = first; k < last; ++k) {
    const auto& p = model.points().points()[k];
    const auto x = in_space(model.points().at(k).place(Side::i, s.drawn_position()));
    Vector<3> f{};
    for (int a = 0; a < dim; ++a) f = f + end.state.lambda[dim * k + a] * p.axis[a];
    const auto law = law_left(model, end.state, k);
    const bool glued = law.cohesion > 0 || law.tension > 0;
    r.force = r.force + f;
    add_virial(x - centre[1], f, r.virial_j);
    add_virial(x - centre[0], -1.0 * f, r.virial_i);
    r.presses += glued ? norm(f) : std::max(0.0, end.state.lambda[dim * k]);
    if (!glued) r.friction = std::min(r.friction, law.friction);
  }
}

}  // namespace

Vector<3> turn_of(const Structure<2>& s, int b, const std::vector<double>& u) {
  return {0, 0, rigid_motion(s.drawn_position(), s.blocks()[b], u).rotation};
}

Vector<3> turn_of(const Structure<3>& s, int b, const std::vector<double>& u) {
  return rigid_motion(s.drawn_position(), s.blocks()[b], u).rotation;
}

template <int dim>
std::vector<StoneRecord> stones_here(const ModelOfBlocks<dim>& model, const StepEnd& end) {
  const auto& s = model.structure();
  const auto turning = model.loads_at_work().turning(end.loads, s);
  std::vector<StoneRecord> stones;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!end.absent.empty() && end.absent[b]) continue;
    const auto& block = s.blocks()[b];
    StoneRecord r{
        block.mesh.id, is_held(model, b), centre_of_mass(s, b), turn_of(s, b, end.state.displacement), {}, {}, {}};
    for (int n = block.first_local; n < block.first_local + block.nodes; ++n) {
      const auto f = field_at<dim>(end.load, n), arm = in_space(s.drawn_position()[n]) - r.centre;
      r.load = r.load + f;
      r.load_moment = r.load_moment + cross(arm, f);
      add_virial(arm, turning.empty() ? f : f - field_at<dim>(turning, n), r.virial);
    }
    stones.push_back(r);
  }
  return stones;
}

template <int dim>
std::vector<JointRecord> joints_here(const ModelOfBlocks<dim>& model, const StepEnd& end) {
  const auto& s = model.structure();
  const auto& points = model.points();
  std::vector<JointRecord> joints;
  for (int first = 0, last = 0; first < points.owned(); first = last) {
    const int number = points.points()[first].joint;
    const auto& joint = points.joints()[number];
    const std::array<Vector<3>, 2> centre{centre_of_mass(s, s.local_block(joint.block_i)),
                                          centre_of_mass(s, s.local_block(joint.block_j))};
    JointRecord r{joint.block_i, joint.block_j, {}, {}, 0, {}, {}, {}, {}, 0, INFINITY};
    std::vector<Vector<3>> arms;
    Vector<3> normal{}, from_i{};
    for (last = first; last < points.owned() && points.points()[last].joint == number; ++last) {
      const auto& p = points.points()[last];
      arms.push_back(in_space(points.at(last).place(Side::i, s.drawn_position())) - centre[0]);
      r.area += p.area;
      normal = normal + p.area * p.axis[0];
      from_i = from_i + p.area * arms.back();
    }
    if (!(norm(normal) > 0) || !(r.area > 0)) continue;
    r.axis[0] = (1 / norm(normal)) * normal;
    const auto middle = (1 / r.area) * from_i;
    r.middle = centre[0] + middle;
    add_forces(model, end, first, last, centre, r);
    if constexpr (dim == 2) {
      r.axis[1] = {-r.axis[0][1], r.axis[0][0], 0};
      r.area /= joint.thickness;
      r.half[0] = r.area / 2;
    } else {
      const auto& any = points.points()[first].axis[1];
      const auto tangent = any - dot(any, r.axis[0]) * r.axis[0];
      r.axis[1] = (1 / norm(tangent)) * tangent;
      r.axis[2] = cross(r.axis[0], r.axis[1]);
      for (auto& arm : arms) arm = arm - middle;
      find_lengths(arms, r);
    }
    joints.push_back(r);
  }
  return joints;
}

template std::vector<StoneRecord> stones_here(const ModelOfBlocks<2>&, const StepEnd&);
template std::vector<StoneRecord> stones_here(const ModelOfBlocks<3>&, const StepEnd&);
template std::vector<JointRecord> joints_here(const ModelOfBlocks<2>&, const StepEnd&);
template std::vector<JointRecord> joints_here(const ModelOfBlocks<3>&, const StepEnd&);

}  // namespace voussoir

#include "joints/point_places.hpp"

#include <map>
#include <utility>

#include "mesh/same_side.hpp"

namespace voussoir {

namespace {

/// The normal of a point before its blocks turned.
template <int dim>
Vector<3> drawn_normal(const ContactPoint& p, const Joint& joint, const Structure<dim>& structure) {
  const auto turn = structure.turn(joint.local_i).halfway_to(structure.turn(joint.local_j));
  return in_space(turn.back()(in_dimension<dim>(p.axis[0])));
}

}  // namespace

template <int dim>
std::vector<PointPlace> places_of(const ContactPoints& points, const Structure<dim>& structure) {
  std::vector<PointPlace> places;
  for (int k = 0; k < points.size(); ++k) {
    const auto& joint = points.joint_of(k);
    const auto& p = points.points()[k];
    places.push_back({joint.block_i, joint.block_j, p.place, drawn_normal(p, joint, structure)});
  }
  return places;
}

template std::vector<PointPlace> places_of(const ContactPoints&, const Structure<2>&);
template std::vector<PointPlace> places_of(const ContactPoints&, const Structure<3>&);

std::vector<int> same_places(const std::vector<PointPlace>& points, const std::vector<PointPlace>& others,
                             double near) {
  std::map<std::pair<BlockId, BlockId>, std::vector<int>> of_joint;
  for (std::size_t k = 0; k < others.size(); ++k)
    of_joint[{others[k].block_i, others[k].block_j}].push_back(static_cast<int>(k));
  std::vector<char> taken(others.size(), 0);
  std::vector<int> same;
  for (const auto& p : points) {
    same.push_back(-1);
    const auto joint = of_joint.find({p.block_i, p.block_j});
    if (joint == of_joint.end()) continue;
    for (const int k : joint->second) {
      if (taken[k] || norm(others[k].place - p.place) > near || !on_same_side(others[k].normal, p.normal, false))
        continue;
      const int best = same.back();  // of a fold, whose points lie in one place, that of the same part
      if (best < 0 || dot(others[k].normal, p.normal) > dot(others[best].normal, p.normal)) same.back() = k;
    }
    if (same.back() >= 0) taken[same.back()] = 1;
  }
  return same;
}

}  // namespace voussoir

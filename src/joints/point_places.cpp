#include "joints/point_places.hpp"

#include <map>
#include <utility>

#include "base/check.hpp"
#include "linalg/parcels.hpp"
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

std::vector<long long> same_places_over_ranks(const std::vector<PointPlace>& points,
                                              const std::vector<PointPlace>& others, long long first, double near,
                                              const Teuchos::Comm<int>& comm) {
  struct Numbered {
    PointPlace place;
    long long number;
  };
  const auto ranks = static_cast<unsigned>(comm.getSize());
  const auto meeting = [ranks](const PointPlace& p) {
    return static_cast<int>(static_cast<unsigned>(p.block_i) % ranks);
  };
  Post<Numbered> tell(comm);
  for (const auto& p : others) tell.add(meeting(p), {p, first++});
  std::vector<PointPlace> here;
  std::vector<long long> number;
  for (const auto& other : std::move(tell).send_all()) {
    here.push_back(other.place);
    number.push_back(other.number);
  }
  Post<PointPlace> ask(comm);
  for (const auto& p : points) ask.add(meeting(p), p);
  // Rank by rank, since several know the points at their borders.
  Post<long long> answer(comm);
  for (const auto& parcel : std::move(ask).send())
    for (const int k : same_places(parcel.items, here, near)) answer.add(parcel.rank, k < 0 ? -1 : number[k]);
  std::vector<std::vector<long long>> from(comm.getSize());
  for (auto& parcel : std::move(answer).send()) from[parcel.rank] = std::move(parcel.items);
  std::vector<std::size_t> next(from.size(), 0);
  std::vector<long long> same;
  for (const auto& p : points) same.push_back(from[meeting(p)].at(next[meeting(p)]++));
  return same;
}

}  // namespace voussoir

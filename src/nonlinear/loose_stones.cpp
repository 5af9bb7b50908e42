#include "nonlinear/loose_stones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "base/disjoint_sets.hpp"
#include "base/tensor.hpp"

namespace voussoir {
namespace {

/// Stones that hold each other.
struct Group {
  std::vector<int> stones, points;
  Vector<2> push{};  ///< [N] what it is out of balance by
};

/// Where a group stops.
struct Stop {
  int point = -1;
  double distance = std::numeric_limits<double>::infinity();  ///< [m]
};

/// One round of moves.
class Walk {
 public:
  Walk(const std::vector<PatchPoint>& points, PointStatuses& statuses, const std::vector<std::array<int, 2>>& sides,
       int stones, double parallel)
      : points_(points),
        statuses_(statuses),
        sides_(sides),
        groups_(stones),
        sets_(stones),
        shift_(stones),
        parallel_(parallel) {}

  std::vector<int> go(const std::vector<Vector<2>>& push, double least);
  const Vector<2>& shift(int stone) const { return shift_[stone]; }  ///< [m]

 private:
  int root(int point, int side) { return sets_.root(sides_[point][side]); }
  bool inside(int point) { return root(point, 0) == root(point, 1); }
  void gather(const std::vector<Vector<2>>& push);
  bool find_way(const Group&, Vector<2>& along);
  double rate(int point, int axis, int group, const Vector<2>& along);
  Stop first_stop(int group, const Vector<2>& along);
  int move(int group, const Vector<2>& along, const Stop&);

  const std::vector<PatchPoint>& points_;
  PointStatuses& statuses_;
  const std::vector<std::array<int, 2>>& sides_;  ///< stones of each point
  std::vector<Group> groups_;              ///< at the roots
  DisjointSets sets_;
  std::vector<Vector<2>> shift_;
  double parallel_;
};

void Walk::gather(const std::vector<Vector<2>>& push) {
  const int points = static_cast<int>(points_.size());
  for (int k = 0; k < points; ++k)
    if (statuses_.resistance[k].tangential > 0) sets_.unite(sides_[k][0], sides_[k][1]);
  for (int s = 0; s < static_cast<int>(push.size()); ++s) {
    auto& group = groups_[sets_.root(s)];
    group.stones.push_back(s);
    group.push = group.push + push[s];
  }
  for (int k = 0; k < points; ++k)
    if (!inside(k))
      for (int side : {0, 1}) groups_[root(k, side)].points.push_back(k);
}

/// Along its beds, where it is pushed to; false where they are not parallel, or there are none.
bool Walk::find_way(const Group& group, Vector<2>& along) {
  bool any = false;
  for (int k : group.points) {
    if (statuses_.resistance[k].normal == 0 || inside(k)) continue;
    if (!any) along = points_[k].axis[1];
    any = true;
    if (std::abs(dot(points_[k].axis[0], along)) > parallel_) return false;
  }
  if (dot(group.push, along) < 0) along = -1.0 * along;
  return any;
}

/// Change of a gap or slip when a group moves by a unit.
double Walk::rate(int point, int axis, int group, const Vector<2>& along) {
  return (root(point, 1) == group ? 1 : -1) * dot(points_[point].axis[axis], along);
}

/// Where a point that slides is back at its origin, or a gap closes.
Stop Walk::first_stop(int group, const Vector<2>& along) {
  Stop first;
  for (int k : groups_[group].points) {
    if (inside(k)) continue;
    const bool closed = statuses_.resistance[k].normal > 0;
    if (closed && points_[k].law.friction == 0 && points_[k].law.cohesion == 0) continue;  // holds nothing
    const double sign = closed ? -statuses_.sliding[k] : 1.0;  // friction acts against the slip
    const double speed = -sign * rate(k, closed, group, along);
    if (!(speed > parallel_)) continue;
    const double distance = std::max(sign * statuses_.motion[k][closed], 0.0) / speed;
    if (distance < first.distance) first = {k, distance};
  }
  return first;
}

/// Returns the group that it joins.
int Walk::move(int group, const Vector<2>& along, const Stop& stop) {
  auto& mine = groups_[group];
  for (int s : mine.stones) shift_[s] = shift_[s] + stop.distance * along;
  for (int k : mine.points)
    if (!inside(k))
      for (int axis : {0, 1}) statuses_.motion[k][axis] += stop.distance * rate(k, axis, group, along);
  const int other = root(stop.point, root(stop.point, 0) == group ? 1 : 0);
  const int joint = sets_.unite(group, other);  // what is held remains 0
  auto& to = groups_[joint];
  auto& from = groups_[joint == group ? other : group];
  to.stones.insert(to.stones.end(), from.stones.begin(), from.stones.end());
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  to.push = to.push + from.push;
  return joint;
}

std::vector<int> Walk::go(const std::vector<Vector<2>>& push, double least) {
  gather(push);
  std::vector<int> stops, queue;
  for (int s = 1; s < static_cast<int>(groups_.size()); ++s)
    if (sets_.root(s) == s) queue.push_back(s);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const int group = queue[next];
    Vector<2> along{};
    if (sets_.root(group) != group || group == 0 || !find_way(groups_[group], along)) continue;
    if (dot(groups_[group].push, along) < least) continue;
    const Stop stop = first_stop(group, along);
    if (stop.point < 0) continue;
    stops.push_back(stop.point);
    queue.push_back(move(group, along, stop));
  }
  return stops;
}

}  // namespace

LooseStones::LooseStones(const PatchParts& parts, const PatchParameters& numbers)
    : parallel_(numbers.parallel), component_(parts.component), stone_(parts.imbalance.size()) {
  VOUSSOIR_EXPECT(component_.size() == stone_.size());
  DisjointSets sets(stone_.size());
  std::vector<double> whole(stone_.size(), 0.0), diagonal = whole;
  for (const auto& e : parts.stiffness) {
    sets.unite(e.row, e.column);
    whole[e.row] += e.value;
    if (e.row == e.column) diagonal[e.row] += e.value;
  }
  std::vector<char> held(stone_.size(), 0);
  const int unknowns = static_cast<int>(stone_.size());
  for (int i = 0; i < unknowns; ++i)
    if (std::abs(whole[i]) > numbers.held_share * diagonal[i]) held[sets.root(i)] = 1;
  for (const auto& p : parts.border)
    for (int i : p.unknown)
      if (i >= 0 && p.resistance.tangential > 0) held[sets.root(i)] = 1;
  for (int i = 0; i < unknowns; ++i) {
    const int root = sets.root(i);  // never after i
    stone_[i] = held[root] ? 0 : root == i ? stones_++ : stone_[root];
  }
  for (const auto& p : parts.points) sides_.push_back({stone_at(p, 0), stone_at(p, 1)});
}

/// The stone on one side of a point.
int LooseStones::stone_at(const PatchPoint& p, int side) const {
  for (int i : {2 * side, 2 * side + 1})
    if (p.unknown[i] >= 0) return stone_[p.unknown[i]];
  return 0;
}

std::vector<int> LooseStones::move_on(const std::vector<PatchPoint>& points, PointStatuses statuses,
                                      const double* imbalance, double least, double* displacement) const {
  std::vector<Vector<2>> push(stones_);
  for (std::size_t i = 0; i < stone_.size(); ++i) push[stone_[i]][component_[i]] -= imbalance[i];
  Walk walk(points, statuses, sides_, stones_, parallel_);
  const auto stops = walk.go(push, least);
  for (std::size_t i = 0; i < stone_.size(); ++i) displacement[i] += walk.shift(stone_[i])[component_[i]];
  return stops;
}

}  // namespace voussoir

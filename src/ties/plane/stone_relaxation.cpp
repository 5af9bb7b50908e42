#include "ties/plane/stone_relaxation.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "base/dense.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

/// Force of a spring whose ends have moved against each other.
Vector<2> force_of(const StonePoint& spring, double stiffness, const Vector<2>& motion) {
  return nearest_lawful(spring.law, Vector<2>{spring.force[0] - stiffness * (motion[0] + spring.gap),
                                              spring.force[1] - stiffness * motion[1]});
}

std::vector<long long> block_ids(const BlockSystem& s) {
  std::vector<long long> ids;
  for (int b = 0; b < s.local_blocks(); ++b) ids.push_back(s.nodes_of(b).id);
  return ids;
}

}  // namespace

StoneRelaxation::StoneRelaxation(const Model& model, std::vector<Stone> stones, double stiffness)
    : model_(model),
      numbers_(model.settings().internals.ties),
      stones_(std::move(stones)),
      stiffness_(stiffness),
      exchange_(block_ids(model.structure()), model.structure().owned_blocks(), model.structure().comm()),
      links_(stones_.size()),
      known_alone_(stones_.size()) {
  VOUSSOIR_EXPECT(stones_.size() == static_cast<std::size_t>(model.structure().local_blocks()) &&
                  "stones: per local block");
  VOUSSOIR_EXPECT(stiffness > 0 && std::isfinite(stiffness) && "stiffness of springs: positive");
  for (const auto& stone : stones_) VOUSSOIR_EXPECT(stone.radius > 0 && "radius of a stone: positive");
  const auto& s = model.structure();
  for (int k = 0; k < model.points().size(); ++k) {
    const auto p = model.points().at(k);
    const int i = model.points().joint_of(k).local_i, j = model.points().joint_of(k).local_j;
    links_[i].push_back({k, j, stones_[j].rides_on == i, -1.0, in_plane(p.place(Side::i, s)) - stones_[i].middle});
    links_[j].push_back({k, i, stones_[i].rides_on == j, 1.0, in_plane(p.place(Side::j, s)) - stones_[j].middle});
    arms_.push_back({links_[i].back().arm, links_[j].back().arm});
  }
}

void StoneRelaxation::begin(std::vector<StonePoint> points, std::vector<StoneVector> lacks) {
  VOUSSOIR_EXPECT(points.size() == static_cast<std::size_t>(model_.points().size()) && "points: per local point");
  VOUSSOIR_EXPECT(lacks.size() == static_cast<std::size_t>(model_.structure().owned_blocks()) &&
                  "lacks: per owned block");
  points_ = std::move(points);
  lacks_ = std::move(lacks);
  force_.resize(points_.size());
  take_back();
}

void StoneRelaxation::take_back() {
  place_.assign(stones_.size(), {});
  way_.assign(stones_.size(), {});
  for (std::size_t k = 0; k < force_.size(); ++k) force_[k] = points_[k].force;
  lack_ = lacks_;
}

double StoneRelaxation::passing(int block) const {
  double sum = 0;
  for (const auto& link : links_[block]) sum += norm(points_[link.point].force) / 2;
  return sum;
}

Vector<2> StoneRelaxation::motion_of(int point, Side side) const {
  const auto& points = model_.points();
  const int block = side == Side::i ? points.joint_of(point).local_i : points.joint_of(point).local_j;
  const auto& d = place_[block];
  const auto& arm = arms_[point][side == Side::i ? 0 : 1];
  const Vector<2> u{d[0] - d[2] * arm[1], d[1] + d[2] * arm[0]};
  return {dot(u, axis_of(point, 0)), dot(u, axis_of(point, 1))};
}

Vector<2> StoneRelaxation::axis_of(int point, int component) const {
  return in_plane(model_.points().points()[point].axis[component]);
}

void StoneRelaxation::update_force(int point) {
  const auto motion = motion_of(point, Side::j) - motion_of(point, Side::i);
  force_[point] = force_of(points_[point], stiffness_, motion);
}

/// What a stone lacks where it is now.
StoneVector StoneRelaxation::lacking(int block, const StoneVector& at_first, Neighbours which) const {
  auto lack = at_first;
  for (int c = 0; c < 3; ++c) lack[c] -= stones_[block].support[c] * place_[block][c];
  for (const auto& link : links_[block]) {
    if (which == Neighbours::that_stay && link.rides) continue;
    const auto change = force_[link.point] - points_[link.point].force;
    const Vector<2> f = link.sign * (change[0] * axis_of(link.point, 0) + change[1] * axis_of(link.point, 1));
    lack[0] += f[0];
    lack[1] += f[1];
    lack[2] += cross(link.arm, f);
  }
  return lack;
}

/// The step that would balance a stone if every spring held.
StoneVector StoneRelaxation::step_of(int block, const StoneVector& lack, Neighbours which) const {
  const auto& stone = stones_[block];
  Matrix<3> matrix{};
  bool held = false;
  for (const auto& link : links_[block]) {
    if (which == Neighbours::that_stay && link.rides) continue;
    held = true;
    for (int a = 0; a < 2; ++a) {
      const auto axis = axis_of(link.point, a);
      const StoneVector way{axis[0], axis[1], cross(link.arm, axis)};
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) matrix[r][c] += stiffness_ * way[r] * way[c];
    }
  }
  for (int c = 0; c < 3; ++c) matrix[c][c] += stone.support[c];
  const double ground = held ? numbers_.foundation * stiffness_ : 0;
  matrix[0][0] += ground;
  matrix[1][1] += ground;
  matrix[2][2] += ground * stone.radius * stone.radius;
  return solve_positive(matrix, lack);
}

double StoneRelaxation::alone(int block, const StoneVector& lacks, double bearable) {
  VOUSSOIR_EXPECT(block >= 0 && block < static_cast<int>(lack_.size()) && "block: an owned one");
  VOUSSOIR_EXPECT(bearable >= 0 && "bearable: not negative");
  const double begun = size_of(lacks, stones_[block].radius);
  if (begun <= bearable) return begun;
  auto& place = place_[block];
  auto& known = known_alone_[block];
  const auto lack_at = [&](const StoneVector& there) {
    place = there;
    for (const auto& link : links_[block])
      if (!link.rides) update_force(link.point);
    return lacking(block, lacks, Neighbours::that_stay);
  };
  double least = begun;
  if (known != StoneVector{}) least = std::min(begun, size_of(lack_at(known), stones_[block].radius));
  if (least > bearable) {
    least = begun;
    StoneVector lack = lacks, there{};
    for (int k = 0; k < numbers_.steps_alone && least > bearable; ++k) {
      const auto step = step_of(block, lack, Neighbours::that_stay);
      for (int c = 0; c < 3; ++c) there[c] += step[c];
      lack = lack_at(there);
      least = std::min(least, size_of(lack, stones_[block].radius));
    }
    known = least <= bearable ? there : StoneVector{};
  }
  place = {};
  for (const auto& link : links_[block]) force_[link.point] = points_[link.point].force;
  return least;
}

/// Steps of owned stones that lack more than they may, three numbers each, with room for those of the halo.
std::vector<double> StoneRelaxation::steps(const std::vector<double>& lacks) const {
  std::vector<double> steps(3 * stones_.size(), 0.0);
  for (int b = 0; b < static_cast<int>(lack_.size()); ++b) {
    if (lacks[b] <= bearable_[b] || links_[b].empty()) continue;
    const auto step = step_of(b, lack_[b], Neighbours::all);
    for (int c = 0; c < 3; ++c) steps[3 * b + c] = numbers_.share_of_step * step[c];
  }
  return steps;
}

/// Moves the stones on.
void StoneRelaxation::move(std::vector<double> steps) {
  exchange_.update(steps, 3);
  std::vector<int> moved;
  for (std::size_t b = 0; b < stones_.size(); ++b) {
    const auto at = steps.begin() + 3L * static_cast<long>(b);
    if (std::all_of(at, at + 3, [](double d) { return d == 0; })) {
      way_[b] = {};
      continue;
    }
    for (int c = 0; c < 3; ++c) {
      way_[b][c] = at[c] + numbers_.momentum * way_[b][c];
      place_[b][c] += way_[b][c];
    }
    moved.push_back(static_cast<int>(b));
  }
  take_up(moved);
}

/// Puts the stones where others were; only those that moved then are away from where they begin.
void StoneRelaxation::go_to(const std::vector<StoneVector>& places) {
  place_ = places;
  std::vector<int> moved;
  for (std::size_t b = 0; b < places.size(); ++b)
    if (places[b] != StoneVector{}) moved.push_back(static_cast<int>(b));
  take_up(moved);
}

/// Forces of stones that have moved, and what they and their neighbours lack then.
void StoneRelaxation::take_up(const std::vector<int>& moved) {
  std::vector<char> touched(stones_.size(), 0);
  for (const int b : moved) {
    touched[b] = 1;
    for (const auto& link : links_[b]) {
      update_force(link.point);
      touched[link.other] = 1;
    }
  }
  for (int b = 0; b < static_cast<int>(lack_.size()); ++b)
    if (touched[b]) lack_[b] = lacking(b, lacks_[b], Neighbours::all);
}

StoneRelaxation::Lacking StoneRelaxation::measure(std::vector<double>& lacks) const {
  Lacking sum;
  lacks.resize(lack_.size());
  for (std::size_t b = 0; b < lack_.size(); ++b) {
    lacks[b] = size_of(lack_[b], stones_[b].radius);
    if (lacks[b] <= bearable_[b]) continue;
    if (links_[b].empty()) {
      sum.stuck += 1;
      continue;
    }
    sum.stones += 1;
    sum.force += lacks[b];
  }
  return sum;
}

RelaxedStones StoneRelaxation::relax(const std::vector<double>& bearable, int loose) {
  VOUSSOIR_EXPECT(bearable.size() == lack_.size() && "bearable: per owned block");
  VOUSSOIR_EXPECT(loose >= 0 && "loose stones: a count");
  bearable_ = bearable;
  RelaxedStones relaxed;
  auto& lacks = relaxed.lacks;
  const auto over_ranks = [&](const Lacking& mine, double known) {
    const std::array<double, 4> here{mine.stones, mine.force, mine.stuck + loose, known};
    return total_of_each(*model_.structure().comm(), here);
  };
  // One message tells of both, of where the stones begin and of the places known.
  const auto begun = measure(lacks);
  std::vector<double> lacks_there;
  double lacking_there = 0;
  if (!known_.empty()) {
    go_to(known_);
    lacking_there = measure(lacks_there).stones;
  }
  auto [lacking, force, loose_already, there] = over_ranks(begun, lacking_there);
  if (!known_.empty() && lacking > 0 && there == 0) return {lacks_there, loose_already > 0};
  if (!known_.empty()) take_back();
  double least = force;  // [N] that all stones which lack too much have lacked together
  // A push crosses a stone in a sweep, and may have to cross the whole structure before anything gets better.
  const auto across = static_cast<int>(std::sqrt(static_cast<double>(model_.structure().owner_of_block().size())));
  const int patience = std::max(numbers_.patience, across);
  int sweep = 0;
  for (int last_progress = 0;; ++sweep) {
    if (force < numbers_.progress * least) {
      least = force;
      last_progress = sweep;
    }
    if (lacking == 0 || sweep - last_progress == patience) break;
    move(steps(lacks));
    const auto all = over_ranks(measure(lacks), 0);
    lacking = all[0];
    force = all[1];
    loose_already = all[2];
  }
  if (sweep > 0 && lacking == 0) known_ = place_;
  relaxed.any_loose = lacking + loose_already > 0;
  return relaxed;
}

}  // namespace voussoir

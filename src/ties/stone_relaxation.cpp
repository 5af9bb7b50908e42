#include "ties/stone_relaxation.hpp"

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
template <int dim>
Vector<dim> force_of(const StonePoint<dim>& spring, double stiffness, Vector<dim> motion) {
  motion[0] += spring.gap;
  return nearest_lawful(spring.law, spring.force - stiffness * motion);
}

std::vector<long long> block_ids(const BlockSystem& s) {
  std::vector<long long> ids;
  for (int b = 0; b < s.local_blocks(); ++b) ids.push_back(s.nodes_of(b).id);
  return ids;
}

}  // namespace

template <int dim>
StoneRelaxation<dim>::StoneRelaxation(const Model& model, std::vector<Stone<dim>> stones, double stiffness)
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
    links_[i].push_back(
        {k, j, stones_[j].rides_on == i, -1.0, in_dimension<dim>(p.place(Side::i, s)) - stones_[i].middle});
    links_[j].push_back(
        {k, i, stones_[i].rides_on == j, 1.0, in_dimension<dim>(p.place(Side::j, s)) - stones_[j].middle});
    arms_.push_back({links_[i].back().arm, links_[j].back().arm});
  }
}

template <int dim>
void StoneRelaxation<dim>::begin(std::vector<StonePoint<dim>> points, std::vector<StoneVector<dim>> lacks) {
  VOUSSOIR_EXPECT(points.size() == static_cast<std::size_t>(model_.points().size()) && "points: per local point");
  VOUSSOIR_EXPECT(lacks.size() == static_cast<std::size_t>(model_.structure().owned_blocks()) &&
                  "lacks: per owned block");
  points_ = std::move(points);
  lacks_ = std::move(lacks);
  force_.resize(points_.size());
  take_back();
}

template <int dim>
void StoneRelaxation<dim>::take_back() {
  place_.assign(stones_.size(), {});
  way_.assign(stones_.size(), {});
  for (std::size_t k = 0; k < force_.size(); ++k) force_[k] = points_[k].force;
  lack_ = lacks_;
}

template <int dim>
double StoneRelaxation<dim>::passing(int block) const {
  double sum = 0;
  for (const auto& link : links_[block]) sum += norm(points_[link.point].force) / 2;
  return sum;
}

template <int dim>
Vector<dim> StoneRelaxation<dim>::motion_of(int point, Side side) const {
  const auto& points = model_.points();
  const int block = side == Side::i ? points.joint_of(point).local_i : points.joint_of(point).local_j;
  const auto& d = place_[block];
  const auto& arm = arms_[point][side == Side::i ? 0 : 1];
  const auto u = motion_at(arm, d);
  Vector<dim> motion;
  for (int a = 0; a < dim; ++a) motion[a] = dot(u, axis_of(point, a));
  return motion;
}

template <int dim>
Vector<dim> StoneRelaxation<dim>::axis_of(int point, int component) const {
  return in_dimension<dim>(model_.points().points()[point].axis[component]);
}

template <int dim>
void StoneRelaxation<dim>::update_force(int point) {
  const auto motion = motion_of(point, Side::j) - motion_of(point, Side::i);
  force_[point] = force_of(points_[point], stiffness_, motion);
}

/// What a stone lacks where it is now.
template <int dim>
StoneVector<dim> StoneRelaxation<dim>::lacking(int block, const StoneVector<dim>& at_first, Neighbours which) const {
  auto lack = at_first;
  for (int c = 0; c < ways; ++c) lack[c] -= stones_[block].support[c] * place_[block][c];
  for (const auto& link : links_[block]) {
    if (which == Neighbours::that_stay && link.rides) continue;
    const auto change = force_[link.point] - points_[link.point].force;
    auto f = change[0] * axis_of(link.point, 0);
    for (int a = 1; a < dim; ++a) f = f + change[a] * axis_of(link.point, a);
    lack = lack + wrench(link.arm, link.sign * f);
  }
  return lack;
}

/// The step that would balance a stone if every spring held.
template <int dim>
StoneVector<dim> StoneRelaxation<dim>::step_of(int block, const StoneVector<dim>& lack, Neighbours which) const {
  const auto& stone = stones_[block];
  Matrix<ways> matrix{};
  bool held = false;
  for (const auto& link : links_[block]) {
    if (which == Neighbours::that_stay && link.rides) continue;
    held = true;
    for (int a = 0; a < dim; ++a) {
      const auto way = wrench(link.arm, axis_of(link.point, a));
      for (int r = 0; r < ways; ++r)
        for (int c = 0; c < ways; ++c) matrix[r][c] += stiffness_ * way[r] * way[c];
    }
  }
  for (int c = 0; c < ways; ++c) matrix[c][c] += stone.support[c];
  const double ground = held ? numbers_.foundation * stiffness_ : 0;
  for (int c = 0; c < ways; ++c) matrix[c][c] += c < dim ? ground : ground * stone.radius * stone.radius;
  return solve_positive(matrix, lack);
}

template <int dim>
double StoneRelaxation<dim>::alone(int block, const StoneVector<dim>& lacks, double bearable) {
  VOUSSOIR_EXPECT(block >= 0 && block < static_cast<int>(lack_.size()) && "block: an owned one");
  VOUSSOIR_EXPECT(bearable >= 0 && "bearable: not negative");
  const double begun = size_of(lacks, stones_[block].radius);
  if (begun <= bearable) return begun;
  auto& place = place_[block];
  auto& known = known_alone_[block];
  const auto lack_at = [&](const StoneVector<dim>& there) {
    place = there;
    for (const auto& link : links_[block])
      if (!link.rides) update_force(link.point);
    return lacking(block, lacks, Neighbours::that_stay);
  };
  double least = begun;
  if (known != StoneVector<dim>{}) least = std::min(begun, size_of(lack_at(known), stones_[block].radius));
  if (least > bearable) {
    least = begun;
    StoneVector<dim> lack = lacks, there{};
    for (int k = 0; k < numbers_.steps_alone && least > bearable; ++k) {
      const auto step = step_of(block, lack, Neighbours::that_stay);
      for (int c = 0; c < ways; ++c) there[c] += step[c];
      lack = lack_at(there);
      least = std::min(least, size_of(lack, stones_[block].radius));
    }
    known = least <= bearable ? there : StoneVector<dim>{};
  }
  place = {};
  for (const auto& link : links_[block]) force_[link.point] = points_[link.point].force;
  return least;
}

/// Steps of owned stones that lack more than they may, a number for each way to move, with room for those of the halo.
template <int dim>
std::vector<double> StoneRelaxation<dim>::steps(const std::vector<double>& lacks) const {
  std::vector<double> steps(ways * stones_.size(), 0.0);
  for (int b = 0; b < static_cast<int>(lack_.size()); ++b) {
    if (lacks[b] <= bearable_[b] || links_[b].empty()) continue;
    const auto step = step_of(b, lack_[b], Neighbours::all);
    for (int c = 0; c < ways; ++c) steps[ways * b + c] = numbers_.share_of_step * step[c];
  }
  return steps;
}

/// Moves the stones on.
template <int dim>
void StoneRelaxation<dim>::move(std::vector<double> steps) {
  exchange_.update(steps, ways);
  std::vector<int> moved;
  for (std::size_t b = 0; b < stones_.size(); ++b) {
    const auto at = steps.begin() + ways * static_cast<long>(b);
    if (std::all_of(at, at + ways, [](double d) { return d == 0; })) {
      way_[b] = {};
      continue;
    }
    for (int c = 0; c < ways; ++c) {
      way_[b][c] = at[c] + numbers_.momentum * way_[b][c];
      place_[b][c] += way_[b][c];
    }
    moved.push_back(static_cast<int>(b));
  }
  take_up(moved);
}

/// Puts the stones where others were; only those that moved then are away from where they begin.
template <int dim>
void StoneRelaxation<dim>::go_to(const std::vector<StoneVector<dim>>& places) {
  place_ = places;
  std::vector<int> moved;
  for (std::size_t b = 0; b < places.size(); ++b)
    if (places[b] != StoneVector<dim>{}) moved.push_back(static_cast<int>(b));
  take_up(moved);
}

/// Forces of stones that have moved, and what they and their neighbours lack then.
template <int dim>
void StoneRelaxation<dim>::take_up(const std::vector<int>& moved) {
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

template <int dim>
typename StoneRelaxation<dim>::Lacking StoneRelaxation<dim>::measure(std::vector<double>& lacks) const {
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

template <int dim>
RelaxedStones StoneRelaxation<dim>::relax(const std::vector<double>& bearable, int loose) {
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
  if (known_) {
    go_to(*known_);
    lacking_there = measure(lacks_there).stones;
  }
  auto [lacking, force, loose_already, there] = over_ranks(begun, lacking_there);
  if (known_ && lacking > 0 && there == 0) return {lacks_there, loose_already > 0};
  if (known_) take_back();
  double least = force;  // [N] that all stones which lack too much have lacked together
  // A push crosses a stone in a sweep, and may have to cross the whole structure before anything gets better.
  const auto across = static_cast<int>(std::sqrt(static_cast<double>(model_.structure().total_blocks())));
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

template class StoneRelaxation<2>;
template class StoneRelaxation<3>;

}  // namespace voussoir

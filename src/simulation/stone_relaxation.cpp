#include "simulation/stone_relaxation.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

// Neighbours move at the same time: half of the step to balance is what Jacobi's method bears between two springs.
constexpr double share_of_step = 0.5;
// A heavy ball rolls on with so much of its last way: the best share where balance is found a dozen stones away, for
// which (1 - 1/12)^2 = 0.84.
constexpr double momentum = 0.85;
// No balance is found where so many sweeps do not lower what all stones lack together by a thousandth: a push has
// crossed as many stones by then.
constexpr int patience = 50;
constexpr double progress = 0.999;
// Foundation of a stone that no point touches in some direction, relative to the stiffness of its points.
constexpr double foundation = 1e-3;
// Steps of a stone alone: those that stand take a handful, or some dozens where one edge is left to stand on.
constexpr int most_steps_alone = 200;

/// Solves the symmetric positive definite system a x = b in place of b.
void solve_plane(std::array<StoneVector, 3>& a, StoneVector& b) {
  for (int k = 0; k < 3; ++k)
    for (int i = k + 1; i < 3; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (int j = k; j < 3; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  for (int k = 2; k >= 0; --k) {
    for (int j = k + 1; j < 3; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
}

/// Force of a spring whose ends have moved against each other.
Vector<2> force_of(const StonePoint& spring, const Vector<2>& motion) {
  Vector<2> force;
  force[0] = project_normal(spring.law, spring.force[0] - spring.stiffness[0] * (motion[0] + spring.gap));
  const double bound = friction_bound(spring.law, force[0]);
  force[1] = std::clamp(spring.force[1] - spring.stiffness[1] * motion[1], -bound, bound);
  return force;
}

std::vector<long long> block_ids(const Structure<2>& s) {
  std::vector<long long> ids;
  for (const auto& block : s.blocks()) ids.push_back(block.mesh.id);
  return ids;
}

}  // namespace

StoneRelaxation::StoneRelaxation(const Model<2>& model, std::vector<Stone> stones,
                                 const std::vector<StonePoint>& points)
    : model_(model),
      stones_(std::move(stones)),
      points_(points),
      exchange_(block_ids(model.structure()), model.structure().owned_blocks(), model.structure().comm()),
      links_(stones_.size()),
      place_(stones_.size()),
      way_(stones_.size()) {
  const auto& s = model.structure();
  for (int k = 0; k < model.points().size(); ++k) {
    const auto& p = model.points().points()[k];
    force_.push_back(points[k].force);
    const int i = s.block_of_node()[p.node_i], j = s.block_of_node()[p.node_j];
    links_[i].push_back({k, j, -1.0, s.position()[p.node_i] - stones_[i].middle});
    links_[j].push_back({k, i, 1.0, s.position()[p.node_j] - stones_[j].middle});
  }
  for (int b = 0; b < s.owned_blocks(); ++b) lack_.push_back(stones_[b].lacks);
}

Vector<2> StoneRelaxation::motion_of(int block, int node, const ContactPoint<2>& p) const {
  const auto& d = place_[block];
  const Vector<2> arm = model_.structure().position()[node] - stones_[block].middle;
  const Vector<2> u{d[0] - d[2] * arm[1], d[1] + d[2] * arm[0]};
  return {dot(u, p.axis[0]), dot(u, p.axis[1])};
}

void StoneRelaxation::update_force(int point) {
  const auto& block = model_.structure().block_of_node();
  const auto& p = model_.points().points()[point];
  const auto motion = motion_of(block[p.node_j], p.node_j, p) - motion_of(block[p.node_i], p.node_i, p);
  force_[point] = force_of(points_[point], motion);
}

/// What a stone lacks where it is now.
StoneVector StoneRelaxation::lacking(int block) const {
  const auto& stone = stones_[block];
  auto lack = stone.lacks;
  for (int c = 0; c < 3; ++c) lack[c] -= stone.support[c] * place_[block][c];
  for (const auto& link : links_[block]) {
    const auto& axis = model_.points().points()[link.point].axis;
    const auto change = force_[link.point] - points_[link.point].force;
    const Vector<2> f = link.sign * (change[0] * axis[0] + change[1] * axis[1]);
    lack[0] += f[0];
    lack[1] += f[1];
    lack[2] += cross(link.arm, f);
  }
  return lack;
}

/// The step that would balance a stone if every spring held.
StoneVector StoneRelaxation::step_of(int block, const StoneVector& lack) const {
  const auto& stone = stones_[block];
  std::array<StoneVector, 3> matrix{};
  double stiffest = 0;
  for (const auto& link : links_[block]) {
    const auto& axis = model_.points().points()[link.point].axis;
    for (int a = 0; a < 2; ++a) {
      const StoneVector way{axis[a][0], axis[a][1], cross(link.arm, axis[a])};
      const double k = points_[link.point].stiffness[a];
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) matrix[r][c] += k * way[r] * way[c];
      stiffest = std::max(stiffest, k);
    }
  }
  for (int c = 0; c < 3; ++c) matrix[c][c] += stone.support[c];
  const double ground = foundation * stiffest;
  matrix[0][0] += ground;
  matrix[1][1] += ground;
  matrix[2][2] += ground * stone.radius * stone.radius;
  auto step = lack;
  solve_plane(matrix, step);
  return step;
}

double StoneRelaxation::alone(int block, const StoneVector& lacks, double bearable,
                              const std::function<bool(int)>& rides) {
  double least = size_of(lacks, stones_[block].radius);
  if (least <= bearable) return least;
  const auto begun = std::exchange(stones_[block].lacks, lacks);
  const auto all_links = links_[block];
  auto& links = links_[block];
  links.erase(std::remove_if(links.begin(), links.end(), [&](const Link& l) { return rides(l.other); }), links.end());
  for (int k = 0; k < most_steps_alone && least > bearable; ++k) {
    const auto step = step_of(block, lacking(block));
    for (int c = 0; c < 3; ++c) place_[block][c] += step[c];
    for (const auto& link : links_[block]) update_force(link.point);
    least = std::min(least, size_of(lacking(block), stones_[block].radius));
  }
  stones_[block].lacks = begun;
  place_[block] = {};
  links = all_links;
  for (const auto& link : links) force_[link.point] = points_[link.point].force;
  return least;
}

/// Moves the stones, and takes up what they and their neighbours lack then.
/// @param steps  of owned blocks, three numbers each, with room for those of the halo
void StoneRelaxation::move(std::vector<double>& steps) {
  exchange_.update(steps, 3);
  std::vector<char> touched(stones_.size(), 0);
  std::vector<int> moved;
  for (std::size_t b = 0; b < stones_.size(); ++b) {
    const auto at = steps.begin() + 3L * static_cast<long>(b);
    if (std::all_of(at, at + 3, [](double d) { return d == 0; })) {
      way_[b] = {};
      continue;
    }
    for (int c = 0; c < 3; ++c) {
      way_[b][c] = at[c] + momentum * way_[b][c];
      place_[b][c] += way_[b][c];
    }
    moved.push_back(static_cast<int>(b));
  }
  for (const int b : moved) {
    touched[b] = 1;
    for (const auto& link : links_[b]) {
      update_force(link.point);
      touched[link.other] = 1;
    }
  }
  for (std::size_t b = 0; b < lack_.size(); ++b)
    if (touched[b]) lack_[b] = lacking(static_cast<int>(b));
}

std::vector<double> StoneRelaxation::relax() {
  const auto& comm = *model_.structure().comm();
  std::vector<double> lacks(lack_.size());
  double least = 0;  // [N] that all stones which lack too much have lacked together
  for (int sweep = 0, last_progress = 0;; ++sweep) {
    double sums[2] = {0, 0}, all[2];
    std::vector<double> steps(3 * stones_.size(), 0.0);
    for (std::size_t b = 0; b < lack_.size(); ++b) {
      lacks[b] = size_of(lack_[b], stones_[b].radius);
      if (lacks[b] <= stones_[b].bearable || links_[b].empty()) continue;
      sums[0] += 1;
      sums[1] += lacks[b];
      const auto step = step_of(static_cast<int>(b), lack_[b]);
      for (int c = 0; c < 3; ++c) steps[3 * b + c] = share_of_step * step[c];
    }
    Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, 2, sums, all);
    if (sweep == 0 || all[1] < progress * least) {
      least = all[1];
      last_progress = sweep;
    }
    if (all[0] == 0 || sweep - last_progress == patience) return lacks;
    move(steps);
  }
}

}  // namespace voussoir

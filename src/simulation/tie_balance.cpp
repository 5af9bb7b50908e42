#include "simulation/tie_balance.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "joints/tractions.hpp"
#include "linalg/reduce.hpp"
#include "simulation/dependent_stones.hpp"
#include "simulation/error_estimate.hpp"
#include "simulation/stone_relaxation.hpp"

namespace voussoir {
namespace {

// What a block lacks counts as nothing below this multiple of the tolerance to which forces are known.
constexpr double noise = 10;
// Loads of a stone that add up to less than this share of their magnitudes are in balance, up to round-off.
constexpr double balanced = 1e-10;

/// Stiffness of the springs [N/m]: that of the softest point, for all alike. Which stones find a balance is a matter of
/// places and laws; springs that differ by orders of magnitude would only make them wait for each other. Collective.
double stiffness_of_springs(const Model<2>& model) {
  double softest = std::numeric_limits<double>::max();
  for (int k = 0; k < model.points().size(); ++k) {
    const double sigma = model.local_stiffness()[k];
    softest = std::min(softest, sigma);
    if (model.compliance().empty()) continue;
    for (int c = 0; c < 2; ++c) softest = std::min(softest, sigma / (1 + sigma * model.compliance()[k].along(c)));
  }
  return -largest_over_ranks(*model.structure().comm(), -softest);
}

/// The points as springs, each with the nearest force that its law admits, normal part first; an open one bears none.
std::vector<StonePoint> springs(const Model<2>& model, const PointLaws& law, const ContactState& state,
                                const std::vector<int>& cluster, double stiffness) {
  std::vector<StonePoint> springs;
  const auto open = open_points(model);
  const auto gap = model.gaps(state.displacement);
  for (int k = 0; k < model.points().size(); ++k) {
    const auto& p = model.points().points()[k];
    StonePoint spring;
    spring.law = law[k];
    spring.stiffness = {stiffness, stiffness};
    const bool tied = cluster[p.node_i] == cluster[p.node_j];
    if (!tied || (!open.empty() && open[k])) spring.gap = std::max(0.0, gap[2 * k]);
    if (open.empty() || !open[k] || !tied) {
      const double normal = project_normal(law[k], state.lambda[2 * k]);
      const double bound = friction_bound(law[k], normal);
      spring.force = {normal, std::clamp(state.lambda[2 * k + 1], -bound, bound)};
      if (normal > -law[k].tension) spring.gap = 0;
    }
    springs.push_back(spring);
  }
  return springs;
}

StoneVector sum_over(const Structure<2>& s, const LocalBlock<2>& block, const Vector<2>& middle,
                     const std::vector<double>& nodal) {
  StoneVector sum{};
  const int first = block.first_local, count = static_cast<int>(block.mesh.position.size());
  for (int i = first; i < first + count; ++i) {
    const Vector<2> f{nodal[2 * i], nodal[2 * i + 1]};
    sum[0] += f[0];
    sum[1] += f[1];
    sum[2] += cross(s.position()[i] - middle, f);
  }
  return sum;
}

/// Half the magnitudes of the forces of its points, per local block: what passes through a block. [N]
std::vector<double> passing(const Model<2>& model, const std::vector<StonePoint>& points) {
  std::vector<double> sum(model.structure().blocks().size(), 0.0);
  const auto& block = model.structure().block_of_node();
  for (int k = 0; k < model.points().size(); ++k) {
    const auto& p = model.points().points()[k];
    for (int node : {p.node_i, p.node_j}) sum[block[node]] += norm(points[k].force) / 2;
  }
  return sum;
}

/// The blocks as rigid bodies where they are; supports hold a node as a point does.
std::vector<Stone> stones_of(const Model<2>& model, double stiffness) {
  const auto& s = model.structure();
  std::vector<Stone> stones;
  for (const auto& block : s.blocks()) {
    Stone stone;
    const int first = block.first_local, count = static_cast<int>(block.mesh.position.size());
    for (int i = first; i < first + count; ++i) stone.middle = stone.middle + (1.0 / count) * s.position()[i];
    for (int i = first; i < first + count; ++i) {
      const Vector<2> arm = s.position()[i] - stone.middle;
      stone.radius = std::max(stone.radius, norm(arm));
      for (int c = 0; c < 2; ++c) {
        if (!model.held()[2 * i + c]) continue;
        stone.support[c] += stiffness;
        stone.support[2] += stiffness * arm[1 - c] * arm[1 - c];
      }
    }
    stones.push_back(stone);
  }
  return stones;
}

/// Moved from the middle of a stone to another point.
StoneVector about(const StoneVector& v, const Vector<2>& from, const Vector<2>& to) {
  return {v[0], v[1], v[2] + cross(from - to, Vector<2>{v[0], v[1]})};
}

/// What all ranks know of every block: 1 where a support holds it; 1 where it is not there, all its joints far open.
std::array<std::vector<int>, 2> held_and_absent(const Model<2>& model) {
  const auto& s = model.structure();
  const std::size_t blocks = s.owner_of_block().size();
  std::vector<int> mine(2 * blocks, 0), all(2 * blocks);
  for (std::size_t i = 0; i < model.held().size() / 2; ++i)
    if (model.held()[2 * i] || model.held()[2 * i + 1]) mine[s.blocks()[s.block_of_node()[i]].mesh.id] = 1;
  if (!model.initial_gap().empty()) {
    std::vector<int> near(s.blocks().size(), 0), far(s.blocks().size(), 0);
    for (int k = 0; k < model.points().size(); ++k) {
      const auto& p = model.points().points()[k];
      auto& count = model.initial_gap()[k] >= s.size() ? far : near;
      for (int node : {p.node_i, p.node_j}) ++count[s.block_of_node()[node]];
    }
    for (int b = 0; b < s.owned_blocks(); ++b)
      mine[blocks + s.blocks()[b].mesh.id] = far[b] > 0 && near[b] == 0;
  }
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_MAX, static_cast<int>(mine.size()), mine.data(), all.data());
  return {std::vector<int>(all.begin(), all.begin() + static_cast<long>(blocks)),
          std::vector<int>(all.begin() + static_cast<long>(blocks), all.end())};
}

/// Per owned block the share of its load, with that of its dependants, that it lacks alone between its neighbours [-].
std::vector<double> left_alone(const Model<2>& model, const std::vector<Stone>& stones, const std::vector<double>& own,
                               const std::vector<StoneVector>& loads, double unknown, StoneRelaxation& relaxation) {
  const auto& s = model.structure();
  const auto [held, absent] = held_and_absent(model);
  const DependentStones dependent(model.source().graph(), held, absent);
  const auto& ids = dependent.dependants();
  // Moments are taken about a point of the structure: the middle of the first dependant.
  std::vector<double> mine(6 * ids.size() + 2, 0.0), all(mine.size());
  const auto of = [&](BlockId id) {
    const int b = s.local_block(id);
    return b >= 0 && b < s.owned_blocks() ? b : -1;
  };
  const auto total = [&] {
    Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  };
  if (!ids.empty() && of(ids[0]) >= 0) std::copy_n(stones[of(ids[0])].middle.begin(), 2, mine.end() - 2);
  total();
  const Vector<2> centre{all[all.size() - 2], all[all.size() - 1]};
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const int b = of(ids[k]);
    if (b < 0) continue;
    const auto lacks = about(stones[b].lacks, stones[b].middle, centre);
    const auto load = about(loads[b], stones[b].middle, centre);
    std::copy(lacks.begin(), lacks.end(), mine.begin() + 6L * static_cast<long>(k));
    std::copy(load.begin(), load.end(), mine.begin() + 6L * static_cast<long>(k) + 3);
  }
  total();
  std::vector<BlockSums> sums(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k)
    std::copy_n(all.begin() + 6L * static_cast<long>(k), 6, sums[k].begin());
  const auto below = dependent.sums(std::move(sums));
  std::vector<double> share(s.owned_blocks(), 0.0);
  for (int b = 0; b < s.owned_blocks(); ++b) {
    auto lacks = stones[b].lacks, load = loads[b];
    if (const auto more = below.find(s.blocks()[b].mesh.id); more != below.end()) {
      const auto& m = more->second;
      const auto other_lacks = about({m[0], m[1], m[2]}, centre, stones[b].middle);
      const auto other_load = about({m[3], m[4], m[5]}, centre, stones[b].middle);
      for (int c = 0; c < 3; ++c) {
        lacks[c] += other_lacks[c];
        load[c] += other_load[c];
      }
    }
    const auto rides = [&](int other) {
      return dependent.depends_on(s.blocks()[other].mesh.id) == s.blocks()[b].mesh.id;
    };
    const double borne = std::max(own[b], size_of(load, stones[b].radius));
    const double left = relaxation.alone(b, lacks, std::max(unknown, largest_share_alone * borne), rides);
    if (left > unknown) share[b] = borne > 0 ? left / borne : std::numeric_limits<double>::infinity();
  }
  return share;
}

/// Marks the stones that lack more than they may, on every rank that sees them.
std::vector<char> marked(const Structure<2>& s, const std::vector<double>& lacks, const std::vector<Stone>& stones) {
  std::vector<double> flag(s.nodes(), 0.0);
  for (int b = 0; b < s.owned_blocks(); ++b) flag[s.blocks()[b].first_local] = lacks[b] > stones[b].bearable;
  s.node_exchange().update(flag, 1);
  std::vector<char> loose;
  for (const auto& block : s.blocks()) loose.push_back(flag[block.first_local] != 0);
  return loose;
}

}  // namespace

TieBalance tie_balance(const Model<2>& model, const PointLaws& law, const ContactState& state,
                       const std::vector<int>& cluster, const std::vector<double>& borne,
                       const std::vector<double>& load) {
  const auto& s = model.structure();
  const double stiffness = stiffness_of_springs(model);
  const auto points = springs(model, law, state, cluster, stiffness);
  PointField forces;
  for (const auto& p : points) forces.insert(forces.end(), p.force.begin(), p.force.end());
  auto lacking = borne;
  add_contact_forces(model.points(), {}, forces, -1.0, lacking);
  for (std::size_t i = 0; i < lacking.size(); ++i)
    if (model.held()[i]) lacking[i] = 0;
  const double unknown = noise * model.scene().newton.tolerance * largest_normal_force(model, state.lambda);
  const auto through = passing(model, points);
  auto stones = stones_of(model, stiffness);
  std::vector<double> own(s.owned_blocks());
  std::vector<StoneVector> loads;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    auto& stone = stones[b];
    const auto& block = s.blocks()[b];
    const auto sum = sum_over(s, block, stone.middle, load);
    double magnitudes = 0;
    for (std::size_t i = 0; i < block.mesh.position.size(); ++i)
      magnitudes += std::hypot(load[2 * (block.first_local + i)], load[2 * (block.first_local + i) + 1]);
    // A stone without load, or whose loads are in balance as those of heat are, is measured by what passes through it.
    loads.push_back(sum);
    own[b] = size_of(sum, stone.radius);
    if (own[b] <= balanced * magnitudes) own[b] = through[b];
    stone.lacks = sum_over(s, block, stone.middle, lacking);
    for (double& l : stone.lacks) l = -l;
    stone.bearable = std::max(unknown, largest_tied_share * own[b]);
  }
  StoneRelaxation relaxation(model, stones, points);
  const auto alone = left_alone(model, stones, own, loads, unknown, relaxation);
  auto lacks = relaxation.relax();
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (alone[b] <= largest_share_alone) continue;
    lacks[b] = std::max(lacks[b], alone[b] * own[b]);
    stones[b].bearable = 0;
  }
  TieBalance balance;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (lacks[b] <= stones[b].bearable) continue;
    const double share = own[b] > 0 ? lacks[b] / own[b] : std::numeric_limits<double>::infinity();
    if (share <= balance.largest) continue;
    balance.largest = share;
    balance.where = s.blocks()[b].mesh.id;
  }
  balance.loose = marked(s, lacks, stones);
  const bool here_loose = std::find(balance.loose.begin(), balance.loose.end(), 1) != balance.loose.end();
  balance.any = largest_over_ranks(*s.comm(), here_loose) > 0;
  const double mine = balance.largest;
  balance.largest = largest_over_ranks(*s.comm(), mine);
  // The lowest number of those that share it, so that all ranks name the same.
  const int none = std::numeric_limits<int>::max();
  const int here = balance.where >= 0 && mine == balance.largest ? balance.where : none;
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_MIN, here, Teuchos::outArg(balance.where));
  if (balance.where == none) balance.where = -1;
  return balance;
}

Warnings held_by_ties(double share, int block, const std::string& when) {
  if (block < 0) return {};
  return {{"held_by_ties", "block " + std::to_string(block), when, share,
           number_text(share) + " of its load is borne by tied points beyond the law of their joints, and no round was "
           "left to release them: without ties it may fall; raise selection > largest rounds, or take selection > mode "
           "= all"}};
}

}  // namespace voussoir

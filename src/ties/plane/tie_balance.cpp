#include "ties/plane/tie_balance.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.hpp"
#include "base/finite.hpp"
#include "base/text.hpp"
#include "joints/tractions.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "ties/error_estimate.hpp"

namespace voussoir {
namespace {

/// Stiffness of the springs [N/m]: that of the softest point, for all alike. Which stones find a balance is a matter of
/// places and laws; springs that differ by orders of magnitude would only make them wait for each other. Collective.
double stiffness_of_springs(const Model& model) {
  double softest = std::numeric_limits<double>::max();
  for (int k = 0; k < model.points().size(); ++k) {
    const double sigma = model.local_stiffness()[k];
    softest = std::min(softest, sigma);
    if (model.compliance().empty()) continue;
    for (int c = 0; c < 2; ++c) softest = std::min(softest, sigma / (1 + sigma * model.compliance()[k].along(c)));
  }
  return -largest_over_ranks(*model.structure().comm(), -softest);
}

/// The points as springs, each with the nearest force that its law admits; an open one bears none.
std::vector<StonePoint> springs(const Model& model, const PointLaws& law, const ContactState& state,
                                const std::vector<int>& cluster) {
  std::vector<StonePoint> springs(model.points().size());
  const auto open = open_points(model);
  PointField gap;  // where a point bears nothing
  for (int k = 0; k < model.points().size(); ++k) {
    auto& spring = springs[k];
    spring.law = law[k];
    const bool tied = is_tied(model.points().points()[k], cluster), is_open = !open.empty() && open[k];
    if (!is_open || !tied) {
      spring.force = nearest_lawful(spring.law, Vector<2>{state.lambda[2 * k], state.lambda[2 * k + 1]});
      if (spring.force[0] > -spring.law.tension) continue;
    }
    if (tied && !is_open) continue;
    if (gap.empty()) gap = model.gaps(state.displacement);
    spring.gap = std::max(0.0, gap[2 * k]);
  }
  return springs;
}

StoneVector sum_over(const BlockSystem& s, const NodesOfBlock& block, const Vector<2>& middle,
                     const std::vector<double>& nodal) {
  StoneVector sum{};
  const int first = block.first_local, count = block.nodes;
  for (int i = first; i < first + count; ++i) {
    const Vector<2> f{nodal[2 * i], nodal[2 * i + 1]};
    sum[0] += f[0];
    sum[1] += f[1];
    sum[2] += cross(in_plane(s.place(i)) - middle, f);
  }
  return sum;
}

/// Sum of the magnitudes of nodal forces of a block [N].
double magnitudes_over(const NodesOfBlock& block, const std::vector<double>& nodal) {
  double sum = 0;
  const int first = block.first_local, count = block.nodes;
  for (int i = first; i < first + count; ++i) sum += norm(Vector<2>{nodal[2 * i], nodal[2 * i + 1]});
  return sum;
}

/// The blocks as rigid bodies where they are; supports hold a node as a point does.
std::vector<Stone> stones_of(const Model& model, const DependentStones& dependent, double stiffness) {
  const auto& s = model.structure();
  std::vector<Stone> stones;
  for (int b = 0; b < s.local_blocks(); ++b) {
    const auto& block = s.nodes_of(b);
    Stone stone;
    const int first = block.first_local, count = block.nodes;
    for (int i = first; i < first + count; ++i) stone.middle = stone.middle + (1.0 / count) * in_plane(s.place(i));
    for (int i = first; i < first + count; ++i) {
      const Vector<2> arm = in_plane(s.place(i)) - stone.middle;
      stone.radius = std::max(stone.radius, norm(arm));
      for (int c = 0; c < 2; ++c) {
        if (!model.held()[2 * i + c]) continue;
        stone.support[c] += stiffness;
        stone.support[2] += stiffness * arm[1 - c] * arm[1 - c];
      }
    }
    if (const BlockId under = dependent.depends_on(block.id); under >= 0) stone.rides_on = s.local_block(under);
    stones.push_back(stone);
  }
  return stones;
}

/// Moved from the middle of a stone to another point.
StoneVector about(const StoneVector& v, const Vector<2>& from, const Vector<2>& to) {
  return {v[0], v[1], v[2] + cross(from - to, Vector<2>{v[0], v[1]})};
}

/// 1 for each owned block that is not there, all its joints far open; empty for none.
std::vector<char> absent_here(const Model& model) {
  const auto& s = model.structure();
  const auto& gap = model.initial_gap();
  const auto is_far = [&](double g) { return g >= s.size(); };
  if (std::none_of(gap.begin(), gap.end(), is_far)) return {};
  std::vector<int> near(s.local_blocks(), 0), far(s.local_blocks(), 0);
  for (int k = 0; k < model.points().size(); ++k) {
    const auto& joint = model.points().joint_of(k);
    auto& count = is_far(gap[k]) ? far : near;
    ++count[joint.local_i];
    ++count[joint.local_j];
  }
  std::vector<char> absent(s.owned_blocks());
  for (int b = 0; b < s.owned_blocks(); ++b) absent[b] = far[b] > 0 && near[b] == 0;
  return absent;
}

/// Which stones depend on which, from what every rank knows of its own. Collective.
DependentStones dependent_stones(const Model& model, const std::vector<char>& absent) {
  const auto& s = model.structure();
  const auto blocks = static_cast<long>(s.owner_of_block().size());
  std::vector<int> mine(2 * blocks, 0);  // is a block held, is it absent
  for (std::size_t i = 0; i < model.held().size() / 2; ++i)
    if (model.held()[2 * i] || model.held()[2 * i + 1]) mine[s.nodes_of(s.block_of_node()[i]).id] = 1;
  for (std::size_t b = 0; b < absent.size(); ++b) mine[blocks + s.nodes_of(static_cast<int>(b)).id] = absent[b];
  const auto all = largest_of_each(*s.comm(), mine);
  return {model.graph(), {all.begin(), all.begin() + blocks}, {all.begin() + blocks, all.end()}};
}

/// Marks the stones that lack more than they may, on every rank that sees them.
std::vector<char> marked(const BlockSystem& s, const std::vector<double>& lacks, const std::vector<double>& bearable) {
  std::vector<double> flag(s.nodes(), 0.0);
  for (int b = 0; b < s.owned_blocks(); ++b) flag[s.nodes_of(b).first_local] = lacks[b] > bearable[b];
  s.node_exchange().update(flag, 1);
  std::vector<char> loose;
  for (int b = 0; b < s.local_blocks(); ++b) loose.push_back(flag[s.nodes_of(b).first_local] != 0);
  return loose;
}

/// The stones that lack more than they may, with the largest share of them all and where it is.
TieBalance balance_of(const BlockSystem& s, const std::vector<double>& lacks, const std::vector<double>& bearable,
                      const std::vector<double>& own) {
  TieBalance balance;
  balance.any = true;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (lacks[b] <= bearable[b]) continue;
    const double share = own[b] > 0 ? lacks[b] / own[b] : std::numeric_limits<double>::infinity();
    if (share <= balance.largest) continue;
    balance.largest = share;
    balance.where = s.nodes_of(b).id;
  }
  balance.loose = marked(s, lacks, bearable);
  const double mine = balance.largest;
  balance.largest = largest_over_ranks(*s.comm(), mine);
  // The lowest number of those that share it, so that all ranks name the same.
  const int none = std::numeric_limits<int>::max();
  balance.where = least_over_ranks(*s.comm(), balance.where >= 0 && mine == balance.largest ? balance.where : none);
  if (balance.where == none) balance.where = -1;
  return balance;
}

}  // namespace

/// What depends on nothing but where stones are, what holds them and which are there.
struct TieCriterion::Stones {
  Stones(const Model& model, std::vector<char> absent_here, double stiffness)
      : arrangement(model.arrangement()),
        absent(std::move(absent_here)),
        dependent(dependent_stones(model, absent)),
        relaxation(model, stones_of(model, dependent, stiffness), stiffness) {
    // Moments are taken about a point of the structure: the middle of the first dependant.
    if (dependent.dependants().empty()) return;
    const auto& s = model.structure();
    const int first = s.local_block(dependent.dependants()[0]);
    if (first >= 0 && first < s.owned_blocks()) centre = relaxation.stones()[first].middle;
    centre = total_of_each(*s.comm(), centre);
  }

  int arrangement;
  std::vector<char> absent;  ///< owned blocks
  DependentStones dependent;
  StoneRelaxation relaxation;
  Vector<2> centre{};
};

TieCriterion::TieCriterion(const Model& model) : model_(model) {
  VOUSSOIR_EXPECT(model.components() == 2 && "stones are let go in the plane");
}
TieCriterion::~TieCriterion() = default;

/// Makes what depends on the stones alone. Collective.
void TieCriterion::arrange(std::vector<char> absent) {
  stones_ = std::make_unique<Stones>(model_, std::move(absent), stiffness_of_springs(model_));
}

/// What the dependants of blocks lack, and their loads; makes anew what it takes where stones have come or gone.
/// Collective.
std::map<BlockId, BlockSums> TieCriterion::of_dependants(const Demands& demands) {
  const auto& s = model_.structure();
  for (;;) {
    const auto& ids = stones_->dependent.dependants();
    std::vector<double> mine(6 * ids.size() + 1, 0.0);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const int b = s.local_block(ids[k]);
      if (b < 0 || b >= s.owned_blocks()) continue;
      const auto& middle = stones_->relaxation.stones()[b].middle;
      const auto lack = about(demands.lacks[b], middle, stones_->centre);
      const auto load = about(demands.loads[b], middle, stones_->centre);
      std::copy(lack.begin(), lack.end(), mine.begin() + 6L * static_cast<long>(k));
      std::copy(load.begin(), load.end(), mine.begin() + 6L * static_cast<long>(k) + 3);
    }
    auto absent = absent_here(model_);
    mine.back() = absent != stones_->absent;
    const auto all = total_of_each(*s.comm(), mine);
    if (all.back() > 0) {
      arrange(std::move(absent));
      continue;
    }
    std::vector<BlockSums> sums(ids.size());
    for (std::size_t k = 0; k < ids.size(); ++k)
      std::copy_n(all.begin() + 6L * static_cast<long>(k), 6, sums[k].begin());
    return stones_->dependent.sums(std::move(sums));
  }
}

/// Per owned block the share of its load, with that of its dependants, that it lacks alone between its neighbours [-].
std::vector<double> TieCriterion::left_alone(const Demands& demands, double unknown,
                                             const std::map<BlockId, BlockSums>& below) {
  const auto& s = model_.structure();
  auto& relaxation = stones_->relaxation;
  const double bearable = model_.settings().internals.ties.largest_share_alone;
  std::vector<double> share(s.owned_blocks(), 0.0);
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& stone = relaxation.stones()[b];
    auto lacks = demands.lacks[b], load = demands.loads[b];
    if (const auto more = below.find(s.nodes_of(b).id); more != below.end()) {
      const auto& m = more->second;
      const auto other_lacks = about({m[0], m[1], m[2]}, stones_->centre, stone.middle);
      const auto other_load = about({m[3], m[4], m[5]}, stones_->centre, stone.middle);
      for (int c = 0; c < 3; ++c) {
        lacks[c] += other_lacks[c];
        load[c] += other_load[c];
      }
    }
    const double borne = std::max(demands.own[b], size_of(load, stone.radius));
    const double left = relaxation.alone(b, lacks, std::max(unknown, bearable * borne));
    if (left > unknown) share[b] = borne > 0 ? left / borne : std::numeric_limits<double>::infinity();
  }
  return share;
}

/// What stones lack where every point gives no more than its law admits, and their loads.
TieCriterion::Demands TieCriterion::demands_of(const std::vector<StonePoint>& points, const std::vector<double>& borne,
                                               const std::vector<double>& load) const {
  const auto& s = model_.structure();
  PointField forces;
  for (const auto& p : points) forces.insert(forces.end(), p.force.begin(), p.force.end());
  auto lacking = borne;
  add_contact_forces(model_.points(), {}, forces, -1.0, lacking);
  for (std::size_t i = 0; i < lacking.size(); ++i)
    if (model_.held()[i]) lacking[i] = 0;
  Demands demands;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& stone = stones_->relaxation.stones()[b];
    demands.loads.push_back(sum_over(s, s.nodes_of(b), stone.middle, load));
    demands.lacks.push_back(sum_over(s, s.nodes_of(b), stone.middle, lacking));
    for (double& l : demands.lacks[b]) l = -l;
  }
  return demands;
}

/// Per owned block what shares refer to [N]: its load. A stone without load, or whose loads are in balance as those of
/// heat are, is measured by what passes through it.
std::vector<double> TieCriterion::measures(const Demands& demands, const std::vector<double>& load) const {
  const auto& s = model_.structure();
  const auto& relaxation = stones_->relaxation;
  const double balanced = model_.settings().internals.ties.balanced;
  std::vector<double> own;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    own.push_back(size_of(demands.loads[b], relaxation.stones()[b].radius));
    if (own[b] <= balanced * magnitudes_over(s.nodes_of(b), load)) own[b] = relaxation.passing(b);
  }
  return own;
}

TieBalance TieCriterion::judge(const PointLaws& law, const ContactState& state, const std::vector<int>& cluster,
                               const std::vector<double>& borne, const std::vector<double>& load,
                               double largest_normal) {
  VOUSSOIR_EXPECT(is_per_point(model_, law) && "laws: per point");
  VOUSSOIR_EXPECT(is_of_points(model_, state.lambda) && all_finite(state.lambda) && "lambda: of points, finite");
  VOUSSOIR_EXPECT(cluster.size() == static_cast<std::size_t>(model_.structure().nodes()) && "cluster: per node copy");
  VOUSSOIR_EXPECT(is_of_nodes(model_, borne) && "borne: of node copies");
  VOUSSOIR_EXPECT(is_of_nodes(model_, load) && "load: of node copies");
  VOUSSOIR_EXPECT(largest_normal >= 0 && "largest force: not negative");
  const auto& s = model_.structure();
  const auto& numbers = model_.settings().internals.ties;
  if (!stones_ || stones_->arrangement != model_.arrangement()) arrange(absent_here(model_));
  auto points = springs(model_, law, state, cluster);
  auto demands = demands_of(points, borne, load);
  const auto below = of_dependants(demands);
  auto& relaxation = stones_->relaxation;
  relaxation.begin(std::move(points), demands.lacks);
  demands.own = measures(demands, load);
  const double unknown = model_.settings().internals.step.noise * model_.settings().newton.tolerance * largest_normal;
  std::vector<double> bearable;
  for (const double own : demands.own) bearable.push_back(std::max(unknown, numbers.largest_share * own));
  const auto alone = left_alone(demands, unknown, below);
  const auto is_loose_alone = [&](double share) { return share > numbers.largest_share_alone; };
  const auto relaxed =
      relaxation.relax(bearable, static_cast<int>(std::count_if(alone.begin(), alone.end(), is_loose_alone)));
  if (!relaxed.any_loose) return {};
  auto lacks = relaxed.lacks;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!is_loose_alone(alone[b])) continue;
    lacks[b] = std::max(lacks[b], alone[b] * demands.own[b]);
    bearable[b] = 0;
  }
  return balance_of(s, lacks, bearable, demands.own);
}

Warnings held_by_ties(double share, int block, const std::string& when) {
  if (block < 0) return {};
  return {
      {"held_by_ties", "block " + std::to_string(block), when, share,
       number_text(share) +
           " of its load is borne by tied points beyond the law of their joints, and no round was "
           "left to release them: without ties it may fall; raise selection > largest rounds, or take selection > mode "
           "= all"}};
}

}  // namespace voussoir

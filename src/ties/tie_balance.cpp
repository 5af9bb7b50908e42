#include "ties/tie_balance.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "base/components.hpp"
#include "base/finite.hpp"
#include "base/text.hpp"
#include "joints/tractions.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "ties/rigid_stones.hpp"

namespace voussoir {
namespace {

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

/// What depends on nothing but where stones are, what holds them and which are there.
template <int dim>
struct Stones {
  Stones(const Model& model, std::vector<char> absent_here, double stiffness)
      : arrangement(model.arrangement()),
        absent(std::move(absent_here)),
        dependent(dependent_stones(model, absent)),
        relaxation(model, stones_of<dim>(model, dependent, stiffness), stiffness) {
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
  StoneRelaxation<dim> relaxation;
  Vector<dim> centre{};
};

}  // namespace

template <int dim>
class TieCriterion::KernelIn final : public Kernel {
 public:
  explicit KernelIn(const Model& model) : model_(model) {}
  TieBalance judge(const PointLaws&, const ContactState&, const std::vector<int>& cluster,
                   const std::vector<double>& borne, const std::vector<double>& load, double unknown) override;

 private:
  static constexpr int ways = ways_of_stone(dim);
  struct Demands {  ///< of owned blocks
    std::vector<StoneVector<dim>> lacks, loads;
    std::vector<double> own;  ///< [N] that shares refer to
  };
  void arrange(std::vector<char> absent);
  Demands demands_of(const std::vector<StonePoint<dim>>&, const std::vector<double>& borne,
                     const std::vector<double>& load) const;
  std::vector<double> measures(const Demands&, const std::vector<double>& load) const;
  std::map<BlockId, BlockSums> of_dependants(const Demands&);
  std::vector<double> left_alone(const Demands&, double unknown, const std::map<BlockId, BlockSums>& below);

  const Model& model_;
  std::unique_ptr<Stones<dim>> stones_;
};

/// Makes what depends on the stones alone. Collective.
template <int dim>
void TieCriterion::KernelIn<dim>::arrange(std::vector<char> absent) {
  stones_ = std::make_unique<Stones<dim>>(model_, std::move(absent), stiffness_of_springs(model_));
}

/// What the dependants of blocks lack, and their loads; makes anew what it takes where stones have come or gone.
/// Collective.
template <int dim>
std::map<BlockId, BlockSums> TieCriterion::KernelIn<dim>::of_dependants(const Demands& demands) {
  const auto& s = model_.structure();
  for (;;) {
    const auto& ids = stones_->dependent.dependants();
    std::vector<double> mine(2 * ways * ids.size() + 1, 0.0);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const int b = s.local_block(ids[k]);
      if (b < 0 || b >= s.owned_blocks()) continue;
      const auto& middle = stones_->relaxation.stones()[b].middle;
      const auto lack = about(demands.lacks[b], middle, stones_->centre);
      const auto load = about(demands.loads[b], middle, stones_->centre);
      const auto at = mine.begin() + 2L * ways * static_cast<long>(k);
      std::copy(lack.begin(), lack.end(), at);
      std::copy(load.begin(), load.end(), at + ways);
    }
    auto absent = absent_here(model_);
    mine.back() = absent != stones_->absent;
    const auto all = total_of_list(*s.comm(), mine, WhyWhole{"stones that only ties hold"});
    if (all.back() > 0) {
      arrange(std::move(absent));
      continue;
    }
    std::vector<BlockSums> sums(ids.size(), BlockSums{});
    for (std::size_t k = 0; k < ids.size(); ++k)
      std::copy_n(all.begin() + 2L * ways * static_cast<long>(k), 2 * ways, sums[k].begin());
    return stones_->dependent.sums(std::move(sums));
  }
}

/// Per owned block the share of its load, with that of its dependants, that it lacks alone between its neighbours [-].
template <int dim>
std::vector<double> TieCriterion::KernelIn<dim>::left_alone(const Demands& demands, double unknown,
                                                            const std::map<BlockId, BlockSums>& below) {
  const auto& s = model_.structure();
  auto& relaxation = stones_->relaxation;
  const double bearable = model_.settings().internals.ties.largest_share_alone;
  std::vector<double> share(s.owned_blocks(), 0.0);
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& stone = relaxation.stones()[b];
    auto lacks = demands.lacks[b], load = demands.loads[b];
    if (const auto more = below.find(s.nodes_of(b).id); more != below.end()) {
      StoneVector<dim> other_lacks, other_load;
      std::copy_n(more->second.begin(), ways, other_lacks.begin());
      std::copy_n(more->second.begin() + ways, ways, other_load.begin());
      lacks = lacks + about(other_lacks, stones_->centre, stone.middle);
      load = load + about(other_load, stones_->centre, stone.middle);
    }
    const double borne = std::max(demands.own[b], size_of(load, stone.radius));
    const double left = relaxation.alone(b, lacks, std::max(unknown, bearable * borne));
    if (left > unknown) share[b] = borne > 0 ? left / borne : std::numeric_limits<double>::infinity();
  }
  return share;
}

/// What stones lack where every point gives no more than its law admits, and their loads.
template <int dim>
typename TieCriterion::KernelIn<dim>::Demands TieCriterion::KernelIn<dim>::demands_of(
    const std::vector<StonePoint<dim>>& points, const std::vector<double>& borne,
    const std::vector<double>& load) const {
  const auto& s = model_.structure();
  PointField forces;
  for (const auto& p : points) forces.insert(forces.end(), p.force.begin(), p.force.end());
  auto lacking = borne;
  add_contact_forces(model_.points(), {}, forces, -1.0, lacking);
  const auto held = model_.held().held_part(lacking, s.components());
  for (std::size_t i = 0; i < lacking.size(); ++i) lacking[i] -= held[i];
  Demands demands;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& stone = stones_->relaxation.stones()[b];
    demands.loads.push_back(sum_over<dim>(s, s.nodes_of(b), stone.middle, load));
    demands.lacks.push_back(sum_over<dim>(s, s.nodes_of(b), stone.middle, lacking));
    for (double& l : demands.lacks[b]) l = -l;
  }
  return demands;
}

/// Per owned block what shares refer to [N]: its load. A stone without load, or whose loads are in balance as those of
/// heat are, is measured by what passes through it.
template <int dim>
std::vector<double> TieCriterion::KernelIn<dim>::measures(const Demands& demands,
                                                          const std::vector<double>& load) const {
  const auto& s = model_.structure();
  const auto& relaxation = stones_->relaxation;
  const double balanced = model_.settings().internals.ties.balanced;
  std::vector<double> own;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    own.push_back(size_of(demands.loads[b], relaxation.stones()[b].radius));
    if (own[b] <= balanced * magnitudes_over<dim>(s.nodes_of(b), load)) own[b] = relaxation.passing(b);
  }
  return own;
}

template <int dim>
TieBalance TieCriterion::KernelIn<dim>::judge(const PointLaws& law, const ContactState& state,
                                              const std::vector<int>& cluster, const std::vector<double>& borne,
                                              const std::vector<double>& load, double unknown) {
  const auto& s = model_.structure();
  const auto& numbers = model_.settings().internals.ties;
  if (!stones_ || stones_->arrangement != model_.arrangement()) arrange(absent_here(model_));
  auto points = springs<dim>(model_, law, state, cluster);
  auto demands = demands_of(points, borne, load);
  const auto below = of_dependants(demands);
  auto& relaxation = stones_->relaxation;
  relaxation.begin(std::move(points), demands.lacks);
  demands.own = measures(demands, load);
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

TieCriterion::TieCriterion(const Model& model) : model_(model) {
  with_components(model.components(), [&](auto dim) { kernel_ = std::make_unique<KernelIn<dim>>(model); });
}
TieCriterion::~TieCriterion() = default;

TieBalance TieCriterion::judge(const PointLaws& law, const ContactState& state, const std::vector<int>& cluster,
                               const std::vector<double>& borne, const std::vector<double>& load,
                               double largest_normal) {
  VOUSSOIR_EXPECT(is_per_point(model_, law) && "laws: per point");
  VOUSSOIR_EXPECT(is_of_points(model_, state.lambda) && all_finite(state.lambda) && "lambda: of points, finite");
  VOUSSOIR_EXPECT(cluster.size() == static_cast<std::size_t>(model_.structure().nodes()) && "cluster: per node copy");
  VOUSSOIR_EXPECT(is_of_nodes(model_, borne) && "borne: of node copies");
  VOUSSOIR_EXPECT(is_of_nodes(model_, load) && "load: of node copies");
  VOUSSOIR_EXPECT(largest_normal >= 0 && "largest force: not negative");
  const double unknown = model_.settings().internals.step.noise * model_.settings().newton.tolerance * largest_normal;
  return kernel_->judge(law, state, cluster, borne, load, unknown);
}

Warnings held_by_ties(double share, int block, const std::string& when) {
  if (block < 0) return {};
  return {
      {"held_by_ties", "block " + std::to_string(block), when, share,
       three_digits(100 * share) +
           " % of its load is borne by tied points beyond the law of their joints, and no round was "
           "left to release them: without ties it may fall; raise selection > largest rounds, or take selection > mode "
           "= all"}};
}

}  // namespace voussoir

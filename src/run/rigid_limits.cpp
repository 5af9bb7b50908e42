#include "run/rigid_limits.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/check.hpp"
#include "blocks/supports.hpp"
#include "linalg/agree.hpp"
#include "linalg/parcels.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"

namespace voussoir {
namespace {

template <int dim>
struct StoneRow {
  BlockId block;
  bool absent;
  RigidStone<dim> stone;
};
template <int dim>
struct PointRow {
  PointId id;
  BlockId block_i, block_j;
  RigidContact<dim> contact;
};
template <int dim>
struct SupportRow {
  BlockId block;
  RigidSupport<dim> support;
  bool again;  ///< others hold its node so too
};

template <int dim>
Vector<dim> of_node(const std::vector<double>& field, int node) {
  Vector<dim> v;
  for (int c = 0; c < dim; ++c) v[c] = field[dim * node + c];
  return v;
}

template <int dim>
Vector<dim> unit_vector(int component) {
  Vector<dim> e{};
  e[component] = 1;
  return e;
}

/// Places count from the middle of the structure, so that they keep their digits wherever the drawing has its origin.
template <int dim>
Vector<dim> place_of(const Structure<dim>& s, int node) {
  return s.position()[node] - s.middle();
}

template <int dim>
StoneRow<dim> stone_of(const Structure<dim>& s, int b, const RigidTask& task) {
  const auto& block = s.blocks()[b];
  const int first = block.first_local, count = block.nodes;
  StoneRow<dim> row{block.mesh.id, task.absent && !task.absent->empty() && (*task.absent)[b], {}};
  auto& stone = row.stone;
  for (int n = first; n < first + count; ++n) stone.middle = stone.middle + (1.0 / count) * place_of(s, n);
  stone.radius = 0;
  Resultant<dim> fixed, raised;
  for (int n = first; n < first + count; ++n) {
    const auto arm = place_of(s, n) - stone.middle;
    stone.radius = std::max(stone.radius, norm(arm));
    if (row.absent) continue;
    if (!task.fixed.empty()) fixed.add(arm, of_node<dim>(task.fixed, n));
    if (!task.raised.empty()) raised.add(arm, of_node<dim>(task.raised, n));
  }
  stone.fixed = fixed.wrench(stone.radius), stone.raised = raised.wrench(stone.radius);
  return row;
}

/// What holds all of a stone: as many components at its middle, and what keeps it from turning.
template <int dim>
std::vector<RigidSupport<dim>> holding_all(double radius) {
  std::vector<RigidSupport<dim>> held;
  for (int c = 0; c < dim; ++c) held.push_back({0, {}, unit_vector<dim>(c), -1});
  for (int c = 0; c < (dim == 2 ? 1 : 3); ++c)  // one end of each axis, across it
    held.push_back({0, radius * unit_vector<dim>(c), unit_vector<dim>((c + 1) % dim), -1});
  return held;
}

template <int dim>
std::vector<SupportRow<dim>> supports_of(const ModelOfBlocks<dim>& model, const std::vector<StoneRow<dim>>& stones) {
  const auto& s = model.structure();
  std::vector<SupportRow<dim>> rows;
  const auto& names = model.supports();
  std::map<int, Directions<dim>> known;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto& support = names[k].parameters;
    for (const auto& [n, held] : held_along(s, support, facet_set(model.source(), {support.on, support.blocks}))) {
      if (n >= s.owned_nodes()) continue;
      const int b = s.block_of_node()[n];
      for (const auto& along : held) {
        const bool again = !known[n].add(along);
        const auto arm = place_of(s, n) - stones[b].stone.middle;
        rows.push_back({s.blocks()[b].mesh.id, {0, arm, along, static_cast<int>(k)}, again});
      }
    }
  }
  for (const auto& row : stones)
    if (row.absent)
      for (const auto& support : holding_all<dim>(row.stone.radius)) rows.push_back({row.block, support, false});
  return rows;
}

template <int dim>
std::vector<PointRow<dim>> points_of(const ModelOfBlocks<dim>& model, const RigidTask& task) {
  const auto& s = model.structure();
  std::vector<Vector<dim>> middle(s.blocks().size());
  for (std::size_t b = 0; b < middle.size(); ++b) middle[b] = stone_of(s, static_cast<int>(b), {}).stone.middle;
  std::vector<PointRow<dim>> rows;
  for (int k = 0; k < model.points().owned(); ++k) {
    const auto& p = model.points().points()[k];
    const auto nodes = model.points().at(k);
    const int i = model.points().joint_of(k).local_i, j = model.points().joint_of(k).local_j;
    if (task.absent && !task.absent->empty() && ((*task.absent)[i] || (*task.absent)[j])) continue;
    RigidContact<dim> c;
    c.arm_i = nodes.place(Side::i, s.position()) - s.middle() - middle[i];
    c.arm_j = nodes.place(Side::j, s.position()) - s.middle() - middle[j];
    for (int a = 0; a < dim; ++a)
      for (int x = 0; x < dim; ++x) c.axis[a][x] = p.axis[a][x];
    c.law = task.state ? law_left(model, *task.state, k) : model.law()[k];
    rows.push_back({p.id, s.blocks()[i].mesh.id, s.blocks()[j].mesh.id, c});
  }
  return rows;
}

/// By support, and there by block, as one rank finds them: of many answers that are as good a programme gives the one
/// that its order leads to.
template <int dim>
void sort_as_on_one_rank(std::vector<SupportRow<dim>>& rows) {
  const auto key = [](const SupportRow<dim>& row) {
    const int name = row.support.name;
    return std::make_pair(name < 0 ? std::numeric_limits<int>::max() : name, row.block);
  };
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

/// For the first rank, of what all have sent.
/// @param points  ascending: those of a joint follow each other
template <int dim>
RigidStructure<dim> structure_of(std::vector<StoneRow<dim>> stones, const std::vector<PointRow<dim>>& points,
                                 const std::vector<SupportRow<dim>>& supports) {
  std::sort(stones.begin(), stones.end(), [](const auto& a, const auto& b) { return a.block < b.block; });
  RigidStructure<dim> rigid;
  for (const auto& row : stones) rigid.stones.push_back(row.stone);
  const auto number = [&](BlockId block) {
    const auto at = std::lower_bound(stones.begin(), stones.end(), block,
                                     [](const StoneRow<dim>& a, BlockId b) { return a.block < b; });
    return static_cast<int>(at - stones.begin());
  };
  int joint = -1;
  for (std::size_t k = 0; k < points.size(); ++k) {
    auto c = points[k].contact;
    if (k == 0 || points[k - 1].block_i != points[k].block_i || points[k - 1].block_j != points[k].block_j) ++joint;
    c.stone_i = number(points[k].block_i);
    c.stone_j = number(points[k].block_j);
    c.joint = joint;
    rigid.contacts.push_back(c);
  }
  for (const auto& row : supports) {
    auto support = row.support;
    support.stone = number(row.block);
    (row.again ? rigid.held_again : rigid.supports).push_back(support);
  }
  return rigid;
}

}  // namespace

template <int dim>
RigidLimits<dim>::RigidLimits(const ModelOfBlocks<dim>& model, const RigidTask& task) : model_(model) {
  VOUSSOIR_EXPECT((task.fixed.empty() || is_of_nodes(model, task.fixed)) && "loads that stay: of node copies");
  VOUSSOIR_EXPECT((task.raised.empty() || is_of_nodes(model, task.raised)) && "raised loads: of node copies, or none");
  VOUSSOIR_EXPECT((!task.absent || task.absent->empty() || task.absent->size() == model.structure().blocks().size()) &&
                  "absent: per block, or none");
  const auto& s = model.structure();
  const auto& comm = *s.comm();
  std::vector<StoneRow<dim>> own;
  for (int b = 0; b < s.owned_blocks(); ++b) own.push_back(stone_of(s, b, task));
  auto supports = gather_on_first(supports_of(model, own), comm);
  const auto stones = gather_on_first(own, comm);
  auto points = gather_on_first(points_of(model, task), comm);
  std::vector<BlockId> blocks;
  for (int b = 0; b < s.local_blocks(); ++b) {
    middle_.push_back(stone_of(s, b, {}).stone.middle);
    blocks.push_back(s.nodes_of(b).id);
  }
  std::vector<PointId> ids;
  for (const auto& point : model.points().points()) ids.push_back(point.id);
  blocks_of_rank_ = exchange_parcels<BlockId>({{0, std::move(blocks)}}, comm);
  points_of_rank_ = exchange_parcels<PointId>({{0, std::move(ids)}}, comm);
  on_first_rank(comm, [&] {
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    for (const auto& row : points) ids_.push_back(row.id);
    sort_as_on_one_rank(supports);
    analysis_ = std::make_unique<const LimitAnalysis<dim>>(structure_of(stones, points, supports));
  });
}

/// The first rank asks, the others are told; what it found of stones and points goes by on_nodes() and on_points().
template <int dim>
template <class Ask>
LimitAnswer<dim> RigidLimits<dim>::ask_first_rank(const Ask& ask) const {
  const auto& comm = *model_.structure().comm();
  LimitAnswer<dim> answer;
  on_first_rank(comm, [&] { answer = ask(*analysis_); });
  if (comm.getSize() == 1) return answer;
  double head[5] = {static_cast<double>(answer.verdict), answer.factor, answer.out_of_balance,
                    static_cast<double>(answer.iterations), answer.dilates ? 1.0 : 0.0};
  Teuchos::broadcast(comm, 0, 5, head);
  answer.verdict = static_cast<LimitVerdict>(static_cast<int>(head[0]));
  answer.factor = head[1], answer.out_of_balance = head[2], answer.iterations = static_cast<int>(head[3]);
  answer.dilates = head[4] > 0;
  return answer;
}

template <int dim>
template <class Ask>
bool RigidLimits<dim>::first_rank_says(const Ask& ask) const {
  int said = 0;
  on_first_rank(*model_.structure().comm(), [&] { said = ask(*analysis_) ? 1 : 0; });
  Teuchos::broadcast(*model_.structure().comm(), 0, Teuchos::outArg(said));
  return said > 0;
}

template <int dim>
LimitAnswer<dim> RigidLimits<dim>::largest_factor(double largest, const LimitAnswer<dim>& borne) const {
  return ask_first_rank([&](const LimitAnalysis<dim>& a) { return a.largest_factor(largest, borne); });
}

template <int dim>
LimitAnswer<dim> RigidLimits<dim>::largest_borne(double largest, const LimitAnswer<dim>& begin) const {
  return ask_first_rank([&](const LimitAnalysis<dim>& a) { return a.largest_borne(largest, begin.basis, true); });
}

template <int dim>
LimitAnswer<dim> RigidLimits<dim>::bears(double factor) const {
  return ask_first_rank([&](const LimitAnalysis<dim>& a) { return a.bears(factor); });
}

template <int dim>
LimitAnswer<dim> RigidLimits<dim>::refuses(double factor) const {
  return ask_first_rank([&](const LimitAnalysis<dim>& a) { return a.refuses(factor); });
}

template <int dim>
bool RigidLimits<dim>::borne_at_any_factor() const {
  return first_rank_says([](const LimitAnalysis<dim>& a) { return a.borne_at_any_factor(); });
}

template <int dim>
LimitAnswer<dim> RigidLimits<dim>::least_pressed(double factor) const {
  return ask_first_rank([factor](const LimitAnalysis<dim>& a) { return a.least_pressed(factor); });
}

template <int dim>
bool RigidLimits<dim>::is_rows() const {
  return first_rank_says([](const LimitAnalysis<dim>& a) { return a.is_rows(); });
}

template <int dim>
LimitAnswer<dim> RigidLimits<dim>::most_balanced(double factor, double* free_share,
                                                 const LimitAnswer<dim>& borne) const {
  double share = 0;
  const auto answer =
      ask_first_rank([&](const LimitAnalysis<dim>& a) { return a.most_balanced(factor, &share, borne); });
  Teuchos::broadcast(*model_.structure().comm(), 0, Teuchos::outArg(share));
  if (free_share) *free_share = share;
  return answer;
}

template <int dim>
std::optional<double> RigidLimits<dim>::without_dilatancy(double largest, const LimitAnswer<dim>& associated) const {
  double found[2] = {0, 0};
  on_first_rank(*model_.structure().comm(), [&] {
    if (const auto factor = analysis_->without_dilatancy(largest, associated)) found[0] = 1, found[1] = *factor;
  });
  Teuchos::broadcast(*model_.structure().comm(), 0, 2, found);
  return found[0] > 0 ? std::optional<double>(found[1]) : std::nullopt;
}

template <int dim>
std::vector<std::array<ReactionRange, dim>> RigidLimits<dim>::reactions(int supports, double factor,
                                                                        const LimitAnswer<dim>& borne) const {
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> ends(2 * dim * static_cast<std::size_t>(supports));
  on_first_rank(*model_.structure().comm(), [&] {
    const auto ranges = analysis_->reactions(supports, factor, borne);
    for (std::size_t k = 0; k < dim * ranges.size(); ++k) {
      const auto& range = ranges[k / dim][k % dim];
      ends[2 * k] = range.least.value_or(-none), ends[2 * k + 1] = range.most.value_or(none);
    }
  });
  if (!ends.empty()) Teuchos::broadcast(*model_.structure().comm(), 0, static_cast<int>(ends.size()), ends.data());
  std::vector<std::array<ReactionRange, dim>> ranges(static_cast<std::size_t>(supports));
  for (std::size_t k = 0; k < dim * ranges.size(); ++k) {
    if (ends[2 * k] > -none) ranges[k / dim][k % dim].least = ends[2 * k];
    if (ends[2 * k + 1] < none) ranges[k / dim][k % dim].most = ends[2 * k + 1];
  }
  return ranges;
}

template <int dim>
std::vector<double> RigidLimits<dim>::on_nodes(const LimitAnswer<dim>& answer) const {
  const auto& s = model_.structure();
  using Motion = typename decltype(answer.motion)::value_type;
  std::vector<Parcel<Motion>> parcels;
  if (!answer.motion.empty())
    for (const auto& [rank, blocks] : blocks_of_rank_) {
      parcels.push_back({rank, {}});
      for (const BlockId b : blocks) parcels.back().items.push_back(answer.motion[b]);
    }
  const auto came = exchange_parcels(std::move(parcels), *s.comm());
  std::vector<double> motion(dim * static_cast<std::size_t>(s.nodes()), 0.0);
  double largest = 0;
  for (int n = 0; n < s.nodes() && !came.empty(); ++n) {
    const int block = s.block_of_node()[n];
    const auto v = velocity_at(came.front().items[block], place_of(s, n) - middle_[block]);
    std::copy(v.begin(), v.end(), &motion[dim * n]);
    if (n < s.owned_nodes()) largest = std::max(largest, length(v));
  }
  largest = largest_over_ranks(*s.comm(), largest);
  for (auto& m : motion) m /= largest > 0 ? largest : 1.0;
  return motion;
}

template <int dim>
PointField RigidLimits<dim>::on_points(const LimitAnswer<dim>& answer) const {
  std::vector<Parcel<Vector<dim>>> parcels;
  if (!answer.force.empty())
    for (const auto& [rank, points] : points_of_rank_) {
      parcels.push_back({rank, {}});
      for (const PointId id : points) {
        const auto at = std::lower_bound(ids_.begin(), ids_.end(), id);
        const bool known = at != ids_.end() && *at == id;
        parcels.back().items.push_back(known ? answer.force[static_cast<std::size_t>(at - ids_.begin())]
                                             : Vector<dim>{});
      }
    }
  PointField force(dim * model_.points().points().size(), 0.0);
  for (const auto& parcel : exchange_parcels(std::move(parcels), *model_.structure().comm()))
    for (std::size_t k = 0; k < parcel.items.size(); ++k)
      std::copy(parcel.items[k].begin(), parcel.items[k].end(), &force[dim * k]);
  return force;
}

namespace {

template <int dim>
RigidVerdict verdict_of(const RigidLimits<dim>& limits, const LimitAnswer<dim>& answer) {
  RigidVerdict told;
  told.verdict = answer.verdict;
  told.factor = answer.factor;
  if (answer.verdict != LimitVerdict::refused && answer.verdict != LimitVerdict::limited) return told;
  told.mechanism = limits.on_nodes(answer);
  told.dilates = answer.dilates;
  told.lambda = limits.on_points(answer);
  return told;
}

}  // namespace

template <int dim>
RigidVerdict RigidTheorem<dim>::refuses(const RigidTask& task) const {
  const RigidLimits<dim> limits(model_, task);
  return verdict_of(limits, limits.refuses(0));
}

template <int dim>
RigidVerdict RigidTheorem<dim>::largest_factor(const RigidTask& task, double largest, bool estimates) const {
  const RigidLimits<dim> limits(model_, task);
  const auto answer = limits.largest_factor(largest);
  auto told = verdict_of(limits, answer);
  if (estimates && answer.verdict == LimitVerdict::limited)  // whether a rank has nodes that move or none
    told.without_dilatancy = limits.without_dilatancy(largest, answer).value_or(told.without_dilatancy);
  return told;
}

template class RigidLimits<2>;
template class RigidLimits<3>;
template class RigidTheorem<2>;
template class RigidTheorem<3>;

}  // namespace voussoir

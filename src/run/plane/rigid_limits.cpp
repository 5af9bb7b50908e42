#include "run/plane/rigid_limits.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "blocks/supports.hpp"
#include "linalg/agree.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"
#include "model/plane/plane_model.hpp"

namespace voussoir {
namespace {

struct StoneRow {
  BlockId block;
  bool absent;
  RigidStone stone;
};
struct PointRow {
  PointId id;
  BlockId block_i, block_j;
  RigidContact contact;
};
struct SupportRow {
  BlockId block;
  RigidSupport support;
};

/// Places count from the middle of the structure, so that they keep their digits wherever the drawing has its origin.
Vector<2> place_of(const Structure<2>& s, int node) { return s.position()[node] - s.middle(); }

StoneRow stone_of(const Structure<2>& s, int b, const RigidTask& task) {
  const auto& block = s.blocks()[b];
  const int first = block.first_local, count = static_cast<int>(block.mesh.position.size());
  StoneRow row{block.mesh.id, task.absent && !task.absent->empty() && (*task.absent)[b], {}};
  auto& stone = row.stone;
  for (int n = first; n < first + count; ++n) stone.middle = stone.middle + (1.0 / count) * place_of(s, n);
  stone.radius = 0;
  for (int n = first; n < first + count; ++n) {
    const auto arm = place_of(s, n) - stone.middle;
    stone.radius = std::max(stone.radius, norm(arm));
    if (row.absent) continue;
    for (const auto& [loads, sum] : {std::make_pair(&task.fixed, &stone.fixed), {&task.raised, &stone.raised}}) {
      if (loads->empty()) continue;
      const auto w = wrench_of(arm, {(*loads)[2 * n], (*loads)[2 * n + 1]});
      for (std::size_t c = 0; c < 3; ++c) (*sum)[c] += w[c];
    }
  }
  return row;
}

std::vector<SupportRow> supports_of(const PlaneModel& model, const std::vector<StoneRow>& stones) {
  const auto& s = model.structure();
  std::vector<SupportRow> rows;
  const auto& names = model.supports();
  std::vector<char> known(model.held().size(), 0);
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<char> held(model.held().size(), 0);
    hold(s, names[k].parameters, facet_set(model.source(), {names[k].parameters.on, names[k].parameters.blocks}), held);
    for (int b = 0; b < s.owned_blocks(); ++b) {
      const auto& block = s.blocks()[b];
      const int first = block.first_local, count = static_cast<int>(block.mesh.position.size());
      for (int n = first; n < first + count; ++n)
        for (int c = 0; c < 2; ++c) {
          if (!held[2 * n + c] || known[2 * n + c]) continue;
          known[2 * n + c] = 1;
          const Vector<2> direction{c == 0 ? 1.0 : 0.0, c == 1 ? 1.0 : 0.0};
          rows.push_back({block.mesh.id, {0, place_of(s, n) - stones[b].stone.middle, direction, static_cast<int>(k)}});
        }
    }
  }
  for (const auto& row : stones)
    if (row.absent)
      for (const auto& [arm, direction] : {std::make_pair(Vector<2>{}, Vector<2>{1, 0}),
                                           {Vector<2>{}, Vector<2>{0, 1}},
                                           {Vector<2>{row.stone.radius, 0}, Vector<2>{0, 1}}})
        rows.push_back({row.block, {0, arm, direction, -1}});
  return rows;
}

std::vector<PointRow> points_of(const PlaneModel& model, const RigidTask& task) {
  const auto& s = model.structure();
  std::vector<Vector<2>> middle(s.blocks().size());
  for (std::size_t b = 0; b < middle.size(); ++b) middle[b] = stone_of(s, static_cast<int>(b), {}).stone.middle;
  std::vector<PointRow> rows;
  for (int k = 0; k < model.points().owned(); ++k) {
    const auto& p = model.points().points()[k];
    const auto nodes = model.points().at(k);
    const int i = model.points().joint_of(k).local_i, j = model.points().joint_of(k).local_j;
    if (task.absent && !task.absent->empty() && ((*task.absent)[i] || (*task.absent)[j])) continue;
    RigidContact c;
    c.arm_i = nodes.place(Side::i, s.position()) - s.middle() - middle[i];
    c.arm_j = nodes.place(Side::j, s.position()) - s.middle() - middle[j];
    c.axis = {in_plane(p.axis[0]), in_plane(p.axis[1])};
    c.law = task.state ? law_left(model, *task.state, k) : model.law()[k];
    rows.push_back({p.id, s.blocks()[i].mesh.id, s.blocks()[j].mesh.id, c});
  }
  return rows;
}

}  // namespace

RigidLimits::RigidLimits(const PlaneModel& model, const RigidTask& task) : model_(model) {
  VOUSSOIR_EXPECT((task.fixed.empty() || is_of_nodes(model, task.fixed)) && "loads that stay: of node copies");
  VOUSSOIR_EXPECT((task.raised.empty() || is_of_nodes(model, task.raised)) && "raised loads: of node copies, or none");
  VOUSSOIR_EXPECT((!task.absent || task.absent->empty() || task.absent->size() == model.structure().blocks().size()) &&
                  "absent: per block, or none");
  const auto& s = model.structure();
  const auto& comm = *s.comm();
  std::vector<StoneRow> own;
  for (int b = 0; b < s.owned_blocks(); ++b) own.push_back(stone_of(s, b, task));
  const auto supports = all_gather(supports_of(model, own), comm);
  auto stones = all_gather(own, comm);
  auto points = all_gather(points_of(model, task), comm);
  std::sort(stones.begin(), stones.end(), [](const auto& a, const auto& b) { return a.block < b.block; });
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  RigidStructure rigid;
  for (const auto& row : stones) {
    rigid.stones.push_back(row.stone);
    middle_.push_back(row.stone.middle);
  }
  const auto number = [&](BlockId block) {
    const auto at =
        std::lower_bound(stones.begin(), stones.end(), block, [](const StoneRow& a, BlockId b) { return a.block < b; });
    return static_cast<int>(at - stones.begin());
  };
  int joint = -1;
  for (std::size_t k = 0; k < points.size(); ++k) {  // points of a joint follow each other
    auto c = points[k].contact;
    if (k == 0 || points[k - 1].block_i != points[k].block_i || points[k - 1].block_j != points[k].block_j) ++joint;
    c.stone_i = number(points[k].block_i);
    c.stone_j = number(points[k].block_j);
    c.joint = joint;
    rigid.contacts.push_back(c);
    ids_.push_back(points[k].id);
  }
  for (const auto& row : supports) {
    auto support = row.support;
    support.stone = number(row.block);
    rigid.supports.push_back(support);
  }
  on_first_rank(comm, [&] { analysis_ = std::make_unique<const LimitAnalysis>(std::move(rigid)); });
}

/// The first rank asks, the others are told; all but the mechanism itself, for which its motion stands.
template <class Ask>
LimitAnswer RigidLimits::ask_first_rank(const Ask& ask) const {
  const auto& comm = *model_.structure().comm();
  LimitAnswer answer;
  on_first_rank(comm, [&] { answer = ask(*analysis_); });
  if (comm.getSize() == 1) return answer;
  double head[6] = {static_cast<double>(answer.verdict),
                    answer.factor,
                    answer.out_of_balance,
                    static_cast<double>(answer.iterations),
                    answer.motion.empty() ? 0.0 : 1.0,
                    answer.dilates ? 1.0 : 0.0};
  Teuchos::broadcast(comm, 0, 6, head);
  answer.verdict = static_cast<LimitVerdict>(static_cast<int>(head[0]));
  answer.factor = head[1], answer.out_of_balance = head[2], answer.iterations = static_cast<int>(head[3]);
  answer.motion.resize(head[4] > 0 ? middle_.size() : 0);
  answer.dilates = head[5] > 0;
  answer.force.resize(ids_.size());
  if (!answer.motion.empty())
    Teuchos::broadcast(comm, 0, static_cast<int>(3 * answer.motion.size()), answer.motion.front().data());
  if (!answer.force.empty())
    Teuchos::broadcast(comm, 0, static_cast<int>(2 * answer.force.size()), answer.force.front().data());
  return answer;
}

LimitAnswer RigidLimits::largest_factor(double largest) const {
  return ask_first_rank([&](const LimitAnalysis& a) { return a.largest_factor(largest); });
}

LimitAnswer RigidLimits::bears(double factor) const {
  return ask_first_rank([&](const LimitAnalysis& a) { return a.bears(factor); });
}

bool RigidLimits::borne_at_any_factor() const {
  int borne = 0;
  on_first_rank(*model_.structure().comm(), [&] { borne = analysis_->borne_at_any_factor() ? 1 : 0; });
  Teuchos::broadcast(*model_.structure().comm(), 0, Teuchos::outArg(borne));
  return borne > 0;
}

bool RigidLimits::is_rows() const {
  int rows = 0;
  on_first_rank(*model_.structure().comm(), [&] { rows = analysis_->is_rows() ? 1 : 0; });
  Teuchos::broadcast(*model_.structure().comm(), 0, Teuchos::outArg(rows));
  return rows > 0;
}

LimitAnswer RigidLimits::most_balanced(double factor, double* free_share) const {
  double share = 0;
  const auto answer = ask_first_rank([&](const LimitAnalysis& a) { return a.most_balanced(factor, &share); });
  Teuchos::broadcast(*model_.structure().comm(), 0, Teuchos::outArg(share));
  if (free_share) *free_share = share;
  return answer;
}

std::optional<double> RigidLimits::without_dilatancy(double largest, const LimitAnswer& associated) const {
  double found[2] = {0, 0};
  on_first_rank(*model_.structure().comm(), [&] {
    if (const auto factor = analysis_->without_dilatancy(largest, associated)) found[0] = 1, found[1] = *factor;
  });
  Teuchos::broadcast(*model_.structure().comm(), 0, 2, found);
  return found[0] > 0 ? std::optional<double>(found[1]) : std::nullopt;
}

std::vector<std::array<ReactionRange, 2>> RigidLimits::reactions(int supports, double factor) const {
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> ends(4 * static_cast<std::size_t>(supports));
  on_first_rank(*model_.structure().comm(), [&] {
    const auto ranges = analysis_->reactions(supports, factor);
    for (std::size_t k = 0; k < 2 * ranges.size(); ++k) {
      const auto& range = ranges[k / 2][k % 2];
      ends[2 * k] = range.least.value_or(-none), ends[2 * k + 1] = range.most.value_or(none);
    }
  });
  if (!ends.empty()) Teuchos::broadcast(*model_.structure().comm(), 0, static_cast<int>(ends.size()), ends.data());
  std::vector<std::array<ReactionRange, 2>> ranges(static_cast<std::size_t>(supports));
  for (std::size_t k = 0; k < 2 * ranges.size(); ++k) {
    if (ends[2 * k] > -none) ranges[k / 2][k % 2].least = ends[2 * k];
    if (ends[2 * k + 1] < none) ranges[k / 2][k % 2].most = ends[2 * k + 1];
  }
  return ranges;
}

std::vector<double> RigidLimits::on_nodes(const LimitAnswer& answer) const {
  const auto& s = model_.structure();
  std::vector<double> motion(2 * static_cast<std::size_t>(s.nodes()), 0.0);
  if (answer.motion.empty()) return motion;
  for (int n = 0; n < s.nodes(); ++n) {
    const auto block = static_cast<std::size_t>(s.blocks()[s.block_of_node()[n]].mesh.id);
    const auto v = velocity_at(answer.motion[block], place_of(s, n) - middle_[block]);
    motion[2 * n] = v[0], motion[2 * n + 1] = v[1];
  }
  double largest = 0;
  for (int n = 0; n < s.owned_nodes(); ++n) largest = std::max(largest, std::hypot(motion[2 * n], motion[2 * n + 1]));
  largest = largest_over_ranks(*s.comm(), largest);
  for (auto& m : motion) m /= largest;
  return motion;
}

PointField RigidLimits::on_points(const LimitAnswer& answer) const {
  const auto& points = model_.points().points();
  PointField force(2 * points.size(), 0.0);
  if (answer.force.empty()) return force;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto at = std::lower_bound(ids_.begin(), ids_.end(), points[k].id);
    if (at == ids_.end() || *at != points[k].id) continue;
    const auto& f = answer.force[static_cast<std::size_t>(at - ids_.begin())];
    force[2 * k] = f[0], force[2 * k + 1] = f[1];
  }
  return force;
}

namespace {

RigidVerdict verdict_of(const RigidLimits& limits, const LimitAnswer& answer) {
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

RigidVerdict PlaneTheorem::bears(const RigidTask& task) const {
  const RigidLimits limits(model_, task);
  return verdict_of(limits, limits.bears(0));
}

RigidVerdict PlaneTheorem::largest_factor(const RigidTask& task, double largest, bool estimates) const {
  const RigidLimits limits(model_, task);
  const auto answer = limits.largest_factor(largest);
  auto told = verdict_of(limits, answer);
  if (estimates && !told.mechanism.empty())
    told.without_dilatancy = limits.without_dilatancy(largest, answer).value_or(told.without_dilatancy);
  return told;
}

}  // namespace voussoir

#include "model/patch_cutter.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/sort_unique.hpp"
#include "linalg/gather.hpp"
#include "linalg/local_view.hpp"
#include "linalg/reduce.hpp"
#include "linalg/traffic.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"

namespace voussoir {
namespace {

/// Blocks that any rank names, ascending, the same list on every rank.
std::vector<BlockId> over_ranks(std::vector<BlockId> mine, const Teuchos::Comm<int>& comm) {
  sort_unique(mine);
  auto all = all_gather(mine, comm);
  sort_unique(all);
  return all;
}

}  // namespace

/// K x - f and the gaps, unless they are known.
void PatchCutter::measure(const TpetraVector& x) {
  if (measured_) return;
  linear_ = Teuchos::rcp(new TpetraVector(parts_.space.map()));
  parts_.problem.evaluate(x, *linear_, gap_);
  measured_ = true;
}

bool PatchCutter::find_stuck(const TpetraVector& x, const PointField& lambda, double threshold) {
  const TrafficScope sent_for(TrafficOf::set_up);
  measured_ = false;
  measure(x);
  const auto& s = parts_.structure;
  const auto& cluster = parts_.space.cluster();
  auto& problem = parts_.problem;
  const auto id_of = [&](int node) { return s.nodes_of(s.block_of_node()[node]).id; };
  std::vector<BlockId> mine;
  TpetraVector residual(*linear_, Teuchos::Copy);
  problem.subtract_contact_forces(lambda, residual);
  const double* off = local_view(residual);
  for (int i = 0; i < s.nodes(); ++i) {
    if (cluster[i] >= parts_.space.owned_clusters()) continue;
    for (int c = 0; c < dim_; ++c)
      if (std::abs(off[dim_ * cluster[i] + c]) > threshold) mine.push_back(id_of(i));
  }
  PointField lawful;
  lawful_forces(problem, CurrentLaws(problem, {}, lambda, gap_), lambda, gap_, lawful);
  for (int k = 0; k < problem.owned_points(); ++k) {
    if (!problem.selected()[k]) continue;
    const auto& joint = parts_.points.joint_of(k);
    for (int c = dim_ * k; c < dim_ * (k + 1); ++c)
      if (std::abs(lawful[c] - lambda[c]) > threshold) mine.insert(mine.end(), {joint.block_i, joint.block_j});
  }
  stuck_ = over_ranks(mine, *s.comm());
  return !stuck_.empty();
}

/// Blocks that a selection has parted from others.
std::vector<BlockId> PatchCutter::parted_blocks() const {
  const auto& s = parts_.structure;
  std::vector<BlockId> mine;
  for (int k = 0; k < parts_.problem.owned_points(); ++k) {
    if (!parts_.problem.selected()[k]) continue;
    const auto& joint = parts_.points.joint_of(k);
    mine.insert(mine.end(), {joint.block_i, joint.block_j});
  }
  return over_ranks(mine, *s.comm());
}

/// Adds the neighbours and groups what meets.
void PatchCutter::find_patches(const std::vector<BlockId>& of) {
  const auto& s = parts_.structure;
  const auto stuck = [&](BlockId b) { return std::binary_search(of.begin(), of.end(), b); };
  std::vector<BlockId> mine = of;
  for (const auto& j : parts_.points.joints())
    if (stuck(j.block_i) || stuck(j.block_j)) mine.insert(mine.end(), {j.block_i, j.block_j});
  block_ = over_ranks(mine, *s.comm());

  // Blocks of one joint, or that share unknowns, belong together.
  struct Pair {
    BlockId a, b;
  };
  std::vector<Pair> pairs;
  const auto within = [&](BlockId b) { return std::binary_search(block_.begin(), block_.end(), b); };
  for (const auto& j : parts_.points.joints())
    if (within(j.block_i) && within(j.block_j)) pairs.push_back({j.block_i, j.block_j});
  std::vector<BlockId> first(parts_.space.clusters(), -1);
  for (int i = 0; i < s.nodes(); ++i) {
    const BlockId b = s.nodes_of(s.block_of_node()[i]).id;
    if (!within(b)) continue;
    auto& other = first[parts_.space.cluster()[i]];
    if (other >= 0 && other != b) pairs.push_back({other, b});
    other = b;
  }
  pairs = all_gather(pairs, *s.comm());
  DisjointSets sets(block_.size());
  const auto place = [&](BlockId b) {
    return static_cast<int>(std::lower_bound(block_.begin(), block_.end(), b) - block_.begin());
  };
  for (const auto& p : pairs) sets.unite(place(p.a), place(p.b));
  patch_.assign(block_.size(), -1);
  patches_ = 0;
  for (int i = 0; i < static_cast<int>(block_.size()); ++i)
    patch_[i] = sets.root(i) == i ? patches_++ : patch_[sets.root(i)];
}

bool PatchCutter::keep_stuck(const std::vector<int>& numbers) {
  const auto patches = all_gather(numbers, *parts_.structure.comm());
  stuck_.clear();
  for (std::size_t b = 0; b < block_.size(); ++b)
    if (std::find(patches.begin(), patches.end(), patch_[b]) != patches.end()) stuck_.push_back(block_[b]);
  return !stuck_.empty();
}

int PatchCutter::patch_of_block(BlockId b) const {
  const auto found = std::lower_bound(block_.begin(), block_.end(), b);
  return found != block_.end() && *found == b ? patch_[found - block_.begin()] : -1;
}

std::vector<int> PatchCutter::patch_of_clusters() const {
  const auto& s = parts_.structure;
  std::vector<int> patch(parts_.space.clusters(), -1);
  for (int i = 0; i < s.nodes(); ++i) {
    const int mine = patch_of_block(s.nodes_of(s.block_of_node()[i]).id);
    if (mine >= 0) patch[parts_.space.cluster()[i]] = mine;
  }
  return patch;
}

double PatchCutter::group(bool all_that_parted) {
  const TrafficScope sent_for(TrafficOf::set_up);
  find_patches(all_that_parted ? parted_blocks() : stuck_);
  const auto& s = parts_.structure;
  double mine = 0;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.nodes_of(b);
    if (patch_of_block(block.id) >= 0) mine += dim_ * static_cast<double>(block.nodes);
  }
  return total_over_ranks(*s.comm(), mine) / static_cast<double>(parts_.space.map()->getGlobalNumElements());
}

std::vector<PatchCutter::Unknown> PatchCutter::unknowns(const TpetraVector& x, const TpetraVector& start) const {
  const auto& space = parts_.space;
  const double *at = local_view(x), *from = local_view(start), *linear = local_view(*linear_);
  std::vector<Unknown> list;
  for (int i = 0; i < dim_ * space.owned_clusters(); ++i) {
    const int patch = cluster_patch_[i / dim_];
    if (patch < 0 || space.held()[i]) continue;
    list.push_back({space.map()->getGlobalElement(i), patch, linear[i], from[i] - at[i], parts_.proximal_weight[i]});
  }
  return list;
}

/// Stiffness of the blocks in rows of patches that this rank owns.
std::vector<PatchCutter::Entry> PatchCutter::entries() const {
  const auto& space = parts_.space;
  const auto& columns = *space.column_map();
  std::vector<Entry> list;
  for (int b = 0; b < parts_.structure.local_blocks(); ++b) {
    const auto& block = parts_.structure.nodes_of(b);
    const auto& k = *block.stiffness;
    const auto unknown = [&](int i) { return dim_ * space.cluster()[block.first_local + i / dim_] + i % dim_; };
    for (int i = 0; i < k.rows(); ++i) {
      const int row = unknown(i);
      if (row >= dim_ * space.owned_clusters() || cluster_patch_[row / dim_] < 0 || space.held()[row]) continue;
      for (int e = k.start[i]; e < k.start[i + 1]; ++e)
        list.push_back({columns.getGlobalElement(row), columns.getGlobalElement(unknown(k.column[e])), k.value[e]});
    }
  }
  return list;
}

/// Patches that the nodes of a point are of, each once.
std::vector<int> PatchCutter::patches_of(int point) const {
  std::vector<int> patches;
  parts_.points.at(point).each([&](int node, double) {
    const int patch = cluster_patch_[parts_.space.cluster()[node]];
    if (patch >= 0 && std::find(patches.begin(), patches.end(), patch) == patches.end()) patches.push_back(patch);
  });
  return patches;
}

/// What is known of a point but where it is.
PointOfPatch PatchCutter::of_patch(int k, const PointLaw& law, const PointField& lambda,
                                   const PointStiffness& resistance) const {
  const auto& problem = parts_.problem;
  PointOfPatch q;
  for (int a = 0; a < dim_; ++a) q.axis[a] = parts_.points.points()[k].axis[a];
  q.law = law;
  q.local_stiffness = problem.local_stiffness()[k];
  if (!problem.compliance().empty()) q.compliance = problem.compliance()[k];
  for (int c = 0; c < dim_; ++c) {
    if (!problem.slip_origin().empty()) q.slip_origin[c] = problem.slip_origin()[dim_ * k + c];
    q.gap[c] = gap_[dim_ * k + c];
    q.force[c] = lambda[dim_ * k + c];
  }
  q.resistance = resistance;
  // Points that slip on what holds still would let the neighbours of stuck blocks go without end.
  if (q.resistance.normal > 0 && q.resistance.gives_way(dim_ - 1))
    q.resistance = {q.resistance.normal, stiffness_of(problem, k, 1, 1.0)};
  return q;
}

/// Points that touch patches, of those this rank owns; one that touches two patches is at the border of both.
PatchCutter::PointsAndShares PatchCutter::points(const PointField& lambda,
                                                 const std::vector<PointStiffness>& resistance) const {
  const auto& space = parts_.space;
  const auto& problem = parts_.problem;
  const CurrentLaws laws(problem, {}, lambda, gap_);
  PointsAndShares all;
  for (int k = 0; k < problem.owned_points(); ++k) {
    if (!problem.selected()[k]) continue;
    const auto touched = patches_of(k);
    if (touched.empty()) continue;
    std::vector<Share> shares;
    parts_.points.at(k).each([&](int node, double weight) {
      for (int c = 0; c < dim_; ++c) {
        const int unknown = dim_ * space.cluster()[node] + c;
        shares.push_back({space.held()[unknown] ? -1 : space.column_map()->getGlobalElement(unknown), c, weight});
      }
    });
    const auto& joint = parts_.points.joint_of(k);
    const int of_i = patch_of_block(joint.block_i), of_j = patch_of_block(joint.block_j);
    const auto what = of_patch(k, laws[k], lambda, resistance[k]);
    for (const int patch : touched) {
      all.points.push_back(
          {parts_.points.points()[k].id, patch, of_i < 0 || of_i != of_j, static_cast<int>(shares.size()), what});
      all.shares.insert(all.shares.end(), shares.begin(), shares.end());
    }
  }
  return all;
}

/// Of a patch, null where it is another rank's.
PatchCutter::Mine* PatchCutter::mine(int patch) {
  const auto& comm = *parts_.structure.comm();
  return patch % comm.getSize() == comm.getRank() ? &mine_[patch / comm.getSize()] : nullptr;
}

/// Patches are put together from what all ranks know of them.
std::vector<CutPatch> PatchCutter::cut(const TpetraVector& x, const PointField& lambda, const PatchRequest& request) {
  const TrafficScope sent_for(TrafficOf::set_up);
  const auto& comm = *parts_.structure.comm();
  measure(x);
  cluster_patch_ = patch_of_clusters();
  mine_.assign((patches_ - comm.getRank() + comm.getSize() - 1) / comm.getSize(), {});
  std::unordered_map<GlobalOrdinal, std::pair<int, int>> place;  // patch, number there
  for (const auto& u : all_gather(unknowns(x, request.start), comm)) {
    auto* const m = mine(u.patch);
    if (!m) continue;
    place[u.id] = {u.patch, static_cast<int>(m->unknowns.size())};
    m->unknowns.push_back(u.id);
    m->parts.imbalance.push_back(u.imbalance);
    m->parts.start.push_back(u.start);
    m->parts.proximal_weight.push_back(u.proximal);
  }
  const auto number = [&](GlobalOrdinal id, int patch) {  // -1 outside of the patch
    const auto found = place.find(id);
    return found == place.end() || found->second.first != patch ? -1 : found->second.second;
  };
  for (const auto& e : all_gather(entries(), comm)) {
    const auto row = place.find(e.row);
    if (row == place.end()) continue;
    const int patch = row->second.first, column = number(e.column, patch);
    if (column >= 0) mine(patch)->parts.stiffness.push_back({row->second.second, column, e.value});
  }
  const auto mine_of_points = points(lambda, request.resistance);
  const auto shares = all_gather(mine_of_points.shares, comm);
  auto next = shares.begin();
  for (const auto& p : all_gather(mine_of_points.points, comm)) {
    const auto first = std::exchange(next, next + p.shares);
    auto* const m = mine(p.patch);
    if (!m) continue;
    PatchPoint local{p.point, {}};
    for (auto share = first; share != next; ++share)
      if (const int at = number(share->unknown, p.patch); at >= 0)
        local.shares.push_back({at, share->component, share->weight});
    (p.border ? m->parts.border : m->parts.points).push_back(local);
    (p.border ? m->border : m->points).push_back(p.id);
  }
  std::vector<CutPatch> patches;
  for (int patch = comm.getRank(); patch < patches_; patch += comm.getSize()) {
    auto& parts = mine(patch)->parts;
    parts.components = dim_;
    parts.force_scale = request.scale;
    parts.length_scale = parts_.structure.size();
    patches.push_back({patch, std::move(parts)});
    parts.points = patches.back().parts.points;  // with their forces, which change
    parts.border = patches.back().parts.border;
  }
  return patches;
}

void PatchCutter::put_back(const std::vector<SolvedPatch>& solved, TpetraVector& x, PointField& lambda) {
  const TrafficScope sent_for(TrafficOf::set_up);
  const auto& comm = *parts_.structure.comm();
  std::vector<Motion> motion;
  std::vector<Force> force;
  const auto tell = [&](const auto& id, const auto& before, const auto& after) {
    for (std::size_t k = 0; k < id.size(); ++k) {
      force.push_back({id[k], {}});
      for (int c = 0; c < dim_; ++c) force.back().change[c] = after[k].force[c] - before[k].force[c];
    }
  };
  for (const auto& patch : solved) {
    const auto& m = *mine(patch.number);
    for (std::size_t u = 0; u < m.unknowns.size(); ++u) motion.push_back({m.unknowns[u], patch.displacement[u]});
    tell(m.points, m.parts.points, patch.points);
    tell(m.border, m.parts.border, patch.border);
  }
  double* value = local_view_to_write(x);
  for (const auto& m : all_gather(motion, comm)) {
    const auto local = x.getMap()->getLocalElement(m.id);
    if (local != Teuchos::OrdinalTraits<LocalOrdinal>::invalid()) value[local] += m.by;
  }
  std::unordered_map<PointId, Vector<3>> change;
  for (const auto& f : all_gather(force, comm))
    for (int c = 0; c < dim_; ++c) change[f.id][c] += f.change[c];
  for (int k = 0; k < parts_.points.size(); ++k) {
    const auto found = change.find(parts_.points.points()[k].id);
    if (found == change.end()) continue;
    for (int c = 0; c < dim_; ++c) lambda[dim_ * k + c] += found->second[c];
  }
  measured_ = false;
}

}  // namespace voussoir

// Which blocks are stuck, and which of them make a patch.
#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.hpp"
#include "base/sort_unique.hpp"
#include "linalg/gather.hpp"
#include "linalg/local_view.hpp"
#include "linalg/reduce.hpp"
#include "linalg/traffic.hpp"
#include "model/patch_cutter.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"

namespace voussoir {
namespace {

constexpr WhyWhole numbers_alone{"numbers of blocks that are stuck or parted, and which of them meet"};

/// Blocks that any rank names, ascending, the same list on every rank. To be asked once share_of() has told that they
/// are not many.
std::vector<BlockId> over_ranks(const std::vector<BlockId>& mine, const Teuchos::Comm<int>& comm) {
  auto all = all_gather(mine, comm, numbers_alone);
  sort_unique(all);
  return all;
}

}  // namespace

bool PatchCutter::find_stuck(const TpetraVector& x, const PointField& lambda, double threshold) {
  const TrafficScope sent_for(TrafficOf::set_up);
  measured_ = false;
  measure(x);
  const auto& s = parts_.structure;
  const auto& cluster = parts_.space.cluster();
  auto& problem = parts_.problem;
  const auto id_of = [&](int node) { return s.nodes_of(s.block_of_node()[node]).id; };
  auto& mine = stuck_;
  mine.clear();
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
  sort_unique(mine);
  return any_of_ranks(*s.comm(), !mine.empty());
}

/// Blocks that a selection has parted from others, as far as this rank knows.
std::vector<BlockId> PatchCutter::parted_blocks() const {
  std::vector<BlockId> mine;
  for (int k = 0; k < parts_.problem.owned_points(); ++k) {
    if (!parts_.problem.selected()[k]) continue;
    const auto& joint = parts_.points.joint_of(k);
    mine.insert(mine.end(), {joint.block_i, joint.block_j});
  }
  sort_unique(mine);
  return mine;
}

/// Of the unknowns of all stones those of some blocks, which their owners have to know of. Collective.
double PatchCutter::share_of(const std::vector<BlockId>& blocks) const {
  const auto& s = parts_.structure;
  double mine = 0;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.nodes_of(b);
    if (std::binary_search(blocks.begin(), blocks.end(), block.id)) mine += dim_ * static_cast<double>(block.nodes);
  }
  return total_over_ranks(*s.comm(), mine) / static_cast<double>(parts_.space.map()->getGlobalNumElements());
}

/// Groups the blocks that meet.
void PatchCutter::find_patches() {
  const auto& s = parts_.structure;
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
  pairs = all_gather(pairs, *s.comm(), numbers_alone);
  DisjointSets sets(block_.size());
  const auto place = [&](BlockId b) {
    return static_cast<int>(std::lower_bound(block_.begin(), block_.end(), b) - block_.begin());
  };
  for (const auto& p : pairs) sets.unite(place(p.a), place(p.b));
  patch_.assign(block_.size(), -1);
  int patches = 0;
  for (int i = 0; i < static_cast<int>(block_.size()); ++i)
    patch_[i] = sets.root(i) == i ? patches++ : patch_[sets.root(i)];
  owner_of_patch_.assign(patches, -1);
  choose_owners();
}

/// A patch goes to the rank that owns most of its blocks, the lowest of those that own as many.
void PatchCutter::choose_owners() {
  const auto& s = parts_.structure;
  std::map<int, int> own;  // blocks of a patch
  for (int b = 0; b < s.owned_blocks(); ++b)
    if (const int patch = patch_of_block(s.nodes_of(b).id); patch >= 0) ++own[patch];
  std::vector<int> mine;  // patch, rank and blocks there, one after the other
  for (const auto& [patch, blocks] : own) mine.insert(mine.end(), {patch, s.comm()->getRank(), blocks});
  std::vector<int> most(owner_of_patch_.size(), 0);
  const auto all = all_gather(mine, *s.comm(), numbers_alone);
  for (auto share = all.begin(); share != all.end(); share += 3)
    if (const int patch = share[0], rank = share[1], blocks = share[2]; blocks > most[patch]) {
      most[patch] = blocks;
      owner_of_patch_[patch] = rank;
    }
}

int PatchCutter::patch_of_block(BlockId b) const {
  const auto found = std::lower_bound(block_.begin(), block_.end(), b);
  return found != block_.end() && *found == b ? patch_[found - block_.begin()] : -1;
}

bool PatchCutter::group(bool all_that_parted, double most) {
  const TrafficScope sent_for(TrafficOf::set_up);
  // Ranks ask of their own what they know first. What only their neighbours know of lies at their borders.
  const auto known = all_that_parted ? parted_blocks() : stuck_;
  if (share_of(known) > most) return false;
  const auto& comm = *parts_.structure.comm();
  const auto of = over_ranks(known, comm);
  if (share_of(of) > most) return false;
  const auto is_of = [&](BlockId b) { return std::binary_search(of.begin(), of.end(), b); };
  auto with_neighbours = of;
  for (const auto& j : parts_.points.joints())
    if (is_of(j.block_i) || is_of(j.block_j)) with_neighbours.insert(with_neighbours.end(), {j.block_i, j.block_j});
  sort_unique(with_neighbours);
  block_ = over_ranks(with_neighbours, comm);
  if (share_of(block_) > most) return false;
  find_patches();
  return true;
}

}  // namespace voussoir

#include "model/patch_cutter.hpp"

#include <algorithm>

#include "linalg/local_view.hpp"
#include "linalg/parcels.hpp"
#include "linalg/traffic.hpp"
#include "nonlinear/residuals.hpp"

namespace voussoir {

/// K x - f and the gaps, unless they are known.
void PatchCutter::measure(const TpetraVector& x) {
  if (measured_) return;
  linear_ = Teuchos::rcp(new TpetraVector(parts_.space.map()));
  parts_.problem.evaluate(x, *linear_, gap_);
  measured_ = true;
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

/// Number of an unknown in a patch of this rank, -1 outside of it.
int PatchCutter::number_in(int patch, GlobalOrdinal unknown) const {
  const auto found = place_.find(unknown);
  return found == place_.end() || found->second.first != patch ? -1 : found->second.second;
}

void PatchCutter::take_unknowns(const TpetraVector& x, const TpetraVector& start) {
  Post<Unknown> post(*parts_.structure.comm());
  for (const auto& u : unknowns(x, start)) post.add(owner_of_patch_[u.patch], u);
  place_.clear();
  for (const auto& parcel : std::move(post).send())
    for (const auto& u : parcel.items) {
      auto& m = mine_.at(u.patch);
      place_[u.id] = {u.patch, static_cast<int>(m.unknowns.size())};
      m.unknowns.push_back(u.id);
      m.owner_of_unknown.push_back(parcel.rank);
      m.parts.imbalance.push_back(u.imbalance);
      m.parts.start.push_back(u.start);
      m.parts.proximal_weight.push_back(u.proximal);
    }
}

void PatchCutter::take_stiffness() {
  Post<Entry> post(*parts_.structure.comm());
  const auto& map = *parts_.space.map();
  for (const auto& e : entries()) post.add(owner_of_patch_[cluster_patch_[map.getLocalElement(e.row) / dim_]], e);
  for (const auto& e : std::move(post).send_all()) {
    const auto [patch, row] = place_.at(e.row);
    if (const int column = number_in(patch, e.column); column >= 0)
      mine_.at(patch).parts.stiffness.push_back({row, column, e.value});
  }
}

void PatchCutter::take_points(const PointField& lambda, const std::vector<PointStiffness>& resistance) {
  const auto& comm = *parts_.structure.comm();
  Post<Point> post(comm);
  Post<Share> shares_to(comm);
  const auto touching = points(lambda, resistance);
  auto next = touching.shares.begin();
  for (const auto& p : touching.points) {
    post.add(owner_of_patch_[p.patch], p);
    for (const auto last = next + p.shares; next != last; ++next) shares_to.add(owner_of_patch_[p.patch], *next);
  }
  const auto shares = std::move(shares_to).send_all();
  auto share = shares.begin();
  for (const auto& parcel : std::move(post).send())
    for (const auto& p : parcel.items) {
      auto& m = mine_.at(p.patch);
      PatchPoint local{p.point, {}};
      for (const auto last = share + p.shares; share != last; ++share)
        if (const int at = number_in(p.patch, share->unknown); at >= 0)
          local.shares.push_back({at, share->component, share->weight});
      (p.border ? m.parts.border : m.parts.points).push_back(local);
      (p.border ? m.border : m.points).push_back(p.id);
      (p.border ? m.owner_of_border : m.owner_of_point).push_back(parcel.rank);
    }
}

/// Patches are put together from what those know of them who own their unknowns and points.
std::vector<CutPatch> PatchCutter::cut(const TpetraVector& x, const PointField& lambda, const PatchRequest& request) {
  const TrafficScope sent_for(TrafficOf::set_up);
  const int rank = parts_.structure.comm()->getRank();
  measure(x);
  cluster_patch_ = patch_of_clusters();
  mine_.clear();
  for (std::size_t patch = 0; patch < owner_of_patch_.size(); ++patch)
    if (owner_of_patch_[patch] == rank) mine_[static_cast<int>(patch)];
  take_unknowns(x, request.start);
  take_stiffness();
  take_points(lambda, request.resistance);
  std::vector<CutPatch> patches;
  for (auto& [patch, m] : mine_) {
    auto& parts = m.parts;
    parts.components = dim_;
    parts.force_scale = request.scale;
    parts.length_scale = parts_.structure.size();
    patches.push_back({patch, std::move(parts)});
    parts.points = patches.back().parts.points;  // with their forces, which change
    parts.border = patches.back().parts.border;
  }
  return patches;
}

void PatchCutter::move_unknowns(const std::vector<SolvedPatch>& solved, TpetraVector& x) {
  Post<Motion> post(*parts_.structure.comm());
  for (const auto& patch : solved) {
    const auto& m = mine_.at(patch.number);
    for (std::size_t u = 0; u < m.unknowns.size(); ++u)
      post.add(m.owner_of_unknown[u], {m.unknowns[u], patch.displacement[u]});
  }
  double* value = local_view_to_write(x);
  for (const auto& m : std::move(post).send_all()) value[x.getMap()->getLocalElement(m.id)] += m.by;
}

void PatchCutter::change_forces(const std::vector<SolvedPatch>& solved, PointField& lambda) {
  Post<Force> post(*parts_.structure.comm());
  const auto tell = [&](const auto& owner, const auto& id, const auto& before, const auto& after) {
    for (std::size_t k = 0; k < id.size(); ++k) {
      Force force{id[k], {}};
      for (int c = 0; c < dim_; ++c) force.change[c] = after[k].force[c] - before[k].force[c];
      post.add(owner[k], force);
    }
  };
  for (const auto& patch : solved) {
    const auto& m = mine_.at(patch.number);
    tell(m.owner_of_point, m.points, m.parts.points, patch.points);
    tell(m.owner_of_border, m.border, m.parts.border, patch.border);
  }
  std::unordered_map<PointId, Vector<3>> change;
  for (const auto& f : std::move(post).send_all())
    for (int c = 0; c < dim_; ++c) change[f.id][c] += f.change[c];
  for (int k = 0; k < parts_.points.owned(); ++k) {
    const auto found = change.find(parts_.points.points()[k].id);
    if (found == change.end()) continue;
    for (int c = 0; c < dim_; ++c) lambda[dim_ * k + c] += found->second[c];
  }
  parts_.points.exchange().update(lambda, dim_);
}

void PatchCutter::put_back(const std::vector<SolvedPatch>& solved, TpetraVector& x, PointField& lambda) {
  const TrafficScope sent_for(TrafficOf::set_up);
  move_unknowns(solved, x);
  change_forces(solved, lambda);
  measured_ = false;
}

}  // namespace voussoir

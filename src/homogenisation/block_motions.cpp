#include "homogenisation/block_motions.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <utility>

#include "base/check.hpp"
#include "base/components.hpp"
#include "base/sort_unique.hpp"
#include "homogenisation/block_motions_kernel.hpp"
#include "homogenisation/pairs_of_blocks.hpp"
#include "linalg/local_view.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {
template <int dim>
BlockMotions::Motions<dim>::Motions(const BlockSystem& s, const ContactPoints& points,
                                    const std::vector<char>& selected, const MergedSpace& space,
                                    const std::vector<char>& active, const SharedSystemParameters& numbers)
    : structure_(s), points_(points), space_(space) {
  number_blocks(active, numbers);
  find_copies(copies_met(selected));
  set_pattern(selected);
  add_elastic_energy();
}

/// Numbers of active blocks on this rank, and of their motions among those of all.
template <int dim>
void BlockMotions::Motions<dim>::number_blocks(const std::vector<char>& active, const SharedSystemParameters& numbers) {
  const auto& s = structure_;
  number_.assign(active.size(), -1);
  SharedSystem::Unknowns unknowns;
  for (int b = 0; b < s.local_blocks(); ++b) {
    if (active[b]) number_[b] = blocks_++;
    if (b < s.owned_blocks()) unknowns.owned = modes * blocks_;
  }
  long long before = 0;
  Teuchos::scan(*s.comm(), Teuchos::REDUCE_SUM, static_cast<long long>(unknowns.owned), Teuchos::outArg(before));
  before -= unknowns.owned;
  std::vector<long long> first(s.nodes(), -1);  // of the motions of the block of each node
  for (int b = 0; b < s.owned_blocks(); ++b)
    for (int n = 0; n < s.nodes_of(b).nodes && active[b]; ++n)
      first[s.nodes_of(b).first_local + n] = before + modes * number_[b];
  s.node_exchange().update(first);
  for (int b = 0; b < s.local_blocks(); ++b) {
    const auto number = first[s.nodes_of(b).first_local];
    VOUSSOIR_EXPECT((number >= 0) == (active[b] != 0) && "active blocks: the same for all who know them");
    for (int m = 0; m < modes && active[b]; ++m) {
      unknowns.number.push_back(number + m);
      unknowns.owner.push_back(s.owner_of(b));
    }
  }
  system_ = std::make_unique<SharedSystem>(std::move(unknowns), rigid_motions(active), s.comm(), numbers);
}

/// Those of the structure, as motions of owned blocks. Lengths are scaled, and turns are about the middle.
template <int dim>
SharedSystem::Bodies BlockMotions::Motions<dim>::rigid_motions(const std::vector<char>& active) const {
  const auto& s = structure_;
  SharedSystem::Bodies bodies{modes, {}, {}};
  bodies.rigid.resize(modes);
  bodies.place.resize(dim);
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!active[b]) continue;
    const auto& block = s.nodes_of(b);
    const auto first = s.place(block.first_local);
    const auto x = first - s.centre();
    const double length = norm(s.place(block.first_local + block.nodes - 1) - first);  // of arms (find_copies)
    double value[modes][modes] = {};
    for (int c = 0; c < dim; ++c) value[c][c] = 1;
    for (int a = 0, turn = dim; a < dim; ++a)
      for (int c = a + 1; c < dim; ++c, ++turn) {
        value[a][turn] = -x[c] / s.size();
        value[c][turn] = x[a] / s.size();
        value[turn][turn] = length / s.size();
      }
    for (int column = 0; column < modes; ++column)
      for (int m = 0; m < modes; ++m) bodies.rigid[column].push_back(value[m][column]);
    for (int c = 0; c < dim; ++c) bodies.place[c].push_back(x[c]);
  }
  return bodies;
}

/// The copies at owned vertices, and those of all other clusters that an owned point with weights reaches.
template <int dim>
std::vector<int> BlockMotions::Motions<dim>::copies_met(const std::vector<char>& selected) const {
  auto copies = structure_.copy();
  const auto& cluster = space_.cluster();
  std::vector<char> reached(space_.clusters(), 0);
  for (int k = 0; k < points_.owned(); ++k)
    if (selected[k] && !points_.points()[k].can_be_tied())
      points_.at(k).each([&](int node, double) { reached[cluster[node]] = 1; });
  for (const int copy : structure_.copy()) reached[cluster[copy]] = 0;
  std::vector<double> found(space_.clusters(), 0.0);
  for (int node = 0; node < structure_.nodes(); ++node) {
    if (!reached[cluster[node]]) continue;
    copies.push_back(node);
    found[cluster[node]] += 1;
  }
  for (int c = 0; c < space_.clusters(); ++c) VOUSSOIR_EXPECT(!reached[c] || found[c] == space_.multiplicity()[c]);
  return copies;
}

/// Sorts copies by clusters.
/// @param met  the copies
template <int dim>
void BlockMotions::Motions<dim>::find_copies(const std::vector<int>& met) {
  const auto& s = structure_;
  const auto number_of = [&](int node) { return number_[s.block_of_node()[node]]; };
  const auto& cluster = space_.cluster();
  copy_start_.assign(space_.clusters() + 1, 0);
  for (int k : met)
    if (number_of(k) >= 0) ++copy_start_[cluster[k] + 1];
  for (int k = 0; k < space_.clusters(); ++k) copy_start_[k + 1] += copy_start_[k];
  copies_.resize(copy_start_.back());
  auto next = copy_start_;
  for (int k : met) {
    if (number_of(k) < 0) continue;
    const auto& block = s.nodes_of(s.block_of_node()[k]);
    const auto first = s.place(block.first_local);
    const auto arm = (1 / norm(s.place(block.first_local + block.nodes - 1) - first)) * (s.place(k) - first);
    auto& copy = copies_[next[cluster[k]]++];
    copy.block = number_of(k);
    std::copy_n(arm.begin(), dim, copy.arm.begin());
  }
}

/// How far each motion of a block moves a place in it along a direction.
template <int dim>
typename BlockMotions::Motions<dim>::Modes BlockMotions::Motions<dim>::motion(const Vector<dim>& arm,
                                                                              const Vector<dim>& direction) {
  Modes m;
  std::copy(direction.begin(), direction.end(), m.begin());
  int turn = dim;
  for (int a = 0; a < dim; ++a)
    for (int b = a + 1; b < dim; ++b, ++turn) m[turn] = direction[b] * arm[a] - direction[a] * arm[b];
  return m;
}

/// How a place in a block moves by its motions.
template <int dim>
Vector<dim> BlockMotions::Motions<dim>::displacement(const Vector<dim>& arm, const Modes& motions) {
  Vector<dim> u;
  std::copy_n(motions.begin(), dim, u.begin());
  int turn = dim;
  for (int a = 0; a < dim; ++a)
    for (int b = a + 1; b < dim; ++b, ++turn) {
      u[a] -= motions[turn] * arm[b];
      u[b] += motions[turn] * arm[a];
    }
  return u;
}

/// Adds factor times the motion of a cluster along a direction of the drawing; what is held of it does not move.
template <int dim>
void BlockMotions::Motions<dim>::add_motion(int cluster, Vector<dim> direction, double factor, Row& row) const {
  direction = space_.held().free_part(cluster, direction);
  const double share = factor / space_.multiplicity()[cluster];
  for (int k = copy_start_[cluster]; k < copy_start_[cluster + 1]; ++k) {
    const auto more = share * motion(copies_[k].arm, direction);
    auto term = std::lower_bound(row.begin(), row.end(), copies_[k].block,
                                 [](const Term& t, int block) { return t.block < block; });
    if (term == row.end() || term->block != copies_[k].block) term = row.insert(term, {copies_[k].block, {}});
    term->value = term->value + more;
  }
}

/// Pairs of blocks that meet at a node of an owned block or across an owned point.
template <int dim>
void BlockMotions::Motions<dim>::set_pattern(const std::vector<char>& selected) {
  PairsOfBlocks met;
  std::vector<int> around;
  const auto meet_at = [&](int cluster) {
    for (int k = copy_start_[cluster]; k < copy_start_[cluster + 1]; ++k) around.push_back(copies_[k].block);
  };
  const auto couple = [&] {
    sort_unique(around);
    for (int i : around)
      for (int j : around)
        if (i <= j) met.add(i, j);
    around.clear();
  };
  const auto& cluster = space_.cluster();
  for (int b = 0; b < structure_.owned_blocks(); ++b) {
    const auto& block = structure_.nodes_of(b);
    for (int i = 0; i < block.nodes; ++i) meet_at(cluster[block.first_local + i]);
    couple();
  }
  for (int k = 0; k < points_.owned(); ++k) {
    if (!selected[k] || space_.tied(points_.points()[k])) continue;
    couplings_.push_back(k);
    points_.at(k).each([&](int node, double) { meet_at(cluster[node]); });
    couple();
  }
  for (int b = 0; b < blocks_; ++b) met.add(b, b);
  matrix_ = pattern_of(std::move(met).all(), modes);
  VOUSSOIR_ENSURE(matrix_.rows() == modes * blocks_);
}

/// Where in the first row of a block the columns of another begin.
template <int dim>
std::size_t BlockMotions::Motions<dim>::place(int block, int other) const {
  const auto row = matrix_.column.begin() + matrix_.start[modes * block];
  const auto end = matrix_.column.begin() + matrix_.start[modes * block + 1];
  return std::lower_bound(row, end, modes * other) - row;
}

/// Adds left^T right to the part of the matrix that a block and another, not before it, have in common.
template <int dim>
void BlockMotions::Motions<dim>::add_to(int block, int other, const Modes& left, const double* right) {
  const std::size_t along = place(block, other);
  for (int m = 0; m < modes; ++m) {
    // Each row of a block begins one column later than the one above.
    double* value = &matrix_.value[matrix_.start[modes * block + m] + along] - m;
    for (int n = block == other ? m : 0; n < modes; ++n) value[n] += left[m] * right[n];
  }
}

/// Adds factor row^T row to the matrix.
template <int dim>
void BlockMotions::Motions<dim>::add_product(const Row& row, double factor) {
  for (auto i = row.begin(); i != row.end(); ++i)
    for (auto j = i; j != row.end(); ++j) add_to(i->block, j->block, factor * i->value, j->value.data());
}

template <int dim>
void BlockMotions::Motions<dim>::add_elastic_energy() {
  std::vector<int> local(blocks_, -1);  // place of a block among those around another
  std::vector<Row> z;
  std::vector<double> kz;
  for (int b = 0; b < structure_.owned_blocks(); ++b) {
    const auto& block = structure_.nodes_of(b);
    const auto& k = *block.stiffness;
    z.assign(k.rows(), {});
    std::vector<int> around;
    for (int i = 0; i < k.rows(); ++i) {
      Vector<dim> direction{};
      direction[i % dim] = 1;
      add_motion(space_.cluster()[block.first_local + i / dim], direction, 1.0, z[i]);
      for (const auto& term : z[i]) {
        if (local[term.block] >= 0) continue;
        local[term.block] = static_cast<int>(around.size());
        around.push_back(term.block);
      }
    }
    // First K Z, then Z^T (K Z).
    const std::size_t n = around.size() * modes;
    kz.assign(k.rows() * n, 0.0);
    for (int i = 0; i < k.rows(); ++i)
      for (int e = k.start[i]; e < k.start[i + 1]; ++e)
        for (const auto& term : z[k.column[e]])
          for (int m = 0; m < modes; ++m) kz[i * n + local[term.block] * modes + m] += k.value[e] * term.value[m];
    for (int i = 0; i < k.rows(); ++i)
      for (const auto& term : z[i])
        for (int other : around)
          if (other >= term.block) add_to(term.block, other, term.value, &kz[i * n + local[other] * modes]);
    for (int other : around) local[other] = -1;
  }
  elastic_ = std::move(matrix_.value);
}

template <int dim>
SolvedBy BlockMotions::Motions<dim>::update(const std::vector<PointStiffness>& stiffness,
                                            const std::vector<double>& proximal) {
  matrix_.value = elastic_;
  Row row;
  for (int k : couplings_) {
    const auto& p = points_.points()[k];
    const auto s = stiffness[k].springs();  // a joint that softens is none
    const auto resist = [&](const Vector<3>& along, double sigma) {
      if (sigma == 0) return;
      Vector<dim> axis;
      std::copy_n(along.begin(), dim, axis.begin());
      row.clear();
      points_.at(k).each([&](int node, double weight) { add_motion(space_.cluster()[node], axis, weight, row); });
      add_product(row, sigma);
    };
    resist(p.axis[0], s.normal);
    // What two tangents have in common, by 2 t u = (t + u)^2 - t^2 - u^2.
    for (int t = 1; t < dim; ++t) {
      double alone = s.along(t - 1, t - 1);
      for (int u = 1; u < dim; ++u) {
        if (u == t) continue;
        alone -= s.along(t - 1, u - 1);
        if (u > t) resist(p.axis[t] + p.axis[u], s.along(t - 1, u - 1));
      }
      resist(p.axis[t], alone);
    }
  }
  for (std::size_t i = 0; i < proximal.size(); ++i) {
    Vector<dim> direction{};
    direction[i % dim] = 1;
    row.clear();
    add_motion(static_cast<int>(i) / dim, direction, 1.0, row);
    add_product(row, proximal[i]);
  }
  const auto by = system_->factor(matrix_);
  matrix_.value = std::vector<double>();  // a factor needs no matrix, and Krylov vectors may need its room
  return by;
}

template <int dim>
void BlockMotions::Motions<dim>::add(const TpetraVector& r, TpetraVector& z) const {
  const TrafficScope sent_for(TrafficOf::block_motions);
  std::vector<double> mine(matrix_.rows(), 0.0), coarse;
  const double* fine = local_view(r);
  for (int cluster = 0; cluster < space_.owned_clusters(); ++cluster) {
    Vector<dim> force{};  // on each copy
    for (int c = 0; c < dim; ++c)
      if (!space_.held()[dim * cluster + c]) force[c] = fine[dim * cluster + c] / space_.multiplicity()[cluster];
    force = space_.held().from_own(cluster, force);
    for (int k = copy_start_[cluster]; k < copy_start_[cluster + 1]; ++k) {
      const auto moments = motion(copies_[k].arm, force);
      const int block = copies_[k].block;
      for (int m = 0; m < modes; ++m) mine[modes * block + m] += moments[m];
    }
  }
  system_->solve(mine, coarse);
  double* value = local_view_to_write(z);
  for (int cluster = 0; cluster < space_.owned_clusters(); ++cluster) {
    Vector<dim> moved{};
    for (int k = copy_start_[cluster]; k < copy_start_[cluster + 1]; ++k) {
      const int block = copies_[k].block;
      Modes motions;
      std::copy_n(&coarse[modes * block], modes, motions.begin());
      moved = moved + displacement(copies_[k].arm, motions);
    }
    moved = space_.held().to_own(cluster, moved);
    for (int c = 0; c < dim; ++c)
      if (!space_.held()[dim * cluster + c]) value[dim * cluster + c] += moved[c] / space_.multiplicity()[cluster];
  }
}

template <int dim>
long long BlockMotions::Motions<dim>::bytes() const {
  return system_->bytes() + matrix_.bytes() +
         static_cast<long long>(copies_.size() * sizeof(Copy) + elastic_.size() * sizeof(double) +
                                (copy_start_.size() + couplings_.size() + number_.size()) * sizeof(int));
}

BlockMotions::BlockMotions(const BlockSystem& s, const ContactPoints& points, const std::vector<char>& selected,
                           const MergedSpace& space, const std::vector<char>& active,
                           const SharedSystemParameters& numbers)
    : kernel_(with_components(s.components(), [&](auto dim) -> std::unique_ptr<Kernel> {
        return std::make_unique<Motions<dim>>(s, points, selected, space, active, numbers);
      })) {}

BlockMotions::BlockMotions(const BlockSystem& s, const ContactPoints& points, const std::vector<char>& selected,
                           const MergedSpace& space, const std::vector<char>& active)
    : BlockMotions(s, points, selected, space, active, SharedSystemParameters()) {}

BlockMotions::~BlockMotions() = default;

void BlockMotions::factor_on_first_rank() { kernel_->factor_on_first_rank(); }

SolvedBy BlockMotions::update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal) {
  return kernel_->update(stiffness, proximal);
}

void BlockMotions::add(const TpetraVector& r, TpetraVector& z) const { kernel_->add(r, z); }

long long BlockMotions::size() const { return kernel_->size(); }

std::vector<MultigridLevel> BlockMotions::levels() const { return kernel_->levels(); }

long long BlockMotions::bytes() const { return kernel_->bytes(); }

}  // namespace voussoir

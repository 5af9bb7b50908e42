#include "homogenisation/merged_space.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_OrdinalTraits.hpp>
#include <algorithm>
#include <utility>

#include "base/check.hpp"
#include "base/components.hpp"
#include "base/disjoint_sets.hpp"
#include "base/sort_unique.hpp"
#include "linalg/local_view.hpp"

namespace voussoir {
namespace {

/// Root of each local node copy at owned vertices: the copies joined by bonded points have one root,
/// the one with the lowest node number.
std::vector<int> roots(const BlockSystem& s, const ContactPoints& points, const std::vector<char>& selected) {
  DisjointSets sets(s.nodes());
  for (int k = 0; k < points.size(); ++k) {
    const auto& p = points.points()[k];
    if (selected[k]) continue;
    VOUSSOIR_EXPECT(p.can_be_tied());
    int a = sets.root(p.shares_i.first()), b = sets.root(p.shares_j.first());
    if (s.node_id()[a] > s.node_id()[b]) std::swap(a, b);
    sets.join(b, a);
  }
  std::vector<int> root(s.nodes());
  for (int i = 0; i < s.nodes(); ++i) root[i] = sets.root(i);
  return root;
}

/// Numbers of the clusters of all node copies. Owned are those whose root this rank owns; numbers run rank by rank.
struct ClusterNumbers {
  std::vector<long long> of_node;
  std::vector<int> representative;       ///< a node copy of each owned cluster
  long long first = 0, behind_last = 0;  ///< of the owned ones

  bool owned(long long n) const { return n >= first && n < behind_last; }
  int count() const { return static_cast<int>(representative.size()); }
};

ClusterNumbers number_clusters(const BlockSystem& s, const std::vector<int>& root) {
  ClusterNumbers numbers;
  auto& number = numbers.of_node;
  number.assign(s.nodes(), -1);
  for (int i = 0; i < s.owned_nodes(); ++i)
    if (root[i] == i) {
      number[i] = numbers.count();
      numbers.representative.push_back(i);
    }
  Teuchos::scan(*s.comm(), Teuchos::REDUCE_SUM, static_cast<long long>(numbers.count()),
                Teuchos::outArg(numbers.behind_last));
  numbers.first = numbers.behind_last - numbers.count();
  for (const int i : numbers.representative) number[i] += numbers.first;
  // Roots of owned nodes lie at owned vertices, so they are local; then halo nodes ask their owners.
  s.node_exchange().update(number);
  for (int i = 0; i < s.owned_nodes(); ++i) number[i] = number[root[i]];
  s.node_exchange().update(number);
  return numbers;
}

}  // namespace

MergedSpace::MergedSpace(const BlockSystem& s, const ContactPoints& points, const std::vector<char>& selected,
                         const Held& held)
    : held_copy_(held), dim_(s.components()), nodes_(s.nodes()) {
  const int dim = dim_;
  auto numbers = number_clusters(s, roots(s, points, selected));
  representative_ = std::move(numbers.representative);
  owned_clusters_ = static_cast<int>(representative_.size());
  const auto& number = numbers.of_node;
  const long long first = numbers.first;
  std::vector<long long> ghosts;
  for (long long n : number)
    if (!numbers.owned(n)) ghosts.push_back(n);
  sort_unique(ghosts);
  cluster_.resize(nodes_);
  for (int i = 0; i < nodes_; ++i)
    cluster_[i] = numbers.owned(number[i])
                      ? static_cast<int>(number[i] - first)
                      : owned_clusters_ + static_cast<int>(std::lower_bound(ghosts.begin(), ghosts.end(), number[i]) -
                                                           ghosts.begin());

  std::vector<GlobalOrdinal> ids;
  for (int k = 0; k < owned_clusters_; ++k)
    for (int c = 0; c < dim; ++c) ids.push_back(dim * (first + k) + c);
  map_ = map_of(ids, s.comm());
  for (long long n : ghosts)
    for (int c = 0; c < dim; ++c) ids.push_back(dim * n + c);
  column_map_ = map_of(ids, s.comm());
  import_ = Teuchos::rcp(new TpetraImport(map_, column_map_));
  column_vector_ = Teuchos::rcp(new TpetraVector(column_map_));

  // All copies of an owned cluster are local: count them and see which components are held, then tell the ghosts.
  const int all = owned_clusters_ + static_cast<int>(ghosts.size());
  multiplicity_.assign(all, 0.0);
  held_ = Held(std::vector<char>(static_cast<std::size_t>(dim) * all, 0));
  for (int i = 0; i < nodes_; ++i)
    if (cluster_[i] < owned_clusters_) {
      multiplicity_[cluster_[i]] += 1;
      for (int c = 0; c < dim; ++c) held_[dim * cluster_[i] + c] |= held[dim * i + c];
    }
  TpetraMultiVector source(map_, 2), target(column_map_, 2);
  {
    auto view = source.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int k = 0; k < dim * owned_clusters_; ++k) {
      view(k, 0) = multiplicity_[k / dim];
      view(k, 1) = held_[k];
    }
  }
  target.doImport(source, *import_, Tpetra::INSERT);
  const auto view = target.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int k = dim * owned_clusters_; k < dim * all; ++k) {
    multiplicity_[k / dim] = view(k, 0);
    held_[k] = view(k, 1) != 0;
  }
  for (const auto& [node, axes] : held.frames()) {
    VOUSSOIR_EXPECT(multiplicity_[cluster_[node]] == 1 && "a node with axes of its own is tied to none");
    held_.set_frame(cluster_[node], axes);
  }
}

void MergedSpace::turn_to_unknowns(std::vector<double>& nodal) const {
  for (const auto& [node, axes] : held_copy_.frames()) {
    Vector<3> v{};
    std::copy_n(nodal.begin() + static_cast<long>(dim_) * node, dim_, v.begin());
    v = Held::turned(axes, v);
    std::copy_n(v.begin(), dim_, nodal.begin() + static_cast<long>(dim_) * node);
  }
}

std::vector<double> MergedSpace::held_part(const std::vector<double>& nodal) const {
  std::vector<char> along(nodal.size());
  for (std::size_t i = 0; i < along.size(); ++i)
    along[i] = held_[static_cast<std::size_t>(dim_) * cluster_[i / dim_] + i % dim_];
  Held of_copies(std::move(along));
  for (const auto& [node, axes] : held_copy_.frames()) of_copies.set_frame(node, axes);
  return of_copies.held_part(nodal, dim_);
}

void MergedSpace::scatter(const TpetraVector& x, std::vector<double>& u) const {
  column_vector_->doImport(x, *import_, Tpetra::INSERT);
  const double* value = local_view(*column_vector_);
  u.resize(static_cast<std::size_t>(dim_) * nodes_);
  with_components(dim_, [&](auto dim) {
    for (int i = 0; i < nodes_; ++i)
      for (int c = 0; c < dim; ++c) u[dim * i + c] = value[dim * cluster_[i] + c];
  });
  for (const auto& [node, axes] : held_copy_.frames()) {
    Vector<3> own{};
    std::copy_n(value + static_cast<long>(dim_) * cluster_[node], dim_, own.begin());
    own = Held::turned_back(axes, own);
    std::copy_n(own.begin(), dim_, u.begin() + static_cast<long>(dim_) * node);
  }
}

void MergedSpace::sum(const std::vector<double>& r, TpetraVector& x) const {
  x.putScalar(0);
  double* value = local_view_to_write(x);
  with_components(dim_, [&](auto dim) {
    for (int i = 0; i < nodes_; ++i)
      if (cluster_[i] < owned_clusters_)
        for (int c = 0; c < dim; ++c) value[dim * cluster_[i] + c] += r[dim * i + c];
  });
  turn_own(value);
  for (int k = 0; k < dim_ * owned_clusters_; ++k)
    if (held_[k]) value[k] = 0;
}

void MergedSpace::average(const std::vector<double>& u, TpetraVector& x) const {
  x.putScalar(0);
  double* value = local_view_to_write(x);
  for (int i = 0; i < nodes_; ++i) {
    const int k = cluster_[i];
    if (k < owned_clusters_)
      for (int c = 0; c < dim_; ++c) value[dim_ * k + c] += u[dim_ * i + c] / multiplicity_[k];
  }
  for (int i = 0; i < nodes_; ++i)
    for (int c = 0; c < dim_; ++c)
      if (cluster_[i] < owned_clusters_ && held_copy_[dim_ * i + c]) value[dim_ * cluster_[i] + c] = u[dim_ * i + c];
  for (const auto& [node, axes] : held_copy_.frames())  // whatever of them is held
    if (cluster_[node] < owned_clusters_)
      std::copy_n(u.begin() + static_cast<long>(dim_) * node, dim_, value + static_cast<long>(dim_) * cluster_[node]);
  turn_own(value);
}

/// Takes what of owned clusters goes along the axes of the drawing to their own.
void MergedSpace::turn_own(double* value) const {
  for (const auto& [cluster, axes] : held_.frames()) {
    if (cluster >= owned_clusters_) continue;
    Vector<3> v{};
    std::copy_n(value + static_cast<long>(dim_) * cluster, dim_, v.begin());
    v = Held::turned(axes, v);
    std::copy_n(v.begin(), dim_, value + static_cast<long>(dim_) * cluster);
  }
}

}  // namespace voussoir

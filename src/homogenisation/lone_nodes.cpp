#include "homogenisation/lone_nodes.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "linalg/local_view.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

/// The sine of an angle whose square is round-off: multigrid squares what it asks of rigid motions.
const double straight = std::sqrt(std::numeric_limits<double>::epsilon());

/// Calls f(neighbour, i, j, value) for every entry that is not zero in the rows of a node.
template <class F>
void each_entry(const TpetraMatrix& a, int dim, int node, const F& f) {
  const auto local = a.getLocalMatrixHost();
  for (int i = 0; i < dim; ++i) {
    const auto row = local.rowConst(dim * node + i);
    for (int e = 0; e < row.length; ++e)
      if (row.value(e) != 0) f(row.colidx(e) / dim, i, row.colidx(e) % dim, row.value(e));
  }
}

/// Whether unknowns of a node have something to do with others, or with each other.
bool is_coupled(const TpetraMatrix& a, int dim, int node) {
  bool coupled = false;
  each_entry(a, dim, node, [&](int other, int i, int j, double) { coupled |= other != node || i != j; });
  return coupled;
}

/// Whether rigid motions of a node and its neighbours depend on each other: in the plane where it has none, in space
/// where all are on one line through it.
bool is_lone(const TpetraMatrix& a, int dim, int node, const std::vector<char>& lone, const double* places) {
  const auto each_way = [&](const auto& f) {
    each_entry(a, dim, node, [&](int other, int, int, double) {
      if (other == node || lone[other]) return;
      Vector<3> way{};
      for (int c = 0; c < dim; ++c) way[c] = places[dim * other + c] - places[dim * node + c];
      f(way);
    });
  };
  Vector<3> longest{};
  each_way([&](const Vector<3>& way) {
    if (dot(way, way) > dot(longest, longest)) longest = way;
  });
  if (dim == 2) return norm(longest) == 0;
  bool beside = false;
  each_way(
      [&](const Vector<3>& way) { beside = beside || norm(cross(longest, way)) > straight * dot(longest, longest); });
  return !beside;
}

/// Lone nodes, each for itself, beside a preconditioner of the others.
class NodesBeside : public Preconditioner {
 public:
  NodesBeside(std::shared_ptr<const Preconditioner> others, int dim, std::vector<int> node,
              std::vector<Matrix<3>> matrix)
      : others_(std::move(others)), dim_(dim), node_(std::move(node)), matrix_(std::move(matrix)) {}

  void apply(const TpetraVector& r, TpetraVector& z) const override {
    if (others_)
      others_->apply(r, z);
    else
      z.putScalar(0);
    const double* right = local_view(r);
    double* value = local_view_to_write(z);
    for (std::size_t k = 0; k < node_.size(); ++k) {
      Vector<3> force{};
      for (int c = 0; c < dim_; ++c) force[c] = right[dim_ * node_[k] + c];
      const auto moved = solve_positive(matrix_[k], force);
      for (int c = 0; c < dim_; ++c) value[dim_ * node_[k] + c] = moved[c];
    }
  }

 private:
  std::shared_ptr<const Preconditioner> others_;
  int dim_;
  std::vector<int> node_;
  std::vector<Matrix<3>> matrix_;
};

}  // namespace

/// Where a node is found its neighbours have one less, so they are looked at again until nothing changes. What is found
/// does not depend on the order, nor on ranks.
LoneNodes::LoneNodes(const TpetraMatrix& a, const MergedSpace& space, const TpetraVector& places)
    : lone_(space.clusters(), 0), dim_(space.components()), owned_(space.owned_clusters()) {
  TpetraVector seen(space.column_map()), mine(space.map()), told(space.column_map());
  seen.doImport(places, space.import(), Tpetra::INSERT);
  std::vector<int> candidates;
  for (int k = 0; k < owned_; ++k)
    if (is_coupled(a, dim_, k)) candidates.push_back(k);
  for (bool found = true; any_of_ranks(*a.getComm(), found);) {
    found = false;
    for (bool again = true; std::exchange(again, false);)
      for (const int k : candidates)
        if (!lone_[k] && is_lone(a, dim_, k, lone_, local_view(seen))) {
          lone_[k] = found = again = true;
          local_view_to_write(mine)[dim_ * k] = 1;
        }
    told.doImport(mine, space.import(), Tpetra::INSERT);
    for (int k = owned_; k < space.clusters(); ++k) lone_[k] = local_view(told)[dim_ * k] > 0;
  }
  for (const int k : candidates) {
    if (!lone_[k]) continue;
    node_.push_back(k);
    Matrix<3> own{};
    each_entry(a, dim_, k, [&](int other, int i, int j, double value) {
      if (other == k) own[i][j] = value;
    });
    matrix_.push_back(own);
  }
  any_ = any_of_ranks(*a.getComm(), !node_.empty());
  others_ = any_of_ranks(*a.getComm(), node_.size() < candidates.size());
}

Teuchos::RCP<TpetraMatrix> LoneNodes::left_out_of(const TpetraMatrix& a) const {
  auto rest = Teuchos::rcp(new TpetraMatrix(a, Teuchos::Copy));
  rest->resumeFill();
  const auto local = rest->getLocalMatrixHost();
  for (int i = 0; i < dim_ * owned_; ++i) {
    auto row = local.row(i);
    for (int e = 0; e < row.length; ++e)
      if (row.colidx(e) != i && (lone_[i / dim_] || lone_[row.colidx(e) / dim_])) row.value(e) = 0;
  }
  rest->fillComplete(a.getDomainMap(), a.getRangeMap());
  return rest;
}

std::shared_ptr<const Preconditioner> LoneNodes::beside(std::shared_ptr<const Preconditioner> of_others) const {
  return std::make_shared<NodesBeside>(std::move(of_others), dim_, node_, matrix_);
}

}  // namespace voussoir

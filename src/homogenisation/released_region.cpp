#include "homogenisation/released_region.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <numeric>
#include <utility>

#include "linalg/local_view.hpp"
#include "linalg/parcels.hpp"
#include "linalg/reduce.hpp"
#include "linalg/solver_failure.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {
namespace {

/// Per unknown of the column map: 1 where a selection parts two nodes.
std::vector<char> parted(const ContactPoints& points, const std::vector<char>& selected, const MergedSpace& space) {
  std::vector<char> inside(space.clusters(), 0);
  for (int k = 0; k < points.size(); ++k) {
    if (!selected[k] || space.tied(points.points()[k])) continue;
    points.at(k).each([&](int node, double) { inside[space.cluster()[node]] = 1; });
  }
  return inside;
}

}  // namespace

ReleasedRegion::ReleasedRegion(const BlockSystem& s, const ContactPoints& points, const std::vector<char>& selected,
                               const MergedSpace& space, const CoarseOperatorParameters& numbers)
    : space_(space) {
  const int dim = space.components();
  auto inside = parted(points, selected, space);
  const auto& cluster = space.cluster();
  const auto unknowns = static_cast<double>(space.map()->getGlobalNumElements());
  const auto most =
      static_cast<long long>(std::min(numbers.largest_region * unknowns, static_cast<double>(SparseLu::most_rows)));
  number(inside);
  for (int layer = 0; layer < numbers.layers && size_ > 0 && size_ <= most; ++layer) {
    TpetraVector mark(space.map()), seen(space.column_map());
    auto wider = inside;
    for (int b = 0; b < s.local_blocks(); ++b) {
      const auto& block = s.nodes_of(b);
      const auto& k = *block.sparse;  // which knows the cells
      for (int i = 0; i < block.nodes; ++i) {
        if (!inside[cluster[block.first_local + i]]) continue;
        for (int e = k.start[dim * i]; e < k.start[dim * i + 1]; e += dim)
          wider[cluster[block.first_local + k.column[e] / dim]] = 1;
      }
    }
    // Ghosts have neighbours that their owner alone knows.
    double* mine = local_view_to_write(mark);
    for (int c = 0; c < space.owned_clusters(); ++c) mine[dim * c] = wider[c];
    seen.doImport(mark, space.import(), Tpetra::INSERT);
    const double* all = local_view(seen);
    for (int c = 0; c < space.clusters(); ++c) inside[c] = all[dim * c] > 0;
    number(inside);
  }
  pays_ = size_ <= most;
}

/// Collective.
/// @param inside  per cluster
void ReleasedRegion::number(const std::vector<char>& inside) {
  const int dim = space_.components();
  unknown_.clear();
  for (int i = 0; i < dim * space_.owned_clusters(); ++i)
    if (inside[i / dim] && !space_.held()[i]) unknown_.push_back(i);
  const auto& comm = *space_.map()->getComm();
  const auto mine = static_cast<long long>(unknown_.size());
  long long until = 0;
  Teuchos::scan(comm, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(until));
  first_ = until - mine;
  size_ = total_over_ranks(comm, mine);
}

void ReleasedRegion::set_pattern(const OwnedRows& h) {
  const auto& comm = *space_.map()->getComm();
  // Number in the region, -1 outside, of every unknown of the column map: told by its owner.
  TpetraVector mine(space_.map()), all(space_.column_map());
  mine.putScalar(-1);
  for (std::size_t i = 0; i < unknown_.size(); ++i)
    local_view_to_write(mine)[unknown_[i]] = static_cast<double>(first_) + static_cast<double>(i);
  all.doImport(mine, space_.import(), Tpetra::INSERT);
  const double* number = local_view(all);
  std::vector<int> length, column;
  std::vector<std::pair<int, std::size_t>> row;
  for (const int i : unknown_) {
    row.clear();
    for (std::size_t e = h.start[i]; e < h.start[i + 1]; ++e)
      if (number[h.column[e]] >= 0) row.emplace_back(static_cast<int>(number[h.column[e]]), e);
    std::sort(row.begin(), row.end());
    for (const auto& [j, e] : row) {
      column.push_back(j);
      entry_.push_back(e);
    }
    length.push_back(static_cast<int>(row.size()));
  }
  for (const int n : gather_on_first(length, comm)) matrix_.start.push_back(matrix_.start.back() + n);
  matrix_.column = gather_on_first(column, comm);
  known_ = true;
  if (comm.getSize() == 1) return;
  const auto rows = [&](long long first, int count) {
    std::vector<GlobalOrdinal> numbers(count);
    std::iota(numbers.begin(), numbers.end(), first);
    return Teuchos::rcp(
        new TpetraMap(Tpetra::global_size_t(size_), Teuchos::arrayViewFromVector(numbers), 0, space_.map()->getComm()));
  };
  from_first_ =
      Teuchos::rcp(new TpetraImport(rows(0, matrix_.rows()), rows(first_, static_cast<int>(unknown_.size()))));
}

bool ReleasedRegion::update(const SystemMatrix& system) {
  const auto h = system.local();
  const auto& comm = *space_.map()->getComm();
  if (!known_) set_pattern(h);
  std::vector<double> value;
  value.reserve(entry_.size());
  for (const std::size_t e : entry_) value.push_back(h.value[e]);
  matrix_.value = gather_on_first(value, comm);
  bool regular = true;
  all_or_none(comm, [&] {
    if (comm.getRank() == 0) regular = factor_.factor(matrix_);
  });
  return all_of_ranks(comm, regular);
}

/// Of the first rank: not a number where it cannot.
void ReleasedRegion::solve(const double* right, double* solution) const {
  std::vector<double> x(matrix_.rows());
  solve_or_not_a_number(x, [&] {
    if (!factor_.solve(matrix_, right, x.data()))
      throw SolverFailure("UMFPACK found the matrix around what has parted singular");
  });
  std::copy(x.begin(), x.end(), solution);
}

void ReleasedRegion::add(const TpetraVector& r, TpetraVector& z) const {
  const TrafficScope sent_for(TrafficOf::block_motions);
  const double* residual = local_view(r);
  std::vector<double> mine;
  for (const int i : unknown_) mine.push_back(residual[i]);
  if (from_first_.is_null()) {
    solve(mine.data(), mine.data());
  } else {
    TpetraVector here(from_first_->getTargetMap()), all(from_first_->getSourceMap());
    std::copy(mine.begin(), mine.end(), local_view_to_write(here));
    all.doExport(here, *from_first_, Tpetra::INSERT);
    if (matrix_.rows() > 0) solve(local_view(all), local_view_to_write(all));
    here.doImport(all, *from_first_, Tpetra::INSERT);
    std::copy_n(local_view(here), mine.size(), mine.begin());
  }
  double* value = local_view_to_write(z);
  for (std::size_t i = 0; i < unknown_.size(); ++i) value[unknown_[i]] += mine[i];
}

long long ReleasedRegion::bytes() const {
  return matrix_.bytes() + factor_.bytes() +
         static_cast<long long>(entry_.size() * sizeof(std::size_t) + unknown_.size() * sizeof(int));
}

}  // namespace voussoir

#include "linalg/direct_preconditioner.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/check.hpp"
#include "linalg/local_view.hpp"
#include "linalg/parcels.hpp"
#include "linalg/solver_failure.hpp"

namespace voussoir {
namespace {

struct Position {
  long long row, column;
};

/// Does work with every owned entry that is not below the diagonal: its position, and its value.
template <class Work>
void each_of_upper_triangle(const TpetraMatrix& a, const Work& work) {
  const auto& map = *a.getRowMap();
  const auto local = a.getLocalMatrixHost();
  for (int i = 0; i < static_cast<int>(local.numRows()); ++i) {
    const auto row = local.rowConst(i);
    for (int k = 0; k < row.length; ++k) {
      const Position at{map.getGlobalElement(i), a.getColMap()->getGlobalElement(row.colidx(k))};
      if (at.column >= at.row) work(at, row.value(k));
    }
  }
}

}  // namespace

DirectPreconditioner::DirectPreconditioner(const TpetraMatrix& a, TrafficOf sent_for)
    : map_(a.getRowMap()), sent_for_(sent_for) {
  const auto& comm = *map_->getComm();
  std::vector<Position> entries;
  each_of_upper_triangle(a, [&](const Position& at, double) { entries.push_back(at); });
  entries = gather_on_first(entries, comm);
  std::vector<int> order(entries.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int x, int y) {
    return std::tie(entries[x].row, entries[x].column) < std::tie(entries[y].row, entries[y].column);
  });
  place_.resize(entries.size());
  const auto end_row = [&] { pattern_.start.push_back(static_cast<int>(pattern_.column.size())); };
  for (const int k : order) {
    while (pattern_.rows() < entries[k].row) end_row();
    place_[k] = static_cast<int>(pattern_.column.size());
    pattern_.column.push_back(static_cast<int>(entries[k].column));
  }
  const auto rows = comm.getRank() == 0 ? static_cast<int>(map_->getGlobalNumElements()) : 0;
  while (pattern_.rows() < rows) end_row();
  if (comm.getSize() > 1) {
    std::vector<GlobalOrdinal> all(rows);
    std::iota(all.begin(), all.end(), map_->getMinAllGlobalIndex());
    const auto on_first = Teuchos::rcp(new TpetraMap(map_->getGlobalNumElements(), Teuchos::arrayViewFromVector(all),
                                                     map_->getIndexBase(), map_->getComm()));
    from_first_ = Teuchos::rcp(new TpetraImport(on_first, map_));
  }
  refactor(a);
}

/// Of the first rank; nothing on others. Collective.
LocalCsr DirectPreconditioner::whole_of(const TpetraMatrix& a) const {
  std::vector<double> values;
  each_of_upper_triangle(a, [&](const Position&, double value) { values.push_back(value); });
  values = gather_on_first(values, *map_->getComm());
  VOUSSOIR_EXPECT(values.size() == place_.size() && "matrix: of the pattern of the first one");
  auto whole = pattern_;
  whole.value.resize(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) whole.value[place_[k]] = values[k];
  return whole;
}

void DirectPreconditioner::refactor(const TpetraMatrix& a) {
  const auto whole = whole_of(a);
  all_or_none(*map_->getComm(), [&] {
    if (map_->getComm()->getRank() > 0) return;
    if (factor_)
      factor_->refactor(whole);
    else
      factor_ = std::make_unique<SparseCholesky>(whole);
  });
}

void DirectPreconditioner::apply(const TpetraVector& r, TpetraVector& z) const {
  const TrafficScope sent_for(sent_for_);
  if (from_first_.is_null()) {
    std::vector<double> whole(local_view(r), local_view(r) + r.getLocalLength());
    solve_or_not_a_number(whole, [&] { factor_->solve(whole.data(), whole.data()); });
    std::copy(whole.begin(), whole.end(), local_view_to_write(z));
    return;
  }
  TpetraVector all(from_first_->getSourceMap());
  all.doExport(r, *from_first_, Tpetra::INSERT);
  if (factor_) {
    std::vector<double> whole(local_view(all), local_view(all) + all.getLocalLength());
    solve_or_not_a_number(whole, [&] { factor_->solve(whole.data(), whole.data()); });
    std::copy(whole.begin(), whole.end(), local_view_to_write(all));
  }
  z.doImport(all, *from_first_, Tpetra::INSERT);
}

long long DirectPreconditioner::bytes() const {
  return (factor_ ? factor_->bytes() : 0) + pattern_.bytes() + static_cast<long long>(place_.size() * sizeof(int));
}

}  // namespace voussoir

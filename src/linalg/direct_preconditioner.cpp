#include "linalg/direct_preconditioner.hpp"

#include <algorithm>
#include <tuple>

#include "linalg/gather.hpp"
#include "linalg/local_view.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {
namespace {

struct Entry {
  long long row, column;
  double value;
};

}  // namespace

DirectPreconditioner::DirectPreconditioner(const TpetraMatrix& a) : map_(a.getRowMap()) {
  std::vector<Entry> entries;  // of the upper triangle
  const auto local = a.getLocalMatrixHost();
  for (int i = 0; i < static_cast<int>(local.numRows()); ++i) {
    const auto row = local.row(i);
    for (int k = 0; k < row.length; ++k) {
      const Entry e{map_->getGlobalElement(i), a.getColMap()->getGlobalElement(row.colidx(k)), row.value(k)};
      if (e.column >= e.row) entries.push_back(e);
    }
  }
  entries = all_gather(entries, *map_->getComm());
  std::sort(entries.begin(), entries.end(),
            [](const Entry& x, const Entry& y) { return std::tie(x.row, x.column) < std::tie(y.row, y.column); });
  LocalCsr whole;
  const auto end_row = [&whole] { whole.start.push_back(static_cast<int>(whole.column.size())); };
  for (const auto& e : entries) {
    while (whole.rows() < e.row) end_row();
    whole.column.push_back(static_cast<int>(e.column));
    whole.value.push_back(e.value);
  }
  while (whole.rows() < static_cast<int>(map_->getGlobalNumElements())) end_row();
  factor_ = std::make_unique<SparseCholesky>(whole);
}

void DirectPreconditioner::apply(const TpetraVector& r, TpetraVector& z) const {
  const TrafficScope sent_for(TrafficOf::continuum);
  const int owned = static_cast<int>(map_->getNodeNumElements());
  const double* value = local_view(r);
  auto whole = all_gather(std::vector<double>(value, value + owned), *map_->getComm());
  factor_->solve(whole.data(), whole.data());
  const long long first = owned > 0 ? map_->getGlobalElement(0) : 0;
  std::copy_n(whole.begin() + first, owned, local_view_to_write(z));
}

}  // namespace voussoir

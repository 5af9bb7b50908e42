#include "linalg/shared_system.hpp"

#include <algorithm>
#include <new>
#include <tuple>
#include <utility>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "linalg/local_view.hpp"
#include "linalg/reduce.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {
namespace {

/// Of an entry of the sum, not below the diagonal.
struct Position {
  GlobalOrdinal row, column;
  friend bool operator<(const Position& a, const Position& b) {
    return std::tie(a.row, a.column) < std::tie(b.row, b.column);
  }
  friend bool operator==(const Position& a, const Position& b) { return a.row == b.row && a.column == b.column; }
};

Teuchos::RCP<const TpetraMap> map_of(const std::vector<GlobalOrdinal>& numbers,
                                     const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const auto unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new TpetraMap(unknown, Teuchos::arrayViewFromVector(numbers), 0, comm));
}

}  // namespace

/// The upper triangle of the sum of all parts, its rows on their owners.
class SharedSystem::Sum {
 public:
  Sum(const Unknowns& unknowns, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) : unknowns_(unknowns), comm_(comm) {
    const auto behind = unknowns.number.begin() + unknowns.owned;
    rows_ = map_of({unknowns.number.begin(), behind}, comm);
    local_ = map_of(unknowns.number, comm);
    import_ = Teuchos::rcp(new TpetraImport(rows_, local_));
  }
  /// Takes the pattern of the first part, and values of all.
  const TpetraMatrix& of(const LocalCsr& part) {
    if (matrix_.is_null()) set_pattern(part);
    std::vector<Parcel<double>> out;
    for (const auto& [rank, entries] : to_) {
      out.push_back({rank, {}});
      out.back().items.reserve(entries.size());
      for (const int e : entries) out.back().items.push_back(part.value[e]);
    }
    Kokkos::deep_copy(value_, 0.0);
    for (std::size_t k = 0; k < mine_.size(); ++k) value_(mine_place_[k]) += part.value[mine_[k]];
    // By senders, so that sums are the same in every run.
    const auto in = exchange_parcels(std::move(out), *comm_);
    VOUSSOIR_ASSERT(in.size() == from_.size());
    for (std::size_t p = 0; p < in.size(); ++p) {
      VOUSSOIR_ASSERT(in[p].items.size() == from_[p].size());
      for (std::size_t k = 0; k < from_[p].size(); ++k) value_(from_[p][k]) += in[p].items[k];
    }
    return *matrix_;
  }
  /// Parts of a vector, added up by the owners.
  void add_up(const std::vector<double>& parts, TpetraVector& owned) const {
    TpetraVector here(local_);
    std::copy(parts.begin(), parts.end(), local_view_to_write(here));
    owned.putScalar(0);
    owned.doExport(here, *import_, Tpetra::ADD);
  }
  /// What owners have, for all who know it.
  void tell(const TpetraVector& owned, std::vector<double>& known) const {
    TpetraVector here(local_);
    here.doImport(owned, *import_, Tpetra::INSERT);
    known.assign(local_view(here), local_view(here) + here.getLocalLength());
  }
  const Teuchos::RCP<const TpetraMap>& rows() const { return rows_; }
  long long bytes() const {
    const auto entries = static_cast<long long>(value_.extent(0));
    return entries * static_cast<long long>(sizeof(double) + 2 * sizeof(int));
  }

 private:
  void set_pattern(const LocalCsr& part);
  void set_matrix(const std::vector<Position>& positions);

  const Unknowns& unknowns_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  Teuchos::RCP<const TpetraMap> rows_, local_;
  Teuchos::RCP<const TpetraImport> import_;
  Teuchos::RCP<TpetraMatrix> matrix_;
  TpetraMatrix::local_matrix_host_type::values_type::non_const_type value_;
  std::vector<Parcel<int>> to_;                 ///< entries of the part that go to others
  std::vector<int> mine_, mine_place_;          ///< those that stay, and where they belong
  std::vector<std::vector<std::size_t>> from_;  ///< where those belong that come from others, by senders
};

void SharedSystem::Sum::set_pattern(const LocalCsr& part) {
  const auto& number = unknowns_.number;
  std::vector<Position> positions;
  std::vector<Parcel<Position>> out;
  std::vector<int> parcel_of(comm_->getSize(), -1);
  for (int i = 0; i < part.rows(); ++i)
    for (int e = part.start[i]; e < part.start[i + 1]; ++e) {
      const int j = part.column[e], first = number[i] <= number[j] ? i : j, second = first == i ? j : i;
      const Position at{number[first], number[second]};
      const int rank = unknowns_.owner[first];
      if (rank == comm_->getRank()) {
        mine_.push_back(e);
        positions.push_back(at);
        continue;
      }
      if (parcel_of[rank] < 0) {
        parcel_of[rank] = static_cast<int>(out.size());
        out.push_back({rank, {}});
        to_.push_back({rank, {}});
      }
      out[parcel_of[rank]].items.push_back(at);
      to_[parcel_of[rank]].items.push_back(e);
    }
  const auto in = exchange_parcels(std::move(out), *comm_);
  auto all = positions;
  for (const auto& parcel : in) all.insert(all.end(), parcel.items.begin(), parcel.items.end());
  sort_unique(all);
  const auto place = [&](const Position& at) {
    return static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), at) - all.begin());
  };
  for (const auto& at : positions) mine_place_.push_back(static_cast<int>(place(at)));
  for (const auto& parcel : in) {
    from_.emplace_back();
    for (const auto& at : parcel.items) from_.back().push_back(place(at));
  }
  set_matrix(all);
}

/// Columns of others have higher numbers than all owned ones, so local columns ascend as numbers do.
void SharedSystem::Sum::set_matrix(const std::vector<Position>& positions) {
  const GlobalOrdinal first = unknowns_.owned > 0 ? unknowns_.number[0] : 0;
  std::vector<GlobalOrdinal> columns(unknowns_.number.begin(), unknowns_.number.begin() + unknowns_.owned), others;
  for (const auto& at : positions)
    if (at.column >= first + unknowns_.owned) others.push_back(at.column);
  sort_unique(others);
  columns.insert(columns.end(), others.begin(), others.end());
  TpetraMatrix::local_matrix_host_type::row_map_type::non_const_type start("start", unknowns_.owned + 1);
  TpetraMatrix::local_matrix_host_type::index_type::non_const_type column("column", positions.size());
  value_ = decltype(value_)("value", positions.size());
  std::size_t next = 0;
  for (int i = 0; i < unknowns_.owned; ++i) {
    start(i) = next;
    VOUSSOIR_ASSERT(next < positions.size() && positions[next].row == first + i && positions[next].column == first + i);
    for (; next < positions.size() && positions[next].row == first + i; ++next)
      column(next) = static_cast<int>(
          positions[next].column < first + unknowns_.owned
              ? positions[next].column - first
              : unknowns_.owned +
                    (std::lower_bound(others.begin(), others.end(), positions[next].column) - others.begin()));
  }
  start(unknowns_.owned) = next;
  VOUSSOIR_ASSERT(next == positions.size());
  matrix_ = Teuchos::rcp(new TpetraMatrix(rows_, map_of(columns, comm_), start, column, value_));
  matrix_->expertStaticFillComplete(rows_, rows_);
}

SharedSystem::SharedSystem(Unknowns unknowns, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                           long long most_on_first)
    : comm_(comm), unknowns_(std::move(unknowns)), most_on_first_(most_on_first) {
  VOUSSOIR_EXPECT(unknowns_.number.size() == unknowns_.owner.size());
  size_ = total_over_ranks(*comm, static_cast<long long>(unknowns_.owned));
  if (comm->getSize() > 1) sum_ = std::make_unique<Sum>(unknowns_, comm);
}

SharedSystem::~SharedSystem() = default;

void SharedSystem::factor(const LocalCsr& part) {
  if (!sum_) {
    if (alone_)
      alone_->refactor(part);
    else
      alone_ = std::make_unique<SparseCholesky>(part);
    return;
  }
  const auto& sum = sum_->of(part);
  if (size_ > most_on_first_) {
    if (!spread_) spread_ = std::make_unique<DistributedLu>(sum_->rows(), FactorsAre::spread, Symmetry::symmetric);
    if (!spread_->factor(sum)) throw std::bad_alloc();
  } else if (on_first_) {
    on_first_->refactor(sum);
  } else {
    on_first_ = std::make_unique<DirectPreconditioner>(sum, TrafficOf::block_motions);
  }
}

void SharedSystem::solve(const std::vector<double>& right, std::vector<double>& solution) const {
  VOUSSOIR_EXPECT(right.size() == unknowns_.number.size());
  if (!sum_) {
    solution.resize(right.size());
    alone_->solve(right.data(), solution.data());
    return;
  }
  TpetraVector b(sum_->rows()), x(sum_->rows());
  sum_->add_up(right, b);
  if (spread_)
    spread_->apply(b, x);
  else
    on_first_->apply(b, x);
  sum_->tell(x, solution);
}

long long SharedSystem::size() const { return size_; }

long long SharedSystem::bytes() const {
  return (alone_ ? alone_->bytes() : 0) + (sum_ ? sum_->bytes() : 0) + (on_first_ ? on_first_->bytes() : 0) +
         (spread_ ? spread_->bytes() : 0);
}

}  // namespace voussoir

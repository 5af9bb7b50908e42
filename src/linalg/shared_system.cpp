#include "linalg/shared_system.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <tuple>
#include <utility>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "linalg/local_view.hpp"
#include "linalg/reduce.hpp"
#include "linalg/solver_failure.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {
namespace {

/// Of an entry of the sum.
struct EntryOfMatrix {
  GlobalOrdinal row, column;
  friend bool operator==(const EntryOfMatrix& a, const EntryOfMatrix& b) {
    return a.row == b.row && a.column == b.column;
  }
};

Teuchos::RCP<TpetraMultiVector> columns_on(const Teuchos::RCP<const TpetraMap>& map,
                                           const std::vector<std::vector<double>>& columns) {
  auto vectors = Teuchos::rcp(new TpetraMultiVector(map, columns.size()));
  auto view = vectors->getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    VOUSSOIR_EXPECT(columns[c].size() == map->getNodeNumElements());
    for (std::size_t i = 0; i < columns[c].size(); ++i) view(i, c) = columns[c][i];
  }
  return vectors;
}

}  // namespace

/// The sum of all parts, its rows on their owners: all of it, or its upper triangle.
class SharedSystem::Sum {
 public:
  Sum(const Unknowns& unknowns, const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
      : unknowns_(unknowns), first_(unknowns.owned > 0 ? unknowns.number[0] : 0), comm_(comm) {
    const auto behind = unknowns.number.begin() + unknowns.owned;
    rows_ = map_of({unknowns.number.begin(), behind}, comm);
    local_ = map_of(unknowns.number, comm);
    import_ = Teuchos::rcp(new TpetraImport(rows_, local_));
  }
  /// Takes the pattern of the first part, and values of all.
  /// @param all  what is below the diagonal too, the same every time
  const TpetraMatrix& of(const LocalCsr& part, bool all) {
    if (matrix_.is_null()) set_pattern(part, all);
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
  /// Of this rank's rows.
  bool is_finite() const {
    double sum = 0;
    for (std::size_t e = 0; e < value_.extent(0); ++e) sum += std::abs(value_(e));
    return std::isfinite(sum);
  }
  const Teuchos::RCP<const TpetraMap>& rows() const { return rows_; }
  long long bytes() const {
    const auto entries = static_cast<long long>(value_.extent(0));
    return entries * static_cast<long long>(sizeof(double) + 2 * sizeof(int));
  }

 private:
  void set_pattern(const LocalCsr& part, bool all);
  void set_matrix(const std::vector<EntryOfMatrix>& positions);
  bool is_mine(GlobalOrdinal number) const { return number >= first_ && number < first_ + unknowns_.owned; }
  /// By rows, and in each as local columns ascend: the owned ones, then others.
  bool before(const EntryOfMatrix& a, const EntryOfMatrix& b) const {
    const bool a_of_others = !is_mine(a.column), b_of_others = !is_mine(b.column);
    return std::tie(a.row, a_of_others, a.column) < std::tie(b.row, b_of_others, b.column);
  }

  const Unknowns& unknowns_;
  GlobalOrdinal first_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  Teuchos::RCP<const TpetraMap> rows_, local_;
  Teuchos::RCP<const TpetraImport> import_;
  Teuchos::RCP<TpetraMatrix> matrix_;
  TpetraMatrix::local_matrix_host_type::values_type::non_const_type value_;
  std::vector<Parcel<int>> to_;                 ///< entries of the part that go to others
  std::vector<int> mine_, mine_place_;          ///< those that stay, and where they belong
  std::vector<std::vector<std::size_t>> from_;  ///< where those belong that come from others, by senders
};

void SharedSystem::Sum::set_pattern(const LocalCsr& part, bool all) {
  std::vector<EntryOfMatrix> positions;
  std::vector<Parcel<EntryOfMatrix>> out;
  std::vector<int> parcel_of(comm_->getSize(), -1);
  const auto give = [&](int e, int i, int j) {
    const EntryOfMatrix at{unknowns_.number[i], unknowns_.number[j]};
    const int rank = unknowns_.owner[i];
    if (rank == comm_->getRank()) {
      mine_.push_back(e);
      positions.push_back(at);
      return;
    }
    if (parcel_of[rank] < 0) {
      parcel_of[rank] = static_cast<int>(out.size());
      out.push_back({rank, {}});
      to_.push_back({rank, {}});
    }
    out[parcel_of[rank]].items.push_back(at);
    to_[parcel_of[rank]].items.push_back(e);
  };
  for (int i = 0; i < part.rows(); ++i)
    for (int e = part.start[i]; e < part.start[i + 1]; ++e) {
      const int j = part.column[e];
      const bool above = unknowns_.number[i] <= unknowns_.number[j];
      if (above || all) give(e, i, j);
      if (!above || (all && i != j)) give(e, j, i);
    }
  const auto in = exchange_parcels(std::move(out), *comm_);
  auto found = positions;
  for (const auto& parcel : in) found.insert(found.end(), parcel.items.begin(), parcel.items.end());
  const auto ascend = [this](const EntryOfMatrix& a, const EntryOfMatrix& b) { return before(a, b); };
  std::sort(found.begin(), found.end(), ascend);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  const auto place = [&](const EntryOfMatrix& at) {
    return static_cast<std::size_t>(std::lower_bound(found.begin(), found.end(), at, ascend) - found.begin());
  };
  for (const auto& at : positions) mine_place_.push_back(static_cast<int>(place(at)));
  for (const auto& parcel : in) {
    from_.emplace_back();
    for (const auto& at : parcel.items) from_.back().push_back(place(at));
  }
  set_matrix(found);
}

void SharedSystem::Sum::set_matrix(const std::vector<EntryOfMatrix>& positions) {
  std::vector<GlobalOrdinal> columns(unknowns_.number.begin(), unknowns_.number.begin() + unknowns_.owned), others;
  for (const auto& at : positions)
    if (!is_mine(at.column)) others.push_back(at.column);
  sort_unique(others);
  columns.insert(columns.end(), others.begin(), others.end());
  TpetraMatrix::local_matrix_host_type::row_map_type::non_const_type start("start", unknowns_.owned + 1);
  TpetraMatrix::local_matrix_host_type::index_type::non_const_type column("column", positions.size());
  value_ = decltype(value_)("value", positions.size());
  std::size_t next = 0;
  for (int i = 0; i < unknowns_.owned; ++i) {
    start(i) = next;
    for (; next < positions.size() && positions[next].row == first_ + i; ++next) {
      const auto at = positions[next].column;
      const auto other = std::lower_bound(others.begin(), others.end(), at) - others.begin();
      column(next) = static_cast<int>(is_mine(at) ? at - first_ : unknowns_.owned + other);
    }
    VOUSSOIR_ASSERT(next > start(i));
  }
  start(unknowns_.owned) = next;
  VOUSSOIR_ASSERT(next == positions.size());
  matrix_ = Teuchos::rcp(new TpetraMatrix(rows_, map_of(columns, comm_), start, column, value_));
  matrix_->expertStaticFillComplete(rows_, rows_);
}

SharedSystem::SharedSystem(Unknowns unknowns, const Bodies& bodies, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                           const SharedSystemParameters& numbers)
    : comm_(comm), unknowns_(std::move(unknowns)), numbers_(numbers) {
  VOUSSOIR_EXPECT(unknowns_.number.size() == unknowns_.owner.size());
  size_ = total_over_ranks(*comm, static_cast<long long>(unknowns_.owned));
  if (comm->getSize() == 1 && !numbers_.levels_on_one_rank) return;
  sum_ = std::make_unique<Sum>(unknowns_, comm);
  bodies_.of_a_body = bodies.of_a_body;
  if (!may_have_levels()) return;
  std::vector<GlobalOrdinal> numbers_of_bodies;
  for (int i = 0; i < unknowns_.owned; i += bodies.of_a_body)
    numbers_of_bodies.push_back(unknowns_.number[i] / bodies.of_a_body);
  bodies_.near_null = columns_on(sum_->rows(), bodies.rigid);
  bodies_.coordinates = columns_on(map_of(numbers_of_bodies, comm), bodies.place);
}

SharedSystem::~SharedSystem() = default;

bool SharedSystem::may_have_levels() const {
  return bodies_.of_a_body > 0 && size_ > std::max<long long>(numbers_.most_on_first, numbers_.levels.coarsest);
}

SolvedBy SharedSystem::factor(const LocalCsr& part) {
  if (!sum_) {
    if (alone_)
      alone_->refactor(part);
    else
      alone_ = std::make_unique<SparseCholesky>(part);
    return SolvedBy::factors;
  }
  const auto& sum = sum_->of(part, may_have_levels());
  if (any_of_ranks(*comm_, !sum_->is_finite()))
    throw SolverFailure("the matrix of all parts holds numbers that are none");
  if (may_have_levels() && build_levels(sum)) return SolvedBy::levels;
  factor_directly(sum);
  return may_have_levels() ? SolvedBy::factors_for_levels : SolvedBy::factors;
}

/// Whether they converge.
bool SharedSystem::build_levels(const TpetraMatrix& sum) {
  levels_ = std::make_unique<BodyLevels>(sum, bodies_, numbers_.levels);
  if (levels_->converges()) {
    on_first_.reset();
    spread_.reset();
    return true;
  }
  levels_.reset();
  return false;
}

void SharedSystem::factor_directly(const TpetraMatrix& sum) {
  if (size_ > numbers_.most_on_first) {
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
  if (levels_)
    levels_->apply(b, x);
  else if (spread_)
    spread_->apply(b, x);
  else
    on_first_->apply(b, x);
  sum_->tell(x, solution);
}

std::vector<MultigridLevel> SharedSystem::levels() const {
  return levels_ ? levels_->levels() : std::vector<MultigridLevel>();
}

long long SharedSystem::bytes() const {
  return (alone_ ? alone_->bytes() : 0) + (sum_ ? sum_->bytes() : 0) + (levels_ ? levels_->bytes() : 0) +
         (on_first_ ? on_first_->bytes() : 0) + (spread_ ? spread_->bytes() : 0);
}

}  // namespace voussoir

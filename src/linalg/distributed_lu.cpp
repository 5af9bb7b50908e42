#include "linalg/distributed_lu.hpp"

#include <dmumps_c.h>

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>
#include <vector>

#include "base/check.hpp"
#include "linalg/local_view.hpp"
#include "linalg/mpi_handle.hpp"
#include "linalg/parcels.hpp"
#include "linalg/solver_failure.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {
namespace {

// Names that MUMPS gives to numbers (its users' guide, sections 3, 6 and 8).
enum Job { start = -1, end = -2, analyse = 1, factorise = 2, solve = 3 };
enum Control {
  errors_to = 1,
  diagnostics_to = 2,
  global_to = 3,
  printing = 4,
  permute_columns = 6,
  root_alone = 13,
  more_room_in_percent = 14,
  entries_are = 18,
  right_side_is = 20,
  solution_is = 21,
  find_null_pivots = 24
};
constexpr int nowhere = -1, distributed = 3, on_host = 0, right_side_distributed = 10, solution_distributed = 1;
constexpr int any_matrix = 0, symmetric_matrix = 2;
enum Failure {
  no_room_to_order = -7,
  factors_too_small = -8,
  work_too_small = -9,
  no_room = -13,
  reserved_too_small = -19
};

// MUMPS guesses the room that pivots off the diagonal take. Where it was not enough: as much again, and so on.
constexpr int first_guess = 30, largest_guess = 2000;

bool too_small(int status) { return status == factors_too_small || status == work_too_small; }

bool lacks_memory(int status) {
  return status == no_room || status == no_room_to_order || status == reserved_too_small || too_small(status);
}

int& control(DMUMPS_STRUC_C& m, int which) { return m.icntl[which - 1]; }

/// Rows by numbers of a rank's own.
}  // namespace

struct DistributedLu::Data {
  Teuchos::RCP<const TpetraMap> map;
  mutable DMUMPS_STRUC_C mumps{};
  const bool symmetric;
  int first = 0;                       ///< number of the first owned row, rank by rank
  Teuchos::RCP<const TpetraMap> rows;  ///< the owned ones by these numbers
  std::vector<int> row,
      column;  ///< of every entry that is given to MUMPS, counted from 1; empty before the pattern is known
  std::vector<char> upper;              ///< of owned entries: not below the diagonal; empty where all are given
  bool known = false, ordered = false;  ///< the pattern is, on all ranks
  const bool alone;                     ///< the first rank factors, of several
  const bool spread;                    ///< several do
  /// From the rows whose solution MUMPS leaves on this rank, or all on the first, to the owned ones.
  mutable Teuchos::RCP<const TpetraImport> to_owners;

  Data(const Teuchos::RCP<const TpetraMap>& m, FactorsAre factors, Symmetry s)
      : map(m),
        symmetric(s == Symmetry::symmetric),
        alone(factors == FactorsAre::on_first_rank && m->getComm()->getSize() > 1),
        spread(!alone && m->getComm()->getSize() > 1) {
    mumps.par = 1;
    mumps.sym = symmetric ? symmetric_matrix : any_matrix;
    mumps.comm_fortran = MPI_Comm_c2f(alone ? MPI_COMM_SELF : mpi_handle(*map->getComm()));
    if (const int status = run(start); status < 0) throw solver_failure("MUMPS", "start", status);
    for (const int out : {errors_to, diagnostics_to, global_to}) control(mumps, out) = nowhere;
    control(mumps, printing) = 0;
    control(mumps, entries_are) = alone ? on_host : distributed;
    control(mumps, permute_columns) = 0;  // that would look at values, which change
    control(mumps, find_null_pivots) = 1;
    control(mumps, root_alone) = 1;  // or null pivots there are not found
    control(mumps, more_room_in_percent) = first_guess;
    number_rows();
    if (!spread) return;
    control(mumps, right_side_is) = right_side_distributed;
    control(mumps, solution_is) = solution_distributed;
  }
  ~Data() {
    if (works()) call(end);
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;

  /// Returns what MUMPS says of all ranks, the same on each: negative where it failed.
  int run(Job job) const {
    int status = works() ? call(job) : 0;
    if (alone) Teuchos::broadcast(*map->getComm(), 0, &status);
    return status;
  }
  bool works() const { return !alone || map->getComm()->getRank() == 0; }
  int call(Job job) const {
    mumps.job = job;
    dmumps_c(&mumps);
    return mumps.infog[0];
  }
  /// Of the owned entries, or of all on the first rank where it factors alone.
  template <class T>
  std::vector<T> entries(std::vector<T> mine) const {
    return alone ? gather_on_first(mine, *map->getComm()) : std::move(mine);
  }
  std::vector<double> values(const TpetraMatrix& a) const;
  void number_rows();
  void set_pattern(const TpetraMatrix& a);
  int order(const TpetraMatrix& a);
  void bring_to_owners(const double* solution, TpetraVector& z) const;
  int solve_alone(const double* right, TpetraVector& z) const;
  int solve_spread(const double* right, TpetraVector& z) const;
};

/// Rank by rank: global numbers may have gaps, those of MUMPS have none.
void DistributedLu::Data::number_rows() {
  const int owned = static_cast<int>(map->getNodeNumElements());
  int until = 0;
  Teuchos::scan(*map->getComm(), Teuchos::REDUCE_SUM, owned, Teuchos::outArg(until));
  first = until - owned;
  std::vector<GlobalOrdinal> numbers(owned);
  std::iota(numbers.begin(), numbers.end(), first);
  rows = map_of(numbers, map->getComm());
}

void DistributedLu::Data::set_pattern(const TpetraMatrix& a) {
  const int owned = static_cast<int>(map->getNodeNumElements());
  TpetraVector mine(map), all(a.getColMap());
  for (int i = 0; i < owned; ++i) local_view_to_write(mine)[i] = first + i;
  const auto import = a.getGraph()->getImporter();
  if (import.is_null())
    Tpetra::deep_copy(all, mine);
  else
    all.doImport(mine, *import, Tpetra::INSERT);
  const double* number = local_view(all);
  const auto local = a.getLocalMatrixHost();
  for (int i = 0; i < owned; ++i) {
    const auto entries = local.rowConst(i);
    for (int e = 0; e < entries.length; ++e) {
      const auto other = static_cast<int>(number[entries.colidx(e)]);
      if (symmetric) upper.push_back(other >= first + i);
      if (symmetric && !upper.back()) continue;
      row.push_back(first + i + 1);
      column.push_back(other + 1);
    }
  }
  row = entries(std::move(row));
  column = entries(std::move(column));
  mumps.n = static_cast<int>(map->getGlobalNumElements());
  mumps.nnz = mumps.nnz_loc = static_cast<MUMPS_INT8>(row.size());
  mumps.irn = mumps.irn_loc = row.data();
  mumps.jcn = mumps.jcn_loc = column.data();
  known = true;
}

/// Of the entries that MUMPS is given.
std::vector<double> DistributedLu::Data::values(const TpetraMatrix& a) const {
  const auto local = a.getLocalMatrixHost().values;
  const auto count = local.extent(0);
  if (!symmetric) return entries(std::vector<double>(local.data(), local.data() + count));
  std::vector<double> list;
  for (std::size_t e = 0; e < count; ++e)
    if (upper[e]) list.push_back(local(e));
  return entries(std::move(list));
}

/// Of the first matrix; returns what MUMPS says.
int DistributedLu::Data::order(const TpetraMatrix& a) {
  if (!known) set_pattern(a);
  const int status = ordered ? 0 : run(analyse);
  ordered = status >= 0;
  return status;
}

/// @param solution  of the rows that MUMPS has left here
void DistributedLu::Data::bring_to_owners(const double* solution, TpetraVector& z) const {
  TpetraVector here(to_owners->getSourceMap()), owned(rows);
  std::copy_n(solution, here.getLocalLength(), local_view_to_write(here));
  owned.doImport(here, *to_owners, Tpetra::INSERT);
  std::copy_n(local_view(owned), owned.getLocalLength(), local_view_to_write(z));
}

/// Returns what MUMPS says. Collective.
int DistributedLu::Data::solve_alone(const double* right, TpetraVector& z) const {
  if (!alone) {
    std::copy_n(right, mumps.n, local_view_to_write(z));
    mumps.rhs = local_view_to_write(z);
    return run(solve);
  }
  if (to_owners.is_null()) {
    std::vector<GlobalOrdinal> all(works() ? mumps.n : 0);
    std::iota(all.begin(), all.end(), 0);
    to_owners = Teuchos::rcp(new TpetraImport(map_of(all, map->getComm()), rows));
  }
  TpetraVector whole(to_owners->getSourceMap()), owned(rows);
  std::copy_n(right, owned.getLocalLength(), local_view_to_write(owned));
  whole.doExport(owned, *to_owners, Tpetra::INSERT);
  mumps.rhs = local_view_to_write(whole);
  const int status = run(solve);
  bring_to_owners(local_view(whole), z);
  return status;
}

/// Every rank gives the right side of its rows, and gets the solution of those whose pivots it has.
int DistributedLu::Data::solve_spread(const double* right, TpetraVector& z) const {
  constexpr int rows_left_here = 23;
  std::vector<double> owned(right, right + rows->getNodeNumElements());
  std::vector<int> numbers(owned.size());
  std::iota(numbers.begin(), numbers.end(), first + 1);
  mumps.nloc_rhs = mumps.lrhs_loc = static_cast<int>(owned.size());
  mumps.rhs_loc = owned.data();
  mumps.irhs_loc = numbers.data();
  mumps.nrhs = 1;
  const int here = std::max(mumps.info[rows_left_here - 1], 0);
  std::vector<double> solution(std::max(here, 1));
  std::vector<int> row_of(std::max(here, 1));
  mumps.lsol_loc = static_cast<int>(solution.size());
  mumps.sol_loc = solution.data();
  mumps.isol_loc = row_of.data();
  const int status = run(solve);
  if (status < 0) return status;
  if (to_owners.is_null()) {
    std::vector<GlobalOrdinal> left;
    for (int k = 0; k < here; ++k) left.push_back(row_of[k] - 1);
    to_owners = Teuchos::rcp(new TpetraImport(map_of(left, map->getComm()), rows));
  }
  bring_to_owners(solution.data(), z);
  return status;
}

DistributedLu::DistributedLu(const Teuchos::RCP<const TpetraMap>& map, FactorsAre factors, Symmetry symmetry)
    : data_(std::make_unique<Data>(map, factors, symmetry)) {}
DistributedLu::~DistributedLu() = default;

bool DistributedLu::factor(const TpetraMatrix& a) {
  auto& d = *data_;
  int status = d.order(a);
  auto value = d.values(a);
  if (d.spread) d.to_owners = Teuchos::null;  // pivots may come to lie on others
  VOUSSOIR_EXPECT(value.size() == d.row.size());
  d.mumps.a = d.mumps.a_loc = value.data();
  while (status >= 0) {
    status = d.run(factorise);
    int& guess = control(d.mumps, more_room_in_percent);
    if (!too_small(status) || guess > largest_guess) break;
    guess *= 2;
    status = 0;
  }
  if (status < 0 && !lacks_memory(status)) throw solver_failure("MUMPS", "factor a matrix", status);
  return status >= 0;
}

DistributedLu::Expected DistributedLu::expected(const TpetraMatrix& a) {
  constexpr int entries = 20, operations = 1, in_millions = -1000000;
  auto& d = *data_;
  const int status = d.order(a);
  if (status < 0 && !lacks_memory(status)) throw solver_failure("MUMPS", "order a matrix", status);
  if (status < 0) return {std::numeric_limits<double>::infinity(), 0};
  const double held = d.mumps.infog[entries - 1];
  std::array<double, 2> all{(held < 0 ? in_millions * held : held) * sizeof(double), d.mumps.rinfog[operations - 1]};
  if (d.alone) Teuchos::broadcast(*d.map->getComm(), 0, 2, all.data());
  return {all[0], all[1]};
}

void DistributedLu::apply(const TpetraVector& r, TpetraVector& z) const {
  const auto& d = *data_;
  const TrafficScope sent_for(TrafficOf::block_motions);
  const double* right = local_view(r);
  const int status = d.spread ? d.solve_spread(right, z) : d.solve_alone(right, z);
  if (status < 0 && lacks_memory(status)) throw std::bad_alloc();
  if (status < 0) throw solver_failure("MUMPS", "solve with its factors", status);
}

long long DistributedLu::bytes() const {
  constexpr int megabytes_worked_in = 22;
  return 1000000LL * data_->mumps.info[megabytes_worked_in - 1] +
         static_cast<long long>((data_->row.size() + data_->column.size()) * sizeof(int));
}

}  // namespace voussoir

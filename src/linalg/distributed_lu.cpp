#include "linalg/distributed_lu.hpp"

#include <dmumps_c.h>

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

#include "base/check.hpp"
#include "linalg/gather.hpp"
#include "linalg/local_view.hpp"
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
  find_null_pivots = 24
};
constexpr int nowhere = -1, distributed = 3, on_host = 0;
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

MPI_Fint handle_of(const Teuchos::Comm<int>& comm) {
  const auto* mpi = dynamic_cast<const Teuchos::MpiComm<int>*>(&comm);
  return MPI_Comm_c2f(mpi ? (*mpi->getRawMpiComm())() : MPI_COMM_SELF);
}

}  // namespace

struct DistributedLu::Data {
  Teuchos::RCP<const TpetraMap> map;
  mutable DMUMPS_STRUC_C mumps{};
  int first = 0;  ///< number of the first owned row, rank by rank
  std::vector<int> row,
      column;  ///< of every entry that is given to MUMPS, counted from 1; empty before the pattern is known
  bool known = false, ordered = false;  ///< the pattern is, on all ranks
  const bool alone;                     ///< the first rank factors, of several

  Data(const Teuchos::RCP<const TpetraMap>& m, FactorsAre factors)
      : map(m), alone(factors == FactorsAre::on_first_rank && m->getComm()->getSize() > 1) {
    mumps.par = 1;
    mumps.sym = 0;
    mumps.comm_fortran = alone ? MPI_Comm_c2f(MPI_COMM_SELF) : handle_of(*map->getComm());
    if (const int status = run(start); status < 0) throw solver_failure("MUMPS", "start", status);
    for (const int out : {errors_to, diagnostics_to, global_to}) control(mumps, out) = nowhere;
    control(mumps, printing) = 0;
    control(mumps, entries_are) = alone ? on_host : distributed;
    control(mumps, permute_columns) = 0;  // that would look at values, which change
    control(mumps, find_null_pivots) = 1;
    control(mumps, root_alone) = 1;  // or null pivots there are not found
    control(mumps, more_room_in_percent) = first_guess;
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
  /// Of the owned entries, or of all where one rank factors alone.
  template <class T>
  std::vector<T> entries(std::vector<T> mine) const {
    return alone ? all_gather(mine, *map->getComm()) : std::move(mine);
  }
  void set_pattern(const TpetraMatrix& a);
  int order(const TpetraMatrix& a);
};

void DistributedLu::Data::set_pattern(const TpetraMatrix& a) {
  const auto& comm = *map->getComm();
  const int owned = static_cast<int>(map->getNodeNumElements());
  int until = 0;
  Teuchos::scan(comm, Teuchos::REDUCE_SUM, owned, Teuchos::outArg(until));
  first = until - owned;
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
      row.push_back(first + i + 1);
      column.push_back(static_cast<int>(number[entries.colidx(e)]) + 1);
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

/// Of the first matrix; returns what MUMPS says.
int DistributedLu::Data::order(const TpetraMatrix& a) {
  if (!known) set_pattern(a);
  const int status = ordered ? 0 : run(analyse);
  ordered = status >= 0;
  return status;
}

DistributedLu::DistributedLu(const Teuchos::RCP<const TpetraMap>& map, FactorsAre factors)
    : data_(std::make_unique<Data>(map, factors)) {}
DistributedLu::~DistributedLu() = default;

bool DistributedLu::factor(const TpetraMatrix& a) {
  auto& d = *data_;
  int status = d.order(a);
  const auto local = a.getLocalMatrixHost();
  auto value = d.entries(std::vector<double>(local.values.data(), local.values.data() + local.values.extent(0)));
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
  const auto& comm = *d.map->getComm();
  const auto owned = d.map->getNodeNumElements();
  const double* value = local_view(r);
  auto whole = all_gather(std::vector<double>(value, value + owned), comm);
  d.mumps.rhs = whole.data();  // read and written on the first rank
  const int status = d.run(solve);
  if (status < 0 && lacks_memory(status)) throw std::bad_alloc();
  if (status < 0) throw solver_failure("MUMPS", "solve with its factors", status);
  Teuchos::broadcast(comm, 0, d.mumps.n, whole.data());
  std::copy_n(whole.begin() + d.first, owned, local_view_to_write(z));
}

long long DistributedLu::bytes() const {
  constexpr int megabytes_worked_in = 22;
  return 1000000LL * data_->mumps.info[megabytes_worked_in - 1] +
         static_cast<long long>((data_->row.size() + data_->column.size()) * sizeof(int));
}

}  // namespace voussoir

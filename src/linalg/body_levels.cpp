#include "linalg/body_levels.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/digest.hpp"
#include "linalg/local_view.hpp"

namespace voussoir {
namespace {

/// Levels of MueLu, below the finest, which is smoothed here.
constexpr int last_level = 9;
/// Share of the energy of the error below which the rest is round-off.
constexpr double solved = 1e-20;

Teuchos::RCP<TpetraMatrix> shifted(const TpetraMatrix& a, double share) {
  auto copy = Teuchos::rcp(new TpetraMatrix(a, Teuchos::Copy));
  TpetraVector diagonal(a.getRowMap());
  a.getLocalDiagCopy(diagonal);
  const double shift = share * diagonal.normInf();
  copy->resumeFill();
  for (int i = 0; i < static_cast<int>(a.getNodeNumRows()); ++i)
    copy->sumIntoLocalValues(i, Teuchos::tuple<LocalOrdinal>(i), Teuchos::tuple<double>(shift));
  copy->fillComplete(a.getDomainMap(), a.getRangeMap());
  return copy;
}

Teuchos::ParameterList groups_of(const BodyMotions& bodies, const BodyLevelsParameters& numbers, bool many_ranks) {
  Teuchos::ParameterList list;
  list.set("number of equations", bodies.of_a_body);
  list.set("coarse: max size", numbers.coarsest);
  list.set("aggregation: drop tol", numbers.coupled);
  list.set("smoother: pre or post", "none");
  list.set("multigrid algorithm", "sa");  // levels are built anew with every change of status
  if (many_ranks) list.set("repartition: min rows per proc", numbers.least_of_a_rank);
  for (int l = 1; l <= last_level; ++l) {
    auto& level = list.sublist("level " + std::to_string(l));
    level.set("smoother: pre or post", "both");
    smooth_by_gauss_seidel(level, 1);
  }
  return list;
}

/// Between -1/2 and 1/2, the same for an unknown on any number of ranks.
double noise(GlobalOrdinal number) {
  const auto bits = digest(&number, sizeof number) * 0xff51afd7ed558ccdull;
  return static_cast<double>(bits >> 11) / 9007199254740992.0 - 0.5;  // 2^53
}

/// Of a symmetric tridiagonal matrix; both not a number where LAPACK fails.
Eigenvalues extremes(std::vector<double> diagonal, std::vector<double> beside) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const int n = static_cast<int>(diagonal.size());
  if (n == 0) return {none, none};
  int info = 0;
  std::vector<double> work(2 * n);
  Teuchos::LAPACK<int, double>().STEQR('N', n, diagonal.data(), beside.data(), nullptr, 1, work.data(), &info);
  if (info != 0) return {none, none};
  return {diagonal.front(), diagonal.back()};
}

}  // namespace

BodyLevels::BodyLevels(const TpetraMatrix& a, const BodyMotions& bodies, const BodyLevelsParameters& numbers)
    : numbers_(numbers),
      a_(shifted(a, numbers.shift)),
      smoother_(std::make_unique<IncompleteCholesky>(*a_)),
      groups_(std::make_unique<AmgPreconditioner>(
          a_, bodies.coordinates, bodies.near_null, static_cast<int>(bodies.coordinates->getNumVectors()),
          groups_of(bodies, numbers, a.getComm()->getSize() > 1), TrafficOf::block_motions)),
      left_(a_->getRowMap()),
      correction_(a_->getRowMap()) {
  measure();
}

void BodyLevels::apply(const TpetraVector& r, TpetraVector& z) const {
  const auto leave = [&] {
    a_->apply(z, left_);
    left_.update(1.0, r, -1.0);
  };
  smoother_->solve(local_view(r), local_view_to_write(z));
  leave();
  groups_->apply(left_, correction_);
  z.update(1.0, correction_, 1.0);
  leave();
  smoother_->solve(local_view(left_), local_view_to_write(correction_));
  z.update(1.0, correction_, 1.0);
}

/// Conjugate gradients from an error of all lengths; what they go by is Lanczos's matrix.
void BodyLevels::measure() {
  TpetraVector x(a_->getRowMap()), r(a_->getRowMap()), z(a_->getRowMap()), p(a_->getRowMap()), ap(a_->getRowMap());
  double* start = local_view_to_write(x);
  for (int i = 0; i < static_cast<int>(x.getLocalLength()); ++i) start[i] = noise(a_->getRowMap()->getGlobalElement(i));
  a_->apply(x, r);
  std::vector<double> diagonal, beside;
  double along = 0, before = 0, alpha = 0, first = 0;
  for (int step = 0; step < numbers_.steps; ++step) {
    apply(r, z);
    before = along;
    along = r.dot(z);
    const double beta = step == 0 ? 0.0 : along / before;
    p.update(1.0, z, beta);
    a_->apply(p, ap);
    const double curvature = p.dot(ap);
    if (step == 0) first = along;
    if (step > 0 && std::abs(along) <= solved * first) break;
    if (!(along > 0) || !(curvature > 0)) {
      eigenvalues_ = extremes({}, {});
      return;
    }
    if (step > 0) beside.push_back(std::sqrt(beta) / alpha);
    const double coupled = step == 0 ? 0.0 : beta / alpha;
    alpha = along / curvature;
    diagonal.push_back(1 / alpha + coupled);
    r.update(-alpha, ap, 1.0);
  }
  beside.resize(diagonal.size());
  eigenvalues_ = extremes(diagonal, beside);
}

bool BodyLevels::converges() const {
  return eigenvalues_.smallest >= numbers_.least_eigenvalue && eigenvalues_.largest <= numbers_.largest_eigenvalue;
}

long long BodyLevels::bytes() const {
  const auto entries = static_cast<long long>(a_->getNodeNumEntries());
  return smoother_->bytes() + entries * static_cast<long long>(sizeof(double) + sizeof(int));
}

}  // namespace voussoir

#include "nonlinear/patch.hpp"

#include <Teuchos_DefaultSerialComm.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "linalg/local_view.hpp"
#include "linalg/solver_failure.hpp"
#include "nonlinear/active_set.hpp"
#include "nonlinear/interior_path.hpp"
#include "nonlinear/point_update.hpp"

namespace voussoir {

Vector<3> PatchPoint::motion(const double* displacement) const {
  Vector<3> sum{};
  for (int a = 0; a < 3; ++a)
    for (const auto& s : shares) sum[a] += share(s, a) * displacement[s.unknown];
  return sum;
}

double PatchPoint::force_on(const PatchShare& s, const double* of_point, int components) const {
  double sum = 0;
  for (int a = 0; a < components; ++a) sum += share(s, a) * of_point[a];
  return sum;
}

Patch::Patch(PatchParts parts, const MethodParameters& methods)
    : parts_(std::move(parts)), methods_(methods), selected_(parts_.points.size(), 1), law_(parts_.points.size()) {
  const int n = static_cast<int>(parts_.imbalance.size());
  map_ = Teuchos::rcp(new TpetraMap(n, n, 0, Teuchos::rcp(new Teuchos::SerialComm<int>())));
  for (std::size_t k = 0; k < parts_.points.size(); ++k) {
    const auto& p = parts_.points[k];
    law_.set(k, p.law);
    local_stiffness_.push_back(p.local_stiffness);
    compliance_.push_back(p.compliance);
    slip_origin_.insert(slip_origin_.end(), p.slip_origin.begin(), p.slip_origin.begin() + parts_.components);
  }
  set_pattern();
  for (const auto& e : parts_.stiffness) entry(stiffness_, e.row, e.column) += e.value;
  for (const auto& p : parts_.border) {
    add(p, p.resistance, stiffness_);
    for (const auto& s : p.shares) parts_.imbalance[s.unknown] -= p.force_on(s, p.force.data(), parts_.components);
  }
}

void Patch::set_pattern() {
  std::vector<std::pair<int, int>> places;
  for (const auto& e : parts_.stiffness) places.emplace_back(e.row, e.column);
  for (int i = 0; i < static_cast<int>(parts_.imbalance.size()); ++i) places.emplace_back(i, i);
  for (const auto* points : {&parts_.points, &parts_.border})
    for (const auto& p : *points)
      for (const auto& row : p.shares)
        for (const auto& column : p.shares) places.emplace_back(row.unknown, column.unknown);
  sort_unique(places);
  stiffness_.start.assign(parts_.imbalance.size() + 1, 0);
  for (const auto& [row, column] : places) {
    ++stiffness_.start[row + 1];
    stiffness_.column.push_back(column);
  }
  for (std::size_t i = 0; i < parts_.imbalance.size(); ++i) stiffness_.start[i + 1] += stiffness_.start[i];
  stiffness_.value.assign(places.size(), 0.0);
}

double& Patch::entry(LocalCsr& a, int row, int column) const {
  const auto first = a.column.begin() + a.start[row], last = a.column.begin() + a.start[row + 1];
  const auto found = std::lower_bound(first, last, column);
  VOUSSOIR_EXPECT(found != last && *found == column);
  return a.value[found - a.column.begin()];
}

/// B^T D B of one point.
void Patch::add(const PatchPoint& p, const PointStiffness& d, LocalCsr& to) const {
  for (const auto& row : p.shares)
    for (const auto& column : p.shares) {
      Vector<3> motion{}, force{};
      for (int a = 0; a < parts_.components; ++a) motion[a] = p.share(column, a);
      d.yield(motion.data(), parts_.components, force.data());
      entry(to, row.unknown, column.unknown) -= p.force_on(row, force.data(), parts_.components);
    }
}

void Patch::evaluate(const TpetraVector& x, TpetraVector& r, PointField& gap) {
  evaluate_direction(x, r, gap);
  double* imbalance = local_view_to_write(r);
  for (std::size_t i = 0; i < parts_.imbalance.size(); ++i) imbalance[i] += parts_.imbalance[i];
  const auto n = static_cast<std::size_t>(parts_.components);
  for (std::size_t i = 0; i < gap.size(); ++i) gap[i] += parts_.points[i / n].gap[i % n];
}

void Patch::evaluate_direction(const TpetraVector& d, TpetraVector& y, PointField& gap) {
  const double* displacement = local_view(d);
  stiffness_.multiply(displacement, local_view_to_write(y));
  gap.clear();
  for (const auto& p : parts_.points) {
    const auto motion = p.motion(displacement);
    gap.insert(gap.end(), motion.begin(), motion.begin() + parts_.components);
  }
}

void Patch::subtract_contact_forces(const PointField& lambda, TpetraVector& r) {
  double* value = local_view_to_write(r);
  for (std::size_t k = 0; k < parts_.points.size(); ++k) {
    const auto& p = parts_.points[k];
    for (const auto& s : p.shares) value[s.unknown] -= p.force_on(s, &lambda[k * parts_.components], parts_.components);
  }
}

LinearSolveResult Patch::solve(const std::vector<PointStiffness>& stiffness, double proximal_scale,
                               const Teuchos::RCP<TpetraVector>& b, const Teuchos::RCP<TpetraVector>& d,
                               const SolveRequest&) {
  LocalCsr h = stiffness_;
  for (int i = 0; i < h.rows(); ++i) entry(h, i, i) += proximal_scale * parts_.proximal_weight[i];
  for (std::size_t k = 0; k < parts_.points.size(); ++k) add(parts_.points[k], stiffness[k], h);
  // A patch is one rank's alone: what fails here the other ranks hear when they count patches.
  try {
    if (factor_.factor(h) && factor_.solve(h, local_view(*b), local_view_to_write(*d))) return {1, true, "", false};
  } catch (const SolverFailure& failure) {
    return not_solved(failure.what());
  }
  d->putScalar(0);
  return not_solved("UMFPACK found the matrix of a patch singular");
}

/// By active sets, or else along the interior path.
bool Patch::come_to_rest(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport& report) {
  const TpetraVector start(x, Teuchos::Copy);
  PointField forces = lambda;
  const auto& numbers = methods_.patches;
  ActiveSet active(*this, ActiveSetUse::in_patch, methods_, numbers.patience);
  // A stone out of balance by the rest flies in the next solve of the whole.
  active.solve(x, forces, numbers.block_threshold * tolerance, numbers.most_solves, nullptr, report);
  if (std::max(report.residual, report.complementarity) <= tolerance) {
    lambda = forces;
    return true;
  }
  if (!methods_.path.used) return false;
  Tpetra::deep_copy(x, start);
  InteriorPath path(*this, methods_);
  return path.trace(x, lambda, tolerance, numbers.most_solves, nullptr, report) == PathEnd::arrived;
}

bool Patch::solve(double tolerance, NewtonReport& report) {
  TpetraVector x(map_);
  std::copy(parts_.start.begin(), parts_.start.end(), local_view_to_write(x));
  PointField lambda;
  const auto n = static_cast<std::size_t>(parts_.components);
  for (const auto& p : parts_.points) lambda.insert(lambda.end(), p.force.begin(), p.force.begin() + parts_.components);
  if (!come_to_rest(x, lambda, tolerance, report)) return false;
  const double* moved = local_view(x);
  displacement_.assign(moved, moved + parts_.imbalance.size());
  for (std::size_t i = 0; i < lambda.size(); ++i) parts_.points[i / n].force[i % n] = lambda[i];
  yield_at_the_border();
  return true;
}

void Patch::yield_at_the_border() {
  for (auto& p : parts_.border) {
    const auto motion = p.motion(displacement_.data());
    const auto before = p.force;
    p.resistance.yield(motion.data(), parts_.components, p.force.data());
    for (int c = 0; c < parts_.components; ++c) passed_on_ = std::max(passed_on_, std::abs(p.force[c] - before[c]));
  }
}

}  // namespace voussoir

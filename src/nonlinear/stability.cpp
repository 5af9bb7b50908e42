#include "nonlinear/stability.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/orthogonal.hpp"
#include "linalg/reduce.hpp"
#include "nonlinear/point_tangents.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"

namespace voussoir {
namespace {

using Numbers = StabilityParameters;
/// Softening points in the place of unknowns: their motions times the root of what they soften by.
class Share {
 public:
  Share(NonlinearProblem& problem, std::vector<PointTangent> all, NewtonReport& report)
      : problem_(problem),
        components_(problem.components()),
        tangents_(std::move(all)),
        report_(report),
        motion_(Teuchos::rcp(new TpetraVector(problem.map()))) {
    for (const auto& t : tangents_) resistance_.push_back(t.resistance);
  }

  /// How many of them any rank has.
  long long size() const {
    long long mine = 0;
    for (int k = 0; k < problem_.owned_points(); ++k) mine += tangents_[k].softens ? 2 : 0;
    return total_over_ranks(*problem_.map()->getComm(), mine);
  }
  /// A start that is alike on any ranks, and nothing that is symmetric.
  PointField start() const {
    const auto n = components_;
    PointField y(n * tangents_.size(), 0.0);
    for (int k = 0; k < problem_.points(); ++k)
      for (int c = 0; c < n; ++c) {
        double whole;
        y[at(k) + c] =
            0.5 + std::modf(0.618033988749895 * static_cast<double>(n * problem_.number_of(k) + c + 1), &whole);
      }
    return rooted(y);
  }
  /// A field of the points of a joint that soften, and 0 elsewhere.
  PointField in_joint(int joint, const PointField& all) const {
    PointField some(all.size(), 0.0);
    for (int k = 0; k < problem_.points(); ++k)
      if (tangents_[k].softens && problem_.joint_of(k) == joint) std::copy_n(&all[at(k)], components_, &some[at(k)]);
    return some;
  }
  double dot(const PointField& a, const PointField& b) const {
    double mine = 0;
    for (int i = 0; i < components_ * problem_.owned_points(); ++i) mine += a[i] * b[i];
    return total_over_ranks(*problem_.map()->getComm(), mine);
  }
  /// Root of softening times what is given per point.
  PointField rooted(const PointField& g) const {
    PointField y(g.size(), 0.0);
    for (std::size_t k = 0; k < tangents_.size(); ++k) {
      const auto& [resistance, h, softens, along, onward] = tangents_[k];
      if (!softens) continue;
      const auto first = at(k);
      const double slip = component(along, &g[first + 1], components_ - 1);
      y[first] = h[0] * g[first] + h[1] * slip;
      const double shear = h[1] * g[first] + h[2] * slip;
      for (int t = 0; t + 1 < components_; ++t) y[first + t + 1] = along[t] * shear;
    }
    return y;
  }
  /// h^1/2 B A^-1 B^T h^1/2 y. Leaves the motion and its gaps. False where a library refused the system.
  bool apply(const PointField& y, PointField& result) {
    const auto b = Teuchos::rcp(new TpetraVector(problem_.map()));
    PointField force = rooted(y);
    for (auto& f : force) f = -f;
    problem_.subtract_contact_forces(force, *b);
    motion_->putScalar(0);
    const auto solved = problem_.solve(resistance_, 1.0, b, motion_, {Numbers::solve_accuracy});
    report_.count(solved);
    if (solved.nothing) return false;
    TpetraVector product(problem_.map());
    problem_.evaluate_direction(*motion_, product, gaps_);
    result = rooted(gaps_);
    return true;
  }
  const Teuchos::RCP<TpetraVector>& motion() const { return motion_; }
  const PointField& gaps() const { return gaps_; }
  bool softens(int k) const { return tangents_[k].softens; }
  /// What a field has of a point's normal (c = 0), or of the way in which it slips on.
  double onward(const PointField& field, int k, int c) const {
    return c == 0 ? field[at(k)] : component(tangents_[k].onward, &field[at(k) + 1], components_ - 1);
  }

 private:
  std::size_t at(std::size_t k) const { return k * components_; }

  NonlinearProblem& problem_;
  const int components_;
  const std::vector<PointTangent> tangents_;
  std::vector<PointStiffness> resistance_;
  NewtonReport& report_;
  Teuchos::RCP<TpetraVector> motion_;
  PointField gaps_;
};

/// Largest eigenvalue of a symmetric tridiagonal matrix and its vector.
double largest_of(std::vector<double> diagonal, std::vector<double> beside, std::vector<double>& vector) {
  const int n = static_cast<int>(diagonal.size());
  beside.resize(n, 0.0);
  std::vector<double> all(static_cast<std::size_t>(n) * n), work(std::max(1, 2 * n - 2));
  int status = 0;
  Teuchos::LAPACK<int, double>().STEQR('I', n, diagonal.data(), beside.data(), all.data(), n, work.data(), &status);
  vector.assign(all.end() - n, all.end());
  return diagonal.back();
}

/// The largest share and the combination of points that has it, by Lanczos' method with all motions kept orthogonal.
/// Where it is told to be stable the combination may be rough. Nothing where a library refused a system.
double largest_share(Share& share, PointField& combination) {
  std::vector<PointField> basis;
  std::vector<double> diagonal, beside, vector;
  PointField next = share.start(), image;
  double length = std::sqrt(share.dot(next, next)), mu = 0;
  const auto most = std::min<long long>(Numbers::most_motions, share.size());
  while (length > 0) {
    for (auto& value : next) value /= length;
    basis.push_back(next);
    if (!share.apply(next, image)) return 0;
    diagonal.push_back(share.dot(next, image));
    next = image;
    take_off(
        basis, [&](const PointField& a, const PointField& b) { return share.dot(a, b); }, next);
    mu = largest_of(diagonal, beside, vector);
    length = std::sqrt(share.dot(next, next));
    const double error = length * std::abs(vector.back());
    const bool unstable = 2 * mu - 1 > Numbers::neutral;
    if (error <= (unstable ? Numbers::motion_error : Numbers::share_error) * mu) break;
    if (static_cast<long long>(basis.size()) >= most || length <= Numbers::solve_accuracy) break;
    beside.push_back(length);
  }
  combination.assign(next.size(), 0.0);
  for (std::size_t j = 0; j < basis.size(); ++j)
    for (std::size_t i = 0; i < combination.size(); ++i) combination[i] += vector[j] * basis[j][i];
  return mu;
}

/// The lowest number of a point of which a field is as large as anywhere, but for a share, and the largest value of the
/// field with the sign that it has there. Collective.
std::pair<long long, double> leader_of(const NonlinearProblem& problem, const Share& share, const PointField& field,
                                       double as_large) {
  double largest = 0;
  const auto visit = [&](const auto& see) {
    for (int k = 0; k < problem.owned_points(); ++k)
      for (int c = 0; share.softens(k) && c < 2; ++c) see(k, share.onward(field, k, c));
  };
  visit([&](int, double g) { largest = std::max(largest, std::abs(g)); });
  largest = largest_over_ranks(problem, largest);
  constexpr double none = std::numeric_limits<double>::infinity();
  double lowest = none, value = 0;
  visit([&](int k, double g) {
    const auto number = static_cast<double>(problem.number_of(k));
    if (std::abs(g) < as_large * largest || !(number < lowest)) return;
    lowest = number;
    value = g;
  });
  const double first = -largest_over_ranks(problem, -lowest);
  const double sum = total_over_ranks(*problem.map()->getComm(), lowest == first ? value : 0.0);
  return {static_cast<long long>(first), sum < 0 ? -largest : largest};
}

PointField motions(const NonlinearProblem& problem, const PointField& gap, const PointField& lambda) {
  const int n = problem.components();
  PointField all(gap.size(), 0.0);
  for (int k = 0; k < problem.points(); ++k)
    for (int c = 0; problem.selected()[k] && c < n; ++c) all[n * k + c] = motion_of(problem, k, c, gap, lambda);
  return all;
}

/// How the structure moves when the joint that has softened furthest, the first of those that are alike as far as
/// shares are told, runs on and all others follow. Whether it gives way along that; false where a library refused the
/// system. Collective.
bool run_on(const NonlinearProblem& problem, Share& share, const PointField& moved, FirstOfAlike& first) {
  const auto softened_by = share.rooted(moved);
  std::vector<double> size(problem.points(), 0.0);
  for (int k = 0; k < problem.points(); ++k)
    for (int c = 0; share.softens(k) && c < 2; ++c)
      size[k] = std::max(size[k], std::abs(share.onward(softened_by, k, c)));
  first = first_of_alike(problem, size);
  const PointField y = share.rooted(share.in_joint(first.joint, moved));
  PointField image;
  if (!share.apply(y, image)) return false;
  // v = A^-1 B^T h e takes v.K v = v.A v - S, where v.A v = image.y and S = image.image.
  const double softened = share.dot(image, image), both = share.dot(image, y);
  return 2 * softened - both > Numbers::neutral * both;
}

}  // namespace

Instability find_instability(NonlinearProblem& problem, const TpetraVector& x, const PointField& lambda,
                             const Damage& damage, NewtonReport& report) {
  Instability found;
  if (!problem.softening()) return found;
  PointField gap;
  TpetraVector residual(problem.map());
  problem.evaluate(x, residual, gap);
  Share share(problem, point_tangents(problem, CurrentLaws(problem, fall(damage), lambda, gap), lambda, gap), report);
  if (share.size() == 0) return found;
  PointField combination, image;
  found.excess = 2 * largest_share(share, combination) - 1;
  if (!(found.excess > Numbers::neutral)) return found;
  found.any = run_on(problem, share, motions(problem, gap, lambda), found.runs_on);
  if (!found.any) {
    found.runs_on = {};
    found.any = share.apply(combination, image);
  }
  if (!found.any) return found;
  const auto [leader, size] = leader_of(problem, share, share.gaps(), Numbers::leads);
  found.leader = leader;
  found.motion = share.motion();
  found.motion->scale(1 / size);
  found.gaps = share.gaps();
  for (auto& g : found.gaps) g /= size;
  return found;
}

double go_down(NonlinearProblem& problem, const Instability& along, double sign, const Damage& damage, TpetraVector& x,
               PointField& lambda) {
  const int n = problem.components();
  TpetraVector force(problem.map()), change(problem.map());
  PointField start, none;
  problem.evaluate(x, force, start);
  problem.evaluate_direction(*along.motion, change, none);
  const double force_along = force.dot(*along.motion), stiffness = change.dot(*along.motion);
  PointField gap(start.size()), lawful = lambda;
  const auto at = [&](double way) {  // leaves the forces of the law there
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = start[i] + sign * way * along.gaps[i];
    lawful_forces(problem, CurrentLaws(problem, fall(damage), lambda, gap), lambda, gap, lawful);
  };
  /// Slope of the potential by the way.
  const auto slope = [&](double way) {
    at(way);
    double mine = 0;
    for (int i = 0; i < n * problem.owned_points(); ++i)
      if (problem.selected()[i / n]) mine += lawful[i] * along.gaps[i];
    return sign * (force_along - total_over_ranks(*problem.map()->getComm(), mine)) + way * stiffness;
  };
  // The way at which a motion is as large as the first that has led here, a small one for sure.
  double way = std::numeric_limits<double>::infinity();
  for (int k = 0; k < problem.owned_points(); ++k) {
    if (!problem.selected()[k]) continue;
    const double opening = motion_of(problem, k, 0, start, lambda);
    if (opening > 0 && along.gaps[n * k] != 0) way = std::min(way, opening / std::abs(along.gaps[n * k]));
    const auto slip = slip_of(problem, k, lambda, start);
    const double slipped = std::hypot(slip[0], slip[1]), slips = tangential_size(along.gaps, k, n);
    if (slipped != 0 && slips != 0) way = std::min(way, slipped / slips);
  }
  way = -largest_over_ranks(problem, -way);
  if (!std::isfinite(way)) return 0;
  const double farthest = problem.length_scale();
  double low = 0;
  while (way < farthest && slope(way) < 0) {
    low = way;
    way *= 2;
  }
  for (int halvings = 0; halvings < 20 && low > 0; ++halvings) {
    const double middle = (low + way) / 2;
    (slope(middle) < 0 ? low : way) = middle;
  }
  at(way);
  x.update(sign * way, *along.motion, 1.0);
  lambda = lawful;
  return way;
}

}  // namespace voussoir

#include "nonlinear/stability.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "linalg/reduce.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"

namespace voussoir {
namespace {

using Numbers = StabilityParameters;
using Square = std::array<double, 3>;  // symmetric: normal, mixed, tangential

/// What a point resists with, and the root of what it softens by.
struct Tangent {
  PointStiffness resistance;
  Square softening{};
  bool softens = false;
  double onward = 1;  ///< direction in which it slips on
};

/// f(a) of a symmetric matrix.
template <class Function>
Square function_of(const Square& a, const Function& f) {
  if (a[1] == 0) return {f(a[0]), 0.0, f(a[2])};
  const double middle = (a[0] + a[2]) / 2, half = (a[0] - a[2]) / 2, radius = std::hypot(half, a[1]);
  const double high = f(middle + radius), low = f(middle - radius);
  const double mean = (high + low) / 2, slope = (high - low) / (2 * radius);
  return {mean + slope * half, slope * a[1], mean - slope * half};
}

/// Derivative of the forces of a point that softens, with friction held at its size: symmetric part.
Square derivative(const NonlinearProblem& problem, int k, const WeakenedLaw& now, const PointField& lambda,
                  const PointField& gap) {
  const double opening = motion_of(problem, k, 0, gap, lambda), slip = motion_of(problem, k, 1, gap, lambda);
  const double normal = lambda[2 * k] - stiffness_of(problem, k, 0, 1.0) * opening;
  const double trial = lambda[2 * k + 1] - stiffness_of(problem, k, 1, 1.0) * slip;
  const bool open = judge(now.law, normal, 0.0, 0.0) == ContactStatus::open;
  const double bound = friction_bound(now.law, open ? -now.law.tension : normal);
  const bool sticks = bound > 0 && std::abs(trial)<bound, slips = bound> 0 && !sticks;
  const bool advances = slips && trial * slip <= 0;
  const double direction = trial > 0 ? 1 : -1;
  PointStiffness s;
  PointCompliance mortar = problem.compliance().empty() ? PointCompliance{} : problem.compliance()[k];
  s.normal = open ? now.pull_per_opening : stiffness_of(problem, k, 0, Numbers::augmentation);
  if (!open) mortar.normal = 0;  // which is in it
  if (sticks) {
    s.tangential[0] = stiffness_of(problem, k, 1, Numbers::augmentation);
    mortar.tangential = 0;
  } else if (advances) {
    s.tangential[0] = now.cohesion_per_slip;
  }
  double mixed = 0;
  if (open && advances) mixed = -direction * (now.pull_per_slip + now.cohesion_per_gap) / 2;
  s.coupling[0] = s.pull[0] = mixed;
  if (mortar.normal != 0 || mortar.tangential != 0) s = in_series(s, mortar, 2);
  return {s.normal, (s.coupling[0] + s.pull[0]) / 2, s.tangential[0]};
}

std::vector<Tangent> tangents(const NonlinearProblem& problem, const CurrentLaws& laws, const PointField& lambda,
                              const PointField& gap) {
  std::vector<Tangent> all(problem.points());
  for (int k = 0; k < problem.points(); ++k) {
    if (!problem.selected()[k]) continue;
    const Square d = derivative(problem, k, laws.at(k), lambda, gap);
    auto& t = all[k];
    const Square size = function_of(d, [](double value) { return std::abs(value); });
    t.resistance.normal = size[0];
    t.resistance.tangential[0] = size[2];
    t.resistance.coupling[0] = t.resistance.pull[0] = size[1];
    t.softening = function_of(d, [](double value) { return std::sqrt(std::max(0.0, -value)); });
    t.softens = t.softening[0] > 0 || t.softening[2] > 0;
    t.onward = motion_of(problem, k, 1, gap, lambda) < 0 ? -1 : 1;
  }
  return all;
}

/// Softening points in the place of unknowns: their motions times the root of what they soften by.
class Share {
 public:
  Share(NonlinearProblem& problem, std::vector<Tangent> all, NewtonReport& report)
      : problem_(problem),
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
    PointField y(2 * tangents_.size(), 0.0);
    for (int k = 0; k < problem_.points(); ++k)
      for (int c = 0; c < 2; ++c) {
        double whole;
        y[2 * k + c] =
            0.5 + std::modf(0.618033988749895 * static_cast<double>(2 * problem_.number_of(k) + c + 1), &whole);
      }
    return rooted(y);
  }
  /// A field of the points that soften beside one in its joint, and 0 elsewhere.
  PointField in_joint_of(long long number, const PointField& all) const {
    int joint = -1;
    for (int k = 0; k < problem_.points(); ++k)
      if (problem_.number_of(k) == number) joint = problem_.joint_of(k);
    PointField some(all.size(), 0.0);
    for (int k = 0; k < problem_.points(); ++k)
      if (tangents_[k].softens && problem_.joint_of(k) == joint) std::copy_n(&all[2 * k], 2, &some[2 * k]);
    return some;
  }
  double dot(const PointField& a, const PointField& b) const {
    double mine = 0;
    for (int i = 0; i < 2 * problem_.owned_points(); ++i) mine += a[i] * b[i];
    return total_over_ranks(*problem_.map()->getComm(), mine);
  }
  /// Root of softening times what is given per point.
  PointField rooted(const PointField& g) const {
    PointField y(g.size(), 0.0);
    for (std::size_t k = 0; k < tangents_.size(); ++k) {
      const auto& h = tangents_[k].softening;
      if (!tangents_[k].softens) continue;
      y[2 * k] = h[0] * g[2 * k] + h[1] * g[2 * k + 1];
      y[2 * k + 1] = h[1] * g[2 * k] + h[2] * g[2 * k + 1];
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
  double onward(int k, int c) const { return c == 0 ? 1.0 : tangents_[k].onward; }

 private:
  NonlinearProblem& problem_;
  const std::vector<Tangent> tangents_;
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
    for (int twice = 0; twice < 2; ++twice)
      for (const auto& known : basis) {
        const double along = share.dot(known, next);
        for (std::size_t i = 0; i < next.size(); ++i) next[i] -= along * known[i];
      }
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
      for (int c = 0; share.softens(k) && c < 2; ++c) see(k, share.onward(k, c) * field[2 * k + c]);
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
  PointField all(gap.size(), 0.0);
  for (int k = 0; k < problem.points(); ++k)
    for (int c = 0; problem.selected()[k] && c < 2; ++c) all[2 * k + c] = motion_of(problem, k, c, gap, lambda);
  return all;
}

/// How the structure moves when the joint that has softened furthest, the first of those that are alike as far as
/// shares are told, runs on and all others follow. Whether it gives way along that; false where a library refused the
/// system. Collective.
bool run_on(const NonlinearProblem& problem, Share& share, const PointField& moved) {
  const auto leader = leader_of(problem, share, share.rooted(moved), 1 - Numbers::share_error).first;
  const PointField y = share.rooted(share.in_joint_of(leader, moved));
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
  if (!problem.softening() || problem.components() != 2) return found;
  PointField gap;
  TpetraVector residual(problem.map());
  problem.evaluate(x, residual, gap);
  Share share(problem, tangents(problem, CurrentLaws(problem, fall(damage), lambda, gap), lambda, gap), report);
  if (share.size() == 0) return found;
  PointField combination, image;
  found.excess = 2 * largest_share(share, combination) - 1;
  found.any = found.excess > Numbers::neutral &&
              (run_on(problem, share, motions(problem, gap, lambda)) || share.apply(combination, image));
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
    for (int i = 0; i < 2 * problem.owned_points(); ++i)
      if (problem.selected()[i / 2]) mine += lawful[i] * along.gaps[i];
    return sign * (force_along - total_over_ranks(*problem.map()->getComm(), mine)) + way * stiffness;
  };
  // The way at which a motion is as large as the first that has led here, a small one for sure.
  double way = std::numeric_limits<double>::infinity();
  for (int k = 0; k < problem.owned_points(); ++k) {
    if (!problem.selected()[k]) continue;
    const double opening = motion_of(problem, k, 0, start, lambda);
    if (opening > 0 && along.gaps[2 * k] != 0) way = std::min(way, opening / std::abs(along.gaps[2 * k]));
    const double slip = motion_of(problem, k, 1, start, lambda);
    if (slip != 0 && along.gaps[2 * k + 1] != 0) way = std::min(way, std::abs(slip / along.gaps[2 * k + 1]));
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

// Parts of ranks are added up and solved exactly, whoever factors the sum; or by levels, where they converge.
#include "linalg/shared_system.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "linalg/solver_failure.hpp"
#include "unit/linalg/body_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// @param most  unknowns that the first rank may factor
SharedSystemParameters on_first_up_to(long long most) {
  SharedSystemParameters numbers;
  numbers.most_on_first = most;
  return numbers;
}
constexpr long long everything = 1000000, nothing = 0;

/// A matrix that is the sum over "elements": each couples an unknown with some others, and is with the rank that owns
/// the unknown; so ranks hold parts of rows of others.
class Elements {
 public:
  explicit Elements(long long size)
      : size_(size), map_(Teuchos::rcp(new TpetraMap(Tpetra::global_size_t(size), 0, everyone()))) {
    std::set<long long> others;
    for (const auto i : map_->getNodeElementList())
      for (const auto j : met_by(i))
        if (!map_->isNodeGlobalElement(j)) others.insert(j);
    for (const auto i : map_->getNodeElementList()) unknowns_.number.push_back(i);
    unknowns_.owned = static_cast<int>(unknowns_.number.size());
    // Last first: the order of others does not matter.
    unknowns_.number.insert(unknowns_.number.end(), others.rbegin(), others.rend());
    for (const auto i : unknowns_.number) unknowns_.owner.push_back(owner_of(i));
  }
  const SharedSystem::Unknowns& unknowns() const { return unknowns_; }
  const Teuchos::RCP<const TpetraMap>& map() const { return map_; }

  /// Of this rank, upper triangle in its own numbers.
  LocalCsr part(double scale) const {
    std::map<std::pair<int, int>, double> entries;
    for (std::size_t k = 0; k < unknowns_.number.size(); ++k) entries[{int(k), int(k)}] = 0;
    for (int k = 0; k < unknowns_.owned; ++k) {
      const auto i = unknowns_.number[k];
      entries[{k, k}] += 0.1 * scale;
      for (const auto j : met_by(i)) {
        const int other = local(j);
        const double stiffness = scale * (1.5 + noise(100 * i + j));  // a spring between the two
        entries[{k, k}] += stiffness;
        entries[{other, other}] += stiffness;
        entries[{std::min(k, other), std::max(k, other)}] -= stiffness;
      }
    }
    LocalCsr part;
    for (std::size_t k = 0; k < unknowns_.number.size(); ++k) {
      for (auto e = entries.lower_bound({int(k), 0}); e != entries.end() && e->first.first == int(k); ++e) {
        part.column.push_back(e->first.second);
        part.value.push_back(e->second);
      }
      part.start.push_back(static_cast<int>(part.column.size()));
    }
    return part;
  }
  /// The sum of all parts, as a matrix that applies.
  Teuchos::RCP<TpetraMatrix> sum(double scale) const {
    return distributed(
        size_,
        [&](long long row) {
          std::map<long long, double> entries{{row, 0.1 * scale}};
          for (long long i = 0; i < size_; ++i)
            for (const auto j : met_by(i)) {
              const double stiffness = scale * (1.5 + noise(100 * i + j));
              if (i == row) entries[row] += stiffness, entries[j] -= stiffness;
              if (j == row) entries[row] += stiffness, entries[i] -= stiffness;
            }
          return entries;
        },
        everyone());
  }

 private:
  std::vector<long long> met_by(long long i) const {
    std::vector<long long> met;
    for (const long long stride : {1LL, 7LL, 30LL})
      if (i + stride < size_) met.push_back(i + stride);
    return met;
  }
  int local(long long i) const {
    return static_cast<int>(std::find(unknowns_.number.begin(), unknowns_.number.end(), i) - unknowns_.number.begin());
  }
  int owner_of(long long i) const {
    // The map is in even pieces.
    const long long ranks = everyone()->getSize(), even = size_ / ranks, more = size_ % ranks;
    const long long behind = more * (even + 1);
    return static_cast<int>(i < behind ? i / (even + 1) : more + (i - behind) / even);
  }

  long long size_;
  Teuchos::RCP<const TpetraMap> map_;
  SharedSystem::Unknowns unknowns_;
};

TEUCHOS_UNIT_TEST(SharedSystem, IsTheExactInverseOfTheSumOfParts) {
  for (const long long size : {4LL, 200LL})
    for (const auto on_first : {everything, nothing}) {
      const Elements elements(size);
      SharedSystem system(elements.unknowns(), {}, everyone(), on_first_up_to(on_first));
      TEST_EQUALITY(system.size(), size);
      for (const double scale : {1.0, 5.0}) {  // factored anew, of the same pattern
        system.factor(elements.part(scale));
        const auto a = elements.sum(scale);
        // b: one per unknown from everybody who knows it.
        std::vector<double> ones(elements.unknowns().number.size(), 1.0), x;
        system.solve(ones, x);
        TEST_EQUALITY(x.size(), ones.size());
        TpetraVector solution(elements.map()), left(elements.map());
        std::copy_n(x.begin(), elements.unknowns().owned, local_view_to_write(solution));
        a->apply(solution, left);
        // The right side is the number of those who know an unknown; all of them hear the same solution.
        const TpetraImport import(
            elements.map(),
            Teuchos::rcp(new TpetraMap(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                                       Teuchos::arrayViewFromVector(elements.unknowns().number), 0, everyone())));
        TpetraVector known(import.getTargetMap()), counted(elements.map());
        known.putScalar(1);
        counted.doExport(known, import, Tpetra::ADD);
        left.update(-1.0, counted, 1.0);
        TEST_COMPARE(left.norm2(), <=, 1e-11 * counted.norm2());  // condition below 1000
        known.doImport(solution, import, Tpetra::INSERT);
        for (std::size_t k = 0; k < x.size(); ++k) TEST_EQUALITY(local_view(known)[k], x[k]);
      }
      TEST_COMPARE(largest_of_ranks(*everyone(), static_cast<double>(system.bytes())), >, 0);
    }
}

TEUCHOS_UNIT_TEST(SharedSystem, WhatTheFirstRankCannotFactorFailsOnAll) {
  const Elements elements(50);
  SharedSystem system(elements.unknowns(), {}, everyone(), on_first_up_to(everything));
  auto part = elements.part(1.0);
  for (double& value : part.value) value = -value;
  TEST_THROW(system.factor(part), SolverFailure);
  system.factor(elements.part(1.0));  // and serves what follows
  std::vector<double> ones(elements.unknowns().number.size(), 1.0), x;
  system.solve(ones, x);
  for (const double value : x) TEST_ASSERT(std::isfinite(value));
}

/// Solves with what a system has for a solution, by conjugate gradients where that is a cycle.
/// @returns  iterations
int solve(const SharedSystem& system, const BodyWall& wall, const TpetraMatrix& a, const TpetraVector& b,
          TpetraVector& x) {
  const auto known = wall.unknowns().number.size();
  TpetraVector r(b, Teuchos::Copy), z(b.getMap()), p(b.getMap()), ap(b.getMap());
  std::vector<double> mine(known), told;
  double along = 0;
  x.putScalar(0);
  for (int k = 0; k < 100; ++k) {
    mine.assign(known, 0.0);
    std::copy_n(local_view(r), r.getLocalLength(), mine.begin());
    system.solve(mine, told);
    std::copy_n(told.begin(), z.getLocalLength(), local_view_to_write(z));
    const double before = along;
    along = r.dot(z);
    p.update(1.0, z, k == 0 ? 0.0 : along / before);
    a.apply(p, ap);
    const double alpha = along / p.dot(ap);
    x.update(alpha, p, 1.0);
    r.update(-alpha, ap, 1.0);
    if (r.norm2() <= 1e-8 * b.norm2()) return k + 1;
  }
  return 1000;
}

SharedSystemParameters by_levels() {
  auto numbers = on_first_up_to(nothing);
  numbers.levels.coarsest = 60;
  numbers.levels.least_of_a_rank = 100;
  return numbers;
}

// As long as nobody is alone: one rank factors.
TEUCHOS_UNIT_TEST(SharedSystem, LevelsStandForTheSolutionOnManyRanks) {
  const bool alone = everyone()->getSize() == 1;
  for (const double open : {0.0, 0.1}) {
    const BodyWall wall(30, 30, open, 41);
    const auto a = wall.matrix();
    SharedSystem system(wall.unknowns(), wall.bodies(), everyone(), by_levels());
    TEST_ASSERT(system.factor(wall.part(3.0)) == (alone ? SolvedBy::factors : SolvedBy::levels));
    TEST_ASSERT(system.factor(wall.part()) == (alone ? SolvedBy::factors : SolvedBy::levels));
    TEST_EQUALITY(system.levels().empty(), alone);
    TpetraVector b(wall.map()), x(wall.map());
    a->apply(*noise_vector(wall.map()), b);
    const int iterations = solve(system, wall, *a, b, x);
    out << open << ": " << iterations << " iterations\n";
    TEST_COMPARE(iterations, <=, alone ? 3 : 20);
    TEST_COMPARE(relative_residual(*a, b, x), <=, 1e-7);
    TEST_COMPARE(largest_of_ranks(*everyone(), static_cast<double>(system.bytes())), >, 0);
  }
}

// Refused where they converge worse than asked for; and all ranks factor.
TEUCHOS_UNIT_TEST(SharedSystem, FactorsTakeThePlaceOfLevelsThatDoNotConverge) {
  const bool alone = everyone()->getSize() == 1;
  // Half of the joints open: stones hang together by few of them.
  const BodyWall wall(40, 40, 0.5);
  const auto a = wall.matrix();
  SharedSystem system(wall.unknowns(), wall.bodies(), everyone(), by_levels());
  TEST_ASSERT(system.factor(wall.part()) == (alone ? SolvedBy::factors : SolvedBy::factors_for_levels));
  TEST_ASSERT(system.levels().empty());
  TpetraVector b(wall.map()), x(wall.map());
  a->apply(*noise_vector(wall.map()), b);
  TEST_COMPARE(solve(system, wall, *a, b, x), <=, 3);
}

// One rank alone has a part that is none: no rank goes another way than the others.
TEUCHOS_UNIT_TEST(SharedSystem, APartOfOneRankThatIsNoNumberFailsOnAll) {
  const BodyWall wall(30, 30);
  SharedSystem system(wall.unknowns(), wall.bodies(), everyone(), by_levels());
  auto part = wall.part();
  if (everyone()->getRank() == everyone()->getSize() - 1) part.value.back() = std::nan("");
  TEST_THROW(system.factor(part), SolverFailure);
  system.factor(wall.part());  // and serves what follows
  TpetraVector b(wall.map()), x(wall.map());
  const auto a = wall.matrix();
  a->apply(*noise_vector(wall.map()), b);
  TEST_COMPARE(solve(system, wall, *a, b, x), <=, 20);
}

}  // namespace

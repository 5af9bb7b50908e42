// Levels of bodies stand for the inverse of their matrix: one linear symmetric cycle, as good on any number of bodies
// and ranks; and they say so where they do not.
#include "linalg/body_levels.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "unit/linalg/body_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Small enough for several levels in walls of some hundred bodies.
BodyLevelsParameters small_levels() {
  BodyLevelsParameters numbers;
  numbers.coarsest = 60;
  numbers.least_of_a_rank = 100;
  return numbers;
}

/// Right side without a part that nothing holds.
Teuchos::RCP<TpetraVector> image(const TpetraMatrix& a, const Teuchos::RCP<const TpetraMap>& map) {
  auto b = Teuchos::rcp(new TpetraVector(map));
  a.apply(*noise_vector(map), *b);
  return b;
}

TEUCHOS_UNIT_TEST(BodyLevels, AreAsGoodForMoreBodies) {
  for (const int wide : {16, 32, 64}) {
    const BodyWall wall(wide, wide);
    const BodyLevels levels(*wall.matrix(), wall.motions(), small_levels());
    out << wide << ": " << levels.eigenvalues().smallest << " to " << levels.eigenvalues().largest << "\n";
    TEST_ASSERT(levels.converges());
    TEST_COMPARE(levels.eigenvalues().smallest, >=, 0.3);
    TEST_COMPARE(levels.levels().size(), >=, wide == 16 ? 2u : 3u);
    TEST_EQUALITY(levels.levels().back().ranks, 1);
    TEST_COMPARE(largest_of_ranks(*everyone(), static_cast<double>(levels.bytes())), >, 0);
  }
}

// A tenth of the joints open, bodies that nothing holds, the last of the ranks without any.
TEUCHOS_UNIT_TEST(BodyLevels, AreLinearAndSymmetricWhateverIsOpen) {
  for (const double open : {0.0, 0.1})
    for (const int loose : {0, 41}) {
      const int used = std::max(1, everyone()->getSize() - 1);
      const BodyWall wall(30, 30, open, loose, used);
      const auto matrix = wall.matrix();
      const BodyLevels levels(*matrix, wall.motions(), small_levels());
      out << open << " " << loose << ": " << levels.eigenvalues().smallest << " to " << levels.eigenvalues().largest
          << "\n";
      TEST_ASSERT(levels.converges());
      const auto a = image(*matrix, wall.map());
      TpetraVector b(wall.map()), ma(wall.map()), mb(wall.map()), sum(wall.map()), m_sum(wall.map());
      for (std::size_t k = 0; k < b.getLocalLength(); ++k)
        local_view_to_write(sum)[k] = noise(5 * wall.map()->getGlobalElement(static_cast<int>(k)));
      matrix->apply(sum, b);
      levels.apply(*a, ma);
      levels.apply(b, mb);
      const double scale = ma.norm2() * b.norm2() + mb.norm2() * a->norm2();
      TEST_COMPARE(std::abs(a->dot(mb) - b.dot(ma)), <=, 1e-10 * scale);
      TEST_COMPARE(a->dot(ma), >, 0);
      sum.update(1.0, *a, 2.0, b, 0.0);
      levels.apply(sum, m_sum);
      m_sum.update(-1.0, ma, -2.0, mb, 1.0);
      TEST_COMPARE(m_sum.norm2(), <=, 1e-5 * (ma.norm2() + mb.norm2()));  // what is loose is shifted by 1e-10
    }
}

// The same cycle, one after the other, is a solver.
TEUCHOS_UNIT_TEST(BodyLevels, CyclesArriveAtTheSolution) {
  const BodyWall wall(40, 40, 0.1);
  const auto matrix = wall.matrix();
  const BodyLevels levels(*matrix, wall.motions(), small_levels());
  const auto b = image(*matrix, wall.map());
  TpetraVector x(wall.map()), r(*b, Teuchos::Copy), z(wall.map());
  for (int cycle = 0; cycle < 60; ++cycle) {
    levels.apply(r, z);
    x.update(1.0, z, 1.0);
    matrix->apply(x, r);
    r.update(1.0, *b, -1.0);
  }
  TEST_COMPARE(r.norm2(), <=, 1e-5 * b->norm2());  // 1 - 0.2, to the power of 60
}

// Half of the joints open: bodies hang together by few. And a matrix that is none of springs.
TEUCHOS_UNIT_TEST(BodyLevels, SayWhereTheyDoNotConverge) {
  const BodyWall open(40, 40, 0.5), wall(30, 30);
  const BodyLevels few(*open.matrix(), open.motions(), small_levels());
  out << few.eigenvalues().smallest << " to " << few.eigenvalues().largest << "\n";
  TEST_ASSERT(!few.converges());
  const auto matrix = wall.matrix();
  matrix->resumeFill();
  matrix->scale(-1.0);
  matrix->fillComplete();
  const BodyLevels negative(*matrix, wall.motions(), small_levels());
  TEST_ASSERT(!negative.converges());
}

TEUCHOS_UNIT_TEST(IncompleteCholesky, IsExactWhereNothingFillsIn) {
  // A column of bodies: its matrix has the pattern of its factors.
  const BodyWall wall(1, 30, 0, 0, 1);
  const auto matrix = wall.matrix();
  const IncompleteCholesky factors(*matrix);
  TpetraVector x(wall.map()), b(wall.map());
  const auto exact = noise_vector(wall.map());
  matrix->apply(*exact, b);
  factors.solve(local_view(b), local_view_to_write(x));
  x.update(-1.0, *exact, 1.0);
  TEST_COMPARE(x.norm2(), <=, 1e-8 * exact->norm2());
}

}  // namespace

// Around the few nodes that a selection parts, systems are solved directly: exact there, and what is left is little.
#include "homogenisation/released_region.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "homogenisation/coarse_operator.hpp"
#include "linalg/reduce.hpp"
#include "unit/homogenisation/selected_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

ReleasedRegion region_of(const SelectedWall& w) { return {w.structure, w.points, w.selected, w.space}; }

TEUCHOS_UNIT_TEST(ReleasedRegion, IsSmallWhereLittleHasParted) {
  const SelectedWall none(Selected::none), few(Selected::few), all(Selected::all), mine(Selected::few, alone());
  TEST_EQUALITY(region_of(none).size(), 0);
  TEST_ASSERT(region_of(none).pays());
  TEST_COMPARE(region_of(few).size(), >, 0);
  TEST_ASSERT(region_of(few).pays());
  TEST_EQUALITY(region_of(few).size(), region_of(mine).size());  // whatever ranks share it
  TEST_ASSERT(!region_of(all).pays());
}

TEUCHOS_UNIT_TEST(ReleasedRegion, SolvesExactlyWhatMovesThereWithFriction) {
  const SelectedWall w(Selected::few);
  SystemMatrix h(w.structure, w.points, w.selected, w.space);
  auto region = region_of(w);
  for (const double direction : {0.0, 1.0, -1.0}) {  // without friction, and slipping either way: factored anew
    const auto stiffness = direction == 0 ? w.statuses() : slipping(w, direction);
    h.update(stiffness, w.proximal());
    TEST_EQUALITY(h.couple(stiffness), direction != 0);
    TEST_ASSERT(region.update(h));
    TpetraVector x(w.space.map()), r(w.space.map()), again(w.space.map());
    region.add(*load(w), x);
    int moved = 0;
    for (int i = 0; i < 2 * w.space.owned_clusters(); ++i) moved += local_view(x)[i] != 0;
    TEST_EQUALITY(static_cast<int>(total_over_ranks(*w.structure.comm(), moved)), region.size());
    h.matrix()->apply(x, r);
    region.add(r, again);
    again.update(-1.0, x, 1.0);
    TEST_COMPARE(again.norm2(), <=, 1e-12 * x.norm2());  // condition 1e4 or less, times round-off
  }
}

TEUCHOS_UNIT_TEST(ReleasedRegion, SavesIterations) {
  const SelectedWall w(Selected::few);
  const Continuum continuum(w.structure, w.points, w.held, {});
  SystemMatrix h(w.structure, w.points, w.selected, w.space);
  LinearSolver solver({});
  const std::vector<double> nothing(w.proximal().size(), 0.0);  // the continuum knows of no proximal term
  for (const double direction : {0.0, 1.0}) {
    const auto stiffness = direction == 0 ? w.statuses() : slipping(w, direction);
    int iterations[2];
    Teuchos::RCP<TpetraVector> x[2];
    for (const bool region : {false, true}) {
      PreconditionerParameters parameters;
      parameters.released_region = region;
      const auto m =
          std::make_shared<CoarseOperator>(w.structure, w.points, w.selected, w.space, continuum, parameters);
      h.update(stiffness, nothing);
      m->update(h, stiffness, nothing);
      const auto symmetry = h.couple(stiffness) ? Symmetry::none : Symmetry::symmetric;
      m->couple(h, symmetry);
      TEST_EQUALITY(m->motions() == 0, region);
      x[region] = Teuchos::rcp(new TpetraVector(w.space.map()));
      const auto result = solver.solve(h.matrix(), m, load(w), x[region], 1e-10, symmetry);
      TEST_ASSERT(result.converged);
      iterations[region] = result.iterations;
    }
    out << iterations[0] << " iterations, " << iterations[1] << " with the region\n";
    TEST_COMPARE(iterations[1], <, iterations[0]);
    x[1]->update(-1.0, *x[0], 1.0);
    TEST_COMPARE(x[1]->norm2(), <=, 1e-6 * x[0]->norm2());  // the tolerance times the condition number
  }
}

TEUCHOS_UNIT_TEST(ReleasedRegion, IsFactoredAgainWhenPointsSlipTheOtherWay) {
  const SelectedWall w(Selected::few);
  const Continuum continuum(w.structure, w.points, w.held, {});
  SystemMatrix h(w.structure, w.points, w.selected, w.space);
  CoarseOperator m(w.structure, w.points, w.selected, w.space, continuum, {});
  const auto factorised_for = [&](double direction) {
    const auto stiffness = slipping(w, direction);
    h.update(stiffness, w.proximal());
    m.update(h, stiffness, w.proximal());
    h.couple(stiffness);
    m.couple(h, Symmetry::none);
    return m.cost().factorised;
  };
  const auto first = factorised_for(1), again = factorised_for(1), other = factorised_for(-1);
  TEST_EQUALITY(first, 1);
  TEST_EQUALITY(again, 1);
  TEST_EQUALITY(other, 2);
  TEST_EQUALITY(m.cost().reused, 1);
  TEST_COMPARE(m.cost().block_bytes, >, 0);
}

// What a step has learnt is forgotten when the next begins, but factors that would be made alike again are kept: those
// of resistances that are the same to the last bit.
TEUCHOS_UNIT_TEST(ReleasedRegion, ANewStepTakesFactorsOnlyWhereNothingHasChanged) {
  for (const auto selected : {Selected::few, Selected::all}) {
    const SelectedWall w(selected);
    const Continuum continuum(w.structure, w.points, w.held, {});
    SystemMatrix h(w.structure, w.points, w.selected, w.space);
    CoarseOperator m(w.structure, w.points, w.selected, w.space, continuum, {});
    const auto stiffness = slipping(w, 1);
    const auto update = [&](double factor) {
      auto more = stiffness;
      for (auto& k : more) k.normal *= factor;
      h.update(more, w.proximal());
      m.update(h, more, w.proximal());
      m.couple(h, h.couple(more) ? Symmetry::none : Symmetry::symmetric);
    };
    constexpr double a_little = 1.01;  // less than a tenth
    update(1);
    update(a_little);
    TEST_EQUALITY(m.cost().factorised, 1);
    TEST_EQUALITY(m.cost().reused, 1);
    TEST_ASSERT(m.begin_step());
    TEST_EQUALITY(m.cost().factorised + m.cost().reused, 0);
    update(1);
    update(a_little);
    TEST_EQUALITY(m.cost().factorised, 0);
    TEST_EQUALITY(m.cost().reused, 2);
    TEST_ASSERT(m.begin_step());
    update(a_little);
    TEST_EQUALITY(m.cost().factorised, 1);
    TEST_ASSERT(m.factor_whole());
    TEST_ASSERT(!m.begin_step());
  }
}

}  // namespace

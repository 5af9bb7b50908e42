// Systems on which Krylov's method labours are factored whole: solved exactly, whatever statuses they come to.
#include <Teuchos_UnitTestHarness.hpp>
#include <limits>

#include "homogenisation/coarse_operator.hpp"
#include "unit/homogenisation/selected_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// A wall, its matrix and its coarse operator, with statuses that slip one way, the other, or have no friction (0).
struct Problem {
  const SelectedWall wall;
  Continuum continuum{wall.structure, wall.points, wall.held, {}};
  SystemMatrix h{wall.structure, wall.points, wall.selected, wall.space};
  CoarseOperator m;

  explicit Problem(Selected what, const PreconditionerParameters& parameters = {},
                   const CoarseOperatorParameters& numbers = {})
      : wall(what), m(wall.structure, wall.points, wall.selected, wall.space, continuum, parameters, numbers) {}

  void slip(double direction) {
    const auto stiffness = direction == 0 ? wall.statuses() : slipping(wall, direction);
    h.update(stiffness, wall.proximal());
    m.update(h, stiffness, wall.proximal());
    m.couple(h, h.couple(stiffness) ? Symmetry::none : Symmetry::symmetric);
  }
  /// |r - H M r| / |r| [-]
  double left() const {
    const auto r = load(wall);
    TpetraVector z(wall.space.map()), hz(wall.space.map());
    m.apply(*r, z);
    h.matrix()->apply(z, hz);
    hz.update(-1.0, *r, 1.0);
    return hz.norm2() / r->norm2();
  }
};

TEUCHOS_UNIT_TEST(FactoredWhole, IsExactForAllStatusesThatFollow) {
  for (const auto what : {Selected::few, Selected::some, Selected::all}) {
    Problem p(what);
    p.slip(1);
    TEST_COMPARE(p.left(), >, 1e-3);
    TEST_ASSERT(p.m.factor_whole());
    for (const double direction : {1.0, -1.0, 0.0}) {
      p.slip(direction);
      TEST_COMPARE(p.left(), <=, 1e-10);  // condition 1e4 or less, times round-off
    }
    TEST_EQUALITY(p.m.cost().whole, 3);
    TEST_EQUALITY(p.m.cost().reused, 1);  // the statuses it was factored with
    TEST_COMPARE(p.m.cost().whole_bytes, >, 0);
    TEST_EQUALITY(p.m.motions(), 0);
  }
}

// A system fills in the more the more neighbours its unknowns have: what its factors take tells, not unknowns alone.
TEUCHOS_UNIT_TEST(FactoredWhole, IsForSystemsWhoseFactorsAreExpectedToFit) {
  PreconditionerParameters parameters;
  CoarseOperatorParameters numbers;
  DistributedLu::Expected expected;
  {
    Problem p(Selected::all);
    p.slip(1);
    expected = DistributedLu(p.wall.space.map()).expected(*p.h.matrix());
    const auto entries = static_cast<double>(p.h.matrix()->getGlobalNumEntries());
    const auto unknowns = static_cast<double>(p.wall.space.map()->getGlobalNumElements());
    TEST_COMPARE(expected.bytes, >, 8 * entries);
    TEST_COMPARE(expected.bytes, <, 1500 * unknowns);
  }
  for (const bool fits : {true, false}) {
    numbers.bytes_of_factors = (fits ? 1.001 : 0.999) * expected.bytes / parameters.factored_up_to;
    Problem p(Selected::all, parameters, numbers);
    p.slip(1);
    TEST_EQUALITY(p.m.iterations_of_factoring(), fits ? numbers.krylov_to_factor : std::numeric_limits<int>::max());
    TEST_EQUALITY(p.m.may_factor_whole(), fits);
    TEST_EQUALITY(p.m.factor_whole(), fits);
  }
}

TEUCHOS_UNIT_TEST(FactoredWhole, WaitsForAsManyIterationsAsFactoringTakes) {
  CoarseOperatorParameters numbers;
  Problem p(Selected::all, {}, numbers);
  p.slip(1);
  const auto entries = static_cast<double>(p.h.matrix()->getGlobalNumEntries());
  const double work = DistributedLu(p.wall.space.map()).expected(*p.h.matrix()).operations / entries;
  numbers.work_per_entry = work / 50.5;
  Problem other(Selected::all, {}, numbers);
  other.slip(1);
  TEST_EQUALITY(other.m.iterations_of_factoring(), 50);
  TEST_ASSERT(other.m.factor_whole());
}

TEUCHOS_UNIT_TEST(FactoredWhole, IsForSystemsThatAreSmallEnoughAndParted) {
  const Problem bonded(Selected::none);
  TEST_ASSERT(!bonded.m.may_factor_whole());
  PreconditionerParameters parameters;
  Problem enough(Selected::all, parameters);
  parameters.factored_up_to = static_cast<int>(enough.wall.space.map()->getGlobalNumElements());
  const Problem just(Selected::all, parameters);
  TEST_ASSERT(just.m.may_factor_whole());
  --parameters.factored_up_to;
  const Problem too_many(Selected::all, parameters);
  TEST_ASSERT(!too_many.m.may_factor_whole());
  parameters.factored_up_to = 0;
  const Problem never(Selected::few, parameters);
  TEST_ASSERT(!never.m.may_factor_whole());
  enough.slip(1);
  TEST_ASSERT(enough.m.may_factor_whole());
  TEST_ASSERT(enough.m.factor_whole());
  TEST_ASSERT(!enough.m.may_factor_whole());  // it is already
}

}  // namespace

// Systems on which Krylov's method labours are factored whole: solved exactly, whatever statuses they come to.
#include <Teuchos_UnitTestHarness.hpp>

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

  explicit Problem(Selected what, const PreconditionerParameters& parameters = {})
      : wall(what), m(wall.structure, wall.points, wall.selected, wall.space, continuum, parameters) {}

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

// Block motions are exact for what they stand for; the whole preconditioner is symmetric and positive.
#include "homogenisation/coarse_operator.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "linalg/shared_system.hpp"
#include "unit/homogenisation/selected_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// The motion number `which` of a block at a place: every block has its own by chance.
Vector<2> motion(BlockId block, int which, const Vector<2>& x) {
  const long long seed = 100LL * block + 10 * which;
  const double turn = noise(seed + 2);
  return {noise(seed) - turn * x[1], noise(seed + 1) + turn * x[0]};
}

/// Motions of the active blocks; where blocks are tied the mean over all copies, 0 where held.
Teuchos::RCP<TpetraVector> block_motion(const SelectedWall& w, int which) {
  auto x = Teuchos::rcp(new TpetraVector(w.space.map()));
  const auto active = w.active();
  double* value = local_view_to_write(*x);
  for (int i = 0; i < w.structure.nodes(); ++i) {
    const int k = w.space.cluster()[i];
    const int block = w.structure.block_of_node()[i];
    if (k >= w.space.owned_clusters() || !active[block]) continue;
    const auto u = motion(w.structure.nodes_of(block).id, which, w.structure.position()[i]);
    for (int c = 0; c < 2; ++c)
      if (!w.space.held()[2 * k + c]) value[2 * k + c] += u[c] / w.space.multiplicity()[k];
  }
  return x;
}

struct System {
  SystemMatrix h;
  explicit System(const SelectedWall& w) : h(w.structure, w.points, w.selected, w.space) {
    h.update(w.statuses(), w.proximal());
  }
};

/// A system with its preconditioner, nothing switched off.
struct WholeOperator {
  System system;
  Continuum continuum;
  CoarseOperator preconditioner;
  explicit WholeOperator(const SelectedWall& w)
      : system(w),
        continuum(w.structure, w.points, w.held, {}),
        preconditioner(w.structure, w.points, w.selected, w.space, continuum, {}) {
    preconditioner.update(system.h, w.statuses(), w.proximal());
  }
};

/// Who solves for block motions, of several ranks.
enum class Motions { on_first, by_all, by_levels };
SharedSystemParameters solved(Motions by) {
  SharedSystemParameters numbers;
  if (by != Motions::on_first) numbers.most_on_first = 0;
  if (by == Motions::by_all) numbers.levels.least_eigenvalue = 2;  // no cycle has it
  numbers.levels.coarsest = 12;
  numbers.levels.least_of_a_rank = 24;
  return numbers;
}

TEUCHOS_UNIT_TEST(BlockMotions, AreThreePerBlockWithASelectedPoint) {
  for (const auto selected : {Selected::some, Selected::all}) {
    const SelectedWall w(selected);
    const auto active = w.active();
    const BlockMotions motions(w.structure, w.points, w.selected, w.space, active);
    const auto mine = std::count(active.begin(), active.begin() + w.structure.owned_blocks(), 1);
    TEST_EQUALITY(motions.size(), 3 * sum_over_ranks(*w.structure.comm(), static_cast<long long>(mine)));
  }
}

TEUCHOS_UNIT_TEST(BlockMotions, SolveExactlyForMotionsOfEveryBlock) {
  for (const auto selected : {Selected::some, Selected::all})
    for (const auto by : {Motions::on_first, Motions::by_all}) {
      const SelectedWall w(selected);
      const System system(w);
      BlockMotions motions(w.structure, w.points, w.selected, w.space, w.active(), solved(by));
      // Twice: factors are made anew for statuses that change.
      motions.update(slipping(w, 1), w.proximal());
      motions.update(w.statuses(), w.proximal());
      for (int which = 0; which < 3; ++which) {
        const auto x = block_motion(w, which);
        TpetraVector r(w.space.map()), z(w.space.map());
        system.h.matrix()->apply(*x, r);
        motions.add(r, z);
        z.update(-1.0, *x, 1.0);
        // Z (Z^T H Z)^-1 Z^T H Z c = Z c. Proximal over structural stiffness makes the coarse condition number some 1e3
        // to 1e5, so that round-off leaves ten digits.
        TEST_COMPARE(z.norm2(), <=, 1e-10 * x->norm2());
      }
    }
}

// What levels leave of the energy of any motions of blocks: less than they promise.
TEUCHOS_UNIT_TEST(BlockMotions, LevelsLeaveLittleOfTheEnergyOfMotions) {
  const SelectedWall w(Selected::all);
  const System system(w);
  BlockMotions motions(w.structure, w.points, w.selected, w.space, w.active(), solved(Motions::by_levels));
  const bool alone = everyone()->getSize() == 1;
  TEST_ASSERT(motions.update(w.statuses(), w.proximal()) == (alone ? SolvedBy::factors : SolvedBy::levels));
  TEST_EQUALITY(motions.levels().empty(), alone);
  for (int which = 0; which < 3; ++which) {
    const auto x = block_motion(w, which);
    TpetraVector hx(w.space.map()), z(w.space.map());
    system.h.matrix()->apply(*x, hx);
    const double energy = x->dot(hx);
    motions.add(hx, z);
    TEST_COMPARE(z.dot(hx), <=, (1 + 1e-9) * energy);
    x->update(-1.0, z, 1.0);
    system.h.matrix()->apply(*x, hx);
    TEST_COMPARE(x->dot(hx), <=, 0.75 * 0.75 * energy);
  }
}

TEUCHOS_UNIT_TEST(BlockMotions, AddToWhatIsThere) {
  const SelectedWall w(Selected::some);
  BlockMotions motions(w.structure, w.points, w.selected, w.space, w.active());
  motions.update(w.statuses(), w.proximal());
  const auto r = noise_vector(w.space.map());
  TpetraVector once(w.space.map()), twice(w.space.map());
  motions.add(*r, once);
  motions.add(*r, twice);
  motions.add(*r, twice);
  twice.update(-2.0, once, 1.0);
  TEST_COMPARE(once.norm2(), >, 0);
  TEST_COMPARE(twice.norm2(), <=, 1e-14 * once.norm2());  // the same sums
}

const PreconditionerParameters parts[] = {{true, true, true},   {false, true, true},      {true, false, true},
                                          {true, true, false},  {false, false, true},     {true, false, false},
                                          {false, true, false}, {true, true, true, false}};

TEUCHOS_UNIT_TEST(CoarseOperator, IsSymmetricAndPositiveWhateverIsSelectedAndSwitchedOn) {
  for (const auto selected : {Selected::none, Selected::few, Selected::some, Selected::all}) {
    const SelectedWall w(selected);
    const Continuum continuum(w.structure, w.points, w.held, {});
    const System system(w);
    for (const auto& part : parts) {
      CoarseOperator m(w.structure, w.points, w.selected, w.space, continuum, part);
      m.update(system.h, w.statuses(), w.proximal());
      m.couple(system.h, Symmetry::symmetric);
      const auto a = noise_vector(w.space.map());
      TpetraVector b(w.space.map()), ma(w.space.map()), mb(w.space.map());
      for (int k = 0; k < 2 * w.space.owned_clusters(); ++k) {
        // Another noise; and residuals are 0 where the displacement is prescribed.
        local_view_to_write(b)[k] = noise(3 * w.space.map()->getGlobalElement(k) + 1);
        if (w.space.held()[k]) local_view_to_write(b)[k] = local_view_to_write(*a)[k] = 0;
      }
      m.apply(*a, ma);
      m.apply(b, mb);
      // Against the size a product of such vectors has: a.M b itself may cancel.
      const double scale = ma.norm2() * b.norm2() + mb.norm2() * a->norm2();
      TEST_COMPARE(std::abs(a->dot(mb) - b.dot(ma)), <=, 1e-10 * scale);
      // Blocks alone leave bonded blocks out, and motions alone add the identity: neither is singular on noise.
      TEST_COMPARE(a->dot(ma), >, 0);
      TEST_COMPARE(b.dot(mb), >, 0);
    }
  }
}

TEUCHOS_UNIT_TEST(CoarseOperator, InheritsTheExactnessOfBlockMotions) {
  for (const auto selected : {Selected::some, Selected::all}) {
    const SelectedWall w(selected);
    WholeOperator whole(w);
    const auto& system = whole.system;
    auto& m = whole.preconditioner;
    const auto x = block_motion(w, 0);
    TpetraVector r(w.space.map()), z(w.space.map());
    system.h.matrix()->apply(*x, r);
    m.apply(r, z);
    z.update(-1.0, *x, 1.0);
    TEST_COMPARE(z.norm2(), <=, 1e-10 * x->norm2());  // as for the motions alone
  }
}

TEUCHOS_UNIT_TEST(CoarseOperator, WithoutSymmetryLeavesNothingToBlockMotionsEither) {
  for (const auto selected : {Selected::some, Selected::all}) {
    const SelectedWall w(selected);
    WholeOperator whole(w);
    const auto& system = whole.system;
    auto& m = whole.preconditioner;
    m.couple(system.h, Symmetry::none);
    BlockMotions motions(w.structure, w.points, w.selected, w.space, w.active());
    motions.update(w.statuses(), w.proximal());
    const auto r = noise_vector(w.space.map());
    TpetraVector z(w.space.map()), left(w.space.map()), seen(w.space.map()), before(w.space.map());
    motions.add(*r, before);
    m.apply(*r, z);
    system.h.matrix()->apply(z, left);
    left.update(1.0, *r, -1.0);
    motions.add(left, seen);
    // Q (r - H M r) = 0, with round-off as above.
    TEST_COMPARE(before.norm2(), >, 0);
    TEST_COMPARE(seen.norm2(), <=, 1e-10 * before.norm2());
  }
}

TEUCHOS_UNIT_TEST(CoarseOperator, OfABondedStructureIsTheContinuum) {
  const SelectedWall w(Selected::none);
  const Continuum continuum(w.structure, w.points, w.held, {});
  const System system(w);
  CoarseOperator m(w.structure, w.points, w.selected, w.space, continuum, {});
  m.update(system.h, w.statuses(), w.proximal());
  auto r = noise_vector(w.space.map());
  for (int k = 0; k < 2 * w.space.owned_clusters(); ++k)
    if (w.space.held()[k]) local_view_to_write(*r)[k] = 0;
  TpetraVector z(w.space.map()), reference(w.space.map());
  m.apply(*r, z);
  continuum.preconditioner()->apply(*r, reference);
  z.update(-1.0, reference, 1.0);
  TEST_COMPARE(z.norm2(), <=, 1e-14 * reference.norm2());  // the same operations
}

}  // namespace

// The arch of Oppenheim under a horizontal force: first a load multiplier, then four hinges.
//
// Source    I. J. Oppenheim, The masonry arch as a four-link mechanism under base motion, Earthquake Engng Struct. Dyn.
//           21 (1992) 1005-1017: lambda = 0.37. A rigid-block linear programme gives 0.3700.
// Set-up    middle radius 10 m, thickness 1.5 m, embrace 157.5 degrees, 7 voussoirs on ground that is held, dry joints
//           (mu = 1, enough that none slides), weight, then a horizontal force lambda x weight.
// Expected  equilibrium at lambda = 0.36, collapse at 0.38.
// Came out  the critical value lies between 0.3690 and 0.3710. Stones of 4 cells along the ring have straight sides of
//           5.6 degrees: they weigh 0.2 % too little, but all alike, which cancels.
// The answer does not depend on Young's modulus: gaps are linear in the displacements and contact points lie at the
// edges, so elastic stones find a line of thrust wherever rigid ones have one.
#include <Teuchos_UnitTestHarness.hpp>

#include "abutments.hpp"
#include "mesh/generators.hpp"
#include "static_case.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

StepReport pushed(double lambda) {
  ArchParameters arch;
  arch.radius = 10;
  arch.thickness = 1.5;
  arch.embrace = 157.5;
  arch.voussoirs = 7;
  arch.cells_radial = 2;
  arch.cells_along = 4;
  auto scene = plain_scene(10e9, 2000, 1.0);
  scene.materials[0].parameters.poisson_ratio = 0.2;
  add_support(scene, "ground");
  add_acceleration(scene, "weight", 0, -9.81);
  add_acceleration(scene, "push", 9.81, 0);
  StaticCase structure(scene, on_abutments(*make_arch(arch), 0.5));
  const auto alone = structure.step({{"weight", 1.0}});
  if (alone.newton.outcome != NewtonOutcome::converged) return alone;
  return structure.step({{"weight", 1.0}, {"push", lambda}});
}

TEUCHOS_UNIT_TEST(OppenheimArch, StandsUpTo37PercentOfItsWeightSideways) {
  for (double lambda : {0.36, 0.369}) TEST_EQUALITY(in_words(pushed(lambda).newton.outcome), "equilibrium");
  for (double lambda : {0.371, 0.38}) TEST_EQUALITY(in_words(pushed(lambda).newton.outcome), "collapse");
}

}  // namespace

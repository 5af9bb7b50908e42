// A block on an incline: it slides when the slope exceeds the friction coefficient, or topples when it exceeds b / h.
//
// Source    statics. On a slope tan(a) the block pushes with W cos(a) and pulls with W sin(a): no friction holds it
//           above tan(a) = mu. Its weight passes the lower edge above tan(a) = b / h.
// Set-up    meshes/incline.geo. A wide block 1.0 x 0.5 m with mu = 0.6; a slender one 0.4 x 1.0 m with mu = 1.
// Expected  equilibrium up to the critical slope, collapse above.
// Came out  so, at 0.1 % below and 0.1 % above. Both limits are exact on any mesh: the sum of forces at the joint is,
//           and the node at the edge carries what a rigid edge does. What blurs them is the solver's tolerance, 1e-8 of
//           the largest force: a block 0.1 % above its limit is out of balance by 1e-3 of its weight.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "mesh/block_source.hpp"
#include "static_case.hpp"
#include "support/repository.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

struct Fate {
  NewtonOutcome outcome;
  Vector<2> lower, upper;  ///< motion of the lower and the upper corner of the joint, along and away from the slope
};

Fate on_slope(double slope, double width, double height, double friction) {
  auto scene = plain_scene(10e9, 2000, friction);
  scene.mesh.type = MeshType::gmsh;
  scene.mesh.gmsh.file = repository("/meshes/incline.geo");
  scene.mesh.gmsh.geometry = {{"slope", slope}, {"width", width}, {"height", height}};
  add_support(scene, "ground");
  add_acceleration(scene, "weight", 0, -9.81);
  auto source = make_block_source<2>(scene.mesh, *Tpetra::getDefaultComm());
  StaticCase structure(scene, std::move(source));
  Fate fate{structure.step({{"weight", 1.0}}).newton.outcome, {}, {}};
  const auto& motion =
      fate.outcome == NewtonOutcome::collapse ? structure.solver().mechanism() : structure.state().displacement;
  const double c = 1 / std::sqrt(1 + slope * slope), s = slope * c;
  for (int k = 0; k < structure.model().points().size(); ++k) {
    const int node = structure.model().points().at(k).main_node(Side::j);  // the bed is block 0, the block block 1
    const auto& x = structure.model().structure().position()[node];
    const Vector<2> u{motion[2 * node], motion[2 * node + 1]};
    const Vector<2> turned{u[0] * c + u[1] * s, -u[0] * s + u[1] * c};
    if (norm(x) < 1e-9) fate.lower = turned;
    if (std::abs(norm(x) - width) < 1e-9) fate.upper = turned;
  }
  return fate;
}

TEUCHOS_UNIT_TEST(Incline, AWideBlockSlidesAboveTheFrictionAngle) {
  const double mu = 0.6;
  TEST_EQUALITY(in_words(on_slope(0.999 * mu, 1.0, 0.5, mu).outcome), "equilibrium");
  const auto sliding = on_slope(1.001 * mu, 1.0, 0.5, mu);
  TEST_EQUALITY(in_words(sliding.outcome), "collapse");
  // The mechanism is scaled to its largest component: both corners move down the slope alike, without lift.
  TEST_COMPARE(sliding.lower[0], <, -0.5);
  TEST_FLOATING_EQUALITY(sliding.lower[0], sliding.upper[0], 1e-3);
  TEST_COMPARE(std::abs(sliding.lower[1]), <, 1e-3);
  TEST_COMPARE(std::abs(sliding.upper[1]), <, 1e-3);
}

TEUCHOS_UNIT_TEST(Incline, ASlenderBlockTopplesAboveItsSlenderness) {
  const double width = 0.4, height = 1.0;
  TEST_EQUALITY(in_words(on_slope(0.999 * width / height, width, height, 1.0).outcome), "equilibrium");
  const auto toppling = on_slope(1.001 * width / height, width, height, 1.0);
  TEST_EQUALITY(in_words(toppling.outcome), "collapse");
  // It turns about the lower corner: that one rests, the upper one rises by the width where the top moves by the
  // height, which is the largest component.
  TEST_COMPARE(norm(toppling.lower), <, 1e-3);
  TEST_COMPARE(toppling.upper[1], >, 0.3);
}

}  // namespace

// A plate pressed on a rigid base and pushed sideways: stick in the middle, slip towards the loaded side.
//
// Source    code_aster V6.04.128, SSNV128, "Plaque avec contact et frottement sur un plan rigide", after the GRECO
//           benchmark: u_x on the contact line, see the table below.
// Set-up    meshes/greco-plate.geo: half of a plate, 40 x 40 mm, plane strain, E = 130 GPa, nu = 0.2, u_x = 0 on
//           x = 40 mm, mu = 1, pressure 50 MPa on top and 150 MPa on the side x = 0; cells of 1.25 mm. The rigid base
//           is a block 10 000 times as stiff, held below.
// Expected  u_x = 28.6, 27.2, 22.8, 19.8, 15.0 micrometres at x = 0, 1.25, 5, 7.5, 11.25 mm, within 5 %.
// Came out  28.6, 27.2, 22.8, 19.8, 15.4 micrometres.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "mesh/block_source.hpp"
#include "static_case.hpp"
#include "support/repository.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

LoadParameters pressure(const std::string& on, double size) {
  LoadParameters load;
  load.name = on;
  auto& traction = load.kind.emplace<TractionParameters>();
  traction.on = on;
  traction.pressure = size;
  return load;
}

TEUCHOS_UNIT_TEST(GrecoPlate, SlipsAsPublished) {
  constexpr double young = 130e9;
  auto scene = plain_scene(young, 7800, 1.0);
  scene.model.plane = Plane::strain;
  scene.materials[0].parameters.poisson_ratio = 0.2;
  auto base = scene.materials[0];
  base.parameters.blocks = "base";
  base.parameters.young_modulus = 1e4 * young;
  scene.materials.push_back(base);
  scene.mesh.type = MeshType::gmsh;
  scene.mesh.gmsh.file = repository("/meshes/greco-plate.geo");
  scene.mesh.gmsh.cells = CellType::quadrilateral;
  add_support(scene, "ground");
  add_support(scene, "symmetry", "x");
  scene.loads = {pressure("top", 50e6), pressure("side", 150e6)};
  auto source = make_block_source<2>(scene.mesh, *Tpetra::getDefaultComm());
  StaticCase plate(scene, std::move(source));
  TEST_EQUALITY(in_words(plate.step({{"top", 1.0}, {"side", 1.0}}).newton.outcome), "equilibrium");

  const struct {
    double x, ux;  ///< [m]
  } published[] = {{0, 28.6e-6}, {1.25e-3, 27.2e-6}, {5e-3, 22.8e-6}, {7.5e-3, 19.8e-6}, {11.25e-3, 15.0e-6}};
  for (const auto& p : published) {
    int found = 0;
    for (int k = 0; k < plate.model().points().size(); ++k) {
      const int node = plate.model().points().at(k).main_node(Side::j);  // block 0 is the base
      const double x = plate.model().structure().position()[node][0];
      if (std::abs(x - p.x) > 1e-9) continue;
      ++found;
      const double ux = plate.state().displacement[2 * node];
      out << "x " << x << ": " << ux << ", published " << p.ux << "\n";
      TEST_FLOATING_EQUALITY(ux, p.ux, 0.05);  // the scatter of the programs in the benchmark
    }
    TEST_EQUALITY(found, 1);
  }
}

}  // namespace

// What scenes of the gallery in space cost in linear solves, from cold starts to their ends.
#include <Teuchos_UnitTestHarness.hpp>

#include "performance/counted_scenes.hpp"
#include "scene/scene_reader.hpp"
#include "support/repository.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

Scene of_gallery(const std::string& name) { return read_scene(repository("/xml/" + name + ".xml")); }

void check(const std::string& row, const Scene& scene, Teuchos::FancyOStream& out, bool& success) {
  RunSummary summary;
  TEST_ASSERT(whole_run(row, scene, out, summary));
}

TEUCHOS_UNIT_TEST(SolvesInSpace, OfAWall) { check("Wall in space", of_gallery("wall-in-space"), out, success); }

TEUCHOS_UNIT_TEST(SolvesInSpace, OfAWallWithReturns) {
  Scene scene = of_gallery("wall-with-returns");
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive}) {
    scene.selection.mode = mode;
    check(mode == SelectionMode::all ? "Wall with returns" : "Wall with returns adaptive", scene, out, success);
  }
}

TEUCHOS_UNIT_TEST(SolvesInSpace, OfADome) { check("Dome", of_gallery("dome"), out, success); }

TEUCHOS_UNIT_TEST(SolvesInSpace, OfABarrelVaultThatSpreads) {
  check("Barrel vault spreading", of_gallery("barrel-vault-spreading"), out, success);
}

// Stones that rock and slip along all three directions.
TEUCHOS_UNIT_TEST(SolvesInSpace, OfAFacadeAsItBeginsToShake) {
  Scene scene = of_gallery("facade-shaken");
  for (auto& stage : scene.stages)
    if (stage.duration > 0) stage.duration *= 0.1;
  check("Facade shaken", scene, out, success);
}

}  // namespace

// Numbers that are allowed and in another unit than meant; scenes that are sound say nothing.
#include "scene/unusual_values.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <filesystem>

#include "base/text.hpp"
#include "scene/scene_reader.hpp"
#include "support/repository.hpp"

namespace {

using namespace voussoir;

const std::string folder = repository("/xml/");

/// Keys that are warned of, and that nothing else is.
std::vector<std::string> keys(const std::string& scene, const std::vector<std::string>& settings) {
  std::vector<std::string> keys;
  for (const auto& w : unusual_values(read_scene(folder + scene, settings)))
    if (w.what == "unusual_value") keys.push_back(split(w.where, ": scene > ").back());
  return keys;
}

TEUCHOS_UNIT_TEST(UnusualValues, ScenesOfTheRepositoryHaveNone) {
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const std::string name = file.path().filename().string();
    if (file.path().extension() != ".xml" || name == "reference.xml") continue;
    out << name << "\n";
    // The base of the plate stands for rigid ground.
    TEST_EQUALITY(keys(name, {}).size(), name == "greco-plate.xml" ? 1u : 0u);
  }
}

TEUCHOS_UNIT_TEST(UnusualValues, AreToldWithTheirKeyUnitAndRange) {
  const auto warnings = unusual_values(read_scene(folder + "wall.xml", {"materials/stone/Young modulus=10"}));
  TEST_EQUALITY(warnings.size(), 1u);
  TEST_ASSERT(warnings[0].where.find("wall.xml: scene > materials > stone > Young modulus") != std::string::npos);
  for (const char* part : {"10 Pa", "1e6 to 1e12 Pa", "Sandstone"})
    TEST_ASSERT(warnings[0].text.find(part) != std::string::npos);
  TEST_EQUALITY(warnings[0].how_much, 10);
}

TEUCHOS_UNIT_TEST(UnusualValues, EveryPhysicalKeyKnowsItsUnit) {
  for (const auto& [scene, setting, key] : std::vector<std::array<std::string, 3>>{
           {"wall.xml", "joints/dry/friction coefficient=35", "joints > dry > friction coefficient"},
           {"wall.xml", "joints/dry/cohesion=0.1", "joints > dry > cohesion"},
           {"wall.xml", "joints/dry/tension strength=0.05", "joints > dry > tension strength"},
           {"wall.xml", "materials/stone/density=2", "materials > stone > density"},
           {"wall.xml", "model/thickness=200", "model > thickness"},
           {"wall.xml", "loads/weight/gravity=9810", "loads > weight > gravity"},
           {"wall-mortar.xml", "joints/mortar/normal stiffness=82", "joints > mortar > normal stiffness"},
           {"retaining-wall.xml", "loads/soil active/unit weight=18", "loads > soil active > unit weight"},
           {"arch-seasons.xml", "loads/warmth/expansion=8", "loads > warmth > expansion"},
           {"clare-college-bridge.xml", "loads/pier settles/uy=-4", "loads > pier settles > uy"},
           {"arch-train-moving.xml", "loads/cart/axle loads=10, 15", "loads > cart > axle loads"},
           {"doorway.xml", "mesh/gmsh/element size=100", "mesh > gmsh > element size"},
           {"sliding-block.xml", "steps/stages/sliding/time step=1.5", "steps > stages > sliding > time step"}}) {
    std::vector<std::string> settings{setting};
    if (scene == "sliding-block.xml") settings.push_back("steps/stages/sliding/duration=3");
    const auto found = keys(scene, settings);
    out << scene << " " << setting << "\n";
    TEST_EQUALITY(found.size(), 1u);
    if (!found.empty()) TEST_EQUALITY(found[0], key);
  }
}

TEUCHOS_UNIT_TEST(UnusualValues, NothingAndInfinityAreUsual) {
  TEST_ASSERT(keys("wall.xml", {"joints/dry/friction coefficient=inf", "joints/dry/cohesion=0"}).empty());
  TEST_ASSERT(keys("wall.xml", {"joints/dry/friction coefficient=0", "joints/dry/cohesion=inf"}).empty());
}

// Each is usual alone: 100 Pa would be much for nothing, and 200 J/m2 little for granite.
TEUCHOS_UNIT_TEST(UnusualValues, AnEnergyThatPartsAJointByMetresAsksForTheStrength) {
  const std::vector<std::string> weak{"joints/dry/tension strength=100", "joints/dry/fracture energy=200"};
  const auto found = keys("wall.xml", weak);
  TEST_EQUALITY(found.size(), 1u);
  TEST_EQUALITY(found[0], "joints > dry > fracture energy");
  TEST_ASSERT(keys("wall.xml", {"joints/dry/tension strength=5e4", "joints/dry/fracture energy=10"}).empty());
}

}  // namespace

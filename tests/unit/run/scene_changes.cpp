// What may be another when a run is gone on with, and what not: key by key, and none is forgotten.
#include "run/scene_changes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "base/error.hpp"
#include "scene/scene_reader.hpp"
#include "support/repository.hpp"

namespace {

using namespace voussoir;

const std::string folder = repository("/xml/");

SceneValues values_of(const Scene& scene) {
  return scene_values(scene, [](const std::string& file) { return file; });
}

/// What is said when a scene has been set so since: the lines of what may change, or the refusal behind "refused".
std::string said(const std::string& file, const std::vector<std::string>& settings, const Passed& passed) {
  const auto before = read_scene(folder + file), now = read_scene(folder + file, settings);
  std::string text;
  try {
    for (const auto& line : scene_changes(values_of(before), values_of(now), now, passed, "checkpoint.h5"))
      text += line + "\n";
  } catch (const InputError& error) {
    return std::string("refused ") + error.what();
  }
  return text;
}

bool refused(const std::string& said, const std::string& key) {
  return said.rfind("refused", 0) == 0 && said.find(key) != std::string::npos;
}
bool told(const std::string& said, const std::string& key) {
  return said.rfind("refused", 0) != 0 && said.find(key) != std::string::npos;
}

const Passed at_the_start{0, false, false}, in_the_first{0, true, false}, after_the_first{1, false, false};

// A key is either refused or told: one that a module adds tomorrow as well, as long as it is declared.
TEUCHOS_UNIT_TEST(SceneChanges, NoKeyIsForgotten) {
  for (const char* file : {"wall.xml", "arch-train-moving.xml", "clare-college-bridge-history.xml", "doorway.xml",
                           "eindhoven-wall.xml", "wall-shaken.xml", "reference.xml"}) {
    const auto scene =
        file == std::string("reference.xml") ? read_scene(folder + "retaining-wall.xml") : read_scene(folder + file);
    const auto before = values_of(scene);
    for (const auto& passed : {at_the_start, Passed{scene.stages.size(), false, scene.load_factor.asked()}})
      for (std::size_t k = 0; k < before.size(); ++k) {
        const bool list_of_members = before[k].first == "loads" || before[k].first == "construction" ||
                                     before[k].first == "observations" || before[k].first == "steps > stages";
        if (list_of_members) continue;  // members are told one by one
        auto now = before;
        now[k].second += " otherwise";
        std::string said;
        try {
          for (const auto& line : scene_changes(before, now, scene, passed, "checkpoint.h5")) said += line;
        } catch (const InputError& error) {
          said = error.what();
        }
        if (said.find(before[k].first) == std::string::npos) out << file << ": " << before[k].first << "\n";
        const bool of_construction = before[k].first.rfind("construction > ", 0) == 0;
        TEST_ASSERT(said.find(of_construction ? "construction" : before[k].first) != std::string::npos);
      }
  }
}

TEUCHOS_UNIT_TEST(SceneChanges, LoadsMayChangeUntilTheyAct) {
  const std::vector<std::string> gravity{"loads/weight/gravity=19.62"}, push{"loads/sideways/ax=2"};
  TEST_ASSERT(told(said("wall.xml", gravity, at_the_start), "loads > weight > gravity"));
  TEST_ASSERT(refused(said("wall.xml", gravity, in_the_first), "loads > weight > gravity = 19.62 [m/s2], was 9.81"));
  TEST_ASSERT(refused(said("wall.xml", gravity, after_the_first), "loads > weight > gravity"));
  TEST_ASSERT(told(said("wall.xml", push, after_the_first), "loads > sideways > ax"));
  TEST_ASSERT(refused(said("wall.xml", push, {1, true, false}), "loads > sideways > ax"));
}

TEUCHOS_UNIT_TEST(SceneChanges, AStageThatHasBegunKeepsItsLoadsAndTimes) {
  const std::vector<std::string> less{"steps/stages/push/loads/sideways=0.5"}, finer{"steps/stages/push/increments=9"};
  TEST_ASSERT(told(said("wall.xml", less, after_the_first), "stages > push > loads > sideways"));
  TEST_ASSERT(refused(said("wall.xml", less, {1, true, false}), "stages > push > loads > sideways"));
  TEST_ASSERT(refused(said("wall.xml", less, {2, false, false}), "stages > push > loads > sideways"));
  TEST_ASSERT(told(said("wall.xml", finer, {1, true, false}), "stages > push > increments"));
  const std::vector<std::string> longer{"steps/stages/shaking/duration=7"};
  TEST_ASSERT(said("wall-shaken.xml", longer, at_the_start).find("duration") != std::string::npos);
}

TEUCHOS_UNIT_TEST(SceneChanges, OfTimeMassAndDampingStayOnceItHasBegun) {
  const std::vector<std::string> damping{"steps/time/stiffness damping=1e-3"}, mass{"steps/time/mass=lumped"},
      tolerance{"steps/time/error tolerance=0.05"};
  const Passed all{2, false, false};
  for (const auto& setting : {damping, mass}) {
    TEST_ASSERT(told(said("arch-train-moving.xml", setting, at_the_start), "steps > time > "));
    TEST_ASSERT(refused(said("arch-train-moving.xml", setting, all), "steps > time > "));
  }
  TEST_ASSERT(told(said("arch-train-moving.xml", tolerance, all), "steps > time > error tolerance"));
}

TEUCHOS_UNIT_TEST(SceneChanges, TheStructureNeverChanges) {
  for (const auto& [setting, section] :
       std::vector<std::pair<std::string, std::string>>{{"joints/dry/tension strength=1e4", "its joints differ"},
                                                        {"joints/dry/initial gap=1e-3", "its joints differ"},
                                                        {"materials/stone/density=1900", "its materials differ"},
                                                        {"model/thickness=2", "its model differ"},
                                                        {"supports/ground/components=y", "its supports differ"}})
    TEST_ASSERT(refused(said("wall.xml", {setting}, at_the_start), section));
}

TEUCHOS_UNIT_TEST(SceneChanges, TolerancesAndOutputAreToldWithTheirValues) {
  TEST_ASSERT(
      told(said("wall.xml", {"newton/tolerance=1e-9"}, {2, false, false}), "newton > tolerance = 1e-9 [-], was 1e-8"));
  TEST_ASSERT(told(said("wall.xml", {"output/every=7"}, {2, false, false}), "output > every"));
  TEST_ASSERT(
      told(said("wall.xml", {"internals/patches/used=false"}, {2, false, false}), "internals > patches > used"));
  TEST_EQUALITY(said("wall.xml", {}, {2, false, false}), "");
}

TEUCHOS_UNIT_TEST(SceneChanges, LoadsRaisedByASearchHaveActed) {
  const std::vector<std::string> harder{"loads/sideways/ax=5"};
  TEST_ASSERT(told(said("doorway.xml", harder, {1, false, false}), "loads > sideways > ax"));
  TEST_ASSERT(refused(said("doorway.xml", harder, {1, false, true}), "loads > sideways > ax"));
}

}  // namespace

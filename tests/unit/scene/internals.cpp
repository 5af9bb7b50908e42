// How steps are solved is read like the rest of a scene, written only where it is not as usual, and refused by name.
#include "scene/internals.hpp"

#include <sstream>

#include "scene/scene_printer.hpp"
#include "unit/scene/broken.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

std::string written(const Scene& scene) {
  std::ostringstream os;
  write_scene(os, scene);
  return os.str();
}

TEUCHOS_UNIT_TEST(Internals, AreSetByTheirPathsAndComeBackFromAWrittenScene) {
  const auto scene = read_scene(path_of("wall"), {"internals/patches/used=false", "internals/active set/patience=24",
                                                  "internals/step/proximal strain=3e-4"});
  const auto back = read_scene_from_text(written(scene), path_of("wall"));
  for (const auto* s : {&scene, &back}) {
    TEST_ASSERT(!s->internals.methods.patches.used);
    TEST_EQUALITY(s->internals.methods.active_set.patience, 24);
    TEST_EQUALITY(s->internals.step.proximal_strain, 3e-4);
  }
}

TEUCHOS_UNIT_TEST(Internals, AreNoPartOfASceneThatLeavesThemAsTheyAre) {
  const auto usual = written(read_scene(path_of("wall"), {"internals/active set/patience=8"}));
  TEST_EQUALITY(usual.find("internals"), std::string::npos);
  std::ostringstream reference;
  print_reference(reference);
  TEST_EQUALITY(reference.str().find("\"internals\""), std::string::npos);
}

// Every default lies in its own range, and no two settings of a method share a name.
TEUCHOS_UNIT_TEST(Internals, TheirReferenceReadsBackAsWhatIsUsual) {
  std::ostringstream reference;
  print_internals_reference(reference);
  const auto text = reference.str();
  const auto begin = text.find("<ParameterList name=\"internals\">", text.find("<ParameterList") + 1);
  const auto section = text.substr(begin, text.rfind("</ParameterList>") - begin);
  const std::string steps = "<ParameterList name=\"steps\">";
  const auto with = changed("wall", steps, section + steps);
  TEST_EQUALITY(said(with, "wall"), "");
  TEST_EQUALITY(written(read_scene_from_text(with, path_of("wall"))), written(read_scene(path_of("wall"))));
}

TEUCHOS_UNIT_TEST(Internals, AreRefusedByNameWithTheNearestAndBeyondTheirRange) {
  const auto text = scene_text(path_of("wall"));
  const auto unknown = said(text, "wall", {"internals/interior path/to boundry=0.9"});
  TEST_INEQUALITY(unknown.find("did you mean \"internals/interior path/to boundary\""), std::string::npos);
  TEST_INEQUALITY(said(text, "wall", {"internals/interior path/to boundary=1"}).find("to boundary"), std::string::npos);
  TEST_INEQUALITY(said(text, "wall", {"internals/patches/used=perhaps"}).find("used"), std::string::npos);
}

}  // namespace

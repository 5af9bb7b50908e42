// scaling: computes families of scenes, larger and larger, and tells each load step in units of a bonded solve.
#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "base/command_line.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "drivers/study.hpp"
#include "linalg/agree.hpp"
#include "output/safe_file.hpp"
#include "scene/scene_reader.hpp"
#include "study/accuracy_study.hpp"
#include "study/motion_study.hpp"
#include "study/scaling_study.hpp"
#include "study/system_study.hpp"

namespace {

using namespace voussoir;

const char* const closing =
    R"(Leaves DIR/scaling.csv, DIR/scaling.json, DIR/scaling.png and DIR/scaling.svg.
Those of an earlier study are replaced.
Exit codes: 0 done, 2 the input is wrong, 3 no convergence, 4 a resource is missing.
)";

struct Arguments {
  std::string peers, scene;
  std::string folder = "out/scaling", draw = VOUSSOIR_SOURCE_DIR "/drivers/report/draw_scaling.py";
  std::vector<std::string> families{"walls", "openings", "storeys", "arches", "bridge"}, systems, overrides;
  std::vector<SelectionMode> modes{SelectionMode::adaptive, SelectionMode::all};
  std::vector<double> motions;
  int smallest = 1, largest = 64;
  std::string help;  ///< to print instead of computing, when it was asked for
  bool asks_for(const std::string& family) const {
    return std::find(families.begin(), families.end(), family) != families.end();
  }
};

std::vector<std::string> words_of(const CommandLine& line, const std::string& option, const std::string& text,
                                  const std::vector<std::string>& known) {
  std::vector<std::string> words;
  for (const auto& part : split(text, ",")) {
    words.push_back(trimmed(part));
    if (std::find(known.begin(), known.end(), words.back()) == known.end())
      line.refuse(option, text, "must be words between commas, of " + list_of(known) + ".");
  }
  return words;
}

std::vector<SelectionMode> modes_of(const std::vector<std::string>& words) {
  std::vector<SelectionMode> modes;
  for (const auto& word : words)
    modes.push_back(word == "bonded" ? SelectionMode::bonded
                    : word == "all"  ? SelectionMode::all
                                     : SelectionMode::adaptive);
  return modes;
}

std::vector<double> peaks_of(const CommandLine& line, const std::string& text) {
  std::vector<double> peaks;
  for (const auto& part : split(text, ",")) {
    const auto peak = number_in(trimmed(part));
    if (!peak || !(*peak > 0)) line.refuse("--motions", text, "must be numbers above 0 between commas, in m/s2.");
    peaks.push_back(*peak);
  }
  return peaks;
}

void declare(CommandLine& line, Arguments& a) {
  const auto words = [&line](const std::string& option, const std::vector<std::string>& known, auto take) {
    return [=, &line](const std::string& text) { take(words_of(line, option, text, known)); };
  };
  using Words = std::vector<std::string>;
  line.add("--families", "LIST", words("--families", a.families, [&a](const Words& given) { a.families = given; }),
           "of walls, openings, storeys, arches, bridge (default: all)");
  line.add("--largest", "N", a.largest, above(0),
           "walls of 16, 32, 64, ... up to N courses (default: 64), arches of 15, 31, 61, ... up to 2 N\n"
           "voussoirs; bridge, openings and storeys (walls 3 and 5 of Ferris and Tin-Loi: one and\n"
           "two storeys) with cells 1, 2, 4, ... times as fine up to N / 16");
  line.add("--smallest", "N", a.smallest, above(0),
           "leaves out walls of fewer courses, arches of fewer than 2 N voussoirs (default: 1)");
  line.add("--systems", "LIST",
           words("--systems", {"blocks", "space", "scene", "cells", "contrast", "open", "spread"},
                 [&a](const Words& given) { a.systems = given; }),
           "instead of load steps, single systems with every point selected, to 1e-8: Krylov iterations,\n"
           "messages and bytes, on walls with more blocks, the same in space (space), a scene as it stands\n"
           "(scene), finer cells, larger contrast of stones (contrast), more open joints (open), resistances\n"
           "further apart (spread)");
  line.add("--scene", "FILE", a.scene,
           "the scene of --systems=scene, and of the walls of --systems=blocks (default there: xml/wall.xml)");
  line.add(
      "--motions", "LIST", [&](const std::string& text) { a.motions = peaks_of(line, text); },
      "instead, time steps at these peak accelerations [m/s2] of the ground, beside bonded ones: 0.4 s of\n"
      "shaking at 2.5 Hz in steps of 5 ms, of the walls and the bridge that are asked for");
  line.add("--peers", "LIST", a.peers,
           "instead, other programs on scenes W<courses> and A<voussoirs>, in turn with this one: GetFEM and\n"
           "CalculiX where they are installed; see drivers/peers/compare.py");
  line.add("--modes", "LIST",
           words("--modes", {"bonded", "adaptive", "all"}, [&a](const Words& given) { a.modes = modes_of(given); }),
           "of bonded, adaptive, all (default: adaptive,all)");
  line.add_repeated("--set", "PATH=VALUE", a.overrides, "change one parameter of every scene; may be repeated");
  line.add("--out", "DIR", a.folder, "where results go (default: out/scaling)");
  line.add("--draw", "SCRIPT", a.draw,
           "what draws the picture (default: drivers/report/draw_scaling.py of the source), or none");
}

Arguments parse(const std::vector<std::string>& words) {
  Arguments a;
  CommandLine line("scaling", "[options], alone or under mpirun");
  declare(line, a);
  if (!line.read(words)) a.help = line.help(closing);
  return a;
}

[[noreturn]] void refuse(const std::string& option, const std::string& why) {
  throw InputError("scaling: " + option + "\n  " + why + "\n  See scaling --help.");
}

/// A scene of this repository, with changes of this study and then of the user.
Scene scene_of(const Arguments& a, const std::string& name, std::vector<std::string> changes = {}) {
  changes.insert(changes.end(), a.overrides.begin(), a.overrides.end());
  return read_scene(VOUSSOIR_SOURCE_DIR "/xml/" + name, changes);
}

/// Own weight, then the western pier down by 0.2 mm in one step: the whole movement takes many.
const std::vector<std::string> bridge_in_two_steps{
    "steps/stages/western pier settles and tilts/increments=1", "loads/pier settles/uy=-0.0002",
    "loads/pier settles/rotation=0.00004", "loads/abutment moves/ux=0", "loads/ground gives way/ux=0"};

void study(const Arguments& a, const Teuchos::RCP<const Teuchos::Comm<int>>& comm, std::ostream& say) {
  on_first_rank(*comm, [&] { std::filesystem::create_directories(a.folder); });
  ScalingStudy scaling(a.folder, comm, say);
  if (a.asks_for("walls")) {
    const auto scene = scene_of(a, "wall.xml");
    for (int n = 16; n <= a.largest; n *= 2)
      if (n >= a.smallest) scaling.add("walls", n, wall_of(scene, n), a.modes);
  }
  if (a.asks_for("arches")) {
    const auto scene = scene_of(a, "arch.xml");
    for (int n = 15; n <= 2 * a.largest; n = n == 15 ? 31 : 2 * n - 1)
      if (n >= 2 * a.smallest || a.smallest == 1) scaling.add("arches", n, arch_of(scene, n), a.modes);
  }
  const int finest = std::max(1, a.largest / 16);
  const auto push_wall = [&](const std::string& family, int number, double push) {
    for (int finer = 1; a.asks_for(family) && finer <= finest; finer *= 2) {
      auto scene = scene_of(
          a, "ferris-tin-loi-wall.xml",
          {"mesh/gmsh/geometry/wall=" + std::to_string(number), "mesh/gmsh/geometry/cells=" + std::to_string(finer)});
      StageParameters stage;
      stage.name = "push";
      stage.factors["sideways"] = push;
      scene.stages.push_back(stage);
      scaling.add(family, finer, scene, a.modes);
    }
  };
  push_wall("openings", 3, 0.2);  // it bears 0.356
  push_wall("storeys", 5, 0.1);   // it bears 0.215
  if (a.asks_for("bridge")) {
    const auto scene = scene_of(a, "clare-college-bridge.xml", bridge_in_two_steps);
    for (int finer = 1; finer <= finest; finer *= 2)
      scaling.add("bridge", finer, with_element_size(scene, 1.0 / finer), a.modes);
  }
  say << "\nResults are in " << a.folder << "/scaling.csv and scaling.json\n";
}

/// What shakes the ground along x, by the name of a load and of the stage in which it acts.
std::vector<std::string> shaken(const std::string& load, const std::string& stage, double peak) {
  const auto in = [](const std::string& where, const std::string& what) { return where + "/" + what; };
  return {in("loads/" + load, "x record="),
          in("loads/" + load, "scale=1"),
          in("loads/" + load, "ax=" + number_text(peak)),
          in("loads/" + load, "time function/type=sine"),
          in("loads/" + load, "time function/frequency=2.5"),
          in("steps/stages/" + stage, "duration=0.4"),
          in("steps/stages/" + stage, "time step=5e-3")};
}

void study_motions(const Arguments& a, const Teuchos::RCP<const Teuchos::Comm<int>>& comm, std::ostream& say) {
  if (!a.asks_for("walls") && !a.asks_for("bridge"))
    refuse("--motions", "moves walls and bridge; name one in --families.");
  on_first_rank(*comm, [&] { std::filesystem::create_directories(a.folder); });
  MotionStudy motions(a.folder, comm, say);
  for (int n = 16; a.asks_for("walls") && n <= a.largest; n *= 2) {
    if (n < a.smallest) continue;
    for (const double peak : a.motions)
      motions.add("walls", n, peak, wall_of(scene_of(a, "wall-shaken.xml", shaken("earthquake", "shaking", peak)), n));
  }
  for (const double peak : a.motions) {
    if (!a.asks_for("bridge")) continue;
    auto changes = shaken("along", "earthquake", peak);
    changes.emplace_back("loads/upwards/scale=0");
    motions.add("bridge", 1, peak, scene_of(a, "clare-college-bridge-earthquake.xml", changes));
  }
  say << "\nResults are in " << a.folder << "/motions.csv and motions.json\n";
}

/// Walls of more and more blocks.
void add_walls(const Arguments& a, const std::string& family, const Scene& scene, SystemStudy& systems) {
  for (int n = std::max(8, a.smallest); n <= a.largest; n *= 2) systems.add({family, double(n)}, wall_of(scene, n));
}

/// One property of a wall of N courses at a time.
void study_systems(const Arguments& a, const Teuchos::RCP<const Teuchos::Comm<int>>& comm, std::ostream& say) {
  const auto asked = [&a](const char* family) {
    return std::find(a.systems.begin(), a.systems.end(), family) != a.systems.end();
  };
  if (asked("scene") && a.scene.empty()) refuse("--systems=scene", "takes a scene as it stands; name it in --scene.");
  const auto named = a.scene.empty() ? scene_of(a, "wall.xml") : read_scene(a.scene, a.overrides);
  if (asked("blocks") && named.mesh.type != MeshType::wall && named.mesh.type != MeshType::wall_in_space)
    refuse("--systems=blocks", "grows walls, and the mesh of " + a.scene +
                                   " is none that a generator makes.\n  --systems=scene takes it as it stands.");
  on_first_rank(*comm, [&] { std::filesystem::create_directories(a.folder); });
  SystemStudy systems(a.folder, comm, say);
  const auto wall = wall_of(scene_of(a, "wall.xml"), a.largest);
  const double size = a.largest;
  for (const auto& family : a.systems) {
    if (family == "blocks") add_walls(a, family, named, systems);
    if (family == "space") add_walls(a, family, scene_of(a, "wall-in-space.xml"), systems);
    if (family == "scene") systems.add({family}, named);
    if (family == "cells")
      for (const int finer : {1, 2, 4, 8}) systems.add({family, double(finer)}, with_element_size(wall, 1.0 / finer));
    if (family == "contrast")
      for (const double contrast : {1.0, 1e2, 1e4, 1e6}) systems.add({family, size, contrast}, wall);
    if (family == "open")
      for (const double open : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) systems.add({family, size, 1, open}, wall);
    if (family == "spread")
      for (const double spread : {1.0, 10.0, 100.0, 1000.0}) systems.add({family, size, 1, 0, spread}, wall);
  }
  say << "\nResults are in " << a.folder << "/systems.csv and systems.json\n";
}

/// Other programs run as processes of their own, and so does this one beside them.
void compare_with_peers(const Arguments& a) {
  const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string command = std::string("/usr/bin/python3 -B " VOUSSOIR_SOURCE_DIR "/drivers/peers/compare.py ") +
                              quoted((here / "voussoir").string()) + " " + quoted(a.folder) + " " +
                              quoted("--scenes=" + a.peers);
  std::cout << std::flush;
  if (std::system(command.c_str()) != 0) throw ResourceError("scaling: the comparison failed:\n  " + command);
}

void run_program(const std::vector<std::string>& words, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                 std::ostream& say) {
  const auto a = parse(words);
  if (!a.help.empty()) {
    say << a.help;
    return;
  }
  if (!a.peers.empty()) {
    if (comm->getSize() > 1) refuse("--peers", "compares programs on one rank; run it without mpirun.");
    compare_with_peers(a);
    return;
  }
  const auto takes_a_scene = [](const std::string& family) { return family == "scene" || family == "blocks"; };
  if (!a.scene.empty() && std::none_of(a.systems.begin(), a.systems.end(), takes_a_scene))
    refuse("--scene", "is the scene of --systems=scene and --systems=blocks, and neither is asked for.");
  if (!a.systems.empty()) {
    study_systems(a, comm, say);
    return;
  }
  if (!a.motions.empty()) {
    study_motions(a, comm, say);
    return;
  }
  study(a, comm, say);
  if (comm->getRank() == 0) draw_picture(a.draw, a.folder);
}

}  // namespace

int main(int argc, char** argv) { return run_study(argc, argv, run_program); }

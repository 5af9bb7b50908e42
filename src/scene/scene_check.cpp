// What no single section of a scene can see.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "base/file_ending.hpp"
#include "base/sort_unique.hpp"
#include "base/text.hpp"
#include "scene/scene_reader.hpp"

namespace voussoir {
namespace {

namespace fs = std::filesystem;

template <class Members>
std::vector<std::string> names_of(const Members& members) {
  std::vector<std::string> names;
  for (const auto& m : members) names.push_back(m.name);
  return names;
}

void require_members(std::size_t count, const std::string& path, const std::string& what, const std::string& advice,
                     InputProblems& problems) {
  if (count == 0 && !problems.concern(path))
    problems.add(path, " has no members\n  but a scene needs at least one" + what + ".\n  " + advice);
}

/// Makes the path of a file absolute, so that a scene written elsewhere finds it again.
/// @param or_folder  a folder of files will do
void find_file(const Scene& scene, std::string& file, const std::string& path, InputProblems& problems,
               bool or_folder = false) {
  if (file.empty() || problems.concern(path)) return;
  std::error_code error;
  const fs::path folder = fs::absolute(scene.file, error).lexically_normal().parent_path();
  std::vector<fs::path> places{folder / file, folder.parent_path() / file, folder.parent_path() / "meshes" / file};
  if (fs::path(file).is_absolute()) places = {file};
  std::vector<std::string> sought;
  for (const fs::path& place : places) {
    if (fs::is_regular_file(place, error) || (or_folder && fs::is_directory(place, error))) {
      file = place.lexically_normal().string();
      return;
    }
    sought.push_back(place.lexically_normal().string());
  }
  problems.add(path, " = " + in_quotes(file) + "\n  cannot be found. Sought: " + list_of(sought) +
                         ".\n  Put the file there, or give its path.");
}

void find_files(Scene& scene, InputProblems& problems) {
  std::string& mesh = scene.mesh.gmsh.file;
  const std::string path = "scene > mesh > gmsh > file", ending = lower_ending(mesh);
  if (scene.mesh.type == MeshType::gmsh && !mesh.empty() && !problems.concern(path)) {
    if (ending != ".geo" && ending != ".msh")
      problems.add(path, " = " + in_quotes(mesh) +
                             "\n  must end in .geo (a geometry) or .msh (a mesh).\n"
                             "  Export the mesh from gmsh in the format .msh 4.1.");
    find_file(scene, mesh, path, problems);
  }
  if (scene.mesh.type == MeshType::stones)
    find_file(scene, scene.mesh.stones.file, "scene > mesh > stones > file", problems, true);
  for (LoadParameters& load : scene.loads)
    for (const auto& of_load : load.files())
      find_file(scene, *of_load.file, "scene > loads > " + load.name + " > " + of_load.key, problems);
}

/// What is legal but has no effect.
/// @param place  in the scene
void warn_of(Scene& scene, const std::string& place, const std::string& text) {
  scene.warnings.push_back({"probably_not_meant", "scene > " + place, "", 0, text});
}

/// What may be as meant: of a part of the stages some loads never act, and none may have a duration.
void remark(Scene& scene, const std::string& place, const std::string& text) {
  scene.remarks.push_back({"remark", "scene > " + place, "", 0, text});
}

void check_stages(Scene& scene, InputProblems& problems) {
  const std::vector<std::string> loads = names_of(scene.loads);
  std::set<std::string> used;
  for (const StageParameters& stage : scene.stages) {
    const bool builds = std::any_of(scene.construction.begin(), scene.construction.end(), [&](const auto& c) {
      return c.parameters.appears == stage.name || c.parameters.disappears == stage.name;
    });
    if (stage.at_once && !stage.dynamic())
      warn_of(scene, "steps > stages > " + stage.name, "has no duration, so at once has no effect in it");
    if (stage.factors.empty() && !stage.dynamic() && !builds)
      remark(scene, "steps > stages > " + stage.name, "names no load, so nothing changes in it");
    for (const auto& [load, factor] : stage.factors) {
      used.insert(load);
      if (loads.empty() || std::find(loads.begin(), loads.end(), load) != loads.end()) continue;
      problems.add("scene > steps > stages > " + stage.name + " > loads > " + load,
                   " = " + number_text(factor) + " [-]\n  names no load of this scene" + did_you_mean(load, loads) +
                       ".\n  Loads: " + list_of(loads) + ".");
    }
  }
  for (const auto& raised : scene.load_factor.pattern) used.insert(raised.first);
  for (const std::string& load : loads)
    if (!used.count(load)) remark(scene, "loads > " + load, "never acts: no stage names it");
}

/// The pattern of a load factor analysis.
void check_load_factor(Scene& scene, InputProblems& problems) {
  const auto& pattern = scene.load_factor.pattern;
  const std::vector<std::string> loads = names_of(scene.loads);
  const std::string path = "scene > load factor > pattern";
  for (const auto& [name, share] : pattern) {
    const auto named = [&name = name](const LoadParameters& l) { return l.name == name; };
    const auto load = std::find_if(scene.loads.begin(), scene.loads.end(), named);
    if (load == scene.loads.end() && !loads.empty())
      problems.add(path + " > " + name, " = " + number_text(share) + " [-]\n  names no load of this scene" +
                                            did_you_mean(name, loads) + ".\n  Loads: " + list_of(loads) + ".");
    if (load != scene.loads.end() && load_as<SettlementParameters>(*load) && scene.model.rotations == Rotations::small)
      remark(scene, "load factor > pattern > " + name,
             "moves a support; displacements are small ones, so what is sought is the movement at "
             "which the structure as drawn stands no more, not as it leans by then; give model > "
             "rotations = \"finite\" to let it lean");
  }
  if (pattern.empty()) return;
  for (const StageParameters& stage : scene.stages)
    if (stage.dynamic())
      problems.add(path, " is given\n  but stage " + in_quotes(stage.name) +
                             " has a duration (a load factor is one of statics).\n  Leave one of the two out.");
  if (scene.selection.mode == SelectionMode::bonded)
    problems.add(path,
                 " is given\n  but selection > mode = \"bonded\" (what is bonded does not collapse).\n"
                 "  Give adaptive or all.");
}

void check_velocities(Scene& scene) {
  const bool moves = std::any_of(scene.stages.begin(), scene.stages.end(), [](const auto& s) { return s.dynamic(); });
  if (!scene.velocities.empty() && !moves)
    remark(scene, "initial velocities", "have no effect: no stage has a duration");
}

void check_loads(Scene& scene, InputProblems& problems) {
  for (const LoadParameters& load : scene.loads) {
    if (load.is_zero()) remark(scene, "loads > " + load.name, "is zero");
    const auto* settlement = load_as<SettlementParameters>(load);
    if (!settlement) continue;
    for (const auto& support : scene.supports) {
      const std::string& held = support.parameters.components;
      if (support.name != settlement->support) continue;
      if (support.parameters.along_normal() && settlement->turn.rotation != 0 &&
          scene.model.rotations == Rotations::finite)
        problems.add("scene > loads > " + load.name + " > rotation",
                     " = " + number_text(settlement->turn.rotation) + " [rad]\n  turns the support " +
                         in_quotes(support.name) +
                         ", which holds along a normal. With model > rotations = \"finite\" this one would turn with "
                         "it, and normals are those of the drawing.\n  Give rotations = \"small\", a support with "
                         "components = \"all\", or a settlement without rotation.");
      if (settlement->ux != 0 && held == "y")
        warn_of(scene, "loads > " + load.name, "has an ux that its support does not hold");
      if (settlement->uy != 0 && held == "x")
        warn_of(scene, "loads > " + load.name, "has an uy that its support does not hold");
    }
  }
}

void check_supports(Scene& scene, InputProblems& problems) {
  const std::vector<std::string> supports = names_of(scene.supports);
  const auto look_up = [&](const std::string& path, const std::string& name) {
    if (name.empty() || problems.concern(path)) return;
    if (std::find(supports.begin(), supports.end(), name) != supports.end()) return;
    problems.add(path, " = " + in_quotes(name) + "\n  is no support of this scene" + did_you_mean(name, supports) +
                           ".\n  " + (supports.empty() ? "It has none." : "Supports: " + list_of(supports) + "."));
  };
  for (const LoadParameters& load : scene.loads)
    if (const auto* settlement = load_as<SettlementParameters>(load))
      look_up("scene > loads > " + load.name + " > support", settlement->support);
  for (const auto& o : scene.observations)
    look_up("scene > observations > " + o.name + " > support", o.parameters.support);
  std::set<std::pair<std::string, std::string>> held;
  for (const auto& support : scene.supports)
    if (!held.insert({support.parameters.on, support.parameters.blocks}).second)
      remark(scene, "supports > " + support.name,
             "holds " + in_quotes(support.parameters.on) + ", which another support holds already");
}

void check_construction(const Scene& scene, InputProblems& problems) {
  const std::vector<std::string> stages = names_of(scene.stages);
  const auto number = [&](const std::string& stage) { return std::find(stages.begin(), stages.end(), stage); };
  for (const auto& [name, c] : scene.construction) {
    const std::string path = "scene > construction > " + name + " > ";
    const std::string values[2] = {c.appears, c.disappears};
    const char* keys[2] = {"appears", "disappears"};
    for (int k = 0; k < 2; ++k)
      if (!values[k].empty() && number(values[k]) == stages.end() && !stages.empty())
        problems.add(path + keys[k], " = " + in_quotes(values[k]) + "\n  is no stage of this scene" +
                                         did_you_mean(values[k], stages) + ".\n  Stages: " + list_of(stages) + ".");
    if (!c.appears.empty() && !c.disappears.empty() && number(c.disappears) <= number(c.appears) &&
        number(c.appears) != stages.end())
      problems.add(path + "disappears", " = " + in_quotes(c.disappears) + "\n  must be a stage after " +
                                            in_quotes(c.appears) + ", where these blocks appear.\n  Exchange the two.");
  }
  for (const StageParameters& stage : scene.stages)
    if (!scene.construction.empty() && stage.dynamic())
      problems.add("scene > steps > stages > " + stage.name + " > duration",
                   " = " + number_text(stage.duration) +
                       " [s]\n  does not go with construction stages (time steps "
                       "do not know of blocks that are not there).\n  Build in a scene of its own.");
  if (!scene.construction.empty() && scene.selection.mode == SelectionMode::bonded)
    problems.add("scene > selection > mode",
                 " = \"bonded\"\n  does not go with construction stages (a joint that is "
                 "born later cannot be tied to where its blocks once were).\n"
                 "  Give adaptive or all.");
}

/// Stones that turn far do so in load steps alone.
void check_rotations(const Scene& scene, InputProblems& problems) {
  if (scene.model.rotations == Rotations::small) return;
  const std::string key = "scene > model > rotations", value = " = \"finite\"\n  does not go with ";
  for (const StageParameters& stage : scene.stages)
    if (stage.dynamic())
      problems.add(key, value + "stage " + in_quotes(stage.name) +
                            ", which has a duration (time steps know of small "
                            "rotations only).\n  Give \"small\", or leave the duration out.");
  if (!scene.construction.empty())
    problems.add(key, value +
                          "construction stages (stones that are not there yet cannot be followed).\n"
                          "  Give \"small\", or leave the construction out.");
  std::map<std::string, std::string> turns;  // the first load that turns each support
  for (const auto& load : scene.loads) {
    if (load_as<TemperatureParameters>(load))
      problems.add(key, value + "load " + in_quotes(load.name) +
                            " (heat presses along the axes of the drawing).\n"
                            "  Give \"small\", or leave this load out.");
    const auto* const settlement = load_as<SettlementParameters>(load);
    if (!settlement || settlement->turn.rotation == 0) continue;
    const auto [first, is_first] = turns.insert({settlement->support, load.name});
    if (!is_first)
      problems.add(key, value + "loads " + in_quotes(first->second) + " and " + in_quotes(load.name) +
                            ", which both turn support " + in_quotes(settlement->support) +
                            ": large turns do not add up.\n  Give one load that turns it, or \"small\".");
  }
}

void check_mortar(const Scene& scene, InputProblems& problems) {
  for (const auto& [name, law] : scene.joints) {
    if (!law.has_mortar()) continue;
    const bool normal = law.normal_stiffness < law.infinity;
    const std::string path = "scene > joints > " + name + " > " + (normal ? "normal" : "tangential") + " stiffness";
    const double stiffness = normal ? law.normal_stiffness : law.tangential_stiffness;
    const std::string value = " = " + number_text(stiffness) + " [Pa/m]\n";
    for (const StageParameters& stage : scene.stages)
      if (stage.dynamic())
        problems.add(path, value + "  does not go with stage " + in_quotes(stage.name) +
                               ", which has a duration (the energy book of time steps knows no springs in joints).\n"
                               "  Leave the stiffness or the duration out.");
    if (scene.selection.mode == SelectionMode::bonded)
      problems.add(path, value +
                             "  does not go with selection > mode = \"bonded\" (a bond is rigid).\n"
                             "  Give adaptive or all.");
  }
}

/// Stiffnesses are summed and squared, like forces, which are looked at where they are known (Model::loads).
void check_stiffness(const Scene& scene, InputProblems& problems) {
  constexpr double least = 1e-130, most = 1e130;  // [N/m] whose squares a computer holds, down to tolerances of solvers
  const auto holds = [](double x) { return least <= x && x <= most; };
  const double thickness = scene.model.thickness;
  const std::string why = "\n  is beyond the numbers a computer can square (" + number_text(least) + " to " +
                          number_text(most) + " can be computed).\n  ";
  if (!holds(thickness) && !problems.concern("scene > model"))
    problems.add("scene > model > thickness", " = " + number_text(thickness) + " [m]" + why + "Give it in metres.");
  for (const auto& [name, material] : scene.materials) {
    const std::string path = "scene > materials > " + name + " > Young modulus";
    const double stiffness = material.young_modulus * (material.thickness > 0 ? material.thickness : thickness);
    if (problems.concern(path) || problems.concern("scene > model > thickness")) continue;
    if (!holds(material.young_modulus) || !holds(stiffness))
      problems.add(path, " = " + number_text(material.young_modulus) + " [Pa], " + number_text(stiffness) +
                             " N/m over the thickness," + why + "Give it in Pa.");
  }
}

/// Reports a name that is no set of the mesh.
void check_set(const std::string& path, const std::string& name, const std::string& kind,
               const std::vector<std::string>& sets, InputProblems& problems) {
  if (std::find(sets.begin(), sets.end(), name) != sets.end()) return;
  problems.add(path, " = " + in_quotes(name) + "\n  is no set of " + kind + " of this mesh" + did_you_mean(name, sets) +
                         ".\n  Sets of " + kind + ": " + list_of(sets) + ".");
}

}  // namespace

void check_scene(Scene& scene, InputProblems& problems) {
  require_members(scene.materials.size(), "scene > materials", " material",
                  "Add <ParameterList name=\"stone\"> with Young modulus, Poisson ratio and density.", problems);
  require_members(scene.joints.size(), "scene > joints", " law for the joints",
                  "Add <ParameterList name=\"dry\"> with a friction coefficient.", problems);
  // What moves through time alone may fly free of supports and loads.
  const bool flies = !scene.stages.empty() && std::all_of(scene.stages.begin(), scene.stages.end(),
                                                          [](const auto& stage) { return stage.dynamic(); });
  if (!flies) {
    require_members(scene.supports.size(), "scene > supports", " support (without one the structure falls)",
                    "Add <ParameterList name=\"ground\"> with the set of facets it is \"on\".", problems);
    require_members(scene.loads.size(), "scene > loads", " load",
                    "Add <ParameterList name=\"weight\"> with type = self weight.", problems);
  }
  require_members(scene.stages.size(), "scene > steps > stages", " stage",
                  "Add <ParameterList name=\"own weight\"> with a sublist \"loads\" that gives weight the factor 1.",
                  problems);
  find_files(scene, problems);
  check_stages(scene, problems);
  check_supports(scene, problems);
  check_loads(scene, problems);
  check_load_factor(scene, problems);
  check_velocities(scene);
  check_construction(scene, problems);
  check_mortar(scene, problems);
  check_stiffness(scene, problems);
  check_rotations(scene, problems);
  check_dimension(scene, problems);
}

namespace {

/// Every set that a scene names, with its key. @param visit  (path of the key, name, of blocks or else of facets)
template <class Visit>
void for_each_set(const Scene& scene, const Visit& visit) {
  for (const auto& m : scene.materials) visit("materials > " + m.name + " > blocks", m.parameters.blocks, true);
  for (const auto& j : scene.joints) {
    visit("joints > " + j.name + " > between", j.parameters.between, true);
    visit("joints > " + j.name + " > and", j.parameters.and_, true);
  }
  for (const auto& v : scene.velocities)
    visit("initial velocities > " + v.name + " > blocks", v.parameters.blocks, true);
  for (const auto& c : scene.construction) visit("construction > " + c.name + " > blocks", c.parameters.blocks, true);
  for (const auto& o : scene.observations) visit("observations > " + o.name + " > blocks", o.parameters.blocks, true);
  for (const auto& s : scene.supports) visit("supports > " + s.name + " > on", s.parameters.on, false);
  for (const auto& s : scene.supports)
    if (!s.parameters.blocks.empty()) visit("supports > " + s.name + " > blocks", s.parameters.blocks, true);
  for (const LoadParameters& load : scene.loads)
    for (const auto& set : load.sets()) visit("loads > " + load.name + " > " + set.key, set.name, set.of_blocks);
}

}  // namespace

std::vector<std::string> files_read(const Scene& scene) {
  std::vector<std::string> files{scene.file};
  if (scene.mesh.from_file())
    files.push_back(scene.mesh.type == MeshType::stones ? scene.mesh.stones.file : scene.mesh.gmsh.file);
  auto loads = scene.loads;
  for (auto& load : loads)
    for (const auto& of_load : load.files())
      if (!of_load.file->empty()) files.push_back(*of_load.file);
  return files;
}

std::vector<std::string> block_sets_named(const Scene& scene) {
  std::vector<std::string> names;
  for_each_set(scene, [&](const std::string&, const std::string& name, bool of_blocks) {
    if (of_blocks) names.push_back(name);
  });
  sort_unique(names);
  return names;
}

void check_names(const Scene& scene, const std::vector<std::string>& block_sets,
                 const std::vector<std::string>& facet_sets) {
  InputProblems problems(scene.file);
  std::vector<std::string> blocks{"all"};
  blocks.insert(blocks.end(), block_sets.begin(), block_sets.end());
  for_each_set(scene, [&](const std::string& key, const std::string& name, bool of_blocks) {
    check_set("scene > " + key, name, of_blocks ? "blocks" : "facets", of_blocks ? blocks : facet_sets, problems);
  });
  problems.throw_if_any();
}

}  // namespace voussoir

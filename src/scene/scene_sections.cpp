#include "scene/scene_sections.hpp"

#include <algorithm>

namespace voussoir {
namespace {

/// The member of this name, appended when there is none.
template <class Member>
Member& member(std::vector<Member>& members, const std::string& name) {
  const auto found = std::find_if(members.begin(), members.end(), [&](const Member& m) { return m.name == name; });
  if (found != members.end()) return *found;
  members.emplace_back();
  members.back().name = name;
  return members.back();
}

/// A family of members with a name; `parameters` leads from a member to what it declares.
template <class Member, class Parameters>
void add_family(ParameterSection& section, const std::string& name, const std::string& text, const std::string& example,
                std::vector<Member>& members, Parameters parameters) {
  Family family{name, text, example, {}, {}};
  for (const Member& m : members) family.names.push_back(m.name);
  family.declare = [&](const std::string& of) { parameters(member(members, of)).declare(section); };
  section.add_family(family);
}

const auto itself = [](auto& member) -> auto& { return member; };
const auto its_parameters = [](auto& member) -> auto& { return member.parameters; };

/// Section "steps": bounds of the load steps, time, and the stages.
struct Steps {
  LoadStepParameters& load_steps;
  TimeParameters& time;
  std::vector<StageParameters>& stages;

  void declare(ParameterSection& section) {
    load_steps.declare(section);
    section.add_section("time", time, "how stages with a duration are stepped through");
    add_family(section, "stages", "stages of loading, one after the other as written here", "own weight", stages,
               itself);
  }
};

}  // namespace

void declare(Scene& scene, ParameterSection& section) {
  section.add("title", scene.title, "one line for the report");
  section.add_section("mesh", scene.mesh, "the blocks");
  section.add_section("model", scene.model, "what a computation assumes: in the plane, and of cells and turns");
  add_family(section, "materials", "materials of the blocks; a later one goes before an earlier one", "stone",
             scene.materials, its_parameters);
  add_family(section, "joints", "laws of the joints; a later one goes before an earlier one", "dry", scene.joints,
             its_parameters);
  add_family(section, "supports", "where the structure is held", "ground", scene.supports, its_parameters);
  add_family(section, "loads", "what acts on the structure; stages say when and how much", "weight", scene.loads,
             itself);
  add_family(section, "construction", "blocks that are not there in all stages: what is built later, and centring",
             "centring", scene.construction, its_parameters);
  add_family(section, "initial velocities", "velocities of blocks when the first stage with a duration begins",
             "falling block", scene.velocities, its_parameters);
  Steps steps{scene.load_steps, scene.time, scene.stages};
  section.add_section("steps", steps, "loading: load steps, and stages that take time");
  section.add_section("load factor", scene.load_factor,
                      "how far a pattern of loads can be raised after the last stage before the structure collapses");
  section.add_section("selection", scene.selection, "which contact points are resolved as contact");
  section.add_section("newton", scene.newton, "accuracy of the nonlinear loop");
  section.add_section("preconditioner", scene.preconditioner, "parts of the preconditioner");
  section.add_section("solver", scene.solver, "linear solver");
  add_family(section, "observations",
             "places whose motion, and supports whose force, is written to history.csv step by step", "crown",
             scene.observations, its_parameters);
  section.add_section("output", scene.output, "what a run leaves behind");
}

void declare_internals(Internals& internals, ParameterSection& section) {
  section.add_section("internals", internals, "how steps are solved, for studies");
}

}  // namespace voussoir

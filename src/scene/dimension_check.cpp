// What a scene names that the dimension of its mesh has no room for.
#include "base/text.hpp"
#include "scene/scene_reader.hpp"

namespace voussoir {
namespace {

/// Keys of space that a plane scene gives.
void check_plane(Scene& scene, InputProblems& problems) {
  const std::string why = "\n  is across the plane of this mesh, where nothing moves.\n  ";
  const auto check = [&](const std::string& section, const std::vector<KeyOfSpace>& given) {
    for (const auto& [key, value] : given)
      problems.add("scene > " + section + " > " + key, value + why + "Leave it out, or take a mesh in space.");
  };
  for (const auto& load : scene.loads) check("loads > " + load.name, load.keys_of_space());
  for (const auto& [name, velocity] : scene.velocities) check("initial velocities > " + name, velocity.keys_of_space());
  for (const auto& [name, place] : scene.observations) {
    std::vector<KeyOfSpace> keys;
    add_if_given(keys, "z", place.z, "m");
    check("observations > " + name, keys);
  }
  for (const auto& [name, support] : scene.supports)
    if (support.components.find('z') != std::string::npos)
      problems.add("scene > supports > " + name + " > components",
                   " = " + in_quotes(support.components) + why + "Give all, xy, x or y.");
  if (scene.model.hexahedra != ModelParameters{}.hexahedra)
    scene.warnings.push_back("model > hexahedra has no effect: the mesh is plane.");
}

void check_model(const ModelParameters& model, InputProblems& problems) {
  if (model.plane != Plane::stress)
    problems.add(
        "scene > model > plane",
        " = \"strain\"\n  is of plane meshes, and this one is in space.\n  Leave it out: supports say what may "
        "not widen.");
  if (model.thickness != ModelParameters{}.thickness)
    problems.add(
        "scene > model > thickness",
        " = " + number_text(model.thickness) +
            " [m]\n  is of plane meshes, and this one is in space.\n  Leave it out: the mesh has a thickness.");
  if (model.rotations == Rotations::finite)
    problems.add("scene > model > rotations",
                 " = \"finite\"\n  does not go with a mesh in space, whose stones are not followed through large turns "
                 "yet.\n  Give \"small\", or a plane scene.");
}

/// Cracks that grow may compete, and whether a structure stays in such a state is looked at in the plane alone.
void check_fracture(const Scene& scene, InputProblems& problems) {
  for (const auto& [name, law] : scene.joints)
    for (const auto& [key, energy] : {std::make_pair("fracture energy", law.fracture_energy),
                                      std::make_pair("shear fracture energy", law.shear_fracture_energy)})
      if (energy > 0)
        problems.add("scene > joints > " + name + " > " + key,
                     " = " + number_text(energy) +
                         " [J/m2]\n  does not go with a mesh in space: whether a structure stays where cracks of its "
                         "joints compete is looked at in plane scenes alone so far.\n  Leave it out, so that the "
                         "strength is lost at once, or give a plane scene.");
}

/// What a scene in space names that is of the plane alone.
void check_space(const Scene& scene, InputProblems& problems) {
  check_model(scene.model, problems);
  check_fracture(scene, problems);
}

}  // namespace

void check_dimension(Scene& scene, InputProblems& problems) {
  if (scene.mesh.dimension() == 2)
    check_plane(scene, problems);
  else
    check_space(scene, problems);
}

}  // namespace voussoir

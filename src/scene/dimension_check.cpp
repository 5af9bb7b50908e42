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
  const bool drawn = scene.mesh.type == MeshType::stones;
  if (scene.model.rotations == Rotations::finite && scene.mesh.has_quadratic_triangles())
    problems.add("scene > model > rotations",
                 std::string(" = \"finite\"\n  does not go with cells = \"quadratic triangle") + (drawn ? "s" : "") +
                     "\": how their edges bend is found once, and does not turn with a stone.\n  Give cells = " +
                     (drawn ? "\"by shape\" or \"triangles\"" : "\"quadrilateral\" or \"triangle\"") +
                     ", or small rotations.");
  if (scene.model.hexahedra != ModelParameters{}.hexahedra)
    scene.warnings.push_back(
        {"probably_not_meant", "scene > model > hexahedra", "", 0, "has no effect: the mesh is plane"});
}

/// What a scene in space names that is of the plane alone.
void check_space(const Scene& scene, InputProblems& problems) {
  const auto& model = scene.model;
  for (const auto& [name, material] : scene.materials)
    if (material.thickness > 0)
      problems.add(
          "scene > materials > " + name + " > thickness",
          " = " + number_text(material.thickness) +
              " [m]\n  is of plane meshes, and this one is in space.\n  Leave it out: the mesh has a thickness.");
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
  const auto& stones = scene.mesh.stones;
  if (model.rotations == Rotations::finite && scene.mesh.type == MeshType::stones &&
      stones.element == StoneElement::quadratic)
    problems.add(
        "scene > model > rotations",
        " = \"finite\"\n  does not go with element = \"quadratic\": how edges of tetrahedra bend is found once, "
        "and does not turn with a stone.\n  Give mesh > stones > element = \"linear\" (with smaller cells: see "
        "src/stones/README.md), or small rotations. Stones of hexahedra are the same either way.");
}

}  // namespace

void check_dimension(Scene& scene, InputProblems& problems) {
  if (scene.mesh.dimension() == 2)
    check_plane(scene, problems);
  else
    check_space(scene, problems);
}

}  // namespace voussoir

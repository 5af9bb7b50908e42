#include "gmsh/gmsh_file.hpp"

#include <gmsh.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "base/words.hpp"
#include "mesh/gmsh_failures.hpp"
#include "mesh/gmsh_numbers.hpp"
#include "mesh/lattice.hpp"
#include "mesh/msh_format.hpp"
#include "mesh/temporary_file.hpp"

namespace voussoir {
namespace {

/// gmsh heeds it when it saves a mesh, and a mesh is not saved here.
void refuse_scaling(const std::string& file) {
  double scaling = 1;
  gmsh::option::getNumber("Mesh.ScalingFactor", scaling);
  if (scaling != 1)
    refuse_file(file, "sets Mesh.ScalingFactor = " + in_words(scaling) + ", which scales only what gmsh saves.",
                "Take it out, and say the unit of the file by mesh > gmsh > unit.");
}

std::string name_of_entity(int dimension, int tag) {
  return (dimension == 3 ? "volume " : dimension == 2 ? "surface " : "curve ") + std::to_string(tag);
}

/// Nodes of an element by its type in the MSH format; 0 for those that are not known here.
int nodes_of_type(int type, int dimension) {
  constexpr std::pair<int, int> line{1, 2}, triangle{2, 3}, quadrilateral{3, 4}, tetrahedron{4, 4}, hexahedron{5, 8};
  if (dimension == 3)
    return type == tetrahedron.first ? tetrahedron.second : type == hexahedron.first ? hexahedron.second : 0;
  for (const auto& [known, nodes] : {line, triangle, quadrilateral})
    if (type == known) return nodes;
  return 0;
}

}  // namespace

void run_on_file(Gmsh& gmsh_itself, const std::string& file, const std::string& what,
                 const std::function<void()>& commands) {
  std::string said;
  for (const auto& error : gmsh_itself.run(commands)) said += "    " + error + "\n";
  if (!said.empty())
    throw InputError("mesh > gmsh > file = " + file + "\n  gmsh could not " + what + ":\n" + said +
                     "  Open the file in gmsh itself to look for the place.");
}

void open_mesh(Gmsh& gmsh_itself, const GmshParameters& p) {
  if (p.element_size > 0 || !p.geometry.empty())
    refuse_file(p.file, "is a finished mesh: \"element size\" and \"geometry\" cannot change it.",
                "Remove these keys or give the .geo file.");
  run_on_file(gmsh_itself, p.file, "read the file", [&] { gmsh::open(std::filesystem::absolute(p.file).string()); });
}

void open_geo(Gmsh& gmsh_itself, const GmshParameters& p, const std::map<std::string, double>& numbers) {
  // Exit in a file of the user ends this process at once: then only what is static takes its leave.
  static std::optional<TemporaryFile> with_numbers;
  with_numbers.emplace(geo_with_numbers(numbers, std::filesystem::absolute(p.file).string()), ".geo");
  run_on_file(gmsh_itself, p.file, "read the file", [&] { gmsh::open(with_numbers->path()); });
  with_numbers.reset();
  refuse_scaling(p.file);
}

void set_mesh_size(double size) {
  gmsh::option::setNumber("Mesh.MeshSizeMin", size);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  gmsh::option::setNumber("Mesh.MeshSizeFactor", 1);
}

Groups read_groups(const std::string& file, int dimension) {
  Groups groups;
  gmsh::vectorpair tags;
  gmsh::model::getPhysicalGroups(tags, dimension);
  std::sort(tags.begin(), tags.end());
  for (const auto& [dim, tag] : tags) {
    std::string name;
    gmsh::model::getPhysicalName(dim, tag, name);
    if (name.empty()) name = "group " + std::to_string(tag);
    if (name == "all")
      refuse_file(file, "has a physical group named \"all\", which always means every block or the whole border.",
                  "Choose another name.");
    const auto known = std::find(groups.names.begin(), groups.names.end(), name);
    const int set = static_cast<int>(known - groups.names.begin());
    if (known == groups.names.end()) groups.names.push_back(name);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dim, tag, entities);
    for (const int entity : entities) {
      groups.of_entity[std::abs(entity)].push_back(set);
      groups.named[std::abs(entity)].push_back(name);
    }
  }
  for (auto& [entity, sets] : groups.of_entity) {
    sort_unique(sets);
  }
  return groups;
}

std::vector<std::vector<std::size_t>> read_elements(const std::string& file, int dimension, int entity,
                                                    Groups& groups) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes, elements;
  gmsh::model::mesh::getElements(types, tags, nodes, dimension, entity);
  for (std::size_t t = 0; t < types.size(); ++t) {
    const int count = nodes_of_type(types[t], dimension);
    if (count == 0 && !tags[t].empty())
      refuse_file(file,
                  "has on " + name_of_entity(dimension, entity) + " cells with " +
                      counted(nodes[t].size() / tags[t].size(), "node") + "; only " +
                      (dimension == 3 ? "tetrahedra with 4 and hexahedra with 8"
                                      : "triangles with 3, quadrilaterals with 4 and edges with 2") +
                      " nodes are known.",
                  "Set Mesh.ElementOrder = 1 and mesh again.");
    for (auto node = nodes[t].begin(); count > 0 && node != nodes[t].end(); node += count)
      elements.emplace_back(node, node + count);
  }
  if (!is_mesh(file) || lists_surfaces(file)) return elements;
  const auto keep = one_of_each_group(file, name_of_entity(dimension, entity), groups.named[entity], elements);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < elements.size(); ++k)
    if (keep[k]) elements[kept++] = elements[k];
  elements.resize(kept);
  return elements;
}

}  // namespace voussoir

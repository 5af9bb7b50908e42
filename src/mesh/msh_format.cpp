#include "mesh/msh_format.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "base/file_ending.hpp"
#include "base/text.hpp"
#include "mesh/lattice.hpp"

namespace voussoir {
namespace {

bool starts_with(const std::string& line, const char* word) { return line.rfind(word, 0) == 0; }

}  // namespace

bool is_mesh(const std::string& file) { return lower_ending(file) == ".msh"; }

bool lists_surfaces(const std::string& file) {
  std::ifstream text(file, std::ios::binary);
  std::string line;
  double version = 1;  // the first format does not name itself
  while (std::getline(text, line)) {
    if (starts_with(line, "$MeshFormat") && std::getline(text, line)) version = std::strtod(line.c_str(), nullptr);
    if (starts_with(line, "$Entities") && version >= 4) return true;
    if (starts_with(line, "$Nodes") || starts_with(line, "$NOD") || starts_with(line, "$Elements")) return false;
  }
  return false;
}

std::vector<char> one_of_each_group(const std::string& file, const std::string& what,
                                    const std::vector<std::string>& groups,
                                    const std::vector<std::vector<std::size_t>>& nodes) {
  std::vector<char> keep(nodes.size(), 1);
  if (groups.size() < 2) return keep;
  std::map<std::vector<std::size_t>, std::size_t> times;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    auto cell = nodes[k];
    std::sort(cell.begin(), cell.end());
    keep[k] = times[cell]++ == 0;
  }
  for (const auto& [cell, count] : times) {
    if (count == groups.size()) continue;
    refuse_mesh(
        "gmsh > file", file,
        "gives " + what + " to the physical groups " + list_of(groups) +
            ", and not each of its cells to all of them, so that several parts carry the number of one (they "
            "would be one block, or one set of edges, joined by nothing but that number).",
        "Give every stone and every named line an elementary number of its own, the second tag of its cells; or "
        "save the mesh from its geometry in gmsh, in format 4.1.");
  }
  return keep;
}

Warnings warnings_of_format(const std::string& file, const SurfaceMesh& mesh) {
  const auto in_a_group = [](const SurfaceMesh::Surface& surface) { return !surface.sets.empty(); };
  // A surface in no group shows that all were saved.
  if (lists_surfaces(file) || mesh.surfaces.empty() ||
      !std::all_of(mesh.surfaces.begin(), mesh.surfaces.end(), in_a_group))
    return {};
  const std::string count = std::to_string(mesh.surfaces.size());
  return {{"surfaces_not_listed", "scene > mesh > gmsh > file", "", static_cast<double>(mesh.surfaces.size()),
           std::filesystem::path(file).filename().string() +
               " is in a format that lists no surfaces, and each of its " + count +
               " is in a physical group: one in no group is not saved beside such, and nobody can miss it here; count "
               "the blocks, or save the mesh in format 4.1, where a surface that is missing is refused"}};
}

}  // namespace voussoir

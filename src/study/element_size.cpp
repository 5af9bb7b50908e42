// The length of the cells, wherever the mesh comes from.
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "study/accuracy_study.hpp"

namespace voussoir {
namespace {

int scaled(int cells, double factor) { return std::max(1, static_cast<int>(std::lround(cells / factor))); }

[[noreturn]] void refuse_unknown_size(const Scene& scene, const std::string& type) {
  throw InputError(scene.file + ": scene > mesh > " + type +
                   " > element size = 0 [m]\n"
                   "  leaves the size to the file, so that it cannot be multiplied.\n"
                   "  Give the size in the scene or with --set, or leave this sweep out: --sizes=none.");
}

}  // namespace

Scene with_element_size(Scene scene, double factor) {
  auto& mesh = scene.mesh;
  if (mesh.type == MeshType::wall) {
    // Half blocks have half the cells of a full one.
    mesh.wall.cells_along = 2 * scaled(mesh.wall.cells_along, 2 * factor);
    mesh.wall.cells_up = scaled(mesh.wall.cells_up, factor);
  }
  if (mesh.type == MeshType::arch) {
    mesh.arch.cells_radial = scaled(mesh.arch.cells_radial, factor);
    mesh.arch.cells_along = scaled(mesh.arch.cells_along, factor);
  }
  if (auto* masonry = mesh.masonry()) masonry->coarsen(factor);
  if (mesh.type == MeshType::stones && factor != 1) {
    if (mesh.stones.element_size == 0) refuse_unknown_size(scene, "stones");
    mesh.stones.element_size *= factor;
  }
  if (mesh.type != MeshType::gmsh || factor == 1) return scene;
  const std::string& file = mesh.gmsh.file;
  if (file.size() > 4 && file.compare(file.size() - 4, 4, ".msh") == 0)
    throw InputError(scene.file + ": scene > mesh > gmsh > file = " + in_quotes(file) +
                     "\n  is a finished mesh, whose element size cannot be changed.\n"
                     "  Give the geometry (.geo) it was made from, or leave this sweep out: --sizes=none.");
  if (mesh.gmsh.element_size == 0) refuse_unknown_size(scene, "gmsh");
  mesh.gmsh.element_size *= factor;
  return scene;
}

double element_size(const Scene& scene) {
  const MeshType type = scene.mesh.type;
  const auto& wall = scene.mesh.wall;
  const auto& arch = scene.mesh.arch;
  if (const auto* masonry = scene.mesh.masonry()) return masonry->longest_edge();
  if (type == MeshType::wall) return std::max(wall.block_length / wall.cells_along, wall.block_height / wall.cells_up);
  const double asked = type == MeshType::gmsh ? scene.mesh.gmsh.element_size : scene.mesh.stones.element_size;
  if (scene.mesh.from_file()) return asked > 0 ? asked : AccuracyRow::unknown;
  constexpr double radian_per_degree = 3.14159265358979323846 / 180;
  const double outer = (arch.radius + arch.thickness / 2) * arch.embrace * radian_per_degree;
  return std::max(arch.thickness / arch.cells_radial, outer / arch.voussoirs / arch.cells_along);
}

}  // namespace voussoir

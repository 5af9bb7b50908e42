// The length of the cells, wherever the mesh comes from.
#include "base/error.hpp"
#include "base/file_ending.hpp"
#include "base/text.hpp"
#include "study/accuracy_study.hpp"

namespace voussoir {
namespace {

[[noreturn]] void refuse_unknown_size(const Scene& scene, const std::string& type) {
  throw InputError(scene.file + ": scene > mesh > " + type +
                   " > element size = 0 [m]\n"
                   "  leaves the size to the file, so that it cannot be multiplied.\n"
                   "  Give the size in the scene or with --set, or leave this sweep out: --sizes=none.");
}

}  // namespace

Scene with_element_size(Scene scene, double factor) {
  auto& mesh = scene.mesh;
  if (auto* masonry = mesh.masonry()) masonry->coarsen(factor);
  if (mesh.type == MeshType::stones && factor != 1) {
    if (mesh.stones.element_size == 0) refuse_unknown_size(scene, "stones");
    mesh.stones.element_size *= factor;
  }
  if (mesh.type != MeshType::gmsh || factor == 1) return scene;
  const std::string& file = mesh.gmsh.file;
  if (lower_ending(file) == ".msh")
    throw InputError(scene.file + ": scene > mesh > gmsh > file = " + in_quotes(file) +
                     "\n  is a finished mesh, whose element size cannot be changed.\n"
                     "  Give the geometry (.geo) it was made from, or leave this sweep out: --sizes=none.");
  if (mesh.gmsh.element_size == 0) refuse_unknown_size(scene, "gmsh");
  mesh.gmsh.element_size *= factor;
  return scene;
}

double element_size(const Scene& scene) {
  const auto& mesh = scene.mesh;
  if (const auto* masonry = mesh.masonry()) return masonry->longest_edge();
  const double asked = mesh.type == MeshType::gmsh ? mesh.gmsh.element_size : mesh.stones.element_size;
  return asked > 0 ? asked : AccuracyRow::unknown;
}

}  // namespace voussoir

#include "stones/gmsh_volumes.hpp"

#include <utility>

#include "base/error.hpp"
#include "base/file_ending.hpp"
#include "mesh/gmsh_failures.hpp"
#include "mesh/gmsh_program.hpp"
#include "mesh/gmsh_request.hpp"

namespace voussoir {
namespace {

GmshParameters parameters_of(const StonesParameters& p) {
  GmshParameters g;
  g.file = p.file;
  g.unit = p.unit;
  g.element_size = p.element_size;
  g.geometry = p.geometry;
  return g;
}

/// What is said of keys of plane files of gmsh holds for those of stones.
std::string of_stones(std::string text) {
  const std::string plane = "mesh > gmsh", stones = "mesh > stones";
  for (auto at = text.find(plane); at != std::string::npos; at = text.find(plane, at + stones.size()))
    text.replace(at, plane.size(), stones);
  return text;
}

}  // namespace

bool is_of_gmsh(const std::string& file) {
  const std::string ending = lower_ending(file);
  return ending == ".geo" || ending == ".msh";
}

VolumeMesh read_volumes(const StonesParameters& p, VolumesAs wanted, Trust trust) {
  try {
    require_file(p.file);
    if (trust == Trust::no) refuse_commands(p.file, p.file);
    const auto died = [&](const ChildEnd& end) { refuse_end(p.file, end); };
    const auto work = wanted == VolumesAs::meshed ? gmsh_work::mesh_volumes : gmsh_work::outline_volumes;
    return volume_mesh_of(ask_gmsh(work, bytes_of(parameters_of(p)), died));
  } catch (const InputError& error) {
    throw InputError(of_stones(error.what()));
  } catch (const ResourceError& error) {
    throw ResourceError(of_stones(error.what()));
  }
}

}  // namespace voussoir

// What is asked of voussoir-gmsh, the program that knows gmsh (src/gmsh): gmsh may crash there, and nobody loads it who
// has no drawing.
#pragma once

#include <functional>
#include <string>

#include "base/child_process.hpp"

namespace voussoir {

/// Its pieces of work, by their names.
namespace gmsh_work {
/// Of GmshParameters (gmsh_request.hpp): refuses a drawing that asks for too many cells. The answer may explain why
/// gmsh fails. A drawing whose scene asks for no size is looked at before it is meshed: its curves are meshed for it,
/// and what is meshed depends on what was meshed before, so that this is another process.
constexpr const char* look_at_drawing = "look at a drawing";
/// Of GmshParameters; the answer is a SurfaceMesh. Where the scene asks for a size, it refuses too many cells itself.
constexpr const char* mesh_drawing = "mesh a drawing";
/// Of GmshParameters; the answer is a VolumeMesh, of cells or of borders.
constexpr const char *mesh_volumes = "mesh volumes", *outline_volumes = "outline volumes";
/// Of the name of a file; the answer is StepSolids: triangles, as few as faces have corners.
constexpr const char* triangulate_step = "triangulate STEP";
/// Of FlatDomains, of ClosedMeshes: triangles in plane polygons, tetrahedra in closed surfaces.
constexpr const char *mesh_polygons = "mesh polygons", *fill_surfaces = "fill surfaces";
}  // namespace gmsh_work

/// The answer to a request, by a process of its own (base/child_process.hpp).
/// @param died  throws what is to be said of one that gave no answer
std::string ask_gmsh(const char* work, const std::string& request, const std::function<void(const ChildEnd&)>& died);

}  // namespace voussoir

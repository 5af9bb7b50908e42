// What the format of a finished mesh tells of its surfaces, and what it does not.
//
// Format 4 lists surfaces and curves with their physical groups. Formats 1 and 2 have cells only, each with the number
// of one physical group and of one surface ("elementary entity"): gmsh writes a cell once for every group of its
// surface, and leaves out what is in no group while anything is in one. Converters often give all cells the same
// surface.
#pragma once

#include <string>
#include <vector>

#include "base/warning.hpp"
#include "mesh/surface_mesh.hpp"

namespace voussoir {

/// A finished mesh, not a geometry to be meshed; by its ending.
bool is_mesh(const std::string& file);

/// Whether a .msh lists the surfaces it is a mesh of.
bool lists_surfaces(const std::string& file);

/// Cells (or edges) of one entity, in a format that lists no entities, in the groups it says it is in: every cell must
/// be there once for each group; then it is kept once. Throws InputError where cells of different groups carry the
/// number of one entity, since they would be one block, or one set of edges.
/// @param what    "surface 7"
/// @param groups  names of its groups
/// @param nodes   of each cell
/// @return which cells to keep
std::vector<char> one_of_each_group(const std::string& file, const std::string& what,
                                    const std::vector<std::string>& groups,
                                    const std::vector<std::vector<std::size_t>>& nodes);

/// What cannot be seen in a mesh that lists no surfaces: one that was not saved.
Warnings warnings_of_format(const std::string& file, const SurfaceMesh&);

}  // namespace voussoir
